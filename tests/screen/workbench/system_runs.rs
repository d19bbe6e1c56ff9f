//! Runs in time of a system of lines on the screen: begun, watched, listed, charted, compared, reported.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use seacable::case::kind;
use seacable::run::job::JobEvent;
use seacable::run::store::{RunLocation, RunWriter};
use seacable::run::{Cost, RunState};
use seacable::system::SystemFile;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::{DocumentContent, JobNumber, JobRequest, SystemView};
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{LARGE, SMALL, has, said, snapshot};

const TEXT: &str = include_str!("../../../cases/systems/bridle_in_heave.toml");

/// The bridle, short and coarse, without error estimates.
fn text() -> String {
    TEXT.replace("segments = 40", "segments = 16").replace(
        "duration_s = 60.0",
        "duration_s = 6.0\nerror_estimate = false",
    )
}

impl Desk {
    /// A bridle that is computed in time, open.
    fn with_moving_system(size: (u16, u16), text: &str) -> Self {
        let mut desk = Self::new(size);
        desk.tell(Msg::FileRead(Box::new(FileRead::new(
            PathBuf::from("cases/bridle.toml"),
            text.to_owned(),
            DocumentContent::System(Box::new(SystemView::new(
                kind::parse::<SystemFile>(text, "bridle.toml").unwrap(),
            ))),
            None,
        ))));
        desk
    }

    /// The jobs asked for and not yet answered.
    fn begun(&mut self) -> Vec<(JobNumber, JobRequest)> {
        let mut begun = Vec::new();
        self.asked.retain(|effect| match effect {
            Effect::Start {
                ticket, request, ..
            } => {
                begun.push((*ticket, request.clone()));
                false
            }
            _ => true,
        });
        begun
    }

    /// Computes the jobs asked for; of each the events up to a time are told, then its end where that is asked for.
    pub(crate) fn compute(&mut self, until: f64, to_the_end: bool) {
        for (ticket, request) in self.begun() {
            let dir = PathBuf::from(format!("runs/bridle-{ticket}"));
            self.tell(Msg::Stored(ticket, dir));
            let mut run = request.execute(&AtomicBool::new(false), &mut |event| {
                let told = match &event {
                    JobEvent::Frame(frame) => frame.time <= until,
                    _ => true,
                };
                if told {
                    self.tell(Msg::Job(ticket, Box::new(event)));
                }
            });
            run.info.cost = Cost::default();
            run.info.started = "2026-01-02T03:04:05Z".to_owned();
            if to_the_end {
                let event = JobEvent::Finished(Box::new(run));
                self.tell(Msg::Job(ticket, Box::new(event)));
            }
        }
    }
}

#[test]
fn a_run_is_watched_and_shown_on_the_charts() {
    let mut desk = Desk::with_moving_system(SMALL, &text());
    desk.keys("R");
    assert!(
        said(&desk).contains("`5` shows its curves, `8` the jobs"),
        "{}",
        said(&desk)
    );
    desk.compute(3.0, false);
    desk.keys("5");
    let curves = |desk: &Desk| {
        let on = desk.state.charted().unwrap();
        let run = on.view.runs.all()[0].clone();
        run.curves.history().time.len()
    };
    // Its curves grow while it computes.
    assert_eq!(curves(&desk), 31);
    let mut desk = Desk::with_moving_system(SMALL, &text());
    desk.keys("R");
    desk.compute(f64::INFINITY, true);
    assert!(said(&desk).contains("is done. `5` shows its curves, `7` the report"));
    assert_eq!(curves(&desk), 61);
    desk.keys("5");
    snapshot("tui_system_charts_80x24", &desk);
    desk.keys("] ] ] ] ] ] ]");
    assert!(desk.screen().contains("clump"));
    desk.keys("6");
    snapshot("tui_system_runs_80x24", &desk);
    let mut desk = Desk::with_moving_system(LARGE, &text());
    desk.keys("R");
    desk.compute(f64::INFINITY, true);
    desk.keys("5");
    snapshot("tui_system_charts_200x60", &desk);
}

#[test]
fn two_runs_are_compared_and_reported() {
    let mut desk = Desk::with_moving_system(SMALL, &text());
    desk.keys("6 space");
    assert!(
        said(&desk).contains("There is no run yet"),
        "{}",
        said(&desk)
    );
    desk.keys("R");
    desk.compute(f64::INFINITY, true);
    desk.keys("R");
    desk.compute(f64::INFINITY, true);
    desk.keys("6 g m m =");
    assert!(has(
        &desk,
        |effect| matches!(effect, Effect::Compare { runs, .. } if runs.len() == 2)
    ));
    desk.keys("G v 5 d");
    assert!(
        said(&desk).contains("Curves against time are drawn less those of"),
        "{}",
        said(&desk)
    );
    desk.keys("7");
    assert_eq!(desk.state.focus(), PaneId::Report);
    assert!(
        desk.screen().contains("Bridle in heave"),
        "{}",
        desk.screen()
    );
}

