//! Sweeps of what is open: begun, followed, read where they are seen.

use std::path::{Path, PathBuf};

use super::job_lines::job_line;
use super::notice::{info, warn};
use super::{job_lines, job_processes, jobs};
use crate::kinds::FileType;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::state::sweep_request::{SweepEffect, SweepMsg, SweepRequest};
use crate::state::sweeps::{OpenSweep, SweepComparison, SweepJob, SweepRead, SweepTab, SweepsView};
use crate::state::{AppState, JobLine, JobNumber, JobPurpose, JobState, Severity};
use crate::study::sweep::{SweepEntry, SweepProgress};
use crate::view::layout;
use crate::visible;

/// Asks for the stored sweeps of what is open.
pub(super) fn list(state: &AppState) -> Option<Effect> {
    let document = state.document.as_ref()?;
    document.sweeps()?;
    let file = document.editor.file.clone();
    Some(Effect::Sweep(SweepEffect::List(file)))
}

/// Computes the load cases of the edited text in the background.
pub(super) fn start(state: &mut AppState) -> Vec<Effect> {
    let Some(request) = request(state) else {
        return Vec::new();
    };
    let ticket = state.jobs.ticket();
    let file = request
        .path
        .file_name()
        .unwrap_or_default()
        .to_string_lossy();
    let name = format!("load cases of {file}");
    let process = job_processes::of_sweep(state, &request);
    let is_process = process.is_some();
    state.jobs.lines.push(JobLine {
        process,
        ..job_line(ticket, name.clone(), JobPurpose::Sweep, JobState::Running)
    });
    if let Some(view) = state.sweeps_mut() {
        view.job = Some(SweepJob {
            ticket,
            dir: None,
            ended: 0,
            read: 0,
        });
        view.failure = None;
    }
    go(state);
    info(
        state,
        format!(
            "The load cases are computed; runs are stored under runs/. `{}` shows the jobs, `ctrl+c` cancels.",
            state.number_of(PaneId::Jobs)
        ),
    );
    match is_process {
        true => vec![job_processes::submit_sweep(ticket, name, request)],
        false => vec![Effect::Sweep(SweepEffect::Start(ticket, Box::new(request)))],
    }
}

/// Shows the pane of the sweeps.
pub(super) fn go(state: &mut AppState) {
    if state.number_of(PaneId::Sweep) > 0
        && let Some(document) = &mut state.document
    {
        document.pane = PaneId::Sweep;
    }
}

fn request(state: &AppState) -> Option<SweepRequest> {
    let document = state.document.as_ref()?;
    let editor = &document.editor;
    let kind = document.content.file_type();
    matches!(kind, FileType::Line | FileType::System).then(|| SweepRequest {
        kind,
        text: editor.text.clone(),
        path: editor.path.clone(),
        overrides: jobs::overrides(editor),
    })
}

/// Takes what the threads behind the screen say of sweeps.
pub(super) fn told(state: &mut AppState, msg: SweepMsg) -> Vec<Effect> {
    match msg {
        SweepMsg::Listed(file, stored) => listed(state, &file, stored),
        SweepMsg::Read(dir, read) => took(state, &dir, read),
        SweepMsg::Checked(dir, verdict) => {
            if let Some(view) = state.sweeps_mut() {
                view.checking = false;
                if let Some(open) = view.open.as_mut().filter(|open| open.snapshot.dir == dir) {
                    open.verdict = Some(verdict);
                    open.arrange();
                }
            }
            Vec::new()
        }
        SweepMsg::Compared(dir, text, is_same) => {
            if let Some(view) = state.sweeps_mut() {
                view.comparison = SweepComparison {
                    of: Some((dir, text)),
                    is_same,
                    is_open: false,
                };
            }
            Vec::new()
        }
        SweepMsg::Begun(ticket, dir) => begun(state, ticket, dir),
        SweepMsg::Progress(ticket, progress, seconds) => {
            went_on(state, ticket, progress, seconds);
            Vec::new()
        }
        SweepMsg::Ended(ticket, ended) => self::ended(state, ticket, ended),
    }
}

