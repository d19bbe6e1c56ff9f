//! RunningJob on with a stored run.

use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::run::job::{self, Request};
use seacable::run::store::{RunLocation, RunWriter};
use seacable::tui::state::JobRequest;
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{said, snapshot};

/// A stored run goes on: the time is asked for, a time that will not do is asked for again, and the run joins the queue.
#[test]
fn a_stored_run_is_resumed_from_the_list() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("short");
    let mut desk = Desk::with_case((80, 24));
    desk.keys("3 c");
    assert!(said(&desk).contains("in memory only"));
    desk.keys("R");
    desk.finish_jobs();
    desk.keys("c");
    snapshot("tui_go_on_80x24", &desk);
    desk.keys("ctrl+u");
    desk.type_text("ten");
    desk.keys("enter");
    assert!(desk.screen().contains("must be a number"));
    desk.keys("ctrl+u");
    desk.type_text("4");
    desk.asked.clear();
    desk.keys("enter");
    assert!(matches!(desk.asked[..], [Effect::PrepareResume(_, until)] if until == 4.0));
    desk.tell(Msg::ResumeReady(
        dir.clone(),
        4.0,
        Err("No whole number.".to_owned()),
    ));
    assert!(desk.screen().contains("No whole number."));
    desk.keys("esc");

    let text = include_str!("../../../cases/hard/falling.toml");
    let request = Request {
        case: case::parse(text, "falling.toml").unwrap(),
        text: text.to_owned(),
        file: "falling.toml".to_owned(),
        overrides: Vec::new(),
        id: String::new(),
    };
    let mut writer = RunWriter::begin(
        &RunLocation::Exactly(dir.clone()),
        request.initial_info(),
        text,
    )
    .unwrap();
    let run = job::execute(&request, &AtomicBool::new(false), &mut |event| {
        writer.event(&event).unwrap();
    });
    writer.finish(&run).unwrap();
    let onward = JobRequest::resumed(&dir, 4.0);
    desk.tell(Msg::ResumeReady(dir, 4.0, onward));
    let started = desk.started();
    assert_eq!(started.len(), 1);
    assert_eq!(started[0].1.case.solver.duration_s, 4.0);
    let runs = &desk.state.line().unwrap().runs_view.runs;
    assert_eq!(runs.all().last().map(|r| r.label.as_str()), Some("to 4 s"));
}
