//! Variants of a case: one made from its text, and found again among stored runs.

use super::{ValidationRow, rows_of_edited};
use crate::{
    case::{self, Case, Diagnostic, EditedKey, Study, StudyPoint, file_kind::FileKind, kind},
    run::{Run, edited_inputs},
};

/// A case set to a point of one of its studies.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StudyVariant {
    /// Text of the case with the study's key set.
    pub text: String,
    /// What was set, as `key=value`.
    pub overrides: Vec<String>,
}

/// Sets a file to a point of one of its studies; `file` is its name in the diagnostics.
///
/// # Errors
/// The file has no such study, or does not take the value.
pub fn variant<K: FileKind>(
    text: &str,
    file: &str,
    studies: &[Study],
    at: &StudyPoint,
) -> Result<StudyVariant, Vec<Diagnostic>> {
    let Some(study) = studies.iter().find(|s| s.name == at.study) else {
        return Err(vec![Diagnostic::whole_file(
            file,
            format!("There is no study named `{}`.", at.study),
            "Name one of the studies of the case.",
        )]);
    };
    let text = kind::put_study_value::<K>(text, &study.key, &at.value)?;
    Ok(StudyVariant {
        text,
        overrides: vec![format!("{}={}", study.key, at.value)],
    })
}

/// The rows of one run: those of the case without a study, and those of every point of a study that the run was computed at.
/// The others read NOT RUN. Rows whose published values are not for the inputs of the run read EDITED; a run at a point of
/// a study is no edited case.
#[must_use]
pub fn rows_of_run(run: &Run, case: &Case) -> Vec<ValidationRow> {
    let (points, edited): (Vec<EditedKey>, Vec<EditedKey>) = edited_inputs::<Case>(run)
        .into_iter()
        .partition(|key| is_point(key, case));
    rows_of_edited(case, &edited, &|at| {
        let computed = match at {
            None => points.is_empty(),
            Some(at) => {
                let study = case.study.iter().find(|s| s.name == at.study);
                let own = |key: &EditedKey| study.is_some_and(|s| s.key == key.path);
                points.iter().all(own) && stands_at(run, case, at)
            }
        };
        computed.then_some(run)
    })
}

/// Whether a key was set to a value of its study.
fn is_point(key: &EditedKey, case: &Case) -> bool {
    let own = case.study.iter().filter(|study| study.key == key.path);
    let mut values = own.flat_map(|study| &study.values);
    values.any(|value| key.has_value(&value.to_string()))
}

/// A run was computed at a point when setting the point does not change its case.
fn stands_at(run: &Run, case: &Case, at: &StudyPoint) -> bool {
    let set = variant::<Case>(&run.case_text, &case.case.title, &case.study, at).ok();
    let again = set.and_then(|v| case::parse_stored(&v.text, &run.info.case_file).ok());
    again.is_some_and(|again| again == *case)
}
