//! The parameter editor: typing a value, undo, and what every change of the text entails.

use tui_input::Input;

use super::ask_edit::ask;
use super::notice::info;
use super::recovery::keep_recovery;
use super::text_input::type_key;
use super::{jobs, runs, vary};
use crate::case::fields::AbsentValue;
use crate::facade::FieldRow;
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::recovery::RecoveredEdits;
use crate::state::pending::{Change, EditSource, PendingEdit};
use crate::state::{AppState, Editing, KeptRange};

const METHODS: [&str; 4] = ["static", "quasi", "rk4", "alpha"];

/// Begins to edit the value under the cursor.
pub fn begin(state: &mut AppState) {
    if let Some(editor) = state.editor_mut()
        && let Some(row) = editor.current_field()
    {
        editor.editing = Some(Editing {
            path: row.path.clone(),
            input: Input::new(
                editor
                    .kept_range(&row.path)
                    .unwrap_or(&row.value)
                    .to_owned(),
            ),
            problem: None,
        });
    }
}

/// Keys while a value is typed.
pub(super) fn typing_key(state: &mut AppState, key: KeyPress) -> Option<Vec<Effect>> {
    let keeps = key == KeyPress::Char('+') && vary::can_keep(state);
    let editor = state.editor_mut()?;
    let editing = editor.editing.as_mut()?;
    match key {
        KeyPress::Ctrl('z') => return Some(vec![Effect::Suspend]),
        KeyPress::Esc | KeyPress::Ctrl('c') => editor.editing = None,
        KeyPress::Enter => {
            return Some(vary::enter(state).unwrap_or_else(|| accept(state)));
        }
        KeyPress::Char('+') if keeps => return Some(vary::keep(state)),
        _ => {
            if type_key(&mut editing.input, key) {
                editing.problem = None;
            }
        }
    }
    Some(Vec::new())
}

/// Sets a key as if it had been typed; a value that is refused is reported.
pub fn set(state: &mut AppState, key: &str, value: &str) -> Vec<Effect> {
    let change = Change::Set(key.to_owned(), value.to_owned());
    ask(state, PendingEdit::command(change))
}

/// Takes a text as an edit, and says so.
pub(super) fn replace(state: &mut AppState, text: String, said: impl Into<String>) -> Vec<Effect> {
    let edit = PendingEdit {
        said: Some(said.into()),
        ..PendingEdit::command(Change::Text(text))
    };
    ask(state, edit)
}

fn accept(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &state.document else {
        return Vec::new();
    };
    let editor = &document.editor;
    let Some(editing) = &editor.editing else {
        return Vec::new();
    };
    let (path, value) = (editing.path.clone(), editing.input.value().trim());
    let row = editor.rows.iter().find(|row| row.path == path);
    let removed = value.is_empty() && row.is_some_and(optional) && document.line().is_some();
    let change = match removed {
        true => Change::Unset(path),
        false => Change::Set(path, value.to_owned()),
    };
    let edit = PendingEdit {
        source: EditSource::Typed,
        ..PendingEdit::command(change)
    };
    ask(state, edit)
}

/// Whether a field is one that the file gives and may leave out.
#[must_use]
pub fn optional(row: &FieldRow) -> bool {
    row.given && row.field.absent != AbsentValue::Required
}

pub(super) fn undo(state: &mut AppState) -> Vec<Effect> {
    let text = state.editor().and_then(|editor| editor.undo.last());
    let said = Some("Undone. `:redo` does it again.".to_owned());
    step_back(state, text.cloned(), EditSource::Undo, said)
}

pub(super) fn redo(state: &mut AppState) -> Vec<Effect> {
    let text = state.editor().and_then(|editor| editor.redo.last());
    step_back(state, text.cloned(), EditSource::Redo, None)
}

fn step_back(
    state: &mut AppState,
    text: Option<String>,
    source: EditSource,
    said: Option<String>,
) -> Vec<Effect> {
    let Some(text) = text else {
        return Vec::new();
    };
    let edit = PendingEdit {
        change: Change::Text(text),
        source,
        said,
    };
    ask(state, edit)
}

