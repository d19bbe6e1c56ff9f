//! Ranges typed into a field, and the runs they make.

use seacable::tui::Effect;
use seacable::tui::pane::PaneId;
use seacable::tui::state::{JobState, KeptRange, Overlay, Question, RunStatus};

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
    assert_eq!(line.runs_view.runs.on_charts().count(), 4);
    assert!(line.runs_view.live.hidden);
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
    assert_eq!(line.runs_view.runs.all().iter().filter(done).count(), 3);
    assert_eq!(line.runs_view.runs.on_charts().count(), 2);
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
    assert!(
        desk.screen()
            .contains("Enter begins 6 runs, + keeps the range")
    );
    assert!(desk.screen().contains("for a grid: 0.2, 0.4 m/s x"));
    desk.keys("enter");
    let said = said(&desk).to_owned();
    assert!(
        said.starts_with("6 runs begun over current.speed_m_per_s and solver.duration_s."),
        "{said}"
    );
}

/// Goes to a field by its label, without a filter afterwards, and begins to edit it.
fn edit(desk: &mut Desk, label: &str) {
    desk.keys("1 /");
    desk.keys("ctrl+u");
    desk.type_text(label);
    desk.keys("enter enter ctrl+u");
}

/// The ranges that wait, as `KEY=VALUES`.
fn kept(desk: &Desk) -> Vec<String> {
    let kept = &desk.state.editor().unwrap().kept;
    kept.iter().map(KeptRange::word).collect()
}

#[test]
fn a_range_kept_and_one_in_a_second_field_make_a_grid() {
    let mut desk = typing("0.2..0.8/4");
    desk.keys("+");
    assert_eq!(kept(&desk), ["current.speed_m_per_s=0.2..0.8/4"]);
    assert!(desk.state.editor().unwrap().editing.is_none());
    assert!(desk.started().is_empty());
    snapshot("tui_range_kept_80x24", &desk);
    edit(&mut desk, "duration");
    desk.type_text("300, 600");
    snapshot("tui_grid_typed_80x24", &desk);
    desk.state.jobs.limit = 8;
    desk.keys("enter");
    assert!(
        said(&desk).starts_with("8 runs begun over current.speed_m_per_s and solver.duration_s."),
        "{}",
        said(&desk)
    );
    assert!(kept(&desk).is_empty());
    assert!(!desk.state.editor().unwrap().unsaved());
    let started = desk.started();
    assert_eq!(
        started[7].1.overrides,
        ["current.speed_m_per_s=0.8", "solver.duration_s=600"]
    );
}

#[test]
fn a_kept_range_survives_edits_and_undo_and_is_in_its_field() {
    let mut desk = typing("0.2..0.8/4");
    desk.keys("+");
    // Another input is edited and undone, and the first is part of the runs.
    edit(&mut desk, "dry mass");
    desk.type_text("310000");
    desk.keys("enter u");
    assert_eq!(kept(&desk).len(), 1);
    desk.keys("U");
    edit(&mut desk, "duration");
    desk.type_text("300, 600");
    desk.keys("+");
    assert_eq!(kept(&desk).len(), 2);
    // The field has its range again, which replaces the kept one.
    desk.keys("1 /");
    desk.keys("ctrl+u");
    desk.type_text("current speed");
    desk.keys("enter enter");
    let editing = desk.state.editor().unwrap().editing.clone().unwrap();
    assert_eq!(editing.input.value(), "0.2..0.8/4");
    desk.keys("ctrl+u");
    desk.type_text("0.2, 0.4");
    desk.state.jobs.limit = 8;
    desk.keys("enter");
    assert!(said(&desk).starts_with("4 runs begun over solver.duration_s and current."));
    let started = desk.started();
    let overrides = &started.last().unwrap().1.overrides;
    assert!(
        overrides.iter().any(|set| set.contains("=310000")),
        "{overrides:?}"
    );
    assert!(
        overrides.ends_with(&["current.speed_m_per_s=0.4".to_owned()]),
        "{overrides:?}"
    );
}

#[test]
fn a_kept_range_is_dropped_by_esc_or_by_a_value() {
    let mut desk = typing("0.2..0.8/4");
    desk.keys("+");
    // Esc leaves the field first, then drops the range, then closes the case.
    desk.keys("enter esc");
    assert_eq!(kept(&desk).len(), 1);
    assert!(desk.screen().contains("esc drop range"));
    desk.keys("esc");
    assert!(kept(&desk).is_empty() && desk.state.document.is_some());
    assert!(desk.screen().contains("esc cases"));
    begin(&mut desk, "0.2..0.8/4");
    desk.keys("+");
    begin(&mut desk, "0.5");
    desk.keys("enter");
    assert!(kept(&desk).is_empty());
    assert!(desk.state.editor().unwrap().unsaved());
}

#[test]
fn a_plus_is_part_of_a_number_elsewhere() {
    let mut desk = typing("2e");
    desk.keys("+");
    desk.type_text("1");
    let editing = desk.state.editor().unwrap().editing.clone().unwrap();
    assert_eq!(editing.input.value(), "2e+1");
    let mut desk = typing("0.2..0.8/4");
    desk.keys("home +");
    let editing = desk.state.editor().unwrap().editing.clone().unwrap();
    assert_eq!(editing.input.value(), "+0.2..0.8/4");
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

#[test]
fn a_kept_range_is_kept_for_recovery_until_it_is_dropped() {
    let mut desk = typing("0.2..0.8/4");
    desk.asked.clear();
    desk.keys("+");
    let is_kept = |effect: &Effect| match effect {
        Effect::KeepRecovery { text, kept, .. } => text.is_some() && kept.len() == 1,
        _ => false,
    };
    assert!(desk.asked.iter().any(is_kept));
    desk.asked.clear();
    desk.keys("esc");
    let is_dropped = |effect: &Effect| matches!(effect, Effect::KeepRecovery { text: None, .. });
    assert!(desk.asked.iter().any(is_dropped));
}
