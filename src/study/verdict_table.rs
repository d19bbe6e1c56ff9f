//! Trials as the table that screen and command line show.

use std::path::Path;

use super::verdict::{CheckedNumber, TrialOutcome, TrialVerdict};
use crate::number::{digits, si};
use crate::report::table::{Cell, CellInk, Column, Table};
use crate::run::Settings;

/// The table of hard cases: a row a number of every trial, the trial's own words on its first row. The notes give the
/// reasons of what was refused or is wrong, by the number of the trial.
#[must_use]
pub fn table(findings: &[TrialVerdict]) -> Table {
    let mut rows = Vec::new();
    let mut notes = Vec::new();
    for (index, finding) in findings.iter().enumerate() {
        let number = index + 1;
        rows.extend(rows_of(
            finding,
            number,
            index.checked_sub(1).and_then(|i| findings.get(i)),
        ));
        if let Some(reason) = &finding.reason {
            notes.push(format!("[{number}] {}: {reason}", finding.outcome.word()));
        }
    }
    Table {
        title: String::new(),
        columns: vec![
            Column::left("outcome"),
            Column::left("case"),
            Column::left("trial"),
            Column::left("solver"),
            Column::left("quantity"),
            Column::right("expected"),
            Column::right("computed"),
            Column::right("error"),
            Column::right("allowed"),
            Column::right("steps"),
            Column::right("iterations"),
            Column::right("rejections"),
        ],
        rows,
        notes,
    }
}

/// The same with a row a trial, on 80 columns: its number that is nearest to the limit or beyond, and its work.
#[must_use]
pub fn compact_table(findings: &[TrialVerdict]) -> Table {
    let rows = findings.iter().enumerate().map(|(i, finding)| {
        let stem = Path::new(&finding.file).file_stem().unwrap_or_default();
        let worst = finding
            .numbers
            .iter()
            .max_by(|a, b| a.share().total_cmp(&b.share()));
        let error = worst.and_then(|n| Some(size(n.computed? - n.expected, n)));
        let none = || Cell::new("-", CellInk::Dim);
        let (work, ran) = (finding.work, finding.settings.is_some());
        let count = |n: u64| {
            if ran {
                Cell::plain(n.to_string())
            } else {
                none()
            }
        };
        vec![
            outcome(finding),
            Cell::plain(stem.to_string_lossy()),
            Cell::plain(format!("[{}] {}", i + 1, finding.trial)),
            error.map_or_else(none, Cell::plain),
            count(work.steps),
            count(work.iterations + work.evaluations),
            count(work.rejections),
        ]
    });
    Table {
        columns: vec![
            Column::left("outcome"),
            Column::left("case"),
            Column::left("trial"),
            Column::right("error"),
            Column::right("steps"),
            Column::right("work"),
            Column::right("rej."),
        ],
        rows: rows.collect(),
        ..Table::default()
    }
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

fn rows_of(finding: &TrialVerdict, number: usize, before: Option<&TrialVerdict>) -> Vec<Vec<Cell>> {
    let first_of_case = before.is_none_or(|other| other.file != finding.file);
    let work = &finding.work;
    let count = |n: u64| {
        Cell::plain(if finding.settings.is_some() {
            n.to_string()
        } else {
            "-".to_owned()
        })
    };
    let head = vec![
        outcome(finding),
        Cell::plain(if first_of_case {
            finding.case.as_str()
        } else {
            ""
        }),
        Cell::plain(format!("[{number}] {}", finding.trial)),
        Cell::plain(finding.settings.as_ref().map_or_else(String::new, solver)),
    ];
    let tail = vec![
        count(work.steps),
        count(work.iterations + work.evaluations),
        count(work.rejections),
    ];
    if finding.numbers.is_empty() {
        let none = || Cell::new("-", CellInk::Dim);
        return vec![[head, (0..5).map(|_| none()).collect(), tail].concat()];
    }
    let numbers = finding.numbers.iter().enumerate();
    numbers
        .map(|(i, number)| {
            let blank = |n: usize| (0..n).map(|_| Cell::plain("")).collect::<Vec<_>>();
            if i == 0 {
                [head.clone(), cells(number), tail.clone()].concat()
            } else {
                [blank(4), cells(number), blank(3)].concat()
            }
        })
        .collect()
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
        TrialOutcome::Wrong => CellInk::Bad,
        _ if !finding.is_as_expected() => CellInk::Warn,
        TrialOutcome::Ok | TrialOutcome::Refused => CellInk::Good,
    };
    Cell::new(finding.outcome.word(), ink)
}

fn cells(number: &CheckedNumber) -> Vec<Cell> {
    let unit = number.unit.as_str();
    let shown = |value: f64| Cell::plain(si(value, unit));
    let missing = || Cell::new("-", CellInk::Dim);
    vec![
        Cell::plain(number.name.as_str()),
        shown(number.expected),
        number.computed.map_or_else(missing, shown),
        number.computed.map_or_else(missing, |value| {
            Cell::plain(size(value - number.expected, number))
        }),
        Cell::plain(size(number.tolerance, number)),
    ]
}

/// A difference: relative to the number where that is not nothing, else in its unit.
fn size(difference: f64, number: &CheckedNumber) -> String {
    if number.expected == 0.0 {
        si(difference.abs(), &number.unit)
    } else {
        format!("{:.1e}", (difference / number.expected).abs())
    }
}
