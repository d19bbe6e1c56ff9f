//! A new run directory, under a name nobody else has.

use std::{
    ffi::{OsStr, OsString},
    fs,
    io::{self, Write},
    path::{Component, Path, PathBuf},
    sync::atomic::{AtomicU64, Ordering},
};

use super::{
    CASE, FILES, RUN, StoreError,
    lock::{DirectoryLock, lock_directory},
    read_info,
};
use crate::clock::{now, stamp};
use crate::files::WriteTarget;
use crate::files::disk::{self, NewFile};
use crate::run::{RunInfo, RunState};
use crate::strays::{self, Hidden};
use crate::visible;

/// Where a run directory goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RunLocation {
    /// A new directory below this one, named after case and time.
    Below(PathBuf),
    /// This very directory; it must not exist yet, or be empty.
    Exactly(PathBuf),
}

/// Makes the directory with `case.toml` and `run.toml` (state partial) in it, and sets the run's name
/// to that of the directory. It appears in one step, and held: nobody ever sees it without these two files.
pub(super) fn create(
    place: &RunLocation,
    info: &mut RunInfo,
    case_text: &str,
) -> Result<(PathBuf, Option<DirectoryLock>), StoreError> {
    info.state = RunState::Partial;
    match place {
        RunLocation::Exactly(dir) => {
            info.id = name_of(dir);
            refuse_if_taken(dir)?;
            let held = appear(dir, info, case_text)?;
            Ok((dir.clone(), held))
        }
        RunLocation::Below(root) => below(root, info, case_text),
    }
}

/// Tries `stem-20261121-061126`, then `…-2`, `…-3` until a name is free.
fn below(
    root: &Path,
    info: &mut RunInfo,
    case_text: &str,
) -> Result<(PathBuf, Option<DirectoryLock>), StoreError> {
    let base = format!("{}-{}", stem(&info.case_file), stamp(now()));
    let mut count = 1_u64;
    loop {
        info.id = if count == 1 {
            base.clone()
        } else {
            format!("{base}-{count}")
        };
        let dir = root.join(&info.id);
        let taken = dir.symlink_metadata().is_ok();
        match if taken {
            Err(StoreError::Taken(dir.clone()))
        } else {
            appear(&dir, info, case_text)
        } {
            Ok(held) => return Ok((dir, held)),
            // Another run took the name between the look and the step.
            Err(StoreError::Taken(_)) => count += 1,
            Err(other) => return Err(other),
        }
    }
}

/// The case's file name without `.toml`, with only characters that no shell or file system minds.
pub fn stem(case_file: &str) -> String {
    let name = Path::new(case_file)
        .file_stem()
        .map(|s| s.to_string_lossy().into_owned());
    let clean: String = name
        .unwrap_or_default()
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || "-_.".contains(c) {
                c
            } else {
                '-'
            }
        })
        .collect();
    let clean = clean.trim_start_matches(['.', '-']);
    if clean.is_empty() {
        "run".to_owned()
    } else {
        clean.to_owned()
    }
}

/// The name of a run in a directory: that of the directory.
pub(super) fn name_of(dir: &Path) -> String {
    dir.file_name()
        .map_or_else(|| "run".to_owned(), |n| n.to_string_lossy().into_owned())
}

fn refuse_if_taken(dir: &Path) -> Result<(), StoreError> {
    match fs::read_dir(dir) {
        Ok(mut inside) => match inside.next() {
            None => Ok(()),
            Some(_) => Err(StoreError::Taken(dir.to_owned())),
        },
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::NotADirectory => {
            Err(StoreError::Taken(dir.to_owned()))
        }
        Err(error) => Err(StoreError::io("Opening", dir)(error)),
    }
}

/// A number for each hidden directory of this process.
static COUNTER: AtomicU64 = AtomicU64::new(0);

fn hidden_name(dir: &Path, number: u64, hidden: Hidden) -> OsString {
    let mut name = strays::prefix(OsStr::new(&name_of(dir)));
    name.push(format!("{number}{}", hidden.suffix()));
    name
}

/// Deletes a run directory in one step: a kill leaves the whole run, or a hidden directory that the next run removes. Anything else than a
/// run is refused.
///
/// # Errors
/// It is no run, or the system refuses.
pub fn delete(dir: &Path) -> Result<(), StoreError> {
    read_info(dir)?;
    let number = COUNTER.fetch_add(1, Ordering::Relaxed);
    let hidden = parent_of(dir).join(hidden_name(dir, number, Hidden::DeletedRun));
    let link = dir.symlink_metadata().is_ok_and(|found| found.is_symlink());
    if !link {
        disk::rename(dir, &hidden).map_err(StoreError::io("Deleting", dir))?;
    }
    let left = if link { dir } else { &hidden };
    disk::remove_dir_all(left).map_err(StoreError::io("Deleting", dir))
}

/// Makes the directory of a run that is under way, held.
fn appear(
    dir: &Path,
    info: &RunInfo,
    case_text: &str,
) -> Result<Option<DirectoryLock>, StoreError> {
    room_for(dir)?;
    remove_left_beside(dir);
    in_one_step(dir, |hidden| {
        disk::create_dir(hidden).map_err(StoreError::io("Making the directory", hidden))?;
        replace(hidden, CASE, case_text.as_bytes())?;
        replace(hidden, RUN, info_text(hidden, info)?.as_bytes())?;
        Ok(lock_directory(hidden))
    })
}

