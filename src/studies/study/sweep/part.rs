//! A part of the load cases of a sweep, computed beside other parts by other processes, on whatever machine.
//!
//! Machines that share a folder rarely share its locks. A run is therefore computed in a directory that belongs to the part alone,
//! below `tasks` in the folder of the sweep, and takes its place beside the folder by one rename when it has come to its end. The
//! rename succeeds for one of all who may have computed it: no run is stored twice, none is seen half made, and none is deleted under
//! the hands of another. What a killed part leaves lies below `tasks`, and goes when the sweep is gathered.

use std::io;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use super::{Sweep, SweepError, SweepFolder};
use crate::files::disk;
use crate::run::RunState;
use crate::run::store::{DirectoryLock, lock_directory};
use crate::study::points::{self, PointOutcome, side_by_side};
use crate::visible;

/// Load cases that follow one another, by their numbers, which begin at 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SweepPart {
    /// The first.
    pub first: usize,
    /// The last.
    pub last: usize,
}

impl FromStr for SweepPart {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once("..").and_then(|(first, last)| {
            let [first, last] = [first, last].map(|word| word.trim().parse::<usize>().ok());
            Some((first?, last?))
        });
        match numbers {
            Some((first, last)) if (1..=last).contains(&first) => Ok(Self { first, last }),
            _ => Err("give two numbers of load cases, such as 1..250".to_owned()),
        }
    }
}

/// What became of the load cases of a part.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PartDone {
    /// Load cases that were stored before, or by another part at the same time.
    pub stored_before: usize,
    /// Runs that were computed and stored.
    pub computed: usize,
    /// Of these, runs whose solver failed.
    pub failed: usize,
    /// Load cases that the case refuses.
    pub refused: usize,
    /// Load cases that were stopped, or did not begin.
    pub stopped: usize,
    /// Why a run could not be stored, which ends the part.
    pub unstored: Option<String>,
}

/// What became of one load case.
enum LoadCaseEnd {
    Before,
    Computed(RunState),
    Refused,
    Stopped,
    Unstored(String),
}

impl Sweep {
    /// Computes a part of the load cases side by side on the threads of the caller's pool, and stores their runs beside the folder. Those
    /// whose place is taken are passed over, whatever became of them. Once `cancel` is set no further one begins, and what is under way
    /// is not stored.
    ///
    /// # Errors
    /// The part lies beyond the load cases, or its own directory cannot be made.
    pub fn compute_part(
        &self,
        folder: &SweepFolder,
        part: SweepPart,
        cancel: &AtomicBool,
    ) -> Result<PartDone, SweepError> {
        let of = self.variation.points.len();
        if part.first > of {
            return Err(SweepError::Beyond(part.first, of));
        }
        let all = part.first - 1..part.last.min(of);
        let count = all.len();
        let left: Vec<usize> = all.filter(|index| !is_taken(&folder.run(*index))).collect();
        let mut done = PartDone {
            stored_before: count - left.len(),
            ..PartDone::default()
        };
        if left.is_empty() {
            return Ok(done);
        }
        let own = OwnDirectory::make(folder, part)?;
        let compute = |index| self.one_of_part(folder, &own, index, cancel);
        for outcome in side_by_side(left, cancel, compute, |_, _, _, _| {}) {
            done.count(outcome.unwrap_or(LoadCaseEnd::Stopped));
        }
        Ok(done)
    }

    fn one_of_part(
        &self,
        folder: &SweepFolder,
        own: &OwnDirectory,
        index: usize,
        cancel: &AtomicBool,
    ) -> LoadCaseEnd {
        let place = folder.run(index);
        if is_taken(&place) {
            return LoadCaseEnd::Before;
        }
        let Ok(job) = self.job(index) else {
            return LoadCaseEnd::Refused;
        };
        let at = own.dir.join(place.file_name().unwrap_or_default());
        match points::outcome(job, Some(&at), cancel) {
            Err(why) => LoadCaseEnd::Unstored(why),
            outcome if has_ended(&outcome) => published(&at, &place, &outcome),
            Ok(_) => LoadCaseEnd::Stopped,
        }
    }

    /// Why the case refuses a load case; nothing where it does not.
    #[must_use]
    pub fn refusal(&self, index: usize) -> Option<String> {
        self.job(index).err()
    }
}

impl PartDone {
    fn count(&mut self, done: LoadCaseEnd) {
        match done {
            LoadCaseEnd::Before => self.stored_before += 1,
            LoadCaseEnd::Computed(state) => {
                self.computed += 1;
                self.failed += usize::from(state == RunState::Failed);
            }
            LoadCaseEnd::Refused => self.refused += 1,
            LoadCaseEnd::Stopped => self.stopped += 1,
            LoadCaseEnd::Unstored(why) => {
                self.stopped += 1;
                self.unstored.get_or_insert(why);
            }
        }
    }

    /// Whether every load case has ended, and none by a fault.
    #[must_use]
    pub fn is_good(&self) -> bool {
        self.failed + self.refused + self.stopped == 0
    }
}

/// Whether a run came to an end of its own: its results, or why there are none.
fn has_ended(outcome: &PointOutcome) -> bool {
    let ended = [RunState::Done, RunState::Failed];
    outcome
        .as_ref()
        .is_ok_and(|run| ended.contains(&run.info.state))
}

fn is_taken(place: &Path) -> bool {
    place.symlink_metadata().is_ok()
}

/// Gives a run its place, unless another has it.
fn published(from: &Path, place: &Path, outcome: &PointOutcome) -> LoadCaseEnd {
    match disk::rename(from, place) {
        Ok(()) => {
            disk::sync_directory(place.parent().unwrap_or(Path::new(".")));
            let state = outcome.as_ref().map(|run| run.info.state);
            LoadCaseEnd::Computed(state.unwrap_or(RunState::Failed))
        }
        // The own one goes with its directory.
        Err(_) if is_taken(place) => LoadCaseEnd::Before,
        Err(error) => LoadCaseEnd::Unstored(format!(
            "its run cannot take its place {}: {error}",
            visible::path(place)
        )),
    }
}

/// The directory in which a part computes; removed with all that did not take its place.
#[derive(Debug)]
struct OwnDirectory {
    dir: PathBuf,
    _lock: Option<DirectoryLock>,
}

impl OwnDirectory {
    fn make(folder: &SweepFolder, part: SweepPart) -> Result<Self, SweepError> {
        let tasks = folder.make_room_for_parts()?;
        let mut count = 1_u64;
        loop {
            let dir = tasks.join(format!("{}-{}.{count}", part.first, part.last));
            match disk::create_dir(&dir) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => count += 1,
                Err(source) => return Err(SweepError::Io { file: dir, source }),
                Ok(()) => {
                    let _lock = lock_directory(&dir);
                    return Ok(Self { dir, _lock });
                }
            }
        }
    }
}

impl Drop for OwnDirectory {
    fn drop(&mut self) {
        // Best effort: what stays goes when the sweep is gathered.
        let _ = disk::remove_dir_all(&self.dir);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_two_numbers_that_begin_at_one() {
        assert_eq!(
            "1..250".parse(),
            Ok(SweepPart {
                first: 1,
                last: 250
            })
        );
        assert_eq!("7..7".parse(), Ok(SweepPart { first: 7, last: 7 }));
        for wrong in [
            "", "1", "0..3", "3..2", "a..b", "-1..3", "1..", "1...3", "1..2..3",
        ] {
            assert!(wrong.parse::<SweepPart>().is_err(), "{wrong}");
        }
    }
}
