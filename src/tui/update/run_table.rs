//! What is done to the runs of the table: marks, names, tags and notes, deleting, running again.

use std::path::{Path, PathBuf};

use tui_input::Input;

use super::edit;
use super::jobs::{queue, start_newest};
use super::notice::{info, warn};
use crate::msg::{Effect, RunCaseUse};
use crate::pane::PaneId;
use crate::run::job::Request;
use crate::state::overlay::RunText;
use crate::state::{
    AppState, DocumentContent, JobRequest, Overlay, ParameterEditor, PromptPurpose, Question,
    RunEntry, RunStatus,
};
use crate::system::motion::{self, job::SystemRequest};

/// Marks the run under the cursor for what is done to several, or takes the mark off.
pub fn mark(state: &mut AppState) {
    let Some(view) = state.runs_view_mut() else {
        return;
    };
    view.runs.turn_mark();
    view.runs.cursor = (view.runs.cursor + 1).min(view.runs.lines().saturating_sub(1));
}

/// Marks all runs of the table, or takes all marks off where there are any.
pub fn mark_all(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let any = view.runs.any_marked();
    let rows = view.runs.rows().to_vec();
    let mut at = 0;
    let mut rows_in_order = rows.clone();
    rows_in_order.sort_unstable();
    view.runs.change_all(|run| {
        run.marked = !any && rows_in_order.binary_search(&at).is_ok();
        at += 1;
    });
    let words = match (any, rows.len()) {
        (true, _) => "No run is marked any more.".to_owned(),
        (false, count) => {
            format!("{count} runs are marked. `:delete` deletes them, `:tag_runs` tags them.")
        }
    };
    info(state, words)
}

/// Asks whether the marked runs, or the one under the cursor, are to be deleted.
pub fn ask_to_delete(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view() else {
        return Vec::new();
    };
    let chosen = view.runs.chosen();
    let dirs: Vec<PathBuf> = chosen
        .iter()
        .filter(|run| why_not_deleted(run).is_none())
        .filter_map(|run| run.dir.clone())
        .collect();
    if dirs.is_empty() {
        return warn(
            state,
            "None of the marked runs can be deleted: they are being computed.",
        );
    }
    let what = match chosen.as_slice() {
        [run] => format!("the stored run {}", run.title()),
        _ => format!("{} stored runs", dirs.len()),
    };
    state.overlay = Some(Overlay::Ask(Question::DeleteRuns { dirs, what }));
    Vec::new()
}

/// Why a run cannot be deleted.
#[must_use]
pub fn why_not_deleted(run: &RunEntry) -> Option<&'static str> {
    match &run.state {
        RunStatus::Job(state) if state.is_open() => {
            Some("This run is still running; `ctrl+c` cancels it.")
        }
        RunStatus::Elsewhere => Some("Another program is still computing this run."),
        _ if run.dir.is_none() => Some("This run has no directory to delete."),
        _ => None,
    }
}

/// Asks for a name, tags or a note of the run under the cursor; tags go to all that are marked.
pub fn ask_text(state: &mut AppState, what: RunText) -> Vec<Effect> {
    let Some(view) = state.runs_view() else {
        return Vec::new();
    };
    let chosen = match what {
        RunText::Tags => view.runs.chosen(),
        _ => view.runs.current().into_iter().collect(),
    };
    let Some(first) = chosen.first() else {
        return Vec::new();
    };
    let now = match what {
        RunText::Name => first.notes.name.clone(),
        RunText::Tags => first.notes.tags.join(" "),
        RunText::Note => first.notes.note.clone(),
    };
    let words = match (what, chosen.len()) {
        (RunText::Name, _) => {
            "A name of your own, shown in place of that of its directory; empty for none."
                .to_owned()
        }
        (RunText::Tags, 1) => {
            "Words apart by blanks; `:filter` then `#word` shows the runs that have one.".to_owned()
        }
        (RunText::Tags, count) => format!("Words apart by blanks, for all {count} marked runs."),
        (RunText::Note, _) => "What is worth knowing about this run.".to_owned(),
    };
    let dirs = chosen.iter().filter_map(|run| run.dir.clone()).collect();
    state.overlay = Some(Overlay::Prompt {
        purpose: PromptPurpose::RunText { what, dirs },
        input: Input::new(now),
        words,
    });
    Vec::new()
}

