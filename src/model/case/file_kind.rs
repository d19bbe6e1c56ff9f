//! What all kinds of file have in common: how they are checked, computed and listed. A kind is the type of its root table.

use std::collections::BTreeMap;

use super::attachments::FileSource;
use super::check::{check_keys, marks};
use super::diagnostic::{Diagnostic, Finding};
use super::fields::Schema;
use super::model::Attachment;
use super::rows::{FieldLister, FieldRow};
use super::schema::{TableNode, TableType};
use super::tree::TomlNode;

/// The root table of a kind of file.
pub trait FileContent {
    /// The result of a file: a design, a solved ropeway.
    type Computed;
}

/// A kind of file.
pub trait FileKind: FileContent + TableType {
    /// Its tables and fields.
    fn schema() -> &'static Schema;

    /// Errors of keys against each other. Keys that are missing or faulty are passed over.
    fn check(keys: &Self::Keys<'_>) -> Vec<Finding>;

    /// Takes in the files that it names and does not carry.
    ///
    /// # Errors
    /// A file that cannot be read, or does not hold what it is named for.
    fn take_files(&mut self, _source: &FileSource<'_>) -> Result<(), Diagnostic> {
        Ok(())
    }

    /// The files that it carries.
    fn files(&self) -> Option<&BTreeMap<String, Attachment>> {
        None
    }

    /// The same, to share what was parsed of them.
    fn files_mut(&mut self) -> Option<&mut BTreeMap<String, Attachment>> {
        None
    }

    /// The result of a file without errors; `keys` are those that it was read from.
    ///
    /// # Errors
    /// What shows only in the computation.
    fn compute(self, keys: &Self::Keys<'_>) -> Result<Self::Computed, Finding>;

    /// Every key the file can have, given or not, in reading order.
    fn list(lister: &FieldLister<'_>) -> Vec<FieldRow>;
}

/// Everything wrong with a file, in the order of its lines: each key against its declaration, and keys against each other.
pub(crate) fn errors<K: FileKind>(root: &TomlNode) -> Vec<Finding> {
    let mut found = check_keys(K::schema(), root);
    found.extend(marks(K::schema(), root));
    found.extend(K::check(&K::keys(&TableNode::root(root))));
    found.sort_by_key(|finding| finding.span.start);
    found
}
