//! Jobs that other screens have started, as they are shown.

use crate::case::TextDigest;
use crate::jobs::list::JobEntry;
use crate::jobs::{JobFolderState as FolderState, JobPhase, JobSpec};
use crate::state::JobState;
use crate::state::job_process::{FoundJob, JobProcess};

use super::ended::state_of;

/// The state of a job of this host.
pub(super) fn found_state(entry: &JobEntry) -> JobState {
    match (&entry.spec, &entry.state) {
        (Err(why), _) => JobState::Failed(why.clone()),
        (_, FolderState::NotBegun) => JobState::Queued,
        (_, FolderState::Held) => match entry.status.as_ref().map(|status| status.phase) {
            Some(JobPhase::Running) => JobState::Running,
            _ => JobState::Queued,
        },
        (_, FolderState::Ended(status)) => state_of(status),
        (_, FolderState::Killed(_)) => JobState::Killed(entry.killed_words()),
    }
}

/// A job as it is shown that others have started.
pub(super) fn found_job(entry: &JobEntry, state: JobState) -> FoundJob {
    let spec = entry.spec.as_ref().ok();
    let text = entry.folder.text().unwrap_or_default();
    let progress = entry.status.as_ref().and_then(|status| status.progress);
    FoundJob {
        name: entry.name().to_owned(),
        is_sweep: spec.is_some_and(JobSpec::is_sweep),
        process: JobProcess {
            number: Some(entry.folder.number),
            host: entry.host.clone(),
            case: spec.map(|spec| spec.case.clone()).unwrap_or_default(),
            label: spec.map(|spec| spec.label.clone()).unwrap_or_default(),
            text: TextDigest::of_text(&text),
            method: String::new(),
            duration_s: progress.map_or(0.0, |progress| progress.duration),
            results: entry.results(),
        },
        state,
        progress: progress.unwrap_or_default(),
    }
}
