//! Load cases: rows of values of keys, from tables in a file and beside it, and their combinations.

use std::collections::BTreeMap;

use super::diagnostic::Diagnostic;
use super::fields::Field;
use super::load_case_file;
pub use super::load_case_file::read as read_file;
use super::model::{Attachment, LoadCaseInputs, StudyValue};
use super::value_range::ValueRange;
use crate::limits::POINTS;

/// By how much probabilities may miss 1: tables of occurrence are printed to few digits.
const ROUNDED: f64 = 1e-3;
/// By how much they miss it by rounding alone.
const ROUNDING: f64 = 1e-9;

/// The field of a key path that load cases may set; what is wrong where there is none, and what would be right.
pub type FieldOf<'a> = &'a dyn Fn(&str) -> Result<&'static Field, (String, String)>;

/// A key that load cases set.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCaseKey {
    /// Key path.
    pub path: String,
    /// The key.
    pub field: &'static Field,
}

/// Load cases, or one table of them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadCases {
    /// The keys, in the order of the columns.
    pub keys: Vec<LoadCaseKey>,
    /// A row a load case: a value for each key, in its unit.
    pub rows: Vec<Vec<StudyValue>>,
    /// Probability of each load case, where any table states it; they add up to 1.
    pub probability: Option<Vec<f64>>,
}

/// Why load cases cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LoadCaseError {
    /// A key set by two tables.
    #[error("`{0}` is set by two tables of load cases; give all of its values in one.")]
    Twice(String),
    /// Tables that go together and differ in length.
    #[error(
        "the tables of load cases zipped as `{0}` have {1} and {2} rows; give as many in each."
    )]
    Uneven(String, usize, usize),
    /// More than allowed.
    #[error("there are {count} load cases; {remedy}.", count = .0, remedy = POINTS.remedy("give fewer values", *.0 as f64))]
    TooMany(usize),
    /// A key that cannot be set, and what would be right.
    #[error("{}", sentence(.0, .1))]
    Key(String, String),
    /// A fault of a file, with its place.
    #[error("{0}")]
    Table(Box<Diagnostic>),
    /// A table that says too little or too much.
    #[error("a table of load cases has {0}.")]
    Incomplete(&'static str),
    /// Values that a key cannot have.
    #[error("{0}: {1}.")]
    Values(String, String),
}

impl LoadCases {
    /// The combinations of the tables of a file; `files` are the texts of the files that they name.
    ///
    /// # Errors
    /// What is wrong with a table, or why they do not go together.
    pub fn of_tables(
        tables: &[LoadCaseInputs],
        files: &BTreeMap<String, Attachment>,
        field: FieldOf<'_>,
    ) -> Result<Self, LoadCaseError> {
        let mut parts: Vec<(Option<&str>, Self)> = Vec::with_capacity(tables.len());
        for table in tables {
            let part = Self::of_table(table, files, field)?;
            let zip = table.zip.as_deref();
            let partner = parts
                .iter_mut()
                .find(|(other, _)| zip.is_some() && *other == zip);
            match (partner, zip) {
                (Some((_, partner)), Some(zip)) => partner.extend(part, zip)?,
                _ => parts.push((zip, part)),
            }
        }
        Self::combined(parts.into_iter().map(|(_, part)| part).collect())
    }

    fn of_table(
        table: &LoadCaseInputs,
        files: &BTreeMap<String, Attachment>,
        field: FieldOf<'_>,
    ) -> Result<Self, LoadCaseError> {
        match (&table.key, &table.file) {
            (Some(path), None) => {
                let wrong = |(problem, remedy)| LoadCaseError::Key(problem, remedy);
                let field = field(path).map_err(wrong)?;
                let values = match (&table.values, &table.range) {
                    (Some(values), None) => values.clone(),
                    (None, Some(range)) => {
                        let wrong = |e| LoadCaseError::Values(path.clone(), format!("{e}"));
                        ValueRange::parse(range, field).map_err(wrong)?.values
                    }
                    _ => {
                        let what = "neither values nor a range, or both";
                        return Err(LoadCaseError::Incomplete(what));
                    }
                };
                if let Some(word) = values.iter().find_map(unwritable) {
                    let why = format!(
                        "`{word}` cannot be kept in a table: give a word without commas, quotes and blanks around it"
                    );
                    return Err(LoadCaseError::Values(path.clone(), why));
                }
                Ok(Self::of_key(
                    path,
                    field,
                    values,
                    table.probability.as_deref(),
                ))
            }
            (None, Some(name)) => {
                let text = files.get(name).map_or("", |file| &*file.text);
                load_case_file::read(text, name, field)
                    .map_err(|fault| LoadCaseError::Table(Box::new(fault)))
            }
            _ => Err(LoadCaseError::Incomplete(
                "neither a key nor a file, or both",
            )),
        }
    }

    /// The values of one key.
    #[must_use]
    pub fn of_key(
        path: &str,
        field: &'static Field,
        values: Vec<StudyValue>,
        probability: Option<&[f64]>,
    ) -> Self {
        Self {
            keys: vec![LoadCaseKey {
                path: path.to_owned(),
                field,
            }],
            rows: values.into_iter().map(|value| vec![value]).collect(),
            probability: probability.map(<[f64]>::to_vec),
        }
    }

