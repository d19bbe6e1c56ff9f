//! Jobs as they are listed: each with its state in words, and what can be done about one that was killed.

use std::path::{Path, PathBuf};

use serde::de::IgnoredAny;

use super::folder::{JobFolder, JobFolderState};
use super::jobs_dir::JobsDir;
use super::spec::{JobSpec, plain};
use super::status::{JobPhase, JobStatus};
use crate::run::Checkpoint;
use crate::run::store::{StoreError, sealed_checkpoint};
use crate::visible;

/// How long a job that has ended is kept for somebody to see it \[s\].
const KEPT_S: u64 = 7 * 24 * 3600;

/// A job as it is listed.
#[derive(Debug, Clone)]
pub struct JobEntry {
    /// Its folder.
    pub folder: JobFolder,
    /// Its host, where that is another one.
    pub host: Option<String>,
    /// What it computes, unless that cannot be read.
    pub spec: Result<JobSpec, String>,
    /// How it is found. Of another host it is what its files say.
    pub state: JobFolderState,
    /// What it said last.
    pub status: Option<JobStatus>,
}

impl JobEntry {
    /// The job in a folder of this host.
    #[must_use]
    pub fn here(folder: JobFolder) -> Self {
        let state = folder.state();
        let status = match &state {
            JobFolderState::Ended(status) | JobFolderState::Killed(status) => Some(status.clone()),
            JobFolderState::NotBegun | JobFolderState::Held => folder.status(),
        };
        Self {
            spec: folder.spec().map_err(|error| error.to_string()),
            host: None,
            folder,
            state,
            status,
        }
    }

    fn elsewhere(host: String, folder: JobFolder) -> Self {
        let status = folder.status();
        let state = match &status {
            Some(status) if status.phase.has_ended() => JobFolderState::Ended(status.clone()),
            Some(_) => JobFolderState::Held,
            None => JobFolderState::NotBegun,
        };
        Self {
            spec: folder.spec().map_err(|error| error.to_string()),
            host: Some(host),
            folder,
            state,
            status,
        }
    }

    /// All jobs of the user: those of this host, the oldest first, then those of others.
    #[must_use]
    pub fn all(jobs: &JobsDir) -> Vec<Self> {
        let here = jobs.jobs().into_iter().map(Self::here);
        here.chain(Self::all_elsewhere(jobs)).collect()
    }

    /// The jobs of the user on other hosts with the same home.
    #[must_use]
    pub fn all_elsewhere(jobs: &JobsDir) -> Vec<Self> {
        let others = jobs.of_other_hosts().into_iter();
        others
            .map(|(host, folder)| Self::elsewhere(host, folder))
            .collect()
    }

    /// What it computes, in words.
    #[must_use]
    pub fn name(&self) -> &str {
        self.spec.as_ref().map_or("?", |spec| &spec.name)
    }

    /// Its phase in a word: `killed` where its process ended without one.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match &self.state {
            JobFolderState::NotBegun => JobPhase::Queued.word(),
            JobFolderState::Held => {
                let phase = self.status.as_ref().map(|status| status.phase);
                phase.unwrap_or(JobPhase::Queued).word()
            }
            JobFolderState::Ended(status) => status.phase.word(),
            JobFolderState::Killed(_) => "killed",
        }
    }

    /// Where its results are, as seen from the directory that this program works in.
    #[must_use]
    pub fn results(&self) -> Option<PathBuf> {
        let results = self.status.as_ref()?.results.as_ref()?;
        let spec = self.spec.as_ref().ok()?;
        Some(results_from_here(spec, results))
    }

    /// How far it is, why it failed, or what can be done about it.
    #[must_use]
    pub fn details(&self) -> String {
        if let Err(why) = &self.spec {
            return why.clone();
        }
        let words = match (&self.state, &self.status) {
            (JobFolderState::Killed(_), _) => self.killed_words(),
            (JobFolderState::Ended(status), _) => status.message.clone().unwrap_or_default(),
            (_, Some(status)) => status.progress_words(),
            (_, None) => String::new(),
        };
        match (&self.host, &self.status) {
            (Some(host), Some(status)) => {
                let age = age(status.age_s());
                let parts = [format!("on {host}"), words, format!("{age} ago")];
                let said: Vec<String> = parts.into_iter().filter(|w| !w.is_empty()).collect();
                said.join(", ")
            }
            (Some(host), None) => format!("on {host}"),
            _ => words,
        }
    }

    /// What can be done about a job whose process ended without a word.
    #[must_use]
    pub fn killed_words(&self) -> String {
        let is_sweep = self.spec.as_ref().is_ok_and(JobSpec::is_sweep);
        match self.results() {
            None => "nothing was stored".to_owned(),
            Some(_) if is_sweep => "goes on when started again".to_owned(),
            Some(dir) => match resumable_from(&dir) {
                Ok(time) => format!("resumable from t = {time:.1} s"),
                Err(why) => why,
            },
        }
    }

    /// Whether it has ended so long ago that nobody looks for it any more.
    #[must_use]
    pub fn is_forgotten(&self) -> bool {
        let has_ended = matches!(
            self.state,
            JobFolderState::Ended(_) | JobFolderState::Killed(_)
        );
        let status = self.status.as_ref();
        self.host.is_none() && has_ended && status.is_some_and(|status| status.age_s() > KEPT_S)
    }
}

/// Where results are, as seen from the directory that this program works in.
#[must_use]
pub fn results_from_here(spec: &JobSpec, results: &Path) -> PathBuf {
    let is_same = std::env::current_dir().is_ok_and(|here| here == spec.directory);
    match is_same {
        true => results.to_owned(),
        false => plain(&spec.directory, results),
    }
}

/// The time that a run can be resumed from \[s\].
///
/// # Errors
/// It cannot, in words.
fn resumable_from(dir: &Path) -> Result<f64, String> {
    match sealed_checkpoint::<Checkpoint<IgnoredAny>>(dir) {
        Ok((checkpoint, _)) => Ok(checkpoint.time()),
        // It has a case and is computed from its start.
        Err(StoreError::NoCheckpoint(_)) if dir.is_dir() => Ok(0.0),
        Err(error) => Err(visible::line(&error.to_string()).into_owned()),
    }
}

/// A duration in words of one unit.
#[must_use]
pub fn age(seconds: u64) -> String {
    match seconds {
        ..120 => format!("{seconds} s"),
        120..7_200 => format!("{} min", seconds / 60),
        7_200..172_800 => format!("{} h", seconds / 3_600),
        _ => format!("{} days", seconds / 86_400),
    }
}

#[cfg(test)]
mod tests {
    use super::age;

    #[test]
    fn ages_are_read_at_a_glance() {
        let words = [0, 119, 120, 7_199, 7_200, 172_800].map(age);
        assert_eq!(words, ["0 s", "119 s", "2 min", "119 min", "2 h", "2 days"]);
    }
}
