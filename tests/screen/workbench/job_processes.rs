//! Jobs that are processes of their own, on a screen without any: what is asked of them, and what is shown of them.

use std::path::PathBuf;

use seacable::case::ChannelQuantity;
use seacable::run::job::JobEvent;
use seacable::run::{OutputFrame, Progress, RunState};
use seacable::tui::state::job_process::{
    FoundJob, JobProcess, NewProcess, ProcessEffect, ProcessMsg,
};
use seacable::tui::state::{
    JobNumber, JobPurpose, JobState, Overlay, Question, RunCurves, RunStatus,
};
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{SMALL, has, said, snapshot};

/// The workbench in a directory, with the case `cases/body.toml` open and jobs as processes.
fn desk() -> Desk {
    let mut desk = Desk::with_case(SMALL);
    desk.state.jobs.processes = Some(PathBuf::from("/home/anna"));
    desk
}

fn submitted(desk: &mut Desk) -> Vec<(JobNumber, NewProcess)> {
    let asked = std::mem::take(&mut desk.asked);
    let submitted = asked.into_iter().filter_map(|effect| match effect {
        Effect::Process(ProcessEffect::Submit(ticket, new)) => Some((ticket, *new)),
        _ => None,
    });
    submitted.collect()
}

fn found(number: u64, case: &str, state: JobState) -> Msg {
    let progress = Progress {
        time: 30.0,
        duration: 120.0,
        steps: 300,
        wall_s: 10.0,
        ..Progress::default()
    };
    let found = FoundJob {
        name: "body, alpha".to_owned(),
        is_sweep: false,
        process: JobProcess {
            number: Some(number),
            host: matches!(state, JobState::Elsewhere(_)).then(|| "node7".to_owned()),
            case: PathBuf::from(case),
            duration_s: 120.0,
            results: Some(PathBuf::from(format!("runs/body-{number}"))),
            ..JobProcess::default()
        },
        state,
        progress,
    };
    Msg::Process(ProcessMsg::Found(Box::new(found)))
}

fn is(ticket: JobNumber, state: JobState) -> Msg {
    Msg::Process(ProcessMsg::Is(ticket, state))
}

#[test]
fn every_run_becomes_a_process_and_waits_for_its_turn_itself() {
    let mut desk = desk();
    desk.keys("R R R");
    let submitted = submitted(&mut desk);
    assert_eq!(submitted.len(), 3);
    assert!(desk.state.jobs.waiting.is_empty());
    assert_eq!(
        submitted[0].1.case,
        PathBuf::from("/home/anna/cases/body.toml")
    );
    let (ticket, _) = submitted[0];
    desk.tell(Msg::Process(ProcessMsg::Numbered(ticket, 41)));
    desk.tell(is(ticket, JobState::Running));
    desk.keys("6");
    let screen = desk.screen();
    assert!(screen.contains("41: body, alpha"), "{screen}");
    let runs = |state: &JobState| {
        let lines = desk.state.jobs.lines.iter();
        let of_runs = lines.filter(|l| l.purpose == JobPurpose::Run);
        of_runs.filter(|l| l.state == *state).count()
    };
    assert_eq!((runs(&JobState::Running), runs(&JobState::Queued)), (1, 2));
}

#[test]
fn quitting_leaves_processes_running_or_cancels_them() {
    for (key, cancels, quits) in [
        ("q", 0, true),
        ("enter", 0, true),
        ("x", 2, true),
        ("c", 0, false),
    ] {
        let mut desk = desk();
        desk.keys("R R q");
        assert!(matches!(
            desk.state.overlay,
            Some(Overlay::Ask(Question::JobsGoOn { count: 2, .. }))
        ));
        desk.asked.clear();
        desk.keys(key);
        let cancelled = desk.asked.iter().filter(|e| matches!(e, Effect::Cancel(_)));
        assert_eq!(cancelled.count(), cancels, "{key}");
        assert_eq!(has(&desk, |e| matches!(e, Effect::Quit)), quits, "{key}");
    }
}

#[test]
fn the_question_warns_where_the_system_ends_jobs() {
    let mut desk = desk();
    let why = "logind ends all processes at the logout.".to_owned();
    desk.tell(Msg::Process(ProcessMsg::EndedByLogout(why)));
    desk.keys("R q");
    assert!(
        desk.screen().contains("But logind ends"),
        "{}",
        desk.screen()
    );
}

#[test]
fn a_case_is_left_while_its_processes_run_and_shown_again_with_them() {
    let mut desk = desk();
    desk.keys("R");
    let (ticket, _) = submitted(&mut desk).remove(0);
    desk.tell(is(ticket, JobState::Running));
    desk.keys("b");
    assert!(desk.state.document.is_none());
    let hidden =
        |e: &Effect| matches!(e, Effect::Process(ProcessEffect::Show(t, false)) if *t == ticket);
    assert!(has(&desk, hidden));
    assert!(!has(
        &desk,
        |e| matches!(e, Effect::Cancel(t) if *t == ticket)
    ));
    let again = Desk::opening(SMALL);
    desk.state.document = None;
    let read = again.state.document.unwrap();
    let read = seacable::tui::msg::FileRead::new(
        read.editor.path.clone(),
        read.editor.text.clone(),
        read.content,
        None,
    );
    desk.tell(Msg::FileRead(Box::new(read)));
    let shown =
        |e: &Effect| matches!(e, Effect::Process(ProcessEffect::Show(t, true)) if *t == ticket);
    assert!(has(&desk, shown));
    let runs = desk.state.runs_view().unwrap().runs.all();
    assert_eq!(runs[0].ticket, Some(ticket));
}

