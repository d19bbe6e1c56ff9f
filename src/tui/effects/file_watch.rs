//! Watches the file that is open, or the directory that is listed, for changes by other programs.
//!
//! Its attributes are read once a second: unlike notices of the kernel, this works on the network file systems of shared servers.

use std::fs::Metadata;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::Duration;

use super::outbox::Outbox;
use crate::msg::Msg;
use seacable_base::files::read;

/// Time between two looks.
const PAUSE: Duration = Duration::from_secs(1);

/// What differs between two contents of a file: device and inode, size, time of change.
type Stamp = (u64, u64, u64, i64, i64);

/// The thread that watches, and what it watches.
#[derive(Debug)]
pub(super) struct FileWatch {
    watched: Arc<(Mutex<Option<Watched>>, Condvar)>,
}

/// A path and what it was at the last looks.
#[derive(Debug)]
struct Watched {
    path: PathBuf,
    /// As it was told, or as it was at first.
    told: Option<Stamp>,
    /// As it was at the last look, where that differs.
    seen: Option<Stamp>,
}

impl FileWatch {
    /// Starts the thread; where the system gives none, nothing is watched.
    pub(super) fn start(out: Outbox) -> Self {
        let watched: Arc<(Mutex<Option<Watched>>, Condvar)> = Arc::default();
        let shared = Arc::clone(&watched);
        let started = std::thread::Builder::new()
            .name("watch".to_owned())
            .spawn(move || {
                loop {
                    if let Some(path) = look(&shared) {
                        out.send(told(&path));
                    }
                }
            });
        drop(started);
        Self { watched }
    }

    /// Watches another path.
    pub(super) fn watch(&self, path: PathBuf) {
        let told = stamp(&path);
        let new = Watched {
            path,
            told,
            seen: None,
        };
        let (lock, changed) = &*self.watched;
        *lock.lock().unwrap_or_else(PoisonError::into_inner) = Some(new);
        changed.notify_all();
    }
}

/// Waits for the next look, and returns the path where it has changed and stayed so for two looks: it is whole then.
fn look(shared: &(Mutex<Option<Watched>>, Condvar)) -> Option<PathBuf> {
    let (lock, changed) = shared;
    let watched = lock.lock().unwrap_or_else(PoisonError::into_inner);
    let mut watched = match watched.is_some() {
        true => {
            let waited = changed.wait_timeout(watched, PAUSE);
            waited.unwrap_or_else(PoisonError::into_inner).0
        }
        false => changed
            .wait(watched)
            .unwrap_or_else(PoisonError::into_inner),
    };
    let one = watched.as_mut()?;
    let now = stamp(&one.path);
    if now == one.told || now.is_none() {
        one.seen = None;
        return None;
    }
    if one.seen != now {
        one.seen = now;
        return None;
    }
    one.told = now;
    one.seen = None;
    Some(one.path.clone())
}

/// What is said of a path that has changed.
fn told(path: &Path) -> Msg {
    if path.is_dir() {
        return Msg::ListChanged(path.to_owned());
    }
    let text = read::text_lossy(path).unwrap_or_default();
    Msg::ChangedOutside(path.to_owned(), text)
}

fn stamp(path: &Path) -> Option<Stamp> {
    let of = |data: Metadata| {
        (
            data.dev(),
            data.ino(),
            data.size(),
            data.mtime(),
            data.mtime_nsec(),
        )
    };
    path.metadata().ok().map(of)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn shared(path: &Path) -> (Mutex<Option<Watched>>, Condvar) {
        let watched = Watched {
            path: path.to_owned(),
            told: stamp(path),
            seen: None,
        };
        (Mutex::new(Some(watched)), Condvar::new())
    }

    #[test]
    fn a_change_is_told_once_it_has_stayed() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("a.toml");
        fs::write(&file, "one").unwrap();
        let shared = shared(&file);
        assert_eq!(look(&shared), None);
        fs::write(&file, "longer").unwrap();
        assert_eq!(look(&shared), None, "it may still be written");
        assert_eq!(look(&shared), Some(file.clone()));
        assert_eq!(look(&shared), None);
        // Replaced by another file, as editors do.
        let other = dir.path().join("b.toml");
        fs::write(&other, "longer").unwrap();
        fs::rename(&other, &file).unwrap();
        assert_eq!(look(&shared), None);
        assert_eq!(look(&shared), Some(file.clone()));
        // Gone for a moment: nothing to tell.
        fs::remove_file(&file).unwrap();
        assert_eq!(look(&shared), None);
        assert_eq!(look(&shared), None);
        assert!(matches!(told(dir.path()), Msg::ListChanged(_)));
    }
}
