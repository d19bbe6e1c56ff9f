//! Pages of text that are worked out behind the screen, and read over it.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::jobs::overrides;
use super::notice::{info, warn};
use super::results;
use crate::case::attachments::with_files;
use crate::msg::{Effect, RunToCompare};
use crate::result_lines::solved_run;
use crate::state::study_of::{RunningStudy, StudyOf};
use crate::state::study_request::StudyRequest;
use crate::state::{AppState, Overlay, RunEntry};
use crate::study::points::BaseCase;
use crate::table::Table;

/// Columns of a page: what the box over the screen has inside.
fn width(state: &AppState) -> usize {
    usize::from(state.size.0.saturating_sub(4).clamp(40, 160))
}

/// Compares the marked runs; where only one is chosen, with the run held against or the live one.
pub fn compare(state: &mut AppState) -> Vec<Effect> {
    let width = width(state);
    let Some(view) = state.runs_view() else {
        return Vec::new();
    };
    let chosen = view.runs.chosen();
    let mut runs: Vec<RunToCompare> = chosen.iter().filter_map(|run| of_entry(run)).collect();
    if runs.len() == 1 {
        let against = view.against.as_ref().map(|(_, run)| run);
        if let Some(run) = against.or_else(|| solved_run(view)) {
            runs.insert(0, RunToCompare::Memory(Arc::clone(run)));
        }
    }
    if runs.len() < 2 {
        return warn(state, "Two runs are compared, or more: `:mark` marks them.");
    }
    let name = format!("{} runs compared", runs.len());
    let effects = vec![Effect::Compare {
        runs,
        width,
        glyphs: state.capabilities.glyphs,
        name,
    }];
    info(state, "The runs are being compared.");
    effects
}

fn of_entry(run: &RunEntry) -> Option<RunToCompare> {
    match &run.curves.run {
        Some(whole) => Some(RunToCompare::Memory(Arc::clone(whole))),
        None => run.dir.clone().map(RunToCompare::Stored),
    }
}

/// Why runs cannot be compared now.
#[must_use]
pub fn why_not_compared(state: &AppState) -> Option<&'static str> {
    let view = state.runs_view()?;
    let chosen = view.runs.chosen().len();
    let other = view.against.is_some() || solved_run(view).is_some();
    match (chosen, other) {
        (0, _) => Some("Two runs are compared, or more: `:mark` marks them."),
        (1, false) => {
            Some("There is no other run to compare this one with; `:mark` marks several.")
        }
        _ => None,
    }
}

/// Varies every input, or leaves out every effect of the scene, and ranks what that does to the result under the cursor.
pub fn study(state: &mut AppState, of: StudyOf) -> Vec<Effect> {
    let width = width(state);
    let Some(result) = results::at_cursor(state) else {
        return Vec::new();
    };
    let Some(document) = state.document.as_mut() else {
        return Vec::new();
    };
    let cancel = Arc::new(AtomicBool::new(false));
    let study = RunningStudy::new(of, Arc::clone(&cancel));
    if let Some(old) = document.study.replace(study) {
        old.cancel.store(true, Ordering::Relaxed);
    }
    let (editor, files) = (&document.editor, document.content.files());
    let request = StudyRequest {
        of,
        kind: document.content.file_type(),
        base: BaseCase {
            text: with_files(&editor.text, &files).into_owned(),
            path: editor.path.display().to_string(),
            overrides: overrides(editor),
            files,
        },
        result,
        width,
    };
    info(
        state,
        "Computed in the background; a page opens when it is done. `ctrl+c` stops it.",
    );
    vec![Effect::Study(Box::new(request), cancel)]
}

/// Opens a page with a table.
pub fn open_table(state: &mut AppState, title: &str, table: &Table) -> Vec<Effect> {
    if table.rows.is_empty() {
        return info(
            state,
            "No curve here has a value for each place of the axis.",
        );
    }
    let text = table.to_text(width(state));
    state.overlay = Some(Overlay::Page {
        title: title.to_owned(),
        text,
        scroll: 0,
    });
    Vec::new()
}

/// How far a study is.
pub(super) fn progress(state: &mut AppState, done: usize, of: usize) -> Vec<Effect> {
    if let Some(study) = state
        .document
        .as_mut()
        .and_then(|document| document.study.as_mut())
    {
        (study.done, study.all) = (done, of);
    }
    Vec::new()
}

/// A page is there, or the reason why not.
pub(super) fn opened(
    state: &mut AppState,
    title: String,
    text: Result<String, String>,
    of_study: bool,
) -> Vec<Effect> {
    if of_study && let Some(document) = &mut state.document {
        document.study = None;
    }
    match text {
        Ok(text) => {
            state.note = None;
            state.overlay = Some(Overlay::Page {
                title,
                text,
                scroll: 0,
            });
            Vec::new()
        }
        Err(why) => warn(state, why),
    }
}

/// Writes a page to a file named after the case.
pub fn write(state: &AppState, title: &str, text: &str) -> Vec<Effect> {
    let stem = state.editor().map_or("page", |editor| editor.stem());
    let words: String = title
        .chars()
        .map(|c| if c.is_alphanumeric() { c } else { '-' })
        .collect();
    vec![Effect::WriteText {
        path: PathBuf::from(format!("{stem}-{words}.txt")),
        text: text.to_owned(),
        what: "The page",
    }]
}

/// Stops the study that computes; returns whether there was one.
pub(super) fn stop(state: &mut AppState) -> bool {
    let document = state.document.as_mut();
    let study = document.and_then(|document| document.study.take());
    study.is_some_and(|study| {
        study.cancel.store(true, Ordering::Relaxed);
        true
    })
}
