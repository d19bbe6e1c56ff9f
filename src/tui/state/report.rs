//! Text reports, of runs and of files of other kinds, made away from the drawing thread.

use std::path::PathBuf;
use std::sync::Arc;

use super::document::DocumentContent;

use crate::kinds::FileType;
use crate::reference::{self, ValidationRow};
use crate::report::chart::Glyphs;
use crate::report::system::motion;
use crate::report::text::WIDTH;
use crate::run::Run;
use crate::tui::facade::{self, FieldRow};
use crate::tui::line_tables::LineTable;

/// A report that is asked for.
#[derive(Debug, Clone)]
pub struct ReportRequest {
    /// Name of the run.
    pub name: String,
    /// The run.
    pub run: Arc<Run>,
    /// Name of the file of its case.
    pub file: String,
    /// The validation table, where the run is of the edited case; else that of the run alone.
    pub checks: Option<Vec<ValidationRow>>,
}

impl PartialEq for ReportRequest {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.run, &other.run)
            && (&self.name, &self.file, &self.checks) == (&other.name, &other.file, &other.checks)
    }
}

impl ReportRequest {
    /// The report.
    #[must_use]
    pub fn text(&self) -> String {
        if FileType::of_text(&self.run.case_text) == FileType::System {
            let report = motion::stored_report(&self.run);
            let text = report.map(|report| report.to_text(WIDTH, Glyphs::Braille));
            return text.unwrap_or_else(|all| facade::first(&all, &self.file));
        }
        match facade::parse(&self.run.case_text, &self.file) {
            Ok(case) => {
                let own = || reference::rows_of_run(&self.run, &case);
                let rows = self.checks.clone().unwrap_or_else(own);
                facade::report(&self.run, &case, &rows)
            }
            Err(problem) => problem,
        }
    }
}

/// A text that is to be made and written.
#[derive(Debug, Clone)]
pub struct TextRequest {
    /// What it is of.
    pub of: TextOf,
    /// Where to; the name of an input for a line case begins with it.
    pub path: PathBuf,
}

/// What a text is of.
#[derive(Debug, Clone)]
pub enum TextOf {
    /// The report of a file other than a line case, with the fields of the file and the characters of its charts.
    Report(DocumentContent, Vec<FieldRow>, Glyphs),
    /// The input for a line case that a file of another kind gives.
    LineInput(DocumentContent),
    /// A table of a run's line, as CSV.
    Line(LineTable, Arc<Run>),
}

impl TextRequest {
    /// Where to, the text, and what it is; the text is absent where there is no result.
    #[must_use]
    pub fn text(self) -> (PathBuf, Option<String>, &'static str) {
        match self.of {
            TextOf::Report(content, rows, glyphs) => {
                let kind = content.kind();
                (self.path, kind.report(&rows, glyphs), kind.report_name().1)
            }
            TextOf::LineInput(content) => {
                let stem = self.path.to_string_lossy();
                content.kind().line_input(&stem)
            }
            TextOf::Line(table, run) => (self.path, Some(table.csv(&run)), "The table"),
        }
    }
}
