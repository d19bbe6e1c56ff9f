//! A sweep with what is asked of its seas: from a file and its load cases, or as a folder has it.

use std::collections::BTreeMap;

use super::{
    StoredSweep, Sweep, SweepKind, SweepOutcomes, SweepResults, load_cases, without_load_cases,
};
use crate::case::load_cases::{LoadCaseError, LoadCases};
use crate::case::{self, Attachment, Case, Diagnostic, kind};
use crate::kinds::FileType;
use crate::study::points::BaseCase;
use crate::study::seas::{SeaQuestion, SeaResults, StoredLoadCase};
use crate::study::vary::Variation;
use crate::system::{SolvedSystem, SystemFile};

/// What is computed, and what is asked of all load cases together.
#[derive(Debug, Clone)]
pub struct SweepPlan {
    /// The load cases and the results.
    pub sweep: Sweep,
    /// Statistics and checks.
    pub question: SeaQuestion,
}

/// What is asked for beside a file.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlanChoices<'a> {
    /// Further load cases: names and texts of CSV files.
    pub csv: &'a [(String, String)],
    /// Further load cases, as `KEY=VALUES`.
    pub varied: &'a [String],
    /// Names of the results that are shown; none: the main ones.
    pub results: &'a [String],
}

/// Why nothing can be computed.
#[derive(Debug, thiserror::Error)]
pub enum PlanError {
    /// Everything that is wrong with the file.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Invalid(Vec<Diagnostic>),
    /// Load cases that cannot be used.
    #[error("{0}")]
    LoadCases(LoadCaseError),
    /// A name that is no result.
    #[error("{0}")]
    Result(String),
    /// A check that cannot be used.
    #[error("{0}")]
    Checks(String),
}

impl SweepPlan {
    /// The sweep of a line whose text stands at this path, with these keys set on top.
    ///
    /// # Errors
    /// What is wrong with the text, its load cases, its checks, or a name of a result.
    pub fn of_line(
        text: &str,
        path: &str,
        overrides: &[String],
        choices: PlanChoices<'_>,
    ) -> Result<Self, PlanError> {
        let case = case::parse(text, path).map_err(PlanError::Invalid)?;
        let of = SweepKind {
            text,
            tables: &case.load_cases,
            files: &case.files,
        };
        let cases = load_cases::<Case>(of, choices.csv, choices.varied);
        let cases = cases.map_err(PlanError::LoadCases)?;
        let text = without_load_cases(text);
        let case = case::parse(&text, path).map_err(PlanError::Invalid)?;
        let text = case::stand_alone(&text, &case).into_owned();
        let base = base(text, path, (overrides, &case.files));
        Self::line(&case, base, cases, choices.results)
    }

    /// The sweep of a system whose text, with the files that it names, has this result.
    ///
    /// # Errors
    /// What is wrong with its load cases, its checks, or a name of a result.
    pub fn of_system(
        (text, solved): (&str, &SolvedSystem),
        path: &str,
        overrides: &[String],
        choices: PlanChoices<'_>,
    ) -> Result<Self, PlanError> {
        let of = SweepKind {
            text,
            tables: &solved.file.load_cases,
            files: &solved.file.files,
        };
        let cases = load_cases::<SystemFile>(of, choices.csv, choices.varied);
        let cases = cases.map_err(PlanError::LoadCases)?;
        let of = (overrides, &solved.file.files);
        let base = base(without_load_cases(text), path, of);
        Self::system(solved, base, cases, choices.results)
    }

    /// A sweep as its folder has it.
    ///
    /// # Errors
    /// What this version refuses of it.
    pub fn of_stored(stored: StoredSweep) -> Result<Self, PlanError> {
        let (text, info) = (stored.case, stored.info);
        let csv = [("load_cases.csv".to_owned(), stored.load_cases)];
        let of = SweepKind {
            text: &text,
            tables: &[],
            files: &BTreeMap::new(),
        };
        let base = |text, files| base(text, &info.case_file, (&info.overrides, files));
        match FileType::of_text(&text) {
            FileType::System => {
                let solved = kind::parse_stored::<SystemFile>(&text, &info.case_file);
                let solved = solved.map_err(PlanError::Invalid)?;
                let cases = load_cases::<SystemFile>(of, &csv, &[]);
                let cases = cases.map_err(PlanError::LoadCases)?;
                let base = base(text, &solved.file.files);
                Self::system(&solved, base, cases, &info.results)
            }
            _ => {
                let case = case::parse_stored(&text, &info.case_file);
                let case = case.map_err(PlanError::Invalid)?;
                let cases = load_cases::<Case>(of, &csv, &[]).map_err(PlanError::LoadCases)?;
                let base = base(text, &case.files);
                Self::line(&case, base, cases, &info.results)
            }
        }
    }

    fn line(
        case: &Case,
        base: BaseCase,
        cases: LoadCases,
        results: &[String],
    ) -> Result<Self, PlanError> {
        let results = SweepResults::of_line(case, results).map_err(PlanError::Result)?;
        let question = SeaQuestion::of_line(case).map_err(PlanError::Checks)?;
        Ok(Self::new(base, cases, results, question))
    }

    fn system(
        solved: &SolvedSystem,
        base: BaseCase,
        cases: LoadCases,
        results: &[String],
    ) -> Result<Self, PlanError> {
        let results = SweepResults::of_system(solved, results).map_err(PlanError::Result)?;
        let question = SeaQuestion::of_system(solved).map_err(PlanError::Checks)?;
        Ok(Self::new(base, cases, results, question))
    }

    fn new(base: BaseCase, cases: LoadCases, results: SweepResults, question: SeaQuestion) -> Self {
        let variation = Variation::of_load_cases(base, cases);
        Self {
            sweep: Sweep::new(variation, results, &question),
            question,
        }
    }
}

impl Sweep {
    /// The sweep of some load cases, with all results that checks need.
    #[must_use]
    pub fn new(variation: Variation, results: SweepResults, question: &SeaQuestion) -> Self {
        let needed = question.rest_names().into_iter().map(|needed| needed.name);
        Self {
            variation,
            results,
            needed: needed.collect(),
        }
    }

    /// What the runs say together; of equilibria, which are not stored, only where there are checks.
    #[must_use]
    pub fn answers(&self, outcomes: &SweepOutcomes, question: &SeaQuestion) -> Option<SeaResults> {
        let outcomes = match outcomes {
            SweepOutcomes::Runs(outcomes, _) => outcomes,
            SweepOutcomes::AtRest(outcomes, _) => {
                let names = question.rest_names();
                let of = (names.as_slice(), question);
                let asked = !question.checks.is_empty();
                return asked.then(|| SeaResults::at_rest(&self.variation, outcomes, of));
            }
        };
        let stored = outcomes
            .iter()
            .map(|outcome| outcome.as_ref().and_then(StoredLoadCase::of_outcome));
        let stored: Vec<Option<StoredLoadCase>> = stored.collect();
        Some(SeaResults::of_runs(&self.variation, &stored, question))
    }
}

fn base(
    text: String,
    path: &str,
    (overrides, files): (&[String], &BTreeMap<String, Attachment>),
) -> BaseCase {
    BaseCase {
        text,
        path: path.to_owned(),
        overrides: overrides.to_vec(),
        files: files.clone(),
    }
}
