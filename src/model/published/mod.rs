//! Published numbers of a file, and the rows that compare them with computed ones.

pub mod comparison;
mod computed;
pub mod number;
mod row;
pub mod trend;

pub use comparison::compare;
pub use comparison::tolerance;
pub use computed::ComputedNumber;
pub use number::PublishedNumber;
pub use row::{
    CalibrationBasis, CurveOverlay, Outcome, RowKind, TrendLine, TrendPoint, ValidationRow,
};
pub use trend::PublishedTrend;
