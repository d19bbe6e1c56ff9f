//! The runs of the open case.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{export, info, moved};
use crate::run::{Run, RunState};
use crate::tui::command::Id;
use crate::tui::facade;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::{
    AppState, Curves, Level, OpenCase, Overlay, Question, RunEntry, RunOrigin, RunStatus, Ticket,
};

pub(super) fn command(state: &mut AppState, id: Id) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    match id {
        Id::Keep => {
            let run = open.live.done.as_ref().and_then(|d| d.run.clone());
            run.map(Effect::KeepRun).into_iter().collect()
        }
        Id::ShowAlone => show_alone(state),
        Id::Select => select(open),
        Id::SelectNone => {
            open.runs.iter_mut().for_each(|slot| slot.shown = false);
            open.live.hidden = false;
            Vec::new()
        }
        Id::Delete => {
            if let Some(slot) = open.current_run()
                && let Some(dir) = slot.dir.clone()
            {
                let id = slot.id.clone();
                state.overlay = Some(Overlay::Ask(Question::DeleteRun { dir, id }));
            }
            Vec::new()
        }
        _ => Vec::new(),
    }
}

fn show_alone(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let at = open.run;
    open.live.hidden = at > 0;
    for (i, slot) in open.runs.iter_mut().enumerate() {
        slot.shown = i + 1 == at;
    }
    let name = open
        .current_run()
        .map_or_else(|| "the live run".to_owned(), |r| r.id.clone());
    let effects = at
        .checked_sub(1)
        .and_then(|i| open.runs.get(i))
        .map_or_else(Vec::new, load);
    info(state, format!("Charts and report now show {name}."));
    effects
}

fn select(open: &mut OpenCase) -> Vec<Effect> {
    let effects = match open.run.checked_sub(1).and_then(|i| open.runs.get_mut(i)) {
        Some(slot) => {
            slot.shown = !slot.shown;
            if slot.shown { load(slot) } else { Vec::new() }
        }
        None => {
            open.live.hidden = !open.live.hidden;
            Vec::new()
        }
    };
    open.run = moved(open.run, 1, open.runs.len() + 1);
    effects
}

/// Reads a stored run when it is needed for the first time.
pub(super) fn load(slot: &RunEntry) -> Vec<Effect> {
    let missing = slot.kind == RunOrigin::Stored && slot.curves.run.is_none();
    slot.dir
        .iter()
        .filter(|_| missing)
        .map(|dir| Effect::ReadRun(dir.clone()))
        .collect()
}

pub(super) fn stored(state: &mut AppState, ticket: Ticket, dir: PathBuf) -> Vec<Effect> {
    if let Some(open) = &mut state.open
        && let Some(slot) = open.runs.iter_mut().find(|s| s.ticket == Some(ticket))
    {
        if let Some(name) = dir.file_name() {
            slot.id = name.to_string_lossy().into_owned();
        }
        slot.dir = Some(dir);
    }
    Vec::new()
}

pub(super) fn kept(state: &mut AppState, dir: &Path, run: Arc<Run>) -> Vec<Effect> {
    if let Some(open) = &mut state.open {
        let mut slot = slot_of(&run);
        if let Some(name) = dir.file_name() {
            slot.id = name.to_string_lossy().into_owned();
        }
        slot.dir = Some(dir.to_owned());
        slot.curves = Curves::whole(run);
        open.runs.push(slot);
        open.live.kept = Some(dir.to_owned());
    }
    info(state, format!("Kept in {}.", dir.display()))
}

/// A stored run for the list, without its curves.
#[must_use]
fn slot_of(run: &Run) -> RunEntry {
    RunEntry {
        ticket: None,
        id: run.info.id.clone(),
        label: String::new(),
        at: None,
        text: run.case_text.clone(),
        kind: RunOrigin::Stored,
        state: match run.info.state {
            RunState::Done => RunStatus::Done,
            RunState::Partial => RunStatus::Partial,
            RunState::Cancelled => RunStatus::Cancelled,
            RunState::Failed => RunStatus::Failed(run.info.failure.clone().unwrap_or_default()),
        },
        method: run.info.settings.method.clone(),
        dir: None,
        cost: Some((run.info.work.steps, run.info.cost.cpu_s)),
        shown: false,
        curves: Curves::default(),
    }
}

