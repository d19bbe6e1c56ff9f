//! The folder of a job: its request from the beginning, the lock of the process that computes it, and what the job says of itself.
//!
//! It appears whole under its name, and goes in one step too.

use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::identity::ProcessIdentity;
use super::jobs_dir::{JobError, check_private, hidden_name};
use super::spec::JobSpec;
use super::status::JobStatus;
use crate::files::lock::{self, LockFile};
use crate::files::shallow::shallow;
use crate::files::{WriteTarget, disk, read};
use crate::strays::Hidden;
use crate::visible;

pub(super) const REQUEST: &str = "request.toml";
pub(super) const CASE: &str = "case.toml";
const STATUS: &str = "status.toml";
const LOCK: &str = "lock";
const WAITING: &str = "waiting";
const LOG: &str = "log";
const SOCKET: &str = "socket";

/// Everything that the folder of a job may hold.
pub(super) const FILES: [&str; 7] = [REQUEST, CASE, STATUS, LOCK, WAITING, LOG, SOCKET];

/// What the lock of a job says.
#[derive(Debug, Serialize, Deserialize)]
struct LockText {
    /// The process that computes the job.
    process: ProcessIdentity,
    /// Whether the file system knows locks.
    is_exclusive: bool,
}

/// How a folder is found.
#[derive(Debug, Clone, PartialEq)]
pub enum JobFolderState {
    /// No process has begun to compute it.
    NotBegun,
    /// A process holds it.
    Held,
    /// It has ended, and says how.
    Ended(JobStatus),
    /// Its process ended without a word, after this one.
    Killed(JobStatus),
}

/// The folder of a job.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JobFolder {
    /// Where it is.
    pub path: PathBuf,
    /// The number of the job on its host.
    pub number: u64,
}

impl JobFolder {
    pub(super) const fn at(path: PathBuf, number: u64) -> Self {
        Self { path, number }
    }

    /// The folder at a path.
    ///
    /// # Errors
    /// It is none, or not the user's own.
    pub fn open(path: &Path) -> Result<Self, JobError> {
        check_private(path)?;
        let name = path.file_name().and_then(OsStr::to_str);
        let number = name.and_then(|name| name.parse().ok());
        let number = number.ok_or_else(|| JobError::Damaged {
            path: path.to_owned(),
            reason: "the folder of a job is named by its number".to_owned(),
        })?;
        Ok(Self::at(path.to_owned(), number))
    }

    /// Whether it is there, the user's own.
    #[must_use]
    pub fn exists(&self) -> bool {
        check_private(&self.path).is_ok()
    }

    /// What is to be computed.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn spec(&self) -> Result<JobSpec, JobError> {
        let path = self.path.join(REQUEST);
        let text = read::text(&path).map_err(JobError::io(&path))?;
        toml::from_str(shallow(&text)).map_err(|error| JobError::Damaged {
            reason: error.message().to_owned(),
            path,
        })
    }

    /// The text of its case; none of a job that resumes a run.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        read::text(&self.path.join(CASE)).ok()
    }

    /// What the job says of itself, once it has said anything.
    #[must_use]
    pub fn status(&self) -> Option<JobStatus> {
        let text = read::text(&self.path.join(STATUS)).ok()?;
        toml::from_str(shallow(&text)).ok()
    }

    /// Writes what the job says of itself.
    ///
    /// # Errors
    /// The system refuses, or the folder is gone.
    pub(super) fn write_status(&self, status: &JobStatus) -> io::Result<()> {
        let text = toml::to_string(status).map_err(io::Error::other)?;
        let text = visible::toml(&text);
        Ok(WriteTarget::replacing(&self.path.join(STATUS)).write(text.as_bytes())?)
    }

    /// Takes the job for this process; nothing where another has it.
    ///
    /// # Errors
    /// The system refuses.
    pub(super) fn take(&self) -> io::Result<Option<LockFile>> {
        let Some(mut lock) = LockFile::take(&self.path.join(LOCK))? else {
            return Ok(None);
        };
        let other = lock_text(&lock.text()).filter(|other| !other.is_exclusive);
        if other.is_some_and(|other| other.process.is_alive()) {
            return Ok(None);
        }
        let said = LockText {
            process: ProcessIdentity::own(),
            is_exclusive: lock.is_exclusive(),
        };
        lock.write(&toml::to_string(&said).map_err(io::Error::other)?)?;
        Ok(Some(lock))
    }

    /// The process that took the job last.
    #[must_use]
    pub fn process(&self) -> Option<ProcessIdentity> {
        Some(self.lock_text()?.process)
    }

    fn lock_text(&self) -> Option<LockText> {
        lock_text(&read::text(&self.path.join(LOCK)).ok()?)
    }

    /// Whether a process of this host has the job.
    #[must_use]
    pub fn is_held(&self) -> bool {
        lock::is_held(&self.path.join(LOCK))
            || self
                .lock_text()
                .is_some_and(|lock| !lock.is_exclusive && lock.process.is_alive())
    }

    /// Says that the job waits for its turn, until what is returned is dropped.
    pub(super) fn wait_in_line(&self) -> io::Result<Option<LockFile>> {
        LockFile::take(&self.path.join(WAITING))
    }

    /// Whether a process waits with it for its turn.
    pub(super) fn is_waiting(&self) -> bool {
        lock::is_held(&self.path.join(WAITING))
    }

    /// How it is found, on this host.
    #[must_use]
    pub fn state(&self) -> JobFolderState {
        if self.is_held() {
            return JobFolderState::Held;
        }
        // Read after the lock was found free: what the process said last is there then.
        match self.status() {
            None => JobFolderState::NotBegun,
            Some(status) if status.phase.has_ended() => JobFolderState::Ended(status),
            // It waited, or read its case: nothing is lost when another process begins anew.
            Some(status) if status.results.is_none() => JobFolderState::NotBegun,
            Some(status) => JobFolderState::Killed(status),
        }
    }

    /// Where its process listens.
    #[must_use]
    pub(super) fn socket(&self) -> PathBuf {
        self.path.join(SOCKET)
    }

    /// Where its process writes what goes wrong.
    #[must_use]
    pub fn log(&self) -> PathBuf {
        self.path.join(LOG)
    }

    /// Removes the folder in one step. One that is gone is no error.
    ///
    /// # Errors
    /// The system refuses.
    pub fn remove(&self) -> io::Result<()> {
        let parent = self.path.parent().unwrap_or(Path::new("."));
        let hidden = parent.join(hidden_name(self.number, Hidden::DeletedRun));
        match disk::rename(&self.path, &hidden) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            renamed => renamed.and_then(|()| disk::remove_dir_all(&hidden)),
        }
    }
}

