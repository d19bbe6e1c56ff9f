//! The parameter editor: typing a value, undo, and what every change of the text entails.

use tui_input::Input;

use super::text_input::type_key;
use super::{info, jobs, moved, runs};
use crate::case::fields::Absent;
use crate::tui::command::Id;
use crate::tui::facade::{self, FieldRow};
use crate::tui::key::Key;
use crate::tui::msg::Effect;
use crate::tui::state::{AppState, Editing, Level, ParameterEditor};

const METHODS: [&str; 4] = ["static", "quasi", "rk4", "alpha"];

/// More steps back than anyone takes, and still a small file each.
const UNDO_DEPTH: usize = 200;

pub(super) fn command(state: &mut AppState, id: Id) -> Vec<Effect> {
    match id {
        Id::Edit => begin(state),
        Id::Reset => reset(state),
        Id::Undo => undo(state),
        Id::Redo => redo(state),
        Id::NextGroup => group(state, true),
        Id::PreviousGroup => group(state, false),
        Id::Method => next_method(state),
        Id::ExternalEditor => state.editor().map_or_else(Vec::new, |editor| {
            vec![Effect::EditFile(editor.path.clone())]
        }),
        _ => Vec::new(),
    }
}

fn begin(state: &mut AppState) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut()
        && let Some(row) = editor.current_field()
    {
        editor.editing = Some(Editing {
            path: row.path.clone(),
            input: Input::new(row.value.clone()),
            problem: None,
        });
    }
    Vec::new()
}

/// Keys while a value or the filter of the fields is typed.
pub(super) fn typing_key(state: &mut AppState, key: Key) -> Option<Vec<Effect>> {
    let editor = state.editor_mut()?;
    if key == Key::Ctrl('z') && (editor.editing.is_some() || editor.filtering) {
        return Some(vec![Effect::Suspend]);
    }
    if let Some(editing) = &mut editor.editing {
        match key {
            Key::Esc | Key::Ctrl('c') => editor.editing = None,
            Key::Enter => return Some(accept(state)),
            _ => {
                if type_key(&mut editing.input, key) {
                    editing.problem = None;
                }
            }
        }
        return Some(Vec::new());
    }
    if !editor.filtering {
        return None;
    }
    let lines = editor.fields().count();
    match key {
        Key::Enter => editor.filtering = false,
        Key::Esc | Key::Ctrl('c') => {
            editor.filtering = false;
            editor.filter.reset();
            editor.field = 0;
        }
        Key::Down => editor.field = moved(editor.field, 1, lines),
        Key::Up => editor.field = moved(editor.field, -1, lines),
        _ => {
            if type_key(&mut editor.filter, key) {
                editor.field = 0;
            }
        }
    }
    Some(Vec::new())
}

/// A text of the kind that is open, with a key set.
fn with(state: &AppState, text: &str, key: &str, value: &str) -> Result<String, String> {
    match &state.file {
        Some(file) => {
            let set = file.content.view().set(text, key, value);
            set.map_err(|all| facade::refusal(key, &all))
        }
        None => facade::set(text, key, value),
    }
}

/// Sets a key as if it had been typed; what is refused is told.
pub(super) fn set(state: &mut AppState, key: &str, value: &str) -> Vec<Effect> {
    match state
        .editor()
        .map(|editor| with(state, &editor.text, key, value))
    {
        Some(Ok(text)) => change(state, text),
        Some(Err(problem)) => super::overlay::warn(state, problem),
        None => Vec::new(),
    }
}

fn accept(state: &mut AppState) -> Vec<Effect> {
    let Some(editing) = state.editor_mut().and_then(|editor| editor.editing.take()) else {
        return Vec::new();
    };
    let value = editing.input.value().trim();
    let editor = state.editor();
    let text = editor.map(|editor| editor.text.clone()).unwrap_or_default();
    let row = editor.and_then(|s| s.rows.iter().find(|row| row.path == editing.path));
    let goes = value.is_empty() && state.open.is_some() && row.is_some_and(can_go);
    let taken = if goes {
        facade::unset(&text, &editing.path)
    } else {
        with(state, &text, &editing.path, value)
    };
    match taken {
        Ok(text) => change(state, text),
        Err(problem) => {
            if let Some(editor) = state.editor_mut() {
                editor.editing = Some(Editing {
                    problem: Some(problem),
                    ..editing
                });
            }
            Vec::new()
        }
    }
}

