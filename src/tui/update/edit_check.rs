//! Edits are applied and checked behind the screen: asking for them, taking their answer, and the keys that wait for it.

use super::ask_edit::send;
use super::notice::{info, warn};
use super::{build, edit, parts, recovery};
use crate::command::CommandId;
use crate::key::KeyPress;
use crate::msg::{Effect, Msg};
use crate::pane::PaneId;
use crate::panes;
use crate::state::edit_check::EditAnswer;
use crate::state::pending::{EditSource, PendingEdit};
use crate::state::{AppState, Severity};

/// More steps back than anyone takes, and still a small file each.
const UNDO_DEPTH: usize = 200;

/// Commands that neither read nor change the text: they need not wait for an edit.
const PASSING: &[CommandId] = &[
    CommandId::StepUp,
    CommandId::StepDown,
    CommandId::LeapUp,
    CommandId::LeapDown,
    CommandId::Down,
    CommandId::Up,
    CommandId::PageDown,
    CommandId::PageUp,
    CommandId::Top,
    CommandId::Bottom,
    CommandId::NextGroup,
    CommandId::PreviousGroup,
    CommandId::NextPane,
    CommandId::PreviousPane,
    CommandId::Filter,
    CommandId::Zoom,
    CommandId::ScrollLeft,
    CommandId::ScrollRight,
    CommandId::ColumnLeft,
    CommandId::ColumnRight,
    CommandId::NextChart,
    CommandId::PreviousChart,
    CommandId::CursorLeft,
    CommandId::CursorRight,
    CommandId::Redraw,
    CommandId::Suspend,
];

/// The answer to a check: what is accepted is taken with its reading, what is refused is said.
pub(super) fn checked(state: &mut AppState, answer: EditAnswer) -> Vec<Effect> {
    let editor = state.editor_mut();
    let Some(edits) = editor.and_then(|editor| editor.pending.end(answer.number)) else {
        return Vec::new();
    };
    let mut effects = Vec::new();
    if let Some(read) = answer.read {
        let changed = enter(state, &edits, &answer.accepted);
        match (&mut state.document, read) {
            (Some(document), Ok(read)) => document.take(*read),
            (Some(document), Err(draft)) => document.take_draft(*draft),
            (None, _) => {}
        }
        effects.extend(edit::taken(state, changed));
    }
    for (i, _) in &answer.accepted {
        if let Some(edit) = edits.get(*i) {
            effects.extend(accepted(state, edit));
        }
    }
    if let Some(fault) = state.editor().and_then(|editor| editor.draft.clone()) {
        state.say(Severity::Warning, format!("Not complete yet: {fault}"));
    }
    if let Some((i, why)) = answer.refused
        && let Some(edit) = edits.get(i)
    {
        effects.extend(refused(state, edit, why));
    }
    effects.extend(send(state));
    effects
}

/// Enters accepted edits into the text and the steps that can be undone, and returns whether the text changed.
fn enter(state: &mut AppState, edits: &[PendingEdit], accepted: &[(usize, String)]) -> bool {
    let Some(editor) = state.editor_mut() else {
        return false;
    };
    let mut changed = false;
    for (i, text) in accepted {
        let source = edits.get(*i).map(|edit| edit.source);
        if *text == editor.text {
            continue;
        }
        changed = true;
        let before = std::mem::replace(&mut editor.text, text.clone());
        match source {
            Some(EditSource::Undo) => {
                editor.undo.pop();
                editor.redo.push(before);
            }
            Some(EditSource::Redo) => {
                editor.redo.pop();
                editor.undo.push(before);
            }
            _ => {
                editor.undo.push(before);
                editor.redo.clear();
            }
        }
    }
    let spare = editor.undo.len().saturating_sub(UNDO_DEPTH);
    editor.undo.drain(..spare);
    changed
}

