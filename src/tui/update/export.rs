//! Files written from what the panes show, and when the text report of a run is asked for.

use std::path::PathBuf;

use super::notice::info;
use crate::case::judging_rows::is_judging;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::report::document::ReportFormat;
use crate::state::report::ReportRequest;
use crate::state::text_request::{TextOf, TextRequest};
use crate::state::trials::Trials;
use crate::state::{AppState, Document, Overlay, Question};

/// Width of texts that are written to files.
pub const TEXT_WIDTH: usize = 100;

/// Writes a text to a file, where there is one.
#[must_use]
pub fn write(path: PathBuf, text: Option<String>, what: &'static str) -> Vec<Effect> {
    text.map(|text| Effect::WriteText { path, text, what })
        .into_iter()
        .collect()
}

/// Asks for the report of the chosen run where it is seen, one report after the other.
pub(super) fn follow_report(state: &mut AppState) -> Option<Effect> {
    let document = state.document.as_mut()?;
    if document.pane != PaneId::Report {
        return None;
    }
    let Some((wanted, open)) = wanted_report(document, state.trials.as_ref()) else {
        document.runs_view_mut()?.report = None;
        return None;
    };
    let view = document.runs_view_mut()?;
    if open || view.report_asked.is_some() || view.report_of.as_ref() == Some(&wanted) {
        return None;
    }
    view.report_asked = Some(wanted.clone());
    Some(Effect::MakeReport(Box::new(wanted)))
}

/// The report of the chosen run, and whether its validation table is still being made.
fn wanted_report(document: &Document, trials: Option<&Trials>) -> Option<(ReportRequest, bool)> {
    let (name, run, dir) = document.runs_view()?.reported()?;
    let line = document.line();
    let line = line.filter(|_| run.case_text == document.editor.text);
    // Its validation table is that of the runs as they are now.
    let open = line.is_some_and(|line| line.checking.is_open());
    let file = document.editor.file.clone();
    let studies = trials.and_then(|trials| trials.study(&file));
    let wanted = ReportRequest {
        name,
        run,
        dir,
        file,
        checks: line.map(|line| line.checks.rows.clone()),
        studies: studies.into_iter().collect(),
    };
    Some((wanted, open))
}

/// Writes the report of the chosen run in a format; as text what is shown.
fn write_run_report(
    document: &Document,
    trials: Option<&Trials>,
    format: ReportFormat,
) -> Vec<Effect> {
    let Some((request, _)) = wanted_report(document, trials) else {
        return Vec::new();
    };
    let name = format!("report.{}", format.ending());
    let beside = format!("{}-{name}", document.editor.stem());
    let dir = request.dir.as_ref();
    let path = dir.map_or_else(|| PathBuf::from(beside), |dir| dir.join(name));
    write_made(TextOf::Run(Box::new(request), format), path)
}

/// Asks for the format of the report.
pub(super) fn ask_format(state: &mut AppState) -> Vec<Effect> {
    state.overlay = Some(Overlay::Ask(Question::ReportFormat));
    Vec::new()
}

/// Writes the report of what is open in a format.
pub(super) fn write_report_as(state: &mut AppState, format: ReportFormat) -> Vec<Effect> {
    match &state.document {
        Some(document) if document.pane == PaneId::Report => {
            write_run_report(document, state.trials.as_ref(), format)
        }
        _ => write_report(state, format),
    }
}

/// A report is there.
pub(super) fn reported(state: &mut AppState, of: &ReportRequest, text: String) -> Vec<Effect> {
    if let Some(view) = state.runs_view_mut()
        && view.report_asked.as_ref() == Some(of)
    {
        view.report = Some((of.name.clone(), text));
        view.report_of = view.report_asked.take();
    }
    Vec::new()
}

/// Writes the report of a file other than a line case in a format.
pub(super) fn write_report(state: &mut AppState, format: ReportFormat) -> Vec<Effect> {
    let glyphs = state.capabilities.glyphs;
    let Some(document) = &state.document else {
        return Vec::new();
    };
    let kind = document.kind();
    if kind.busy().is_some() {
        return still_computing(state);
    }
    let (name, _) = kind.report_name();
    let path = PathBuf::from(format!(
        "{}-{name}.{}",
        document.editor.stem(),
        format.ending()
    ));
    let mut rows = document.editor.rows.clone();
    rows.retain(|row| !is_judging(&row.path));
    let of = TextOf::Report(document.content.clone(), rows, format, glyphs);
    write_made(of, path)
}

/// Writes a text that is made behind the screen.
#[must_use]
pub fn write_made(of: TextOf, path: PathBuf) -> Vec<Effect> {
    vec![Effect::WriteMade(Box::new(TextRequest { of, path }))]
}

/// Writes the input for a line case.
pub(super) fn write_line_input(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &state.document else {
        return Vec::new();
    };
    if document.kind().busy().is_some() {
        return still_computing(state);
    }
    let stem = PathBuf::from(document.editor.stem());
    write_made(TextOf::LineInput(document.content.clone()), stem)
}

fn still_computing(state: &mut AppState) -> Vec<Effect> {
    let words = "The dynamic analysis is still running; its results can be written when it ends.";
    info(state, words)
}
