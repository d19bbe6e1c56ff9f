//! Ropes whose stiffness is not one number: a tension-strain table, or a stiffness that depends on how the rope was
//! loaded before: by its mean tension, or by a slow part that creeps.

pub mod creep;
pub mod dynamic;
mod elastic_tension;
pub mod table;
pub mod working_curve;

pub use creep::CreepingRope;
pub use dynamic::{FibreRope, MeanState, RopeAverage, StaticElasticity, StiffnessForm};
pub use elastic_tension::ElasticTension;
pub use table::{TableInterpolation, TensionTable};

/// How the elastic tension of a material follows from its strain, where that is not in proportion.
#[derive(Debug, Clone, PartialEq)]
pub enum TensionLaw {
    /// By a table.
    TensionTable(TensionTable),
    /// With dynamic stiffness.
    FibreRope(FibreRope),
    /// With a slow part that creeps.
    Creeping(CreepingRope),
}

impl TensionLaw {
    /// Tension and slope at a strain \[-\]; about a mean, or at rest where there is none.
    #[inline]
    #[must_use]
    pub fn at(&self, strain: f64, mean: Option<&MeanState>) -> ElasticTension {
        match (self, mean) {
            (Self::TensionTable(table), _) => table.at(strain),
            (Self::FibreRope(rope), None) => rope.at_rest(strain),
            (Self::FibreRope(rope), Some(mean)) => rope.in_motion(strain, mean),
            (Self::Creeping(rope), _) => rope.at_rest(strain),
        }
    }

    /// Energy stored per unstretched length at a strain \[N\], and how it grows with the mean tension \[-\].
    #[must_use]
    pub fn stored(&self, strain: f64, mean: Option<&MeanState>) -> (f64, f64) {
        match (self, mean) {
            (Self::TensionTable(table), _) => (table.stored(strain), 0.0),
            (Self::FibreRope(rope), None) => (rope.stored_at_rest(strain), 0.0),
            (Self::FibreRope(rope), Some(mean)) => rope.stored_in_motion(strain, mean),
            (Self::Creeping(rope), _) => (rope.stored_at_rest(strain), 0.0),
        }
    }

    /// The strain at a tension \[N\] of a line at rest.
    #[must_use]
    pub fn strain_at(&self, tension: f64) -> f64 {
        match self {
            Self::TensionTable(table) => table.strain_at(tension),
            Self::FibreRope(rope) => rope.strain_at(tension),
            Self::Creeping(rope) => rope.strain_at(tension),
        }
    }

    /// A representative stiffness of the whole law \[N\].
    #[must_use]
    pub fn representative_stiffness(&self) -> f64 {
        match self {
            Self::TensionTable(table) => table.representative_stiffness(),
            Self::FibreRope(rope) => rope.representative_stiffness(),
            Self::Creeping(rope) => rope.curve.representative_stiffness(),
        }
    }

    /// A slope that the tension does not exceed \[N\], with dynamic stiffness up to half the breaking load: what
    /// explicit steps and tolerances must be small for.
    #[must_use]
    pub fn max_stiffness(&self) -> f64 {
        match self {
            Self::TensionTable(table) => table.max_stiffness(),
            Self::FibreRope(rope) => rope.max_stiffness(),
            Self::Creeping(rope) => rope.max_stiffness(),
        }
    }

    /// The dynamic stiffness, if that is what it has.
    #[must_use]
    pub fn dynamic(&self) -> Option<&FibreRope> {
        match self {
            Self::FibreRope(rope) => Some(rope),
            Self::TensionTable(_) | Self::Creeping(_) => None,
        }
    }

    /// The rope that creeps, if that is what it is.
    #[must_use]
    pub fn creeping(&self) -> Option<&CreepingRope> {
        match self {
            Self::Creeping(rope) => Some(rope),
            Self::TensionTable(_) | Self::FibreRope(_) => None,
        }
    }
}
