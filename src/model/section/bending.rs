//! Bending after Costello, G. A. and Phillips, J. W. (1976), "Effective modulus of twisted wire
//! cables", J. Eng. Mech. Div. ASCE 102, 171-181 (also Costello 1990, *Theory of Wire Rope*), as
//! Lin et al. 2016 use it, eqs. (18)-(19):
//!
//! ```text
//! EI = Σ 2 cos α/(2 + ν sin²α) E I + E_c I_c
//! ```
//!
//! with the lay angle α to the axis (Costello counts it from the plane of the section). Every unit
//! bends about its own axis: full slip, the lower bound of the bending stiffness, reached at large
//! curvature. Sheaths are closed tubes and cannot slip: their stiffness is added.
//!
//! The upper bound is full stick: plane sections stay plane, a helical unit is
//! strained by κ R cos²α times the cosine of its place around the cable, and the layer adds
//! ½ Σ E A R² cos³α.

use super::layout::SectionLayout;

/// Bending stiffness of a section, by its parts \[N m²\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BendingStiffness {
    /// The helical layers.
    pub helices: f64,
    /// The centre with its jacket.
    pub centre: f64,
    /// The sheaths.
    pub sheaths: f64,
    /// Increase by the helical layers at full stick.
    pub friction: f64,
}

impl BendingStiffness {
    /// Sum at full slip, the lower bound \[N m²\].
    #[must_use]
    pub fn full_slip(&self) -> f64 {
        self.helices + self.centre + self.sheaths
    }

    /// Sum at full stick, the upper bound \[N m²\].
    #[must_use]
    pub fn full_stick(&self) -> f64 {
        self.full_slip() + self.friction
    }
}

/// The bending stiffness of a section.
#[must_use]
pub fn bending(layout: &SectionLayout) -> BendingStiffness {
    let helices = layout.helices().map(|helix| {
        let (sin, cos) = helix.angle.sin_cos();
        let units = helix
            .elements
            .iter()
            .map(|unit| unit.ei * 2.0 * cos / (2.0 + unit.poisson * sin * sin));
        units.sum::<f64>()
    });
    let friction = layout.helices().map(|helix| {
        let ea: f64 = helix.elements.iter().map(|unit| unit.ea).sum();
        0.5 * ea * helix.pitch_radius.powi(2) * helix.angle.cos().powi(3)
    });
    let centre = layout.centre.as_ref();
    BendingStiffness {
        friction: friction.sum(),
        helices: helices.sum(),
        centre: centre.map_or(0.0, |centre| centre.element.ei + centre.jacket().ei),
        sheaths: layout.sheaths().map(|sheath| sheath.solid().ei).sum(),
    }
}