/// Removes what killed processes left of runs in the directory that a run goes into.
pub fn remove_left_beside(dir: &Path) {
    strays::remove(&parent_of(dir), &FILES);
}

/// Makes the directory of a run that has ended: it is there with all its files, or not at all.
pub(super) fn at_once(
    dir: &Path,
    fill: impl FnOnce(&mut NewDirectory) -> Result<(), StoreError>,
) -> Result<(), StoreError> {
    room_for(dir)?;
    in_one_step(dir, |hidden| {
        let mut new = NewDirectory::create(hidden, dir)?;
        fill(&mut new)?;
        new.sync()
    })
}

/// A directory that nobody else sees: its files are made under their names, and synced together.
pub(super) struct NewDirectory {
    dir: PathBuf,
    /// Where it goes, by which faults name it.
    place: PathBuf,
    files: Vec<NewFile>,
}

impl NewDirectory {
    fn create(dir: &Path, place: &Path) -> Result<Self, StoreError> {
        disk::create_dir(dir).map_err(StoreError::io("Making the directory", place))?;
        Ok(Self {
            dir: dir.to_owned(),
            place: place.to_owned(),
            files: Vec::new(),
        })
    }

    /// Where it goes.
    pub(super) fn place(&self) -> &Path {
        &self.place
    }

    /// Makes a file.
    pub(super) fn put(&mut self, name: &str, bytes: &[u8]) -> Result<(), StoreError> {
        let place = self.place.join(name);
        let wrong = |source| StoreError::io("Writing", &place)(source);
        let mut file = NewFile::create(&self.dir.join(name)).map_err(wrong)?;
        file.write_all(bytes).map_err(wrong)?;
        self.files.push(file);
        Ok(())
    }

    /// Makes it survive a power cut.
    fn sync(self) -> Result<(), StoreError> {
        let wrong = StoreError::io("Writing", &self.place);
        let synced = self.files.iter().try_for_each(NewFile::sync);
        synced.map_err(wrong)?;
        disk::sync_directory(&self.dir);
        Ok(())
    }
}

/// Makes the directory that a run goes into, where it is missing; fails where the run cannot go there.
pub(super) fn room_for(dir: &Path) -> Result<(), StoreError> {
    refuse_if_taken(dir)?;
    let parent = parent_of(dir);
    if parent.join(RUN).is_file() {
        return Err(StoreError::InRun(dir.to_owned()));
    }
    // Missing parents are made, but not to step out of them again.
    let steps_out = dir.components().any(|part| part == Component::ParentDir);
    if steps_out && !parent.is_dir() {
        let absent = io::Error::from(io::ErrorKind::NotFound);
        return Err(StoreError::io("Opening", &parent)(absent));
    }
    disk::create_dir_all(&parent).map_err(StoreError::io("Making the directory", &parent))
}

/// Fills a hidden directory beside the final one, then renames it.
fn in_one_step<T>(
    dir: &Path,
    fill: impl FnOnce(&Path) -> Result<T, StoreError>,
) -> Result<T, StoreError> {
    let parent = parent_of(dir);
    let number = COUNTER.fetch_add(1, Ordering::Relaxed);
    let hidden = parent.join(hidden_name(dir, number, Hidden::NewRun));

    let filled = fill(&hidden).and_then(|made| {
        let renamed = disk::rename(&hidden, dir);
        renamed.map(|()| made).map_err(|error| match error.kind() {
            io::ErrorKind::DirectoryNotEmpty | io::ErrorKind::AlreadyExists => {
                StoreError::Taken(dir.to_owned())
            }
            _ => StoreError::io("Making the run directory", dir)(error),
        })
    });
    if filled.is_err() {
        // Best effort: the error that matters is the one already in hand.
        let _ = disk::remove_dir_all(&hidden);
    }
    let made = filled?;
    disk::sync_directory(&parent);
    Ok(made)
}

/// `run.toml` as text.
pub(super) fn info_text(dir: &Path, info: &RunInfo) -> Result<String, StoreError> {
    let text = toml::to_string(info).map_err(|error| StoreError::Damaged {
        file: dir.join(RUN),
        reason: error.to_string(),
    })?;
    Ok(visible::toml(&text).into_owned())
}

/// Replaces a file of a run directory: a reader sees the old or the new one whole.
pub(super) fn replace(dir: &Path, name: &str, bytes: &[u8]) -> Result<(), StoreError> {
    Ok(WriteTarget::replacing(&dir.join(name)).write(bytes)?)
}

fn parent_of(dir: &Path) -> PathBuf {
    match dir.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    }
}

#[cfg(test)]
mod tests {
    use super::stem;

    #[test]
    fn names_are_safe() {
        assert_eq!(stem("manifold.toml"), "manifold");
        assert_eq!(stem("my case (2).toml"), "my-case--2-");
        assert_eq!(stem("../x/..toml"), "run");
        assert_eq!(stem(""), "run");
    }
}
