//! Checks of a case file. [`mod@line`], [`ends`], [`rope`],
//! [`loads`], [`payload`], [`sea`], [`mod@solver`], [`start`], [`validation_data`] and [`trials`] hold typed values against each other. They pass
//! over what is missing or faulty, so that everything is reported at once, each at its place.

mod checks;
mod creep;
mod ends;
mod line;
mod load_cases;
mod loads;
mod payload;
mod published_curve;
mod recorded;
mod rope;
mod sea;
mod solver;
mod start;
mod studies;
mod taken;
mod trials;
mod validation_data;

use super::diagnostic::Finding;
use super::model::CaseKeys;

pub(crate) use checks::is_of_check;
pub use checks::of_checks;
pub use line::{CheckedSection, drag_twice, of_attachments};
pub use load_cases::{of_load_cases, takes_values};
pub(crate) use load_cases::{variable, varied};
pub use loads::{
    BedShapeKeys, FrictionKeys, current as of_current, increasing, too_many_rows, too_many_steps,
};
pub use published_curve::of_published_curves;
pub use rope::of_material;
pub use sea::{of_gauge, of_waves};
pub(crate) use seacable_keys::check::{
    check_keys, existing, fields_here, marks, names, unknown, unknown_name, unknown_path,
    used_twice,
};
pub use solver::{of_companions, of_longest_step};
pub use start::of_line_start;
pub use studies::{of_studies, of_study, of_study_point, two_others};
pub use taken::{of_result, of_window};
pub use trials::of_trials;

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
