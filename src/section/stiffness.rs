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
//! rigid middle has Θ = 0; one that keeps its volume, Θ = 1, shrinks by ε R_c/2 under strain, and
//! all layers follow it inwards. Sheaths carry nothing here.
//!
//! With Θ = 0 the matrix is symmetric, as Maxwell's theorem asks. With Θ = 1 it is not: the wires'
//! tension is counted, the pressure they put on the middle is not. Wires of force t squeeze it with
//! p A_c = Σ t (R_c/2R) sin²α/cos α; [`ea_with_pressure`] takes that off, and is what virtual work
//! gives.

use super::layout::Layout;
use super::model::Core;

/// Tension F and torque M from strain ε and twist per length τ.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Matrix {
    /// F from ε \[N\]: the axial stiffness EA when the ends cannot turn.
    pub tension_strain: f64,
    /// F from τ \[N m\].
    pub tension_twist: f64,
    /// M from ε \[N m\].
    pub torque_strain: f64,
    /// M from τ \[N m²\]: the torsional stiffness GJ when the length is held.
    pub torque_twist: f64,
}

/// Whether the ends are kept from turning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Twist {
    /// They are: τ = 0.
    Held,
    /// They are not: M = 0.
    Free,
}

impl Matrix {
    /// Axial stiffness \[N\].
    #[must_use]
    pub fn ea(&self, twist: Twist) -> f64 {
        match twist {
            Twist::Held => self.tension_strain,
            Twist::Free => self.tension_strain + self.tension_twist * self.turn(),
        }
    }

    /// Torsional stiffness at held length \[N m²\].
    #[must_use]
    pub fn gj_held_length(&self) -> f64 {
        self.torque_twist
    }

    /// Torsional stiffness without tension, the length free \[N m²\].
    #[must_use]
    pub fn gj_free_length(&self) -> f64 {
        self.torque_twist - self.torque_strain * ratio(self.tension_twist, self.tension_strain)
    }

    /// Strain and twist per length \[rad/m\] under a tension \[N\]; nothing when nothing carries.
    #[must_use]
    pub fn stretched(&self, tension: f64, twist: Twist) -> Option<(f64, f64)> {
        let ea = self.ea(twist);
        let strain = tension / ea;
        let turn = match twist {
            Twist::Held => 0.0,
            Twist::Free => self.turn(),
        };
        (ea > 0.0 && strain.is_finite()).then_some((strain, strain * turn))
    }

    /// Twist per length by strain when there is no torque \[rad/m\].
    fn turn(&self) -> f64 {
        -ratio(self.torque_strain, self.torque_twist)
    }
}

fn ratio(of: f64, by: f64) -> f64 {
    if by > 0.0 { of / by } else { 0.0 }
}

/// How much a unit of a layer is strained, for a cable strained by 1: cos²α − Θ (R_c/2R) sin²α \[-\].
pub(super) fn unit_strain(layout: &Layout, pitch_radius: f64, angle: f64, core: Core) -> f64 {
    let squeezed = layout.centre.as_ref().map_or(0.0, |centre| centre.radius);
    let shrink = core.theta() * squeezed / (2.0 * pitch_radius);
    angle.cos().powi(2) - shrink * angle.sin().powi(2)
}

/// The stiffness matrix of a section.
#[must_use]
pub fn matrix(layout: &Layout, core: Core) -> Matrix {
    let mut sum = Matrix::default();
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

/// Axial stiffness with ends held and an incompressible middle whose pressure is counted, which
/// eq. (16) does not do: Σ E A (cos²α − (R_c/2R) sin²α)²/cos α + E_c A_c \[N\].
#[must_use]
pub fn ea_with_pressure(layout: &Layout) -> f64 {
    let centre = layout.centre.as_ref();
    let centre = centre.map_or(0.0, |centre| centre.element.ea + centre.jacket().ea);
    let helices = layout.helices().map(|helix| {
        let ea: f64 = helix.elements.iter().map(|unit| unit.ea).sum();
        let (radius, angle) = (helix.pitch_radius, helix.angle);
        ea * unit_strain(layout, radius, angle, Core::Incompressible).powi(2) / angle.cos()
    });
    centre + helices.sum::<f64>()
}
