//! The lock on a run directory: the program that computes a run holds it, and the system releases it when the program ends,
//! however it ends. A partial run without a lock was killed.

use std::{fs::File, path::Path};

use rustix::fs::{FlockOperation, flock};
use rustix::io::Errno;

/// A lock on a run directory, released when dropped.
#[derive(Debug)]
pub struct DirectoryLock {
    _directory: File,
}

/// Locks a directory; `None` where the file system has no locks.
pub fn lock_directory(dir: &Path) -> Option<DirectoryLock> {
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
