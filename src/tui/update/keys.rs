//! Keys and pastes: first to what is typed, then to what lies over the screen, then to the table.

use super::filter::filtered;
use super::motion::moved;
use super::notice::info;
use super::text_input::{type_key, type_text};
use super::{command_line, edit, overlay, quit};
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::panes;
use crate::state::overlay::LineTypePicker;
use crate::state::{AppState, Filter, Overlay, Severity};

pub(super) fn key(state: &mut AppState, key: KeyPress) -> Vec<Effect> {
    if state
        .note
        .as_ref()
        .is_some_and(|n| n.level == Severity::Info)
    {
        state.note = None;
    }
    if key != KeyPress::Ctrl('c') {
        state.interrupted = false;
    }
    if state.overlay.is_some() {
        return overlay::key(state, key);
    }
    if let Some(effects) = edit::typing_key(state, key) {
        return effects;
    }
    if let Some(effects) = filter_key(state, key) {
        return effects;
    }
    match panes::find(state, key) {
        Some(found) => overlay::run_command(state, found.id),
        None if key == KeyPress::Esc => Vec::new(),
        None => info(
            state,
            format!("`{key}` does nothing here. `:help` shows the keys that do."),
        ),
    }
}

/// Keys while a filter is typed.
fn filter_key(state: &mut AppState, key: KeyPress) -> Option<Vec<Effect>> {
    let (filter, cursor, lines) = state.filter_mut()?;
    if !filter.typing {
        return None;
    }
    let before = filter.input.value().to_owned();
    match key {
        KeyPress::Ctrl('z') => return Some(vec![Effect::Suspend]),
        KeyPress::Enter => filter.typing = false,
        KeyPress::Esc | KeyPress::Ctrl('c') => {
            *filter = Filter::default();
            *cursor = 0;
        }
        KeyPress::Down => *cursor = moved(*cursor, 1, lines),
        KeyPress::Up => *cursor = moved(*cursor, -1, lines),
        _ => {
            if type_key(&mut filter.input, key) {
                *cursor = 0;
            }
        }
    }
    if filter.input.value() != before {
        filtered(state);
    }
    Some(Vec::new())
}

pub(super) fn paste(state: &mut AppState, text: &str) -> Vec<Effect> {
    match &mut state.overlay {
        Some(Overlay::Palette(line)) => {
            type_text(&mut line.input, text);
            command_line::begin_anew(line);
            return Vec::new();
        }
        Some(Overlay::Help { filter, .. } | Overlay::Messages { filter, .. }) => {
            if filter.typing {
                type_text(&mut filter.input, text);
            }
            return Vec::new();
        }
        Some(Overlay::Prompt { input, .. } | Overlay::LineTypes(LineTypePicker { input, .. })) => {
            type_text(input, text);
            return Vec::new();
        }
        Some(Overlay::Picker(picker)) => {
            type_text(&mut picker.input, text);
            picker.cursor = 0;
            return Vec::new();
        }
        Some(Overlay::Form(form)) => {
            if let Some(line) = form.current_mut() {
                type_text(&mut line.input, text);
            }
            form.problem.clear();
            return Vec::new();
        }
        Some(_) => return Vec::new(),
        None => {}
    }
    if let Some(editing) = state
        .editor_mut()
        .and_then(|editor| editor.editing.as_mut())
    {
        type_text(&mut editing.input, text);
        editing.problem = None;
        return Vec::new();
    }
    if let Some((filter, cursor, _)) = state.filter_mut()
        && filter.typing
    {
        type_text(&mut filter.input, text);
        *cursor = 0;
        filtered(state);
        return Vec::new();
    }
    info(
        state,
        "Pasted text goes into a field that is being edited; none is.",
    )
}

/// Ctrl-C: the first cancels, the second quits.
pub(super) fn interrupt(state: &mut AppState) -> Vec<Effect> {
    if std::mem::replace(&mut state.interrupted, true) {
        state.interrupted = false;
        return quit::quit(state);
    }
    if super::pages::stop(state) {
        return info(state, "The study is stopped. Ctrl-C again quits.");
    }
    super::jobs::cancel_focused(state)
}
