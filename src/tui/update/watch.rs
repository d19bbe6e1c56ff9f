//! Changes of files by other programs: taken over, or said where the user's edits would be lost.

use std::path::{Path, PathBuf};

use super::edit;
use super::notice::warn;
use crate::msg::Effect;
use crate::state::AppState;
use crate::visible;

/// Asks to watch what is open, or the directory listed, where that is another than before.
pub(super) fn follow(state: &mut AppState) -> Option<Effect> {
    let wanted = match state.editor() {
        Some(editor) => editor.path.clone(),
        None => state.cases.dir.clone(),
    };
    if wanted.as_os_str().is_empty() || state.watched.as_ref() == Some(&wanted) {
        return None;
    }
    state.watched = Some(wanted.clone());
    Some(Effect::Watch(wanted))
}

/// The file that is open has another text now.
pub(super) fn changed(state: &mut AppState, path: &Path, text: String) -> Vec<Effect> {
    let Some(editor) = state.editor_mut().filter(|editor| editor.path == path) else {
        return Vec::new();
    };
    let is_own = editor.saving.as_ref() == Some(&text) || editor.saved == text;
    if is_own {
        return Vec::new();
    }
    if editor.unsaved() || !editor.pending.is_empty() || editor.editing.is_some() {
        let words = format!(
            "{} was changed by another program; your edits are kept. `:save` asks which of both to save.",
            visible::path(path)
        );
        return warn(state, words);
    }
    editor.saved.clone_from(&text);
    let said =
        "The file was changed by another program and is read again. `:undo` takes that back.";
    edit::replace(state, text, said)
}

/// The directory of the list has other files now.
pub(super) fn listed(state: &AppState, dir: &PathBuf) -> Vec<Effect> {
    match state.document.is_none() && state.cases.dir == *dir {
        true => vec![Effect::ReadCases],
        false => Vec::new(),
    }
}
