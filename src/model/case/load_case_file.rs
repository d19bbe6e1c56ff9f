//! A file of load cases: CSV with a column for each key path, and a row for each load case.

use std::collections::BTreeMap;

use super::attachments::{FileSource, PlacedWord, placed_lines};
use super::check::varied;
use super::diagnostic::{Diagnostic, Finding};
use super::fields::Schema;
use super::load_cases::{FieldOf, LoadCaseKey, LoadCases, shares};
use super::model::{Attachment, LoadCaseInputs, StudyValue};
use super::value_range::ValueRange;
use crate::limits::POINTS;

/// A column of weights.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Weight {
    /// They add up to 1.
    Probability,
    /// How often each load case occurs, in whatever unit.
    Occurrences,
}

impl Weight {
    const ALL: [Self; 2] = [Self::Probability, Self::Occurrences];

    const fn name(self) -> &'static str {
        match self {
            Self::Probability => "probability",
            Self::Occurrences => "occurrences",
        }
    }

    fn read(self, word: &str) -> Result<f64, &'static str> {
        let (most, remedy) = match self {
            Self::Probability => (1.0, "write a number from 0 to 1"),
            Self::Occurrences => (f64::MAX, "write a number that is not negative"),
        };
        let number = word.parse::<f64>().ok();
        number.filter(|n| (0.0..=most).contains(n)).ok_or(remedy)
    }
}

/// What the columns hold.
struct LoadCaseColumns<'t> {
    head: Vec<PlacedWord<'t>>,
    keys: Vec<LoadCaseKey>,
    weight: Option<(usize, Weight)>,
}

/// Reads a file whose first line has the key paths, and `probability` or `occurrences` where they are known.
///
/// # Errors
/// The first fault, with its line and column.
pub fn read(text: &str, file: &str, field: FieldOf<'_>) -> Result<LoadCases, Diagnostic> {
    let whole = |problem: &str, remedy: String| Diagnostic::whole_file(file, problem, remedy);
    let placed = |finding: Finding| finding.at(file, text);
    let mut lines = placed_lines(text);
    let head = lines.next().ok_or_else(|| {
        let remedy = "begin with a line of key paths, then a line for each load case";
        whole("the table of load cases is empty", remedy.to_owned())
    })?;
    let count = lines.count();
    if POINTS.is_exceeded_by(count as f64) {
        let remedy = POINTS.remedy("give fewer", count as f64);
        return Err(whole("the table has too many load cases", remedy));
    }
    let columns = LoadCaseColumns::read(head, field).map_err(placed)?;
    let (mut rows, mut weights) = (Vec::with_capacity(count), Vec::new());
    for line in placed_lines(text).skip(1) {
        let (row, weight) = columns.row(&line).map_err(placed)?;
        rows.push(row);
        weights.extend(weight);
    }
    if rows.is_empty() {
        let remedy = "give a line for each load case";
        return Err(whole("the table has no load case", remedy.to_owned()));
    }
    let probability = match columns.weight {
        None => None,
        Some((_, of)) => {
            Some(probability(&weights, of).map_err(|(problem, remedy)| whole(&problem, remedy))?)
        }
    };
    Ok(LoadCases {
        keys: columns.keys,
        rows,
        probability,
    })
}

impl FileSource<'_> {
    /// Sees to it that the files of load cases are carried, and that they are such tables.
    pub fn take_load_cases(
        &self,
        files: &mut BTreeMap<String, Attachment>,
        tables: &[LoadCaseInputs],
        schema: &'static Schema,
    ) -> Result<(), Diagnostic> {
        for (index, table) in tables.iter().enumerate() {
            if let Some(name) = &table.file {
                let number = (index + 1).to_string();
                let shown = self.take(files, name, &["load_cases", &number, "file"])?;
                let field = |path: &str| varied(schema, self.root, path);
                read(&files[name].text, &shown, &field)?;
            }
        }
        Ok(())
    }
}

impl<'t> LoadCaseColumns<'t> {
    fn read(head: Vec<PlacedWord<'t>>, field: FieldOf<'_>) -> Result<Self, Finding> {
        let mut keys: Vec<LoadCaseKey> = Vec::new();
        let mut weight: Option<(usize, Weight)> = None;
        for (column, (name, span)) in head.iter().enumerate() {
            let fault =
                |problem: &str, remedy: &str| Err(Finding::new(span, *name, problem, remedy));
            if let Some(of) = Weight::ALL.into_iter().find(|of| of.name() == *name) {
                if weight.is_some() {
                    return fault(
                        "the load cases are weighted twice",
                        "keep one column of weights",
                    );
                }
                weight = Some((column, of));
                continue;
            }
            let wrong = |(problem, remedy)| Finding::new(span, *name, problem, remedy);
            let field = field(name).map_err(wrong)?;
            if keys.iter().any(|key| key.path == *name) {
                return fault("the key has two columns", "give each key one column");
            }
            keys.push(LoadCaseKey {
                path: (*name).to_owned(),
                field,
            });
        }
        if keys.is_empty() {
            let problem = "no column is a key, so that there is nothing to set";
            let remedy = "name a key path such as waves.height_m in the first line";
            return Err(Finding::new(&head[0].1, "", problem, remedy));
        }
        Ok(Self { head, keys, weight })
    }

    /// The values of a line in the order of the keys, and its weight.
    fn row(&self, line: &[PlacedWord<'_>]) -> Result<(Vec<StudyValue>, Option<f64>), Finding> {
        if line.len() != self.head.len() {
            let span = line[0].1.start..line[line.len() - 1].1.end;
            let (values, columns) = (line.len(), self.head.len());
            let problem = format!("the line has {values} values for {columns} columns");
            return Err(Finding::new(
                &span,
                "",
                problem,
                "give one value for each column",
            ));
        }
        let (mut row, mut weight) = (Vec::with_capacity(self.keys.len()), None);
        for (column, (word, span)) in line.iter().enumerate() {
            let fault = |problem: String, remedy: &str| {
                Finding::new(span, self.head[column].0, problem, remedy)
            };
            if let Some((_, of)) = self.weight.filter(|(at, _)| *at == column) {
                let wrong = |remedy| fault(format!("`{word}` is no such number"), remedy);
                weight = Some(of.read(word).map_err(wrong)?);
                continue;
            }
            let read = ValueRange::parse(word, self.keys[row.len()].field);
            let read = read.map_err(|error| fault(error.to_string(), "correct the value"))?;
            if read.values.len() != 1 {
                let problem = format!("`{word}` is not one value");
                return Err(fault(problem, "give one value in each column"));
            }
            row.extend(read.values);
        }
        Ok((row, weight))
    }
}

/// The weights as probabilities.
fn probability(weights: &[f64], of: Weight) -> Result<Vec<f64>, (String, String)> {
    shares(weights, of == Weight::Probability).ok_or_else(|| {
        let sum: f64 = weights.iter().sum();
        let remedy = match of {
            Weight::Probability => "let them add up to 1, or call the column occurrences",
            Weight::Occurrences => "give numbers whose sum is above zero",
        };
        (
            format!("the column {} adds up to {sum}", of.name()),
            remedy.to_owned(),
        )
    })
}
