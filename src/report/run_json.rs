//! A run, and rows of validation tables, as JSON objects for scripts; keys end in their units.

use std::path::Path;

use serde_json::{Value, json};

use crate::reference::ValidationRow;
use crate::run::{Quantity, Run};

/// The results of a run, each with the parts of its error, and the directory that holds all else.
#[must_use]
pub fn run(run: &Run, directory: &Path) -> Value {
    let info = &run.info;
    json!({
        "kind": "run",
        "title": info.title,
        "version": info.version,
        "directory": directory.display().to_string(),
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
            "outcome": row.outcome.to_string(),
            "source": row.source,
        })
    });
    Value::Array(each.collect())
}
