//! One unit or wire: size, mass, stiffness, strength.

use std::f64::consts::PI;

use super::model::{Armour, DataSheetUnit, Rod, Tube, Unit};

/// A unit or a wire.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CableElement {
    /// Name of the unit, or of the layer for a wire.
    pub name: String,
    /// Kind: "tube", "wire".
    pub what: &'static str,
    /// Outer radius \[m\].
    pub radius: f64,
    /// Radius of the bore of a tube; 0 for others \[m\].
    pub bore_radius: f64,
    /// Mass per length, contents included \[kg/m\].
    pub mass: f64,
    /// Axial stiffness \[N\].
    pub ea: f64,
    /// Bending stiffness \[N m²\].
    pub ei: f64,
    /// Torsional stiffness \[N m²\].
    pub gj: f64,
    /// Poisson's ratio \[-\].
    pub poisson: f64,
    /// Load-carrying cross-section, where it is known \[m²\].
    pub area: Option<f64>,
    /// Axial strength, where it is known \[N\].
    pub strength: Option<f64>,
}

impl CableElement {
    /// A unit of this name.
    #[must_use]
    pub fn of_unit(name: &str, unit: &Unit) -> Self {
        match unit {
            Unit::Electric(whole) => Self::whole(name, "electric cable", whole),
            Unit::Fibre(whole) => Self::whole(name, "optical fibre", whole),
            Unit::Tube(tube) => Self::tube(name, tube),
            Unit::Rod(rod) => Self::rod(name, rod),
            Unit::Filler(filler) => {
                let area = disc(0.5 * filler.diameter_m);
                Self {
                    mass: area * filler.density_kg_per_m3,
                    ..Self::soft(name, "filler rope", filler.diameter_m)
                }
            }
        }
    }

    /// A wire of an armour layer.
    #[must_use]
    pub fn of_armour(armour: &Armour) -> Self {
        let rod = Rod {
            diameter_m: armour.wire_diameter_m,
            density_kg_per_m3: armour.density_kg_per_m3,
            youngs_modulus_pa: armour.youngs_modulus_pa,
            poisson_ratio: armour.poisson_ratio,
            shear_modulus_pa: None,
            strength_pa: armour.strength_pa,
            break_load_n: None,
        };
        Self {
            what: "wire",
            ..Self::rod(&armour.name, &rod)
        }
    }

    fn soft(name: &str, what: &'static str, diameter: f64) -> Self {
        Self {
            name: name.to_owned(),
            what,
            radius: 0.5 * diameter,
            ..Self::default()
        }
    }

    fn whole(name: &str, what: &'static str, whole: &DataSheetUnit) -> Self {
        Self {
            mass: whole.mass_kg_per_m,
            ea: whole.ea_n,
            ei: whole.ei_n_m2,
            gj: whole.gj_n_m2,
            poisson: whole.poisson_ratio,
            strength: whole.break_load_n,
            ..Self::soft(name, what, whole.diameter_m)
        }
    }

    fn tube(name: &str, tube: &Tube) -> Self {
        let outer = 0.5 * tube.tube_diameter_m.unwrap_or(tube.diameter_m);
        let bore = outer - tube.wall_m;
        let area = disc(outer) - disc(bore);
        let inertia = second_moment(outer) - second_moment(bore);
        let jacket = disc(0.5 * tube.diameter_m) - disc(outer);
        let shear = tube
            .shear_modulus_pa
            .unwrap_or_else(|| shear_modulus(tube.youngs_modulus_pa, tube.poisson_ratio));
        Self {
            bore_radius: bore,
            mass: area * tube.density_kg_per_m3
                + jacket * tube.jacket_density_kg_per_m3
                + disc(bore) * tube.content_density_kg_per_m3,
            ea: tube.youngs_modulus_pa * area,
            ei: tube.youngs_modulus_pa * inertia,
            gj: 2.0 * shear * inertia,
            poisson: tube.poisson_ratio,
            area: Some(area),
            strength: strength(tube.break_load_n, tube.strength_pa, area),
            ..Self::soft(name, "tube", tube.diameter_m)
        }
    }

    fn rod(name: &str, rod: &Rod) -> Self {
        let radius = 0.5 * rod.diameter_m;
        let (area, inertia) = (disc(radius), second_moment(radius));
        let shear = rod
            .shear_modulus_pa
            .unwrap_or_else(|| shear_modulus(rod.youngs_modulus_pa, rod.poisson_ratio));
        Self {
            mass: area * rod.density_kg_per_m3,
            ea: rod.youngs_modulus_pa * area,
            ei: rod.youngs_modulus_pa * inertia,
            gj: 2.0 * shear * inertia,
            poisson: rod.poisson_ratio,
            area: Some(area),
            strength: strength(rod.break_load_n, rod.strength_pa, area),
            ..Self::soft(name, "rod", rod.diameter_m)
        }
    }
}

/// The breaking load, which is measured, takes precedence over strength times area.
fn strength(load: Option<f64>, stress: Option<f64>, area: f64) -> Option<f64> {
    load.or_else(|| stress.map(|stress| stress * area))
}

/// Area of a disc of this radius \[m²\].
pub(super) fn disc(radius: f64) -> f64 {
    PI * radius * radius
}

/// Second moment of area of a disc of this radius about a diameter \[m⁴\].
pub(super) fn second_moment(radius: f64) -> f64 {
    0.25 * PI * radius.powi(4)
}

/// Shear modulus of an isotropic material \[Pa\].
pub(super) fn shear_modulus(youngs: f64, poisson: f64) -> f64 {
    0.5 * youngs / (1.0 + poisson)
}