/// The file as an editor left it: taken as an edit that can be undone, or refused with all that is wrong with it.
pub(super) fn edited(state: &mut AppState, read: Result<String, String>) -> Vec<Effect> {
    let Some(editor) = state.editor_mut() else {
        return super::cases::edited(state, read);
    };
    match read {
        Ok(text) if text == editor.saved => info(state, "The file is as it was."),
        Ok(text) => {
            editor.saved.clone_from(&text);
            let said = "Read from the file again. `:undo` takes the change back.";
            replace(state, text, said)
        }
        Err(story) => {
            let (title, file) = ("The file as the editor left it", editor.path.clone());
            super::cases::rejected(state, title.to_owned(), file, story)
        }
    }
}

/// What follows when edits are accepted: what hangs on the text is updated, the text kept for recovery, the case solved again.
/// A text that is not complete is kept and not solved.
pub(super) fn taken(state: &mut AppState, changed: bool) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut() {
        let last = editor.fields().count().saturating_sub(1);
        editor.field = editor.field.min(last);
    }
    vary::recheck(state);
    runs::check(state);
    if !changed {
        return Vec::new();
    }
    let mut effects = keep_recovery(state);
    if state.editor().is_some_and(|editor| editor.draft.is_none()) {
        effects.extend(jobs::resolve(state));
        effects.extend(super::ship::resolve(state));
    }
    effects
}

/// Reads the text again.
pub(super) fn reread(state: &mut AppState) -> Vec<Effect> {
    ask(state, PendingEdit::command(Change::Reread))
}

/// Puts the field back to what the file says.
pub fn reset(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &state.document else {
        return Vec::new();
    };
    let editor = &document.editor;
    let Some(row) = editor.current_field() else {
        return Vec::new();
    };
    let saved = editor.saved_field(&row.path);
    let added = saved.is_some_and(|saved| !saved.given) && optional(row);
    if added && document.line().is_some() {
        let change = Change::Unset(row.path.clone());
        return ask(state, PendingEdit::command(change));
    }
    match saved.filter(|saved| !saved.value.is_empty()) {
        Some(saved) => {
            let change = Change::Set(saved.path.clone(), saved.value.clone());
            ask(state, PendingEdit::command(change))
        }
        None => info(
            state,
            "The file gives no value here; `:undo` undoes the edits one by one.",
        ),
    }
}

/// Shows all fields, or only those that the file gives; the cursor stays on its field where that is shown.
pub fn fold(state: &mut AppState) {
    let Some(editor) = state.editor_mut() else {
        return;
    };
    let path = editor.current_field().map(|row| row.path.clone());
    editor.folded = !editor.folded;
    let at = editor
        .fields()
        .position(|row| Some(&row.path) == path.as_ref());
    editor.field = at
        .unwrap_or(editor.field)
        .min(editor.fields().count().saturating_sub(1));
}

/// Moves the cursor to the next or the previous group of fields.
pub fn next_group(state: &mut AppState, forward: bool) {
    if let Some(editor) = state.editor_mut() {
        let groups: Vec<String> = editor.fields().map(|row| row.group.clone()).collect();
        let begins = |i: &usize| *i == 0 || groups[*i] != groups[*i - 1];
        let at = editor.field;
        let found = if forward {
            (at + 1..groups.len()).find(begins)
        } else {
            (0..at.min(groups.len())).rev().find(begins)
        };
        editor.field = found.unwrap_or(at);
    }
}

/// The solver is an input like any other: it is written to the text, and can be undone.
pub(super) fn next_method(state: &mut AppState) -> Vec<Effect> {
    let Some(line) = state.line() else {
        return Vec::new();
    };
    let now = line.case.solver.method.name();
    let at = METHODS.iter().position(|m| *m == now).unwrap_or(0);
    let next = METHODS[(at + 1) % METHODS.len()];
    let change = Change::Set("solver.method".to_owned(), next.to_owned());
    let edit = PendingEdit {
        said: Some(format!("The solver is now `{next}`.")),
        ..PendingEdit::command(change)
    };
    ask(state, edit)
}

/// Brings back the edits of an earlier session.
pub(super) fn recover(state: &mut AppState, left: RecoveredEdits) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut() {
        let kept = left.kept.iter();
        editor.kept = kept.filter_map(|word| KeptRange::read(word)).collect();
    }
    let said = "The edits of the earlier session are back. `:undo` undoes them.";
    let edit = PendingEdit {
        change: Change::Text(left.text),
        source: EditSource::Recovered,
        said: Some(said.to_owned()),
    };
    ask(state, edit)
}
