//! Why a variation cannot be computed.

use crate::case::Diagnostic;
use crate::limits::POINTS;

/// What is wrong with the values of a key, and what would be right.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RangeError {
    /// Nothing is given.
    #[error("there are no values; write A..B/N, such as 0.2..0.8/4, or a,b,c")]
    Empty,
    /// A range without a count.
    #[error("`{0}` lacks the number of values; write A..B/N, such as 0.2..0.8/4")]
    NoCount(String),
    /// A count that is none.
    #[error(
        "`{0}` is no number of values; give a whole number from 2 on, with `log` behind it for even ratios"
    )]
    Count(String),
    /// A count above the limit.
    #[error("it has {count} values; {remedy}", count = .0, remedy = POINTS.remedy("give fewer", *.0 as f64))]
    TooMany(usize),
    /// A text that is no number.
    #[error("`{text}` is no number{of_unit}; {remedy}")]
    NoNumber {
        /// The text.
        text: String,
        /// " of m", or nothing.
        of_unit: String,
        /// What would be right.
        remedy: String,
    },
    /// Ratios between numbers of unlike sign.
    #[error(
        "even ratios need two numbers above zero, and go from {0} to {1}; leave `log` out for even steps"
    )]
    NotPositive(String, String),
    /// Both ends are the same.
    #[error("the range begins and ends at {0}; give two different numbers, or the value alone")]
    NoLength(String),
    /// A value that the key does not take.
    #[error("{value} is out of range; the key takes {range}")]
    OutOfRange {
        /// The value with its unit.
        value: String,
        /// What it takes.
        range: String,
    },
    /// A key of whole numbers.
    #[error(
        "{0} is not a whole number, which the key takes; choose ends and count so that every step is whole"
    )]
    NotWhole(String),
    /// A value given twice.
    #[error("{0} is given twice; give each value once")]
    Twice(String),
    /// A word that the key does not take.
    #[error("`{word}` is not known; {remedy}")]
    Word {
        /// The word.
        word: String,
        /// What would be right.
        remedy: String,
    },
}

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
