//! The parameter editor: typing a value, undo, and what every change of the text entails.

use tui_input::Input;

use super::notice::{info, warn};
use super::text_input::type_key;
use super::{jobs, runs, vary};
use crate::case::fields::AbsentValue;
use crate::run::settings::method_name;
use crate::tui::facade::{self, FieldRow};
use crate::tui::key::KeyPress;
use crate::tui::msg::Effect;
use crate::tui::state::reading;
use crate::tui::state::{AppState, Editing, Reading, Severity};

const METHODS: [&str; 4] = ["static", "quasi", "rk4", "alpha"];

/// More steps back than anyone takes, and still a small file each.
const UNDO_DEPTH: usize = 200;

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
    let Some(document) = &state.document else {
        return Vec::new();
    };
    let kind = document.content.file_type();
    let text = reading::set(kind, &document.editor.text, key, value);
    take(state, text)
}

/// Takes a text as an edit, or reports why there is none.
pub(super) fn take(state: &mut AppState, text: Result<String, String>) -> Vec<Effect> {
    match text {
        Ok(text) => change(state, text),
        Err(problem) => warn(state, problem),
    }
}

fn accept(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &mut state.document else {
        return Vec::new();
    };
    let Some(editing) = document.editor.editing.take() else {
        return Vec::new();
    };
    let value = editing.input.value().trim();
    let (editor, kind) = (&document.editor, document.content.file_type());
    let mut rows = editor.rows.iter();
    let row = rows.find(|row| row.path == editing.path);
    let removed = row.filter(|row| value.is_empty() && optional(row));
    let text = removed.and_then(|_| reading::unset(kind, &editor.text, &editing.path));
    let text = text.unwrap_or_else(|| reading::set(kind, &editor.text, &editing.path, value));
    match text {
        Ok(text) => {
            // A value in place of its range.
            let kept = &mut document.editor.kept;
            kept.retain(|kept| kept.path != editing.path);
            change(state, text)
        }
        Err(problem) => {
            document.editor.editing = Some(Editing {
                problem: Some(problem),
                ..editing
            });
            Vec::new()
        }
    }
}

/// Whether a field is one that the file gives and may leave out.
#[must_use]
pub fn optional(row: &FieldRow) -> bool {
    row.given && row.field.absent != AbsentValue::Required
}

/// Takes a new text as an edit that can be undone.
fn change(state: &mut AppState, text: String) -> Vec<Effect> {
    let Some(editor) = state.editor_mut() else {
        return Vec::new();
    };
    if text == editor.text {
        return Vec::new();
    }
    let before = std::mem::replace(&mut editor.text, text);
    editor.undo.push(before);
    if editor.undo.len() > UNDO_DEPTH {
        editor.undo.remove(0);
    }
    editor.redo.clear();
    changed(state)
}

pub(super) fn undo(state: &mut AppState) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut()
        && let Some(text) = editor.undo.pop()
    {
        editor.redo.push(std::mem::replace(&mut editor.text, text));
        let effects = changed(state);
        info(state, "Undone. `U` does it again.");
        return effects;
    }
    Vec::new()
}

pub(super) fn redo(state: &mut AppState) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut()
        && let Some(text) = editor.redo.pop()
    {
        editor.undo.push(std::mem::replace(&mut editor.text, text));
        return changed(state);
    }
    Vec::new()
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
            let effects = change(state, text);
            info(
                state,
                "Read from the file again. `u` takes the change back.",
            );
            effects
        }
        Err(story) => {
            let (title, file) = ("The file as the editor left it", editor.path.clone());
            super::cases::rejected(state, title.to_owned(), file, story)
        }
    }
}

/// What follows every change of the text: fields and result updated, the text kept for recovery, a new solve.
fn changed(state: &mut AppState) -> Vec<Effect> {
    refresh(state);
    let mut effects = keep_recovery(state);
    effects.extend(jobs::resolve(state));
    effects.extend(super::ship::resolve(state));
    effects
}

/// Keeps what is unsaved on disk, so that no kind of exit loses it.
pub(super) fn keep_recovery(state: &AppState) -> Vec<Effect> {
    state
        .editor()
        .into_iter()
        .map(|editor| Effect::KeepRecovery {
            path: editor.path.clone(),
            text: editor.unsaved().then(|| editor.text.clone()),
        })
        .collect()
}

/// Reads what is open, and the fields, from the text again.
pub(super) fn refresh(state: &mut AppState) {
    let Some(document) = &mut state.document else {
        return;
    };
    // Edits are checked before they are taken; where an old text is no longer valid, the fields stay as they were.
    let read = Reading::new(&document.file(), document.editor.text.clone());
    let read = read.map(|read| document.take(read));
    let editor = &mut document.editor;
    editor.field = editor.field.min(editor.fields().count().saturating_sub(1));
    if let Err(all) = read {
        let problem = facade::first(&all, &editor.file);
        state.say(Severity::Error, problem);
    }
    vary::recheck(state);
    runs::check(state);
}

/// Puts the field back to what the file says.
pub fn reset(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &state.document else {
        return Vec::new();
    };
    let (editor, kind) = (&document.editor, document.content.file_type());
    let Some(row) = editor.current_field() else {
        return Vec::new();
    };
    let saved = reading::rows(kind, &editor.saved);
    let saved = saved.iter().find(|saved| saved.path == row.path);
    let added = saved.is_some_and(|saved| !saved.given) && optional(row);
    if added && let Some(text) = reading::unset(kind, &editor.text, &row.path) {
        return take(state, text);
    }
    match saved.filter(|saved| !saved.value.is_empty()) {
        Some(saved) => {
            let text = reading::set(kind, &editor.text, &saved.path, &saved.value);
            take(state, text)
        }
        None => info(
            state,
            "The file gives no value here; `u` undoes the edits one by one.",
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
    let now = method_name(line.case.solver.method);
    let at = METHODS.iter().position(|m| *m == now).unwrap_or(0);
    let next = METHODS[(at + 1) % METHODS.len()];
    let effects = set(state, "solver.method", next);
    if !effects.is_empty() {
        info(state, format!("The solver is now `{next}`."));
    }
    effects
}

/// Brings back the edits of an earlier session.
pub(super) fn recover(state: &mut AppState, text: String) -> Vec<Effect> {
    let Some(document) = &state.document else {
        return Vec::new();
    };
    let path = document.editor.path.clone();
    if let Err(all) = Reading::new(&document.file(), text.clone()) {
        let problem = facade::first(&all, &document.editor.file);
        return warn(
            state,
            format!("The kept edits are no longer valid and stay where they are: {problem}"),
        );
    }
    let mut effects = change(state, text);
    effects.push(Effect::DropRecovery(path));
    // The edits of this session are kept after those of the earlier one are dropped.
    effects.extend(keep_recovery(state));
    info(
        state,
        "The edits of the earlier session are back. `u` undoes them.",
    );
    effects
}
