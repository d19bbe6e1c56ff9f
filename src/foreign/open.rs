//! Opening of a file of any kind, of this program or of another: `open::load::<SystemFile>(path)`.

use std::path::{Path, PathBuf};

use crate::case::Diagnostic;
use crate::case::file_kind::FileKind;
use crate::case::kind::{self, LoadedFile, ReadFile};
use crate::import::{self, ImportOptions, Imported, line_case};
use crate::kinds::FileBytes;
use crate::system::SystemFile;
use crate::visible;

/// A file with the text that is read of it.
#[derive(Debug, Clone)]
pub struct OpenedFile {
    /// Where it is.
    pub path: PathBuf,
    /// Its text; of a file of another program that of its case.
    pub text: String,
    foreign: Option<ForeignSource>,
}

/// A file of another program, or of a line, and how its case comes from it.
#[derive(Debug, Clone)]
struct ForeignSource {
    file: String,
    text: String,
    imported: Imported,
}

impl OpenedFile {
    /// Opens a file: a case of a line too, as its system, where that is what is opened; what is said about a file of another program besides its text is in the options.
    ///
    /// # Errors
    ///
    /// A missing file, a directory, a binary file; everything that is wrong with a file of another program, each at its row.
    pub fn of_bytes<K: FileKind>(
        bytes: FileBytes,
        options: &ImportOptions,
    ) -> Result<Self, Vec<Diagnostic>> {
        let path = bytes.path().to_owned();
        let text = bytes
            .text(K::schema())
            .map_err(|diagnostic| vec![diagnostic])?;
        let file = path.display().to_string();
        let imported = if import::is_foreign_file(&path, &text) {
            import::read(&text, &file, options)?
        } else if is_system::<K>() && line_case::is_line_case(&text) {
            without_options(&file, options)?;
            line_case::read(&text, &path)?
        } else {
            return Ok(Self {
                path,
                text,
                foreign: None,
            });
        };
        Ok(Self {
            path,
            text: imported.text.clone(),
            foreign: Some(ForeignSource {
                file,
                text,
                imported,
            }),
        })
    }

    /// Whether it is of another program.
    #[must_use]
    pub const fn is_foreign(&self) -> bool {
        self.foreign.is_some()
    }

    /// Reads and checks it.
    ///
    /// # Errors
    ///
    /// Everything that is wrong, at once; of a file of another program each at its row.
    pub fn read<K: FileKind>(&self) -> Result<ReadFile<K>, Vec<Diagnostic>> {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        kind::read_beside::<K>(&self.text, &visible::path(&self.path), folder)
            .map_err(|found| self.at_its_rows(found))
    }

    /// Reads, checks and computes it.
    ///
    /// # Errors
    ///
    /// Everything that is wrong, at once, or what shows only in the computation.
    pub fn compute<K: FileKind>(&self) -> Result<K::Computed, Vec<Diagnostic>> {
        let computed = self.read::<K>()?.compute();
        computed.map_err(|found| self.at_its_rows(found))
    }

    /// Diagnostics of its text; of a file of another program each at the row that it comes from.
    #[must_use]
    pub fn at_its_rows(&self, found: Vec<Diagnostic>) -> Vec<Diagnostic> {
        let Some(ForeignSource {
            file,
            text,
            imported,
        }) = &self.foreign
        else {
            return found;
        };
        let at_its_row = |one: &Diagnostic| imported.at_its_row(one, file, text);
        found.iter().map(at_its_row).collect()
    }
}

/// Refuses what is said besides a case of a line, which leaves nothing open.
fn without_options(file: &str, options: &ImportOptions) -> Result<(), Vec<Diagnostic>> {
    if options.is_empty() {
        return Ok(());
    }
    let problem = "is a case of a line, which says all that files of other programs leave open";
    let remedy = "leave --without, --depth, --density, --gravity and --motion out; set its keys";
    Err(vec![Diagnostic::whole_file(file, problem, remedy)])
}

/// Whether a kind of file is the system.
fn is_system<K: FileKind>() -> bool {
    std::ptr::eq(K::schema(), SystemFile::schema())
}

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
    load_from::<K>(FileBytes::read(path), options)
}

/// The same of a file that was read from disk.
///
/// # Errors
///
/// As [`load_as`].
pub fn load_from<K: FileKind>(
    bytes: FileBytes,
    options: &ImportOptions,
) -> Result<LoadedFile<K::Computed>, Vec<Diagnostic>> {
    let opened = OpenedFile::of_bytes::<K>(bytes, options)?;
    let read = opened.read::<K>()?;
    let whole_text = read.whole_text();
    let computed = read.compute().map_err(|found| opened.at_its_rows(found))?;
    Ok(LoadedFile {
        text: opened.text,
        whole_text,
        computed,
        path: opened.path,
    })
}
