//! What every kind of scene has, tried by the program: a feature holds for all of them, or it is written here where it does not yet.
//!
//! The fixtures in `tests/data/before_one_march` are what the program offered before lines and systems had one march: nothing of it is
//! lost.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/drawn_lines.rs"]
mod drawn_lines;
#[path = "../common/lines.rs"]
#[expect(dead_code, reason = "other tests need the case")]
mod lines;

mod case_as_system;
mod drawn;
mod features;
mod friction;
mod line_keys;
mod modes;
mod nothing_lost;
mod one_line;
mod recorded;
mod sliding;
mod trials;
