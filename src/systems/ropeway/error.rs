//! Errors of the models of a ropeway.

use crate::number::si;
use crate::statics::catenary::CatenaryError;

/// Why a model of a ropeway has no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RopewayError {
    /// The closed form of the line at rest was not solved.
    #[error("{0}")]
    Catenary(#[from] CatenaryError),
    /// The tension is below the least that any length of the rope gives.
    #[error(
        "no length of this rope gives {asked_n:.1} N at the ship: over this span the least is {least_n:.1} N"
    )]
    TooLittleTension {
        /// Tension required \[N\].
        asked_n: f64,
        /// Least tension of any length \[N\].
        least_n: f64,
    },
    /// The strain would exceed [`MOST_STRAIN`](super::elastic::MOST_STRAIN).
    #[error("the rope would have to stretch by more than {:.0} %", 100.0 * crate::ropeway::elastic::MOST_STRAIN)]
    Overstretched,
    /// An inextensible rope that does not reach.
    #[error("an inextensible rope of {length_m:.3} m does not reach over {chord_m:.3} m")]
    TooShort {
        /// Its length \[m\].
        length_m: f64,
        /// Distance between the ends \[m\].
        chord_m: f64,
    },
    /// The setting needs more rope than there is.
    #[error("takes {} of rope, and of the shortest there is {}", si(*.length_m, "m"), si(*.stored_m, "m"))]
    TooLittleRope {
        /// Length of rope between the ends \[m\].
        length_m: f64,
        /// Length of the shortest rope \[m\].
        stored_m: f64,
    },
    /// The horizontal tension is so small that the end forces overflow.
    #[error("the rope hangs so deep that its forces overflow; give less sag or a shorter rope")]
    TooDeep,
    /// The ship goes further than the rope reaches.
    #[error(
        "at {time_s:.1} s the ship is displaced by {off_m:.2} m, beyond the reach of {length_m:.2} m of rope; \
         give more rope, or a winch that is fast enough"
    )]
    BeyondReach {
        /// Time \[s\].
        time_s: f64,
        /// Displacement of the ship away from the platform \[m\].
        off_m: f64,
        /// Length of rope between the ends \[m\].
        length_m: f64,
    },
    /// The rope in motion has no answer, and why.
    #[error("{0}")]
    Motion(String),
    /// Anything else that has no solution, in words.
    #[error("{0}")]
    NotFound(&'static str),
}
