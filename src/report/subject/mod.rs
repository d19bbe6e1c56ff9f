//! What a report is of, and the report in every format: the one way for the command line and the screen.

mod csv;
mod json;
mod studies;

use std::borrow::Cow;
use std::path::Path;

pub use studies::StudyTable;

use super::chart::Glyphs;
use super::document::{Report, ReportFormat};
use super::sweep::SweepReport;
use super::system::motion;
use super::text::{self, WIDTH};
use super::verdict::{self, RunVerdict};
use super::{comparison, ropeway, section, ship, system};
use seacable_model::case::{self, Case, Diagnostic, FieldRow, kind};
use seacable_model::kinds::FileType;
use seacable_model::section::Design;
use seacable_runs::reference::{self, ValidationRow};
use seacable_runs::run::Run;
pub use seacable_studies::comparison::Comparison;
use seacable_studies::study::seas::SeaQuestion;
use seacable_systems::ropeway::{ModelResults, SolvedRopeway};
pub use seacable_systems::ship::{DynamicAnalysis, StaticAnalysis};
use seacable_systems::system::analysis::analyses::Analyses;
use seacable_systems::system::{SolvedSystem, SystemFile};

/// A run, stored or in memory.
#[derive(Debug, Clone, Copy)]
pub struct RunSubject<'a> {
    /// The run.
    pub run: &'a Run,
    /// Its directory; empty for one in memory.
    pub dir: &'a Path,
    /// The validation table of its case, where that has runs of its own; else that of the run alone is made.
    pub rows: Option<&'a [ValidationRow]>,
    /// Another run from which the differences of this one are reported.
    pub against: Option<&'a Run>,
}

/// What a run was computed of.
enum RunInputs {
    Line(Box<Case>),
    System(Box<SolvedSystem>),
}

/// What a report is of. `fields` are those of the file.
#[derive(Debug, Clone)]
pub enum ReportSubject<'a> {
    /// A run of a line case, or of a system of lines in time.
    Run(RunSubject<'a>),
    /// A cross-section, with the tension of its load sharing \[N\], if another than the default.
    Section(&'a Design, &'a [FieldRow], Option<f64>),
    /// A ropeway at the position of the results.
    Ropeway(&'a SolvedRopeway, Box<ModelResults>, &'a [FieldRow]),
    /// A ship; without a dynamic analysis while that is still running.
    Ship(
        &'a StaticAnalysis,
        Option<&'a DynamicAnalysis>,
        &'a [FieldRow],
    ),
    /// A system of lines at rest.
    System(
        &'a SolvedSystem,
        &'a Analyses,
        &'a [ValidationRow],
        &'a [FieldRow],
    ),
    /// A sweep.
    Sweep(Box<SweepReport<'a>>),
}

impl ReportSubject<'_> {
    /// The report in a format, with tables of studies that were run beside it. Charts in characters are drawn with `glyphs`.
    ///
    /// # Errors
    /// What is wrong with the text of a stored run for this version.
    pub fn write(
        &self,
        format: ReportFormat,
        glyphs: Glyphs,
        studies: &[StudyTable],
    ) -> Result<String, Vec<Diagnostic>> {
        let report = || self.report(studies);
        Ok(match format {
            ReportFormat::Text => report()?.to_text(WIDTH, glyphs),
            ReportFormat::Markdown => report()?.to_markdown(glyphs),
            ReportFormat::Html => report()?.to_html(),
            ReportFormat::Csv => self.to_csv(&report)?,
            ReportFormat::Json => format!("{:#}\n", self.to_json(&report)?),
        })
    }

    /// The report as blocks.
    fn report(&self, studies: &[StudyTable]) -> Result<Report, Vec<Diagnostic>> {
        let mut report = match self {
            Self::Run(subject) => subject.report()?,
            Self::Section(design, fields, tension) => section::report(design, fields, *tension),
            Self::Ropeway(solved, results, fields) => ropeway::report(solved, results, fields),
            Self::Ship(statics, dynamic, fields) => ship::report(statics, *dynamic, fields),
            Self::System(solved, analyses, rows, fields) => {
                system::report(solved, analyses, rows, fields)
            }
            Self::Sweep(sweep) => sweep.report(WIDTH),
        };
        studies::add(&mut report, studies, self.has_trials());
        if let Self::Run(subject) = self {
            subject.add_comparison(&mut report);
        }
        Ok(report)
    }

    /// Whether hard cases and speed against error are studies of its kind.
    const fn has_trials(&self) -> bool {
        matches!(self, Self::Run(_))
    }
}

impl RunSubject<'_> {
    fn is_of_system(&self) -> bool {
        FileType::of_text(&self.run.case_text) == FileType::System
    }

    /// What its text says; of a system at rest, as it began.
    fn inputs(&self) -> Result<RunInputs, Vec<Diagnostic>> {
        let (text, file) = (&self.run.case_text, &self.run.info.case_file);
        Ok(match self.is_of_system() {
            true => RunInputs::System(Box::new(kind::parse_stored::<SystemFile>(text, file)?)),
            false => RunInputs::Line(Box::new(case::parse_stored(text, file)?)),
        })
    }

    fn report(&self) -> Result<Report, Vec<Diagnostic>> {
        let run = self.run;
        let inputs = self.inputs()?;
        let mut report = match &inputs {
            RunInputs::System(solved) => motion::stored_report(run, solved),
            RunInputs::Line(case) => text::of_run(run, case, &self.rows(case)),
        };
        verdict::add(&mut report, self.verdict(&inputs));
        Ok(report)
    }

    /// The verdict of the checks of its file, where it is stored and has any; the reason where they cannot be used.
    fn verdict(&self, inputs: &RunInputs) -> Result<Option<RunVerdict>, String> {
        let run = self.run;
        if self.dir.as_os_str().is_empty() {
            return Ok(None);
        }
        let question = match inputs {
            RunInputs::System(solved) => SeaQuestion::of_system(solved),
            RunInputs::Line(case) => SeaQuestion::of_line(case),
        };
        question.map(|question| RunVerdict::of_run(&question, self.dir, &run.summary))
    }

    /// The validation table.
    fn rows(&self, case: &Case) -> Cow<'_, [ValidationRow]> {
        match self.rows {
            Some(rows) => Cow::Borrowed(rows),
            None => Cow::Owned(reference::rows_of_run(self.run, case)),
        }
    }

    fn add_comparison(&self, report: &mut Report) {
        if let Some(other) = self.against {
            let runs = [other, self.run];
            comparison::add(report, &Comparison::of_runs(&runs), &runs, WIDTH);
        }
    }
}
