//! The core as the screen needs it: one thin layer over case, reference and report.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use crate::case::fields::Schema;
use crate::case::structure::{self, StructureEdit};
use crate::case::{self, Attachment, Case, EditedKey, StudyPoint, kind};
use crate::kinds::FileType;
use crate::reference;
use crate::ropeway::{ROPEWAY, Ropeway};
use crate::run::Run;
use crate::section::{CrossSection, SECTION};
use crate::ship::{SHIP, Ship};
use crate::system::{SYSTEM, SystemFile};

pub use crate::case::FieldRow;
pub use crate::reference::ValidationRow;

/// The tables and keys of a kind of file.
#[must_use]
pub fn schema(kind: FileType) -> &'static Schema {
    match kind {
        FileType::Line => &case::CASE,
        FileType::Section => &SECTION,
        FileType::Ropeway => &ROPEWAY,
        FileType::Ship => &SHIP,
        FileType::System => &SYSTEM,
    }
}

/// The text of a file with an edit of its structure; the file with it is not checked.
///
/// # Errors
/// Why the edit cannot be made.
pub fn restructure(kind: FileType, text: &str, edit: &StructureEdit) -> Result<String, String> {
    structure::apply(schema(kind), text, edit)
}

/// Reads a text as a case.
///
/// # Errors
/// The first thing wrong, as one line with file, line and column.
pub fn parse(text: &str, file: &str) -> Result<Case, String> {
    case::parse_stored(text, file).map_err(|all| first(&all, file))
}

/// Reads a text as the case of a file, which may name others beside it; those that are known and have not changed are not parsed again.
///
/// # Errors
/// All that is wrong.
pub fn parse_at(
    text: &str,
    (path, file): (&Path, &str),
    known: &BTreeMap<String, Attachment>,
) -> Result<Case, Vec<case::Diagnostic>> {
    let folder = path.parent().unwrap_or(Path::new(""));
    case::parse_sharing(text, (file, folder), known)
}

/// Sets a key of the text.
///
/// # Errors
/// What is wrong with the value and what would be right.
pub fn set(text: &str, key: &str, value: &str) -> Result<String, String> {
    let last = key.rsplit('.').next().unwrap_or(key);
    case::edit::set(text, key, value).map_err(|d| format!("{last} {}", sentences(&d)))
}

/// Sets a key of the text of a file; key and value are checked, the file with them is not.
///
/// # Errors
/// What is wrong with the value and what would be right.
pub fn put(kind: FileType, text: &str, key: &str, value: &str) -> Result<String, String> {
    let put = match kind {
        FileType::Line => kind::put::<Case>(text, key, value),
        FileType::Section => kind::put::<CrossSection>(text, key, value),
        FileType::Ropeway => kind::put::<Ropeway>(text, key, value),
        FileType::Ship => kind::put::<Ship>(text, key, value),
        FileType::System => kind::put::<SystemFile>(text, key, value),
    };
    let last = key.rsplit('.').next().unwrap_or(key);
    put.map_err(|all| match (kind, all.first()) {
        (FileType::Line, Some(first)) => format!("{last} {}", sentences(first)),
        _ => refusal(key, &all),
    })
}

/// Leaves an optional key out of the text.
///
/// # Errors
/// Why it cannot be left out.
pub fn unset(text: &str, key: &str) -> Result<String, String> {
    case::edit::unset(text, key).map_err(|d| format!("{} {}", d.key, sentences(&d)))
}

/// The first thing wrong with a text, as one line with file, line and column.
#[must_use]
pub fn first(all: &[case::Diagnostic], file: &str) -> String {
    all.first().map_or_else(
        || format!("{file} is not what it was."),
        ToString::to_string,
    )
}

/// What is wrong with a file at a key, and what would be right.
#[must_use]
pub fn missing(fault: &case::Diagnostic) -> String {
    match fault.key.is_empty() {
        true => sentences(fault),
        false => format!("{}: {}", fault.key, sentences(fault)),
    }
}

/// All that is wrong with a value, each at the key that says so.
#[must_use]
pub fn refusal(key: &str, all: &[case::Diagnostic]) -> String {
    let words = all.iter().map(|d| {
        let at = if d.key == key {
            key.rsplit('.').next().unwrap_or(key)
        } else {
            &d.key
        };
        format!("{at}: {}", sentences(d))
    });
    words.collect::<Vec<_>>().join(" ")
}

/// What is wrong, and what would be right.
fn sentences(d: &case::Diagnostic) -> String {
    let stopped = |text: &str| text.trim().trim_end_matches('.').to_owned();
    let remedy = stopped(&d.remedy);
    let mut letters = remedy.chars();
    let capital: String = letters
        .next()
        .into_iter()
        .flat_map(char::to_uppercase)
        .collect();
    format!("{}. {capital}{}.", stopped(&d.problem), letters.as_str())
}

/// A point of a study in words: `current speed 0.2 m/s`.
#[must_use]
pub fn at_label(case: &Case, at: &StudyPoint) -> String {
    let study = case.study.iter().find(|s| s.name == at.study);
    let key = study.map_or(at.study.as_str(), |s| s.key.as_str());
    setting_label(key, &at.value.to_string())
}

/// A key at a value in words: `current speed 0.2 m/s`.
#[must_use]
pub fn setting_label(key: &str, value: &str) -> String {
    let path: Vec<&str> = key.split('.').collect();
    let words = case::field_at(&path).map(|field| field.in_words(key));
    match words {
        Some((label, "" | "-")) => format!("{label} {value}"),
        Some((label, unit)) => format!("{label} {value} {unit}"),
        None => format!("{key} {value}"),
    }
}

/// Text and case at a point of a study; `None` is the edited case.
///
/// # Errors
/// Why the point cannot be made.
pub fn variant(
    text: &str,
    case: &Case,
    at: Option<&StudyPoint>,
    file: &str,
) -> Result<(String, Case), String> {
    let Some(at) = at else {
        return Ok((text.to_owned(), case.clone()));
    };
    let study = case
        .study
        .iter()
        .find(|s| s.name == at.study)
        .ok_or_else(|| format!("{file} has no study named `{}`.", at.study))?;
    // With the files that it names: the name alone does not say where they are.
    let whole = case::stand_alone(text, case);
    let text = case::edit::set_value(&whole, &study.key, &at.value).map_err(|d| d.to_string())?;
    let case = parse(&text, file)?;
    Ok((text, case))
}

/// Compares runs of a case, which may have edited inputs, with the published values.
#[must_use]
pub fn checks(
    case: &Case,
    edited: &[EditedKey],
    runs: &[(Option<StudyPoint>, Arc<Run>)],
) -> Vec<ValidationRow> {
    reference::rows_of_edited(case, edited, &|at| {
        runs.iter()
            .find(|(have, _)| have.as_ref() == at)
            .map(|(_, run)| run.as_ref())
    })
}
