//! A case computed at many points: keys varied over ranges, alone or as a grid.
//!
//! [`Variation`] says what is computed, a [sweep](super::sweep) computes it, and `report::variation` shows the
//! results. Points need not be a grid: each is a list of settings of its own, so that load cases are points as well.

mod error;
mod key;
pub mod system;

use std::collections::HashSet;

pub use error::VariationError;
pub use key::VariedKey;

use super::points::{BaseCase, PointRequest, Setting, StudyPoint};
use crate::case::load_cases::LoadCases;
use crate::case::{StudyValue, ValueRange};
use crate::limits::POINTS;

/// A case and the points at which it is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation {
    /// The case.
    pub base: BaseCase,
    /// The keys that are varied; each point has a setting for each of them, in their order.
    pub keys: Vec<VariedKey>,
    /// The points.
    pub points: Vec<StudyPoint>,
    /// Probability of each point, where it is known; they add up to 1.
    pub probability: Option<Vec<f64>>,
    /// Whether the points are the full product of the values of the keys, the last key fastest.
    pub is_grid: bool,
}

impl Variation {
    /// The full product of the values of some keys; the last key varies fastest.
    ///
    /// # Errors
    /// A key that is given twice, or too many points.
    pub fn of_keys(base: BaseCase, given: Vec<VariedKey>) -> Result<Self, VariationError> {
        let mut keys: Vec<VariedKey> = Vec::with_capacity(given.len());
        for key in given {
            if keys.iter().any(|known| known.path == key.path) {
                return Err(VariationError::Twice(key.path));
            }
            keys.push(key);
        }
        let counts = keys.iter().map(|key| key.range.values.len());
        let count = counts.fold(1_usize, usize::saturating_mul);
        if POINTS.is_exceeded_by(count as f64) {
            return Err(VariationError::TooMany(count));
        }
        let points = product(&keys);
        Ok(Self {
            base,
            keys,
            points,
            probability: None,
            is_grid: true,
        })
    }

    /// A case at load cases.
    #[must_use]
    pub fn of_load_cases(base: BaseCase, cases: LoadCases) -> Self {
        let keys = cases.keys.iter().enumerate();
        let varied = keys.map(|(column, key)| {
            let values = distinct(cases.rows.iter().map(|row| &row[column]));
            VariedKey {
                path: key.path.clone(),
                field: key.field,
                range: ValueRange::of_values(values),
            }
        });
        let keys: Vec<VariedKey> = varied.collect();
        let point = |row: Vec<StudyValue>| {
            let settings = keys.iter().zip(row);
            let settings = settings.map(|(key, value)| Setting::new(&key.path, value));
            StudyPoint {
                settings: settings.collect(),
            }
        };
        let points: Vec<StudyPoint> = cases.rows.into_iter().map(point).collect();
        let counts = keys.iter().map(|key| key.range.values.len());
        let count = counts.fold(1_usize, usize::saturating_mul);
        Self {
            base,
            is_grid: count == points.len() && points == product(&keys),
            points,
            keys,
            probability: cases.probability,
        }
    }

    /// What is computed at each point; the reason where the case refuses it.
    #[must_use]
    pub fn requests(&self) -> Vec<PointRequest> {
        let points = self.points.iter();
        points
            .map(|point| self.base.request(&point.settings))
            .collect()
    }
}

/// The values without those that were before, in their order. Of a million load cases each may have its own.
fn distinct<'a>(all: impl Iterator<Item = &'a StudyValue>) -> Vec<StudyValue> {
    let (mut numbers, mut words) = (HashSet::new(), HashSet::new());
    let is_new = |value: &&'a StudyValue| match value {
        // Both zeros are the same value.
        StudyValue::Number(number) => numbers.insert((number + 0.0).to_bits()),
        StudyValue::Word(word) => words.insert(word.as_str()),
    };
    all.filter(is_new).cloned().collect()
}

/// Every combination of the values of the keys.
fn product(keys: &[VariedKey]) -> Vec<StudyPoint> {
    let mut points = vec![StudyPoint::default()];
    for key in keys {
        let with = |point: &StudyPoint| {
            let values = key.range.values.iter();
            let settings = values.map(|value| Setting::new(&key.path, value.clone()));
            let points = settings.map(|setting| StudyPoint {
                settings: [point.settings.clone(), vec![setting]].concat(),
            });
            points.collect::<Vec<StudyPoint>>()
        };
        points = points.iter().flat_map(with).collect();
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::shipped::SHIPPED;

    fn base() -> BaseCase {
        let (path, text) = SHIPPED
            .iter()
            .find(|(path, _)| path.ends_with("pendulous/manifold.toml"))
            .unwrap();
        BaseCase::new(text, path)
    }

    fn grid(words: &[&str]) -> Result<Variation, VariationError> {
        let base = base();
        let keys = words.iter().map(|word| VariedKey::parse(word, &base.text));
        let keys = keys.collect::<Result<_, _>>()?;
        Variation::of_keys(base, keys)
    }

    #[test]
    fn two_keys_make_a_grid() {
        let words = ["current.speed_m_per_s=0.2..0.4/3", "line.wire.segments=2,4"];
        let variation = grid(&words).unwrap();
        assert_eq!(variation.points.len(), 6);
        let requests = variation.requests();
        let last = requests[5].as_ref().unwrap();
        assert_eq!(
            last.overrides,
            ["current.speed_m_per_s=0.4", "line.wire.segments=4"]
        );
        assert_eq!(last.case.line[2].segments, 4);
    }

    #[test]
    fn what_cannot_be_varied_is_named() {
        let fault = |words: &[&str]| grid(words).unwrap_err().to_string();
        for (words, why) in [
            (&["current.sped_m_per_s=1,2"][..], "did you mean"),
            (&["current.speed_m_per_s"], "KEY=A..B/N"),
            (&["current.speed_m_per_s=1..2"], "number of values"),
            (
                &["payload.wet_mass_kg=1,2", "payload.wet_mass_kg=3,4"],
                "twice",
            ),
            (
                &[
                    "payload.wet_mass_kg=1..9/200",
                    "payload.drag_area_m2=1..9/200",
                ],
                "40000 points",
            ),
            (&["ends.a.position_m=1,2"], "ends.a.position_m.x"),
            (&["case.title=a,b"], "takes no number"),
        ] {
            let found = fault(words);
            assert!(found.contains(why), "{words:?}: {found}");
        }
    }
}
