//! Locks on files: a process holds one while it lives, and the system releases it when the process ends, however it ends.

use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, Write};
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;

use rustix::fs::{FlockOperation, OFlags, flock};
use rustix::io::Errno;

use super::faults::{self, DiskOperation};

/// Permissions of a lock: nobody else needs it.
const MODE: u32 = 0o600;

/// The longest text that is read from a lock \[bytes\].
const LONGEST: u64 = 1 << 16;

/// A lock, released when dropped. Its file may hold a text, such as the name of its process.
#[derive(Debug)]
pub struct LockFile {
    file: File,
    is_exclusive: bool,
}

impl LockFile {
    /// Takes a lock without waiting for it; nothing where another process holds it. Makes its file where it is missing.
    ///
    /// # Errors
    /// The system refuses.
    pub fn take(path: &Path) -> io::Result<Option<Self>> {
        faults::met(DiskOperation::Create, path)?;
        let file = open(path, true)?;
        match flock(&file, FlockOperation::NonBlockingLockExclusive) {
            Ok(()) => Ok(Some(Self {
                file,
                is_exclusive: true,
            })),
            Err(Errno::WOULDBLOCK) => Ok(None),
            Err(error) => Self::without(file, error).map(Some),
        }
    }

    /// Takes a lock, and waits until others have released it.
    ///
    /// # Errors
    /// The system refuses.
    pub fn wait(path: &Path) -> io::Result<Self> {
        faults::met(DiskOperation::Create, path)?;
        let file = open(path, true)?;
        match flock(&file, FlockOperation::LockExclusive) {
            Ok(()) => Ok(Self {
                file,
                is_exclusive: true,
            }),
            Err(error) => Self::without(file, error),
        }
    }

    /// The file system may have no locks.
    fn without(file: File, error: Errno) -> io::Result<Self> {
        let no_locks = [Errno::NOLCK, Errno::NOTSUP, Errno::NOSYS, Errno::INVAL];
        match no_locks.contains(&error) {
            true => Ok(Self {
                file,
                is_exclusive: false,
            }),
            false => Err(error.into()),
        }
    }

    /// Whether no other process can hold it; false where the file system has no locks.
    pub const fn is_exclusive(&self) -> bool {
        self.is_exclusive
    }

    /// The text of its file; empty where it cannot be read.
    pub fn text(&mut self) -> String {
        let mut bytes = Vec::new();
        let read = self
            .file
            .rewind()
            .and_then(|()| (&mut self.file).take(LONGEST).read_to_end(&mut bytes));
        read.ok()
            .and_then(|_| String::from_utf8(bytes).ok())
            .unwrap_or_default()
    }

    /// Replaces the text of its file, in place: another file of the name would be another lock.
    ///
    /// # Errors
    /// The system refuses.
    pub fn write(&mut self, text: &str) -> io::Result<()> {
        self.file.rewind()?;
        self.file.set_len(0)?;
        self.file.write_all(text.as_bytes())
    }
}

/// Whether a process holds the lock of this file.
#[must_use]
pub fn is_held(path: &Path) -> bool {
    open(path, false).is_ok_and(|file| {
        let tried = flock(&file, FlockOperation::NonBlockingLockShared);
        tried == Err(Errno::WOULDBLOCK)
    })
}

/// Opened to be written, as locks of network file systems need it.
fn open(path: &Path, create: bool) -> io::Result<File> {
    let flags = (OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::NOCTTY).bits();
    OpenOptions::new()
        .read(true)
        .write(true)
        .create(create)
        .mode(MODE)
        .custom_flags(i32::try_from(flags).unwrap_or_default())
        .open(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_is_held_once_and_released_when_dropped() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("lock");
        assert!(!is_held(&path));
        let mut lock = LockFile::take(&path).unwrap().unwrap();
        lock.write("first, and longer").unwrap();
        lock.write("second").unwrap();
        assert_eq!(lock.text(), "second");
        assert!(lock.is_exclusive());
        assert!(is_held(&path));
        assert!(LockFile::take(&path).unwrap().is_none());
        drop(lock);
        assert!(!is_held(&path));
        assert_eq!(LockFile::wait(&path).unwrap().text(), "second");
    }

    #[test]
    fn a_link_is_no_lock() {
        let dir = tempfile::tempdir().unwrap();
        let link = dir.path().join("link");
        std::os::unix::fs::symlink("elsewhere", &link).unwrap();
        assert!(LockFile::take(&link).is_err());
        assert!(!dir.path().join("elsewhere").exists());
    }
}
