//! Text reports, of runs and of files of other kinds, made away from the drawing thread.

use std::path::PathBuf;
use std::sync::Arc;

use super::document::DocumentContent;

use crate::reference::{self, ValidationRow};
use crate::report::chart::Glyphs;
use crate::run::Run;
use crate::tui::facade::{self, FieldRow};

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

/// A report of a file other than a line case, that is to be written.
#[derive(Debug, Clone)]
pub struct ModelReport {
    /// What it reports on.
    pub content: DocumentContent,
    /// The fields of the file.
    pub rows: Vec<FieldRow>,
    /// Characters of its charts.
    pub glyphs: Glyphs,
    /// Where to.
    pub path: PathBuf,
}

impl ModelReport {
    /// The report, and what it is; absent where there is no result.
    #[must_use]
    pub fn text(&self) -> Option<(String, &'static str)> {
        let kind = self.content.kind();
        let text = kind.report(&self.rows, self.glyphs)?;
        Some((text, kind.report_name().1))
    }
}