fn listed(state: &mut AppState, file: &str, stored: Vec<SweepEntry>) -> Vec<Effect> {
    if state.editor().is_some_and(|editor| editor.file == file)
        && let Some(view) = state.sweeps_mut()
    {
        view.take(stored);
    }
    Vec::new()
}

/// A sweep is read, or cannot be.
fn took(state: &mut AppState, dir: &Path, read: Result<SweepRead, String>) -> Vec<Effect> {
    let Some(view) = state.sweeps_mut() else {
        return Vec::new();
    };
    if view.reading.as_deref() == Some(dir) {
        view.reading = None;
    }
    if view.wanted.as_deref() != Some(dir) {
        return Vec::new();
    }
    match read {
        Ok(read) => show(view, read),
        Err(why) => {
            view.open = None;
            view.failure = Some(why);
        }
    }
    Vec::new()
}

fn show(view: &mut SweepsView, read: SweepRead) {
    view.failure = None;
    match &mut view.open {
        Some(open) if open.snapshot.dir == read.snapshot.dir => open.renew(read),
        open => *open = Some(OpenSweep::new(read)),
    }
}

fn begun(state: &mut AppState, ticket: JobNumber, dir: PathBuf) -> Vec<Effect> {
    job_lines::has_results(state, ticket, &dir);
    if let Some(view) = state.sweeps_mut()
        && let Some(job) = view.job.as_mut().filter(|job| job.ticket == ticket)
    {
        job.dir = Some(dir.clone());
        // The folder is there before the list of them says so.
        view.wanted = Some(dir);
    }
    list(state).into_iter().collect()
}

fn went_on(state: &mut AppState, ticket: JobNumber, progress: SweepProgress, seconds: f64) {
    let SweepProgress { done, stored, of } = progress;
    if let Some(line) = state.jobs.get_mut(ticket) {
        line.progress.steps = done as u64;
        line.progress.time = (done - stored) as f64;
        line.progress.duration = (of - stored) as f64;
        line.progress.wall_s = seconds;
    }
    if let Some(view) = state.sweeps_mut()
        && let Some(job) = view.job.as_mut().filter(|job| job.ticket == ticket)
    {
        job.ended = done;
    }
}

fn ended(
    state: &mut AppState,
    ticket: JobNumber,
    ended: Result<(SweepRead, bool), String>,
) -> Vec<Effect> {
    let is_open = state
        .jobs
        .get_mut(ticket)
        .is_some_and(|line| line.state.is_open());
    let new = match &ended {
        Ok((_, false)) => JobState::Done,
        Ok((_, true)) => JobState::Cancelled,
        Err(why) => JobState::Failed(why.clone()),
    };
    job_lines::set_state(state, ticket, new);
    let view = state.sweeps_mut().filter(|view| {
        let job = view.job.as_ref();
        job.is_some_and(|job| job.ticket == ticket)
    });
    let Some(view) = view else {
        return Vec::new();
    };
    view.job = None;
    match ended {
        Ok((read, cancelled)) => {
            let words = outcome(&read, cancelled);
            if view.wanted.as_ref() == Some(&read.snapshot.dir) {
                show(view, read);
            }
            info(state, words);
        }
        Err(why) => {
            view.reload = view.open.is_some();
            if view.open.is_none() {
                view.failure = Some(why.clone());
            }
            if is_open {
                state.say(Severity::Error, format!("The load cases: {why}"));
            }
        }
    }
    let mut effects = vec![Effect::RefreshRuns];
    effects.extend(list(state));
    effects.extend(super::end::quit_if_asked(state));
    effects
}

/// What became of a sweep, in words.
fn outcome(read: &SweepRead, cancelled: bool) -> String {
    let (done, of) = (read.table.done(), read.table.states.len());
    let dir = visible::path(&read.snapshot.dir);
    match (cancelled, read.table.failed()) {
        (true, _) => {
            format!("Stopped with {done} of {of} load cases done in {dir}; `:start_sweep` goes on.")
        }
        (false, 0) => format!("{done} of {of} load cases are done: {dir}."),
        (false, failed) => {
            format!("{done} of {of} load cases are done, {failed} without results: {dir}.")
        }
    }
}

