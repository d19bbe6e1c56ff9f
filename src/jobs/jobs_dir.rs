//! The directory of all jobs of the user on this host, and what may be in it.
//!
//! `$XDG_STATE_HOME/seacable/jobs/HOST` outlives the login. It holds a [folder](super::folder) for each job, the lock under which numbers are
//! given, and the locks of the jobs that compute. Everything is the user's own: what belongs to somebody else, or others can write, is
//! refused.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use super::folder::{CASE, FILES, JobFolder, REQUEST};
use super::identity::host;
use super::spec::JobSubmission;
use crate::files::lock::LockFile;
use crate::files::{WriteTarget, disk};
use crate::places::state_dir;
use crate::strays::{self, Hidden};
use crate::visible;

/// The lock under which numbers are given; its text is the last one.
const NUMBERS: &str = "numbers";

/// The directory of the locks that the jobs which compute hold.
const SLOTS: &str = "slots";

/// Why jobs cannot be kept or found.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// The place is not the user's own.
    #[error(
        "{} {why}; seacable keeps jobs only where nobody else can write",
        visible::path(path)
    )]
    NotPrivate {
        /// The place.
        path: PathBuf,
        /// What is wrong with it.
        why: &'static str,
    },
    /// The operating system refused.
    #[error("{} cannot be used: {source}", visible::path(path))]
    Io {
        /// The place.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// What a file of the folder says cannot be understood.
    #[error("{} cannot be understood: {reason}", visible::path(path))]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
}

impl JobError {
    pub(super) fn io(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { path, source }
    }
}

/// The jobs of the user on this host, and beside them those on other hosts with the same home.
#[derive(Debug, Clone)]
pub struct JobsDir {
    /// The directory of all hosts.
    all: PathBuf,
    /// That of this host.
    dir: PathBuf,
}

impl JobsDir {
    /// Opens the directory of the jobs, and makes it where it is missing.
    ///
    /// # Errors
    /// It cannot be made or written, or is not the user's own.
    pub fn open() -> Result<Self, JobError> {
        let state = state_dir().map_err(JobError::io(Path::new("the home directory")))?;
        disk::create_dir_all(&state).map_err(JobError::io(&state))?;
        let all = state.join("jobs");
        let dir = all.join(host());
        for path in [&all, &dir] {
            private_dir(path)?;
        }
        Ok(Self { all, dir })
    }

    /// The directory that a job is in.
    pub(super) fn around(folder: &JobFolder) -> Self {
        let above = |path: &Path| path.parent().unwrap_or(Path::new(".")).to_owned();
        let dir = above(&folder.path);
        let all = above(&dir);
        Self { all, dir }
    }

    /// The directory of this host.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.dir
    }

    /// Keeps a request as the newest job. Its process is started by [`launch`](super::launch).
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn submit(&self, submission: &JobSubmission) -> Result<JobFolder, JobError> {
        let numbers = self.dir.join(NUMBERS);
        // Numbers are given one by one, so that they are in the order of the requests.
        let mut last = LockFile::wait(&numbers).map_err(JobError::io(&numbers))?;
        let known = self.numbers().into_iter().max().unwrap_or(0);
        let said = last.text().trim().parse().unwrap_or(0);
        let last_number = known.max(said);
        let number = last_number.checked_add(1).ok_or_else(|| JobError::Damaged {
            path: numbers.clone(),
            reason: format!("job {last_number} leaves no number for another; remove its folder and this file"),
        })?;
        last.write(&number.to_string())
            .map_err(JobError::io(&numbers))?;
        let hidden = self.dir.join(hidden_name(number, Hidden::NewRun));
        let folder = JobFolder::at(self.dir.join(number.to_string()), number);
        let made = fill(&hidden, submission)
            .and_then(|()| disk::rename(&hidden, &folder.path).map_err(JobError::io(&folder.path)));
        if made.is_err() {
            // Best effort: the error that matters is the one already in hand.
            let _ = disk::remove_dir_all(&hidden);
        }
        made.map(|()| folder)
    }

    /// The jobs of this host, the oldest first.
    #[must_use]
    pub fn jobs(&self) -> Vec<JobFolder> {
        let mut numbers = self.numbers();
        numbers.sort_unstable();
        let folder = |number: u64| JobFolder::at(self.dir.join(number.to_string()), number);
        numbers.into_iter().map(folder).collect()
    }

    /// The job of a number.
    #[must_use]
    pub fn job(&self, number: u64) -> Option<JobFolder> {
        let folder = JobFolder::at(self.dir.join(number.to_string()), number);
        folder.exists().then_some(folder)
    }

    /// The jobs of other hosts, by the names of these.
    #[must_use]
    pub fn of_other_hosts(&self) -> Vec<(String, JobFolder)> {
        let Ok(inside) = fs::read_dir(&self.all) else {
            return Vec::new();
        };
        let hosts = inside.flatten().map(|item| item.path());
        let others = hosts.filter(|dir| *dir != self.dir && check_private(dir).is_ok());
        let mut found: Vec<(String, JobFolder)> = others
            .flat_map(|dir| {
                let host = dir.file_name().unwrap_or_default();
                let host = host.to_string_lossy().into_owned();
                let all = self.all.clone();
                let jobs = Self { all, dir }.jobs();
                jobs.into_iter().map(move |job| (host.clone(), job))
            })
            .collect();
        found.sort_by(|a, b| (&a.0, a.1.number).cmp(&(&b.0, b.1.number)));
        found
    }

    /// Removes what processes left that were killed while they made or removed a folder.
    pub fn tidy(&self) {
        strays::remove_of_this_host(&self.dir, &FILES);
    }

    /// The locks of the jobs which compute: one for every core but one.
    ///
    /// # Errors
    /// They cannot be made.
    pub(super) fn slots(&self) -> Result<Vec<PathBuf>, JobError> {
        let dir = self.dir.join(SLOTS);
        private_dir(&dir)?;
        let count = slot_count();
        Ok((0..count).map(|slot| dir.join(slot.to_string())).collect())
    }

    fn numbers(&self) -> Vec<u64> {
        let Ok(inside) = fs::read_dir(&self.dir) else {
            return Vec::new();
        };
        let names = inside.flatten().map(|item| item.file_name());
        let number = |name: OsString| {
            let name = name.to_str()?;
            let number = name.parse::<u64>().ok()?;
            // Not `+7` or `007`, which are the folders of no job.
            (number.to_string() == name).then_some(number)
        };
        names.filter_map(number).collect()
    }
}