#[test]
fn a_job_of_an_earlier_login_is_followed_with_its_curves() {
    let mut desk = desk();
    desk.tell(found(7, "/home/anna/cases/body.toml", JobState::Running));
    assert!(
        said(&desk).contains("Job 7, body, alpha, goes on"),
        "{}",
        said(&desk)
    );
    let ticket = desk.state.jobs.lines.last().unwrap().ticket;
    assert!(has(&desk, |e| {
        matches!(e, Effect::Process(ProcessEffect::Adopt(t, 7)) if *t == ticket)
    }));
    let channels = vec![ChannelQuantity::Z.at("payload")];
    desk.tell(Msg::Job(
        ticket,
        Box::new(JobEvent::Started {
            channels: channels.clone(),
            lines: Vec::new(),
        }),
    ));
    let mut curves = RunCurves::default();
    curves.begin(channels);
    for time in [0.0, 10.0, 40.0] {
        curves.push(&OutputFrame {
            time,
            values: vec![-time],
            shapes: Vec::new(),
            progress: Progress {
                time,
                duration: 120.0,
                steps: 400,
                ..Progress::default()
            },
        });
    }
    desk.tell(Msg::Recorded(ticket, Box::new(curves)));
    let run = desk.state.runs_view().unwrap().runs.all().last().unwrap();
    assert_eq!(run.curves.history().time, [0.0, 10.0, 40.0]);
    // One of another case is followed without.
    desk.tell(found(8, "/home/anna/cases/other.toml", JobState::Queued));
    assert_eq!(desk.state.runs_view().unwrap().runs.len(), 1);
}

#[test]
fn jobs_are_listed_with_what_became_of_them() {
    let mut desk = desk();
    let other = "/home/anna/cases/other.toml";
    let killed = "resumable from t = 30.0 s".to_owned();
    let elsewhere = "running on node7, 30 of 120 s, 2 s ago".to_owned();
    desk.tell(found(3, other, JobState::Running));
    desk.tell(found(4, other, JobState::Done));
    desk.tell(found(5, other, JobState::Killed(killed)));
    desk.tell(found(
        6,
        other,
        JobState::Failed("no equilibrium".to_owned()),
    ));
    desk.tell(found(9, other, JobState::Elsewhere(elsewhere)));
    desk.keys("6");
    snapshot("tui_jobs_of_processes_80x24", &desk);
    // What has become of one on another host since is said in its line.
    desk.tell(found(9, other, JobState::Elsewhere("done".to_owned())));
    desk.keys("G");
    desk.keys("x");
    assert!(said(&desk).contains("another host"), "{}", said(&desk));
    desk.tell(Msg::Process(ProcessMsg::Gone("node7".to_owned(), 9)));
    assert!(!desk.screen().contains("9: body"), "{}", desk.screen());
}

#[test]
fn a_killed_run_is_one_that_can_be_resumed() {
    let mut desk = desk();
    desk.keys("R");
    let (ticket, _) = submitted(&mut desk).remove(0);
    desk.tell(is(ticket, JobState::Running));
    desk.tell(Msg::Stored(ticket, PathBuf::from("runs/body-1")));
    let words = "resumable from t = 30.0 s".to_owned();
    desk.tell(is(ticket, JobState::Killed(words)));
    assert!(
        said(&desk).contains("ended without a word; resumable from t = 30.0 s"),
        "{}",
        said(&desk)
    );
    let runs = desk.state.runs_view().unwrap().runs.all();
    assert_eq!(runs[0].state, RunStatus::Partial);
    desk.keys("3 j c");
    assert!(matches!(desk.state.overlay, Some(Overlay::Prompt { .. })));
}

#[test]
fn what_cannot_be_a_process_is_computed_here() {
    let mut desk = desk();
    desk.keys("R");
    let (ticket, new) = submitted(&mut desk).remove(0);
    let why = "no process can be started: out of memory".to_owned();
    desk.tell(Msg::Process(ProcessMsg::NotSubmitted(
        ticket,
        Box::new(new),
        why,
    )));
    assert!(has(&desk, |e| {
        matches!(e, Effect::Start { ticket: t, store: true, .. } if *t == ticket)
    }));
    assert!(
        said(&desk).contains("inside this screen"),
        "{}",
        said(&desk)
    );
    desk.keys("q");
    assert!(matches!(
        desk.state.overlay,
        Some(Overlay::Ask(Question::JobsRunning))
    ));
}

#[test]
fn a_process_that_ends_with_its_run_is_as_any_run() {
    let mut desk = desk();
    desk.keys("R");
    let (ticket, new) = submitted(&mut desk).remove(0);
    let seacable::tui::state::job_process::ProcessWork::Run(request) = new.work else {
        panic!("a run was asked for");
    };
    let seacable::jobs::JobRequest::Line(request, None) = request else {
        panic!("of a line");
    };
    let run = super::desk::run(&request, RunState::Done);
    desk.tell(Msg::Job(
        ticket,
        Box::new(JobEvent::Finished(Box::new(run))),
    ));
    assert!(said(&desk).contains("is done"), "{}", said(&desk));
    desk.keys("q");
    assert!(has(&desk, |e| matches!(e, Effect::Quit)));
}
