//! A line whose ends are paid out.

use crate::case::Case;

/// A line that is paid out.
#[derive(Debug, Clone)]
pub struct PaidLine {
    /// Which line.
    pub line: usize,
    /// What passes its ends A and B: the payout, and the sign of its length here.
    pub ends: [Option<(usize, f64)>; 2],
    /// The line as it is at rest.
    pub case: Case,
}
