//! The runs below a directory.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use super::{StoreError, is_locked, read_info};
use crate::run::{RunInfo, RunState};

/// One run directory.
#[derive(Debug)]
pub struct StoredRun {
    /// Where it is.
    pub dir: PathBuf,
    /// What its `run.toml` says, or why it cannot be read.
    pub info: Result<RunInfo, StoreError>,
    /// Whether a program is computing it at this moment.
    pub held: bool,
}

/// The runs right below a directory, newest first, damaged ones last; none when it does not exist.
/// Directories that hold no run are passed over.
///
/// # Errors
/// The directory cannot be listed.
pub fn list(root: &Path) -> Result<Vec<StoredRun>, StoreError> {
    let inside = match fs::read_dir(root) {
        Ok(inside) => inside,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(StoreError::io("Listing", root)(error)),
    };
    let mut entries = Vec::new();
    for item in inside {
        let dir = item.map_err(StoreError::io("Listing", root))?.path();
        // Hidden directories are runs about to appear, or left by a kill before they did.
        let hidden = dir
            .file_name()
            .is_some_and(|n| n.to_string_lossy().starts_with('.'));
        if hidden || !dir.is_dir() {
            continue;
        }
        match read_info(&dir) {
            Err(StoreError::NotARun(_)) => {}
            info => {
                let partial = |i: &RunInfo| i.state == RunState::Partial;
                let held = info.as_ref().is_ok_and(partial) && is_locked(&dir);
                entries.push(StoredRun { dir, info, held });
            }
        }
    }
    entries.sort_by_key(|e| std::cmp::Reverse(age(e)));
    Ok(entries)
}

/// Beginning of the run, then a name in which counters sort as numbers; empty for damaged ones.
fn age(entry: &StoredRun) -> (String, usize, String) {
    match &entry.info {
        Ok(info) => (info.started.clone(), info.id.len(), info.id.clone()),
        Err(_) => (String::new(), 0, entry.dir.to_string_lossy().into_owned()),
    }
}
