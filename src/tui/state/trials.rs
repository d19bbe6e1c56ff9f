//! Trials of hard cases: what is computed, and the results so far.

use std::path::PathBuf;

use super::JobNumber;
use crate::report::subject::StudyTable;
use crate::study::{TrialVerdict, hard_cases};
use crate::table::Table;
use crate::table_pane::TablePane;

/// Whose trials.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TrialsOf {
    /// Of one case, as edited.
    Case {
        /// File name.
        file: String,
        /// Text.
        text: String,
    },
    /// Of all cases among these files that have any.
    Files(Vec<PathBuf>),
}

/// How far the trials are, as the thread that computes them reports.
#[derive(Debug, Clone, Default)]
pub struct TrialProgress {
    /// What came out so far, in the order of the cases.
    pub findings: Vec<TrialVerdict>,
    /// Trials computed.
    pub done: usize,
    /// Trials in all.
    pub all: usize,
    /// Whether this is the last word.
    pub over: bool,
}

/// Why no trials are computed of a file.
pub(super) const NO_TRIALS: &str = "This case has no trials. A `[[trial]]` table in its file makes one; in the list of cases `:trials` computes all.";

/// From this many columns on the whole table fits.
pub const WIDE: u16 = 160;

/// Trials on the screen, or behind it.
#[derive(Debug, Clone)]
pub struct Trials {
    /// Whose they are.
    pub of: TrialsOf,
    /// Number of the job.
    pub ticket: JobNumber,
    /// How far they are.
    pub progress: TrialProgress,
    /// Whether they were stopped.
    pub stopped: bool,
    /// Whether they are seen; else they run behind the screen.
    pub shown: bool,
    /// Selection, sorting and scrolling.
    pub pane: TablePane,
}

impl Trials {
    /// The table of results so far, for a screen of so many columns: every number, or a row a trial.
    #[must_use]
    pub fn table(&self, columns: u16) -> Table {
        if columns < WIDE {
            hard_cases::compact_table(&self.progress.findings)
        } else {
            hard_cases::table(&self.progress.findings)
        }
    }

    /// The trial selected in the table of a row a trial.
    #[must_use]
    pub fn selected(&self, table: &Table) -> Option<&TrialVerdict> {
        self.progress.findings.get(self.pane.selected(table)?)
    }

    /// The table of those that are over, for a report on this file: those of its case, or of all cases.
    #[must_use]
    pub fn study(&self, of_file: &str) -> Option<StudyTable> {
        let name = match &self.of {
            TrialsOf::Case { file, .. } => {
                Some(format!("Hard cases: the trials of {file}")).filter(|_| file == of_file)
            }
            TrialsOf::Files(_) => Some("Hard cases: the trials of all cases".to_owned()),
        };
        let table = hard_cases::compact_table(&self.progress.findings);
        let is_over = self.progress.over && !self.progress.findings.is_empty();
        name.filter(|_| is_over)
            .map(|name| StudyTable { name, table })
    }

    /// Whether they still compute.
    #[must_use]
    pub fn running(&self) -> bool {
        !self.progress.over
    }
}