/// Asks for the stored runs of a case, and of those beside it.
pub(super) fn list(open: &OpenCase) -> Effect {
    let mut files = vec![open.editor.file.clone()];
    files.extend(open.case.case.beside.iter().flatten().cloned());
    Effect::ListRuns(files)
}

/// Stored runs join the list; those that the validation table needs are read.
pub(super) fn listed(state: &mut AppState, slots: Vec<RunEntry>) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let needed: Vec<_> = facade::plan(&open.case)
        .into_iter()
        .filter_map(|at| {
            let found = facade::variant(
                &open.editor.text,
                &open.case,
                at.as_ref(),
                &open.editor.file,
            );
            Some((at, found.ok()?.0))
        })
        .collect();
    let mut effects = Vec::new();
    for mut slot in slots {
        let same = |s: &&mut RunEntry| s.dir.is_some() && s.dir == slot.dir;
        if let Some(known) = open.runs.iter_mut().find(same) {
            if known.state != slot.state && known.kind == RunOrigin::Stored {
                slot.shown = known.shown;
                slot.at = known.at.take();
                slot.label = std::mem::take(&mut known.label);
                *known = slot;
                effects.extend(
                    Some(&*known)
                        .filter(|s| s.shown)
                        .map(load)
                        .unwrap_or_default(),
                );
            }
            continue;
        }
        if let Some((at, _)) = needed.iter().find(|(_, text)| *text == slot.text)
            && slot.state == RunStatus::Done
        {
            slot.label = at
                .as_ref()
                .map_or_else(String::new, |at| facade::at_label(&open.case, at));
            slot.at.clone_from(at);
            effects.extend(load(&slot));
        }
        open.runs.push(slot);
    }
    effects
}

pub(super) fn read(state: &mut AppState, dir: &Path, run: Result<Arc<Run>, String>) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let mut problem = None;
    if let Some(slot) = open.runs.iter_mut().find(|s| s.dir.as_deref() == Some(dir)) {
        match run {
            Ok(run) => slot.curves = Curves::whole(run),
            Err(why) => {
                slot.shown = false;
                slot.state = RunStatus::Unreadable(why.clone());
                problem = Some(why);
            }
        }
    }
    if let Some(why) = problem {
        state.say(Level::Error, why);
    }
    check(state);
    Vec::new()
}

pub(super) fn deleted(state: &mut AppState, dir: &Path) -> Vec<Effect> {
    if let Some(open) = &mut state.open {
        open.runs.retain(|s| s.dir.as_deref() != Some(dir));
        open.run = open.run.min(open.runs.len());
        if open.live.kept.as_deref() == Some(dir) {
            open.live.kept = None;
        }
    }
    check(state);
    info(state, format!("Deleted {}.", dir.display()))
}

/// Makes the validation table anew from the runs that answer for the case as it stands.
pub(super) fn check(state: &mut AppState) {
    let Some(open) = &mut state.open else {
        return;
    };
    let variants: Vec<_> = facade::plan(&open.case)
        .into_iter()
        .filter_map(|at| {
            let (text, _) = facade::variant(
                &open.editor.text,
                &open.case,
                at.as_ref(),
                &open.editor.file,
            )
            .ok()?;
            let run = answering(open, &text)?;
            Some((at, run))
        })
        .collect();
    open.checks = facade::checks(&open.case, &variants);
    if open.pane == PaneId::Report {
        export::write_report(state);
    }
}

/// The newest complete run of exactly this text.
fn answering(open: &OpenCase, text: &str) -> Option<Arc<Run>> {
    let done = |run: &&Arc<Run>| run.info.state == RunState::Done;
    let live = open
        .live
        .done
        .as_ref()
        .filter(|_| open.live.done_text == text);
    let slots = open.runs.iter().rev().filter(|s| s.text == text);
    slots
        .map(|s| &s.curves)
        .chain(live)
        .filter_map(|c| c.run.as_ref())
        .find(done)
        .cloned()
}

/// The run that the report is about: the one under the cursor of the list, else the live one.
pub(in crate::tui) fn reported(open: &OpenCase) -> Option<(String, Arc<Run>, Option<PathBuf>)> {
    if let Some(slot) = open.current_run()
        && let Some(run) = &slot.curves.run
    {
        return Some((slot.id.clone(), Arc::clone(run), slot.dir.clone()));
    }
    let run = open.live.done.as_ref()?.run.clone()?;
    Some(("live".to_owned(), run, open.live.kept.clone()))
}
