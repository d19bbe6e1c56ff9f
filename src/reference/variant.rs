//! Variants of a case: one made from its text, and found again among stored runs.

use super::{ValidationRow, rows};
use crate::{
    case::{self, Case, Diagnostic, StudyPoint, edit},
    run::Run,
};

/// A case set to a point of one of its studies.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Variant {
    /// Text of the case with the study's key set.
    pub text: String,
    /// What was set, as `key=value`.
    pub overrides: Vec<String>,
}

/// Sets a case to a point of one of its studies.
///
/// # Errors
/// The case has no such study, or does not take the value.
pub fn variant(text: &str, case: &Case, at: &StudyPoint) -> Result<Variant, Vec<Diagnostic>> {
    let Some(study) = case.study.iter().find(|s| s.name == at.study) else {
        return Err(vec![Diagnostic::whole_file(
            &case.case.title,
            format!("There is no study named `{}`.", at.study),
            "Name one of the studies of the case.",
        )]);
    };
    let text =
        edit::set_value(text, &study.key, &at.value).map_err(|diagnostic| vec![diagnostic])?;
    Ok(Variant {
        text,
        overrides: vec![format!("{}={}", study.key, at.value)],
    })
}

/// The rows of one run: those of the case without a study where only keys of solver and output were overridden, and
/// those of every point of a study that the run was computed at. The others read NOT RUN.
#[must_use]
pub fn rows_of_run(run: &Run, case: &Case) -> Vec<ValidationRow> {
    rows(case, &|at| matches_variant(run, case, at).then_some(run))
}

/// True when a run was computed at this point of a study, or is the case without one.
#[must_use]
pub fn matches_variant(run: &Run, case: &Case, at: Option<&StudyPoint>) -> bool {
    let key = at
        .and_then(|at| case.study.iter().find(|s| s.name == at.study))
        .map(|s| &s.key);
    let foreign = run.info.overrides.iter().any(|word| {
        let set = word
            .split_once('=')
            .map_or(word.as_str(), |(key, _)| key.trim());
        !(set.starts_with("solver.") || set.starts_with("output.") || key.is_some_and(|k| k == set))
    });
    if foreign {
        return false;
    }
    // A run was computed at a point when setting the point does not change its case.
    at.is_none_or(|at| {
        let set = variant(&run.case_text, case, at).ok();
        let again = set.and_then(|v| case::parse(&v.text, &run.info.case_file).ok());
        again.is_some_and(|again| again == *case)
    })
}
