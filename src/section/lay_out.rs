//! Lays out the geometry of a section from the inside out; violations where units or layers overlap.

use std::f64::consts::TAU;

use super::element::Element;
use super::format::{at_least, at_most, degrees, mm};
use super::layer_checks::{layer_checks, layer_keys};
use super::layout::{CentreCylinder, Helix, Layout, SheathTube, Shell};
use super::model::{Armour, Layer, Section, Sheath, UnitLayer};
use super::packing::{Ring, most, ring, smallest_radius, touching_phase};
use super::units::{known_units, unit_named};
use crate::case::InvalidValue;

/// Units a layer may have; a wire layer has its own, wider limit.
pub const MOST_UNITS: usize = 60;

/// A layer of less coverage than this, with room for one more unit, is sparse \[-\].
const SPARSE: f64 = 0.9;

/// Sizes that differ by less than this count as equal \[m\].
const TOUCH: f64 = 1e-9;

/// Lays a section out.
///
/// # Errors
///
/// Every violation, with its key, the reason and a remedy.
pub fn lay_out(section: &Section) -> Result<Layout, Vec<InvalidValue>> {
    let mut violations = known_units(section);
    violations.extend(layer_checks(section));
    if section.centre.is_none() && section.layers.is_empty() {
        let remedy = "add [centre], or a [[layer]] of units";
        violations.push(InvalidValue::new(&["section"], "holds nothing", remedy));
    }
    if !violations.is_empty() {
        return Err(violations);
    }
    let mut builder = Builder::default();
    builder.centre(section);
    for (layer, name) in section.layers.iter().zip(layer_keys(section)) {
        builder.layer(section, layer, &name);
        if !builder.violations.is_empty() {
            // The position of the next layers is unknown.
            break;
        }
    }
    if builder.violations.is_empty() {
        Ok(builder.layout())
    } else {
        Err(builder.violations)
    }
}

#[derive(Default)]
struct Builder {
    centre: Option<CentreCylinder>,
    shells: Vec<Shell>,
    /// Outer radius of the layers so far \[m\].
    outer_radius: f64,
    warnings: Vec<InvalidValue>,
    violations: Vec<InvalidValue>,
}

impl Builder {
    fn layout(self) -> Layout {
        Layout {
            centre: self.centre,
            outer_radius: self.outer_radius,
            shells: self.shells,
            warnings: self.warnings,
        }
    }

