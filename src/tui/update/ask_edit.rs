//! Edits are asked for, one check after the other.

use crate::msg::Effect;
use crate::state::AppState;
use crate::state::edit_check::EditCheck;
use crate::state::pending::PendingEdit;

/// Asks for an edit.
pub(super) fn ask(state: &mut AppState, edit: PendingEdit) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut() {
        editor.pending.push(edit);
    }
    send(state)
}

/// Asks for the check of what waits, unless one is under way.
pub(super) fn send(state: &mut AppState) -> Vec<Effect> {
    let number = state.checks + 1;
    let Some(document) = &mut state.document else {
        return Vec::new();
    };
    let Some(edits) = document.editor.pending.begin(number) else {
        return Vec::new();
    };
    state.checks = number;
    vec![Effect::CheckEdits(Box::new(EditCheck {
        number,
        file: document.file(),
        text: document.editor.text.clone(),
        edits,
    }))]
}
