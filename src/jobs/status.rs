//! What a job says of itself in its folder: its phase, how far it is, where its results are.

use std::path::PathBuf;
use std::time::UNIX_EPOCH;

use serde::{Deserialize, Serialize};

use crate::run::store::{now, rfc3339};
use crate::run::{Progress, RunState};
use crate::study::sweep::SweepProgress;

/// The version of the folder and of what is said over the socket.
pub const VERSION: u32 = 1;

/// Where a job stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum JobPhase {
    /// It waits for its turn.
    Queued,
    /// It computes.
    Running,
    /// It is complete.
    Done,
    /// It gave up.
    Failed,
    /// It was stopped.
    Cancelled,
}

impl JobPhase {
    /// Its word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Done => "done",
            Self::Failed => "failed",
            Self::Cancelled => "cancelled",
        }
    }

    /// Whether it has ended.
    #[must_use]
    pub const fn has_ended(self) -> bool {
        matches!(self, Self::Done | Self::Failed | Self::Cancelled)
    }

    /// The phase of a job whose run ended so.
    #[must_use]
    pub const fn of_run(state: RunState) -> Self {
        match state {
            RunState::Done => Self::Done,
            RunState::Cancelled => Self::Cancelled,
            RunState::Failed | RunState::Partial => Self::Failed,
        }
    }
}

/// How far the load cases of a job are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LoadCaseProgress {
    /// Those that are done.
    #[serde(flatten)]
    pub count: SweepProgress,
    /// Wall time so far \[s\].
    pub wall_s: f64,
}

/// What a job says of itself. Written as `status.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JobStatus {
    /// Version of this description.
    pub version: u32,
    /// Where it stands.
    pub phase: JobPhase,
    /// When it said so, RFC 3339 in UTC.
    pub updated: String,
    /// The same \[s since 1970\].
    pub updated_s: u64,
    /// The directory of its run, or of its sweep, as seen from the directory that the job works in.
    pub results: Option<PathBuf>,
    /// Why it failed.
    pub message: Option<String>,
    /// How far a run is.
    pub progress: Option<Progress>,
    /// How far a sweep is.
    pub load_cases: Option<LoadCaseProgress>,
}

impl JobStatus {
    /// A job in this phase, of which nothing else is known.
    #[must_use]
    pub fn new(phase: JobPhase) -> Self {
        Self {
            version: VERSION,
            phase,
            updated: String::new(),
            updated_s: 0,
            results: None,
            message: None,
            progress: None,
            load_cases: None,
        }
        .dated()
    }

    /// The same, said now.
    #[must_use]
    pub fn dated(mut self) -> Self {
        let at = now();
        self.updated = rfc3339(at);
        let since = at.duration_since(UNIX_EPOCH);
        self.updated_s = since.map_or(0, |since| since.as_secs());
        self
    }

    /// How long ago it was said \[s\], by the clock of this host.
    #[must_use]
    pub fn age_s(&self) -> u64 {
        let since = now().duration_since(UNIX_EPOCH);
        since.map_or(0, |since| since.as_secs().saturating_sub(self.updated_s))
    }

    /// How far it is, in words; empty before it is known.
    #[must_use]
    pub fn progress_words(&self) -> String {
        if let Some(LoadCaseProgress { count, .. }) = self.load_cases {
            return format!("{} of {} load cases", count.done, count.of);
        }
        match self.progress {
            Some(progress) if progress.estimating => "estimating errors".to_owned(),
            Some(Progress {
                search: Some(search),
                ..
            }) => search.to_string(),
            Some(progress) if progress.steps > 0 => {
                let (time, duration) = (progress.time, progress.duration);
                format!("{time:.0} of {duration:.0} s")
            }
            _ => String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::SearchProgress;

    #[test]
    fn a_status_is_read_back_as_it_was_written() {
        let status = JobStatus {
            results: Some("runs/small-1".into()),
            message: Some("no \"equilibrium\"".to_owned()),
            progress: Some(Progress {
                steps: 7,
                search: Some(SearchProgress {
                    round: 2,
                    asked: 1e-3,
                    reached: None,
                }),
                ..Progress::default()
            }),
            load_cases: Some(LoadCaseProgress {
                count: SweepProgress {
                    done: 2,
                    stored: 1,
                    of: 6,
                },
                wall_s: 1.5,
            }),
            ..JobStatus::new(JobPhase::Running)
        };
        let text = toml::to_string(&status).unwrap();
        assert_eq!(toml::from_str::<JobStatus>(&text).unwrap(), status);
        let text = serde_json::to_string(&status).unwrap();
        assert_eq!(serde_json::from_str::<JobStatus>(&text).unwrap(), status);
        assert_eq!(status.progress_words(), "2 of 6 load cases");
    }
}
