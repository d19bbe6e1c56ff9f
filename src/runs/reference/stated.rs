//! What a file of any kind states of published numbers and of trends along its studies, and the rows of its validation table.

use super::edited::{RowScope, set_aside};
use super::{ValidationRow, trend, value};
use crate::case::{EditedKey, Study, StudyPoint};
use crate::published::{ComputedNumber, PublishedNumber, PublishedTrend};

/// What a file states of published numbers and of trends along its studies.
#[derive(Debug, Clone, Copy)]
pub struct PublishedStatements<'a> {
    /// Its studies.
    pub studies: &'a [Study],
    /// Its published numbers.
    pub numbers: &'a [PublishedNumber],
    /// Its trends.
    pub trends: &'a [PublishedTrend],
    /// The reason of its tolerances, where a number states none of its own.
    pub reason: Option<&'a str>,
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
}

impl<'a> PublishedStatements<'a> {
    /// The study of this name.
    #[must_use]
    pub fn study(&self, name: &str) -> Option<&'a Study> {
        self.studies.iter().find(|study| study.name == name)
    }

    /// The distinct variants of the file that its numbers and trends need, `None` being the file without a study; in the order in
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
        variants
    }

    /// The rows of its numbers and then of its trends, in the order of the file.
    #[must_use]
    pub fn rows(&self, results: &dyn ResultsAt) -> Vec<ValidationRow> {
        let numbers = self.numbers.iter();
        let numbers = numbers.map(|printed| value::row(printed, self.numbers, results));
        let trends = self.trends.iter();
        let trends = trends.map(|trend| trend::row(self, trend, results));
        let all = numbers.chain(trends);
        all.map(|row| row.with_common_reason(self.reason)).collect()
    }

    /// The rows of a file with edited inputs whose published values are not for it read EDITED, with the keys that are why. `curves`
    /// says what its curves are taken of, whose rows come last; a row beyond them is of the file without a study.
    pub fn set_edited_aside<'c>(
        &self,
        rows: &mut [ValidationRow],
        curves: impl IntoIterator<Item = RowScope<'c>>,
        edited: &[EditedKey],
    ) where
        'a: 'c,
    {
        if edited.is_empty() {
            return;
        }
        let numbers = self.numbers.iter().map(RowScope::of_number);
        let trends = self.trends.iter().map(RowScope::of_trend);
        let scopes = numbers.chain(trends).chain(curves);
        let beyond = std::iter::repeat_with(RowScope::default);
        for (row, scope) in rows.iter_mut().zip(scopes.chain(beyond)) {
            let concern = |key: &&EditedKey| scope.concerns(self.studies, &key.path);
            let keys: Vec<&EditedKey> = edited.iter().filter(concern).collect();
            set_aside(row, &keys);
        }
    }
}
