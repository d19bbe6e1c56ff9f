//! What the index answers.

use std::collections::BTreeMap;

use rusqlite::Row;

use super::sync::baseline_of;
use super::{IndexError, IndexedRun, RunIndex};
use crate::case::TextDigest;
use crate::run::RunState;

/// Runs of some case files: those that have changed since an earlier answer, and the numbers of all.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunRows {
    /// Runs that are new or have changed, and those that are partial: what computes them is seen elsewhere. Oldest first.
    pub changed: Vec<IndexedRun>,
    /// The numbers of all runs, ascending.
    pub all: Vec<i64>,
    /// The state of the index that this answer shows, for the next question.
    pub state: i64,
}

/// A result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredResult {
    /// Its value in SI.
    pub value: f64,
    /// Its unit.
    pub unit: String,
    /// Its numerical error, where it was estimated.
    pub error: Option<f64>,
    /// The range in which it lies, where it is not settled.
    pub unsettled: Option<(f64, f64)>,
}

/// An input that differs among runs.
#[derive(Debug, Clone, PartialEq)]
pub struct InputColumn {
    /// Its key.
    pub key: String,
    /// Its value in runs that are not named below; absent where they leave it out.
    pub usual: Option<String>,
    /// Its value in the others, by their numbers in ascending order.
    pub values: Vec<(i64, Option<String>)>,
}

impl InputColumn {
    /// Its value in a run.
    #[must_use]
    pub fn value_in_run(&self, run: i64) -> Option<&str> {
        let found = self.values.binary_search_by_key(&run, |(id, _)| *id);
        found.map_or(self.usual.as_deref(), |at| self.values[at].1.as_deref())
    }
}

/// A result of runs.
#[derive(Debug, Clone, PartialEq)]
pub struct ResultColumn {
    /// Its name.
    pub name: String,
    /// Its values by the numbers of the runs, in ascending order.
    pub values: Vec<(i64, MeasuredResult)>,
}

impl ResultColumn {
    /// Its value in a run.
    #[must_use]
    pub fn result_in_run(&self, run: i64) -> Option<&MeasuredResult> {
        let found = self.values.binary_search_by_key(&run, |(id, _)| *id);
        found.ok().map(|at| &self.values[at].1)
    }
}

/// Columns of a table of runs.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunColumns {
    /// Inputs that differ among the runs, by key.
    pub inputs: Vec<InputColumn>,
    /// The results that were asked for, in their order.
    pub results: Vec<ResultColumn>,
}

impl RunIndex {
    /// The runs of these case files, those that have changed since an earlier answer in full.
    ///
    /// # Errors
    /// The database fails.
    pub fn rows(&self, files: &[String], since: i64) -> Result<RunRows, IndexError> {
        let mut answer = RunRows::default();
        for file in files {
            let mut all = self
                .database
                .prepare_cached("SELECT id FROM runs WHERE case_file = ?1")?;
            for id in all.query_map([file], |row| row.get(0))? {
                answer.all.push(id?);
            }
            let mut changed = self.database.prepare_cached(
                "SELECT * FROM runs WHERE case_file = ?1 AND (change > ?2 OR state = 'partial')",
            )?;
            let rows = changed.query_map((file, since), |row| {
                let change: i64 = row.get("change")?;
                Ok((change, run(row)?))
            })?;
            for row in rows {
                let (change, run) = row?;
                answer.state = answer.state.max(change);
                answer.changed.push(run);
            }
        }
        answer.state = answer.state.max(since);
        answer.all.sort_unstable();
        let age = |run: &IndexedRun| (run.started.clone(), run.name.len(), run.name.clone());
        answer.changed.sort_by_cached_key(age);
        Ok(answer)
    }

    /// The inputs that differ among the runs of a case file, and these results of its runs.
    ///
    /// # Errors
    /// The database fails.
    pub fn columns(&self, file: &str, results: &[String]) -> Result<RunColumns, IndexError> {
        let inputs = self.input_columns(file)?;
        let results = results.iter().map(|name| self.result_column(file, name));
        Ok(RunColumns {
            inputs,
            results: results.collect::<Result<_, _>>()?,
        })
    }

