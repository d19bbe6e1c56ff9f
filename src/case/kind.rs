//! What all kinds of file beside the line case have in common: how they are recognised, read, checked, computed, and set
//! key by key. A kind provides its schema, its texts and its results.

use std::path::{Path, PathBuf};

use super::check::check_keys;
use super::diagnostic::Diagnostic;
use super::edit::put;
use super::fields::Schema;
use super::invalid_value::InvalidValue;
use super::model::Mark;
use super::read::{diagnose, said, text_of};
use super::rows::{FieldRow, Lister};
use super::schema::{Place, TableType};
use super::tree::Node;
use std::collections::BTreeMap;

/// A kind of file.
pub(crate) trait FileKind {
    /// Its words as plain data.
    type Words: TableType;
    /// What they come to.
    type Worked;

    /// Its tables and fields.
    fn schema() -> &'static Schema;

    /// Works the words out, which have passed the checks of the schema; or all that cannot be as they say.
    fn work(words: Self::Words, tree: &Node) -> Result<Self::Worked, Vec<InvalidValue>>;

    /// Where the words say that values come from, by key path.
    fn marks(_words: &Self::Words) -> BTreeMap<String, Mark> {
        BTreeMap::new()
    }

    /// Every key the file can have, given or not, in reading order.
    fn list(lister: &Lister<'_>) -> Vec<FieldRow>;
}

/// A file with its text and what it comes to.
#[derive(Debug, Clone, PartialEq)]
pub struct Opened<W> {
    /// The text of the file.
    pub text: String,
    /// What it comes to.
    pub worked: W,
    /// The file.
    pub path: PathBuf,
}

/// Whether a file has the table that every file of this kind begins with, and none of these others.
pub(crate) fn begins<K: FileKind>(path: &Path, others: &[&str]) -> bool {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let has = |table: &str| {
        let header = format!("[{table}]");
        text.lines()
            .any(|line| line.trim_start().starts_with(&header))
    };
    has(K::schema().what) && !others.iter().any(|other| has(other))
}

/// Reads, checks and works out a file.
pub(crate) fn load<K: FileKind>(path: &Path) -> Result<Opened<K::Worked>, Vec<Diagnostic>> {
    let text = text_of(path, K::schema()).map_err(|diagnostic| vec![diagnostic])?;
    let worked = parse::<K>(&text, &path.display().to_string())?;
    Ok(Opened {
        text,
        worked,
        path: path.to_owned(),
    })
}

/// Checks a text and works it out; all that is wrong at once, in the order of the lines. `file` is the name that the
/// diagnostics carry.
pub(crate) fn parse<K: FileKind>(text: &str, file: &str) -> Result<K::Worked, Vec<Diagnostic>> {
    let tree = said(text, file, K::schema())?;
    let mut found = check_keys(K::schema(), &tree);
    if found.is_empty() {
        let words = K::Words::from_keys(&K::Words::keys(&Place::root(&tree)))
            .map_err(|finding| diagnose(vec![finding], text, file))?;
        match K::work(words, &tree) {
            Ok(worked) => return Ok(worked),
            Err(wrong) => found = wrong.iter().map(|invalid| invalid.found(&tree)).collect(),
        }
    }
    found.sort_by_key(|finding| finding.span.start);
    Err(diagnose(found, text, file))
}

/// Every key of a text, with its value; a text that is not TOML gives none.
pub(crate) fn rows<K: FileKind>(text: &str) -> Vec<FieldRow> {
    let Ok(root) = Node::parse(text) else {
        return Vec::new();
    };
    let words = K::Words::from_keys(&K::Words::keys(&Place::root(&root)));
    let marks = words.map_or_else(|_| BTreeMap::new(), |words| K::marks(&words));
    K::list(&Lister {
        schema: K::schema(),
        text,
        root: &root,
        marks: &marks,
    })
}

/// The text with keys set one after the other, as a user types them; it is worked out once all are set.
pub(crate) fn set_all<K: FileKind>(
    text: &str,
    edits: &[(&str, &str)],
) -> Result<String, Vec<Diagnostic>> {
    let mut edited = text.to_owned();
    let mut faults = Vec::new();
    for (key, value) in edits {
        match put(K::schema(), &edited, key, value) {
            Ok(next) => edited = next,
            Err(fault) => faults.push(fault),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let shown: Vec<String> = edits.iter().map(|(k, v)| format!("{k} = {v}")).collect();
    parse::<K>(&edited, &shown.join(", ")).map(|_| edited)
}