/// What follows an edit that is accepted.
fn accepted(state: &mut AppState, edit: &PendingEdit) -> Vec<Effect> {
    let mut dropped = false;
    if edit.source == EditSource::Typed
        && let Some(editor) = state.editor_mut()
        && let Some(editing) = editor.editing.take()
    {
        // A value in place of its range.
        let before = editor.kept.len();
        editor.kept.retain(|kept| kept.path != editing.path);
        dropped = editor.kept.len() < before;
    }
    if edit.source == EditSource::Form {
        build::accepted(state);
    }
    if let Some(words) = &edit.said {
        info(state, words.clone());
    }
    if edit.source != EditSource::Recovered {
        return match dropped {
            true => recovery::keep_recovery(state),
            false => Vec::new(),
        };
    }
    recovery::take_over_recovery(state)
}

/// A refusal stays with the value where that is typed.
fn refused(state: &mut AppState, edit: &PendingEdit, why: String) -> Vec<Effect> {
    if edit.source == EditSource::Form {
        return build::refused(state, why);
    }
    let typed = edit.source == EditSource::Typed;
    let editing = state
        .editor_mut()
        .and_then(|editor| editor.editing.as_mut());
    match editing.filter(|_| typed) {
        Some(editing) => {
            editing.problem = Some(why);
            Vec::new()
        }
        None => warn(state, why),
    }
}

/// Whether what the screen shows is about to change by an answer that is on its way.
#[must_use]
pub fn awaits(state: &AppState) -> bool {
    checking(state) || reporting(state) || parts::any_open(state)
}

fn checking(state: &AppState) -> bool {
    state
        .editor()
        .is_some_and(|editor| !editor.pending.is_empty())
}

fn reporting(state: &AppState) -> bool {
    let view = state
        .runs_view()
        .filter(|_| state.focus() == PaneId::Report);
    view.is_some_and(|view| view.report_asked.is_some())
}

/// Whether a key or a paste waits: it is meant for the text with the edits before it, or writes what is being made.
fn waits(state: &AppState, msg: &Msg) -> bool {
    if (reporting(state) || parts::is_open(state))
        && let Msg::Key(key) = msg
    {
        let found = state.overlay.is_none().then(|| panes::find(state, *key));
        if found
            .flatten()
            .is_some_and(|found| found.id == CommandId::Write)
        {
            return true;
        }
    }
    if !checking(state) {
        return false;
    }
    let typing = state
        .editor()
        .is_some_and(|editor| editor.editing.is_some());
    if typing || state.overlay.is_some() {
        return true;
    }
    match msg {
        Msg::Key(KeyPress::Ctrl('z')) => false,
        Msg::Key(_) | Msg::Paste(_) if is_filtering(state) => false,
        Msg::Key(key) => panes::find(state, *key).is_some_and(|found| {
            !(PASSING.contains(&found.id) || matches!(found.id, CommandId::Pane(_)))
        }),
        _ => true,
    }
}

fn is_filtering(state: &AppState) -> bool {
    match &state.document {
        Some(document) if document.pane == PaneId::Runs => {
            let view = document.runs_view();
            view.is_some_and(|view| view.runs.filter.typing)
        }
        Some(document) if document.pane == PaneId::Model => document.editor.model.filter.typing,
        Some(document) => document.editor.filter.typing,
        None => false,
    }
}

/// Keeps a key or a paste that waits, and those behind it; a second Ctrl-C drops the edits that they wait for.
pub(super) fn hold(state: &mut AppState, msg: Msg) -> Result<Vec<Effect>, Msg> {
    let typed = matches!(msg, Msg::Key(_) | Msg::Paste(_));
    if !typed || (state.held.is_empty() && !waits(state, &msg)) {
        return Err(msg);
    }
    let interrupt = |msg: &Msg| matches!(msg, Msg::Key(KeyPress::Ctrl('c')));
    if interrupt(&msg) && state.held.iter().any(interrupt) {
        state.held.clear();
        if let Some(editor) = state.editor_mut() {
            editor.pending = Default::default();
        }
        return Ok(warn(state, "The edit that was being checked is dropped."));
    }
    state.held.push_back(msg);
    Ok(Vec::new())
}

/// The next key or paste that waits no longer.
pub(super) fn released(state: &mut AppState) -> Option<Msg> {
    let ready = state.held.front().is_some_and(|msg| !waits(state, msg));
    ready.then(|| state.held.pop_front()).flatten()
}
