//! The checks of a file on one run, or on its equilibrium: a sea of one load case.

use std::path::Path;

use super::{SeaQuestion, SeaResults, StoredLoadCase};
use crate::run::Quantity;
use crate::study::points::{BaseCase, StudyPoint};
use crate::study::vary::Variation;
use crate::study::vary::system::SystemPoint;
use crate::system::SolvedSystem;

impl SeaResults {
    /// Of a stored run, its directory and its results.
    #[must_use]
    pub fn of_run(dir: &Path, summary: &[Quantity], question: &SeaQuestion) -> Self {
        let run = StoredLoadCase {
            dir: dir.to_owned(),
            summary: summary.to_vec(),
        };
        Self::of_runs(&as_in_the_file(), &[Some(run)], question)
    }

    /// Of a system at rest.
    #[must_use]
    pub fn of_equilibrium(solved: &SolvedSystem, question: &SeaQuestion) -> Self {
        let names = question.rest_names();
        let wanted: Vec<String> = names.iter().map(|name| name.name.clone()).collect();
        let outcome = Ok(SystemPoint::of_system(solved, &wanted));
        Self::at_rest(&as_in_the_file(), &[Some(outcome)], (&names, question))
    }

    /// Whether it is of one load case.
    #[must_use]
    pub fn is_of_one_load_case(&self) -> bool {
        matches!(self.seas.as_slice(), [sea] if sea.load_cases.len() == 1)
    }
}

/// The file as it stands, as the only load case.
fn as_in_the_file() -> Variation {
    Variation {
        base: BaseCase::new("", ""),
        keys: Vec::new(),
        points: vec![StudyPoint::default()],
        probability: None,
        is_grid: true,
    }
}
