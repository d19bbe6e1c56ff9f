//! Lays out the geometry of a section from the inside out; errors where units or layers overlap.

use std::f64::consts::TAU;

use super::element::CableElement;
use super::format::{at_least, at_most, degrees, mm};
use super::layout::{CentreCylinder, Helix, LaidLayer, SectionLayout, SheathTube};
use super::model::{Armour, CrossSection, Layer, Sheath, UnitLayer};
use super::packing::{PackedRing, most, ring, smallest_radius, touching_phase};
use crate::case::join;

/// Units a layer may have; a wire layer has its own, wider limit.
pub const MOST_UNITS: usize = 60;

/// A layer of less coverage than this, with room for one more unit, is sparse \[-\].
const SPARSE: f64 = 0.9;

/// Sizes that differ by less than this count as equal \[m\].
pub(super) const TOUCH: f64 = 1e-9;

/// Why a section cannot be laid out.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{problem}; {remedy}")]
pub struct LayoutError {
    /// The key meant.
    pub key: LayoutKey,
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
}

/// A key of a section; layers by their number from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayoutKey {
    /// The section as a whole.
    Section,
    /// A layer as a whole.
    Layer(usize),
    /// The units of a layer.
    Units(usize),
    /// The pitch radius of a layer of units.
    PitchRadius(usize),
    /// The number of wires of an armour layer.
    Count(usize),
}

impl LayoutError {
    pub(super) fn new(
        key: LayoutKey,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            key,
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }
}

/// Lays out a section that has passed validation.
///
/// # Errors
///
/// The first layer that cannot lie as the section says: the position of those around it is then unknown.
pub fn lay_out(section: &CrossSection) -> Result<SectionLayout, LayoutError> {
    let mut builder = LayoutBuilder::default();
    builder.centre(section)?;
    for (index, layer) in section.layers.iter().enumerate() {
        match layer {
            Layer::Units(input) => builder.units(section, input, index),
            Layer::Armour(input) => builder.armour(input, index),
            Layer::Sheath(input) => builder.sheath(input, index),
        }?;
    }
    builder.warnings.extend(unused(section));
    Ok(SectionLayout {
        centre: builder.centre,
        outer_radius: builder.outer_radius,
        shells: builder.shells,
        warnings: builder.warnings,
    })
}

/// The unit of this name.
fn unit_named(
    section: &CrossSection,
    name: &str,
    key: LayoutKey,
) -> Result<CableElement, LayoutError> {
    let unknown = || {
        let problem = format!("there is no unit named \"{}\"", name.escape_default());
        LayoutError::new(key, problem, "name one of the units of the section")
    };
    let unit = section.units.get(name).ok_or_else(unknown)?;
    Ok(CableElement::of_unit(name, unit))
}

/// Warnings of units that are described but lie nowhere.
fn unused(section: &CrossSection) -> impl Iterator<Item = String> {
    let used = |name: &str| {
        let in_centre = section.centre.as_ref().is_some_and(|c| c.unit == name);
        let in_layer = section.layers.iter().any(|layer| match layer {
            Layer::Units(layer) => layer.units.iter().any(|unit| unit == name),
            _ => false,
        });
        in_centre || in_layer
    };
    let idle = section.units.keys().filter(move |name| !used(name));
    idle.map(|name| {
        let remedy = "name it in [centre] or in the `units` of a layer, or remove it";
        format!("{}: the unit is not used; {remedy}", join(&["units", name]))
    })
}

#[derive(Default)]
struct LayoutBuilder {
    centre: Option<CentreCylinder>,
    shells: Vec<LaidLayer>,
    /// Outer radius of the layers so far \[m\].
    outer_radius: f64,
    warnings: Vec<String>,
}

impl LayoutBuilder {
    fn centre(&mut self, section: &CrossSection) -> Result<(), LayoutError> {
        let Some(input) = &section.centre else {
            return Ok(());
        };
        let element = unit_named(section, &input.unit, LayoutKey::Section)?;
        let radius = input.jacket_diameter_m.map_or(element.radius, |d| 0.5 * d);
        self.outer_radius = radius.max(element.radius);
        self.centre = Some(CentreCylinder {
            element,
            radius: self.outer_radius,
            input: input.clone(),
        });
        Ok(())
    }

    fn sheath(&mut self, input: &Sheath, index: usize) -> Result<(), LayoutError> {
        if self.outer_radius <= 0.0 {
            let remedy = "put the centre or a layer of units before it";
            let problem = "is a sheath around nothing";
            return Err(LayoutError::new(LayoutKey::Layer(index), problem, remedy));
        }
        let inner_radius = self.outer_radius;
        self.outer_radius += input.thickness_m;
        self.shells.push(LaidLayer::Tube(SheathTube {
            input: input.clone(),
            inner_radius,
            outer_radius: self.outer_radius,
        }));
        Ok(())
    }

