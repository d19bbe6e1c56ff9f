//! A comparison for other programs: one row an item and run, every digit kept.

use seacable_runs::run::Quantity;
use seacable_studies::comparison::{Comparison, ResultChange, error_bar, letter};

/// Columns of the table.
const COLUMNS: [&str; 12] = [
    "section",
    "name",
    "unit",
    "run",
    "value",
    "error",
    "least",
    "greatest",
    "difference",
    "difference_error",
    "difference_relative",
    "verdict",
];

type CsvRow = [String; 12];

/// The comparison as CSV (RFC 4180): sections `run`, `input`, `setting`, `result`, `channel`, `published` and `cost`.
///
/// # Errors
/// When the writer fails, which writing to memory does not.
pub fn csv(comparison: &Comparison) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    for row in rows(comparison) {
        writer.write_record(row)?;
    }
    writer.flush()?;
    writer
        .into_inner()
        .map_err(|error| csv::Error::from(error.into_error()))
}

fn rows(comparison: &Comparison) -> Vec<CsvRow> {
    let mut rows: Vec<CsvRow> = Vec::new();
    for (index, run) in comparison.runs.iter().enumerate() {
        rows.push(plain("run", &run.case_file, "", index, run.id.clone()));
    }
    for input in &comparison.inputs {
        for (index, value) in input.values.iter().enumerate() {
            let text = value.as_ref().map_or_else(String::new, |v| v.text.clone());
            rows.push(plain("input", &input.path, input.unit, index, text));
        }
    }
    rows.extend(of_settings("setting", &comparison.settings));
    for result in &comparison.results {
        let (name, unit) = (result.id.to_string(), result.id.unit());
        for (index, value) in result.values.iter().enumerate() {
            let change = result.changes[index];
            rows.push(of_result(&name, &unit, index, value.as_ref(), change));
        }
    }
    rows.extend(of_channels(comparison));
    rows.extend(of_published(comparison));
    rows.extend(of_settings("cost", &comparison.cost));
    rows
}

fn plain(section: &str, name: &str, unit: &str, run: usize, value: String) -> CsvRow {
    let mut row = CsvRow::default();
    row[0] = section.to_owned();
    row[1] = name.to_owned();
    row[2] = unit.to_owned();
    row[3] = letter(run);
    row[4] = value;
    row
}

fn of_settings(
    section: &str,
    settings: &[seacable_studies::comparison::ComparedSetting],
) -> Vec<CsvRow> {
    let row = |setting: &seacable_studies::comparison::ComparedSetting| {
        let values = setting.values.iter().enumerate();
        let rows = values.map(|(run, value)| plain(section, setting.name, "", run, value.clone()));
        rows.collect::<Vec<CsvRow>>()
    };
    settings.iter().flat_map(row).collect()
}

fn of_result(
    name: &str,
    unit: &str,
    run: usize,
    value: Option<&Quantity>,
    change: Option<ResultChange>,
) -> CsvRow {
    let mut row = plain("result", name, unit, run, number(value.map(|q| q.value)));
    let bar = value.and_then(error_bar);
    row[5] = number(value.and_then(Quantity::error_estimate));
    row[6] = number(bar.map(|bar| bar[0]));
    row[7] = number(bar.map(|bar| bar[1]));
    row[8] = number(change.map(|change| change.absolute));
    row[9] = number(change.and_then(|change| change.error));
    row[10] = number(change.and_then(|change| change.relative));
    row[11] = match (value, change) {
        (None, _) => "missing".to_owned(),
        (_, change) => change.map_or_else(String::new, |c| c.agreement.words().to_owned()),
    };
    row
}

/// Root mean square and greatest size of the difference of every channel.
fn of_channels(comparison: &Comparison) -> Vec<CsvRow> {
    let mut rows = Vec::new();
    for channel in &comparison.channels {
        let unit = channel.id.quantity.unit();
        for (run, curve) in channel.differences.iter().enumerate() {
            let Some(curve) = curve else { continue };
            for (what, value) in [
                ("rms_difference", curve.rms),
                ("greatest_difference", curve.greatest.0),
            ] {
                let name = format!("{}.{what}", channel.id);
                rows.push(plain("channel", &name, unit, run, number(Some(value))));
            }
        }
    }
    rows
}

fn of_published(comparison: &Comparison) -> Vec<CsvRow> {
    let mut rows = Vec::new();
    for published in &comparison.validation {
        for (run, row) in published.rows.iter().enumerate() {
            let Some(known) = row else { continue };
            let mut row = plain(
                "published",
                &published.name,
                &known.unit,
                run,
                number(known.computed),
            );
            row[5] = number(known.error);
            row[8] = number(known.difference);
            row[11] = known.outcome.word().to_owned();
            rows.push(row);
        }
    }
    rows
}

/// A number with the digits that read back to the same bits; empty for none.
fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}
