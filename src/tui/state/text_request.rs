//! A text of a document, asked for to be written or shown.

use super::{document_content::DocumentContent, report::ReportRequest};
use crate::facade::FieldRow;
use crate::line_tables::LineTable;
use crate::{chart::Glyphs, report::document::ReportFormat, run::Run};
use std::{path::PathBuf, sync::Arc};

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
    /// The report of a file other than a line case in a format, with the fields of the file and the characters of its charts.
    Report(DocumentContent, Vec<FieldRow>, ReportFormat, Glyphs),
    /// The report of a run in a format.
    Run(Box<ReportRequest>, ReportFormat),
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
            TextOf::Report(content, rows, format, glyphs) => {
                let kind = content.kind();
                let subject = kind.report(&rows);
                let text = subject.and_then(|subject| subject.write(format, glyphs, &[]).ok());
                (self.path, text, kind.report_name().1)
            }
            TextOf::Run(request, format) => (self.path, request.written(format).ok(), "The report"),
            TextOf::LineInput(content) => {
                let stem = self.path.to_string_lossy();
                content.kind().line_input(&stem)
            }
            TextOf::Line(table, run) => (self.path, Some(table.csv(&run)), "The table"),
        }
    }
}
