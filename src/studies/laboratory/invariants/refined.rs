//! A system on twice the segments, or in steps half as long.

use toml::{Table, Value};

use super::tree::{change, listed, number, put};
use super::variant::SystemVariant;
use crate::system::discretised::SEGMENTS;

/// The local error of a step of second order falls by eight where the step is half as long.
const BY_HALF: f64 = 8.0;
/// The tolerance of steps of a file that does not say.
const STEP_TOLERANCE: f64 = 2e-5;

pub(super) fn refined(system: &Table) -> SystemVariant {
    let mut variant = SystemVariant::of_file(system.clone());
    for line in listed(&mut variant.file, "lines") {
        let before = number(line, "segments").unwrap_or(SEGMENTS as f64);
        put(line, "segments", Value::Integer(2 * before as i64));
    }
    variant
}

/// None of a system that does not move.
pub(super) fn halved(system: &Table) -> Option<SystemVariant> {
    let mut variant = SystemVariant::of_file(system.clone());
    let solver = variant.file.get_mut("solver")?.as_table_mut()?;
    change(solver, "time_step_s", |step| 0.5 * step);
    let before = number(solver, "step_tolerance").unwrap_or(STEP_TOLERANCE);
    put(solver, "step_tolerance", before / BY_HALF);
    Some(variant)
}
