//! A system of lines on the screen: its views, its panes, an edit that moves everything.

use std::path::PathBuf;

use seacable::case::kind;
use seacable::chart::Glyphs;
use seacable::system::SystemFile;
use seacable::tui::Msg;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::{DocumentContent, SystemView};

use super::desk::{Desk, looks};
use super::{LARGE, SMALL, snapshot};

const TEXT: &str = include_str!("../../../cases/systems/crows_foot.toml");

impl Desk {
    /// The platform on three split lines, open.
    pub(crate) fn with_system(size: (u16, u16)) -> Self {
        let mut desk = Self::new(size);
        desk.tell(Msg::FileRead(Box::new(FileRead::new(
            PathBuf::from("cases/crows_foot.toml"),
            TEXT.to_owned(),
            DocumentContent::System(Box::new(SystemView::new(
                kind::parse::<SystemFile>(TEXT, "crows_foot.toml").unwrap(),
            ))),
            None,
        ))));
        desk
    }
}

fn height_of_junction(desk: &Desk) -> f64 {
    let DocumentContent::System(system) = &desk.state.document.as_ref().unwrap().content else {
        panic!("no system");
    };
    let point = system.solved.network.point("junction1").unwrap();
    system.solved.rest.placement.points[point].z
}

#[test]
fn the_panes_of_a_system() {
    let mut desk = Desk::with_system(SMALL);
    assert_eq!(desk.state.focus(), PaneId::System);
    snapshot("tui_system_80x24", &desk);
    desk.keys("l");
    snapshot("tui_system_side_80x24", &desk);
    desk.keys("3 ] ] ]");
    snapshot("tui_system_stiffness_80x24", &desk);
    let desk = Desk::with_system(LARGE);
    snapshot("tui_system_200x60", &desk);
}

#[test]
fn without_colour_in_ascii() {
    let mut desk = Desk::with_system((120, 30));
    desk.state.capabilities = looks(Glyphs::Ascii, false);
    desk.keys("l l");
    let buffer = desk.buffer();
    assert!(buffer.content().iter().all(|cell| cell.symbol().is_ascii()));
}

/// A longer main line lets its junction come nearer to the platform, and down.
#[test]
fn an_edit_moves_everything() {
    let mut desk = Desk::with_system(SMALL);
    let before = height_of_junction(&desk);
    desk.keys("1");
    desk.keys("/ m a i n 1 space l e n g t h enter");
    desk.keys("enter ctrl+u 1 6 5 enter");
    let after = height_of_junction(&desk);
    assert!((after - before).abs() > 0.5, "{before} {after}");
    desk.keys("u");
    assert!((height_of_junction(&desk) - before).abs() < 1e-9);
}