    fn centre(&mut self, section: &Section) {
        let Some(input) = &section.centre else {
            return;
        };
        let Some(unit) = unit_named(section, &input.unit) else {
            return;
        };
        let element = Element::of_unit(&input.unit, unit);
        let radius = input.jacket_diameter_m.map_or(element.radius, |d| 0.5 * d);
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
            self.violations.push(InvalidValue::new(
                &["centre", "jacket_diameter_m"],
                problem,
                remedy,
            ));
        }
        self.outer_radius = radius.max(element.radius);
        self.centre = Some(CentreCylinder {
            element,
            radius: self.outer_radius,
            input: input.clone(),
        });
    }

    fn layer(&mut self, section: &Section, layer: &Layer, key: &str) {
        match layer {
            Layer::Units(input) => self.units(section, input, key),
            Layer::Armour(input) => self.armour(input, key),
            Layer::Sheath(input) => self.sheath(input, key),
        }
    }

    fn sheath(&mut self, input: &Sheath, key: &str) {
        if self.outer_radius <= 0.0 {
            let remedy = "put the centre or a layer of units before it";
            self.violations.push(InvalidValue::new(
                &["layer", key],
                "is a sheath around nothing",
                remedy,
            ));
        }
        let inner_radius = self.outer_radius;
        self.outer_radius += input.thickness_m;
        self.shells.push(Shell::Tube(SheathTube {
            input: input.clone(),
            inner_radius,
            outer_radius: self.outer_radius,
        }));
    }

    fn units(&mut self, section: &Section, input: &UnitLayer, key: &str) {
        let named = input.units.iter().filter_map(|name| {
            let unit = unit_named(section, name)?;
            Some(Element::of_unit(name, unit))
        });
        let elements: Vec<Element> = named.collect();
        if elements.len() > MOST_UNITS {
            let problem = format!("holds {} units, more than {MOST_UNITS}", elements.len());
            let remedy =
                "spread them over several layers; wires belong in a layer of kind \"armour\"";
            self.violations
                .push(InvalidValue::new(&["layer", key, "units"], problem, remedy));
            return;
        }
        let angle = input.lay_angle_deg.to_radians();
        let radii: Vec<f64> = elements.iter().map(|unit| unit.radius).collect();
        let thickest = radii.iter().copied().fold(0.0, f64::max);
        let smallest = smallest_radius(&radii, angle);
        let least = smallest.max(self.outer_radius + thickest);
        // The factor keeps a computed radius from violating the limit by rounding.
        let radius = input.pitch_radius_m.unwrap_or(least * (1.0 + 1e-9));
        let set = ring(&radii, radius, angle).filter(|set| set.taken <= TAU * (1.0 + 1e-9));
        let Some(set) = set else {
            self.too_small(radius, smallest, input, elements.len(), angle, key);
            return;
        };
        if radius - thickest < self.outer_radius - TOUCH {
            self.too_far_in(radius, thickest, key);
            return;
        }
        self.floating(radius - thickest, thickest, key);
        let helix = Helix {
            name: input.name.clone(),
            armour: false,
            elements,
            places: set.places.clone(),
            angle: angle * input.sense.sign(),
            pitch_radius: radius,
            smallest_radius: smallest,
            inner_radius: self.outer_radius,
            outer_radius: radius + thickest,
            coverage: set.taken / TAU,
            filler: (input.filler_fraction, input.filler_density_kg_per_m3),
        };
        self.sparse(&helix, &set, key);
        self.add(helix);
    }

    fn armour(&mut self, input: &Armour, key: &str) {
        let angle = input.lay_angle_deg.to_radians();
        let wire = 0.5 * input.wire_diameter_m;
        let is_innermost = self.outer_radius <= 0.0;
        let smallest = |count: usize| smallest_radius(&vec![wire; count], angle);
        let (count, radius) = match (input.count, is_innermost) {
            (None, true) => {
                let problem = "has nothing inside that determines how many wires fit";
                let remedy = "give `count`, or put the centre or a layer before it";
                self.violations
                    .push(InvalidValue::new(&["layer", key], problem, remedy));
                return;
            }
            (Some(count), true) => (count, smallest(count).max(wire) * (1.0 + 1e-9)),
            (count, false) => {
                let radius = self.outer_radius + wire;
                (count.unwrap_or_else(|| most(wire, radius, angle)), radius)
            }
        };
        let capacity = most(wire, radius, angle);
        if count > capacity {
            self.too_many(count, capacity, smallest(count), input, key);
            return;
        }
        let radii = vec![wire; count];
        let Some(set) = wires(&radii, radius, angle) else {
            return;
        };
        let helix = Helix {
            name: input.name.clone(),
            armour: true,
            elements: vec![Element::of_armour(input); count],
            places: set.places.clone(),
            angle: angle * input.sense.sign(),
            pitch_radius: radius,
            smallest_radius: smallest(count),
            inner_radius: self.outer_radius,
            outer_radius: radius + wire,
            coverage: set.taken / TAU,
            filler: (0.0, 0.0),
        };
        self.sparse(&helix, &set, key);
        self.add(helix);
    }

    fn add(&mut self, helix: Helix) {
        self.outer_radius = helix.outer_radius;
        self.shells.push(Shell::Helix(helix));
    }

    fn too_small(
        &mut self,
        radius: f64,
        smallest: f64,
        input: &UnitLayer,
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
        let last = if input.pitch_radius_m.is_some() {
            "pitch_radius_m"
        } else {
            "units"
        };
        let remedy = format!(
            "give pitch_radius_m = {} or leave it out, or take fewer or thinner units",
            at_least(smallest)
        );
        self.violations
            .push(InvalidValue::new(&["layer", key, last], problem, remedy));
    }

    fn too_far_in(&mut self, radius: f64, thickest: f64, key: &str) {
        let problem = format!(
            "the layer overlaps another: its inner radius is {}, and the outer radius of the layers inside {}",
            mm(radius - thickest),
            mm(self.outer_radius)
        );
        let remedy = format!(
            "give pitch_radius_m = {} or more or leave it out, or make the layers inside thinner",
            at_least(self.outer_radius + thickest)
        );
        let path = ["layer", key, "pitch_radius_m"];
        self.violations
            .push(InvalidValue::new(&path, problem, remedy));
    }

    fn too_many(
        &mut self,
        count: usize,
        capacity: usize,
        smallest: f64,
        input: &Armour,
        key: &str,
    ) {
        let problem = format!(
            "the wires overlap: {count} of {} at {} deg need a pitch radius of {}, and the layer lies on {}; at most {capacity} fit",
            mm(input.wire_diameter_m),
            input.lay_angle_deg,
            mm(smallest),
            mm(self.outer_radius + 0.5 * input.wire_diameter_m)
        );
        let remedy = format!("give {capacity} or fewer, or leave it out for as many as fit");
        self.violations
            .push(InvalidValue::new(&["layer", key, "count"], problem, remedy));
    }

    /// Warns of a gap below the layer.
    fn floating(&mut self, inner: f64, thickest: f64, key: &str) {
        let gap = inner - self.outer_radius;
        let (bound, problem) = if self.outer_radius > 0.0 {
            let problem = format!("there is a gap of {} below the layer", mm(gap));
            (0.2 * thickest, problem)
        } else {
            let problem = format!("the centre is hollow, {} wide", mm(2.0 * gap));
            (thickest, problem)
        };
        if gap > bound {
            let remedy = format!(
                "fill it, for example with a jacket or a unit of diameter {}, or the units move inwards under tension",
                at_most(2.0 * inner)
            );
            self.warnings
                .push(InvalidValue::new(&["layer", key], problem, remedy));
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
                "the layer does not close: {count} units cover {} % of the circumference, {room} more would fit",
                (100.0 * helix.coverage).floor()
            );
            let remedy = "add units or filler ropes, or the layer shifts when the cable bends";
            self.warnings
                .push(InvalidValue::new(&["layer", key], problem, remedy));
        }
    }
}

/// Equal wires at equal angles.
fn wires(radii: &[f64], radius: f64, angle: f64) -> Option<Ring> {
    let count = radii.len();
    let taken = match radii {
        [first, second, ..] => count as f64 * touching_phase(first + second, radius, angle)?,
        _ => 0.0,
    };
    let places = (0..count).map(|i| TAU * i as f64 / count as f64).collect();
    Some(Ring { places, taken })
}
