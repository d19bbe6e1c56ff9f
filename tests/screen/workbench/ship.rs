//! A ship on the screen: its headings chosen, its motions drawn, computed at sea without the screen waiting.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;

use seacable::case::kind;
use seacable::chart::Glyphs;
use seacable::ship::{DynamicAnalysis, Ship};
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::{Document, DocumentContent, ShipView};
use seacable::tui::{Effect, Msg};

use super::desk::{Desk, looks};
use super::{LARGE, SMALL, has, said, snapshot};

const TEXT: &str = include_str!("../../../cases/ship/anchored.toml");

/// The ship that comes with the program, with a record and few seeds that are computed quickly.
fn text() -> String {
    TEXT.replace("duration_s = 10800.0", "duration_s = 600.0")
        .replace("records = 10", "records = 3")
}

impl Desk {
    /// The anchored ship, open, still to be computed at sea.
    pub(crate) fn with_ship(size: (u16, u16)) -> Self {
        let mut desk = Self::new(size);
        let rest = kind::parse::<Ship>(&text(), "anchored.toml").unwrap();
        desk.tell(Msg::FileRead(Box::new(FileRead::new(
            PathBuf::from("cases/ship/anchored.toml"),
            text(),
            DocumentContent::Ship(Box::new(ShipView::new(rest))),
            None,
        ))));
        desk
    }

    /// Answers as the thread does that works the newest text out.
    fn sail(&mut self) {
        let asked = self.asked.iter().rev().find_map(|effect| match effect {
            Effect::ComputeShip(ship) => Some(ship.clone()),
            _ => None,
        });
        let mut ship = asked.unwrap();
        ship.folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/ship");
        let computed = ship.computed();
        self.tell(Msg::ShipComputed(ship.stop, computed));
    }
}

fn open(desk: &Desk) -> &Document {
    desk.state.document.as_ref().unwrap()
}

fn ship(desk: &Desk) -> &ShipView {
    let DocumentContent::Ship(ship) = &open(desk).content else {
        panic!("no ship");
    };
    ship
}

#[test]
fn the_panes_of_a_ship() {
    let mut desk = Desk::with_ship(SMALL);
    assert_eq!(desk.state.focus(), PaneId::Ship);
    assert!(
        desk.screen().contains("dynamic analysis: running"),
        "{}",
        desk.screen()
    );
    desk.keys("3 ]");
    assert!(desk.screen().contains("dynamic analysis is still running"));
    desk.sail();
    snapshot("tui_ship_motions_80x24", &desk);
    desk.keys("2");
    snapshot("tui_ship_80x24", &desk);
    desk.keys("1");
    snapshot("tui_ship_inputs_80x24", &desk);
    desk.keys("3 ] ]");
    snapshot("tui_ship_rope_80x24", &desk);
    desk.keys("4");
    snapshot("tui_ship_validation_80x24", &desk);
    let mut desk = Desk::with_ship(LARGE);
    desk.sail();
    snapshot("tui_ship_200x60", &desk);
}

#[test]
fn without_colour_in_ascii() {
    let mut desk = Desk::with_ship((120, 30));
    desk.state.capabilities = looks(Glyphs::Ascii, false);
    desk.sail();
    snapshot("tui_ship_ascii_mono_120x30", &desk);
    let buffer = desk.buffer();
    assert!(buffer.content().iter().all(|cell| cell.symbol().is_ascii()));
}

#[test]
fn headings_are_chosen_and_motions_drawn_one_by_one() {
    let mut desk = Desk::with_ship(SMALL);
    let (first, before) = (ship(&desk).equilibrium, desk.screen());
    desk.keys(if first == 0 { "G" } else { "g" });
    assert_ne!(ship(&desk).equilibrium, first);
    assert_ne!(desk.screen(), before);
    desk.sail();
    desk.keys("3 ] c c c");
    assert_eq!(ship(&desk).trace, Some(2));
    desk.keys("c c c c");
    assert_eq!(ship(&desk).trace, None);
}

#[test]
fn an_edit_is_live_at_rest_and_only_the_newest_text_is_taken_at_sea() {
    let mut desk = Desk::with_ship(SMALL);
    let stale = ship(&desk).running.clone().unwrap();
    let before = ship(&desk).statics.clone();
    desk.keys("1 /");
    desk.type_text("current.speed");
    desk.keys("enter enter ctrl+u");
    desk.type_text("0.4");
    desk.keys("enter");
    assert!(open(&desk).editor.unsaved());
    assert_ne!(ship(&desk).statics.equilibria, before.equilibria);
    // The computation under way was stopped, and its answer is dropped.
    assert!(stale.load(Ordering::Relaxed));
    let old = DynamicAnalysis {
        motion: None,
        coupled: None,
        rope: None,
    };
    desk.tell(Msg::ShipComputed(
        stale,
        Some((Arc::new(old), Default::default())),
    ));
    assert!(ship(&desk).dynamic.is_none() && ship(&desk).running.is_some());
    desk.sail();
    assert!(ship(&desk).dynamic.is_some() && ship(&desk).running.is_none());
    desk.keys("u");
    assert!(!open(&desk).editor.unsaved());
    desk.keys("1 enter ctrl+u");
    desk.type_text("-4");
    desk.keys("enter");
    assert!(desk.screen().contains("out of range") || desk.screen().contains("greater than"));
}

#[test]
fn report_hang_point_and_validation_are_written_once_worked_out() {
    let mut desk = Desk::with_ship(SMALL);
    desk.keys("w");
    assert!(
        said(&desk).contains("dynamic analysis is still running"),
        "{}",
        said(&desk)
    );
    desk.sail();
    desk.keys("w M 4 w");
    let written: Vec<(String, &str)> = desk
        .asked
        .iter()
        .filter_map(|e| match e {
            Effect::WriteText { path, text, .. } => {
                Some((path.display().to_string(), text.as_str()))
            }
            _ => None,
        })
        .collect();
    assert_eq!(written[0].0, "anchored-report.txt");
    assert!(written[0].1.contains("Equilibrium headings"));
    assert_eq!(written[1].0, "anchored-hang-off-point.csv");
    assert!(written[1].1.starts_with("time_s,x_m,y_m,z_m\n0.0,"));
    assert_eq!(written[2].0, "anchored-validation.txt");
    desk.keys("esc");
    assert_eq!(desk.state.focus(), PaneId::Cases, "{}", said(&desk));
    assert!(has(&desk, |e| matches!(e, Effect::ReadCases)));
}
