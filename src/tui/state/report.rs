//! Reports of runs and of files of other kinds, made away from the drawing thread.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::chart::Glyphs;
use crate::facade;
use crate::reference::ValidationRow;
use crate::report::document::ReportFormat;
use crate::report::subject::{ReportSubject, RunSubject, StudyTable};
use crate::run::Run;

/// A report that is asked for.
#[derive(Debug, Clone)]
pub struct ReportRequest {
    /// Name of the run.
    pub name: String,
    /// The run.
    pub run: Arc<Run>,
    /// Its directory, where it is stored.
    pub dir: Option<PathBuf>,
    /// Name of the file of its case.
    pub file: String,
    /// The validation table, where the run is of the edited case; else that of the run alone.
    pub checks: Option<Vec<ValidationRow>>,
    /// Tables of studies that were run on the screen.
    pub studies: Vec<StudyTable>,
}

impl PartialEq for ReportRequest {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.run, &other.run)
            && (&self.name, &self.file, &self.dir) == (&other.name, &other.file, &other.dir)
            && (&self.checks, &self.studies) == (&other.checks, &other.studies)
    }
}

impl ReportRequest {
    /// The text report, or why there is none.
    #[must_use]
    pub fn text(&self) -> String {
        self.written(ReportFormat::Text).unwrap_or_else(|why| why)
    }

    /// The report in a format.
    ///
    /// # Errors
    /// What is wrong with the text of its case, in words.
    pub fn written(&self, format: ReportFormat) -> Result<String, String> {
        let subject = ReportSubject::Run(RunSubject {
            run: &self.run,
            dir: self.dir.as_deref().unwrap_or(Path::new("")),
            rows: self.checks.as_deref(),
            against: None,
        });
        // A file is the same whatever the terminal shows.
        let written = subject.write(format, Glyphs::Braille, &self.studies);
        written.map_err(|all| facade::first(&all, &self.file))
    }
}
