//! Writes files whole or not at all: never onto an input, never through a symbolic link, and onto an existing file only
//! where the caller allows it.
//!
//! The contents go to a temporary file in the same directory, created exclusively, are synced, and take their name by a
//! rename. On failure the temporary file is removed and an existing file keeps its contents.
//!
//! Files are read by [`read`] only, and made, renamed and removed by `disk` only; [`root`] says where files lie that cases name, [`walk`]
//! lists those below a directory.

pub mod disk;
pub(crate) mod faults;
pub mod lock;
pub mod read;
pub mod root;
pub mod shallow;
pub mod strays;
pub mod unsaved;
pub mod walk;

use crate::visible;
use std::fs::{self, Metadata, Permissions};
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use self::disk::TemporaryFile;
use self::strays::Hidden;

/// What may happen to a file that exists at the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existing<'a> {
    /// It is kept, and writing fails.
    Keep,
    /// It is replaced.
    Replace,
    /// It is replaced if it still holds this text.
    ReplaceIfUnchanged(&'a str),
}

/// Why a file was not written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The target is a file that the same command reads.
    #[error("{} is an input of this command and is not overwritten; name another file", visible::path(.0))]
    IsInput(PathBuf),
    /// The target is a file of a stored run.
    #[error("{} belongs to the run in its directory and is not overwritten; name another file", visible::path(.0))]
    OfRun(PathBuf),
    /// The target is a symbolic link.
    #[error("{} is a symbolic link; name the file itself", visible::path(.0))]
    IsLink(PathBuf),
    /// The target is a directory, a device or a pipe.
    #[error("{} is not a regular file", visible::path(.0))]
    NotRegular(PathBuf),
    /// The target exists and is not to be replaced.
    #[error("{} exists", visible::path(.0))]
    Exists(PathBuf),
    /// The target has no write permission.
    #[error("{} is read-only", visible::path(.0))]
    ReadOnly(PathBuf),
    /// The target no longer holds what the caller read from it.
    #[error("{} has changed on disk", visible::path(.0))]
    Changed(PathBuf),
    /// The operating system refused.
    #[error("writing {} failed: {source}", visible::path(path))]
    Io {
        /// The target.
        path: PathBuf,
        /// What the system reported.
        source: io::Error,
    },
}

impl From<WriteError> for io::Error {
    fn from(error: WriteError) -> Self {
        match error {
            WriteError::Io { source, .. } => source,
            error => Self::other(error),
        }
    }
}

/// A file to write.
#[derive(Debug, Clone, Copy)]
pub struct WriteTarget<'a> {
    /// Where it goes.
    pub path: &'a Path,
    /// Files that the same command reads.
    pub inputs: &'a [PathBuf],
    /// What may happen to a file that exists there.
    pub existing: Existing<'a>,
}

impl<'a> WriteTarget<'a> {
    /// A file that must not exist yet.
    #[must_use]
    pub fn new(path: &'a Path) -> Self {
        Self {
            path,
            inputs: &[],
            existing: Existing::Keep,
        }
    }

    /// A file that replaces what exists.
    #[must_use]
    pub fn replacing(path: &'a Path) -> Self {
        Self {
            existing: Existing::Replace,
            ..Self::new(path)
        }
    }

    /// Checks, without writing, that the target may be written: call it before a long computation.
    ///
    /// # Errors
    /// Every [`WriteError`] that is known before writing.
    pub fn check(&self) -> Result<(), WriteError> {
        self.permissions().map(drop)
    }

    /// Writes the file.
    ///
    /// # Errors
    /// The target may not be written, or the system refuses; an existing file is then intact.
    pub fn write(&self, contents: &[u8]) -> Result<(), WriteError> {
        let permissions = self.permissions()?;
        let written = self.write_beside_and_rename(contents, permissions);
        written.map_err(|source| match source.kind() {
            io::ErrorKind::AlreadyExists => WriteError::Exists(self.path.to_owned()),
            _ => self.io(source),
        })
    }

    /// The permissions to give the file: those of the file it replaces.
    fn permissions(&self) -> Result<Option<Permissions>, WriteError> {
        let path = || self.path.to_owned();
        let found = match self.path.symlink_metadata() {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                let directory = fs::metadata(directory_of(self.path));
                return directory.map(|_| None).map_err(|error| self.io(error));
            }
            Err(error) => return Err(self.io(error)),
        };
        if found.is_symlink() {
            return Err(WriteError::IsLink(path()));
        }
        if !found.is_file() {
            return Err(WriteError::NotRegular(path()));
        }
        if self
            .inputs
            .iter()
            .any(|input| is_same(self.path, &found, input))
        {
            return Err(WriteError::IsInput(path()));
        }
        if self.existing == Existing::Keep {
            return Err(WriteError::Exists(path()));
        }
        if found.permissions().readonly() {
            return Err(WriteError::ReadOnly(path()));
        }
        if let Existing::ReplaceIfUnchanged(text) = self.existing
            && read::bytes(self.path).map_err(|error| self.io(error))? != text.as_bytes()
        {
            return Err(WriteError::Changed(path()));
        }
        Ok(Some(found.permissions()))
    }

    fn write_beside_and_rename(
        &self,
        contents: &[u8],
        permissions: Option<Permissions>,
    ) -> io::Result<()> {
        let directory = directory_of(self.path);
        strays::remove(directory, &[]);
        let prefix = strays::prefix(self.path.file_name().unwrap_or_default());
        let mut beside =
            TemporaryFile::create(directory, &prefix, Hidden::File.suffix(), permissions)?;
        beside.fill(contents)?;
        beside.take_name(self.path, self.existing != Existing::Keep)?;
        disk::sync_directory(directory);
        Ok(())
    }

    fn io(&self, source: io::Error) -> WriteError {
        WriteError::Io {
            path: self.path.to_owned(),
            source,
        }
    }
}

