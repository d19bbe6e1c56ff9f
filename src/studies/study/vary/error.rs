//! Why a variation cannot be computed.

use crate::case::{Diagnostic, RangeError};
use crate::limits::POINTS;

/// Why a variation cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum VariationError {
    /// Words that are no key with values.
    #[error(
        "`{0}` gives no values; write KEY=A..B/N or KEY=a,b,c, such as current.speed_m_per_s=0.2..0.8/4"
    )]
    Syntax(String),
    /// A key that is not known.
    #[error("`{}` cannot be varied: {}; {}", .0.key, .0.problem, .0.remedy)]
    Key(Diagnostic),
    /// A key of several numbers.
    #[error("`{0}` has three numbers; vary one of them: `{0}.x`, `{0}.y` or `{0}.z`")]
    Coordinates(String),
    /// A key that takes no number.
    #[error("`{0}` takes no number and no choice of words, but {1}; vary another key")]
    NoNumber(String, String),
    /// Values that it cannot have.
    #[error("{0}: {1}.")]
    Range(String, RangeError),
    /// The same key again.
    #[error("`{0}` is varied twice; give all of its values at once")]
    Twice(String),
    /// More points than are computed.
    #[error("the variation has {count} points; {remedy}.", count = .0, remedy = POINTS.remedy("give fewer values", *.0 as f64))]
    TooMany(usize),
}
