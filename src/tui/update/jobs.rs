//! Jobs: the live re-solve, runs asked for; starting and cancelling them.

use std::sync::Arc;

use super::job_lines::{job_line, set_state};
use super::notice::info;
use super::{job_processes, trials};
use crate::case::{Case, StudyPoint, TextDigest};
use crate::facade::{self, FieldRow};
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::run::job::Request;
use crate::state::{
    AppState, Document, DocumentContent, JobLine, JobNumber, JobPurpose, JobRequest, JobState,
    ParameterEditor, QueuedRequest, RunCurves, RunEntry, SystemView,
};
use crate::system::motion::{self, job::SystemRequest};

/// Solves the edited case in the background; the newest wins.
pub(super) fn resolve(state: &mut AppState) -> Vec<Effect> {
    let mut effects = Vec::new();
    let ticket = state.jobs.ticket();
    let document = state.document.as_mut();
    let Some((line, editor)) = document.and_then(Document::line_and_editor) else {
        return effects;
    };
    let request = request(
        editor,
        &editor.text,
        &editor.rows,
        line.case.clone(),
        "live",
    );
    let live = &mut line.runs_view.live;
    live.going = Some(RunCurves::default());
    live.going_text.clone_from(&editor.text);
    live.failure = None;
    live.hidden = false;
    let name = format!("live: {} ({})", editor.file, line.case.solver.method.name());
    if let Some(old) = live.ticket.replace(ticket) {
        effects.push(Effect::Cancel(old));
    }
    // Of live solves only the newest has a line in the list.
    state.jobs.lines.retain(|l| l.purpose != JobPurpose::Live);
    state.jobs.lines.insert(
        0,
        job_line(ticket, name, JobPurpose::Live, JobState::Running),
    );
    effects.push(Effect::Start {
        ticket,
        request: JobRequest::Line(Box::new(request), None),
        store: false,
    });
    effects
}

fn request(
    editor: &ParameterEditor,
    text: &str,
    rows: &[FieldRow],
    case: Case,
    id: &str,
) -> Request {
    let of_file = text == editor.saved;
    Request {
        case,
        text: text.to_owned(),
        file: editor.file.clone(),
        overrides: match of_file {
            true => Vec::new(),
            false => editor.overrides(rows),
        },
        id: id.to_owned(),
    }
}

/// The inputs in which the edited text differs from the file, as `key=value`.
pub(super) fn overrides(editor: &ParameterEditor) -> Vec<String> {
    match editor.unsaved() {
        true => editor.overrides(&editor.rows),
        false => Vec::new(),
    }
}

/// Runs the edited case or system, and stores the run.
pub(super) fn run(state: &mut AppState) -> Vec<Effect> {
    if !enqueue_edited(state) {
        return Vec::new();
    }
    let effects = start_newest(state);
    let words = format!(
        "The run has begun; it is stored under runs/. `{}` shows its curves, `{}` the jobs.",
        state.number_of(PaneId::Charts),
        state.number_of(PaneId::Jobs)
    );
    info(state, words);
    effects
}

/// Puts a run of the edited text at the end of the queue; says whether there is anything to run.
fn enqueue_edited(state: &mut AppState) -> bool {
    let Some(document) = state.document.as_mut() else {
        return false;
    };
    if let Some(view) = document.runs_view_mut() {
        // The same curves twice would only hide each other.
        view.hide_runs();
    }
    let editor = &document.editor;
    match &document.content {
        DocumentContent::Line(line) => {
            let (text, rows, case) = (editor.text.clone(), editor.rows.clone(), line.case.clone());
            enqueue(state, (&text, &rows), case, None, true);
        }
        DocumentContent::System(system) => {
            let Some(request) = system_request(editor, system) else {
                return false;
            };
            let request = JobRequest::System(Box::new(request), None);
            queue(state, request, String::new(), None, true);
        }
        _ => return false,
    }
    true
}

/// The run in time of the edited system.
fn system_request(editor: &ParameterEditor, system: &SystemView) -> Option<SystemRequest> {
    let solved = Arc::clone(&system.solved);
    let request =
        motion::job::request(solved, &editor.text, editor.file.clone(), overrides(editor));
    request.map(|request| SystemRequest {
        id: editor.stem().to_owned(),
        ..request
    })
}

/// Puts the cursor on the newest run, and starts what waits.
pub(super) fn start_newest(state: &mut AppState) -> Vec<Effect> {
    if let Some(view) = state.runs_view_mut() {
        view.runs.go_to_newest();
    }
    start_waiting(state)
}