/// The directory that holds a path.
fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Whether an input is the file found at the target, by device and inode (hard links) or by canonical path.
fn is_same(target: &Path, found: &Metadata, input: &Path) -> bool {
    let same_inode = fs::metadata(input)
        .is_ok_and(|input| (input.dev(), input.ino()) == (found.dev(), found.ino()));
    let same_path = || match (target.canonicalize(), input.canonicalize()) {
        (Ok(target), Ok(input)) => target == input,
        _ => false,
    };
    same_inode || same_path()
}

#[cfg(test)]
mod tests {
    use std::fs::File;
    use std::os::unix::fs::PermissionsExt;

    use super::disk::NewFile;
    use super::*;

    /// A directory with a file `old.txt` that holds "old".
    fn place() -> (tempfile::TempDir, PathBuf) {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("old.txt");
        fs::write(&file, "old").unwrap();
        (dir, file)
    }

    fn names(dir: &tempfile::TempDir) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(dir.path())
            .unwrap()
            .map(|item| item.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_new_file_is_written_with_the_usual_permissions() {
        let (dir, _) = place();
        let file = dir.path().join("new.txt");
        WriteTarget::new(&file).write(b"new").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        let plain = dir.path().join("plain.txt");
        File::create(&plain).unwrap();
        let mode = |path: &Path| path.metadata().unwrap().permissions().mode();
        assert_eq!(mode(&file), mode(&plain));
        assert_eq!(names(&dir), ["new.txt", "old.txt", "plain.txt"]);
    }

    #[test]
    fn an_existing_file_is_replaced_only_where_allowed() {
        let (dir, file) = place();
        assert!(matches!(
            WriteTarget::new(&file).write(b"new"),
            Err(WriteError::Exists(_))
        ));
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        fs::set_permissions(&file, Permissions::from_mode(0o640)).unwrap();
        WriteTarget::replacing(&file).write(b"new").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert_eq!(file.metadata().unwrap().permissions().mode() & 0o777, 0o640);
        assert_eq!(names(&dir), ["old.txt"]);
    }

    #[test]
    fn an_input_is_never_overwritten_not_even_by_a_hard_link() {
        let (dir, file) = place();
        let link = dir.path().join("link.txt");
        fs::hard_link(&file, &link).unwrap();
        let inputs = [file.clone()];
        for path in [&file, &link, &dir.path().join("./old.txt")] {
            let target = WriteTarget {
                inputs: &inputs,
                ..WriteTarget::replacing(path)
            };
            assert!(matches!(target.check(), Err(WriteError::IsInput(_))));
            assert!(matches!(target.write(b"new"), Err(WriteError::IsInput(_))));
        }
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    }

    #[test]
    fn nothing_is_written_through_a_symbolic_link() {
        let (dir, file) = place();
        for (name, to) in [("link.txt", "old.txt"), ("dangling.txt", "absent.txt")] {
            let link = dir.path().join(name);
            std::os::unix::fs::symlink(to, &link).unwrap();
            for target in [WriteTarget::new(&link), WriteTarget::replacing(&link)] {
                assert!(matches!(target.write(b"new"), Err(WriteError::IsLink(_))));
            }
        }
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        assert!(!dir.path().join("absent.txt").exists());
    }

    #[test]
    fn directories_and_devices_are_refused() {
        let (dir, _) = place();
        for path in [dir.path(), Path::new("/dev/full")] {
            assert!(matches!(
                WriteTarget::replacing(path).write(b"new"),
                Err(WriteError::NotRegular(_))
            ));
        }
    }

    #[test]
    fn a_file_that_is_read_only_or_has_changed_is_kept() {
        let (dir, file) = place();
        let target = WriteTarget {
            existing: Existing::ReplaceIfUnchanged("other"),
            ..WriteTarget::new(&file)
        };
        assert!(matches!(target.write(b"new"), Err(WriteError::Changed(_))));
        fs::set_permissions(&file, Permissions::from_mode(0o444)).unwrap();
        assert!(matches!(
            WriteTarget::replacing(&file).write(b"new"),
            Err(WriteError::ReadOnly(_))
        ));
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        assert_eq!(names(&dir), ["old.txt"]);
    }

    #[test]
    fn a_failure_leaves_no_temporary_file() {
        let (dir, file) = place();
        let absent = dir.path().join("absent/new.txt");
        assert!(WriteTarget::new(&absent).check().is_err());
        assert!(matches!(
            WriteTarget::new(&absent).write(b"new"),
            Err(WriteError::Io { .. })
        ));
        let too_long = dir.path().join("x".repeat(300));
        assert!(WriteTarget::new(&too_long).write(b"new").is_err());
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        assert_eq!(names(&dir), ["old.txt"]);
    }

    #[test]
    fn a_stream_is_created_exclusively() {
        let (dir, file) = place();
        assert!(NewFile::create(&file).is_err());
        let link = dir.path().join("link.txt");
        std::os::unix::fs::symlink("absent.txt", &link).unwrap();
        assert!(NewFile::create(&link).is_err());
        assert!(NewFile::create(&dir.path().join("new.txt")).is_ok());
    }
}