    /// Adds the columns of a table that goes together with this one, row by row.
    fn extend(&mut self, other: Self, zip: &str) -> Result<(), LoadCaseError> {
        let (own, theirs) = (self.rows.len(), other.rows.len());
        if own != theirs {
            return Err(LoadCaseError::Uneven(zip.to_owned(), own, theirs));
        }
        for (row, more) in self.rows.iter_mut().zip(other.rows) {
            row.extend(more);
        }
        self.keys.extend(other.keys);
        self.probability = match (self.probability.take(), other.probability) {
            (Some(a), Some(b)) => shares(
                &a.iter().zip(&b).map(|(a, b)| a * b).collect::<Vec<_>>(),
                false,
            ),
            (a, b) => a.or(b),
        };
        Ok(())
    }

    /// Every combination of the rows of some tables; those of the last one follow each other.
    ///
    /// # Errors
    /// A key of two tables, or too many combinations.
    pub fn combined(parts: Vec<Self>) -> Result<Self, LoadCaseError> {
        let counts = parts.iter().map(|part| part.rows.len());
        let count = counts.fold(1_usize, usize::saturating_mul);
        if POINTS.is_exceeded_by(count as f64) {
            return Err(LoadCaseError::TooMany(count));
        }
        let states = parts.iter().any(|part| part.probability.is_some());
        let mut all = Self {
            rows: vec![Vec::new()],
            probability: states.then(|| vec![1.0]),
            ..Self::default()
        };
        for part in parts {
            let twice = part
                .keys
                .iter()
                .find(|key| all.keys.iter().any(|known| known.path == key.path));
            if let Some(key) = twice {
                return Err(LoadCaseError::Twice(key.path.clone()));
            }
            let alike = 1.0 / part.rows.len().max(1) as f64;
            if let Some(known) = &mut all.probability {
                let of = |row: usize| part.probability.as_ref().map_or(alike, |p| p[row]);
                let more = known
                    .iter()
                    .flat_map(|p| (0..part.rows.len()).map(move |row| (*p, row)));
                *known = more.map(|(p, row)| p * of(row)).collect();
            }
            let with = |known: &Vec<StudyValue>| {
                let rows = part.rows.iter();
                rows.map(|row| [&known[..], row].concat())
                    .collect::<Vec<_>>()
            };
            all.rows = all.rows.iter().flat_map(with).collect();
            all.keys.extend(part.keys);
        }
        Ok(all)
    }
}

/// A word that a table of CSV as this program reads it cannot hold.
fn unwritable(value: &StudyValue) -> Option<&str> {
    let StudyValue::Word(word) = value else {
        return None;
    };
    let sound = !word.is_empty()
        && word.trim() == word
        && !word.starts_with('#')
        && !word.contains(|c: char| c == ',' || c == '"' || c.is_control());
    (!sound).then_some(word)
}

/// Weights over their sum; nothing where they have none, or are probabilities that do not add up to 1.
pub(super) fn shares(weights: &[f64], are_probabilities: bool) -> Option<Vec<f64>> {
    let sum: f64 = weights.iter().sum();
    let sound =
        sum > 0.0 && sum.is_finite() && (!are_probabilities || (sum - 1.0).abs() <= ROUNDED);
    let share = |weight: &f64| match are_probabilities && (sum - 1.0).abs() < ROUNDING {
        // Those that were read back keep their bits.
        true => *weight,
        false => weight / sum,
    };
    sound.then(|| weights.iter().map(share).collect())
}

/// Whether probabilities add up to 1, as well as a printed table does.
#[must_use]
pub(super) fn add_up(probability: &[f64]) -> bool {
    shares(probability, true).is_some()
}

