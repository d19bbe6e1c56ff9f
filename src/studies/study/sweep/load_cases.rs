//! The load cases of a file, those asked for beside it, and the file without them.

use toml_edit::DocumentMut;

use crate::case::file_kind::FileKind;
use crate::case::load_cases::{LoadCaseError, LoadCases, read_file};
use crate::case::{Attachment, LoadCaseInputs, ValueRange, kind};
use crate::files::shallow::shallow;
use std::collections::BTreeMap;

/// What a file of a kind says of load cases.
#[derive(Debug, Clone, Copy)]
pub struct SweepKind<'a> {
    /// The text of the file.
    pub text: &'a str,
    /// Its tables of load cases.
    pub tables: &'a [LoadCaseInputs],
    /// The files that it names.
    pub files: &'a BTreeMap<String, Attachment>,
}

/// All combinations of the tables of a file, of CSV files (each with its name and text) and of keys with their values (`KEY=VALUES`).
///
/// # Errors
/// What is wrong with one, or why they do not go together.
pub fn load_cases<K: FileKind>(
    of: SweepKind<'_>,
    csv: &[(String, String)],
    varied: &[String],
) -> Result<LoadCases, LoadCaseError> {
    let field = |path: &str| kind::varied_field::<K>(of.text, path);
    let mut parts = vec![LoadCases::of_tables(of.tables, of.files, &field)?];
    for (name, text) in csv {
        let read = read_file(text, name, &field);
        parts.push(read.map_err(|fault| LoadCaseError::Table(Box::new(fault)))?);
    }
    for word in varied {
        let (path, values) = word.split_once('=').ok_or_else(|| {
            let remedy = "write KEY=A..B/N or KEY=a,b,c, such as waves.height_m=2..8/4";
            LoadCaseError::Key(format!("`{word}` gives no values"), remedy.to_owned())
        })?;
        let wrong = |(problem, remedy)| LoadCaseError::Key(problem, remedy);
        let field = field(path.trim()).map_err(wrong)?;
        let wrong = |error| LoadCaseError::Values(path.to_owned(), format!("{error}"));
        let values = ValueRange::parse(values, field).map_err(wrong)?.values;
        parts.push(LoadCases::of_key(path.trim(), field, values, None));
    }
    LoadCases::combined(parts)
}

/// The text of a file without its load cases: what each of their runs is a run of.
#[must_use]
pub fn without_load_cases(text: &str) -> String {
    match shallow(text).parse::<DocumentMut>() {
        Ok(mut document) if document.contains_key("load_cases") => {
            document.remove("load_cases");
            document.to_string()
        }
        _ => text.to_owned(),
    }
}
