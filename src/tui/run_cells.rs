//! The cells of the table of runs.

use super::state::{Charted, RunColumn, RunEntry, RunList};
use crate::case;
use crate::number;
use crate::run::index::MeasuredResult;

/// The head of a column, with how many runs there are and how it sorts.
#[must_use]
pub fn head(runs: &RunList, column: RunColumn) -> String {
    let words = match (column, runs.rows().len()) {
        (RunColumn::Name, 0) => "    run".to_owned(),
        (RunColumn::Name, count) => format!("    run ({count})"),
        _ => plain_head(runs, column),
    };
    match runs.sort {
        Some((by, down)) if by == column => format!("{words} {}", if down { "v" } else { "^" }),
        _ => words,
    }
}

/// The name of a column.
#[must_use]
pub fn plain_head(runs: &RunList, column: RunColumn) -> String {
    match column {
        RunColumn::Name => "run".to_owned(),
        RunColumn::State => "state".to_owned(),
        RunColumn::Input(at) => runs
            .columns
            .inputs
            .get(at)
            .map_or_else(String::new, |c| label(&c.key)),
        RunColumn::Result(at) => {
            let column = runs.columns.results.get(at);
            column.map_or_else(String::new, |c| c.name.clone())
        }
        RunColumn::Method => "solver".to_owned(),
        RunColumn::Steps => "steps".to_owned(),
        RunColumn::Cpu => "CPU".to_owned(),
        RunColumn::Age => "begun".to_owned(),
        RunColumn::Tags => "tags".to_owned(),
    }
}

/// An input as the inputs call it, with its unit.
fn label(key: &str) -> String {
    match axis_name(key) {
        (name, "") => name,
        (name, unit) => format!("{name} [{unit}]"),
    }
}

/// An input as the inputs call it, and its unit; empty for pure numbers and words.
#[must_use]
pub fn axis_name(key: &str) -> (String, &'static str) {
    let path: Vec<&str> = key.split('.').collect();
    match case::field_at(&path) {
        Some(field) => {
            // Of several sections each has the same labels.
            let name = match path.as_slice() {
                ["line" | "materials", name, ..] => format!("{name} "),
                _ => String::new(),
            };
            let unit = if field.unit == "-" { "" } else { field.unit };
            (format!("{name}{}", field.label), unit)
        }
        None => (key.to_owned(), ""),
    }
}

/// A cell of a run.
#[must_use]
pub fn cell(runs: &RunList, run: &RunEntry, column: RunColumn) -> String {
    match column {
        RunColumn::Name => {
            let shown = if run.shown { "x" } else { " " };
            let mark = if run.marked { "*" } else { "" };
            // What the columns of inputs do not say yet.
            let label = if run.number.is_none() && !run.label.is_empty() {
                format!("{}: ", run.label)
            } else {
                String::new()
            };
            format!("[{shown}]{mark} {label}{}", run.title())
        }
        RunColumn::State => run.state.word().to_owned(),
        RunColumn::Input(_) => runs.input(run, column).unwrap_or_default().to_owned(),
        RunColumn::Result(at) => runs.result(run, at).map_or_else(String::new, result),
        RunColumn::Method => run.method.clone(),
        RunColumn::Steps => run
            .cost
            .map_or_else(String::new, |(steps, _)| steps.to_string()),
        RunColumn::Cpu => run
            .cost
            .map_or_else(String::new, |(_, cpu)| number::duration(cpu)),
        RunColumn::Age => age(&run.started),
        RunColumn::Tags => run.notes.tags.join(" "),
    }
}

/// A result with its error, as everywhere.
fn result(result: &MeasuredResult) -> String {
    if let Some((least, greatest)) = result.unsettled {
        return number::range(least, greatest, &result.unit);
    }
    number::with_error(result.value, result.error, &result.unit)
}

/// A cell of the live run.
#[must_use]
pub fn live_cell(on: Charted<'_>, column: RunColumn) -> String {
    let live = &on.view.live;
    let run = live.done.as_ref().and_then(|done| done.run.as_ref());
    match column {
        RunColumn::Name => {
            let shown = if live.hidden { " " } else { "x" };
            let kept = if live.kept.is_some() { ", kept" } else { "" };
            format!("[{shown}] live, in memory{kept}")
        }
        RunColumn::State => match (&live.ticket, &live.failure, &live.done) {
            (Some(_), ..) => "running",
            (None, Some(why), _) if why == "cancelled" => "cancelled",
            (None, Some(_), _) => "failed",
            (None, None, Some(_)) => "done",
            (None, None, None) => "",
        }
        .to_owned(),
        RunColumn::Input(_) | RunColumn::Age | RunColumn::Tags => String::new(),
        RunColumn::Result(at) => {
            let name = on
                .view
                .runs
                .columns
                .results
                .get(at)
                .map(|c| c.name.as_str());
            let found = name.and_then(|name| run?.quantity(name));
            found.map_or_else(String::new, |q| {
                result(&MeasuredResult {
                    value: q.value,
                    unit: q.unit().to_owned(),
                    error: q.error_estimate(),
                    unsettled: q.unsettled.map(|[least, greatest]| (least, greatest)),
                })
            })
        }
        RunColumn::Method => on
            .case
            .map_or_else(String::new, |case| case.solver.method.name().to_owned()),
        RunColumn::Steps => run.map_or_else(String::new, |run| run.info.work.steps.to_string()),
        RunColumn::Cpu => run.map_or_else(String::new, |run| number::duration(run.info.cost.cpu_s)),
    }
}

/// `2026-11-22 21:05`, from RFC 3339 in UTC.
fn age(started: &str) -> String {
    started.get(..16).unwrap_or(started).replace('T', " ")
}
