//! The end of the program.

use crate::msg::Effect;
use crate::state::{AppState, Overlay, Question};
use std::path::PathBuf;

/// Ends the program. Ranges that wait for one in a further field are dropped as they are when the case is left.
pub(super) fn now(state: &AppState) -> Vec<Effect> {
    let mut effects = drop_ranges(state);
    effects.push(Effect::Quit);
    effects
}

/// Where nothing else is unsaved, nothing is to be recovered.
pub(super) fn drop_ranges(state: &AppState) -> Vec<Effect> {
    let editor = state.editor();
    let editor = editor.filter(|editor| !editor.unsaved() && !editor.kept.is_empty());
    let path = editor.map(|editor| editor.path.clone());
    path.map(nothing_unsaved).into_iter().collect()
}

pub(super) const fn nothing_unsaved(path: PathBuf) -> Effect {
    Effect::KeepRecovery {
        path,
        text: None,
        kept: Vec::new(),
    }
}

/// A quit that waits for jobs continues when they have ended.
pub(super) fn quit_if_asked(state: &mut AppState) -> Vec<Effect> {
    let asked = matches!(
        state.overlay,
        Some(Overlay::Ask(
            Question::JobsRunning | Question::JobsGoOn { .. }
        ))
    );
    if asked && state.jobs.open() == 0 {
        state.overlay = None;
        return now(state);
    }
    Vec::new()
}
