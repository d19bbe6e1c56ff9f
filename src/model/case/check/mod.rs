//! Checks of a case file. [`keys`] holds every table and value against its declaration; [`mod@line`], [`ends`], [`rope`],
//! [`loads`], [`payload`], [`sea`], [`mod@solver`], [`start`], [`validation_data`] and [`trials`] hold typed values against each other. They pass
//! over what is missing or faulty, so that everything is reported at once, each at its place.

mod checks;
mod creep;
mod ends;
mod keys;
mod line;
mod load_cases;
mod loads;
mod names;
mod paths;
mod payload;
mod recorded;
mod rope;
mod sea;
mod solver;
mod start;
mod taken;
mod trials;
mod validation_data;

use super::diagnostic::Finding;
use super::model::CaseKeys;

pub(crate) use checks::{is_of_check, of_checks};
pub(crate) use keys::{check as check_keys, fields_here, subtable};
pub(crate) use load_cases::{of_load_cases, takes_values, variable, varied};
pub(crate) use loads::{current as of_current, increasing, too_many_rows, too_many_steps};
pub(crate) use names::{unknown, unknown_name, used_twice};
pub(crate) use paths::{marks, unknown_path};
pub(crate) use rope::of_material;
pub(crate) use sea::of_waves;

/// Errors of the keys of a case against each other.
pub(super) fn check(keys: &CaseKeys<'_>) -> Vec<Finding> {
    const CHECKS: [fn(&CaseKeys<'_>) -> Vec<Finding>; 10] = [
        line::check,
        ends::check,
        rope::check,
        loads::check,
        payload::check,
        sea::check,
        solver::check,
        start::check,
        validation_data::check,
        trials::check,
    ];
    CHECKS.iter().flat_map(|check| check(keys)).collect()
}
