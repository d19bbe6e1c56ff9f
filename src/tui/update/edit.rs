//! The parameter editor: typing a value, undo, and what every change of the text entails.

use tui_input::Input;

use super::typing::type_key;
use super::{info, jobs, moved, runs};
use crate::tui::backend;
use crate::tui::command::Id;
use crate::tui::key::Key;
use crate::tui::msg::Effect;
use crate::tui::state::{Editing, Level, State};

const METHODS: [&str; 4] = ["static", "quasi", "rk4", "alpha"];

/// More steps back than anyone takes, and still a small file each.
const UNDO_DEPTH: usize = 200;

pub(super) fn command(state: &mut State, id: Id) -> Vec<Effect> {
    match id {
        Id::Edit => begin(state),
        Id::Reset => reset(state),
        Id::Undo => undo(state),
        Id::Redo => redo(state),
        Id::NextGroup => group(state, true),
        Id::PreviousGroup => group(state, false),
        Id::Method => next_method(state),
        _ => Vec::new(),
    }
}

fn begin(state: &mut State) -> Vec<Effect> {
    if let Some(open) = &mut state.open
        && let Some(row) = open.current_field()
    {
        open.editing = Some(Editing {
            path: row.path.clone(),
            input: Input::new(row.value.clone()),
            problem: None,
        });
    }
    Vec::new()
}

/// Keys while a value or the filter of the fields is typed.
pub(super) fn typing_key(state: &mut State, key: Key) -> Option<Vec<Effect>> {
    let open = state.open.as_mut()?;
    if key == Key::Ctrl('z') && (open.editing.is_some() || open.filtering) {
        return Some(vec![Effect::Suspend]);
    }
    if let Some(editing) = &mut open.editing {
        match key {
            Key::Esc | Key::Ctrl('c') => open.editing = None,
            Key::Enter => return Some(accept(state)),
            _ => {
                if type_key(&mut editing.input, key) {
                    editing.problem = None;
                }
            }
        }
        return Some(Vec::new());
    }
    if !open.filtering {
        return None;
    }
    let lines = open.fields().count();
    match key {
        Key::Enter => open.filtering = false,
        Key::Esc | Key::Ctrl('c') => {
            open.filtering = false;
            open.filter.reset();
            open.field = 0;
        }
        Key::Down => open.field = moved(open.field, 1, lines),
        Key::Up => open.field = moved(open.field, -1, lines),
        _ => {
            if type_key(&mut open.filter, key) {
                open.field = 0;
            }
        }
    }
    Some(Vec::new())
}

fn accept(state: &mut State) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let Some(editing) = open.editing.take() else {
        return Vec::new();
    };
    match backend::set(&open.text, &editing.path, editing.input.value().trim()) {
        Ok(text) => change(state, text),
        Err(problem) => {
            open.editing = Some(Editing {
                problem: Some(problem),
                ..editing
            });
            Vec::new()
        }
    }
}

/// Takes a new text as an edit that can be undone.
fn change(state: &mut State, text: String) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    if text == open.text {
        return Vec::new();
    }
    let before = std::mem::replace(&mut open.text, text);
    open.undo.push(before);
    if open.undo.len() > UNDO_DEPTH {
        open.undo.remove(0);
    }
    open.redo.clear();
    changed(state)
}

fn undo(state: &mut State) -> Vec<Effect> {
    if let Some(open) = &mut state.open
        && let Some(text) = open.undo.pop()
    {
        open.redo.push(std::mem::replace(&mut open.text, text));
        let effects = changed(state);
        info(state, "Undone. `U` does it again.");
        return effects;
    }
    Vec::new()
}

fn redo(state: &mut State) -> Vec<Effect> {
    if let Some(open) = &mut state.open
        && let Some(text) = open.redo.pop()
    {
        open.undo.push(std::mem::replace(&mut open.text, text));
        return changed(state);
    }
    Vec::new()
}

/// What every change of the text entails: fields and table anew, the draft kept, a re-solve.
fn changed(state: &mut State) -> Vec<Effect> {
    refresh(state);
    let mut effects = keep_draft(state);
    effects.extend(jobs::resolve(state));
    effects
}

/// Keeps what is unsaved on disk, so that no kind of exit loses it.
pub(super) fn keep_draft(state: &State) -> Vec<Effect> {
    state
        .open
        .iter()
        .map(|open| Effect::KeepDraft {
            path: open.path.clone(),
            text: open.unsaved().then(|| open.text.clone()),
        })
        .collect()
}

/// Reads case and fields from the text again.
pub(super) fn refresh(state: &mut State) {
    let Some(open) = &mut state.open else {
        return;
    };
    match backend::parse(&open.text, &open.file) {
        Ok(case) => {
            open.rows = backend::rows(&open.text, &case);
            open.case = case;
        }
        // Edits are checked before they are taken; an old text that no longer passes is told, and
        // the fields stay as they were.
        Err(problem) => state.say(Level::Error, problem),
    }
    if let Some(open) = &mut state.open {
        open.field = open.field.min(open.fields().count().saturating_sub(1));
    }
    runs::check(state);
}

/// Puts the field back to what the file says.
fn reset(state: &mut State) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let Some(path) = open.current_field().map(|row| row.path.clone()) else {
        return Vec::new();
    };
    let of_file = backend::parse(&open.saved, &open.file)
        .ok()
        .and_then(|case| {
            backend::rows(&open.saved, &case)
                .into_iter()
                .find(|row| row.path == path)
        });
    let Some(row) = of_file.filter(|row| !row.value.is_empty()) else {
        return info(
            state,
            "The file gives no value here; `u` undoes the edits one by one.",
        );
    };
    let result = backend::set(&open.text, &path, &row.value);
    match result {
        Ok(text) => change(state, text),
        Err(problem) => super::overlay::warn(state, problem),
    }
}

fn group(state: &mut State, forward: bool) -> Vec<Effect> {
    if let Some(open) = &mut state.open {
        let groups: Vec<String> = open.fields().map(|row| row.group.clone()).collect();
        let begins = |i: &usize| *i == 0 || groups[*i] != groups[*i - 1];
        let at = open.field;
        let found = if forward {
            (at + 1..groups.len()).find(begins)
        } else {
            (0..at.min(groups.len())).rev().find(begins)
        };
        open.field = found.unwrap_or(at);
    }
    Vec::new()
}

/// The solver is an input like any other: it is written to the text, and can be undone.
fn next_method(state: &mut State) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let now = backend::method_word(open.case.solver.method);
    let at = METHODS.iter().position(|m| *m == now).unwrap_or(0);
    let next = METHODS[(at + 1) % METHODS.len()];
    match backend::set(&open.text, "solver.method", next) {
        Ok(text) => {
            let effects = change(state, text);
            info(state, format!("The solver is now `{next}`."));
            effects
        }
        Err(problem) => super::overlay::warn(state, problem),
    }
}

/// Brings back the edits of an earlier session.
pub(super) fn recover(state: &mut State, text: String) -> Vec<Effect> {
    let Some(open) = &state.open else {
        return Vec::new();
    };
    let path = open.path.clone();
    if let Err(problem) = backend::parse(&text, &open.file) {
        return super::overlay::warn(
            state,
            format!("The kept edits no longer pass and stay where they are: {problem}"),
        );
    }
    let mut effects = change(state, text);
    effects.push(Effect::DropRecovery(path));
    // The draft of this session is written after the old one is dropped.
    effects.extend(keep_draft(state));
    info(
        state,
        "The edits of the earlier session are back. `u` undoes them.",
    );
    effects
}
