//! The runs of the open case.

use crate::{facade, visible};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::job_lines;
use super::motion::moved;
use super::notice::info;
use crate::case::{ChannelQuantity, TextDigest};
use crate::msg::{Effect, RunsFound};
use crate::run::Run;
use crate::run::index::SyncProgress;
use crate::state::line::PlannedWork;
use crate::state::{
    AppState, Document, DocumentContent, JobNumber, JobState, RunCurves, RunEntry, RunOrigin,
    RunStatus, RunsView, Severity, VariantPlan,
};
use crate::study::results::main_results;
use crate::system::network::Network;

/// Stores the live run.
pub(super) fn keep(state: &AppState) -> Vec<Effect> {
    let done = state.runs_view().and_then(|view| view.live.done.as_ref());
    let run = done.and_then(|done| done.run.clone());
    run.map(Effect::KeepRun).into_iter().collect()
}

/// Shows the run under the cursor alone.
pub fn show_alone(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    view.hide_runs();
    let mut effects = Vec::new();
    let name = match view.runs.current_mut() {
        Some(entry) => {
            entry.shown = true;
            effects = load(entry);
            entry.title()
        }
        None => {
            view.live.hidden = false;
            "the live run".to_owned()
        }
    };
    view.runs.arrange();
    info(state, format!("Charts and report now show {name}."));
    effects
}

/// Shows the run under the cursor beside the others, or takes it off.
pub fn select(view: &mut RunsView) -> Vec<Effect> {
    let mut effects = Vec::new();
    match view.runs.current_mut() {
        Some(entry) => {
            entry.shown = !entry.shown;
            if entry.shown {
                effects = load(entry);
            }
        }
        None => view.live.hidden = !view.live.hidden,
    }
    view.runs.arrange();
    view.runs.cursor = moved(view.runs.cursor, 1, view.runs.lines());
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
    job_lines::has_results(state, ticket, &dir);
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    // The index may have been quicker.
    view.runs
        .retain(|run| run.ticket.is_some() || run.dir.as_ref() != Some(&dir));
    if let Some(entry) = view.runs.newest_mut(|run| run.ticket == Some(ticket)) {
        if let Some(name) = dir.file_name() {
            entry.id = name.to_string_lossy().into_owned();
        }
        entry.dir = Some(dir);
    }
    view.runs.arrange();
    vec![Effect::RefreshRuns]
}

pub(super) fn kept(state: &mut AppState, dir: &Path, run: Arc<Run>) -> Vec<Effect> {
    if let Some(view) = state.runs_view_mut() {
        view.live.kept = Some(dir.to_owned());
        let info = &run.info;
        let mut entry = RunEntry::session(
            TextDigest::of_text(&run.case_text),
            info.settings.method.clone(),
        );
        if let Some(name) = dir.file_name() {
            entry.id = name.to_string_lossy().into_owned();
        }
        entry.state = RunStatus::Job(JobState::Done);
        entry.cost = Some((info.work.steps, info.cost.cpu_s));
        entry.started.clone_from(&info.started);
        entry.duration_s = info.settings.duration_s;
        entry.label = info.overrides.join(", ");
        entry.kind = RunOrigin::Stored;
        entry.dir = Some(dir.to_owned());
        entry.curves = RunCurves::whole(run);
        view.runs.extend([entry]);
    }
    info(state, format!("Kept in {}.", visible::path(dir)));
    vec![Effect::RefreshRuns]
}

/// Asks for the stored runs of what is open, and of those beside it.
pub(super) fn list(state: &AppState) -> Option<Effect> {
    let document = state.document.as_ref()?;
    let mut files = vec![document.editor.file.clone()];
    let results = match &document.content {
        DocumentContent::Line(line) => {
            files.extend(line.case.case.beside.iter().flatten().cloned());
            let main = main_results(&line.case);
            main.iter().map(ToString::to_string).collect()
        }
        DocumentContent::System(system) if system.has_runs() => {
            let beside = system.solved.file.about.beside.iter();
            files.extend(beside.flatten().cloned());
            main_channels(&system.solved.network)
        }
        _ => return None,
    };
    Some(Effect::ListRuns { files, results })
}

/// The results of a system that the table of runs shows: the greatest tensions at both ends of its first lines.
fn main_channels(network: &Network) -> Vec<String> {
    const LINES: usize = 3;
    let lines = network.lines.iter().take(LINES);
    let both = lines.flat_map(|line| ["a", "b"].map(|end| format!("{}|{end}", line.name)));
    both.map(|place| format!("{}.max", ChannelQuantity::Tension.at(place)))
        .collect()
}

