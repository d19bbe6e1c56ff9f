//! Files written from what the panes show, and the text report of a run.

use std::path::PathBuf;

use super::notice::info;
use crate::reference;
use crate::tui::facade;
use crate::tui::msg::Effect;
use crate::tui::state::{AppState, Document};

/// Width of texts that are written to files.
pub const TEXT_WIDTH: usize = 100;

/// Writes a text to a file, where there is one.
#[must_use]
pub fn write(path: PathBuf, text: Option<String>, what: &'static str) -> Vec<Effect> {
    text.map(|text| Effect::WriteText { path, text, what })
        .into_iter()
        .collect()
}

/// Makes the report of the chosen run of a line case.
pub(super) fn make_report(document: &mut Document) {
    let Some((line, editor)) = document.line_and_editor() else {
        return;
    };
    line.report = line.reported().map(|(name, run, _)| {
        let text = match facade::parse(&run.case_text, &editor.file) {
            Ok(case) => {
                let rows = if run.case_text == editor.text {
                    line.checks.clone()
                } else {
                    reference::rows_of_run(&run, &case)
                };
                facade::report(&run, &case, &rows)
            }
            Err(problem) => problem,
        };
        (name, text)
    });
}

/// Writes the report of a file other than a line case.
pub(super) fn write_report(state: &mut AppState) -> Vec<Effect> {
    let glyphs = state.capabilities.glyphs;
    let Some(document) = &state.document else {
        return Vec::new();
    };
    let kind = document.kind();
    if kind.busy().is_some() {
        return still_computing(state);
    }
    let (name, what) = kind.report_name();
    let path = PathBuf::from(format!("{}-{name}.txt", document.editor.stem()));
    write(path, kind.report(&document.editor, glyphs), what)
}

/// Writes the input for a line case.
pub(super) fn write_line_input(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &state.document else {
        return Vec::new();
    };
    if document.kind().busy().is_some() {
        return still_computing(state);
    }
    match document.kind().line_input(document.editor.stem()) {
        (path, Some(text), what) => write(path, Some(text), what),
        _ => info(state, "There is nothing to write."),
    }
}

fn still_computing(state: &mut AppState) -> Vec<Effect> {
    let words = "The dynamic analysis is still running; its results can be written when it ends.";
    info(state, words)
}
