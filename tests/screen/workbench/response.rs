//! A line in waves on the screen: the map of its response, its root mean squares and waves, and their tables.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::report::figures::FigureId;
use seacable::run::job::{self, JobEvent};
use seacable::tui::msg::FileRead;
use seacable::tui::{Effect, Msg};

use super::desk::{Desk, content_of};
use super::{LARGE, SMALL, looks, snapshot};
use seacable::chart::Glyphs;

/// The cable in the regular wave on a coarse mesh, for a shorter time, computed for real.
fn cable(size: (u16, u16)) -> Desk {
    let text = include_str!("../../../cases/double_stepped/regular_wave.toml")
        .replace("duration_s = 240.0", "duration_s = 120.0")
        .replace("response_from_s = 140.0", "response_from_s = 60.0")
        .replace("segments = 40", "segments = 10")
        .replace("segments = 20", "segments = 5")
        .replace("segments = 120", "segments = 30")
        .replace("segments = 59", "segments = 15");
    let mut desk = Desk::new(size);
    desk.tell(Msg::FileRead(Box::new(FileRead::new(
        PathBuf::from("cases/regular_wave.toml"),
        text.clone(),
        content_of(case::parse(&text, "regular_wave.toml").unwrap()),
        None,
    ))));
    for (ticket, request) in desk.started() {
        let mut run = job::execute(&request, &AtomicBool::new(false), &mut |_| ());
        // The time it took is another one every time.
        run.info.cost.cpu_s = 0.05;
        desk.tell(Msg::Job(
            ticket,
            Box::new(JobEvent::Finished(Box::new(run))),
        ));
    }
    desk
}

fn show(desk: &mut Desk, kind: FigureId) {
    desk.keys("2");
    for _ in 0..seacable::report::figures::FIGURES.len() {
        if desk.state.line().unwrap().runs_view.chart == kind {
            return;
        }
        desk.keys("]");
    }
    panic!("there is no chart {kind:?}");
}

#[test]
fn the_map_and_its_neighbours() {
    let mut desk = cable(SMALL);
    show(&mut desk, FigureId::Map);
    snapshot("tui_map_80x24", &desk);
    // The cursor reads a time and a place.
    desk.keys("l } } }");
    snapshot("tui_map_cursor_80x24", &desk);
    desk.keys("j");
    desk.state.capabilities = looks(Glyphs::Ascii, false);
    snapshot("tui_map_ascii_mono_80x24", &desk);
    desk.keys("w");
    let written = desk.asked.iter().filter_map(|effect| match effect {
        Effect::WriteText { path, text, .. } => Some((path.clone(), text.lines().count())),
        _ => None,
    });
    let written: Vec<_> = written.collect();
    assert_eq!(written[0].0, PathBuf::from("regular_wave-map.txt"));
    assert_eq!(written[1], (PathBuf::from("regular_wave-map.csv"), 62));
}

#[test]
fn the_tables_of_the_response() {
    let mut desk = cable(SMALL);
    desk.keys("7 ]");
    snapshot("tui_response_80x24", &desk);
    desk.keys("]");
    snapshot("tui_waves_80x24", &desk);
    desk.keys("w ]");
    let path = desk.asked.iter().find_map(|effect| match effect {
        Effect::WriteText { path, .. } => Some(path.clone()),
        _ => None,
    });
    assert_eq!(path, Some(PathBuf::from("regular_wave-waves.csv")));
}

#[test]
fn the_charts_of_the_response_at_200x60() {
    let mut desk = cable(LARGE);
    show(&mut desk, FigureId::Map);
    snapshot("tui_map_200x60", &desk);
}
