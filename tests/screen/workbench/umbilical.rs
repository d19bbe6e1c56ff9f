//! The umbilical at rest on the screen: charts that begin with its shape, and the table of its nodes.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::report::figures::FigureId;
use seacable::run::job::{self, JobEvent};
use seacable::tui::msg::FileRead;
use seacable::tui::{Effect, Msg};

use super::desk::{Desk, content_of};
use super::{SMALL, snapshot};

const WAVE: &str = include_str!("../../../cases/umbilical/steep_wave.toml");

/// The case open with its live solve complete, computed for real: statics are quick.
fn wave(size: (u16, u16)) -> Desk {
    let mut desk = Desk::new(size);
    desk.tell(Msg::FileRead(Box::new(FileRead::new(
        PathBuf::from("cases/steep_wave.toml"),
        WAVE.to_owned(),
        content_of(case::parse(WAVE, "steep_wave.toml").unwrap()),
        None,
    ))));
    compute(&mut desk);
    desk
}

fn compute(desk: &mut Desk) {
    loop {
        let started = desk.started();
        if started.is_empty() {
            return;
        }
        for (ticket, request) in started {
            let run = job::execute(&request, &AtomicBool::new(false), &mut |_| ());
            desk.tell(Msg::Job(
                ticket,
                Box::new(JobEvent::Finished(Box::new(run))),
            ));
        }
    }
}

#[test]
fn a_line_at_rest_at_80x24() {
    let mut desk = wave(SMALL);
    desk.keys("2");
    snapshot("tui_wave_side_80x24", &desk);
    desk.keys("[ [");
    snapshot("tui_wave_moment_80x24", &desk);
    desk.keys("7 G");
    snapshot("tui_wave_nodes_80x24", &desk);
    desk.keys("w");
    let written = desk.asked.iter().find_map(|effect| match effect {
        Effect::WriteText { path, text, .. } => Some((path.clone(), text.clone())),
        _ => None,
    });
    let (path, text) = written.unwrap();
    assert_eq!(path, PathBuf::from("steep_wave-nodes.csv"));
    assert_eq!(text.lines().count(), 332);
}

#[test]
fn the_charts_are_those_that_have_something_to_show() {
    let mut desk = wave(SMALL);
    let open = desk.state.line().unwrap();
    assert_eq!(open.runs_view.chart, FigureId::Shape);
    assert_eq!(FigureId::of_case(&open.case).len(), 7);
    // Without bending stiffness there is no curvature to show, and with time there is a history.
    desk.keys("2 [");
    assert_eq!(desk.state.line().unwrap().runs_view.chart, FigureId::Study);
    let text = case::edit::set(WAVE, "materials.umbilical.ei_n_m2", "0.0").unwrap();
    let bare = case::parse(&text, "bare").unwrap();
    assert_eq!(FigureId::of_case(&bare).len(), 5);
    let text = case::edit::set(WAVE, "solver.method", "alpha").unwrap();
    let moving = case::parse(&text, "moving").unwrap();
    assert_eq!(
        FigureId::of_case(&moving),
        [
            FigureId::Tensions,
            FigureId::OnBed,
            FigureId::Shape,
            FigureId::Profile,
            FigureId::Curvature,
            FigureId::Moment,
            FigureId::Study
        ]
    );
}

#[test]
fn every_chart_of_a_line_at_rest_is_seen_at_once_on_a_large_screen() {
    let mut desk = wave((200, 60));
    desk.keys("2");
    let text = desk.screen();
    for title in [
        "Shape of the line",
        "from above",
        "from ahead",
        "Curvature",
        "Bending moment",
    ] {
        assert!(text.contains(title), "{title} is missing:\n{text}");
    }
    desk.keys("7");
    assert!(desk.screen().contains("Nodes of live"));
}
