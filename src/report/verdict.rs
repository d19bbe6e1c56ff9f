//! The verdict of the checks of a file on one run, or on its equilibrium.

use std::path::Path;

use serde_json::Value;

use super::document::Report;
use super::seas::SeasView;
use super::table::Table;
use seacable_model::case::StatisticsInputs;
use seacable_model::checks::utilisation::UtilisationVerdict;
use seacable_runs::run::Quantity;
use seacable_studies::study::seas::{SeaQuestion, SeaResults};
pub use seacable_systems::system::SolvedSystem;

/// The checks of a file with what one run, or its equilibrium, makes of them.
#[derive(Debug, Clone)]
pub struct RunVerdict {
    results: SeaResults,
    statistics: StatisticsInputs,
}

impl RunVerdict {
    /// Of a stored run, its directory and its results; nothing where the file has no checks.
    #[must_use]
    pub fn of_run(question: &SeaQuestion, dir: &Path, summary: &[Quantity]) -> Option<Self> {
        let of = || SeaResults::of_run(dir, summary, question);
        Self::new(question, of)
    }

    /// Of a system at rest; nothing where the file has no checks.
    #[must_use]
    pub fn of_equilibrium(question: &SeaQuestion, solved: &SolvedSystem) -> Option<Self> {
        Self::new(question, || SeaResults::of_equilibrium(solved, question))
    }

    fn new(question: &SeaQuestion, results: impl FnOnce() -> SeaResults) -> Option<Self> {
        (!question.checks.is_empty()).then(|| Self {
            results: results(),
            statistics: question.statistics.clone(),
        })
    }

    fn view(&self) -> SeasView<'_> {
        SeasView {
            results: &self.results,
            statistics: &self.statistics,
        }
    }

    /// A row for each check: its verdict, and what governs it.
    #[must_use]
    pub fn table(&self) -> Table {
        self.view().verdict()
    }

    /// The worst of all checks; nothing where none is for this run.
    #[must_use]
    pub fn worst(&self) -> Option<UtilisationVerdict> {
        self.view().worst()
    }

    /// The verdict in a word, a row for each check and place, and what could not be compared.
    #[must_use]
    pub fn to_json(&self) -> Value {
        self.view().checks_json()
    }
}

/// Adds a verdict to a report, or why there is none.
pub(super) fn add(page: &mut Report, verdict: Result<Option<RunVerdict>, String>) {
    match verdict {
        Ok(None) => {}
        Ok(Some(verdict)) => {
            page.heading("Checks");
            page.table(verdict.table());
        }
        Err(why) => {
            page.heading("Checks");
            page.paragraph(&why);
        }
    }
}
