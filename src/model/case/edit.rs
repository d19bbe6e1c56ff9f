//! Edits of a case's text, checked as a whole.

use super::StudyValue;
use super::diagnostic::{Diagnostic, Finding};
use super::fields::{Field, ValueType, split};
use super::file_kind::errors;
use super::model::{CASE, Case, field_at};
use seacable_keys::read::evaluated_tree;

pub use seacable_keys::edit::*;

/// The text of the case with one key set to a value, given as a user types it: a TOML value, or a
/// bare word where the field takes words.
///
/// A key that the file leaves out is added to its table; a table that the file leaves out is added
/// at the end of the file.
///
/// # Errors
///
/// The key is not known, the value is of the wrong type or out of range (the remedy names the
/// range), or the case with it would contradict itself in a way it did not before. The diagnostic
/// carries the edit, `key = value`, in place of a file.
pub fn set(text: &str, key_path: &str, value: &str) -> Result<String, Diagnostic> {
    set_all(text, &[(key_path, value)]).map_err(|faults| {
        let first = faults.into_iter().next();
        first.unwrap_or_else(|| {
            refusal(
                key_path,
                value,
                "is refused".to_owned(),
                "give another value".to_owned(),
            )
        })
    })
}

/// The text of the case with several keys set one after the other; whether they agree with each
/// other is asked once all are set.
///
/// # Errors
///
/// As [`set`]; all faults at once.
pub fn set_all(text: &str, edits: &[(&str, &str)]) -> Result<String, Vec<Diagnostic>> {
    let (edited, shown) = put_all(&CASE, text, edits)?;
    let faults = new_faults(text, &edited, &shown);
    if faults.is_empty() {
        Ok(edited)
    } else {
        Err(faults)
    }
}

/// The text of the case with one key set to a number, written as its field wants it.
///
/// # Errors
///
/// As [`set`].
pub fn set_number(text: &str, key_path: &str, value: f64) -> Result<String, Diagnostic> {
    let whole = split(key_path)
        .and_then(|parts| field_at(&parts))
        .is_some_and(|field| field.kind == ValueType::Integer);
    let shown = if whole && value.fract() == 0.0 {
        format!("{value:.0}")
    } else {
        format!("{value:?}")
    };
    set(text, key_path, &shown)
}

/// Sets one key to a value of a study, as [`set_number`] does or as a word.
///
/// # Errors
///
/// As [`set`].
pub fn set_value(text: &str, key_path: &str, value: &StudyValue) -> Result<String, Diagnostic> {
    match value {
        StudyValue::Number(number) => set_number(text, key_path, *number),
        StudyValue::Word(word) => set(text, key_path, word),
    }
}

/// The text of the case with one optional key left out, so that its default holds again. A comment behind its value stays,
/// on a line of its own.
///
/// # Errors
///
/// The key is needed, or the case without it would contradict itself in a way it did not before.
pub fn unset(text: &str, key_path: &str) -> Result<String, Diagnostic> {
    let edited = without(&CASE, text, key_path)?;
    let fresh = new_faults(text, &edited, &format!("without {key_path}"));
    fresh.into_iter().next().map_or(Ok(edited), Err)
}

/// The field of a key path of a case.
///
/// # Errors
///
/// The case has no such key; the remedy names the one that was probably meant.
pub fn field(text: &str, key_path: &str) -> Result<&'static Field, Diagnostic> {
    field_by(&CASE, text, key_path)
}

/// Faults of the edited case that the case did not have before.
fn new_faults(before: &str, after: &str, edit: &str) -> Vec<Diagnostic> {
    let of = |text: &str| {
        evaluated_tree(&CASE, text).map_or_else(|found| found, |tree| errors::<Case>(&tree))
    };
    let (old, new) = (of(before), of(after));
    let known = |fault: &Finding| {
        old.iter()
            .any(|one| one.key == fault.key && one.problem == fault.problem)
    };
    let fresh = new.into_iter().filter(|fault| !known(fault));
    fresh.map(|fault| fault.at(edit, after)).collect()
}
