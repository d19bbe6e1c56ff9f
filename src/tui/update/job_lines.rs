//! The lines of the list of jobs.

use crate::state::job_process::JobProcess;
use crate::state::{AppState, JobLine, JobNumber, JobPurpose, JobState, RunEntry, RunStatus};
use std::path::Path;

pub(super) fn job_line(
    ticket: JobNumber,
    name: String,
    purpose: JobPurpose,
    state: JobState,
) -> JobLine {
    JobLine {
        ticket,
        name,
        purpose,
        state,
        progress: crate::run::Progress::default(),
        process: None,
    }
}

/// Sets job and run to a state.
pub(super) fn set_state(state: &mut AppState, ticket: JobNumber, new: JobState) {
    if let Some(slot) = slot(state, ticket) {
        slot.state = RunStatus::Job(new.clone());
    }
    if let Some(line) = state.jobs.get_mut(ticket) {
        line.state = new;
    }
}

pub(super) fn slot(state: &mut AppState, ticket: JobNumber) -> Option<&mut RunEntry> {
    state
        .runs_view_mut()?
        .runs
        .newest_mut(|run| run.ticket == Some(ticket))
}

pub(super) fn process_mut(state: &mut AppState, ticket: JobNumber) -> Option<&mut JobProcess> {
    state.jobs.get_mut(ticket)?.process.as_deref_mut()
}

/// A process has a directory for its results.
pub(super) fn has_results(state: &mut AppState, ticket: JobNumber, dir: &Path) {
    if let Some(process) = process_mut(state, ticket) {
        process.results = Some(dir.to_owned());
    }
}
