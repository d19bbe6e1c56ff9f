//! The quantities of a cross-section by name, for published values.

use super::design::Design;
use super::layout::Helix;
use super::model::Core;

/// A quantity that published values may name.
pub struct SectionQuantity {
    /// Name, ending in its unit where it has one.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Meaning.
    pub description: &'static str,
    read: fn(&Design) -> Option<f64>,
}

const fn quantity(
    name: &'static str,
    unit: &'static str,
    read: fn(&Design) -> Option<f64>,
    description: &'static str,
) -> SectionQuantity {
    SectionQuantity {
        name,
        unit,
        description,
        read,
    }
}

/// All quantities; equations are those of Lin et al. (2016).
#[rustfmt::skip] // one quantity a line
pub static QUANTITIES: [SectionQuantity; 19] = [
    quantity("outer_diameter_m", "m", |d| Some(2.0 * d.layout.outer_radius), "outer diameter"),
    quantity("mass_kg_per_m", "kg/m", |d| Some(d.weight.in_air), "mass in air with empty gaps"),
    quantity("moving_mass_kg_per_m", "kg/m", |d| Some(d.weight.moving), "mass with the water in flooded gaps"),
    quantity("wet_weight_n_per_m", "N/m", |d| Some(d.weight.in_water_force), "weight in water"),
    quantity("ea_rigid_n", "N", |d| Some(d.matrix(Core::Rigid).tension_strain), "axial stiffness with fixed ends and a rigid core, eq. (16)"),
    quantity("ea_incompressible_n", "N", |d| Some(d.matrix(Core::Incompressible).tension_strain), "the same with an incompressible core"),
    quantity("tension_twist_n_m", "N m", |d| Some(d.matrix(Core::Rigid).tension_twist), "tension from twist per length, eq. (16)"),
    quantity("torque_strain_rigid_n_m", "N m", |d| Some(d.matrix(Core::Rigid).torque_strain), "torque from strain with a rigid core, eq. (17)"),
    quantity("torque_strain_incompressible_n_m", "N m", |d| Some(d.matrix(Core::Incompressible).torque_strain), "the same with an incompressible core"),
    quantity("gj_n_m2", "N m2", |d| Some(d.matrix(Core::Rigid).torque_twist), "torsional stiffness at fixed length, eq. (17)"),
    quantity("ei_slip_n_m2", "N m2", |d| Some(d.bending.full_slip()), "bending stiffness at full slip, with that of the sheaths"),
    quantity("ei_stick_n_m2", "N m2", |d| Some(d.bending.full_stick()), "bending stiffness at full stick, with that of the sheaths"),
    quantity("ei_units_n_m2", "N m2", |d| Some(d.bending.helices + d.bending.centre), "bending stiffness of centre and helical layers at full slip, eqs. (18)-(19)"),
    quantity("ei_sheaths_n_m2", "N m2", |d| Some(d.bending.sheaths), "bending stiffness of the sheaths"),
    quantity("break_load_n", "N", |d| d.strength.as_ref().map(|s| s.break_load), "tension at which the first unit reaches its strength"),
    quantity("allowable_tension_n", "N", |d| d.strength.as_ref().map(|s| s.allowable), "the same by the usage factor"),
    quantity("units", "-", |d| Some(units(d)), "units of the centre and the layers of units"),
    quantity("armour_layers", "-", |d| Some(armour(d).count() as f64), "layers of armour wires"),
    quantity("armour_wires", "-", |d| Some(armour(d).map(|h| h.elements.len()).sum::<usize>() as f64), "wires of all of them"),
];

fn armour(design: &Design) -> impl Iterator<Item = &Helix> {
    design.layout.helices().filter(|helix| helix.armour)
}

fn units(design: &Design) -> f64 {
    let layers = design.layout.helices().filter(|helix| !helix.armour);
    let laid: usize = layers.map(|helix| helix.elements.len()).sum();
    (laid + usize::from(design.layout.centre.is_some())) as f64
}

/// The quantity of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static SectionQuantity> {
    QUANTITIES.iter().find(|quantity| quantity.name == name)
}

impl SectionQuantity {
    /// Its value; nothing where the section does not have it.
    #[must_use]
    pub fn value(&self, design: &Design) -> Option<f64> {
        (self.read)(design)
    }
}
