//! The runs of the open case.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::export;
use super::motion::moved;
use super::notice::info;
use crate::run::Run;
use crate::tui::facade;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::{
    AppState, Document, JobNumber, JobState, LineView, RunCurves, RunEntry, RunOrigin, RunStatus,
    Severity,
};

/// Stores the live run.
pub(super) fn keep(state: &AppState) -> Vec<Effect> {
    let done = state.line().and_then(|line| line.live.done.as_ref());
    let run = done.and_then(|done| done.run.clone());
    run.map(Effect::KeepRun).into_iter().collect()
}

/// Shows the run under the cursor alone.
pub fn show_alone(state: &mut AppState) -> Vec<Effect> {
    let Some(line) = state.line_mut() else {
        return Vec::new();
    };
    let at = line.run;
    line.live.hidden = at > 0;
    for (i, entry) in line.runs.iter_mut().enumerate() {
        entry.shown = i + 1 == at;
    }
    let name = line
        .current_run()
        .map_or_else(|| "the live run".to_owned(), |r| r.id.clone());
    let effects = at
        .checked_sub(1)
        .and_then(|i| line.runs.get(i))
        .map_or_else(Vec::new, load);
    info(state, format!("Charts and report now show {name}."));
    effects
}

/// Shows the run under the cursor beside the others, or takes it off.
pub fn select(line: &mut LineView) -> Vec<Effect> {
    let effects = match line.run.checked_sub(1).and_then(|i| line.runs.get_mut(i)) {
        Some(entry) => {
            entry.shown = !entry.shown;
            if entry.shown { load(entry) } else { Vec::new() }
        }
        None => {
            line.live.hidden = !line.live.hidden;
            Vec::new()
        }
    };
    line.run = moved(line.run, 1, line.runs.len() + 1);
    effects
}

/// Reads a stored run when it is needed for the first time.
pub(super) fn load(entry: &RunEntry) -> Vec<Effect> {
    let missing = entry.kind == RunOrigin::Stored && entry.curves.run.is_none();
    entry
        .dir
        .iter()
        .filter(|_| missing)
        .map(|dir| Effect::ReadRun(dir.clone()))
        .collect()
}

pub(super) fn stored(state: &mut AppState, ticket: JobNumber, dir: PathBuf) -> Vec<Effect> {
    if let Some(line) = state.line_mut()
        && let Some(entry) = line.runs.iter_mut().find(|s| s.ticket == Some(ticket))
    {
        if let Some(name) = dir.file_name() {
            entry.id = name.to_string_lossy().into_owned();
        }
        entry.dir = Some(dir);
    }
    Vec::new()
}

pub(super) fn kept(state: &mut AppState, dir: &Path, run: Arc<Run>) -> Vec<Effect> {
    if let Some(line) = state.line_mut() {
        let mut entry = RunEntry::stored(&run.info, run.case_text.clone());
        if let Some(name) = dir.file_name() {
            entry.id = name.to_string_lossy().into_owned();
        }
        entry.dir = Some(dir.to_owned());
        entry.curves = RunCurves::whole(run);
        line.runs.push(entry);
        line.live.kept = Some(dir.to_owned());
    }
    info(state, format!("Kept in {}.", dir.display()))
}

/// Asks for the stored runs of a line case, and of those beside it.
pub(super) fn list(state: &AppState) -> Option<Effect> {
    let (line, editor) = (state.line()?, state.editor()?);
    let mut files = vec![editor.file.clone()];
    files.extend(line.case.case.beside.iter().flatten().cloned());
    Some(Effect::ListRuns(files))
}

/// Stored runs join the list; those that the validation table needs are read.
pub(super) fn listed(state: &mut AppState, entries: Vec<RunEntry>) -> Vec<Effect> {
    let document = state.document.as_mut();
    let Some((line, editor)) = document.and_then(Document::line_and_editor) else {
        return Vec::new();
    };
    let needed = line.needed(editor);
    let mut effects = Vec::new();
    for mut entry in entries {
        let same = |s: &&mut RunEntry| s.dir.is_some() && s.dir == entry.dir;
        if let Some(known) = line.runs.iter_mut().find(same) {
            if known.state != entry.state && known.kind == RunOrigin::Stored {
                entry.shown = known.shown;
                entry.at = known.at.take();
                entry.label = std::mem::take(&mut known.label);
                *known = entry;
                effects.extend(
                    Some(&*known)
                        .filter(|s| s.shown)
                        .map(load)
                        .unwrap_or_default(),
                );
            }
            continue;
        }
        if let Some((at, _)) = needed.iter().find(|(_, text)| *text == entry.text)
            && entry.state == RunStatus::Job(JobState::Done)
        {
            entry.label = at
                .as_ref()
                .map_or_else(String::new, |at| facade::at_label(&line.case, at));
            entry.at.clone_from(at);
            effects.extend(load(&entry));
        }
        line.runs.push(entry);
    }
    effects
}

pub(super) fn read(state: &mut AppState, dir: &Path, run: Result<Arc<Run>, String>) -> Vec<Effect> {
    let Some(line) = state.line_mut() else {
        return Vec::new();
    };
    let mut problem = None;
    if let Some(entry) = line.runs.iter_mut().find(|s| s.dir.as_deref() == Some(dir)) {
        match run {
            Ok(run) => entry.curves = RunCurves::whole(run),
            Err(why) => {
                entry.shown = false;
                entry.state = RunStatus::Unreadable(why.clone());
                problem = Some(why);
            }
        }
    }
    if let Some(why) = problem {
        state.say(Severity::Error, why);
    }
    check(state);
    Vec::new()
}

pub(super) fn deleted(state: &mut AppState, dir: &Path) -> Vec<Effect> {
    if let Some(line) = state.line_mut() {
        line.runs.retain(|s| s.dir.as_deref() != Some(dir));
        line.run = line.run.min(line.runs.len());
        if line.live.kept.as_deref() == Some(dir) {
            line.live.kept = None;
        }
    }
    check(state);
    info(state, format!("Deleted {}.", dir.display()))
}

/// Updates the validation table from the runs of the edited case, and the report where it is seen.
pub(super) fn check(state: &mut AppState) {
    if let Some(document) = &mut state.document {
        document.content.kind_mut().validate(&document.editor);
        if document.pane == PaneId::Report {
            export::make_report(document);
        }
    }
}