/// What is wrong and what would be right, in a sentence.
fn sentence(problem: &str, remedy: &str) -> String {
    let end = if remedy.ends_with('?') { "" } else { "." };
    format!("{problem}; {remedy}{end}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::kind;
    use crate::case::model::Case;
    use crate::case::shipped::SHIPPED;

    fn text() -> &'static str {
        let found = SHIPPED
            .iter()
            .find(|(path, _)| path.ends_with("pendulous/manifold.toml"));
        found.unwrap().1
    }

    fn field(path: &str) -> Result<&'static Field, (String, String)> {
        kind::varied_field::<Case>(text(), path)
    }

    fn key(path: &str, values: &str, probability: Option<&[f64]>) -> LoadCases {
        let field = field(path).unwrap();
        let values = ValueRange::parse(values, field).unwrap().values;
        LoadCases::of_key(path, field, values, probability)
    }

    fn numbers(cases: &LoadCases) -> Vec<Vec<f64>> {
        let numbers = |row: &Vec<StudyValue>| row.iter().filter_map(StudyValue::number).collect();
        cases.rows.iter().map(numbers).collect()
    }

    const SPEED: &str = "current.speed_m_per_s";
    const MASS: &str = "payload.wet_mass_kg";

    #[test]
    fn tables_are_combined_and_the_last_one_follows_each_other() {
        let parts = vec![
            key(SPEED, "0.2,0.4", Some(&[0.25, 0.75])),
            key(MASS, "1e3,2e3,3e3", None),
        ];
        let cases = LoadCases::combined(parts).unwrap();
        let expected = [
            [0.2, 1e3],
            [0.2, 2e3],
            [0.2, 3e3],
            [0.4, 1e3],
            [0.4, 2e3],
            [0.4, 3e3],
        ];
        assert_eq!(numbers(&cases), expected);
        let probability = cases.probability.unwrap();
        assert!((probability.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        assert!((probability[4] - 0.25).abs() < 1e-15, "{probability:?}");
        let twice = LoadCases::combined(vec![key(SPEED, "1,2", None), key(SPEED, "3", None)]);
        assert_eq!(twice, Err(LoadCaseError::Twice(SPEED.to_owned())));
        assert!(LoadCases::combined(Vec::new()).unwrap().keys.is_empty());
    }

    #[test]
    fn words_that_a_table_cannot_hold_are_refused() {
        let field = |_: &str| field(SPEED);
        for word in ["a,b", "", " a", "#a", "a\nb", "\"a"] {
            let table = LoadCaseInputs {
                key: Some("ends.a.motion_file".to_owned()),
                values: Some(vec![StudyValue::Word(word.to_owned())]),
                range: None,
                zip: None,
                probability: None,
                file: None,
            };
            let found = LoadCases::of_tables(&[table], &BTreeMap::new(), &field);
            let why = found.unwrap_err().to_string();
            assert!(why.contains("cannot be kept in a table"), "{word}: {why}");
        }
    }

    #[test]
    fn tables_that_are_zipped_go_together() {
        let mut cases = key(SPEED, "0.2,0.4", Some(&[0.4, 0.6]));
        cases.extend(key(MASS, "1e3,2e3", None), "sea").unwrap();
        assert_eq!(numbers(&cases), [[0.2, 1e3], [0.4, 2e3]]);
        assert_eq!(cases.probability, Some(vec![0.4, 0.6]));
        let uneven = cases.extend(key("solver.duration_s", "1,2,3", None), "sea");
        assert_eq!(uneven, Err(LoadCaseError::Uneven("sea".to_owned(), 2, 3)));
    }

    #[test]
    fn a_file_has_a_row_for_each_load_case() {
        let text = "# scatter\ncurrent.speed_m_per_s, occurrences, payload.wet_mass_kg\n0.2, 30, 1 t\n\n0.4, 10, 2e3\n";
        let cases = load_case_file::read(text, "a.csv", &field).unwrap();
        assert_eq!(numbers(&cases), [[0.2, 1e3], [0.4, 2e3]]);
        assert_eq!(cases.probability, Some(vec![0.75, 0.25]));
    }

    #[test]
    fn faults_of_a_file_have_their_place() {
        let head = "current.speed_m_per_s,probability\n";
        for (text, line, column, why) in [
            ("", 1, 1, "is empty"),
            (head, 1, 1, "no load case"),
            ("probability\n1\n", 1, 1, "no column is a key"),
            ("current.sped_m_per_s\n1\n", 1, 1, "there is no key"),
            (
                "current.speed_m_per_s,current.speed_m_per_s\n1,1\n",
                1,
                23,
                "two columns",
            ),
            (
                "current.speed_m_per_s,probability,occurrences\n1,1,1\n",
                1,
                35,
                "weighted twice",
            ),
            (&format!("{head}0.2\n"), 2, 1, "1 values for 2 columns"),
            (
                &format!("{head}0.2,0.5\n0.2 kg,0.5\n"),
                3,
                1,
                "is no number of m/s",
            ),
            (&format!("{head}-3e9,1\n"), 2, 1, "out of range"),
            (&format!("{head}0.2..0.4/3,1\n"), 2, 1, "is not one value"),
            (&format!("{head}0.2,1.5\n"), 2, 5, "is no such number"),
            (&format!("{head}0.2,nan\n"), 2, 5, "is no such number"),
            (&format!("{head}0.2,0.5\n0.3,0.4\n"), 1, 1, "adds up to 0.9"),
        ] {
            let fault = load_case_file::read(text, "a.csv", &field).unwrap_err();
            assert_eq!(
                (fault.line, fault.column),
                (line, column),
                "{text}: {fault:?}"
            );
            assert!(fault.problem.contains(why), "{text}: {}", fault.problem);
        }
    }

    #[test]
    fn probabilities_that_are_read_back_keep_their_bits() {
        let third = [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0];
        assert_eq!(shares(&third, true), Some(third.to_vec()));
        assert_eq!(
            shares(&[0.3, 0.6995], true).map(|p| p.iter().sum::<f64>()),
            Some(1.0)
        );
        for wrong in [&[0.3, 0.6][..], &[0.0], &[f64::MAX, f64::MAX]] {
            assert_eq!(shares(wrong, true), None, "{wrong:?}");
        }
    }
}
