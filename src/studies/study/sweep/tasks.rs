//! The directory in which parts of a sweep are computed and tasks of arrays print: `tasks` in the folder of the sweep. It is there while a
//! sweep is computed on a cluster, and goes with the end.

use std::path::{Path, PathBuf};
use std::{fs, io};

use super::{SweepError, SweepFolder};
use crate::files::disk;
use crate::run::store;

const TASKS: &str = "tasks";

impl SweepFolder {
    /// Makes the directory in which parts compute and tasks print, where it is missing.
    ///
    /// # Errors
    /// The system refuses.
    pub fn make_room_for_parts(&self) -> Result<PathBuf, SweepError> {
        let tasks = self.dir().join(TASKS);
        let made = match is_link(&tasks) {
            true => Err(io::Error::other(
                "it is a link, which may lead elsewhere; remove it",
            )),
            false => disk::create_dir_all(&tasks),
        };
        match made {
            Ok(()) => Ok(tasks),
            Err(source) => Err(SweepError::Io {
                file: tasks,
                source,
            }),
        }
    }

    /// Removes what parts left that were killed, and once all is well what the tasks of arrays printed too. Call it when no array is in the
    /// queue: of another machine it is not seen whether a part is computing.
    ///
    /// # Errors
    /// A part is computed on this machine at this moment.
    pub fn remove_parts(&self, all_is_well: bool) -> Result<(), SweepError> {
        let tasks = self.dir().join(TASKS);
        let inside = (!is_link(&tasks)).then(|| fs::read_dir(&tasks).ok());
        let Some(inside) = inside.flatten() else {
            return Ok(());
        };
        let (parts, printed): (Vec<PathBuf>, Vec<PathBuf>) = inside
            .flatten()
            .map(|item| item.path())
            .partition(|path| path.is_dir());
        if let Some(busy) = parts.iter().find(|part| store::is_locked(part)) {
            return Err(SweepError::Busy(busy.clone()));
        }
        // Best effort: what stays does no harm.
        for part in parts.iter().filter(|path| is_named(path, &['-', '.'], "")) {
            let _ = disk::remove_dir_all(part);
        }
        if all_is_well {
            for file in printed.iter().filter(|path| is_named(path, &['_'], ".log")) {
                let _ = disk::remove_file(file);
            }
            let _ = disk::remove_dir(&tasks);
        }
        Ok(())
    }
}

fn is_link(path: &Path) -> bool {
    path.symlink_metadata()
        .is_ok_and(|found| found.is_symlink())
}

/// Whether a file has a name of numbers with these marks between them.
fn is_named(path: &Path, marks: &[char], suffix: &str) -> bool {
    let name = path.file_name().and_then(|name| name.to_str());
    let numbers = name.and_then(|name| name.strip_suffix(suffix));
    numbers.is_some_and(|numbers| {
        let parts: Vec<&str> = numbers.split(marks).collect();
        let digits = |part: &&str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
        parts.len() == marks.len() + 1 && parts.iter().all(digits)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_tasks_leave_is_known_by_its_name() {
        let named = |name: &str| is_named(Path::new(name), &['-', '.'], "");
        assert!(named("tasks/1-250.1") && !named("tasks/1-250") && !named("tasks/mine"));
        let printed = |name: &str| is_named(Path::new(name), &['_'], ".log");
        assert!(printed("12_3.log") && !printed("12.log") && !printed("12_a.log"));
    }
}
