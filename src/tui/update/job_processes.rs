//! Jobs that are processes of their own: they go on when the case is left or the program ends, and are found again.

use std::path::Path;

use super::job_lines::{job_line, process_mut, set_state, slot};
use super::jobs::start_waiting;
use super::{end, runs};
use crate::case::TextDigest;
use crate::jobs::SweepRequest;
use crate::jobs::spec::plain;
use crate::msg::Effect;
use crate::state::job_process::{
    FoundJob, JobProcess, NewProcess, ProcessEffect, ProcessMsg, ProcessWork,
};
use crate::state::sweep_request::SweepEffect;
use crate::state::sweeps::SweepJob;
use crate::state::{
    AppState, JobLine, JobNumber, JobPurpose, JobState, QueuedRequest, RunEntry, RunOrigin,
    RunStatus, Severity,
};
use crate::visible;

/// What is known of the process of a run of the open case, where runs are processes.
pub(super) fn of_entry(state: &AppState, entry: &RunEntry) -> Option<Box<JobProcess>> {
    let directory = state.jobs.processes.as_ref()?;
    let case = &state.editor()?.path;
    Some(Box::new(JobProcess {
        case: plain(directory, case),
        label: entry.label.clone(),
        text: entry.text,
        method: entry.method.clone(),
        duration_s: entry.duration_s,
        ..JobProcess::default()
    }))
}

/// The same of load cases.
pub(super) fn of_sweep(state: &AppState, request: &SweepRequest) -> Option<Box<JobProcess>> {
    let directory = state.jobs.processes.as_ref()?;
    Some(Box::new(JobProcess {
        case: plain(directory, &request.path),
        text: TextDigest::of_text(&request.text),
        ..JobProcess::default()
    }))
}

/// Everything that waits becomes a process: they wait for their turns themselves.
pub(super) fn submit_waiting(state: &mut AppState) -> Vec<Effect> {
    if state.jobs.processes.is_none() {
        return Vec::new();
    }
    let waiting = std::mem::take(&mut state.jobs.waiting);
    let is_process = |queued: &QueuedRequest| {
        let line = state.jobs.lines.iter().find(|l| l.ticket == queued.ticket);
        line.is_some_and(|line| line.process.is_some())
    };
    let (processes, here): (Vec<_>, Vec<_>) = waiting.into_iter().partition(is_process);
    state.jobs.waiting = here.into();
    let submit = |QueuedRequest { ticket, request }| {
        let line = state.jobs.lines.iter().find(|l| l.ticket == ticket)?;
        let process = line.process.as_ref()?;
        let new = NewProcess {
            work: ProcessWork::Run(request),
            name: line.name.clone(),
            label: process.label.clone(),
            case: process.case.clone(),
        };
        let submit = ProcessEffect::Submit(ticket, Box::new(new));
        Some(Effect::Process(submit))
    };
    processes.into_iter().filter_map(submit).collect()
}

/// Starts a process that computes load cases.
pub(super) fn submit_sweep(ticket: JobNumber, name: String, request: SweepRequest) -> Effect {
    let new = NewProcess {
        name,
        label: String::new(),
        case: request.path.clone(),
        work: ProcessWork::Sweep(request),
    };
    Effect::Process(ProcessEffect::Submit(ticket, Box::new(new)))
}

/// Takes what is said of processes.
pub(super) fn told(state: &mut AppState, msg: ProcessMsg) -> Vec<Effect> {
    match msg {
        ProcessMsg::Found(found) => self::found(state, *found),
        ProcessMsg::Gone(host, number) => {
            let is_gone = |process: &JobProcess| {
                process.host.as_ref() == Some(&host) && process.number == Some(number)
            };
            let lines = &mut state.jobs.lines;
            lines.retain(|line| !line.process.as_deref().is_some_and(is_gone));
            state.jobs.cursor = state
                .jobs
                .cursor
                .min(state.jobs.lines.len().saturating_sub(1));
            Vec::new()
        }
        ProcessMsg::Numbered(ticket, number) => {
            if let Some(process) = process_mut(state, ticket) {
                process.number = Some(number);
            }
            Vec::new()
        }
        ProcessMsg::Is(ticket, new) => is(state, ticket, &new),
        ProcessMsg::NotSubmitted(ticket, new, why) => not_submitted(state, ticket, *new, &why),
        ProcessMsg::EndedByLogout(why) => {
            state.jobs.ended_by_logout = Some(why);
            Vec::new()
        }
    }
}

