//! What jobs say, and what follows when they end.

use std::sync::Arc;

use super::end::quit_if_asked;
use super::job_lines::{set_state, slot};
use super::jobs::start_waiting;
use super::runs;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::run::job::JobEvent;
use crate::run::{Progress, Run, RunState};
use crate::state::runs_view::CoarseAnswer;
use crate::state::{AppState, Document, JobNumber, JobState, RunCurves, Severity};

/// An event of a job. Events of jobs that nothing waits for any more are dropped.
pub(super) fn event(state: &mut AppState, ticket: JobNumber, event: JobEvent) -> Vec<Effect> {
    if state
        .jobs
        .get_mut(ticket)
        .is_none_or(|l| !l.state.is_open())
    {
        return Vec::new();
    }
    let live = is_live(state, ticket);
    match event {
        JobEvent::Finished(run) => return finished(state, ticket, Arc::from(run), live),
        JobEvent::Searching(search) => {
            if let Some(line) = state.jobs.get_mut(ticket) {
                line.progress.search = Some(search);
            }
        }
        JobEvent::Started { channels, .. } => {
            if let Some(line) = state.jobs.get_mut(ticket) {
                line.progress.search = None;
            }
            if let Some(curves) = curves(state, ticket, live) {
                curves.begin(channels);
            }
        }
        JobEvent::Frame(frame) => {
            if let Some(line) = state.jobs.get_mut(ticket) {
                line.progress = frame.progress;
            }
            if let Some(curves) = curves(state, ticket, live) {
                curves.push(&frame);
            }
        }
        JobEvent::Case(_) | JobEvent::Checkpoint(_) => {}
        JobEvent::Estimating => {
            if let Some(line) = state.jobs.get_mut(ticket) {
                line.progress.estimating = true;
            }
            if let Some(curves) = curves(state, ticket, live) {
                curves.progress.estimating = true;
            }
        }
    }
    Vec::new()
}

/// What a job has recorded since it was last asked; dropped where nothing waits for it any more.
pub(super) fn recorded(state: &mut AppState, ticket: JobNumber, later: &RunCurves) -> Vec<Effect> {
    let Some(line) = state.jobs.get_mut(ticket).filter(|l| l.state.is_open()) else {
        return Vec::new();
    };
    line.progress = Progress {
        estimating: line.progress.estimating,
        ..later.progress
    };
    let progress = line.progress;
    let live = is_live(state, ticket);
    if let Some(curves) = curves(state, ticket, live) {
        curves.append(later);
        curves.progress = progress;
    }
    Vec::new()
}

/// A coarse run ahead of the live solve; dropped where that is not waited for any more.
pub(super) fn coarse(state: &mut AppState, ticket: JobNumber, run: Arc<Run>) -> Vec<Effect> {
    if is_live(state, ticket)
        && let Some(view) = state.runs_view_mut()
    {
        view.live.coarse = Some(CoarseAnswer {
            curves: RunCurves::whole(run),
            text: view.live.going_text.clone(),
        });
    }
    Vec::new()
}

/// Whether a job is the live solve of what is open.
fn is_live(state: &AppState, ticket: JobNumber) -> bool {
    state
        .runs_view()
        .is_some_and(|view| view.live.ticket == Some(ticket))
}

fn curves(state: &mut AppState, ticket: JobNumber, live: bool) -> Option<&mut RunCurves> {
    if live {
        return state.runs_view_mut()?.live.going.as_mut();
    }
    Some(&mut slot(state, ticket)?.curves)
}

fn finished(state: &mut AppState, ticket: JobNumber, run: Arc<Run>, live: bool) -> Vec<Effect> {
    let failure = run
        .info
        .failure
        .clone()
        .unwrap_or_else(|| "no reason given".to_owned());
    let new = match run.info.state {
        RunState::Done => JobState::Done,
        RunState::Cancelled => JobState::Cancelled,
        RunState::Failed | RunState::Partial => JobState::Failed(failure.clone()),
    };
    set_state(state, ticket, new.clone());
    if live {
        live_finished(state, run, &new);
    } else if let Some(slot) = slot(state, ticket) {
        slot.cost = Some((run.info.work.steps, run.info.cost.cpu_s));
        slot.curves.finish(run);
    }
    match new {
        JobState::Failed(why) => state.say(Severity::Error, format!("The run failed: {why}")),
        JobState::Done if !live => said_done(state, ticket),
        _ => {}
    }
    runs::check(state);
    let mut effects = start_waiting(state);
    if !live {
        effects.push(Effect::RefreshRuns);
    }
    effects.extend(quit_if_asked(state));
    effects
}

fn live_finished(state: &mut AppState, run: Arc<Run>, new: &JobState) {
    let document = state.document.as_mut();
    let Some((view, editor)) = document.and_then(Document::runs_and_editor) else {
        return;
    };
    let of_file = view.live.going_text == editor.saved;
    let live = &mut view.live;
    live.ticket = None;
    live.going = None;
    match new {
        // A cancelled solve leaves the old curve as it was, and the coarse answer, which is marked as such.
        JobState::Cancelled => live.failure = Some("cancelled".to_owned()),
        _ => {
            live.coarse = None;
            if view.against.is_none() && *new == JobState::Done && of_file {
                view.against = Some(("the file's".to_owned(), Arc::clone(&run)));
            }
            live.done = Some(RunCurves::whole(run));
            live.done_text = std::mem::take(&mut live.going_text);
            live.kept = None;
            live.failure = match new {
                JobState::Failed(why) => Some(why.clone()),
                _ => None,
            };
        }
    }
}

fn said_done(state: &mut AppState, ticket: JobNumber) {
    let left = state.jobs.open();
    let line = state.line().is_some();
    let [charts, validation, report] =
        [PaneId::Charts, PaneId::Validation, PaneId::Report].map(|pane| state.number_of(pane));
    let Some(slot) = slot(state, ticket) else {
        return;
    };
    let id = &slot.id;
    let run = slot.curves.run.as_ref();
    let happened = run.map_or(&[][..], |run| &run.info.happened);
    let events: String = happened.iter().map(|event| format!(" {event}.")).collect();
    let text = match left {
        0 if line => {
            format!(
                "{id} is done. `{validation}` shows the validation table, `{report}` the report."
            )
        }
        0 => format!("{id} is done.{events} `{charts}` shows its curves, `{report}` the report."),
        _ => format!("{id} is done; {left} runs to go."),
    };
    state.say(Severity::Info, text);
}

/// A job could not be started or stored.
pub(super) fn failed(state: &mut AppState, ticket: JobNumber, reason: String) -> Vec<Effect> {
    if state
        .jobs
        .get_mut(ticket)
        .is_none_or(|l| !l.state.is_open())
    {
        state.say(Severity::Error, reason);
        return Vec::new();
    }
    set_state(state, ticket, JobState::Failed(reason.clone()));
    if is_live(state, ticket)
        && let Some(view) = state.runs_view_mut()
    {
        view.live.ticket = None;
        view.live.going = None;
        view.live.failure = Some(reason.clone());
    }
    state.say(Severity::Error, reason);
    let mut effects = start_waiting(state);
    effects.extend(quit_if_asked(state));
    effects
}