    fn input_columns(&self, file: &str) -> Result<Vec<InputColumn>, IndexError> {
        let baseline = baseline_of(&self.database, file)?.unwrap_or_default();
        let mut query = self.database.prepare_cached(
            "SELECT names.name, inputs.run, inputs.value FROM inputs
             JOIN names ON names.id = inputs.key JOIN runs ON runs.id = inputs.run
             WHERE runs.case_file = ?1",
        )?;
        let mut columns: BTreeMap<String, Vec<(i64, Option<String>)>> = BTreeMap::new();
        let rows = query.query_map([file], |row| {
            Ok((row.get::<_, String>(0)?, (row.get(1)?, row.get(2)?)))
        })?;
        for row in rows {
            let (key, value) = row?;
            columns.entry(key).or_default().push(value);
        }
        let column = |(key, mut values): (String, Vec<_>)| {
            values.sort_unstable();
            InputColumn {
                usual: baseline.get(&key).cloned(),
                key,
                values,
            }
        };
        Ok(columns.into_iter().map(column).collect())
    }

    fn result_column(&self, file: &str, name: &str) -> Result<ResultColumn, IndexError> {
        let mut query = self.database.prepare_cached(
            "SELECT results.run, value, unit, error, least, greatest FROM results
             JOIN runs ON runs.id = results.run
             WHERE result = (SELECT id FROM names WHERE name = ?2) AND runs.case_file = ?1
             ORDER BY results.run",
        )?;
        let rows = query.query_map([file, name], |row| {
            let (least, greatest): (Option<f64>, Option<f64>) = (row.get(4)?, row.get(5)?);
            let result = MeasuredResult {
                value: row.get(1)?,
                unit: row.get(2)?,
                error: row.get(3)?,
                unsettled: least.zip(greatest),
            };
            Ok((row.get(0)?, result))
        })?;
        Ok(ResultColumn {
            name: name.to_owned(),
            values: rows.collect::<rusqlite::Result<_>>()?,
        })
    }

    /// The results that runs of a case file have, by name.
    ///
    /// # Errors
    /// The database fails.
    pub fn result_names(&self, file: &str) -> Result<Vec<String>, IndexError> {
        // The newest complete run has those of the case as it is.
        let mut query = self.database.prepare_cached(
            "SELECT names.name FROM results JOIN names ON names.id = results.result
             WHERE run = (SELECT id FROM runs WHERE case_file = ?1 AND state = 'done' ORDER BY started DESC LIMIT 1)
             ORDER BY names.id",
        )?;
        let names = query.query_map([file], |row| row.get(0))?;
        Ok(names.collect::<rusqlite::Result<_>>()?)
    }
}

fn run(row: &Row) -> rusqlite::Result<IndexedRun> {
    let json: String = row.get("overrides")?;
    let notes: String = row.get("notes")?;
    let state: String = row.get("state")?;
    Ok(IndexedRun {
        id: row.get("id")?,
        name: row.get("name")?,
        case_file: row.get("case_file")?,
        state: match state.as_str() {
            "done" => RunState::Done,
            "cancelled" => RunState::Cancelled,
            "partial" => RunState::Partial,
            _ => RunState::Failed,
        },
        failure: row.get("failure")?,
        damaged: row.get("damaged")?,
        started: row.get("started")?,
        method: row.get("method")?,
        duration_s: row.get("duration_s")?,
        steps: row.get::<_, i64>("steps")?.cast_unsigned(),
        cpu_s: row.get("cpu_s")?,
        overrides: serde_json::from_str(&json).unwrap_or_default(),
        text: TextDigest(row.get::<_, i64>("text")?.cast_unsigned()),
        notes: serde_json::from_str(&notes).unwrap_or_default(),
    })
}
