//! Why a ropeway has no answer.

use crate::statics::catenary::Refusal;

/// Why a ropeway has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Trouble {
    /// The line at rest was not solved.
    #[error("{0}")]
    Refused(#[from] Refusal),
    /// No rope so heavy can hang with so little tension.
    #[error(
        "no length of this rope gives {asked_n:.1} N at the ship: over this span the least is {least_n:.1} N"
    )]
    TooLittleTension {
        /// What was asked for \[N\].
        asked_n: f64,
        /// The least there is \[N\].
        least_n: f64,
    },
    /// The rope would have to stretch further than ropes do.
    #[error("the rope would have to stretch by more than {:.0} %", 100.0 * crate::ropeway::exact::MOST_STRAIN)]
    Overstretched,
    /// An inextensible rope that does not reach.
    #[error("a rope of {length_m:.3} m that cannot stretch does not reach over {chord_m:.3} m")]
    TooShort {
        /// Its length \[m\].
        length_m: f64,
        /// Distance between the ends \[m\].
        chord_m: f64,
    },
    /// A rope so long or a pull so small that numbers end.
    #[error(
        "the rope hangs too deep for numbers to tell its forces; give less sag or a shorter rope"
    )]
    TooDeep,
    /// The ship goes further than the rope reaches.
    #[error(
        "at {time_s:.1} s the ship is {off_m:.2} m off its place, beyond the reach of {length_m:.2} m of rope; \
         give more rope, or a winch that is fast enough"
    )]
    BeyondReach {
        /// When \[s\].
        time_s: f64,
        /// How far off \[m\].
        off_m: f64,
        /// Rope that lies between the ends \[m\].
        length_m: f64,
    },
    /// A search that found nothing.
    #[error("{0}")]
    NotFound(&'static str),
}
