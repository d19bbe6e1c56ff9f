//! The one way to what changes a disk: files made, written, synced, renamed and removed. Here tests let an operation fail (see
//! `faults`).

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, Write};
use std::os::unix::fs::{DirBuilderExt, OpenOptionsExt, PermissionsExt};
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use super::faults::{self, DiskOperation};

/// Permissions of a new file, before the umask.
const NEW_FILE_MODE: u32 = 0o666;

/// A file that this program made and writes.
#[derive(Debug)]
pub struct NewFile {
    file: File,
    path: PathBuf,
}

impl NewFile {
    /// Makes a file that must not exist yet.
    ///
    /// # Errors
    /// Something exists there, or the system refuses.
    pub fn create(path: &Path) -> io::Result<Self> {
        faults::met(DiskOperation::Create, path)?;
        let file = OpenOptions::new()
            .write(true)
            .create_new(true)
            .mode(NEW_FILE_MODE)
            .open(path)?;
        Ok(Self {
            file,
            path: path.to_owned(),
        })
    }

    /// Makes a file in a directory that has no name: the system frees it however the program ends.
    ///
    /// # Errors
    /// The system refuses.
    pub fn nameless_in(dir: &Path) -> io::Result<Self> {
        faults::met(DiskOperation::Create, dir)?;
        Ok(Self {
            file: tempfile::tempfile_in(dir)?,
            path: dir.to_owned(),
        })
    }

    /// Makes what is written survive a power cut.
    ///
    /// # Errors
    /// The system refuses.
    pub fn sync(&self) -> io::Result<()> {
        faults::met(DiskOperation::Sync, &self.path)?;
        self.file.sync_all()
    }

    /// The file, to be read and measured.
    pub const fn open(&self) -> &File {
        &self.file
    }

    /// Holds room for so many bytes.
    ///
    /// # Errors
    /// There is no such room, or the file system cannot hold any.
    pub fn hold(&self, bytes: u64) -> io::Result<()> {
        use rustix::fs::{FallocateFlags, fallocate};
        faults::met(DiskOperation::Write, &self.path)?;
        Ok(fallocate(&self.file, FallocateFlags::empty(), 0, bytes)?)
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let taken = faults::taken(&self.path, bytes.len())?;
        self.file.write(&bytes[..taken])
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A file beside the one whose name it will take; removed unless it takes it.
#[derive(Debug)]
pub(crate) struct TemporaryFile {
    file: NewFile,
    name: TempPath,
}

impl TemporaryFile {
    /// Makes it, under a name of its own between `prefix` and `suffix`.
    ///
    /// # Errors
    /// The system refuses.
    pub(crate) fn create(
        dir: &Path,
        prefix: &OsStr,
        suffix: &str,
        permissions: Option<Permissions>,
    ) -> io::Result<Self> {
        faults::met(DiskOperation::Create, dir)?;
        let made = tempfile::Builder::new()
            .prefix(prefix)
            .suffix(suffix)
            .permissions(Permissions::from_mode(NEW_FILE_MODE))
            .tempfile_in(dir)?;
        let (file, name) = NamedTempFile::into_parts(made);
        if let Some(permissions) = permissions {
            faults::met(DiskOperation::Permissions, &name)?;
            file.set_permissions(permissions)?;
        }
        let path = name.to_path_buf();
        Ok(Self {
            file: NewFile { file, path },
            name,
        })
    }

    /// Writes all of the contents, and makes them survive a power cut.
    ///
    /// # Errors
    /// The system refuses.
    pub(crate) fn fill(&mut self, contents: &[u8]) -> io::Result<()> {
        self.file.write_all(contents)?;
        self.file.sync()
    }

    /// Takes a name, over what has it or only where it is free.
    ///
    /// # Errors
    /// The name is taken, or the system refuses.
    pub(crate) fn take_name(self, path: &Path, over: bool) -> io::Result<()> {
        faults::met(DiskOperation::Rename, path)?;
        let taken = if over {
            self.name.persist(path)
        } else {
            self.name.persist_noclobber(path)
        };
        taken.map_err(|error| error.error)
    }
}

/// Renames a file or directory.
///
/// # Errors
/// As [`fs::rename`].
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    faults::met(DiskOperation::Rename, to)?;
    fs::rename(from, to)
}

/// Makes a directory.
///
/// # Errors
/// As [`fs::create_dir`].
pub fn create_dir(path: &Path) -> io::Result<()> {
    faults::met(DiskOperation::Create, path)?;
    fs::create_dir(path)
}

/// Makes a directory that only its owner can enter.
///
/// # Errors
/// As [`fs::create_dir`].
pub fn create_private_dir(path: &Path) -> io::Result<()> {
    faults::met(DiskOperation::Create, path)?;
    fs::DirBuilder::new().mode(0o700).create(path)
}

/// A file that only its owner can read, to be written at its end; made where it is missing.
///
/// # Errors
/// As [`OpenOptions::open`].
pub fn append_private(path: &Path) -> io::Result<File> {
    faults::met(DiskOperation::Create, path)?;
    let mut options = OpenOptions::new();
    options.append(true).create(true).mode(0o600).open(path)
}

/// Makes a directory and those above it, where they are missing.
///
/// # Errors
/// As [`fs::create_dir_all`].
pub fn create_dir_all(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Ok(());
    }
    faults::met(DiskOperation::Create, path)?;
    fs::create_dir_all(path)
}

/// Removes a file.
///
/// # Errors
/// As [`fs::remove_file`].
pub fn remove_file(path: &Path) -> io::Result<()> {
    faults::met(DiskOperation::Remove, path)?;
    fs::remove_file(path)
}

/// Removes an empty directory.
///
/// # Errors
/// As [`fs::remove_dir`].
pub fn remove_dir(path: &Path) -> io::Result<()> {
    faults::met(DiskOperation::Remove, path)?;
    fs::remove_dir(path)
}

/// Removes a directory with all that is in it.
///
/// # Errors
/// As [`fs::remove_dir_all`].
pub fn remove_dir_all(path: &Path) -> io::Result<()> {
    faults::met(DiskOperation::Remove, path)?;
    fs::remove_dir_all(path)
}

/// Makes renames in a directory survive a power cut. A file system that cannot sync a directory is left alone.
pub fn sync_directory(directory: &Path) {
    if let Ok(open) = File::open(directory) {
        // Not every file system syncs directories, and the file itself is synced already.
        let _ = open.sync_all();
    }
}
