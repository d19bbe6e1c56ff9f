//! Trials of hard cases: computed in the background, their table filled row by row.

use super::job_lines;
use super::notice::info;
use crate::case::attachments::with_files;
use crate::msg::Effect;
use crate::state::trials::{TrialProgress, Trials, TrialsOf};
use crate::state::{AppState, Document, DocumentContent, JobNumber, JobPurpose, JobState};
use crate::study::tally;
use crate::table_pane::TablePane;

/// Shows the trials of the open case, or those of all cases listed; computes them unless they are done or running.
pub fn show(state: &mut AppState) -> Vec<Effect> {
    let of_document = state.document.as_ref().and_then(of_document);
    let listed = state.cases.entries.iter().map(|entry| entry.path.clone());
    let of = of_document.unwrap_or_else(|| TrialsOf::Files(listed.collect()));
    match &mut state.trials {
        Some(known) if known.of == of && !known.stopped => {
            known.shown = true;
            Vec::new()
        }
        _ => begin(state, of),
    }
}

/// Those of the open file, as edited; nothing of a kind without trials.
fn of_document(document: &Document) -> Option<TrialsOf> {
    let files = match &document.content {
        DocumentContent::Line(line) => &line.case.files,
        DocumentContent::System(system) => &system.solved.file.files,
        _ => return None,
    };
    let editor = &document.editor;
    Some(TrialsOf::Case {
        file: editor.file.clone(),
        text: with_files(&editor.text, files).into_owned(),
    })
}

/// Computes trials, in the place of those before.
pub fn begin(state: &mut AppState, of: TrialsOf) -> Vec<Effect> {
    let mut effects: Vec<Effect> = stop(state);
    let ticket = state.jobs.ticket();
    let name = match &of {
        TrialsOf::Case { file, .. } => format!("trials of {file}"),
        TrialsOf::Files(_) => "trials of all hard cases".to_owned(),
    };
    let line = job_lines::job_line(ticket, name, JobPurpose::Trials, JobState::Running);
    state.jobs.lines.push(line);
    state.trials = Some(Trials {
        of: of.clone(),
        ticket,
        progress: TrialProgress::default(),
        stopped: false,
        shown: true,
        pane: TablePane::default(),
    });
    effects.push(Effect::StartTrials { ticket, of });
    effects
}

/// Stops trials that are on their way.
pub fn stop(state: &mut AppState) -> Vec<Effect> {
    let Some(trials) = state.trials.as_mut().filter(|t| t.running()) else {
        return Vec::new();
    };
    trials.stopped = true;
    trials.progress.over = true;
    let ticket = trials.ticket;
    job_lines::set_state(state, ticket, JobState::Cancelled);
    vec![Effect::Cancel(ticket)]
}

/// How far the trials are; dropped where nothing waits for them any more.
pub(super) fn progress(
    state: &mut AppState,
    ticket: JobNumber,
    progress: TrialProgress,
) -> Vec<Effect> {
    let Some(trials) = &mut state.trials else {
        return Vec::new();
    };
    if trials.ticket != ticket || !trials.running() {
        return Vec::new();
    }
    let over = progress.over;
    let words = tally(&progress.findings).to_string();
    if let Some(line) = state.jobs.get_mut(ticket) {
        line.progress.time = progress.done as f64;
        line.progress.duration = progress.all as f64;
        line.progress.steps = progress.done as u64;
    }
    trials.progress = progress;
    if over {
        job_lines::set_state(state, ticket, JobState::Done);
        info(state, format!("{words}."));
    }
    Vec::new()
}
