//! Memory, counted by an allocator of this binary: it must not run beside other tests.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/small.rs"]
mod small;

mod memory_bound;
mod steps;
mod systems;