/// Puts a run of the open case with this text and these fields at the end of the queue; the list of runs is to be arranged after the last.
pub(super) fn enqueue(
    state: &mut AppState,
    (text, rows): (&str, &[FieldRow]),
    case: Case,
    at: Option<StudyPoint>,
    shown: bool,
) {
    let document = state.document.as_mut();
    let Some((line, editor)) = document.and_then(Document::line_and_editor) else {
        return;
    };
    let label = at
        .as_ref()
        .map_or_else(String::new, |at| facade::at_label(&line.case, at));
    let request = request(editor, text, rows, case, editor.stem());
    let request = JobRequest::Line(Box::new(request), None);
    queue(state, request, label, at, shown);
}

/// Puts a run at the end of the queue, and in the list of runs, which is to be arranged after the last.
pub(super) fn queue(
    state: &mut AppState,
    request: JobRequest,
    label: String,
    at: Option<StudyPoint>,
    shown: bool,
) {
    let ticket = state.jobs.ticket();
    if state.runs_view().is_none() {
        return;
    }
    let info = request.initial_info();
    let method = info.settings.method;
    let stem = request.file().trim_end_matches(".toml");
    let name = joined_label(&[stem, &label, &method]);
    let entry = RunEntry {
        ticket: Some(ticket),
        id: name.clone(),
        label,
        at,
        duration_s: info.settings.duration_s,
        shown,
        ..RunEntry::session(TextDigest::of_text(request.text()), method)
    };
    let process = job_processes::of_entry(state, &entry);
    if let Some(view) = state.runs_view_mut() {
        view.runs.push(entry);
    }
    state.jobs.lines.push(JobLine {
        process,
        ..job_line(ticket, name, JobPurpose::Run, JobState::Queued)
    });
    state
        .jobs
        .waiting
        .push_back(QueuedRequest { ticket, request });
}

/// The parts that say something, joined.
#[must_use]
pub fn joined_label(parts: &[&str]) -> String {
    let parts: Vec<&str> = parts.iter().copied().filter(|p| !p.is_empty()).collect();
    parts.join(", ")
}

/// Starts what waits, as far as there is room.
pub(super) fn start_waiting(state: &mut AppState) -> Vec<Effect> {
    let mut effects = job_processes::submit_waiting(state);
    while state.jobs.computing() < state.jobs.limit {
        let Some(next) = state.jobs.waiting.pop_front() else {
            break;
        };
        let QueuedRequest { ticket, request } = next;
        set_state(state, ticket, JobState::Running);
        effects.push(Effect::Start {
            ticket,
            request,
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
    let in_runs = state.runs_view().and_then(|view| {
        let ticket = view.current_run()?.ticket?;
        let line = state.jobs.lines.iter().find(|l| l.ticket == ticket)?;
        (state.focus() == PaneId::Runs && line.state.is_open()).then_some(line)
    });
    let newest = |purpose: JobPurpose| {
        let mut lines = state.jobs.lines.iter();
        lines.rfind(|l| l.purpose == purpose && l.state == JobState::Running)
    };
    let in_sweep = (state.focus() == PaneId::Sweep).then(|| newest(JobPurpose::Sweep));
    let found = in_jobs
        .or(in_runs)
        .or(in_sweep.flatten())
        .or_else(|| newest(JobPurpose::Run))
        .or_else(|| newest(JobPurpose::Sweep))
        .or_else(|| newest(JobPurpose::Trials))
        .or_else(|| newest(JobPurpose::Live));
    match found.map(|l| (l.ticket, l.name.clone())) {
        Some((ticket, name)) => {
            let effects = cancel(state, ticket);
            info(state, format!("Cancelled {name}. Ctrl-C again quits."));
            effects
        }
        None => info(
            state,
            "Nothing is running. Ctrl-C again quits; so does `:quit`.",
        ),
    }
}

/// Cancels a job.
pub fn cancel(state: &mut AppState, ticket: JobNumber) -> Vec<Effect> {
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

/// Jobs of the open case end with it; trials and processes keep running.
pub(super) fn cancel_all(state: &mut AppState) -> Vec<Effect> {
    state.jobs.waiting.clear();
    let open: Vec<JobNumber> = state
        .jobs
        .lines
        .iter_mut()
        .filter(|l| l.state.is_open() && l.purpose != JobPurpose::Trials && l.process.is_none())
        .map(|l| {
            l.state = JobState::Cancelled;
            l.ticket
        })
        .collect();
    open.into_iter().map(Effect::Cancel).collect()
}
