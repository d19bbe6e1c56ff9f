//! Inputs that the user edited: what the views say of them, and of the published values that were for other inputs.

use std::path::PathBuf;

use super::desk::{CASE, Desk};
use super::{LARGE, SMALL};
use seacable::reference::Outcome;
use seacable::tui::{Msg, update};

const NARROW: (u16, u16) = (80, 30);

fn edited(size: (u16, u16), key: &str, value: &str) -> Desk {
    let mut desk = Desk::with_case(size);
    set(&mut desk, key, value);
    desk
}

fn set(desk: &mut Desk, key: &str, value: &str) {
    let effects = update::edit::set(&mut desk.state, key, value);
    desk.perform(effects);
    desk.finish_jobs();
}

fn outcomes(desk: &Desk) -> Vec<(Outcome, String)> {
    let checks = &desk.state.line().unwrap().checks.rows;
    let row = |row: &seacable::reference::ValidationRow| {
        (row.outcome, row.reason.clone().unwrap_or_default())
    };
    checks.iter().map(row).collect()
}

#[test]
fn an_edited_input_is_yours_and_the_help_says_what_the_file_says() {
    let mut desk = edited(NARROW, "payload.drag_area_m2", "120");
    desk.keys("/");
    desk.type_text("drag area");
    desk.keys("enter z");
    let screen = desk.screen();
    assert!(
        screen.contains("yours; the file says 141.0 m² (calibrated)"),
        "{screen}"
    );
    assert!(!screen.contains("fitted to the mean"), "{screen}");
    desk.keys("u");
    let screen = desk.screen();
    assert!(!screen.contains("yours"), "{screen}");
    assert!(screen.contains("fitted to the mean"), "{screen}");
}

#[test]
fn published_rows_do_not_judge_an_edited_case_and_say_why() {
    let mut desk = Desk::with_case(LARGE);
    let before = outcomes(&desk);
    set(&mut desk, "current.speed_m_per_s", "0.45");
    let why = "current.speed_m_per_s is yours: 0.45 m/s for 0.3 m/s.";
    for (outcome, reason) in outcomes(&desk) {
        assert_eq!((outcome, reason.as_str()), (Outcome::Edited, why));
    }
    desk.keys("4");
    let screen = desk.screen();
    assert!(
        screen.contains("EDITED") && screen.contains(why),
        "{screen}"
    );
    set(&mut desk, "current.speed_m_per_s", "0.3");
    assert_eq!(outcomes(&desk), before);
}

#[test]
fn solver_and_mesh_are_judged_and_the_duration_where_the_whole_run_counts() {
    let mut desk = Desk::with_case(SMALL);
    let before = outcomes(&desk);
    set(&mut desk, "line.rope.segments", "10");
    set(&mut desk, "solver.method", "rk4");
    assert_eq!(outcomes(&desk), before);
    set(&mut desk, "solver.duration_s", "700");
    let (late, early) = (&outcomes(&desk)[0], &outcomes(&desk)[1]);
    assert_ne!(late.0, Outcome::Edited, "it has a window of its own");
    assert_eq!(early.0, Outcome::Edited);
}

#[test]
fn a_saved_edit_remains_the_users() {
    let mut desk = edited(NARROW, "current.speed_m_per_s", "0.45");
    let text = desk.state.editor().unwrap().text.clone();
    desk.tell(Msg::Saved(PathBuf::from("cases/body.toml"), text));
    set(&mut desk, "solver.method", "rk4");
    let editor = desk.state.editor().unwrap();
    let speed = editor.edited.iter().find(|key| key.path.contains("speed"));
    let words = speed.unwrap().replaced.words();
    assert_eq!(words, "yours; the file as opened says 0.3 m/s (published)");
    assert!(outcomes(&desk).iter().all(|(o, _)| *o == Outcome::Edited));
}

#[test]
fn the_report_of_an_edited_case_marks_its_inputs_and_judges_no_published_value() {
    let mut desk = edited(SMALL, "payload.drag_area_m2", "120");
    desk.keys("R");
    desk.finish_jobs();
    desk.keys("5");
    let (_, report) = desk.state.line().unwrap().runs_view.report.clone().unwrap();
    assert!(report.contains("payload.drag_area_m2: yours"), "{report}");
    assert!(
        !report.contains("payload.drag_area_m2 (calibrated)"),
        "{report}"
    );
    assert!(report.contains("2 EDITED"), "{report}");
    assert!(report.contains("Rows that read EDITED"), "{report}");
    assert!(CASE.contains("calibrated"));
}
