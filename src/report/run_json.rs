//! A run, and rows of validation tables, as JSON objects for scripts; keys end in their units.

use seacable_base::visible;
use std::path::Path;

use serde_json::{Value, json};

use super::table::Table;
use seacable_engine::modes::LineModes;
use seacable_model::case::{Provenance, StudyValue};
use seacable_runs::reference::papers::{Answer, JudgedStatement, Paper};
use seacable_runs::reference::{TrendLine, ValidationRow};
use seacable_runs::run::{Quantity, Run};

/// The results of a run, each with the parts of its error, and the directory that holds all else.
#[must_use]
pub fn run(run: &Run, directory: &Path) -> Value {
    let info = &run.info;
    json!({
        "kind": "run",
        "title": info.title,
        "version": info.version,
        "directory": visible::path(directory),
        "state": info.state,
        "failure": info.failure,
        "warnings": info.warnings,
        "results": run.summary.iter().map(result).collect::<Vec<_>>(),
    })
}

fn result(quantity: &Quantity) -> Value {
    json!({
        "name": quantity.id.to_string(),
        "value": quantity.value,
        "unit": quantity.unit(),
        "time_error": quantity.time_error,
        "mesh_error": quantity.mesh_error,
        "not_settled_between": quantity.unsettled,
    })
}

/// A study: the rows of its table by the heads of their columns.
#[must_use]
pub fn study(name: &str, table: &Table) -> Value {
    json!({
        "kind": "study",
        "study": name,
        "title": table.title,
        "rows": table.to_json(),
        "notes": table.notes,
    })
}

/// The natural modes of a line, from the lowest frequency up.
#[must_use]
pub fn modes(found: &LineModes) -> Value {
    json!({"kind": "line_modes", "modes": each_mode(found)})
}

/// Each natural mode of lines.
#[must_use]
pub fn each_mode(found: &LineModes) -> Vec<Value> {
    let each = found.modes.iter().map(|named| {
        let mode = &named.mode;
        let vibrates = mode.eigenvalue > 0.0;
        json!({
            "frequency_hz": vibrates.then(|| mode.frequency_hz()),
            "error_hz": named.error_hz.filter(|_| vibrates),
            "period_s": vibrates.then(|| 1.0 / mode.frequency_hz()),
            "moves": mode.kind.name(),
            "of_kind": named.of_kind,
            "half_waves": mode.half_waves,
            "out_of_plane": mode.out_of_plane,
        })
    });
    each.collect()
}

/// A validation table.
#[must_use]
pub fn validation(rows: &[ValidationRow]) -> Value {
    let each = rows.iter().map(|row| {
        json!({
            "name": row.name,
            "published": row.published,
            "computed": row.computed,
            "unit": row.unit,
            "error": row.error,
            "tolerance": row.tolerance,
            "tolerance_reason": row.tolerance_reason,
            "outcome": row.outcome.to_string(),
            "kind": row.kind.word(),
            "inputs": row.inputs.map(Provenance::name),
            "trend": row.trend.as_ref().map(trend),
            "note": row.note,
            "reason": row.reason,
            "source": row.source,
        })
    });
    Value::Array(each.collect())
}

/// A paper with its statements answered.
#[must_use]
pub fn paper(paper: &Paper, statements: &[JudgedStatement<'_>]) -> Value {
    let each = statements.iter().map(|one| {
        let (word, reason) = answer(&one.answer);
        let statement = one.statement;
        json!({
            "printed_in": statement.printed_in,
            "says": statement.says,
            "answer": word,
            "reason": reason,
            "second": one.second.as_ref().map(|second| answer(second).0),
            "rows": statement.rows,
            "input": statement.input,
            "code": statement.code,
            "test": statement.test,
        })
    });
    json!({
        "title": paper.about.title,
        "cite": paper.about.cite,
        "cases": paper.about.cases,
        "statements": each.collect::<Vec<_>>(),
    })
}

/// The word for an answer, and the reason where it is none.
fn answer(answer: &Answer) -> (&'static str, Option<&str>) {
    match answer {
        Answer::Input => ("input", None),
        Answer::Equation => ("equation", None),
        Answer::Agrees(kind) => (kind.word(), None),
        Answer::NotReproduced(reason) => ("not reproduced", Some(reason)),
        Answer::Untestable(reason) => ("untestable", Some(reason)),
        Answer::NotAttempted(reason) => ("not attempted", Some(reason)),
    }
}

/// What a trend should do, and the numbers along it.
fn trend(line: &TrendLine) -> Value {
    let points = line.points.iter().map(|point| {
        let value = match &point.value {
            StudyValue::Number(value) => json!(value),
            StudyValue::Word(word) => json!(word),
        };
        json!({"value": value, "computed": point.computed, "error": point.error})
    });
    json!({
        "key": line.key,
        "expect": line.expect.name(),
        "points": points.collect::<Vec<_>>(),
    })
}
