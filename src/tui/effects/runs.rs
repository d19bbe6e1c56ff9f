//! Stored runs: listed, kept, deleted.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::run::store::{self, RunLocation};
use crate::run::{Run, RunInfo, RunState};
use crate::tui::msg::Msg;
use crate::tui::state::{RunEntry, RunStatus, Severity};

/// The runs of these case files, the newest last; those of another case than the first are labelled with its name.
pub(super) fn list_runs(files: &[String]) -> Vec<RunEntry> {
    let entries = store::list(Path::new(store::DEFAULT_ROOT)).unwrap_or_default();
    let mut runs: Vec<RunEntry> = entries
        .into_iter()
        .filter_map(|entry| {
            let info = entry.info.ok()?;
            let place = files.iter().position(|file| *file == info.case_file)?;
            // A run of another case says which.
            let stem = info.case_file.trim_end_matches(".toml").to_owned();
            let mut run = self::entry(entry.dir, &info, entry.held);
            if place > 0 {
                run.label = format!("{stem} {}", run.label).trim_end().to_owned();
            }
            Some(run)
        })
        .collect();
    runs.reverse();
    runs
}

fn entry(dir: PathBuf, info: &RunInfo, held: bool) -> RunEntry {
    let text = fs::read_to_string(dir.join("case.toml")).unwrap_or_default();
    let mut entry = RunEntry::stored(info, text);
    entry.label = info.overrides.join(", ");
    entry.dir = Some(dir);
    if held && info.state == RunState::Partial {
        entry.state = RunStatus::Elsewhere;
    }
    entry
}

/// Deletes a run directory, and refuses to delete anything else.
pub(super) fn delete_run(dir: PathBuf) -> Msg {
    let deleted = store::read_info(&dir)
        .map_err(|e| e.to_string())
        .and_then(|_| fs::remove_dir_all(&dir).map_err(|e| e.to_string()));
    match deleted {
        Ok(()) => Msg::RunDeleted(dir),
        Err(error) => Msg::Say(
            Severity::Error,
            format!("{} cannot be deleted: {error}", dir.display()),
        ),
    }
}

/// Stores a run that is in memory.
pub(super) fn keep_run(run: Arc<Run>) -> Msg {
    let place = RunLocation::Below(PathBuf::from(store::DEFAULT_ROOT));
    match store::save(&place, &run) {
        Ok(dir) => Msg::Kept(dir, run),
        Err(error) => Msg::Say(Severity::Error, format!("The run cannot be kept: {error}")),
    }
}
