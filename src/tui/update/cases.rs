//! The list of cases, and opening one.

use std::path::PathBuf;

use super::motion::moved;
use super::text_input::type_key;
use super::{edit, jobs, runs, ship};
use crate::tui::case_library::FIRST;
use crate::tui::key::Key;
use crate::tui::msg::{Effect, FileRead};
use crate::tui::state::{AppState, CaseEntry, Document, Level, Overlay, ParameterEditor, Question};

/// Keys while the filter is typed.
pub(super) fn typing_key(state: &mut AppState, key: Key) -> Option<Vec<Effect>> {
    if state.editor().is_some() || !state.cases.typing {
        return None;
    }
    let lines = state.cases.shown().count();
    let cases = &mut state.cases;
    match key {
        Key::Enter => cases.typing = false,
        Key::Esc | Key::Ctrl('c') => {
            cases.typing = false;
            cases.filter.reset();
            cases.cursor = 0;
        }
        Key::Down => cases.cursor = moved(cases.cursor, 1, lines),
        Key::Up => cases.cursor = moved(cases.cursor, -1, lines),
        Key::Ctrl('z') => return Some(vec![Effect::Suspend]),
        _ => {
            if type_key(&mut cases.filter, key) {
                cases.cursor = 0;
            }
        }
    }
    Some(Vec::new())
}

pub(super) fn listed(state: &mut AppState, dir: PathBuf, entries: Vec<CaseEntry>) -> Vec<Effect> {
    let before = state.cases.current().map(|e| e.path.clone());
    state.cases.dir = dir;
    state.cases.entries = entries;
    // The cursor stays on its case; at first it is on the one that newcomers should see.
    let at = match before {
        Some(path) => state.cases.shown().position(|e| e.path == path),
        None => state.cases.shown().position(|e| e.name == FIRST),
    };
    let lines = state.cases.shown().count();
    state.cases.cursor = at
        .unwrap_or(state.cases.cursor)
        .min(lines.saturating_sub(1));
    Vec::new()
}

pub(super) fn rejected(state: &mut AppState, title: String, text: String) -> Vec<Effect> {
    state.say(Level::Error, format!("{title} cannot be opened."));
    state.overlay = Some(Overlay::Text {
        title,
        text,
        scroll: 0,
    });
    Vec::new()
}

pub(super) fn opened(state: &mut AppState, read: FileRead) -> Vec<Effect> {
    state.close();
    let editor = ParameterEditor::new(read.path, read.text);
    state.document = Some(Document::new(editor, read.content));
    edit::refresh(state);
    let mut effects = jobs::resolve(state);
    effects.extend(ship::resolve(state));
    effects.extend(runs::list(state));
    if let Some(text) = read.recovered {
        state.overlay = Some(Overlay::Ask(Question::Recover { text }));
    }
    effects
}
