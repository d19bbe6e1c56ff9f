//! What a file of any kind states of published numbers, of trends along its studies and of curves, and the rows of its validation table.

use super::edited::{RowScope, set_aside};
use super::{ValidationRow, curve, trend, value};
use crate::case::{EditedKey, PublishedCurve, Study, StudyPoint};
use crate::published::{ComputedNumber, PublishedNumber, PublishedTrend};
use crate::run::published_curve::held;
use crate::run::{History, Quantity, Run, RunState};

/// What a file states of published numbers, of trends along its studies and of curves.
#[derive(Debug, Clone, Copy)]
pub struct PublishedStatements<'a> {
    /// Its studies.
    pub studies: &'a [Study],
    /// Its published numbers.
    pub numbers: &'a [PublishedNumber],
    /// Its trends.
    pub trends: &'a [PublishedTrend],
    /// Its published curves.
    pub curves: &'a [PublishedCurve],
    /// The reason of its tolerances, where a number states none of its own.
    pub reason: Option<&'a str>,
}

/// What a run in time is compared by.
#[derive(Debug, Clone, Copy)]
pub struct ComparedRun<'r> {
    /// The channels at the output times.
    pub history: &'r History,
    /// All single numbers with their errors.
    pub summary: &'r [Quantity],
}

impl<'r> ComparedRun<'r> {
    /// Of a run that is computed or stored.
    ///
    /// # Errors
    /// Why the run did not come to its end, as a sentence.
    pub fn of_run(run: &'r Run) -> Result<Self, String> {
        ended(run.info.state, run.info.failure.as_deref())?;
        Ok(Self {
            history: &run.history,
            summary: &run.summary,
        })
    }
}

/// Whether a run in this state came to its end.
///
/// # Errors
/// Why it did not, as a sentence.
pub fn ended(state: RunState, failure: Option<&str>) -> Result<(), String> {
    Err(match state {
        RunState::Done => return Ok(()),
        RunState::Failed => {
            let why = failure.unwrap_or("no reason was given");
            format!("The run failed: {}.", why.trim_end_matches('.'))
        }
        RunState::Cancelled => "The run was cancelled before its end.".to_owned(),
        RunState::Partial => "The run is partial: it never came to its end.".to_owned(),
    })
}

/// The results of a file at the points of its studies.
pub trait ResultsAt {
    /// Unit of the result of this name.
    fn unit(&self, name: &str) -> String;

    /// The result of this name at a point; `None` is the file without a study.
    ///
    /// # Errors
    /// Why there is none, as a sentence.
    fn number(&self, at: Option<&StudyPoint>, name: &str) -> Result<ComputedNumber, String>;

    /// The run in time at a point.
    ///
    /// # Errors
    /// Why there is none, as a sentence.
    fn run(&self, at: Option<&StudyPoint>) -> Result<ComparedRun<'_>, String>;
}

impl<'a> PublishedStatements<'a> {
    /// The study of this name.
    #[must_use]
    pub fn study(&self, name: &str) -> Option<&'a Study> {
        self.studies.iter().find(|study| study.name == name)
    }

    /// The distinct variants of the file that its numbers, trends and curves need, `None` being the file without a study; in the order in
    /// which it asks for them.
    #[must_use]
    pub fn plan(&self) -> Vec<Option<StudyPoint>> {
        let mut variants: Vec<Option<StudyPoint>> = Vec::new();
        let mut need = |at: Option<StudyPoint>| {
            if !variants.contains(&at) {
                variants.push(at);
            }
        };
        for printed in self.numbers {
            need(printed.at.clone());
            for other in [&printed.change_from, &printed.ratio_to] {
                if other.is_some() {
                    need(other.clone());
                }
            }
        }
        for trend in self.trends {
            for value in self.study(&trend.study).map_or(&[][..], |s| &s.values) {
                need(Some(StudyPoint {
                    study: trend.study.clone(),
                    value: value.clone(),
                }));
            }
        }
        for curve in self.curves {
            need(curve.at.clone());
        }
        variants
    }

    /// The rows of its numbers, then of its trends, then of its curves, in the order of the file.
    #[must_use]
    pub fn rows(&self, results: &dyn ResultsAt) -> Vec<ValidationRow> {
        let numbers = self.numbers.iter();
        let numbers = numbers.map(|printed| value::row(printed, self.numbers, results));
        let trends = self.trends.iter();
        let trends = trends.map(|trend| trend::row(self, trend, results));
        let curves = self.curves.iter().enumerate();
        let curves = curves.flat_map(|(number, curve)| {
            curve::rows(number, curve, &results.run(curve.at.as_ref()))
        });
        let all = numbers.chain(trends).chain(curves);
        all.map(|row| row.with_common_reason(self.reason)).collect()
    }

    /// The rows of a file with edited inputs whose published values are not for it read EDITED, with the keys that are why.
    pub fn set_edited_aside(&self, rows: &mut [ValidationRow], edited: &[EditedKey]) {
        if edited.is_empty() {
            return;
        }
        let numbers = self.numbers.iter().map(RowScope::of_number);
        let trends = self.trends.iter().map(RowScope::of_trend);
        let curves = self.curves.iter();
        let curves = curves.flat_map(|curve| vec![RowScope::of_curve(curve); held(curve).len()]);
        let scopes = numbers.chain(trends).chain(curves);
        for (row, scope) in rows.iter_mut().zip(scopes) {
            let concern = |key: &&EditedKey| scope.concerns(self.studies, &key.path);
            let keys: Vec<&EditedKey> = edited.iter().filter(concern).collect();
            set_aside(row, &keys);
        }
    }
}
