//! Ropes whose stiffness is not one number, against what they must do.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod dynamic;
mod mooring;
mod table;
