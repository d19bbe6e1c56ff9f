//! Who writes a run: the program that computes it holds a lock on its directory, which the system takes back when the
//! program ends, however it ends. A partial run that nobody holds was killed.

use std::{fs::File, path::Path};

use rustix::fs::{FlockOperation, flock};
use rustix::io::Errno;

/// A run directory held; dropped, it is let go.
#[derive(Debug)]
pub(super) struct DirectoryLock {
    _directory: File,
}

/// Holds a directory; nothing where the file system has no locks.
pub(super) fn lock_directory(dir: &Path) -> Option<DirectoryLock> {
    let directory = File::open(dir).ok()?;
    flock(&directory, FlockOperation::NonBlockingLockExclusive).ok()?;
    Some(DirectoryLock {
        _directory: directory,
    })
}

/// Whether a program is writing the run in this directory at this moment.
#[must_use]
pub fn is_locked(dir: &Path) -> bool {
    File::open(dir).is_ok_and(|directory| {
        let tried = flock(&directory, FlockOperation::NonBlockingLockShared);
        tried == Err(Errno::WOULDBLOCK)
    })
}
