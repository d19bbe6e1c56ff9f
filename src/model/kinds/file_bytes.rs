//! A file as it was read from disk, before its kind is known: it is read once, whoever asks for it then.

use std::borrow::Cow;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use super::FileType;
use super::foreign::is_foreign_file;
use crate::files::read;
use crate::visible;
use seacable_keys::fields::Schema;
use seacable_keys::{Diagnostic, Finding};

/// The bytes of a file, or why it cannot be read, which its reader says in the words of its kind.
#[derive(Debug)]
pub struct FileBytes {
    path: PathBuf,
    bytes: io::Result<Vec<u8>>,
}

impl FileBytes {
    /// Reads a file.
    #[must_use]
    pub fn read(path: &Path) -> Self {
        Self {
            path: path.to_owned(),
            bytes: read::bytes(path),
        }
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Its kind: that of a line case where it cannot be read.
    #[must_use]
    pub fn kind(&self) -> FileType {
        FileType::of_file(&self.path, &self.lossy())
    }

    /// The same where it can be read.
    ///
    /// # Errors
    /// It cannot.
    pub fn readable(self) -> io::Result<Self> {
        let (path, bytes) = (self.path, Ok(self.bytes?));
        Ok(Self { path, bytes })
    }

    /// Whether it is of another program.
    #[must_use]
    pub fn is_foreign(&self) -> bool {
        self.bytes.is_ok() && is_foreign_file(&self.path, &self.lossy())
    }

    fn lossy(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(self.bytes.as_deref().unwrap_or_default())
    }

    /// Its text.
    ///
    /// # Errors
    /// It cannot be read, or is not UTF-8.
    pub fn utf8(self) -> io::Result<String> {
        read::utf8(self.bytes?)
    }

    /// Its text, as a file of a kind.
    ///
    /// # Errors
    /// It is a directory, cannot be read or is no text.
    pub fn text(self, schema: &Schema) -> Result<String, Diagnostic> {
        let file = visible::path(&self.path);
        if self.path.is_dir() {
            let what = schema.what;
            let remedy = format!(
                "name a {what} file in it; `seacable DIR` opens the workbench on all its cases"
            );
            return Err(Diagnostic::whole_file(
                &file,
                format!("is a directory, not a {what} file"),
                remedy,
            ));
        }
        let bytes = self.bytes.map_err(|error| unreadable(&file, &error))?;
        String::from_utf8(bytes).or_else(|error| {
            // Files of other programs are read in any encoding: only their remarks are not ASCII.
            let text = String::from_utf8_lossy(error.as_bytes());
            match is_foreign_file(&self.path, &text) {
                true => Ok(text.into_owned()),
                false => Err(binary(&file, &error, schema)),
            }
        })
    }
}

fn unreadable(file: &str, error: &io::Error) -> Diagnostic {
    match error.kind() {
        ErrorKind::NotFound => Diagnostic::whole_file(
            file,
            "there is no such file",
            "check the name and the directory",
        ),
        ErrorKind::PermissionDenied => Diagnostic::whole_file(
            file,
            "the file may not be read",
            "give yourself permission to read it",
        ),
        _ => Diagnostic::whole_file(
            file,
            format!("the file cannot be read: {error}"),
            "check the file and its disk",
        ),
    }
}

/// A file that is not UTF-8, with the place of the first byte that is not.
fn binary(file: &str, error: &std::string::FromUtf8Error, schema: &Schema) -> Diagnostic {
    let good = error.utf8_error().valid_up_to();
    let before = String::from_utf8_lossy(&error.as_bytes()[..good]);
    let problem = format!(
        "this is not text: byte {} of the file is not UTF-8",
        good + 1
    );
    let remedy = format!("a {} is a text file in TOML, saved as UTF-8", schema.what);
    let finding = Finding::new(&(good..good), "", problem, remedy);
    finding.at(file, &before)
}
