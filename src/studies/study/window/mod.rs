//! In which sea may the work go on: the greatest of some values of a key, such as the significant height, at which all checks pass, sea by
//! sea of a table of load cases.
//!
//! It is sought by bisection: it assumes that what passes at a value passes at all lower ones. Each round is a [sweep](super::sweep) of its
//! own, over the seeds of the seas that are still sought; whether a value passes is decided by its checks, with both errors, so that a value that
//! is not settled counts as one that does not pass, and is named as such.

mod bracket;

pub use bracket::LimitBracket;

use crate::case::StudyValue;
use crate::case::load_cases::{LoadCaseKey, LoadCases};
use crate::checks::utilisation::UtilisationVerdict;
use crate::study::points::Setting;
use crate::study::seas::{CheckRow, SeaGroup, SeaResults};
use crate::study::vary::{Variation, VariedKey};

/// What is sought: a key with its values, which rise.
#[derive(Debug, Clone, PartialEq)]
pub struct WindowKey {
    /// The key.
    pub key: LoadCaseKey,
    /// Its values.
    pub values: Vec<f64>,
}

/// The limiting value of one sea.
#[derive(Debug, Clone, PartialEq)]
pub struct WindowRow {
    /// The sea, without the key that is sought.
    pub sea: SeaGroup,
    /// Between which values it lies.
    pub bracket: LimitBracket,
    /// What governs at the least value that does not pass: the check, the place and the share that is used.
    pub governing: Option<Governing>,
}

/// What governs at a value.
#[derive(Debug, Clone, PartialEq)]
pub struct Governing {
    /// The check.
    pub check: String,
    /// The place.
    pub place: String,
    /// The share of its limit that is used.
    pub used: f64,
}

/// Why a window cannot be sought.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum WindowError {
    /// A key that takes words.
    #[error(
        "`{0}` takes words; name a key that takes numbers, such as waves.1.significant_height_m"
    )]
    Words(String),
    /// Fewer than two values, or none that rise.
    #[error("`{0}` has fewer than two values that rise; write KEY=1..9/33 for 33 of them")]
    Few(String),
    /// A key that the load cases set too.
    #[error("`{0}` is set by the load cases too; leave it out there")]
    Twice(String),
}

impl WindowKey {
    /// Of a key that is varied.
    ///
    /// # Errors
    /// Values that are words or do not rise.
    pub fn of_varied_key(varied: &VariedKey) -> Result<Self, WindowError> {
        let numbers = varied.range.values.iter().map(StudyValue::number);
        let numbers: Option<Vec<f64>> = numbers.collect();
        let values = numbers.ok_or_else(|| WindowError::Words(varied.path.clone()))?;
        if values.len() < 2 || values.windows(2).any(|pair| pair[1] <= pair[0]) {
            return Err(WindowError::Few(varied.path.clone()));
        }
        Ok(Self {
            key: LoadCaseKey {
                path: varied.path.clone(),
                field: varied.field,
            },
            values,
        })
    }

    /// The rows to fill: the seas of a table of load cases.
    ///
    /// # Errors
    /// The table sets the key too.
    pub fn rows(
        &self,
        table: &Variation,
        seas: Vec<SeaGroup>,
    ) -> Result<Vec<WindowRow>, WindowError> {
        if table.keys.iter().any(|key| key.path == self.key.path) {
            return Err(WindowError::Twice(self.key.path.clone()));
        }
        let rows = seas.into_iter().map(|sea| WindowRow {
            sea,
            bracket: LimitBracket::new(self.values.len()),
            governing: None,
        });
        Ok(rows.collect())
    }

    /// The load cases of the next round: those of each sea at each value to try; nothing when all is found.
    #[must_use]
    pub fn round(&self, table: &Variation, rows: &[WindowRow]) -> Option<Variation> {
        let mut cases: Vec<Vec<StudyValue>> = Vec::new();
        for row in rows {
            for place in row.bracket.next() {
                let value = StudyValue::Number(self.values[place]);
                for &load_case in &row.sea.load_cases {
                    let own = table.points[load_case].settings.iter();
                    let own = own.map(|setting| setting.value.clone());
                    cases.push(own.chain([value.clone()]).collect());
                }
            }
        }
        let keys = table.keys.iter().map(|key| LoadCaseKey {
            path: key.path.clone(),
            field: key.field,
        });
        let load_cases = LoadCases {
            keys: keys.chain([self.key.clone()]).collect(),
            rows: cases,
            probability: None,
        };
        (!load_cases.rows.is_empty())
            .then(|| Variation::of_load_cases(table.base.clone(), load_cases))
    }

    /// Takes what a round has shown.
    pub fn take(&self, rows: &mut [WindowRow], results: &SeaResults) {
        for (number, sea) in results.seas.iter().enumerate() {
            let is_key = |setting: &&Setting| setting.key == self.key.path;
            let tried = sea.settings.iter().find(is_key);
            let tried = tried.and_then(|setting| setting.value.number());
            let place = self.values.iter().position(|value| Some(*value) == tried);
            let others = sea.settings.iter().filter(|setting| !is_key(setting));
            let others: Vec<&Setting> = others.collect();
            let row = rows
                .iter_mut()
                .find(|row| row.sea.settings.iter().eq(others.iter().copied()));
            let (Some(row), Some(place)) = (row, place) else {
                continue;
            };
            let (verdict, governing) = said(results, number);
            row.bracket.take(place, verdict);
            if row.bracket.fails == Some((place, verdict)) {
                row.governing = governing;
            }
        }
    }
}

/// What the checks say of a sea: the worst of them, and the row that governs. A sea in which nothing could be compared is open.
fn said(results: &SeaResults, sea: usize) -> (UtilisationVerdict, Option<Governing>) {
    let rows = results.checks.iter().flat_map(|check| {
        let of_sea = check.rows.iter().filter(move |row| row.sea == Some(sea));
        of_sea.map(move |row| (check, row))
    });
    let share = |row: &CheckRow| (row.used.verdict(), row.used.value);
    let worst = rows.max_by(|(_, a), (_, b)| {
        let (a, b) = (share(a), share(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let open = results
        .checks
        .iter()
        .any(|check| check.open_seas.contains(&sea));
    match worst {
        None => (UtilisationVerdict::Open, None),
        Some((check, row)) => {
            let verdict = row.used.verdict();
            let verdict = if open {
                verdict.max(UtilisationVerdict::Open)
            } else {
                verdict
            };
            let governing = Governing {
                check: check.check.name.clone(),
                place: row.place.clone(),
                used: row.used.value,
            };
            (verdict, Some(governing))
        }
    }
}
