//! From the words of a section to circles, from the inside out, and what cannot lie so.

use std::f64::consts::TAU;

use super::element::Element;
use super::layout::{Helix, Layout, Middle, SheathTube, Shell};
use super::misfit::{Misfit, at_least, at_most, degrees, mm};
use super::model::{Armour, Layer, Section, Sheath, UnitLayer};
use super::packing::{Ring, most, ring, smallest_radius, touching_phase};
use super::units::{known_units, unit_named};

/// Armour layers a section may have: as many as the program of Lin et al. 2016 (section 2.1) takes.
pub const MOST_ARMOUR: usize = 4;

/// Units a layer may have; a wire layer has its own, wider limit.
pub const MOST_UNITS: usize = 60;

/// Lay angles for which a unit is a helix that carries tension \[deg\].
pub const LAY_ANGLES: (f64, f64) = (0.5, 60.0);

/// A layer covered less than this, with room for one more, is called sparse \[-\].
const SPARSE: f64 = 0.9;

/// Sizes that differ by less than this count as equal \[m\].
const TOUCH: f64 = 1e-9;

/// Lays a section out.
///
/// # Errors
///
/// Everything that cannot lie as the section says, each with its key, the reason and a remedy.
pub fn lay_out(section: &Section) -> Result<Layout, Vec<Misfit>> {
    let mut wrong = known_units(section);
    wrong.extend(names(section));
    wrong.extend(armour_layers(section));
    wrong.extend(lay_angles(section));
    if section.centre.is_none() && section.layers.is_empty() {
        let remedy = "add [centre], or a [[layer]] of units";
        wrong.push(Misfit::new(&["section"], "holds nothing", remedy));
    }
    if !wrong.is_empty() {
        return Err(wrong);
    }
    let mut builder = Builder::default();
    builder.centre(section);
    for (layer, name) in section.layers.iter().zip(layer_keys(section)) {
        builder.layer(section, layer, &name);
        if !builder.wrong.is_empty() {
            // Where the next layers would lie is not known.
            break;
        }
    }
    if builder.wrong.is_empty() {
        Ok(builder.layout())
    } else {
        Err(builder.wrong)
    }
}

/// The names by which layers go in key paths: a name taken by an earlier layer gives way to the
/// number.
fn layer_keys(section: &Section) -> Vec<String> {
    let mut keys: Vec<String> = Vec::new();
    for (index, layer) in section.layers.iter().enumerate() {
        let taken = keys.iter().any(|key| key == layer.name());
        keys.push(if taken {
            (index + 1).to_string()
        } else {
            layer.name().to_owned()
        });
    }
    keys
}

fn names(section: &Section) -> Vec<Misfit> {
    let twice = layer_keys(section)
        .into_iter()
        .zip(&section.layers)
        .filter(|(key, layer)| key != layer.name());
    twice
        .map(|(key, layer)| {
            let problem = format!("the name \"{}\" is used twice", layer.name());
            let remedy = "give every layer a name of its own";
            Misfit::new(&["layer", &key, "name"], problem, remedy)
        })
        .collect()
}

fn armour_layers(section: &Section) -> Option<Misfit> {
    let armour = |(layer, _): &(&Layer, String)| matches!(layer, Layer::Armour(_));
    let layers = section.layers.iter().zip(layer_keys(section));
    let (_, key) = layers.filter(armour).nth(MOST_ARMOUR)?;
    Some(Misfit::new(
        &["layer", &key, "kind"],
        format!("is one armour layer too many: a section has at most {MOST_ARMOUR}"),
        "leave it out, or take thicker wires in fewer layers",
    ))
}

/// Lay angles that make no helix that carries tension.
fn lay_angles(section: &Section) -> Vec<Misfit> {
    let (least, greatest) = LAY_ANGLES;
    let mut wrong = Vec::new();
    for (layer, key) in section.layers.iter().zip(layer_keys(section)) {
        let given = match layer {
            Layer::Units(layer) => layer.lay_angle_deg,
            Layer::Armour(layer) => layer.lay_angle_deg,
            Layer::Sheath(_) => continue,
        };
        if (least..=greatest).contains(&given) {
            continue;
        }
        let (problem, last) = if given < least {
            (
                "is no helix: units that run straight cannot bend without being stretched",
                "; a straight unit belongs in the middle, as [centre]",
            )
        } else {
            (
                "is a hoop: it carries no tension, and the theory of laid armour does not hold for it",
                "",
            )
        };
        wrong.push(Misfit::new(
            &["layer", &key, "lay_angle_deg"],
            format!("{given} deg {problem}"),
            format!("give {least} to {greatest} deg, usually 5 to 30{last}"),
        ));
    }
    wrong
}

