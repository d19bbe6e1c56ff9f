//! What differs among load cases. Keys that always change together, such as the height and the period of a sea, are one axis.

use std::collections::HashMap;

use crate::case::StudyValue;
use crate::case::fields::in_words;
use crate::study::points::Setting;
use crate::study::seas::is_of_one_sea;
use crate::study::vary::{Variation, VariedKey};

/// What differs among load cases.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadCaseAxis {
    /// Its keys in words, with their units: `significant height [m] / peak period [s]`.
    pub label: String,
    /// Its values, each as the values of its keys.
    pub values: Vec<String>,
    /// Whether it tells samples of a sea apart, not seas.
    pub is_of_samples: bool,
    /// The values of its keys, by value of the axis.
    parts: Vec<Vec<String>>,
    /// Names and units of its keys.
    keys: Vec<(String, &'static str)>,
    /// The place of the value of each load case.
    places: Vec<u32>,
}

impl LoadCaseAxis {
    /// The place of its value at a load case.
    #[must_use]
    pub fn place(&self, load_case: usize) -> Option<usize> {
        self.places.get(load_case).map(|place| *place as usize)
    }

    /// A value in words: `significant height 3 m, peak period 9 s`.
    #[must_use]
    pub fn words(&self, place: usize) -> String {
        let values = self.parts.get(place).into_iter().flatten();
        let parts = self.keys.iter().zip(values);
        let words = parts.map(|((name, unit), value)| match *unit {
            "" => format!("{name} {value}"),
            unit => format!("{name} {value} {unit}"),
        });
        words.collect::<Vec<_>>().join(", ")
    }
}

/// A key with the place of its value at every load case.
struct KeyPlaces<'a> {
    key: &'a VariedKey,
    places: Vec<u32>,
}

/// The axes of the load cases of a variation, in the order of their keys. A key with one value is none.
pub(super) fn axes(variation: &Variation) -> Vec<LoadCaseAxis> {
    let keys = variation.keys.iter().enumerate();
    let keys = keys.filter(|(_, key)| key.range.values.len() > 1);
    let mut groups: Vec<Vec<KeyPlaces<'_>>> = Vec::new();
    for (column, key) in keys {
        let own = KeyPlaces {
            key,
            places: places(variation, column, key),
        };
        let same = |group: &&mut Vec<KeyPlaces<'_>>| is_same(&group[0].places, &own.places);
        match groups.iter_mut().find(same) {
            Some(group) => group.push(own),
            None => groups.push(vec![own]),
        }
    }
    let kept: Vec<bool> = (0..groups.len())
        .map(|own| !is_of_seed(&groups, own))
        .collect();
    let mut kept = kept.iter();
    groups.retain(|_| kept.next() == Some(&true));
    let all = groups.iter().flatten();
    let names: Vec<String> = all.map(|of| short(of.key)).collect();
    groups.iter().map(|group| axis(group, &names)).collect()
}

/// The place of the value of a key among its values, at every load case.
fn places(variation: &Variation, column: usize, key: &VariedKey) -> Vec<u32> {
    let known = sorted(key);
    let known: HashMap<String, u32> = known
        .into_iter()
        .map(|value| written(key, &value))
        .zip(0..)
        .collect();
    let of = |setting: &Setting| known.get(&written(key, &setting.value)).copied();
    let points = variation.points.iter();
    points
        .map(|point| point.settings.get(column).and_then(of).unwrap_or(0))
        .collect()
}

/// The values of a key: numbers ascending, words as they came.
fn sorted(key: &VariedKey) -> Vec<StudyValue> {
    let mut values = key.range.values.clone();
    let number = |value: &StudyValue| match value {
        StudyValue::Number(number) => Some(*number),
        StudyValue::Word(_) => None,
    };
    if values.iter().all(|value| number(value).is_some()) {
        values.sort_by(|a, b| {
            number(a)
                .zip(number(b))
                .map_or(std::cmp::Ordering::Equal, |(a, b)| a.total_cmp(&b))
        });
    }
    values
}

fn written(key: &VariedKey, value: &StudyValue) -> String {
    Setting::new(&key.path, value.clone()).written()
}

/// Whether two keys change together: each value of the one goes with one value of the other.
fn is_same(a: &[u32], b: &[u32]) -> bool {
    let (mut forth, mut back) = (HashMap::new(), HashMap::new());
    a.iter()
        .zip(b)
        .all(|(a, b)| *forth.entry(a).or_insert(b) == b && *back.entry(b).or_insert(a) == a)
}