/// Takes the name, tags or note that was typed, and keeps it with each run.
pub(super) fn take_text(
    state: &mut AppState,
    what: RunText,
    dirs: &[PathBuf],
    typed: &str,
) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let mut effects = Vec::new();
    for dir in dirs {
        if let Some(run) = view.runs.in_dir_mut(dir) {
            match what {
                RunText::Name => typed.clone_into(&mut run.notes.name),
                RunText::Tags => run.notes.set_tags(typed),
                RunText::Note => typed.clone_into(&mut run.notes.note),
            }
            effects.push(Effect::WriteNotes(dir.clone(), run.notes.clone()));
        }
    }
    view.runs.arrange();
    effects
}

/// Asks for the exact case of the run under the cursor.
pub fn read_case(state: &AppState, wanted: RunCaseUse) -> Vec<Effect> {
    let run = state.runs_view().and_then(|view| view.runs.current());
    let dir = run.and_then(|run| run.dir.clone());
    let (Some(dir), Some(editor)) = (dir, state.editor()) else {
        return Vec::new();
    };
    vec![Effect::ReadRunCase {
        dir,
        wanted,
        beside: editor.path.clone(),
    }]
}

/// The exact case of a run: edited in place of what is open, which can be undone, or run again.
pub(super) fn exact_case(
    state: &mut AppState,
    dir: &Path,
    wanted: RunCaseUse,
    read: Result<(String, DocumentContent), String>,
) -> Vec<Effect> {
    let (text, content) = match read {
        Ok(read) => read,
        Err(why) => return warn(state, why),
    };
    let Some(editor) = state.editor() else {
        return Vec::new();
    };
    let name = dir
        .file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    match wanted {
        RunCaseUse::Edit => {
            if let Some(document) = &mut state.document {
                document.pane = PaneId::Inputs;
            }
            let said = format!("The inputs are those of {name}. `:undo` takes them back.");
            edit::replace(state, text, said)
        }
        RunCaseUse::RunAgain => {
            let Some(request) = request_again(editor, text, content) else {
                return warn(state, format!("{name} is no run of what is open."));
            };
            let label = format!("again {name}");
            queue(state, request, label, None, false);
            let effects = start_newest(state);
            info(
                state,
                format!("{name} is computed again, as a run of its own."),
            );
            effects
        }
    }
}

/// A run of the exact text of an earlier one.
fn request_again(
    editor: &ParameterEditor,
    text: String,
    content: DocumentContent,
) -> Option<JobRequest> {
    let (file, id) = (editor.file.clone(), editor.stem().to_owned());
    match content {
        DocumentContent::Line(line) => {
            let request = Request {
                case: line.case,
                file,
                id,
                overrides: Vec::new(),
                text,
            };
            Some(JobRequest::Line(Box::new(request), None))
        }
        DocumentContent::System(system) => {
            let request = motion::job::request(system.solved, &text, file, Vec::new())?;
            let request = SystemRequest { id, ..request };
            Some(JobRequest::System(Box::new(request), None))
        }
        _ => None,
    }
}

/// Sorts the table by the next column, or the other way round.
pub fn sort(state: &mut AppState, around: bool) {
    if let Some(view) = state.runs_view_mut() {
        if around {
            view.runs.sort_around();
        } else {
            view.runs.sort_next();
        }
    }
}

/// Drops the marks and shows the live run alone.
pub fn live_only(state: &mut AppState) {
    if let Some(view) = state.runs_view_mut() {
        view.hide_runs();
        view.live.hidden = false;
        view.runs.change_all(|run| run.marked = false);
    }
}
