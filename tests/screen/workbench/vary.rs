//! Ranges typed into a field, and the runs they make.

use seacable::tui::pane::PaneId;
use seacable::tui::state::{JobState, Overlay, Question, RunStatus};

use super::desk::Desk;
use super::{SMALL, said, snapshot};

/// The current speed being edited, with a text typed over its value.
fn typing(text: &str) -> Desk {
    let mut desk = Desk::with_case(SMALL);
    begin(&mut desk, text);
    desk
}

fn begin(desk: &mut Desk, text: &str) {
    desk.keys("1 /");
    desk.keys("ctrl+u");
    desk.type_text("current speed");
    desk.keys("enter enter ctrl+u");
    desk.type_text(text);
}

#[test]
fn a_range_in_a_field_runs_the_case_at_each_value() {
    let mut desk = typing("0.2..0.8/4");
    snapshot("tui_range_typed_80x24", &desk);
    desk.state.jobs.limit = 8;
    desk.keys("enter");
    assert!(said(&desk).starts_with("4 runs begun over current.speed_m_per_s."));
    assert!(!desk.state.editor().unwrap().unsaved());
    let started = desk.started();
    let overrides: Vec<&str> = started
        .iter()
        .map(|(_, request)| request.overrides[0].as_str())
        .collect();
    assert_eq!(
        overrides,
        ["0.2", "0.4", "0.6", "0.8"].map(|v| format!("current.speed_m_per_s={v}"))
    );
    assert!(started[3].1.text.contains("speed_m_per_s = 0.8"));
    assert_eq!(started[3].1.id, "body");
    assert_eq!(desk.state.focus(), PaneId::Runs);
    snapshot("tui_range_runs_80x24", &desk);
    let line = desk.state.line().unwrap();
    assert_eq!(line.runs.on_charts().count(), 4);
    assert!(line.live.hidden);
}

#[test]
fn runs_that_are_there_are_shown_again() {
    let mut desk = typing("0.2, 0.4");
    desk.keys("enter");
    desk.finish_jobs();
    begin(&mut desk, "0.4, 0.6 m/s");
    desk.keys("enter");
    assert!(said(&desk).starts_with("1 run begun over current.speed_m_per_s; 1 there already."));
    desk.finish_jobs();
    let line = desk.state.line().unwrap();
    let done = |run: &&_| state_of(run) == RunStatus::Job(JobState::Done);
    assert_eq!(line.runs.all().iter().filter(done).count(), 3);
    assert_eq!(line.runs.on_charts().count(), 2);
    begin(&mut desk, "0.4, 0.6");
    desk.keys("enter");
    assert!(said(&desk).contains("are there already"), "{}", said(&desk));
}

fn state_of(run: &seacable::tui::state::RunEntry) -> RunStatus {
    run.state.clone()
}

#[test]
fn a_second_key_behind_the_range_makes_a_grid() {
    let mut desk = typing("0.2, 0.4 x solver.duration_s=300..600/3");
    assert!(desk.screen().contains("6 runs: 0.2, 0.4 m/s x solver."));
    desk.keys("enter");
    let said = said(&desk).to_owned();
    assert!(
        said.starts_with("6 runs begun over current.speed_m_per_s and solver.duration_s."),
        "{said}"
    );
}

#[test]
fn what_is_no_range_is_refused_with_its_reason() {
    for (text, why) in [
        ("0.2..0.8", "lacks the number of values"),
        ("0.2..99/3", "49.6 m/s is out of range"),
        ("0.2, fast", "`fast` is no number"),
        ("0.2, 0.4 x payload", "gives no values"),
        ("0.1..0.9/5000", "more than 2000"),
        // A decimal comma is answered as before.
        ("0,5", "0.5"),
    ] {
        let mut desk = typing(text);
        desk.keys("enter");
        let editor = desk.state.editor().unwrap();
        let problem = editor.editing.as_ref().and_then(|e| e.problem.clone());
        let problem = problem.unwrap_or_default();
        assert!(problem.contains(why), "{text}: {problem}");
        assert!(desk.started().is_empty());
    }
}

#[test]
fn many_runs_are_asked_about_first() {
    let mut desk = typing("0.2..0.8/201");
    desk.keys("enter");
    let asked = |desk: &Desk| {
        matches!(
            desk.state.overlay,
            Some(Overlay::Ask(Question::ManyRuns { count: 201 }))
        )
    };
    assert!(asked(&desk));
    // The range stays to be edited.
    desk.keys("c");
    assert!(desk.state.editor().unwrap().editing.is_some());
    assert!(desk.started().is_empty());
    desk.keys("enter r");
    assert!(said(&desk).starts_with("201 runs begun"));
}
