//! Jobs: the live re-solve, runs asked for; starting and cancelling them.

use super::{info, studies, trials};
use crate::case::{At, Case};
use crate::run::Resume;
use crate::run::job::Request;
use crate::tui::command::Id;
use crate::tui::facade;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::{
    AppState, Curves, JobLine, JobState, OpenCase, Purpose, RunEntry, RunOrigin, RunStatus, Ticket,
    Waiting,
};

pub(super) fn command(state: &mut AppState, id: Id) -> Vec<Effect> {
    match id {
        Id::Run => run(state),
        Id::Study => studies::ask(state),
        Id::Validate => studies::validate(state),
        Id::CancelJob => {
            let ticket = state.jobs.lines.get(state.jobs.cursor).map(|l| l.ticket);
            ticket.map_or_else(Vec::new, |t| cancel(state, t))
        }
        _ => Vec::new(),
    }
}

/// Solves the case as it stands in the background; the newest wins.
pub(super) fn resolve(state: &mut AppState) -> Vec<Effect> {
    let mut effects = Vec::new();
    let ticket = state.jobs.ticket();
    let Some(open) = &mut state.open else {
        return effects;
    };
    let request = request(open, &open.editor.text, open.case.clone(), "live");
    let live = &mut open.live;
    live.going = Some(Curves::default());
    live.going_text.clone_from(&open.editor.text);
    live.failure = None;
    live.hidden = false;
    let name = format!(
        "live: {} ({})",
        open.editor.file,
        facade::method_word(open.case.solver.method)
    );
    if let Some(old) = live.ticket.replace(ticket) {
        effects.push(Effect::Cancel(old));
    }
    // Of live solves only the newest has a line in the list.
    state.jobs.lines.retain(|l| l.purpose != Purpose::Live);
    state
        .jobs
        .lines
        .insert(0, line(ticket, name, Purpose::Live, JobState::Running));
    effects.push(Effect::Start {
        ticket,
        request: Box::new(request),
        from: None,
        store: false,
    });
    effects
}

pub(super) fn line(ticket: Ticket, name: String, purpose: Purpose, state: JobState) -> JobLine {
    JobLine {
        ticket,
        name,
        purpose,
        state,
        progress: crate::run::Progress::default(),
    }
}

fn request(open: &OpenCase, text: &str, case: Case, id: &str) -> Request {
    Request {
        case,
        text: text.to_owned(),
        file: open.editor.file.clone(),
        overrides: overrides(open, text),
        id: id.to_owned(),
    }
}

/// The keys in which a text differs from the file, as `key=value`.
fn overrides(open: &OpenCase, text: &str) -> Vec<String> {
    if text == open.editor.saved {
        return Vec::new();
    }
    let rows = |text: &str| {
        (open.editor.case_of(text)).map_or_else(|_| Vec::new(), |case| facade::rows(text, &case))
    };
    let of_file = rows(&open.editor.saved);
    rows(text)
        .into_iter()
        .filter(|row| {
            of_file
                .iter()
                .find(|old| old.path == row.path)
                .is_none_or(|old| old.value != row.value)
        })
        .map(|row| format!("{}={}", row.path, row.value))
        .collect()
}

fn run(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let (text, case) = (open.editor.text.clone(), open.case.clone());
    // The same curves twice would only hide each other.
    open.live.hidden = true;
    for slot in &mut open.runs {
        slot.shown = false;
    }
    enqueue(state, &text, case, None, true);
    let effects = start_newest(state);
    info(
        state,
        "The run has begun; it is stored under runs/. `2` shows its curves, `6` the jobs.",
    );
    effects
}

/// Puts the cursor on the newest run, and starts what waits.
pub(super) fn start_newest(state: &mut AppState) -> Vec<Effect> {
    if let Some(open) = &mut state.open {
        open.run = open.runs.len();
    }
    start_waiting(state)
}

/// Puts a run of the open case at the end of the queue.
pub(super) fn enqueue(state: &mut AppState, text: &str, case: Case, at: Option<At>, shown: bool) {
    let Some(open) = &state.open else {
        return;
    };
    let label = at
        .as_ref()
        .map_or_else(String::new, |at| facade::at_label(&open.case, at));
    let stem = open.editor.file.trim_end_matches(".toml");
    let request = request(open, text, case, stem);
    queue(state, request, None, label, at, shown);
}

