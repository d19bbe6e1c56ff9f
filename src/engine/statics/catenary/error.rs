//! Why a line is not solved.

use thiserror::Error;

/// A line without an equilibrium, without a unique one, or with one that fails its verification.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CatenaryError {
    /// An invalid number.
    #[error("{quantity} is {value}; it must be {needs}")]
    Input {
        /// Which quantity, with its unit.
        quantity: &'static str,
        /// The number given.
        value: f64,
        /// The valid numbers.
        needs: &'static str,
    },
    /// An end lies under the bed.
    #[error("end {end} lies {below_m:.6} m below the bed; it must be on it or above")]
    EndBelowBed {
        /// A or B.
        end: char,
        /// How far below \[m\].
        below_m: f64,
    },
    /// An end of a buoyant line lies above the surface that holds the line down.
    #[error("end {end} lies {above_m:.6} m above the surface; it must be on it or below")]
    EndAboveSurface {
        /// A or B.
        end: char,
        /// How far above \[m\].
        above_m: f64,
    },
    /// More line on a slope than friction holds.
    #[error(
        "the line is slack on the slope: the surplus slides downhill and has no place of its own; \
         friction of at least {needed:.4} would hold it"
    )]
    SlackOnSlope {
        /// The coefficient that would hold it: the tangent of the slope.
        needed: f64,
    },
    /// Friction on a grounded part between two suspended ones.
    #[error(
        "the line lies on the bed between two hanging parts; with friction its tension there depends on how \
         it was laid, so the end positions do not determine it; without friction they do"
    )]
    FrictionUndetermined,
    /// Touchdown on a sloping bed below end A.
    #[error(
        "the line comes down on a sloping bed below end A, which is not covered; A must be on the sloping bed"
    )]
    SlopeBelowA,
    /// A weightless line longer than the distance.
    #[error(
        "the line has no weight and is longer than the distance between its ends: its shape is not determined"
    )]
    ShapeUndetermined,
    /// An inextensible line shorter than the distance.
    #[error(
        "the line cannot stretch and is {short_m:.6} m shorter than the distance between its ends"
    )]
    TooShort {
        /// Missing length \[m\].
        short_m: f64,
    },
    /// A pattern of contact with the bed that is not covered.
    #[error("{0}")]
    UnsupportedContact(&'static str),
    /// A line that is at the surface otherwise than from its ends on.
    #[error("{0}")]
    AtSurface(&'static str),
    /// The forces found do not reproduce the position of the end closely enough.
    #[error(
        "not solved: the forces found would put the end where the line pulls with an error of {error:.1e} of its \
         end tension (after {iterations} iterations)"
    )]
    NotVerified {
        /// Achieved error of force over end tension.
        error: f64,
        /// Iterations spent.
        iterations: u32,
    },
}
