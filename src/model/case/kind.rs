//! Reading, listing and editing of a text of any kind: `kind::parse::<Ship>(text, file)`.

use std::path::{Path, PathBuf};

use super::check::variable;
use super::diagnostic::Diagnostic;
use super::edit::{field_by, put_all};
use super::edited::{self, EditedKey};
use super::fields::{Field, ValueType};
pub use super::file_kind::FileContent;
use super::file_kind::{FileKind, errors};
use super::read::diagnose;
pub use super::read_file::{
    ReadFile, read, read_again, read_beside, read_stored, read_toml, read_variant, read_with,
};
use super::replaced_value::Origin;
use super::rows::{FieldLister, FieldRow};
use super::schema::{TableNode, WrittenKeys};
use super::tree::TomlNode;
use super::{StudyValue, parameters, shipped};

/// A file with its text and its result.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedFile<T> {
    /// The text of the file.
    pub text: String,
    /// The same with the files that it names, so that it can be edited and read anywhere.
    pub whole_text: String,
    /// Its result.
    pub computed: T,
    /// The file.
    pub path: PathBuf,
}

/// Checks a text and computes it. `file` is the name in the diagnostics; files that the text names are looked for beside it.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines, or what shows only in the computation.
pub fn parse<K: FileKind>(text: &str, file: &str) -> Result<K::Computed, Vec<Diagnostic>> {
    read::<K>(text, file)?.compute()
}

/// The same of a text that stands in a folder, where files that it names are looked for; `file` is the name in the diagnostics.
///
/// # Errors
///
/// As [`parse`].
pub fn parse_beside<K: FileKind>(
    text: &str,
    file: &str,
    folder: &Path,
) -> Result<K::Computed, Vec<Diagnostic>> {
    read_beside::<K>(text, file, folder)?.compute()
}

/// Checks the text of a file of a stored run, which carries the files that it names, and computes it: none is looked for.
///
/// # Errors
///
/// As [`parse`].
pub fn parse_stored<K: FileKind>(text: &str, file: &str) -> Result<K::Computed, Vec<Diagnostic>> {
    read_stored::<K>(text, file)?.compute()
}

/// A text with the files that it names, so that it can be edited and read anywhere; `file` is where it stands.
///
/// # Errors
///
/// Everything that is wrong, at once.
pub fn whole_text<K: FileKind>(text: &str, file: &str) -> Result<String, Vec<Diagnostic>> {
    Ok(read::<K>(text, file)?.whole_text())
}

/// Checks content that no file gives as that of a file, and computes it.
///
/// # Errors
///
/// Everything that is wrong, at once.
pub fn compute<K: FileKind>(content: K) -> Result<K::Computed, Vec<Diagnostic>> {
    let root = TomlNode::of_table(&content.write(WrittenKeys::All));
    let found = errors::<K>(&root);
    let name = K::schema().what;
    if !found.is_empty() {
        return Err(diagnose(found, "", name));
    }
    let computed = content.compute(&K::keys(&TableNode::root(&root)));
    computed.map_err(|finding| vec![finding.at(name, "")])
}

/// The field of a key that studies and load cases beside the file may set, given in it or not: one number, or one of some words.
///
/// # Errors
/// What is wrong with it, and what would be right.
pub fn varied_field<K: FileKind>(
    text: &str,
    path: &str,
) -> Result<&'static Field, (String, String)> {
    let wrong = |fault: Diagnostic| {
        let problem = format!("`{}` cannot be varied: {}", fault.key, fault.problem);
        (problem, fault.remedy.to_string())
    };
    let field = field::<K>(text, path).map_err(wrong)?;
    variable(path, field)
}

/// Every key the file can have, given or not, with its value. A text that is not TOML gives no rows.
#[must_use]
pub fn rows<K: FileKind>(text: &str) -> Vec<FieldRow> {
    let Ok(mut root) = TomlNode::parse(text) else {
        return Vec::new();
    };
    // What cannot be evaluated is listed as it is written.
    let _faults = parameters::evaluate(K::schema(), &mut root);
    let lister = FieldLister::new(K::schema(), text, &root);
    let mut rows = lister.parameters();
    rows.extend(K::list(&lister));
    rows
}

/// The rows of a text that was edited, its own inputs marked as the user's, and their keys. `before` is the text that the file has; an
/// edited copy of a file that comes with the program is compared with that.
#[must_use]
pub fn edited_rows<K: FileKind>(text: &str, before: &str) -> (Vec<FieldRow>, Vec<EditedKey>) {
    let (before, origin) = match shipped::of_title(before) {
        Some(shipped) => (shipped, Origin::Shipped),
        None => (before, Origin::File),
    };
    let mut rows = rows::<K>(text);
    let other = (text != before).then(|| self::rows::<K>(before));
    let listed_before = other.as_ref().unwrap_or(&rows);
    let keys = edited::edited(&rows, listed_before, origin, edited::is_sourced(before));
    edited::mark(&mut rows, &keys);
    (rows, keys)
}

/// The field of a key path of a file.
///
/// # Errors
///
/// The file has no such key; the remedy names the one that was probably meant.
pub fn field<K: FileKind>(text: &str, key_path: &str) -> Result<&'static Field, Diagnostic> {
    field_by(K::schema(), text, key_path)
}

/// The text with one key set to a value as a user types it: a TOML value, or a bare word where the key takes words.
/// Nothing but the value changes; a key that the file leaves out is added to its table.
///
/// # Errors
///
/// The key is not known, the value is of the wrong type or out of range, or everything that is wrong in the file with it.
pub fn set<K: FileKind>(
    text: &str,
    key_path: &str,
    value: &str,
) -> Result<String, Vec<Diagnostic>> {
    set_all::<K>(text, &[(key_path, value)])
}

/// The text with one key set, as [`set`] does: key and value are checked, the file with it is not.
///
/// # Errors
///
/// The key is not known, or the value is of the wrong type or out of range.
pub fn put<K: FileKind>(
    text: &str,
    key_path: &str,
    value: &str,
) -> Result<String, Vec<Diagnostic>> {
    put_all(K::schema(), text, &[(key_path, value)]).map(|(edited, _)| edited)
}

/// The same with a value of a study, a number written as its field wants it.
///
/// # Errors
///
/// As [`put`].
pub fn put_study_value<K: FileKind>(
    text: &str,
    key_path: &str,
    value: &StudyValue,
) -> Result<String, Vec<Diagnostic>> {
    let whole = || field::<K>(text, key_path).is_ok_and(|field| field.kind == ValueType::Integer);
    let written = match value {
        StudyValue::Word(word) => word.clone(),
        StudyValue::Number(number) if number.fract() == 0.0 && whole() => format!("{number:.0}"),
        StudyValue::Number(number) => format!("{number:?}"),
    };
    put::<K>(text, key_path, &written)
}

/// The text with several keys set one after the other; the file is checked and computed once all are set.
///
/// # Errors
///
/// As [`set`].
pub fn set_all<K: FileKind>(text: &str, edits: &[(&str, &str)]) -> Result<String, Vec<Diagnostic>> {
    set_and_compute::<K>(text, edits).map(|(edited, _)| edited)
}

/// As [`set_all`], with the result of the edited text.
///
/// # Errors
///
/// As [`set`].
pub fn set_and_compute<K: FileKind>(
    text: &str,
    edits: &[(&str, &str)],
) -> Result<(String, K::Computed), Vec<Diagnostic>> {
    let read = read_with::<K>(text, edits, Path::new(""))?;
    let edited = read.text.clone();
    Ok((edited, read.compute()?))
}
