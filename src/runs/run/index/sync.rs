//! Bringing the index in step with the directories of the runs.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use rusqlite::{OptionalExtension, Transaction, params};

use super::baseline::{self, Inputs};
use super::folder::{self, FolderRun};
use super::{IndexError, RunIndex};
use crate::run::RunState;

/// How far the index is in step with the directories.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct SyncProgress {
    /// Runs read so far, or gone.
    pub done: usize,
    /// Runs that are new, changed or gone.
    pub all: usize,
}

/// So many runs are taken in one step: a kill loses no more, and another program waits no longer.
const AT_ONCE: usize = 200;

/// The word of a state in the database.
pub(super) const fn state_word(state: RunState) -> &'static str {
    match state {
        RunState::Partial => "partial",
        RunState::Done => "done",
        RunState::Failed => "failed",
        RunState::Cancelled => "cancelled",
    }
}

impl RunIndex {
    /// Reads what is new or has changed, and forgets what is gone. Tells how far it is after each step, and stops when asked to;
    /// what is done until then stays.
    ///
    /// # Errors
    /// The directory cannot be listed, or the database fails.
    pub fn sync(
        &mut self,
        stop: &AtomicBool,
        told: &mut dyn FnMut(SyncProgress),
    ) -> Result<SyncProgress, IndexError> {
        let now = folder::stamps(&self.root)?;
        let known = self.known()?;
        let gone = known.keys().filter(|name| !now.contains_key(*name));
        let gone: Vec<(&String, Option<&String>)> = gone.map(|name| (name, None)).collect();
        let new = now
            .iter()
            .filter(|(name, stamp)| known.get(*name) != Some(stamp));
        let mut changes: Vec<_> = new.map(|(name, stamp)| (name, Some(stamp))).collect();
        // The newest first: names end in the time of their run.
        changes.reverse();
        changes.extend(gone);
        let mut progress = SyncProgress {
            done: 0,
            all: changes.len(),
        };
        for some in changes.chunks(AT_ONCE) {
            if stop.load(Ordering::Relaxed) {
                break;
            }
            self.take(some)?;
            progress.done += some.len();
            told(progress);
        }
        Ok(progress)
    }

    /// The stamps of the runs that the index knows.
    fn known(&self) -> Result<BTreeMap<String, String>, IndexError> {
        let mut query = self
            .database
            .prepare_cached("SELECT name, stamp FROM runs")?;
        let rows = query.query_map([], |row| Ok((row.get(0)?, row.get(1)?)))?;
        Ok(rows.collect::<rusqlite::Result<_>>()?)
    }

    /// Takes some changes in one step. Files are read before it begins, so that it is short.
    fn take(&mut self, changes: &[(&String, Option<&String>)]) -> Result<(), IndexError> {
        let read = |(name, stamp): &(&String, Option<&String>)| {
            let run =
                stamp.map(|stamp| (FolderRun::read(&self.root.join(name)), stamp.to_string()));
            ((*name).clone(), run)
        };
        let read: Vec<_> = changes.iter().map(read).collect();
        let behavior = rusqlite::TransactionBehavior::Immediate;
        let step = self.database.transaction_with_behavior(behavior)?;
        let change = next_change(&step)?;
        for (name, run) in read {
            match run {
                Some((run, stamp)) => insert(&step, &name, &stamp, change, &run)?,
                None => remove(&step, &name)?,
            }
        }
        step.commit()?;
        Ok(())
    }
}

/// The number of the next step; every run that it touches carries it.
fn next_change(step: &Transaction) -> rusqlite::Result<i64> {
    let next = "UPDATE counter SET change = change + 1 RETURNING change";
    step.query_row(next, [], |row| row.get(0))
}

fn remove(step: &Transaction, name: &str) -> rusqlite::Result<()> {
    let mut find = step.prepare_cached("SELECT id FROM runs WHERE name = ?1")?;
    let found: Option<i64> = find.query_row([name], |row| row.get(0)).optional()?;
    if let Some(id) = found {
        clear(step, id)?;
        step.prepare_cached("DELETE FROM runs WHERE id = ?1")?
            .execute([id])?;
    }
    Ok(())
}

/// Forgets inputs and results of a run.
fn clear(step: &Transaction, id: i64) -> rusqlite::Result<()> {
    for table in ["inputs", "results"] {
        step.prepare_cached(&format!("DELETE FROM {table} WHERE run = ?1"))?
            .execute([id])?;
    }
    Ok(())
}

