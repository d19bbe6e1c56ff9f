//! A file that was read and checked, before anything is computed of it.

use std::collections::BTreeMap;
use std::path::Path;

use super::attachments::{FileSource, share, with_files};
use super::diagnostic::Diagnostic;
use super::edit::put_all;
use super::file_kind::FileKind;
use super::model::Attachment;
use super::read::checked;
use super::schema::TableNode;
use super::tree::TomlNode;
use crate::files::root;
use crate::kinds::FileBytes;
use crate::visible;
use crate::work_log::{self, Task};

/// A file that was read and checked: what it says, with the files that it names. Its answer is computed where it is asked for.
#[derive(Debug, Clone)]
pub struct ReadFile<K> {
    /// Its text.
    pub text: String,
    /// What it says.
    pub content: K,
    /// Its name in diagnostics.
    file: String,
    /// Where its keys are, for what shows only in the computation.
    root: TomlNode,
}

impl<K: FileKind> ReadFile<K> {
    /// Its text with the files that it names, so that it can be edited and read anywhere.
    #[must_use]
    pub fn whole_text(&self) -> String {
        let files = self.content.files();
        files.map_or_else(
            || self.text.clone(),
            |files| with_files(&self.text, files).into_owned(),
        )
    }

    /// Its answer.
    ///
    /// # Errors
    /// What shows only in the computation.
    pub fn compute(self) -> Result<K::Computed, Vec<Diagnostic>> {
        work_log::log(Task::Solve, &self.file);
        let Self {
            text,
            content,
            file,
            root,
        } = self;
        content
            .compute(&K::keys(&TableNode::root(&root)))
            .map_err(|finding| vec![finding.at(&file, &text)])
    }
}

/// Reads and checks a text. `file` is the name in the diagnostics; files that the text names are looked for beside it.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn read<K: FileKind>(text: &str, file: &str) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    read_beside(text, file, folder_of(Path::new(file)))
}

/// The same of a text whose file was read before: files that it named then and that have not changed keep what was parsed of them.
///
/// # Errors
///
/// As [`read`].
pub fn read_again<K: FileKind>(
    text: &str,
    file: &str,
    known: &BTreeMap<String, Attachment>,
) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    read_sharing(text, (file, file), folder_of(Path::new(file)), known)
}

/// The same of a text that stands in a folder, where files that it names are looked for; `file` is the name in the diagnostics.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn read_beside<K: FileKind>(
    text: &str,
    file: &str,
    folder: &Path,
) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    read_sharing(text, (file, file), folder, &BTreeMap::new())
}

/// Reads and checks a text: what it is called in diagnostics, and the file that it is of; what was parsed of known files of the same
/// text is shared.
fn read_sharing<K: FileKind>(
    text: &str,
    (file, of): (&str, &str),
    folder: &Path,
    known: &BTreeMap<String, Attachment>,
) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    let (root, mut content) = checked::<K>(text, file)?;
    share(&mut content, known);
    let source = FileSource {
        root: &root,
        text,
        file,
        of,
        folder,
        known,
    };
    content
        .take_files(&source)
        .map_err(|diagnostic| vec![source.quoting_none_outside(diagnostic)])?;
    Ok(ReadFile {
        text: text.to_owned(),
        content,
        file: file.to_owned(),
        root,
    })
}

/// Reads and checks the text of a file of a stored run, which carries the files that it names: none is looked for.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn read_stored<K: FileKind>(text: &str, file: &str) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    read_beside(text, file, Path::new(root::NOWHERE))
}

/// Reads and checks the text of a file in TOML.
///
/// # Errors
///
/// Everything that is wrong, at once: a missing file, a directory, a binary or empty file, TOML syntax, every invalid key and value.
pub fn read_toml<K: FileKind>(path: &Path) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    let text = FileBytes::read(path).text(K::schema());
    let text = text.map_err(|diagnostic| vec![diagnostic])?;
    read_beside(&text, &visible::path(path), folder_of(path))
}

/// Reads and checks the text of a file with several keys set, one after the other; the diagnostics name the edits in the place of the file.
///
/// # Errors
///
/// A key that is not known, a value of the wrong type or out of range, or everything that is wrong in the file with them.
pub fn read_with<K: FileKind>(
    text: &str,
    edits: &[(&str, &str)],
    path: &Path,
) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    let (edited, shown) = put_all(K::schema(), text, edits)?;
    let named = (&*shown, &*visible::path(path));
    read_sharing(&edited, named, folder_of(path), &BTreeMap::new())
}

/// The same of a text that carries its files, which were parsed before as far as they are known.
///
/// # Errors
///
/// As [`read_with`].
pub fn read_variant<K: FileKind>(
    text: &str,
    edits: &[(&str, &str)],
    known: &BTreeMap<String, Attachment>,
) -> Result<ReadFile<K>, Vec<Diagnostic>> {
    let (edited, shown) = put_all(K::schema(), text, edits)?;
    read_sharing(&edited, (&shown, ""), Path::new(""), known)
}

fn folder_of(file: &Path) -> &Path {
    file.parent().unwrap_or(Path::new(""))
}
