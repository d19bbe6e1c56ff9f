//! Whose turn it is: so many jobs compute at a time as there are cores but one, in the order of their numbers. Nobody keeps the queue: each
//! waiting process looks for itself, so that it goes on whoever is killed.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use super::folder::JobFolder;
use super::jobs_dir::{JobError, JobsDir};
use crate::files::lock::LockFile;

/// Between two looks: at first, and at most.
const FIRST: Duration = Duration::from_millis(5);
const LONGEST: Duration = Duration::from_millis(100);

/// Waits until a job may compute, and until what is returned is dropped; nothing where it is cancelled meanwhile.
///
/// # Errors
/// The locks cannot be made.
pub(super) fn wait(
    jobs: &JobsDir,
    folder: &JobFolder,
    cancel: &AtomicBool,
) -> Result<Option<LockFile>, JobError> {
    let slots = jobs.slots()?;
    let line = folder.wait_in_line();
    let _in_line = line.map_err(|source| JobError::Io {
        path: folder.path.clone(),
        source,
    })?;
    let mut pause = FIRST;
    while !cancel.load(Ordering::Relaxed) {
        if !others_are_first(jobs, folder) {
            // A lock that cannot be taken is one that others have.
            let mut free = slots.iter().map(|slot| LockFile::take(slot).ok().flatten());
            if let Some(slot) = free.find_map(|slot| slot) {
                return Ok(Some(slot));
            }
        }
        std::thread::sleep(pause);
        pause = (2 * pause).min(LONGEST);
    }
    Ok(None)
}

/// Whether a job of a lower number waits.
fn others_are_first(jobs: &JobsDir, folder: &JobFolder) -> bool {
    let others = jobs.jobs();
    let mut earlier = others
        .iter()
        .take_while(|other| other.number < folder.number);
    earlier.any(JobFolder::is_waiting)
}