    fn units(
        &mut self,
        section: &CrossSection,
        input: &UnitLayer,
        index: usize,
    ) -> Result<(), LayoutError> {
        let key = LayoutKey::Units(index);
        let named = input.units.iter();
        let elements: Vec<CableElement> = named
            .map(|name| unit_named(section, name, key))
            .collect::<Result<_, _>>()?;
        if elements.len() > MOST_UNITS {
            let problem = format!("holds {} units, more than {MOST_UNITS}", elements.len());
            let remedy =
                "spread them over several layers; wires belong in a layer of kind \"armour\"";
            return Err(LayoutError::new(key, problem, remedy));
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
            let key = match input.pitch_radius_m {
                Some(_) => LayoutKey::PitchRadius(index),
                None => key,
            };
            return Err(too_small(radius, smallest, elements.len(), angle, key));
        };
        if radius - thickest < self.outer_radius - TOUCH {
            return Err(self.too_far_in(radius, thickest, index));
        }
        self.floating(radius - thickest, thickest, &input.name);
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
        self.add(helix, &set);
        Ok(())
    }

    fn armour(&mut self, input: &Armour, index: usize) -> Result<(), LayoutError> {
        let angle = input.lay_angle_deg.to_radians();
        let wire = 0.5 * input.wire_diameter_m;
        let is_innermost = self.outer_radius <= 0.0;
        let smallest = |count: usize| smallest_radius(&vec![wire; count], angle);
        let (count, radius) = match (input.count, is_innermost) {
            (None, true) => {
                let problem = "has nothing inside that determines how many wires fit";
                let remedy = "give `count`, or put the centre or a layer before it";
                return Err(LayoutError::new(LayoutKey::Layer(index), problem, remedy));
            }
            (Some(count), true) => (count, smallest(count).max(wire) * (1.0 + 1e-9)),
            (count, false) => {
                let radius = self.outer_radius + wire;
                (count.unwrap_or_else(|| most(wire, radius, angle)), radius)
            }
        };
        let capacity = most(wire, radius, angle);
        let set = wires(&vec![wire; count], radius, angle).filter(|_| count <= capacity);
        let Some(set) = set else {
            return Err(self.too_many(count, capacity, smallest(count), input, index));
        };
        let helix = Helix {
            name: input.name.clone(),
            armour: true,
            elements: vec![CableElement::of_armour(input); count],
            places: set.places.clone(),
            angle: angle * input.sense.sign(),
            pitch_radius: radius,
            smallest_radius: smallest(count),
            inner_radius: self.outer_radius,
            outer_radius: radius + wire,
            coverage: set.taken / TAU,
            filler: (0.0, 0.0),
        };
        self.add(helix, &set);
        Ok(())
    }

    fn add(&mut self, helix: Helix, set: &PackedRing) {
        self.sparse(&helix, set);
        self.outer_radius = helix.outer_radius;
        self.shells.push(LaidLayer::Helix(helix));
    }

    fn too_far_in(&self, radius: f64, thickest: f64, index: usize) -> LayoutError {
        let problem = format!(
            "the layer overlaps another: its inner radius is {}, and the outer radius of the layers inside {}",
            mm(radius - thickest),
            mm(self.outer_radius)
        );
        let remedy = format!(
            "give pitch_radius_m = {} or more or leave it out, or make the layers inside thinner",
            at_least(self.outer_radius + thickest)
        );
        LayoutError::new(LayoutKey::PitchRadius(index), problem, remedy)
    }

    fn too_many(
        &self,
        count: usize,
        capacity: usize,
        smallest: f64,
        input: &Armour,
        index: usize,
    ) -> LayoutError {
        let problem = format!(
            "the wires overlap: {count} of {} at {} deg need a pitch radius of {}, and the layer lies on {}; at most {capacity} fit",
            mm(input.wire_diameter_m),
            input.lay_angle_deg,
            mm(smallest),
            mm(self.outer_radius + 0.5 * input.wire_diameter_m)
        );
        let remedy = format!("give {capacity} or fewer, or leave it out for as many as fit");
        LayoutError::new(LayoutKey::Count(index), problem, remedy)
    }

    /// Warns of a gap below the layer.
    fn floating(&mut self, inner: f64, thickest: f64, name: &str) {
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
            self.warn(name, &problem, &remedy);
        }
    }

    fn warn(&mut self, layer: &str, problem: &str, remedy: &str) {
        let layer = join(&["layer", layer]);
        self.warnings.push(format!("{layer}: {problem}; {remedy}"));
    }

    /// Warns of a layer that does not close.
    fn sparse(&mut self, helix: &Helix, set: &PackedRing) {
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
            self.warn(&helix.name, &problem, remedy);
        }
    }
}

/// Units that need a greater pitch radius.
fn too_small(radius: f64, smallest: f64, count: usize, angle: f64, key: LayoutKey) -> LayoutError {
    let problem = format!(
        "the units overlap: {count} of them at {} need a pitch radius of {} or more, and it is {}",
        degrees(angle),
        mm(smallest),
        mm(radius)
    );
    let remedy = format!(
        "give pitch_radius_m = {} or leave it out, or take fewer or thinner units",
        at_least(smallest)
    );
    LayoutError::new(key, problem, remedy)
}

/// Equal wires at equal angles.
fn wires(radii: &[f64], radius: f64, angle: f64) -> Option<PackedRing> {
    let count = radii.len();
    let taken = match radii {
        [first, second, ..] => count as f64 * touching_phase(first + second, radius, angle)?,
        _ => 0.0,
    };
    let places = (0..count).map(|i| TAU * i as f64 / count as f64).collect();
    Some(PackedRing { places, taken })
}