/// How many jobs compute at a time.
#[must_use]
pub fn slot_count() -> usize {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    cores.saturating_sub(1).max(1)
}

pub(super) fn hidden_name(number: u64, hidden: Hidden) -> OsString {
    let mut name = strays::prefix(OsStr::new(&number.to_string()));
    name.push(format!("0{}", hidden.suffix()));
    name
}

/// Makes the folder of a request, under a hidden name.
fn fill(hidden: &Path, submission: &JobSubmission) -> Result<(), JobError> {
    disk::create_private_dir(hidden).map_err(JobError::io(hidden))?;
    let write = |name: &str, text: &str| {
        let path = hidden.join(name);
        let written = WriteTarget::new(&path).write(text.as_bytes());
        written.map_err(|error| JobError::io(&path)(error.into()))
    };
    if let Some(text) = &submission.text {
        write(CASE, text)?;
    }
    let text = toml::to_string(&submission.spec).map_err(|error| JobError::Damaged {
        path: hidden.join(REQUEST),
        reason: error.to_string(),
    })?;
    write(REQUEST, &visible::toml(&text))
}

/// Makes a directory of the user's own where it is missing, and checks it.
fn private_dir(path: &Path) -> Result<(), JobError> {
    match disk::create_private_dir(path) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
            Err(JobError::io(path)(error))
        }
        _ => check_private(path),
    }
}

/// Checks that a directory is the user's own, and that nobody else can write in it.
///
/// # Errors
/// It is not.
pub(super) fn check_private(path: &Path) -> Result<(), JobError> {
    let found = path.symlink_metadata().map_err(JobError::io(path))?;
    let why = if !found.is_dir() {
        "is not a directory"
    } else if found.uid() != rustix::process::geteuid().as_raw() {
        "belongs to another user"
    } else if found.mode() & 0o022 != 0 {
        "can be written by others"
    } else {
        return Ok(());
    };
    let path = path.to_owned();
    Err(JobError::NotPrivate { path, why })
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(crate) fn jobs_dir(dir: &Path) -> JobsDir {
        let jobs = JobsDir {
            all: dir.join("jobs"),
            dir: dir.join("jobs/here"),
        };
        private_dir(&jobs.all).unwrap();
        private_dir(&jobs.dir).unwrap();
        jobs
    }

    pub(crate) fn submission() -> JobSubmission {
        let request = super::super::SweepRequest {
            kind: crate::kinds::FileType::Line,
            text: "[case]\n".to_owned(),
            path: "small.toml".into(),
            overrides: Vec::new(),
        };
        JobSubmission::of_sweep(&request, "load cases of small.toml").unwrap()
    }

    #[test]
    fn jobs_are_numbered_in_their_order_and_a_number_is_not_given_twice() {
        let dir = tempfile::tempdir().unwrap();
        let jobs = jobs_dir(dir.path());
        let first = jobs.submit(&submission()).unwrap();
        let second = jobs.submit(&submission()).unwrap();
        second.remove().unwrap();
        second.remove().unwrap();
        let third = jobs.submit(&submission()).unwrap();
        assert_eq!([first.number, second.number, third.number], [1, 2, 3]);
        assert_eq!(jobs.jobs(), [first.clone(), third]);
        assert_eq!(first.spec().unwrap().name, "load cases of small.toml");
        assert_eq!(first.text().as_deref(), Some("[case]\n"));
        assert_eq!(first.path.metadata().unwrap().mode() & 0o777, 0o700);
    }

    #[test]
    fn numbers_do_not_begin_again_after_the_greatest() {
        let dir = tempfile::tempdir().unwrap();
        let jobs = jobs_dir(dir.path());
        let stray = jobs.path().join("+7");
        fs::create_dir(&stray).unwrap();
        assert_eq!(jobs.submit(&submission()).unwrap().number, 1);
        let greatest = jobs.path().join(u64::MAX.to_string());
        fs::create_dir(&greatest).unwrap();
        let refused = jobs.submit(&submission()).unwrap_err().to_string();
        assert!(
            refused.contains("leaves no number for another"),
            "{refused}"
        );
        fs::remove_dir(&greatest).unwrap();
        assert_eq!(jobs.submit(&submission()).unwrap().number, 2);
    }

    #[test]
    fn jobs_of_other_hosts_are_listed_by_their_names() {
        let dir = tempfile::tempdir().unwrap();
        let here = jobs_dir(dir.path());
        let there = JobsDir {
            dir: here.all.join("there"),
            ..here.clone()
        };
        private_dir(&there.dir).unwrap();
        let job = there.submit(&submission()).unwrap();
        assert_eq!(here.of_other_hosts(), [("there".to_owned(), job)]);
        assert!(here.jobs().is_empty());
    }
}
