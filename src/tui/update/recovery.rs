//! Unsaved edits kept for a session that is recovered.

use crate::msg::Effect;
use crate::state::{AppState, KeptRange};
use std::path::PathBuf;

/// Keeps what is unsaved on disk, so that no kind of exit loses it.
pub(super) fn keep_recovery(state: &AppState) -> Vec<Effect> {
    let keep = |(path, text, kept)| Effect::KeepRecovery { path, text, kept };
    unsaved(state).map(keep).into_iter().collect()
}

/// Keeps what is unsaved, in place of what an earlier session left.
pub(super) fn take_over_recovery(state: &AppState) -> Vec<Effect> {
    let take = |(path, text, kept)| Effect::TakeOverRecovery { path, text, kept };
    unsaved(state).map(take).into_iter().collect()
}

/// The file that is open, its text where that or a range is unsaved, and the ranges.
pub(super) fn unsaved(state: &AppState) -> Option<(PathBuf, Option<String>, Vec<String>)> {
    let editor = state.editor()?;
    let text = (editor.unsaved() || !editor.kept.is_empty()).then(|| editor.text.clone());
    let kept = editor.kept.iter().map(KeptRange::word).collect();
    Some((editor.path.clone(), text, kept))
}