fn insert(
    step: &Transaction,
    name: &str,
    stamp: &str,
    change: i64,
    run: &FolderRun,
) -> rusqlite::Result<()> {
    let id = insert_row(step, name, stamp, change, run)?;
    clear(step, id)?;
    if let Ok(info) = &run.info {
        insert_inputs(step, id, &info.case_file, &run.inputs)?;
    }
    let mut add =
        step.prepare_cached("INSERT OR REPLACE INTO results VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)")?;
    for (name, result) in &run.results {
        let (least, greatest) = result.unsettled.unzip();
        add.execute(params![
            number_of(step, name)?,
            id,
            result.value,
            result.unit,
            result.error,
            least,
            greatest
        ])?;
    }
    Ok(())
}

/// The row of a run; a run that is known keeps its number.
fn insert_row(
    step: &Transaction,
    name: &str,
    stamp: &str,
    change: i64,
    run: &FolderRun,
) -> rusqlite::Result<i64> {
    let info = run.info.as_ref().ok();
    let text = |of: fn(&crate::run::RunInfo) -> &str| info.map_or("", of);
    let failure = match &run.info {
        Ok(info) => info.failure.as_deref(),
        Err(why) => Some(why.as_str()),
    };
    let json = |words: serde_json::Result<String>| words.unwrap_or_default();
    step.prepare_cached(
        "INSERT INTO runs (name, stamp, change, case_file, state, failure, damaged, started, method, steps, cpu_s,
             overrides, text, notes, duration_s)
         VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15)
         ON CONFLICT (name) DO UPDATE SET stamp = ?2, change = ?3, case_file = ?4, state = ?5, failure = ?6, damaged = ?7,
             started = ?8, method = ?9, steps = ?10, cpu_s = ?11, overrides = ?12, text = ?13, notes = ?14,
             duration_s = ?15
         RETURNING id",
    )?
    .query_row(
        params![
            name,
            stamp,
            change,
            text(|i| &i.case_file),
            info.map_or("failed", |i| state_word(i.state)),
            failure,
            info.is_none(),
            text(|i| &i.started),
            text(|i| &i.settings.method),
            info.map_or(0, |i| i.work.steps.cast_signed()),
            info.map_or(0.0, |i| i.cost.cpu_s),
            json(serde_json::to_string(info.map_or(&Vec::new(), |i| &i.overrides))),
            run.text.0.cast_signed(),
            json(serde_json::to_string(&run.notes)),
            info.map_or(0.0, |i| i.settings.duration_s),
        ],
        |row| row.get(0),
    )
}

/// Keeps what differs from the baseline of the case file; the first run of a file is the baseline.
fn insert_inputs(
    step: &Transaction,
    id: i64,
    case_file: &str,
    inputs: &Inputs,
) -> rusqlite::Result<()> {
    let Some(baseline) = baseline_of(step, case_file)? else {
        let text = serde_json::to_string(inputs).unwrap_or_default();
        step.execute("INSERT INTO baselines VALUES (?1, ?2)", [case_file, &text])?;
        return Ok(());
    };
    let mut add = step.prepare_cached("INSERT OR REPLACE INTO inputs VALUES (?1, ?2, ?3)")?;
    for (key, value) in baseline::differences(&baseline, inputs) {
        add.execute(params![number_of(step, &key)?, id, value])?;
    }
    Ok(())
}

/// The baseline of a case file, if there is one.
pub(super) fn baseline_of(
    database: &rusqlite::Connection,
    case_file: &str,
) -> rusqlite::Result<Option<Inputs>> {
    let mut find = database.prepare_cached("SELECT inputs FROM baselines WHERE case_file = ?1")?;
    let found: Option<String> = find.query_row([case_file], |row| row.get(0)).optional()?;
    Ok(found.map(|text| serde_json::from_str(&text).unwrap_or_default()))
}

/// The number of a name, which is new where it was not known.
fn number_of(step: &Transaction, name: &str) -> rusqlite::Result<i64> {
    let mut find = step.prepare_cached("SELECT id FROM names WHERE name = ?1")?;
    if let Some(found) = find.query_row([name], |row| row.get(0)).optional()? {
        return Ok(found);
    }
    step.prepare_cached("INSERT INTO names (name) VALUES (?1)")?
        .execute([name])?;
    Ok(step.last_insert_rowid())
}
