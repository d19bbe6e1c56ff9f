//! Natural modes: computed in the background, again when the case changes, one computation at a time.

use std::sync::Arc;

use crate::modes::LineModes;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::state::AppState;

/// Asks for the modes of the edited file, where they are seen and not known.
pub(super) fn follow(state: &mut AppState) -> Option<Effect> {
    let document = state.document.as_mut()?;
    let pane = document.pane;
    let of = document.content.of_modes();
    let (view, editor) = document.modes_and_editor()?;
    match pane {
        PaneId::Modes => view.beside = true,
        PaneId::Inputs | PaneId::Runs | PaneId::Jobs => {}
        _ => view.beside = false,
    }
    let known = view.found.is_some() && view.text == editor.text;
    if !view.beside || known || view.going.is_some() {
        return None;
    }
    view.going = Some(editor.text.clone());
    Some(Effect::FindModes {
        of: of?,
        text: editor.text.clone(),
    })
}

/// Takes over the modes of a text, unless nothing waits for them any more.
pub(super) fn computed(
    state: &mut AppState,
    text: String,
    found: Result<Arc<LineModes>, String>,
) -> Vec<Effect> {
    if let Some(modes) = state.modes_mut()
        && modes.going.as_ref() == Some(&text)
    {
        modes.going = None;
        modes.found = Some(found);
        modes.text = text;
    }
    Vec::new()
}
