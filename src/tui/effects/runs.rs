//! Stored runs: kept, annotated, deleted.

use crate::visible;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::facade;
use crate::kinds::FileType;
use crate::msg::{Msg, RunCaseUse};
use crate::run::Run;
use crate::run::store::{self, RunLocation, RunNotes};
use crate::state::reading::content;
use crate::state::{ParameterEditor, Severity};

/// Deletes run directories, and refuses to delete anything else.
pub(super) fn delete_runs(dirs: Vec<PathBuf>) -> Vec<Msg> {
    let mut deleted = Vec::new();
    let mut answers = Vec::new();
    for dir in dirs {
        match store::delete(&dir) {
            Ok(()) => deleted.push(dir),
            Err(error) => {
                let words = format!("{} cannot be deleted: {error}", visible::path(&dir));
                answers.push(Msg::Say(Severity::Error, words));
            }
        }
    }
    answers.insert(0, Msg::RunsDeleted(deleted));
    answers
}

/// Stores a run that is in memory.
pub(super) fn keep_run(run: Arc<Run>) -> Msg {
    let place = RunLocation::Below(PathBuf::from(store::DEFAULT_ROOT));
    match store::save(&place, &run) {
        Ok(dir) => Msg::Kept(dir, run),
        Err(error) => Msg::Say(Severity::Error, format!("The run cannot be kept: {error}")),
    }
}

/// Keeps what the user says of a run.
pub(super) fn write_notes(dir: &Path, notes: &RunNotes) -> Vec<Msg> {
    let failed = notes.write(dir).err();
    let say = |error| Msg::Say(Severity::Error, format!("The note cannot be kept: {error}"));
    failed.map(say).into_iter().collect()
}

/// The exact case of a run of the case in this file.
pub(super) fn read_run_case(dir: PathBuf, wanted: RunCaseUse, beside: &Path) -> Msg {
    let read = || {
        let text = store::case_text(&dir)
            .map_err(|error| format!("The case of the run cannot be read: {error}"))?;
        let name = ParameterEditor::name_of(beside);
        let content = content(FileType::of_text(&text), &text, beside, &name);
        let content = content.map_err(|all| {
            let problem = facade::first(&all, &name);
            format!("The case of the run is none of this version: {problem}")
        })?;
        Ok((text, content))
    };
    let read = read();
    Msg::RunCase(dir, wanted, read)
}
