//! The folders of the program: whether they can be written, and how much room there is.

use std::io;
use std::path::{Path, PathBuf};

use rustix::fs::{Access, access, statvfs};

use super::finding::{DoctorFinding, Surroundings};
use seacable_base::{places, visible};
use seacable_runs::run::store::DEFAULT_ROOT;

const TOPIC: &str = "folders";

/// Less room than this is too little for runs \[bytes\].
const LITTLE: u64 = 100 << 20;

pub(super) fn findings(around: &Surroundings<'_>) -> Vec<DoctorFinding> {
    let runs = Ok(around.directory.join(DEFAULT_ROOT));
    vec![
        folder("settings", places::config_dir()),
        folder("shipped cases", places::data_dir()),
        folder("state", places::state_dir()),
        folder("index of runs", places::cache_dir()),
        folder("runs", runs),
    ]
}

fn folder(name: &str, path: io::Result<PathBuf>) -> DoctorFinding {
    let path = match path {
        Ok(path) => path,
        Err(error) => {
            let found = DoctorFinding::fine(TOPIC, name, error.to_string());
            return found.problem("set HOME to your home directory");
        }
    };
    let shown = visible::path(&path);
    let (there, new) = nearest(&path);
    let new = if new { ", made when it is needed" } else { "" };
    let free = free(there);
    let room = free.map_or_else(String::new, |free| format!(", {} free", size(free)));
    let found = DoctorFinding::fine(TOPIC, name, format!("{shown}{new}{room}"));
    if !there.is_dir() {
        let what = visible::path(there);
        return found.problem(format!("{what} is no directory; move it away"));
    }
    if access(there, Access::WRITE_OK | Access::EXEC_OK).is_err() {
        let what = visible::path(there);
        return found.problem(format!(
            "{what} cannot be written: give yourself permission, or work elsewhere"
        ));
    }
    match free {
        Some(free) if free < LITTLE => {
            found.problem("there is too little room on its disk; delete runs that are not needed")
        }
        _ => found,
    }
}

/// The path, or the nearest above it that is there; and whether that is another.
fn nearest(path: &Path) -> (&Path, bool) {
    let mut above = path.ancestors();
    let there = above.find(|path| path.symlink_metadata().is_ok());
    let there = there.unwrap_or(Path::new("."));
    (there, there != path)
}

/// The room on the disk of a folder \[bytes\].
fn free(path: &Path) -> Option<u64> {
    let found = statvfs(path).ok()?;
    Some(found.f_bavail.saturating_mul(found.f_frsize))
}

fn size(bytes: u64) -> String {
    match bytes >> 20 {
        mib @ 0..1024 => format!("{mib} MiB"),
        mib => format!("{} GiB", mib >> 10),
    }
}
