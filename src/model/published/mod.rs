//! Published numbers of a file, and the rows that compare them with computed ones.

pub(crate) mod comparison;
pub(crate) mod number;
mod row;

pub use comparison::compare;
pub(crate) use comparison::tolerance;
pub use number::PublishedNumber;
pub use row::{
    CalibrationBasis, CurveOverlay, Outcome, RowKind, TrendLine, TrendPoint, ValidationRow,
};
