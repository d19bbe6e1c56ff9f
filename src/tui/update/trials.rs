//! Trials of hard cases: computed in the background, their table filled row by row.

use std::path::PathBuf;

use super::{export, info, jobs, overlay};
use crate::case;
use crate::study::tally;
use crate::tui::command::Id;
use crate::tui::msg::Effect;
use crate::tui::state::trials::{TrialProgress, Trials, TrialsOf};
use crate::tui::state::{AppState, JobState, Purpose, Ticket};
use crate::tui::table_pane::TablePane;

/// Columns of the table in a file.
const PAPER_WIDTH: usize = 160;

/// Shows the trials of the open case, or those of all cases listed; computes them unless that is done or on its way.
pub(super) fn show(state: &mut AppState) -> Vec<Effect> {
    let of = match &state.open {
        Some(open) => TrialsOf::Case {
            file: open.editor.file.clone(),
            text: case::stand_alone(&open.editor.text, &open.case).into_owned(),
        },
        None => TrialsOf::Files(state.cases.entries.iter().map(|e| e.path.clone()).collect()),
    };
    match &mut state.trials {
        Some(known) if known.of == of && !known.stopped => {
            known.shown = true;
            Vec::new()
        }
        _ => begin(state, of),
    }
}

fn begin(state: &mut AppState, of: TrialsOf) -> Vec<Effect> {
    let mut effects: Vec<Effect> = stop(state);
    let ticket = state.jobs.ticket();
    let name = match &of {
        TrialsOf::Case { file, .. } => format!("trials of {file}"),
        TrialsOf::Files(_) => "trials of all hard cases".to_owned(),
    };
    let line = jobs::line(ticket, name, Purpose::Trials, JobState::Running);
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
pub(super) fn stop(state: &mut AppState) -> Vec<Effect> {
    let Some(trials) = state.trials.as_mut().filter(|t| t.running()) else {
        return Vec::new();
    };
    trials.stopped = true;
    trials.progress.over = true;
    let ticket = trials.ticket;
    jobs::set_state(state, ticket, JobState::Cancelled);
    vec![Effect::Cancel(ticket)]
}

/// What a command does while trials are seen; absent: the same as everywhere.
pub(super) fn command(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let (by, columns) = (overlay::step(state, id), state.size.0);
    let trials = state.trials.as_mut().filter(|t| t.shown)?;
    let table = trials.table(columns);
    match id {
        Id::Trials => {
            let of = trials.of.clone();
            return Some(begin(state, of));
        }
        Id::Back => trials.shown = false,
        Id::CancelJob | Id::Interrupt if trials.running() => {
            let effects = stop(state);
            info(state, "Stopped; `T` computes the trials anew.");
            return Some(effects);
        }
        Id::ScrollLeft | Id::ScrollRight | Id::Sort => {
            trials.pane.act(export::table_verb(id), &table);
        }
        Id::Write => {
            let tally = tally(&trials.progress.findings);
            let table = trials.table(u16::MAX).to_text(PAPER_WIDTH);
            let text = format!("{table}\n{tally}\n");
            let path = PathBuf::from("hard-cases.txt");
            return Some(export::write(path, Some(text), "The table of trials"));
        }
        _ => trials.pane.act(overlay::by_rows(by?), &table),
    }
    Some(Vec::new())
}

/// How far the trials are; dropped where nobody waits for them any more.
pub(super) fn progress(
    state: &mut AppState,
    ticket: Ticket,
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
        jobs::set_state(state, ticket, JobState::Done);
        info(state, format!("{words}."));
    }
    Vec::new()
}
