//! The rows that a filter leaves, after it has changed.

use crate::pane::PaneId;
use crate::state::AppState;

/// Brings the list that has the focus in step with its filter, where it keeps the lines that pass.
pub(super) fn filtered(state: &mut AppState) {
    match state.focus() {
        PaneId::Runs => {
            if let Some(view) = state.runs_view_mut() {
                view.runs.filter_rows();
            }
        }
        PaneId::Sweep => {
            if let Some(open) = state.sweeps_mut().and_then(|view| view.open.as_mut()) {
                open.arrange();
            }
        }
        _ => {}
    }
}