/// A job of an earlier screen, or of another one or another host, joins the list; one that has ended meanwhile is spoken of.
fn found(state: &mut AppState, found: FoundJob) -> Vec<Effect> {
    let of_same = |line: &&mut JobLine| {
        line.process.as_ref().is_some_and(|known| {
            known.number == found.process.number && known.host == found.process.host
        })
    };
    if let Some(line) = state.jobs.lines.iter_mut().find(of_same) {
        line.state = found.state;
        return Vec::new();
    }
    say_found(state, &found);
    let ticket = state.jobs.ticket();
    let purpose = match found.is_sweep {
        true => JobPurpose::Sweep,
        false => JobPurpose::Run,
    };
    let (number, is_open) = (found.process.number, found.state.is_open());
    state.jobs.lines.push(JobLine {
        progress: found.progress,
        process: Some(Box::new(found.process)),
        ..job_line(ticket, found.name, purpose, found.state)
    });
    let Some(number) = number.filter(|_| is_open) else {
        return vec![Effect::RefreshRuns];
    };
    let mut effects = vec![Effect::Process(ProcessEffect::Adopt(ticket, number))];
    effects.extend(show(state));
    effects
}

fn say_found(state: &mut AppState, found: &FoundJob) {
    let name = visible::line(&found.name).into_owned();
    let number = found.process.number.unwrap_or_default();
    let at = found.process.results.as_deref();
    let at = at.map_or_else(String::new, |dir| format!(": {}", visible::path(dir)));
    let (level, words) = match &found.state {
        JobState::Queued | JobState::Running => (
            Severity::Info,
            format!("Job {number}, {name}, goes on from an earlier login."),
        ),
        JobState::Done => (
            Severity::Info,
            format!("Job {number}, {name}, is done{at}."),
        ),
        JobState::Cancelled => (
            Severity::Info,
            format!("Job {number}, {name}, was cancelled{at}."),
        ),
        JobState::Failed(why) => (
            Severity::Warning,
            format!("Job {number}, {name}, failed: {why}"),
        ),
        JobState::Killed(words) => (
            Severity::Warning,
            format!("Job {number}, {name}, ended without a word; {words}{at}."),
        ),
        JobState::Elsewhere(_) => return,
    };
    state.say(level, words);
}

/// Puts the open jobs of the open case where their curves are shown, and asks for these.
pub(super) fn show(state: &mut AppState) -> Vec<Effect> {
    let (Some(directory), Some(path)) = (
        state.jobs.processes.clone(),
        state.editor().map(|editor| editor.path.clone()),
    ) else {
        return Vec::new();
    };
    let lines = state.jobs.lines.iter().filter(|l| l.state.is_open());
    let of_case: Vec<JobLine> = lines
        .filter(|l| {
            l.process
                .as_ref()
                .is_some_and(|p| p.is_of(&directory, &path))
        })
        .cloned()
        .collect();
    let mut effects = Vec::new();
    for line in of_case {
        let joined = match line.purpose {
            JobPurpose::Sweep => show_sweep(state, &line),
            _ => show_run(state, &line),
        };
        if joined {
            let show = ProcessEffect::Show(line.ticket, true);
            effects.push(Effect::Process(show));
        }
    }
    effects
}