/// Shows the stored sweep so many places further on.
pub fn turn(state: &mut AppState, by: isize) -> Vec<Effect> {
    let Some(view) = state.sweeps_mut() else {
        return Vec::new();
    };
    let count = view.stored.len();
    if count == 0 {
        return warn(
            state,
            "No sweep of this file is stored; `:start_sweep` computes its load cases.",
        );
    }
    let place = view.place().unwrap_or(0) as isize + by;
    let place = place.rem_euclid(count as isize) as usize;
    view.wanted = Some(view.stored[place].dir.clone());
    view.failure = None;
    let words = format!(
        "Sweep {} of {count}: {}.",
        place + 1,
        visible::path(&view.stored[place].dir)
    );
    info(state, words)
}

/// Asks for what is seen of sweeps and not known: the sweep itself, and what its load cases say together.
pub(super) fn follow(state: &mut AppState) -> Vec<Effect> {
    if !layout::seen(state).contains(&PaneId::Sweep) {
        return Vec::new();
    }
    let judged_anyway = layout::shows_verdict(state);
    let Some(view) = state.sweeps_mut() else {
        return Vec::new();
    };
    let read = ask_to_read(view);
    let check = ask_to_check(view, judged_anyway);
    let asked = read.into_iter().chain(check).chain(ask_to_compare(state));
    asked.map(Effect::Sweep).collect()
}

/// Asks whether the sweep that is shown is of the text as it is.
fn ask_to_compare(state: &mut AppState) -> Option<SweepEffect> {
    let document = state.document.as_ref()?;
    let view = document.sweeps()?;
    let snapshot = view.open.as_ref()?.snapshot.clone();
    let known = &view.comparison;
    if known.is_open || known.is_of(&snapshot.dir, &document.editor.text) {
        return None;
    }
    let request = request(state)?;
    state.sweeps_mut()?.comparison.is_open = true;
    Some(SweepEffect::Compare(snapshot, Box::new(request)))
}

fn ask_to_read(view: &mut SweepsView) -> Option<SweepEffect> {
    let dir = view.wanted.clone()?;
    if view.reading.is_some() {
        return None;
    }
    let open = view.open.as_ref().filter(|open| open.snapshot.dir == dir);
    let known = open.map(|open| open.snapshot.clone());
    let job = view
        .job
        .as_mut()
        .filter(|job| job.dir.as_ref() == Some(&dir));
    let has_gone_on = job.as_ref().is_some_and(|job| job.ended > job.read);
    let is_asked = std::mem::take(&mut view.reload);
    let is_known = known.is_some() || view.failure.is_some();
    if is_known && !has_gone_on && !is_asked {
        return None;
    }
    if let Some(job) = job {
        job.read = job.ended;
    }
    view.reading = Some(dir.clone());
    Some(SweepEffect::Read { dir, known })
}

/// Records are long: while the load cases are computed they are read again only when a quarter more of them is done.
fn ask_to_check(view: &mut SweepsView, anyway: bool) -> Option<SweepEffect> {
    let open = view.open.as_ref()?;
    let is_seen = matches!(view.tab, SweepTab::Checks | SweepTab::Seas);
    let is_seen = is_seen || anyway || view.wants_verdict;
    if view.checking || !(is_seen || open.verdict.is_some()) {
        return None;
    }
    let done = open.table.done();
    let computing = view.is_computing(&open.snapshot.dir);
    let is_old = match &open.verdict {
        None => true,
        Some(verdict) if computing => done >= verdict.done + (verdict.done / 4).max(1),
        Some(verdict) => done != verdict.done,
    };
    if !is_old {
        return None;
    }
    let snapshot = open.snapshot.clone();
    view.checking = true;
    Some(SweepEffect::Check(snapshot))
}

/// Reads the sweep that is shown anew: another program may compute it.
pub fn reload(state: &mut AppState) -> Vec<Effect> {
    if let Some(view) = state.sweeps_mut() {
        view.reload = true;
        view.failure = None;
    }
    list(state).into_iter().collect()
}

/// Shows the next view.
pub fn turn_tab(state: &mut AppState, by: usize) {
    if let Some(view) = state.sweeps_mut() {
        view.tab = view.tab.turned(by);
        if let Some(open) = &mut view.open {
            open.cell = None;
        }
    }
}