fn lock_text(text: &str) -> Option<LockText> {
    toml::from_str(shallow(text)).ok()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    use super::super::jobs_dir::tests::{jobs_dir, submission};
    use super::*;
    use crate::JobPhase;

    #[test]
    fn a_folder_says_how_its_job_is() {
        let dir = tempfile::tempdir().unwrap();
        let folder = jobs_dir(dir.path()).submit(&submission()).unwrap();
        assert_eq!(folder.state(), JobFolderState::NotBegun);
        let lock = folder.take().unwrap().unwrap();
        assert_eq!(folder.process(), Some(ProcessIdentity::own()));
        assert_eq!(folder.state(), JobFolderState::Held);
        assert!(folder.take().unwrap().is_none());
        folder
            .write_status(&JobStatus::new(JobPhase::Running))
            .unwrap();
        assert_eq!(folder.state(), JobFolderState::Held);
        drop(lock);
        assert_eq!(folder.state(), JobFolderState::NotBegun);
        let running = JobStatus {
            results: Some("runs/small-1".into()),
            ..JobStatus::new(JobPhase::Running)
        };
        folder.write_status(&running).unwrap();
        assert_eq!(folder.state(), JobFolderState::Killed(running));
        let done = JobStatus::new(JobPhase::Done);
        folder.write_status(&done).unwrap();
        assert_eq!(folder.state(), JobFolderState::Ended(done));
    }

    #[test]
    fn a_process_that_is_there_has_the_job_where_the_file_system_has_no_locks() {
        let dir = tempfile::tempdir().unwrap();
        let folder = jobs_dir(dir.path()).submit(&submission()).unwrap();
        let write = |process| {
            let text = LockText {
                process,
                is_exclusive: false,
            };
            fs::write(folder.path.join(LOCK), toml::to_string(&text).unwrap()).unwrap();
        };
        write(ProcessIdentity::own());
        assert!(folder.is_held() && folder.take().unwrap().is_none());
        write(ProcessIdentity {
            boot: "an earlier one".to_owned(),
            ..ProcessIdentity::own()
        });
        assert!(!folder.is_held() && folder.take().unwrap().is_some());
    }

    #[test]
    fn what_others_can_write_is_refused() {
        let dir = tempfile::tempdir().unwrap();
        let jobs = jobs_dir(dir.path());
        let folder = jobs.submit(&submission()).unwrap();
        assert!(JobFolder::open(&folder.path).is_ok());
        fs::set_permissions(&folder.path, fs::Permissions::from_mode(0o770)).unwrap();
        let refused = JobFolder::open(&folder.path).unwrap_err().to_string();
        assert!(refused.contains("can be written by others"), "{refused}");
        assert!(!folder.exists() && jobs.job(1).is_none());
        let link = jobs.path().join("7");
        std::os::unix::fs::symlink(jobs.path(), &link).unwrap();
        assert!(JobFolder::open(&link).is_err());
    }
}