#[derive(Default)]
struct Builder {
    centre: Option<Middle>,
    shells: Vec<Shell>,
    /// Radius over all that is laid so far \[m\].
    reach: f64,
    warnings: Vec<Misfit>,
    wrong: Vec<Misfit>,
}

impl Builder {
    fn layout(self) -> Layout {
        Layout {
            centre: self.centre,
            outer_radius: self.reach,
            shells: self.shells,
            warnings: self.warnings,
        }
    }

    fn centre(&mut self, section: &Section) {
        let Some(words) = &section.centre else {
            return;
        };
        let Some(unit) = unit_named(section, &words.unit) else {
            return;
        };
        let element = Element::of_unit(&words.unit, unit);
        let radius = words.jacket_diameter_m.map_or(element.radius, |d| 0.5 * d);
        if radius < element.radius - TOUCH {
            let problem = format!(
                "the jacket's {} is thinner than the unit inside it, {}",
                mm(2.0 * radius),
                mm(2.0 * element.radius)
            );
            let remedy = format!(
                "give {} or more, or leave it out",
                at_least(2.0 * element.radius)
            );
            self.wrong.push(Misfit::new(
                &["centre", "jacket_diameter_m"],
                problem,
                remedy,
            ));
        }
        self.reach = radius.max(element.radius);
        self.centre = Some(Middle {
            element,
            radius: self.reach,
            words: words.clone(),
        });
    }

    fn layer(&mut self, section: &Section, layer: &Layer, key: &str) {
        match layer {
            Layer::Units(words) => self.units(section, words, key),
            Layer::Armour(words) => self.armour(words, key),
            Layer::Sheath(words) => self.sheath(words, key),
        }
    }

    fn sheath(&mut self, words: &Sheath, key: &str) {
        if self.reach <= 0.0 {
            let remedy = "put the centre or a layer of units before it";
            self.wrong.push(Misfit::new(
                &["layer", key],
                "is a sheath around nothing",
                remedy,
            ));
        }
        let inner_radius = self.reach;
        self.reach += words.thickness_m;
        self.shells.push(Shell::Tube(SheathTube {
            words: words.clone(),
            inner_radius,
            outer_radius: self.reach,
        }));
    }

    fn units(&mut self, section: &Section, words: &UnitLayer, key: &str) {
        let named = words.units.iter().filter_map(|name| {
            let unit = unit_named(section, name)?;
            Some(Element::of_unit(name, unit))
        });
        let elements: Vec<Element> = named.collect();
        if elements.len() > MOST_UNITS {
            let problem = format!("holds {} units, more than {MOST_UNITS}", elements.len());
            let remedy =
                "spread them over several layers; wires belong in a layer of kind \"armour\"";
            self.wrong
                .push(Misfit::new(&["layer", key, "units"], problem, remedy));
            return;
        }
        let angle = words.lay_angle_deg.to_radians();
        let radii: Vec<f64> = elements.iter().map(|unit| unit.radius).collect();
        let thickest = radii.iter().copied().fold(0.0, f64::max);
        let smallest = smallest_radius(&radii, angle);
        let least = smallest.max(self.reach + thickest);
        // A hair more keeps a radius that was computed from being refused by its rounding.
        let radius = words.pitch_radius_m.unwrap_or(least * (1.0 + 1e-9));
        let set = ring(&radii, radius, angle).filter(|set| set.taken <= TAU * (1.0 + 1e-9));
        let Some(set) = set else {
            self.too_small(radius, smallest, words, elements.len(), angle, key);
            return;
        };
        if radius - thickest < self.reach - TOUCH {
            self.too_far_in(radius, thickest, key);
            return;
        }
        self.floating(radius - thickest, thickest, key);
        let helix = Helix {
            name: words.name.clone(),
            armour: false,
            elements,
            places: set.places.clone(),
            angle: angle * words.sense.sign(),
            pitch_radius: radius,
            smallest_radius: smallest,
            inner_radius: self.reach,
            outer_radius: radius + thickest,
            coverage: set.taken / TAU,
            filler: (words.filler_fraction, words.filler_density_kg_per_m3),
        };
        self.sparse(&helix, &set, key);
        self.add(helix);
    }

