//! A ropeway on the screen: the cargo moved along it, other spans, its panes, and what it looks like.

use std::path::PathBuf;

use seacable::case::kind;
use seacable::chart::Glyphs;
use seacable::ropeway::Ropeway;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::{Document, DocumentContent, RopewayView};
use seacable::tui::{Effect, Msg};

use super::desk::{Desk, looks};
use super::{LARGE, SMALL, has, said, snapshot};

const TEXT: &str = include_str!("../../../cases/ropeway/span_80.toml");

impl Desk {
    /// The ropeway of 80 m, open.
    pub(crate) fn with_ropeway(size: (u16, u16)) -> Self {
        let mut desk = Self::new(size);
        desk.tell(Msg::FileRead(Box::new(FileRead::new(
            PathBuf::from("cases/span_80.toml"),
            TEXT.to_owned(),
            DocumentContent::Ropeway(Box::new(RopewayView::new(
                kind::parse::<Ropeway>(TEXT, "span_80.toml").unwrap(),
            ))),
            None,
        ))));
        desk
    }
}

fn open(desk: &Desk) -> &Document {
    desk.state.document.as_ref().unwrap()
}

fn ropeway(desk: &Desk) -> &RopewayView {
    let DocumentContent::Ropeway(ropeway) = &open(desk).content else {
        panic!("no ropeway");
    };
    ropeway
}

fn sag(desk: &Desk) -> f64 {
    ropeway(desk).results().unwrap().exact.sag_m
}

#[test]
fn the_panes_of_a_ropeway() {
    let mut desk = Desk::with_ropeway(SMALL);
    assert_eq!(desk.state.focus(), PaneId::Ropeway);
    snapshot("tui_ropeway_80x24", &desk);
    desk.keys("1");
    snapshot("tui_ropeway_inputs_80x24", &desk);
    desk.keys("3 ]");
    snapshot("tui_ropeway_hauling_80x24", &desk);
    desk.keys("4");
    snapshot("tui_ropeway_validation_80x24", &desk);
    let desk = Desk::with_ropeway(LARGE);
    snapshot("tui_ropeway_200x60", &desk);
}

#[test]
fn without_colour_in_ascii() {
    let mut desk = Desk::with_ropeway((120, 30));
    desk.state.capabilities = looks(Glyphs::Ascii, false);
    snapshot("tui_ropeway_ascii_mono_120x30", &desk);
    let buffer = desk.buffer();
    assert!(buffer.content().iter().all(|cell| cell.symbol().is_ascii()));
}

#[test]
fn the_cargo_slides_and_everything_follows_without_an_edit() {
    let mut desk = Desk::with_ropeway(SMALL);
    let (middle, before) = (sag(&desk), desk.screen());
    desk.keys("l l right");
    assert!((ropeway(&desk).position - 0.53).abs() < 1e-9);
    assert!(sag(&desk) < middle);
    assert_ne!(desk.screen(), before);
    desk.keys("H H h left");
    assert!((ropeway(&desk).position - 0.31).abs() < 1e-9);
    assert!(!open(&desk).editor.unsaved());
    desk.keys("L L L L L L L L");
    assert!(desk.screen().contains("on the ship"), "{}", desk.screen());
    desk.keys("0");
    assert!((sag(&desk) - middle).abs() < 1e-12);
    desk.keys("H K");
    assert!(open(&desk).editor.text.contains("position = 0.4\n"));
    desk.keys("u");
    assert!(!open(&desk).editor.unsaved());
}

#[test]
fn another_span_is_an_edit_like_any_other() {
    let mut desk = Desk::with_ropeway(SMALL);
    desk.keys("1 /");
    desk.type_text("ropeway.span_m");
    desk.keys("enter");
    for (typed, span) in [("40", 40.0), ("60", 60.0)] {
        desk.keys("enter ctrl+u");
        desk.type_text(typed);
        desk.keys("enter");
        assert!((ropeway(&desk).worked.rope.geometry.span_m - span).abs() < 1e-12);
        assert!(open(&desk).editor.unsaved());
        desk.keys("u");
        assert!((ropeway(&desk).worked.rope.geometry.span_m - 80.0).abs() < 1e-12);
        assert!(!open(&desk).editor.unsaved());
    }
}

#[test]
fn an_edit_is_worked_out_at_once_and_a_bad_one_refused_with_its_reason() {
    let mut desk = Desk::with_ropeway(SMALL);
    desk.keys("1 /");
    desk.type_text("setting.sag");
    desk.keys("enter enter ctrl+u");
    desk.type_text("30");
    desk.keys("enter");
    let text = desk.screen();
    assert!(text.contains("of the shortest there is"), "{text}");
    assert!(!open(&desk).editor.unsaved());
    desk.keys("ctrl+u");
    desk.type_text("5");
    desk.keys("enter");
    assert!(open(&desk).editor.unsaved() && sag(&desk) < 6.0);
}

#[test]
fn report_line_case_and_validation_are_written() {
    let mut desk = Desk::with_ropeway(SMALL);
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
    assert_eq!(written[0].0, "span_80-report.txt");
    assert_eq!(written[1].0, "span_80-line.toml");
    assert!(seacable::case::parse(written[1].1, "line").is_ok());
    assert_eq!(written[2].0, "span_80-validation.txt");
    assert!(written[2].1.contains("DIFFERS"));
    desk.keys("esc");
    assert_eq!(desk.state.focus(), PaneId::Cases, "{}", said(&desk));
    assert!(has(&desk, |e| matches!(e, Effect::ReadCases)));
}