/// What the index says: stored runs join the list, change or leave it; those that the validation table needs are read.
pub(super) fn listed(state: &mut AppState, found: RunsFound) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let runs = &mut view.runs;
    if let Some(columns) = found.columns {
        runs.take_columns(columns);
    }
    if found.whole {
        runs.indexing = None;
    }
    let mut effects = Vec::new();
    let mut new = Vec::new();
    for entry in found.changed {
        match entry.dir.as_deref().and_then(|dir| runs.in_dir_mut(dir)) {
            Some(known) => {
                known.renew(entry);
                if known.shown {
                    effects.extend(load(known));
                }
            }
            None => new.push(entry),
        }
    }
    runs.extend(new);
    // Runs of this session are in the list before they are in the index.
    runs.retain(|run| {
        run.number
            .is_none_or(|number| found.all.binary_search(&number).is_ok())
    });
    effects.extend(load_needed(state));
    check(state);
    effects
}

/// How far the index is.
pub(super) fn indexing(state: &mut AppState, progress: SyncProgress) -> Vec<Effect> {
    if let Some(view) = state.runs_view_mut() {
        view.runs.indexing = (progress.done < progress.all).then_some(progress);
    }
    Vec::new()
}

/// Names the runs that the validation table needs by their points, and reads them.
pub(super) fn load_needed(state: &mut AppState) -> Vec<Effect> {
    let document = state.document.as_mut();
    let Some((line, editor)) = document.and_then(Document::line_and_editor) else {
        return Vec::new();
    };
    if line.plan.text != editor.text {
        return Vec::new();
    }
    let mut effects = Vec::new();
    for variant in line.plan.of_published_values() {
        let done = RunStatus::Job(JobState::Done);
        let of = |run: &RunEntry| run.text == variant.digest && run.state == done;
        if let Some(run) = line.runs_view.runs.newest_mut(of) {
            if let Some(at) = &variant.at {
                run.label = facade::at_label(&line.case, at);
            }
            run.at.clone_from(&variant.at);
            effects.extend(load(run));
        }
    }
    effects
}

/// Asks for the variants of the text as it is, one text after the other.
pub(super) fn plan(state: &mut AppState) -> Option<Effect> {
    let document = state.document.as_mut()?;
    let (line, editor) = document.line_and_editor()?;
    if line.planning || line.plan.text == editor.text {
        return None;
    }
    line.planning = true;
    Some(Effect::Plan {
        case: Box::new(line.case.clone()),
        text: editor.text.clone(),
        file: editor.file.clone(),
    })
}

/// The variants are there: what waited for them goes on.
pub(super) fn planned(state: &mut AppState, plan: VariantPlan) -> Vec<Effect> {
    let document = state.document.as_mut();
    let Some((line, editor)) = document.and_then(Document::line_and_editor) else {
        return Vec::new();
    };
    line.planning = false;
    line.plan = plan;
    if line.plan.text != editor.text {
        return Vec::new();
    }
    let waiting = line.planned.take();
    let mut effects = load_needed(state);
    check(state);
    effects.extend(match waiting {
        Some(PlannedWork::Study(index)) => super::studies::study(state, index),
        Some(PlannedWork::Validate) => super::studies::validate(state),
        None => Vec::new(),
    });
    effects
}

pub(super) fn read(state: &mut AppState, dir: &Path, run: Result<Arc<Run>, String>) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let mut problem = None;
    if let Some(entry) = view.runs.in_dir_mut(dir) {
        match run {
            Ok(run) => entry.curves = RunCurves::whole(run),
            Err(why) => {
                entry.shown = false;
                entry.state = RunStatus::Unreadable(why.clone());
                problem = Some(why);
            }
        }
    }
    view.runs.arrange();
    if view.hold.as_deref() == Some(dir)
        && let Some(entry) = view.runs.in_dir(dir)
        && let Some(run) = entry.curves.run.clone()
    {
        view.against = Some((entry.title(), run));
        view.hold = None;
    }
    if let Some(why) = problem {
        state.say(Severity::Error, why);
    }
    check(state);
    Vec::new()
}

pub(super) fn deleted(state: &mut AppState, dirs: &[PathBuf]) -> Vec<Effect> {
    let (Some(view), false) = (state.runs_view_mut(), dirs.is_empty()) else {
        return Vec::new();
    };
    let gone = |dir: &Option<PathBuf>| dir.as_ref().is_some_and(|dir| dirs.contains(dir));
    view.runs.retain(|run| !gone(&run.dir));
    if gone(&view.live.kept) {
        view.live.kept = None;
    }
    check(state);
    let words = match dirs {
        [dir] => format!("Deleted {}.", visible::path(dir)),
        _ => format!("Deleted {} runs.", dirs.len()),
    };
    info(state, words);
    vec![Effect::RefreshRuns]
}

/// The validation table has to be made anew from the runs of the edited case.
pub(super) fn check(state: &mut AppState) {
    if let Some(document) = &mut state.document {
        document.outdate_checks();
    }
}
