//! Geometry of a section: circles and helices.

use std::f64::consts::TAU;

use super::element::{CableElement, disc, second_moment, shear_modulus};
use super::model::{Centre, Sheath};

/// A section laid out.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionLayout {
    /// The unit in the centre.
    pub centre: Option<CentreCylinder>,
    /// The layers, from the inside out.
    pub shells: Vec<LaidLayer>,
    /// Outer radius of the whole \[m\].
    pub outer_radius: f64,
    /// Warnings about the geometry.
    pub warnings: Vec<String>,
}

/// The unit in the centre with its jacket.
#[derive(Debug, Clone, PartialEq)]
pub struct CentreCylinder {
    /// The unit.
    pub element: CableElement,
    /// Outer radius, over the jacket \[m\].
    pub radius: f64,
    /// Its keys in the file.
    pub input: Centre,
}

/// Stiffness of a round tube of one material.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct TubeStiffness {
    /// Cross-section \[m²\].
    pub area: f64,
    /// Axial stiffness \[N\].
    pub ea: f64,
    /// Bending stiffness \[N m²\].
    pub ei: f64,
    /// Torsional stiffness \[N m²\].
    pub gj: f64,
}

impl TubeStiffness {
    fn of_tube(inner: f64, outer: f64, youngs: f64, poisson: f64) -> Self {
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

impl CentreCylinder {
    /// The jacket.
    #[must_use]
    pub fn jacket(&self) -> TubeStiffness {
        let input = &self.input;
        let (youngs, poisson) = (input.jacket_youngs_modulus_pa, input.jacket_poisson_ratio);
        TubeStiffness::of_tube(self.element.radius, self.radius, youngs, poisson)
    }

    /// Mass per length \[kg/m\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.element.mass + self.jacket().area * self.input.jacket_density_kg_per_m3
    }
}

impl SheathTube {
    /// Its stiffness.
    #[must_use]
    pub fn solid(&self) -> TubeStiffness {
        let (youngs, poisson) = (self.input.youngs_modulus_pa, self.input.poisson_ratio);
        TubeStiffness::of_tube(self.inner_radius, self.outer_radius, youngs, poisson)
    }

    /// Mass per length \[kg/m\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.solid().area * self.input.density_kg_per_m3
    }
}

/// A layer laid out.
#[derive(Debug, Clone, PartialEq)]
pub enum LaidLayer {
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
    pub elements: Vec<CableElement>,
    /// Angular position of each of them in the section \[rad\].
    pub places: Vec<f64>,
    /// Lay angle to the axis, positive for a right-handed helix \[rad\].
    pub angle: f64,
    /// Radius of the helix \[m\].
    pub pitch_radius: f64,
    /// Smallest radius on which the units fit \[m\].
    pub smallest_radius: f64,
    /// Outer radius of the layers inside \[m\].
    pub inner_radius: f64,
    /// Radius over the layer \[m\].
    pub outer_radius: f64,
    /// Share of the full turn that the units take \[-\].
    pub coverage: f64,
    /// Share of the gaps that filler ropes take, and their density \[kg/m³\].
    pub filler: (f64, f64),
}

impl Helix {
    /// Lay length: length of cable in which a unit makes one turn \[m\].
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

    /// Area of the gaps between the units and the layers inside and outside \[m²\].
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
    /// Its keys in the file.
    pub input: Sheath,
    /// Inner radius \[m\].
    pub inner_radius: f64,
    /// Outer radius \[m\].
    pub outer_radius: f64,
}

impl LaidLayer {}

impl SectionLayout {
    /// The helical layers, from the inside out.
    pub fn helices(&self) -> impl Iterator<Item = &Helix> {
        self.shells.iter().filter_map(|shell| match shell {
            LaidLayer::Helix(helix) => Some(helix),
            LaidLayer::Tube(_) => None,
        })
    }

    /// The sheaths, from the inside out.
    pub fn sheaths(&self) -> impl Iterator<Item = &SheathTube> {
        self.shells.iter().filter_map(|shell| match shell {
            LaidLayer::Tube(tube) => Some(tube),
            LaidLayer::Helix(_) => None,
        })
    }
}
