//! Published numbers of a file, and the rows that compare them with computed ones.

pub mod comparison;
pub mod number;
mod row;

pub use comparison::compare;
pub use comparison::tolerance;
pub use number::PublishedNumber;
pub use row::{
    CalibrationBasis, CurveOverlay, Outcome, RowKind, TrendLine, TrendPoint, ValidationRow,
};