    fn armour(&mut self, words: &Armour, key: &str) {
        let angle = words.lay_angle_deg.to_radians();
        let wire = 0.5 * words.wire_diameter_m;
        let around_nothing = self.reach <= 0.0;
        let smallest = |count: usize| smallest_radius(&vec![wire; count], angle);
        let (count, radius) = match (words.count, around_nothing) {
            (None, true) => {
                let problem = "has nothing inside that would tell how many wires fit";
                let remedy = "give `count`, or put the centre or a layer before it";
                self.wrong
                    .push(Misfit::new(&["layer", key], problem, remedy));
                return;
            }
            (Some(count), true) => (count, smallest(count).max(wire) * (1.0 + 1e-9)),
            (count, false) => {
                let radius = self.reach + wire;
                (count.unwrap_or_else(|| most(wire, radius, angle)), radius)
            }
        };
        let held = most(wire, radius, angle);
        if count > held {
            self.too_many(count, held, smallest(count), words, key);
            return;
        }
        let radii = vec![wire; count];
        let Some(set) = wires(&radii, radius, angle) else {
            return;
        };
        let helix = Helix {
            name: words.name.clone(),
            armour: true,
            elements: vec![Element::of_armour(words); count],
            places: set.places.clone(),
            angle: angle * words.sense.sign(),
            pitch_radius: radius,
            smallest_radius: smallest(count),
            inner_radius: self.reach,
            outer_radius: radius + wire,
            coverage: set.taken / TAU,
            filler: (0.0, 0.0),
        };
        self.sparse(&helix, &set, key);
        self.add(helix);
    }

    fn add(&mut self, helix: Helix) {
        self.reach = helix.outer_radius;
        self.shells.push(Shell::Helix(helix));
    }

    fn too_small(
        &mut self,
        radius: f64,
        smallest: f64,
        words: &UnitLayer,
        count: usize,
        angle: f64,
        key: &str,
    ) {
        let problem = format!(
            "the units overlap: {count} of them at {} need a pitch radius of {} or more, and it is {}",
            degrees(angle),
            mm(smallest),
            mm(radius)
        );
        let last = if words.pitch_radius_m.is_some() {
            "pitch_radius_m"
        } else {
            "units"
        };
        let remedy = format!(
            "give pitch_radius_m = {} or leave it out, or take fewer or thinner units",
            at_least(smallest)
        );
        self.wrong
            .push(Misfit::new(&["layer", key, last], problem, remedy));
    }

    fn too_far_in(&mut self, radius: f64, thickest: f64, key: &str) {
        let problem = format!(
            "the layer lies inside another: it reaches in to a radius of {}, and what lies inside reaches out to {}",
            mm(radius - thickest),
            mm(self.reach)
        );
        let remedy = format!(
            "give pitch_radius_m = {} or more or leave it out, or make what lies inside thinner",
            at_least(self.reach + thickest)
        );
        let path = ["layer", key, "pitch_radius_m"];
        self.wrong.push(Misfit::new(&path, problem, remedy));
    }

    fn too_many(&mut self, count: usize, held: usize, smallest: f64, words: &Armour, key: &str) {
        let problem = format!(
            "the wires overlap: {count} of {} at {} deg need a pitch radius of {}, and the layer lies on {}; at most {held} fit",
            mm(words.wire_diameter_m),
            words.lay_angle_deg,
            mm(smallest),
            mm(self.reach + 0.5 * words.wire_diameter_m)
        );
        let remedy = format!("give {held} or fewer, or leave it out for as many as fit");
        self.wrong
            .push(Misfit::new(&["layer", key, "count"], problem, remedy));
    }

    /// Warns of units with nothing under them.
    fn floating(&mut self, inner: f64, thickest: f64, key: &str) {
        let gap = inner - self.reach;
        let (bound, problem) = if self.reach > 0.0 {
            let problem = format!("there is a gap of {} below the layer", mm(gap));
            (0.2 * thickest, problem)
        } else {
            let problem = format!("the middle is hollow, {} wide", mm(2.0 * gap));
            (thickest, problem)
        };
        if gap > bound {
            let remedy = format!(
                "fill it, for example with a jacket or a unit of diameter {}, or the units move inwards under tension",
                at_most(2.0 * inner)
            );
            self.warnings
                .push(Misfit::new(&["layer", key], problem, remedy));
        }
    }

    /// Warns of a layer that does not close.
    fn sparse(&mut self, helix: &Helix, set: &Ring, key: &str) {
        let count = helix.elements.len();
        let one = set.taken / count.max(1) as f64;
        let room = if one > 0.0 {
            ((TAU - set.taken) / one).floor()
        } else {
            0.0
        };
        if count > 1 && set.taken < SPARSE * TAU && room >= 1.0 {
            let problem = format!(
                "the layer does not close: {count} units cover {} % of the turn, {room} more would fit",
                (100.0 * helix.coverage).floor()
            );
            let remedy = "add units or filler ropes, or the layer shifts when the cable bends";
            self.warnings
                .push(Misfit::new(&["layer", key], problem, remedy));
        }
    }
}

/// Wires are alike and may be many, so their places are simply shared out.
fn wires(radii: &[f64], radius: f64, angle: f64) -> Option<Ring> {
    let count = radii.len();
    let taken = match radii {
        [first, second, ..] => count as f64 * touching_phase(first + second, radius, angle)?,
        _ => 0.0,
    };
    let places = (0..count).map(|i| TAU * i as f64 / count as f64).collect();
    Some(Ring { places, taken })
}