fn show_run(state: &mut AppState, line: &JobLine) -> bool {
    if slot(state, line.ticket).is_some() {
        return false;
    }
    let (Some(view), Some(process)) = (state.runs_view_mut(), &line.process) else {
        return false;
    };
    let results = process.results.clone();
    // The index may have been quicker.
    view.runs
        .retain(|run| run.ticket.is_some() || run.dir.is_none() || run.dir != results);
    let name = results.as_deref().and_then(Path::file_name);
    let name = name.map(|name| name.to_string_lossy().into_owned());
    view.runs.extend([RunEntry {
        ticket: Some(line.ticket),
        id: name.unwrap_or_else(|| line.name.clone()),
        label: process.label.clone(),
        duration_s: process.duration_s,
        state: RunStatus::Job(line.state.clone()),
        shown: true,
        dir: results,
        ..RunEntry::session(process.text, process.method.clone())
    }]);
    true
}

fn show_sweep(state: &mut AppState, line: &JobLine) -> bool {
    let Some(view) = state.sweeps_mut().filter(|view| view.job.is_none()) else {
        return false;
    };
    let dir = line.process.as_ref().and_then(|p| p.results.clone());
    if dir.is_some() {
        view.wanted.clone_from(&dir);
    }
    view.job = Some(SweepJob {
        ticket: line.ticket,
        dir,
        ended: 0,
        read: 0,
    });
    true
}

/// The case is left: its jobs go on, and what they record is not asked for.
pub(super) fn hide(state: &AppState) -> Vec<Effect> {
    let lines = state.jobs.lines.iter();
    let open = lines.filter(|l| l.state.is_open() && l.process.is_some());
    let hide = open.map(|l| Effect::Process(ProcessEffect::Show(l.ticket, false)));
    hide.collect()
}

/// A job is so now; one that has ended has no run that is shown.
fn is(state: &mut AppState, ticket: JobNumber, new: &JobState) -> Vec<Effect> {
    let Some(line) = state.jobs.get_mut(ticket).filter(|l| l.state.is_open()) else {
        return Vec::new();
    };
    let name = visible::line(&line.name).into_owned();
    let is_sweep = line.purpose == JobPurpose::Sweep;
    set_state(state, ticket, new.clone());
    match new {
        JobState::Queued | JobState::Running | JobState::Elsewhere(_) => return Vec::new(),
        JobState::Killed(words) => {
            state.say(
                Severity::Error,
                format!("{name} ended without a word; {words}."),
            );
            leave_killed(state, ticket);
        }
        JobState::Failed(why) => state.say(Severity::Error, format!("{name} failed: {why}")),
        JobState::Done => state.say(Severity::Info, format!("{name} is done.")),
        JobState::Cancelled => {}
    }
    if is_sweep
        && let Some(view) = state.sweeps_mut()
        && view.job.as_ref().is_some_and(|job| job.ticket == ticket)
    {
        view.job = None;
        view.reload = view.open.is_some();
    }
    runs::check(state);
    let mut effects = start_waiting(state);
    effects.push(Effect::RefreshRuns);
    effects.extend(end::quit_if_asked(state));
    effects
}

/// A run whose process was killed is as one that is found so: it can be resumed.
fn leave_killed(state: &mut AppState, ticket: JobNumber) {
    if let Some(slot) = slot(state, ticket).filter(|slot| slot.dir.is_some()) {
        slot.ticket = None;
        slot.kind = RunOrigin::Stored;
        slot.state = RunStatus::Partial;
    }
}

/// No process can be started: the job is computed inside this program.
fn not_submitted(
    state: &mut AppState,
    ticket: JobNumber,
    new: NewProcess,
    why: &str,
) -> Vec<Effect> {
    let words = format!(
        "{} is computed inside this screen, and ends with it: {why}.",
        new.name
    );
    state.say(Severity::Warning, words);
    let Some(line) = state.jobs.get_mut(ticket) else {
        return Vec::new();
    };
    line.process = None;
    match new.work {
        ProcessWork::Run(request) => {
            let queued = QueuedRequest { ticket, request };
            state.jobs.waiting.push_back(queued);
            start_waiting(state)
        }
        ProcessWork::Sweep(request) => {
            vec![Effect::Sweep(SweepEffect::Start(ticket, Box::new(request)))]
        }
    }
}
