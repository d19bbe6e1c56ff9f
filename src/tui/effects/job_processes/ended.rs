//! What becomes of a job that has ended: its results are read where they are shown, and its folder goes.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use crate::jobs::list::{JobEntry, results_from_here};
use crate::jobs::{JobFolder, JobPhase, JobSpec, JobStatus};
use crate::msg::Msg;
use crate::run::job::JobEvent;
use crate::run::store;
use crate::state::job_process::ProcessMsg;
use crate::state::sweep_request::SweepMsg;
use crate::state::sweeps::SweepRead;
use crate::state::{JobNumber, JobState};
use crate::study::sweep::SweepSnapshot;

/// A job that has ended.
#[derive(Debug)]
pub(super) struct EndedJob {
    pub(super) ticket: JobNumber,
    pub(super) folder: JobFolder,
    pub(super) spec: JobSpec,
    pub(super) status: JobStatus,
    /// Whether its results are shown.
    pub(super) is_shown: bool,
}

impl EndedJob {
    /// Reads what is shown of it, and removes its folder. For a thread behind the screen.
    pub(super) fn messages(self) -> Vec<Msg> {
        let results = self.status.results.as_ref();
        let results = results.map(|dir| results_from_here(&self.spec, dir));
        let mut messages = Vec::new();
        match results.filter(|_| self.is_shown) {
            Some(dir) if self.spec.is_sweep() => messages.push(self.sweep(&dir)),
            Some(dir) => messages.extend(self.run(dir)),
            None => messages.push(self.is()),
        }
        // What stays is shown once more.
        let _ = self.folder.remove();
        messages
    }

    fn is(&self) -> Msg {
        Msg::Process(ProcessMsg::Is(self.ticket, state_of(&self.status)))
    }

    fn run(&self, dir: PathBuf) -> Vec<Msg> {
        let run = store::read(&dir);
        let stored = Msg::Stored(self.ticket, dir);
        let ended = match run {
            // A run that could not be stored to its end is reported by its job.
            Ok(run) if JobPhase::of_run(run.info.state) == self.status.phase => {
                let finished = JobEvent::Finished(Box::new(run));
                Msg::Job(self.ticket, Box::new(finished))
            }
            Ok(_) => self.is(),
            Err(error) => {
                let why = JobState::Failed(error.to_string());
                Msg::Process(ProcessMsg::Is(self.ticket, why))
            }
        };
        vec![stored, ended]
    }

    fn sweep(&self, dir: &Path) -> Msg {
        let read = || {
            let snapshot = SweepSnapshot::read(dir, &AtomicBool::new(false))?;
            let is_cancelled = self.status.phase == JobPhase::Cancelled;
            Ok((SweepRead::new(snapshot), is_cancelled))
        };
        let ended = match self.status.phase {
            JobPhase::Failed => Err(self.status.message.clone().unwrap_or_default()),
            _ => crate::jobs::on_all_cores_but_one(read),
        };
        Msg::Sweep(SweepMsg::Ended(self.ticket, ended))
    }
}

/// A job whose process ended without a word.
pub(super) fn killed(ticket: JobNumber, folder: &JobFolder) -> Msg {
    let entry = JobEntry::here(folder.clone());
    let words = entry.killed_words();
    let _ = folder.remove();
    Msg::Process(ProcessMsg::Is(ticket, JobState::Killed(words)))
}

/// The end of a job whose folder another screen has removed: as its run says.
pub(super) fn shown_elsewhere(spec: &JobSpec, known: Option<&JobStatus>) -> JobStatus {
    let results = known.and_then(|status| status.results.clone());
    let dir = results.as_ref().map(|dir| results_from_here(spec, dir));
    let info = dir.filter(|_| !spec.is_sweep());
    let info = info.and_then(|dir| store::read_info(&dir).ok());
    let phase = info.as_ref().map(|info| JobPhase::of_run(info.state));
    let unknown = known
        .map(|status| status.phase)
        .filter(|phase| phase.has_ended());
    JobStatus {
        results,
        message: info.and_then(|info| info.failure),
        ..JobStatus::new(phase.or(unknown).unwrap_or(JobPhase::Done))
    }
}

/// The state of a job that says this of itself.
pub(super) fn state_of(status: &JobStatus) -> JobState {
    match status.phase {
        JobPhase::Queued => JobState::Queued,
        JobPhase::Running => JobState::Running,
        JobPhase::Done => JobState::Done,
        JobPhase::Cancelled => JobState::Cancelled,
        JobPhase::Failed => {
            let why = status.message.clone();
            JobState::Failed(why.unwrap_or_else(|| "no reason given".to_owned()))
        }
    }
}
