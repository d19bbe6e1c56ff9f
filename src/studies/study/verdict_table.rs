//! Trials as the table that screen and command line show.

use std::path::Path;

use super::verdict::{CheckedNumber, TrialOutcome, TrialVerdict};
use crate::number::{digits, si};
use crate::run::{Settings, Work};
use crate::table::{Align, Cell, CellStyle, Table};

/// A row of the full table: a trial with one of its numbers.
struct TrialRow<'a> {
    verdict: &'a TrialVerdict,
    /// Number of the trial, from 1.
    trial: usize,
    /// Whether this is the first row of the case, and of the trial.
    first: (bool, bool),
    number: Option<&'a CheckedNumber>,
}

impl TrialRow<'_> {
    /// A cell of the trial, on its first row.
    fn once(&self, cell: impl Fn(&TrialVerdict) -> Cell) -> Cell {
        if self.first.1 {
            cell(self.verdict)
        } else {
            Cell::default()
        }
    }

    /// A cell of the number.
    fn number(&self, text: impl Fn(&CheckedNumber) -> Option<String>) -> Cell {
        self.number
            .and_then(text)
            .map_or_else(Cell::none, Cell::plain)
    }
}

/// The rows of a trial, one a number or one without any.
fn rows_of(verdicts: &[TrialVerdict], index: usize) -> Vec<TrialRow<'_>> {
    let verdict = &verdicts[index];
    let previous = index.checked_sub(1).map(|i| &verdicts[i].file);
    let row = |(i, number)| TrialRow {
        verdict,
        trial: index + 1,
        first: (previous != Some(&verdict.file), i == 0),
        number,
    };
    if verdict.numbers.is_empty() {
        return vec![row((0, None))];
    }
    let numbers = verdict.numbers.iter().map(Some).enumerate();
    numbers.map(row).collect()
}

/// The table of hard cases: a row a number of every trial, the trial's own words on its first row. The notes give the
/// reasons of what was refused or is wrong, by the number of the trial.
#[must_use]
pub fn table(findings: &[TrialVerdict]) -> Table {
    let rows: Vec<TrialRow<'_>> = (0..findings.len())
        .flat_map(|index| rows_of(findings, index))
        .collect();
    let count = |row: &TrialRow<'_>, of: fn(&Work) -> u64| {
        row.once(|v| Cell::plain(work(v, of).map_or_else(|| "-".to_owned(), |n| n.to_string())))
    };
    let notes = findings.iter().enumerate().filter_map(|(i, finding)| {
        let reason = finding.reason.as_ref()?;
        Some(format!("[{}] {}: {reason}", i + 1, finding.outcome.word()))
    });
    Table::of_records("", &rows)
        .cell("outcome", Align::Left, |row| row.once(outcome))
        .text("case", |row| match row.first {
            (true, true) => row.verdict.case.as_str(),
            _ => "",
        })
        .cell("trial", Align::Left, |row| {
            row.once(|v| Cell::plain(format!("[{}] {}", row.trial, v.trial)))
        })
        .cell("solver", Align::Left, |row| {
            row.once(|v| Cell::plain(v.settings.as_ref().map_or_else(String::new, solver)))
        })
        .cell("quantity", Align::Left, |row| {
            row.number(|n| Some(n.name.clone()))
        })
        .cell("expected", Align::Right, |row| {
            row.number(|n| Some(si(n.expected, &n.unit)))
        })
        .cell("computed", Align::Right, |row| {
            row.number(|n| Some(si(n.computed?, &n.unit)))
        })
        .cell("error", Align::Right, |row| row.number(error))
        .cell("allowed", Align::Right, |row| {
            row.number(|n| Some(size(n.tolerance, n)))
        })
        .cell("steps", Align::Right, |row| count(row, |w| w.steps))
        .cell("iterations", Align::Right, |row| count(row, iterations))
        .cell("rejections", Align::Right, |row| {
            count(row, |w| w.rejections)
        })
        .build()
        .noted(notes)
}