/// Puts a run at the end of the queue, and in the list of runs.
pub(super) fn queue(
    state: &mut AppState,
    request: Request,
    from: Option<Resume>,
    label: String,
    at: Option<At>,
    shown: bool,
) {
    let ticket = state.jobs.ticket();
    let Some(open) = &mut state.open else {
        return;
    };
    let method = facade::method_word(request.case.solver.method).to_owned();
    let stem = request.file.trim_end_matches(".toml");
    let name = joined_label(&[stem, &label, &method]);
    let text = request.text.clone();
    open.runs.push(RunEntry {
        ticket: Some(ticket),
        id: name.clone(),
        label,
        at,
        text,
        kind: RunOrigin::Session,
        state: RunStatus::Queued,
        method,
        dir: None,
        cost: None,
        shown,
        curves: Curves::default(),
    });
    state
        .jobs
        .lines
        .push(line(ticket, name, Purpose::Run, JobState::Queued));
    state.jobs.waiting.push_back(Waiting {
        ticket,
        request: Box::new(request),
        from: from.map(Box::new),
    });
}

/// The parts that say something, joined.
#[must_use]
pub fn joined_label(parts: &[&str]) -> String {
    let parts: Vec<&str> = parts.iter().copied().filter(|p| !p.is_empty()).collect();
    parts.join(", ")
}

/// Starts what waits, as far as there is room.
pub(super) fn start_waiting(state: &mut AppState) -> Vec<Effect> {
    let mut effects = Vec::new();
    while state.jobs.computing() < state.jobs.limit {
        let Some(next) = state.jobs.waiting.pop_front() else {
            break;
        };
        let Waiting {
            ticket,
            request,
            from,
        } = next;
        set_state(state, ticket, JobState::Running);
        effects.push(Effect::Start {
            ticket,
            request,
            from,
            store: true,
        });
    }
    effects
}

/// Cancels the job that the user looks at.
pub(super) fn cancel_focused(state: &mut AppState) -> Vec<Effect> {
    let cursor = state.jobs.cursor;
    let in_jobs = state
        .jobs
        .lines
        .get(cursor)
        .filter(|l| state.focus() == PaneId::Jobs && l.state.is_open());
    let in_runs = state.open.as_ref().and_then(|open| {
        let ticket = open.current_run()?.ticket?;
        let line = state.jobs.lines.iter().find(|l| l.ticket == ticket)?;
        (open.pane == PaneId::Runs && line.state.is_open()).then_some(line)
    });
    let newest = |purpose: Purpose| {
        let mut lines = state.jobs.lines.iter();
        lines.rfind(|l| l.purpose == purpose && l.state == JobState::Running)
    };
    let found = in_jobs
        .or(in_runs)
        .or_else(|| newest(Purpose::Run))
        .or_else(|| newest(Purpose::Trials))
        .or_else(|| newest(Purpose::Live));
    match found.map(|l| (l.ticket, l.name.clone())) {
        Some((ticket, name)) => {
            let effects = cancel(state, ticket);
            info(state, format!("Cancelled {name}. Ctrl-C again quits."));
            effects
        }
        None => info(
            state,
            "Nothing is running. Ctrl-C again quits; so does `q`.",
        ),
    }
}

fn cancel(state: &mut AppState, ticket: Ticket) -> Vec<Effect> {
    if state.trials.as_ref().is_some_and(|t| t.ticket == ticket) {
        return trials::stop(state);
    }
    let was_waiting = state.jobs.waiting.len();
    state.jobs.waiting.retain(|w| w.ticket != ticket);
    if state.jobs.waiting.len() < was_waiting {
        set_state(state, ticket, JobState::Cancelled);
        return Vec::new();
    }
    // A running job still delivers what it has; its last event says that it is cancelled.
    vec![Effect::Cancel(ticket)]
}

/// Sets job and run to a state.
pub(super) fn set_state(state: &mut AppState, ticket: Ticket, new: JobState) {
    let slot_state = match &new {
        JobState::Queued => RunStatus::Queued,
        JobState::Running => RunStatus::Running,
        JobState::Done => RunStatus::Done,
        JobState::Failed(why) => RunStatus::Failed(why.clone()),
        JobState::Cancelled => RunStatus::Cancelled,
    };
    if let Some(slot) = slot(state, ticket) {
        slot.state = slot_state;
    }
    if let Some(line) = state.jobs.get_mut(ticket) {
        line.state = new;
    }
}

pub(super) fn slot(state: &mut AppState, ticket: Ticket) -> Option<&mut RunEntry> {
    let runs = &mut state.open.as_mut()?.runs;
    runs.iter_mut().find(|s| s.ticket == Some(ticket))
}

/// Jobs of the open case end with it; trials go on.
pub(super) fn cancel_all(state: &mut AppState) -> Vec<Effect> {
    state.jobs.waiting.clear();
    let open: Vec<Ticket> = state
        .jobs
        .lines
        .iter_mut()
        .filter(|l| l.state.is_open() && l.purpose != Purpose::Trials)
        .map(|l| {
            l.state = JobState::Cancelled;
            l.ticket
        })
        .collect();
    open.into_iter().map(Effect::Cancel).collect()
}
