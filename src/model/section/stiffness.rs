//! Tension and torsion after Knapp, R. H. (1979), "Derivation of a new stiffness matrix for helically
//! armored cables considering tension and torsion", Int. J. Numer. Methods Eng. 14, 515-529, in the
//! linear form of Lin et al. (2016), "Research on numeric simulation of umbilical on cross-section
//! and static analysis", Periodical of Ocean University of China 46(12), 111-116, eqs. (16)-(17).
//!
//! ```text
//! F = [Σ E A cos α (cos²α − Θ (R_c/2R) sin²α) + E_c A_c] ε + [Σ E A R sin α cos²α] τ
//! M = [Σ E A R sin α (cos²α − Θ (R_c/2R) sin²α)] ε + [Σ E A R² sin²α cos α + G_c J_c] τ
//! ```
//!
//! with the strain ε of the cable, its twist per length τ, the lay angle α to the axis (positive
//! for right-handed layers), the pitch radius R, and the radius R_c of the central cylinder. A
//! rigid core has Θ = 0; an incompressible one, Θ = 1, contracts by ε R_c/2 under strain, and
//! all layers follow it inwards. Sheaths carry nothing here.
//!
//! With Θ = 0 the matrix is symmetric, as Maxwell's reciprocity requires. With Θ = 1 it is not: the equations count the
//! tension of the wires but not their pressure on the core, p A_c = Σ t (R_c/2R) sin²α/cos α for wires of force t;
//! [`ea_with_core_pressure`] subtracts it, which agrees with virtual work.

use super::layout::SectionLayout;
use super::model::Core;

/// Tension F and torque M from strain ε and twist per length τ.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StiffnessMatrix {
    /// F from ε \[N\]: the axial stiffness EA with fixed ends.
    pub tension_strain: f64,
    /// F from τ \[N m\].
    pub tension_twist: f64,
    /// M from ε \[N m\].
    pub torque_strain: f64,
    /// M from τ \[N m²\]: the torsional stiffness GJ at fixed length.
    pub torque_twist: f64,
}

/// Whether the ends of the cable may rotate about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EndRotation {
    /// No rotation: τ = 0.
    Fixed,
    /// Free rotation: M = 0.
    Free,
}

impl StiffnessMatrix {
    /// Axial stiffness \[N\].
    #[must_use]
    pub fn ea(&self, twist: EndRotation) -> f64 {
        match twist {
            EndRotation::Fixed => self.tension_strain,
            EndRotation::Free => self.tension_strain + self.tension_twist * self.twist_per_strain(),
        }
    }

    /// Torsional stiffness at fixed length \[N m²\].
    #[must_use]
    pub fn gj_fixed_length(&self) -> f64 {
        self.torque_twist
    }

    /// Torsional stiffness without tension, at free length \[N m²\].
    #[must_use]
    pub fn gj_free_length(&self) -> f64 {
        self.torque_twist - self.torque_strain * ratio(self.tension_twist, self.tension_strain)
    }

    /// Strain and twist per length \[rad/m\] under a tension \[N\]; `None` without axial stiffness.
    #[must_use]
    pub fn strain_and_twist(&self, tension: f64, twist: EndRotation) -> Option<(f64, f64)> {
        let ea = self.ea(twist);
        let strain = tension / ea;
        let twist_per_strain = match twist {
            EndRotation::Fixed => 0.0,
            EndRotation::Free => self.twist_per_strain(),
        };
        (ea > 0.0 && strain.is_finite()).then_some((strain, strain * twist_per_strain))
    }

    /// Rotation per length by strain when there is no torque \[rad/m\].
    fn twist_per_strain(&self) -> f64 {
        -ratio(self.torque_strain, self.torque_twist)
    }
}

fn ratio(of: f64, by: f64) -> f64 {
    if by > 0.0 { of / by } else { 0.0 }
}

/// Strain of a unit of a layer by strain of the cable: cos²α − Θ (R_c/2R) sin²α \[-\].
pub(super) fn unit_strain(
    layout: &SectionLayout,
    pitch_radius: f64,
    angle: f64,
    core: Core,
) -> f64 {
    let core_radius = layout.centre.as_ref().map_or(0.0, |centre| centre.radius);
    let contraction = core.theta() * core_radius / (2.0 * pitch_radius);
    angle.cos().powi(2) - contraction * angle.sin().powi(2)
}

/// The stiffness matrix of a section.
#[must_use]
pub fn matrix(layout: &SectionLayout, core: Core) -> StiffnessMatrix {
    let mut sum = StiffnessMatrix::default();
    if let Some(centre) = &layout.centre {
        let jacket = centre.jacket();
        sum.tension_strain += centre.element.ea + jacket.ea;
        sum.torque_twist += centre.element.gj + jacket.gj;
    }
    for helix in layout.helices() {
        let (sin, cos) = helix.angle.sin_cos();
        let radius = helix.pitch_radius;
        let ea: f64 = helix.elements.iter().map(|unit| unit.ea).sum();
        let strained = unit_strain(layout, radius, helix.angle, core);
        sum.tension_strain += ea * cos * strained;
        sum.tension_twist += ea * radius * sin * cos * cos;
        sum.torque_strain += ea * radius * sin * strained;
        sum.torque_twist += ea * radius * radius * sin * sin * cos;
    }
    sum
}

/// Axial stiffness with fixed ends and an incompressible core, including the core pressure that eq. (16)
/// neglects: Σ E A (cos²α − (R_c/2R) sin²α)²/cos α + E_c A_c \[N\].
#[must_use]
pub fn ea_with_core_pressure(layout: &SectionLayout) -> f64 {
    let centre = layout.centre.as_ref();
    let centre = centre.map_or(0.0, |centre| centre.element.ea + centre.jacket().ea);
    let helices = layout.helices().map(|helix| {
        let ea: f64 = helix.elements.iter().map(|unit| unit.ea).sum();
        let (radius, angle) = (helix.pitch_radius, helix.angle);
        ea * unit_strain(layout, radius, angle, Core::Incompressible).powi(2) / angle.cos()
    });
    centre + helices.sum::<f64>()
}
