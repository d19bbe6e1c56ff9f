//! Exit statuses.

/// A bad result: a row outside its tolerance, a solver that failed.
pub(super) const BAD_RESULT: u8 = 1;
/// A command that could not be carried out.
pub(super) const BAD_INPUT: u8 = 2;
