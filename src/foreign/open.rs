//! Opening of a file of any kind, of this program or of another: `open::load::<SystemFile>(path)`.

use std::path::Path;

use crate::case::file_kind::FileKind;
use crate::case::kind::{LoadedFile, loaded};
use crate::case::{Diagnostic, text_of};
use crate::import::{self, ImportOptions};

/// Reads, checks and computes a file.
///
/// # Errors
///
/// Everything that is wrong, at once: a missing file, a directory, a binary or empty file, TOML syntax, every invalid key
/// and value, or what shows only in the computation.
pub fn load<K: FileKind>(path: &Path) -> Result<LoadedFile<K::Computed>, Vec<Diagnostic>> {
    load_as::<K>(path, &ImportOptions::default())
}

/// The same; what is said about a file of another program besides its text is in the options.
///
/// # Errors
///
/// Everything that is wrong, at once; of a file of another program each at its row.
pub fn load_as<K: FileKind>(
    path: &Path,
    options: &ImportOptions,
) -> Result<LoadedFile<K::Computed>, Vec<Diagnostic>> {
    let text = text_of(path, K::schema()).map_err(|diagnostic| vec![diagnostic])?;
    if !import::is_foreign_file(path, &text) {
        return loaded::<K>(text, path);
    }
    let file = path.display().to_string();
    let imported = import::read(&text, &file, options)?;
    loaded::<K>(imported.text.clone(), path).map_err(|found| {
        let at_its_row = |one: &Diagnostic| imported.at_its_row(one, &file, &text);
        found.iter().map(at_its_row).collect()
    })
}