/// Whether a field is one that the file gives and may leave out.
pub(in crate::tui) fn can_go(row: &FieldRow) -> bool {
    row.given && row.field.absent != Absent::Required
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

fn undo(state: &mut AppState) -> Vec<Effect> {
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

fn redo(state: &mut AppState) -> Vec<Effect> {
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
        return Vec::new();
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
            super::cases::rejected(state, "The file as the editor left it".to_owned(), story)
        }
    }
}

/// What every change of the text entails: fields and table anew, the draft kept, a re-solve.
fn changed(state: &mut AppState) -> Vec<Effect> {
    refresh(state);
    let mut effects = keep_recovery(state);
    if state.open.is_some() {
        effects.extend(jobs::resolve(state));
    }
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
    // Edits are checked before they are taken; an old text that no longer passes is told, and
    // the fields stay as they were.
    let mut problem = None;
    if let Some(file) = &mut state.file {
        if let Err(all) = file.refresh() {
            problem = Some(facade::first(&all, &file.editor.file));
        }
    } else if let Some(open) = &mut state.open {
        match open.editor.case_of(&open.editor.text) {
            Ok(case) => {
                open.editor.rows = facade::rows(&open.editor.text, &case);
                open.case = case;
            }
            Err(why) => problem = Some(why),
        }
    }
    if let Some(problem) = problem {
        state.say(Level::Error, problem);
    }
    if let Some(editor) = state.editor_mut() {
        editor.field = editor.field.min(editor.fields().count().saturating_sub(1));
    }
    if state.open.is_some() {
        runs::check(state);
    }
}

/// The fields of a text, of the kind of file that is open; none when it does not pass.
fn rows_of(state: &AppState, text: &str, editor: &ParameterEditor) -> Vec<FieldRow> {
    match &state.file {
        Some(file) => file.content.view().rows(text),
        None => {
            (editor.case_of(text)).map_or_else(|_| Vec::new(), |case| facade::rows(text, &case))
        }
    }
}

/// Puts the field back to what the file says.
fn reset(state: &mut AppState) -> Vec<Effect> {
    let Some(editor) = state.editor() else {
        return Vec::new();
    };
    let Some(path) = editor.current_field().map(|row| row.path.clone()) else {
        return Vec::new();
    };
    let of_file = rows_of(state, &editor.saved, editor)
        .into_iter()
        .find(|row| row.path == path);
    let left_out = of_file.as_ref().is_some_and(|row| !row.given);
    let given_now = editor.current_field().is_some_and(can_go);
    if left_out && given_now && state.open.is_some() {
        return match facade::unset(&editor.text, &path) {
            Ok(text) => change(state, text),
            Err(problem) => super::overlay::warn(state, problem),
        };
    }
    let Some(row) = of_file.filter(|row| !row.value.is_empty()) else {
        return info(
            state,
            "The file gives no value here; `u` undoes the edits one by one.",
        );
    };
    match with(state, &editor.text, &path, &row.value) {
        Ok(text) => change(state, text),
        Err(problem) => super::overlay::warn(state, problem),
    }
}

fn group(state: &mut AppState, forward: bool) -> Vec<Effect> {
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
    Vec::new()
}

/// The solver is an input like any other: it is written to the text, and can be undone.
fn next_method(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let now = facade::method_word(open.case.solver.method);
    let at = METHODS.iter().position(|m| *m == now).unwrap_or(0);
    let next = METHODS[(at + 1) % METHODS.len()];
    match facade::set(&open.editor.text, "solver.method", next) {
        Ok(text) => {
            let effects = change(state, text);
            info(state, format!("The solver is now `{next}`."));
            effects
        }
        Err(problem) => super::overlay::warn(state, problem),
    }
}

/// Brings back the edits of an earlier session.
pub(super) fn recover(state: &mut AppState, text: String) -> Vec<Effect> {
    let Some(editor) = state.editor() else {
        return Vec::new();
    };
    let path = editor.path.clone();
    let passes = match &state.file {
        Some(file) => {
            let passes = file.content.view().passes(&text, &editor.file);
            passes.map_err(|all| facade::first(&all, &editor.file))
        }
        None => editor.case_of(&text).map(drop),
    };
    if let Err(problem) = passes {
        return super::overlay::warn(
            state,
            format!("The kept edits no longer pass and stay where they are: {problem}"),
        );
    }
    let mut effects = change(state, text);
    effects.push(Effect::DropRecovery(path));
    // The draft of this session is written after the old one is dropped.
    effects.extend(keep_recovery(state));
    info(
        state,
        "The edits of the earlier session are back. `u` undoes them.",
    );
    effects
}
