//! Keys and pastes: first to what is typed, then to what lies over the screen, then to the table.

use super::notice::info;
use super::text_input::type_text;
use super::{cases, edit, overlay, quit};
use crate::tui::key::Key;
use crate::tui::msg::Effect;
use crate::tui::panes;
use crate::tui::state::{AppState, Level, Overlay};

pub(super) fn key(state: &mut AppState, key: Key) -> Vec<Effect> {
    if state.note.as_ref().is_some_and(|n| n.level == Level::Info) {
        state.note = None;
    }
    if key != Key::Ctrl('c') {
        state.interrupted = false;
    }
    if state.overlay.is_some() {
        return overlay::key(state, key);
    }
    if let Some(effects) = edit::typing_key(state, key) {
        return effects;
    }
    if let Some(effects) = cases::typing_key(state, key) {
        return effects;
    }
    match panes::find(state, key) {
        Some(found) => overlay::run_command(state, found.id),
        None if key == Key::Esc => Vec::new(),
        None => info(
            state,
            format!("`{key}` does nothing here. `?` shows the keys that do."),
        ),
    }
}

pub(super) fn paste(state: &mut AppState, text: &str) -> Vec<Effect> {
    match &mut state.overlay {
        Some(Overlay::Palette { input, cursor }) => {
            type_text(input, text);
            *cursor = 0;
            return Vec::new();
        }
        Some(Overlay::SaveAs { input, .. } | Overlay::Until { input, .. }) => {
            type_text(input, text);
            return Vec::new();
        }
        Some(_) => return Vec::new(),
        None => {}
    }
    if let Some(editor) = state.editor_mut() {
        if let Some(editing) = &mut editor.editing {
            type_text(&mut editing.input, text);
            editing.problem = None;
            return Vec::new();
        }
        if editor.filtering {
            type_text(&mut editor.filter, text);
            editor.field = 0;
            return Vec::new();
        }
    } else if state.cases.typing {
        type_text(&mut state.cases.filter, text);
        state.cases.cursor = 0;
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
    super::jobs::cancel_focused(state)
}
