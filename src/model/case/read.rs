//! From a file to a checked case.

use crate::visible;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::attachments::{gather, share};
use super::check::check_keys;
use super::diagnostic::{Diagnostic, Finding};
use super::fields::Schema;
use super::file_kind::{FileKind, errors};
use super::model::{Attachment, CASE, Case};
use super::schema::{TableNode, TableType};
use super::tree::TomlNode;
use super::{parameters, size, warm_start};
use crate::files::root;
use crate::kinds::{FileBytes, FileType};
pub use seacable_keys::read::{diagnose, tree_of};

/// A case with the text and the file it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedCase {
    /// The text of the file.
    pub text: String,
    /// The case, checked.
    pub case: Case,
    /// The file.
    pub path: PathBuf,
}

/// Reads and checks a case file.
///
/// # Errors
///
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary
/// or empty, faults of the TOML syntax, or every fault of keys and values.
pub fn load(path: &Path) -> Result<LoadedCase, Vec<Diagnostic>> {
    load_from(FileBytes::read(path))
}

/// The same of a file that was read from disk.
///
/// # Errors
///
/// As [`load`].
pub fn load_from(file: FileBytes) -> Result<LoadedCase, Vec<Diagnostic>> {
    let path = file.path().to_owned();
    let text = text_of_line(file)?;
    let case = parse_of(&text, &path)?;
    Ok(LoadedCase { text, case, path })
}

/// The text of a case file, not checked.
///
/// # Errors
///
/// There is no such file, it is a directory, or binary.
pub fn text_of_line(file: FileBytes) -> Result<String, Vec<Diagnostic>> {
    file.text(&CASE).map_err(|diagnostic| vec![diagnostic])
}

/// Checks a text as that of a case file.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse_of(text: &str, path: &Path) -> Result<Case, Vec<Diagnostic>> {
    let folder = path.parent().unwrap_or(Path::new(""));
    parse_beside(text, &visible::path(path), folder)
}

/// Checks the text of a case. `file` is the name the diagnostics carry; the files it names are looked for beside it.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Case, Vec<Diagnostic>> {
    let folder = Path::new(file).parent().unwrap_or(Path::new(""));
    parse_beside(text, file, folder)
}

/// Checks the text of a case that stands in a folder: where the files it names are looked for. `file` is the name the
/// diagnostics carry.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse_beside(text: &str, file: &str, folder: &Path) -> Result<Case, Vec<Diagnostic>> {
    parse_sharing(text, (file, folder), &BTreeMap::new())
}

/// As [`parse_beside`], of a text whose file was read before: files that it named then and that have not changed keep what was parsed of
/// them.
///
/// # Errors
///
/// As [`parse`].
pub fn parse_sharing(
    text: &str,
    (file, folder): (&str, &Path),
    known: &BTreeMap<String, Attachment>,
) -> Result<Case, Vec<Diagnostic>> {
    let (tree, mut case) = checked::<Case>(text, file)?;
    share(&mut case, known);
    gather(&mut case, &tree, text, (file, folder), known)
        .and_then(|()| warm_start::gather(&mut case, &tree, text, (file, folder)))
        .map_err(|diagnostic| vec![diagnostic])?;
    Ok(case)
}

/// Checks the text of the case of a stored run, which carries the files that it names: none is looked for.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse_stored(text: &str, file: &str) -> Result<Case, Vec<Diagnostic>> {
    parse_beside(text, file, Path::new(root::NOWHERE))
}

/// Reads the text of a case key by key, without checking values against each other and without the files that it names: for
/// tests of what computes.
///
/// # Errors
///
/// Faults of the TOML syntax, or every fault of a key.
pub fn parse_keys(text: &str) -> Result<Case, Vec<Diagnostic>> {
    let tree = said(text, "case", &CASE)?;
    let found = check_keys(&CASE, &tree);
    if !found.is_empty() {
        return Err(diagnose(found, text, "case"));
    }
    let case = Case::from_keys(&Case::keys(&TableNode::root(&tree)));
    case.map_err(|finding| diagnose(vec![finding], text, "case"))
}

/// The tree of a text, and what it says, without errors of its keys.
pub(crate) fn checked<K: FileKind>(
    text: &str,
    file: &str,
) -> Result<(TomlNode, K), Vec<Diagnostic>> {
    let tree = said(text, file, K::schema())?;
    let found = errors::<K>(&tree);
    if !found.is_empty() {
        return Err(diagnose(found, text, file));
    }
    let content = K::from_keys(&K::keys(&TableNode::root(&tree)));
    let content = content.map_err(|finding| diagnose(vec![finding], text, file))?;
    Ok((tree, content))
}

/// The tree of a text that says something, in TOML.
fn said(text: &str, file: &str, schema: &'static Schema) -> Result<TomlNode, Vec<Diagnostic>> {
    if let Some(diagnostic) = nothing_said(text, file, schema) {
        return Err(vec![diagnostic]);
    }
    let mut tree = tree_of(text).map_err(|found| diagnose(found, text, file))?;
    if let Some(found) = size::check(&tree).or_else(|| other_kind(&tree, schema)) {
        return Err(diagnose(vec![found], text, file));
    }
    match parameters::evaluate(schema, &mut tree) {
        found if found.is_empty() => Ok(tree),
        found => Err(diagnose(found, text, file)),
    }
}

/// A file of another kind, told by the table that every file of its kind begins with.
fn other_kind(tree: &TomlNode, schema: &Schema) -> Option<Finding> {
    let has = |kind: &FileType| tree.get(kind.table()).is_some();
    if tree.get(schema.what).is_some() {
        return None;
    }
    let other = FileType::ALL.into_iter().find(has)?;
    let wanted = FileType::ALL
        .into_iter()
        .find(|kind| kind.table() == schema.what)?;
    let (found, remedy) = other.description();
    let span = &tree.get(other.table())?.span;
    let problem = format!("this is {found}, not {}", wanted.description().0);
    Some(Finding::new(span, other.table(), problem, remedy))
}

fn nothing_said(text: &str, file: &str, schema: &Schema) -> Option<Diagnostic> {
    let comment = |line: &str| line.trim().is_empty() || line.trim_start().starts_with('#');
    text.trim_start_matches('\u{feff}')
        .lines()
        .all(comment)
        .then(|| {
            Diagnostic::whole_file(
                file,
                format!("the file is empty: it holds no {}", schema.what),
                schema.least,
            )
        })
}