/// A stored run goes on to a later end, as one of a line case.
#[test]
fn a_stored_run_is_resumed_from_the_list() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("short");
    let mut desk = Desk::with_moving_system(SMALL, &text());
    desk.keys("R");
    let (ticket, request) = desk.begun().remove(0);
    let exactly = RunLocation::Exactly(dir.clone());
    let mut writer =
        RunWriter::begin(&exactly, request.initial_info(), &request.stored_text()).unwrap();
    let run = request.execute(&AtomicBool::new(false), &mut |event| {
        writer.event(&event).unwrap();
    });
    writer.finish(&run).unwrap();
    desk.tell(Msg::Stored(ticket, dir.clone()));
    let event = JobEvent::Finished(Box::new(run));
    desk.tell(Msg::Job(ticket, Box::new(event)));
    desk.keys("6 G c ctrl+u");
    desk.type_text("8");
    desk.asked.clear();
    desk.keys("enter");
    assert!(
        matches!(&desk.asked[..], [Effect::PrepareResume(from, until)] if *from == dir && *until == 8.0)
    );
    desk.tell(Msg::ResumeReady(
        dir.clone(),
        8.0,
        JobRequest::resumed(&dir, 8.0),
    ));
    assert!(said(&desk).contains("is resumed from "), "{}", said(&desk));
    desk.compute(f64::INFINITY, true);
    let runs = &desk.state.runs_view().unwrap().runs;
    let last = runs.all().last().unwrap();
    assert_eq!(last.label, "to 8 s");
    let resumed = last.curves.run.as_ref().unwrap();
    assert_eq!(resumed.info.state, RunState::Done);
    assert_eq!(resumed.history.time.len(), 81);
    let again = JobRequest::resumed(&dir, 3.0);
    assert!(again.unwrap_err().contains("is at 6 s already"));
}

#[test]
fn a_run_that_fails_says_when_and_where() {
    let failing = text().replace(
        "duration_s = 6.0",
        "duration_s = 6.0\nposition_tolerance_m = 1e-300",
    );
    let mut desk = Desk::with_moving_system(SMALL, &failing);
    desk.keys("R");
    desk.compute(f64::INFINITY, true);
    let words = said(&desk);
    assert!(
        words.contains("The run failed: at t = ") && words.contains("node"),
        "{words}"
    );
    let run = &desk.state.runs_view().unwrap().runs.all()[0];
    assert_eq!(
        run.curves.run.as_ref().unwrap().info.state,
        RunState::Failed
    );
}

#[test]
fn what_happens_to_the_lines_is_said_and_reported() {
    let broken = text().replace(
        "name = \"left\"\n",
        "name = \"left\"\nbreak_at_m = 50.0\nbreak_s = 3.0\n",
    );
    let mut desk = Desk::with_moving_system(LARGE, &broken);
    desk.keys("R");
    desk.compute(f64::INFINITY, true);
    let words = said(&desk);
    assert!(words.contains("3.000000 s: line left breaks."), "{words}");
    desk.keys("7");
    assert!(
        desk.state
            .runs_view()
            .unwrap()
            .report
            .as_ref()
            .unwrap()
            .1
            .contains("line left breaks")
    );
}

#[test]
fn ctrl_c_cancels_a_run() {
    let mut desk = Desk::with_moving_system(SMALL, &text());
    desk.keys("R ctrl+c");
    assert!(has(&desk, |effect| matches!(effect, Effect::Cancel(_))));
}

/// The stored runs of the files that a system names beside it are listed with its own.
#[test]
fn runs_of_systems_beside_it_are_listed() {
    let title = "title = \"Bridle in heave\"\n";
    let text = text().replace(title, &format!("{title}beside = [\"other.toml\"]\n"));
    for (text, wanted) in [
        (self::text(), vec!["bridle.toml"]),
        (text, vec!["bridle.toml", "other.toml"]),
    ] {
        let desk = Desk::with_moving_system(SMALL, &text);
        let listed = desk.asked.iter().find_map(|effect| match effect {
            Effect::ListRuns { files, .. } => Some(files.clone()),
            _ => None,
        });
        assert_eq!(listed.unwrap(), wanted);
    }
}
