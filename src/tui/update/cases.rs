//! The list of cases, and opening one.

use std::path::PathBuf;

use super::build::new_file;
use super::notice::info;
use super::{job_processes, jobs, results, runs, ship, sweeps};
use crate::case_library::FIRST;
use crate::msg::{Effect, FileRead};
use crate::state::{AppState, CaseEntry, Document, Overlay, Question, Severity};

pub(super) fn listed(state: &mut AppState, dir: PathBuf, entries: Vec<CaseEntry>) -> Vec<Effect> {
    let before = state.cases.current().map(|e| e.path.clone());
    state.cases.dir = dir;
    state.cases.is_read = true;
    state.cases.entries = entries;
    // The cursor stays on its case; at first it is on the one that newcomers should see.
    let at = match before {
        Some(path) => state.cases.shown().iter().position(|e| e.path == path),
        None => state.cases.shown().iter().position(|e| e.name == FIRST),
    };
    let lines = state.cases.shown().len();
    state.cases.cursor = at
        .unwrap_or(state.cases.cursor)
        .min(lines.saturating_sub(1));
    Vec::new()
}

/// A file of the list as the user's editor left it: the list is read again, and what is wrong with the file is shown.
pub(super) fn edited(state: &mut AppState, read: Result<String, String>) -> Vec<Effect> {
    let file = state.cases.current().map(|entry| entry.path.clone());
    match (read, file) {
        (Ok(_), _) => info(state, "The list is read again; Enter opens the file."),
        (Err(story), file) => {
            let title = "The file as the editor left it".to_owned();
            rejected(state, title, file.unwrap_or_default(), story)
        }
    };
    vec![Effect::ReadCases]
}

pub(super) fn rejected(
    state: &mut AppState,
    title: String,
    file: PathBuf,
    text: String,
) -> Vec<Effect> {
    state.cases.opening = None;
    state.say(Severity::Error, format!("{title} cannot be opened."));
    state.overlay = Some(Overlay::Text {
        title,
        text,
        scroll: 0,
        file,
    });
    Vec::new()
}

pub(super) fn opened(state: &mut AppState, read: FileRead) -> Vec<Effect> {
    state.close();
    state.cases.opening = None;
    let made = new_file::is_asked(state);
    state.document = Some(Document::new(read.path, read.read));
    runs::check(state);
    if let Some(editor) = state
        .document
        .as_mut()
        .filter(|d| d.line().is_some())
        .map(|d| &mut d.editor)
    {
        editor.folded = true;
    }
    let earlier = state.earlier.take();
    if let Some(document) = &mut state.document
        && let Some(earlier) = earlier.filter(|earlier| earlier.is_of(&document.editor.path))
    {
        earlier.restore(document);
    }
    results::main_ones(state);
    let mut effects = jobs::resolve(state);
    if made {
        // The list has it too, once it is seen again.
        state.overlay = None;
        effects.push(Effect::ReadCases);
    }
    effects.extend(ship::resolve(state));
    effects.extend(runs::list(state));
    effects.extend(sweeps::list(state));
    effects.extend(job_processes::show(state));
    if let Some(left) = read.recovered {
        state.overlay = Some(Overlay::Ask(Question::Recover { left }));
    }
    effects
}