/// The same with a row a trial, on 80 columns: its number that is nearest to the limit or beyond, and its work.
#[must_use]
pub fn compact_table(findings: &[TrialVerdict]) -> Table {
    let rows: Vec<(usize, &TrialVerdict)> = findings.iter().enumerate().collect();
    let count = |(_, verdict): &(usize, &TrialVerdict), of: fn(&Work) -> u64| {
        work(verdict, of).map_or_else(Cell::none, |n| Cell::plain(n.to_string()))
    };
    Table::of_records("", &rows)
        .cell("outcome", Align::Left, |row| outcome(row.1))
        .text("case", |row| {
            let stem = Path::new(&row.1.file).file_stem().unwrap_or_default();
            stem.to_string_lossy()
        })
        .text("trial", |row| format!("[{}] {}", row.0 + 1, row.1.trial))
        .cell("error", Align::Right, |row| {
            let numbers = row.1.numbers.iter();
            let worst = numbers.max_by(|a, b| a.share().total_cmp(&b.share()));
            worst.and_then(error).map_or_else(Cell::none, Cell::plain)
        })
        .cell("steps", Align::Right, |row| count(row, |w| w.steps))
        .cell("work", Align::Right, |row| count(row, iterations))
        .cell("rej.", Align::Right, |row| count(row, |w| w.rejections))
        .build()
}

/// A count of the work of a trial that ran.
fn work(verdict: &TrialVerdict, of: fn(&Work) -> u64) -> Option<u64> {
    verdict.settings.as_ref().map(|_| of(&verdict.work))
}

fn iterations(work: &Work) -> u64 {
    work.iterations + work.evaluations
}

/// Difference of a number from what is expected.
fn error(number: &CheckedNumber) -> Option<String> {
    Some(size(number.computed? - number.expected, number))
}

/// All that a trial says, in sentences.
#[must_use]
pub fn description(finding: &TrialVerdict) -> Vec<String> {
    let how = finding.settings.as_ref().map_or_else(String::new, solver);
    let title = finding.case.trim_end_matches('.');
    let mut lines = vec![format!("{title}: {}; {how}", finding.trial)];
    lines.extend(finding.reason.clone());
    lines.extend(finding.numbers.iter().map(|n| {
        let computed = n
            .computed
            .map_or_else(|| "nothing".to_owned(), |v| si(v, &n.unit));
        let off = n.computed.map_or_else(String::new, |v| {
            format!(
                ", off by {} of {} allowed",
                size(v - n.expected, n),
                size(n.tolerance, n)
            )
        });
        format!(
            "{}: {computed}, must be {}{off}. After {}",
            n.name,
            si(n.expected, &n.unit),
            n.source
        )
    }));
    lines
}

/// The method with what sets its accuracy.
fn solver(settings: &Settings) -> String {
    let mut words = settings.method.clone();
    if let Some(rho) = settings.rho_inf {
        words.push_str(&format!(" rho {rho}"));
    }
    if settings.step_tolerance.is_some() {
        words.push_str(", steps vary");
    } else if settings.time_step_s > 0.0 {
        words.push_str(&format!(", {} s", digits(settings.time_step_s, 3)));
    }
    words
}

fn outcome(finding: &TrialVerdict) -> Cell {
    let ink = match finding.outcome {
        TrialOutcome::Wrong => CellStyle::Bad,
        _ if !finding.is_as_expected() => CellStyle::Warn,
        TrialOutcome::Ok | TrialOutcome::Refused => CellStyle::Good,
    };
    Cell::new(finding.outcome.word(), ink)
}

/// A difference: relative to the number where that is not nothing, else in its unit.
fn size(difference: f64, number: &CheckedNumber) -> String {
    if number.expected == 0.0 {
        si(difference.abs(), &number.unit)
    } else {
        format!("{:.1e}", (difference / number.expected).abs())
    }
}