/// Whether a group of keys tells no seas apart and follows from another one: which seed has its errors estimated.
fn is_of_seed(groups: &[Vec<KeyPlaces<'_>>], own: usize) -> bool {
    let of_samples = |group: &[KeyPlaces<'_>]| group.iter().all(|of| is_of_one_sea(&of.key.path));
    let follows = |other: &[KeyPlaces<'_>]| {
        let mut known = HashMap::new();
        let mut both = other[0].places.iter().zip(&groups[own][0].places);
        both.all(|(other, own)| *known.entry(other).or_insert(own) == own)
    };
    let mut others = groups.iter().enumerate().filter(|(place, _)| *place != own);
    of_samples(&groups[own]) && others.any(|(_, other)| of_samples(other) && follows(other))
}

/// The last part of a key path, without its unit.
fn short(key: &VariedKey) -> String {
    let last = key.path.rsplit('.').next().unwrap_or(&key.path);
    in_words(last).0
}

/// The short name of a key, or its path where another key has the same.
fn name(key: &VariedKey, names: &[String]) -> String {
    let short = short(key);
    match names.iter().filter(|name| **name == short).count() {
        0 | 1 => short,
        _ => key.path.clone(),
    }
}

fn axis(group: &[KeyPlaces<'_>], names: &[String]) -> LoadCaseAxis {
    let keys: Vec<(String, &'static str)> = group
        .iter()
        .map(|of| (name(of.key, names), of.key.unit()))
        .collect();
    let labels = keys.iter().map(|(name, unit)| match *unit {
        "" => name.clone(),
        unit => format!("{name} [{unit}]"),
    });
    let first = &group[0];
    let count = first.key.range.values.len();
    let mut values = vec![Vec::new(); count];
    for of in group {
        let own = sorted(of.key);
        // The keys of an axis go together: the first load case of a value has those of all keys.
        let mut seen = vec![false; count];
        for (first, place) in first.places.iter().zip(&of.places) {
            let at = *first as usize;
            if !std::mem::replace(&mut seen[at], true) {
                values[at].push(written(of.key, &own[*place as usize]));
            }
        }
    }
    LoadCaseAxis {
        label: labels.collect::<Vec<_>>().join(" / "),
        values: values.iter().map(|parts| parts.join("/")).collect(),
        parts: values,
        is_of_samples: group.iter().all(|of| is_of_one_sea(&of.key.path)),
        keys,
        places: first.places.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::field_at;
    use crate::case::load_cases::{LoadCaseKey, LoadCases};
    use crate::study::points::BaseCase;

    #[test]
    fn keys_that_change_together_are_one_axis() {
        let key = |path: &str| LoadCaseKey {
            path: path.to_owned(),
            field: field_at(&path.split('.').collect::<Vec<_>>()).unwrap(),
        };
        let row = |height: f64, period: f64, seed: f64| {
            [height, period, seed, 0.5].map(StudyValue::Number).to_vec()
        };
        let load_cases = LoadCases {
            keys: vec![
                key("waves.significant_height_m"),
                key("waves.peak_period_s"),
                key("waves.seed"),
                key("current.speed_m_per_s"),
            ],
            rows: vec![
                row(4.0, 9.0, 1.0),
                row(2.0, 7.0, 1.0),
                row(4.0, 9.0, 2.0),
                row(2.0, 7.0, 2.0),
            ],
            probability: None,
        };
        let variation = Variation::of_load_cases(BaseCase::new("", "c.toml"), load_cases);
        let found = axes(&variation);
        assert_eq!(found.len(), 2);
        assert_eq!(found[0].label, "significant height [m] / peak period [s]");
        assert_eq!(found[0].values, ["2/7", "4/9"]);
        assert_eq!(found[0].words(1), "significant height 4 m, peak period 9 s");
        assert_eq!(found[0].place(0), Some(1));
        assert!(!found[0].is_of_samples && found[1].is_of_samples);
        assert_eq!(found[1].words(1), "seed 2");
    }

    #[test]
    fn which_seed_has_its_errors_estimated_is_no_axis() {
        let key = |path: &str| LoadCaseKey {
            path: path.to_owned(),
            field: field_at(&path.split('.').collect::<Vec<_>>()).unwrap(),
        };
        let row = |seed: f64, estimated: &str| {
            vec![
                StudyValue::Number(seed),
                StudyValue::Word(estimated.to_owned()),
            ]
        };
        let load_cases = LoadCases {
            keys: vec![key("waves.seed"), key("solver.error_estimate")],
            rows: vec![row(1.0, "true"), row(2.0, "false"), row(3.0, "false")],
            probability: None,
        };
        let variation = Variation::of_load_cases(BaseCase::new("", "c.toml"), load_cases);
        let found = axes(&variation);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].label, "seed");
    }
}
