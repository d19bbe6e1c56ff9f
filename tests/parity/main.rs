//! What every kind of scene has, tried by the program.
//!
//! The fixtures in `tests/data/before_one_march` are what the program offered before lines and systems had one march: nothing of it is
//! lost.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod nothing_lost;
