//! Where everything lies: from the words of a section to circles, and what cannot lie so.

use std::f64::consts::TAU;

use super::element::{Element, disc, second_moment, shear_modulus};
use super::misfit::{Misfit, at_least, at_most, degrees, mm};
use super::model::{Armour, Centre, Layer, Section, Sheath, UnitLayer};
use super::packing::{Ring, most, ring, smallest_radius};
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

/// A section laid out.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// What runs in the middle.
    pub centre: Option<Middle>,
    /// The layers, from the inside out.
    pub shells: Vec<Shell>,
    /// Outer radius of the whole \[m\].
    pub outer_radius: f64,
    /// What fits but should be looked at.
    pub warnings: Vec<Misfit>,
}

/// The unit in the middle with its jacket.
#[derive(Debug, Clone, PartialEq)]
pub struct Middle {
    /// The unit.
    pub element: Element,
    /// Outer radius, over the jacket \[m\].
    pub radius: f64,
    /// What the section says of it.
    pub words: Centre,
}

/// Stiffness of a round tube of one material.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Solid {
    /// Cross-section \[m²\].
    pub area: f64,
    /// Axial stiffness \[N\].
    pub ea: f64,
    /// Bending stiffness \[N m²\].
    pub ei: f64,
    /// Torsional stiffness \[N m²\].
    pub gj: f64,
}

impl Solid {
    fn of(inner: f64, outer: f64, youngs: f64, poisson: f64) -> Self {
        let area = (disc(outer) - disc(inner)).max(0.0);
        let inertia = (second_moment(outer) - second_moment(inner)).max(0.0);
        Self {
            area,
            ea: youngs * area,
            ei: youngs * inertia,
            gj: 2.0 * shear_modulus(youngs, poisson) * inertia,
        }
    }
}

impl Middle {
    /// The jacket.
    #[must_use]
    pub fn jacket(&self) -> Solid {
        let words = &self.words;
        let (youngs, poisson) = (words.jacket_youngs_modulus_pa, words.jacket_poisson_ratio);
        Solid::of(self.element.radius, self.radius, youngs, poisson)
    }

    /// Mass per length \[kg/m\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.element.mass + self.jacket().area * self.words.jacket_density_kg_per_m3
    }
}

impl SheathTube {
    /// Its stiffness.
    #[must_use]
    pub fn solid(&self) -> Solid {
        let (youngs, poisson) = (self.words.youngs_modulus_pa, self.words.poisson_ratio);
        Solid::of(self.inner_radius, self.outer_radius, youngs, poisson)
    }

    /// Mass per length \[kg/m\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.solid().area * self.words.density_kg_per_m3
    }
}

/// A layer laid out.
#[derive(Debug, Clone, PartialEq)]
pub enum Shell {
    /// Units or wires in a helix.
    Helix(Helix),
    /// A sheath.
    Tube(SheathTube),
}

/// Units or wires in a helix.
#[derive(Debug, Clone, PartialEq)]
pub struct Helix {
    /// Name of the layer.
    pub name: String,
    /// Whether these are armour wires.
    pub armour: bool,
    /// The units, in order around the layer.
    pub elements: Vec<Element>,
    /// The angle at which each of them lies in the section \[rad\].
    pub places: Vec<f64>,
    /// Lay angle to the axis, positive for a right-handed helix \[rad\].
    pub angle: f64,
    /// Radius of the helix \[m\].
    pub pitch_radius: f64,
    /// The smallest that would hold the units \[m\].
    pub smallest_radius: f64,
    /// Radius of what lies inside \[m\].
    pub inner_radius: f64,
    /// Radius over the layer \[m\].
    pub outer_radius: f64,
    /// Share of the full turn that the units take \[-\].
    pub coverage: f64,
    /// Share of the gaps that filler ropes take, and their density \[kg/m³\].
    pub filler: (f64, f64),
}

impl Helix {
    /// Length of the cable in which a unit goes round once \[m\].
    #[must_use]
    pub fn lay_length(&self) -> f64 {
        TAU * self.pitch_radius / self.angle.abs().tan()
    }

    /// Mass per length of cable, filler ropes included \[kg/m\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        let units: f64 = self.elements.iter().map(|unit| unit.mass).sum();
        let (fraction, density) = self.filler;
        units / self.angle.cos() + self.gaps() * fraction * density
    }

    /// The gaps between the units and what lies inside and around \[m²\].
    #[must_use]
    pub fn gaps(&self) -> f64 {
        let filled = self.elements.iter().map(|unit| disc(unit.radius));
        let filled = filled.sum::<f64>() / self.angle.cos();
        (disc(self.outer_radius) - disc(self.inner_radius) - filled).max(0.0)
    }
}

/// A sheath laid out.
#[derive(Debug, Clone, PartialEq)]
pub struct SheathTube {
    /// What the section says of it.
    pub words: Sheath,
    /// Inner radius \[m\].
    pub inner_radius: f64,
    /// Outer radius \[m\].
    pub outer_radius: f64,
}

impl Shell {
    /// Radius over the layer \[m\].
    #[must_use]
    pub fn outer_radius(&self) -> f64 {
        match self {
            Self::Helix(helix) => helix.outer_radius,
            Self::Tube(tube) => tube.outer_radius,
        }
    }
}

impl Layout {
    /// The helical layers, from the inside out.
    pub fn helices(&self) -> impl Iterator<Item = &Helix> {
        self.shells.iter().filter_map(|shell| match shell {
            Shell::Helix(helix) => Some(helix),
            Shell::Tube(_) => None,
        })
    }

    /// The sheaths, from the inside out.
    pub fn sheaths(&self) -> impl Iterator<Item = &SheathTube> {
        self.shells.iter().filter_map(|shell| match shell {
            Shell::Tube(tube) => Some(tube),
            Shell::Helix(_) => None,
        })
    }
}

/// Lays a section out.
///
/// # Errors
///
/// Everything that cannot lie as the section says, each with its key, the reason and a remedy.
pub fn lay_out(section: &Section) -> Result<Layout, Vec<Misfit>> {
    let mut wrong = known_units(section);
    wrong.extend(names(section));
    wrong.extend(armour_layers(section));
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
        let Some(angle) = self.lay_angle(words.lay_angle_deg, key) else {
            return;
        };
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
        let Some(angle) = self.lay_angle(words.lay_angle_deg, key) else {
            return;
        };
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

    /// The lay angle in radians, when it is one for a helix that carries tension.
    fn lay_angle(&mut self, given: f64, key: &str) -> Option<f64> {
        let (least, greatest) = LAY_ANGLES;
        if (least..=greatest).contains(&given) {
            return Some(given.to_radians());
        }
        let (problem, remedy) = if given < least {
            let problem = format!(
                "{given} deg is no helix: units that run straight cannot bend without being stretched"
            );
            (
                problem,
                format!(
                    "give {least} to {greatest} deg, usually 5 to 30; a straight unit belongs in the middle, as [centre]"
                ),
            )
        } else {
            let problem = format!(
                "{given} deg is a hoop: it carries no tension, and the theory of laid armour does not hold for it"
            );
            (
                problem,
                format!("give {least} to {greatest} deg, usually 5 to 30"),
            )
        };
        self.wrong.push(Misfit::new(
            &["layer", key, "lay_angle_deg"],
            problem,
            remedy,
        ));
        None
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
        [first, second, ..] => {
            count as f64 * super::packing::touching_phase(first + second, radius, angle)?
        }
        _ => 0.0,
    };
    let places = (0..count).map(|i| TAU * i as f64 / count as f64).collect();
    Some(Ring { places, taken })
}
