//! A cross-section on the screen: what keys do to it, and what it looks like.

use std::path::PathBuf;

use seacable::case::kind;
use seacable::section::CrossSection;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::{Document, DocumentContent, Overlay, Question, SectionView};
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{LARGE, SMALL, has, said, snapshot};

const TEXT: &str = include_str!("../../../cases/umbilical/section.toml");

impl Desk {
    /// The cross-section of the umbilical, open.
    pub(crate) fn with_section(size: (u16, u16)) -> Self {
        let mut desk = Self::new(size);
        desk.tell(Msg::FileRead(Box::new(FileRead::new(
            PathBuf::from("cases/section.toml"),
            TEXT.to_owned(),
            DocumentContent::Section(Box::new(SectionView::new(
                kind::parse::<CrossSection>(TEXT, "section.toml").unwrap(),
            ))),
            None,
        ))));
        desk
    }
}

fn open(desk: &Desk) -> &Document {
    desk.state.document.as_ref().unwrap()
}

fn section(desk: &Desk) -> &SectionView {
    let DocumentContent::Section(section) = &open(desk).content else {
        panic!("no section");
    };
    section
}

/// Goes to a field by its name and types a value.
fn edit(desk: &mut Desk, field: &str, value: &str) {
    desk.keys("1 /");
    desk.type_text(field);
    desk.keys("enter enter ctrl+u");
    desk.type_text(value);
    desk.keys("enter");
}

#[test]
fn the_panes_of_a_section() {
    let mut desk = Desk::with_section(SMALL);
    snapshot("tui_section_inputs_80x24", &desk);
    desk.keys("2");
    snapshot("tui_section_drawing_80x24", &desk);
    desk.keys("3");
    snapshot("tui_section_tables_80x24", &desk);
    let desk = Desk::with_section(LARGE);
    snapshot("tui_section_200x60", &desk);
}

#[test]
fn an_edit_redraws_at_once_keeps_every_comment_and_can_be_undone() {
    let mut desk = Desk::with_section(SMALL);
    let before = section(&desk).design.clone();
    edit(&mut desk, "tube.wall_m", "0.002");
    let (now, design) = (open(&desk), &section(&desk).design);
    assert_eq!(
        now.editor.text,
        TEXT.replace("wall_m = 0.00165", "wall_m = 0.002")
    );
    assert!(design.ea() > before.ea());
    assert!(has(
        &desk,
        |e| matches!(e, Effect::KeepRecovery { text: Some(t), .. } if t.contains("wall_m = 0.002"))
    ));
    desk.keys("u");
    assert_eq!(section(&desk).design, before);
    desk.keys("U s");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::SaveCase { text, expected: Some(old), .. } if text.contains("0.002") && old == TEXT)
    ));
    desk.keys("r");
    assert!(!open(&desk).editor.unsaved());
}

#[test]
fn what_cannot_be_laid_out_is_refused_with_the_reason() {
    let mut desk = Desk::with_section(SMALL);
    edit(&mut desk, "inner-armour.count", "500");
    snapshot("tui_section_refused_80x24", &desk);
    assert!(!open(&desk).editor.unsaved());
}

#[test]
fn the_drawing_zooms_and_pans_and_fits_again() {
    let mut desk = Desk::with_section(SMALL);
    desk.keys("2");
    let whole = desk.buffer();
    desk.keys("+ + l k");
    assert_ne!(desk.buffer(), whole);
    desk.keys("0");
    assert_eq!(desk.buffer(), whole);
}

#[test]
fn the_material_is_written_and_copied_and_the_drawing_and_tables_too() {
    let mut desk = Desk::with_section(SMALL);
    desk.keys("M y w 2 w");
    let mut written = desk.asked.iter().filter_map(|e| match e {
        Effect::WriteText { path, text, .. } => Some((path.display().to_string(), text)),
        _ => None,
    });
    let (path, fragment) = written.next().unwrap();
    assert_eq!(path, "umbilical-material.txt");
    assert!(fragment.contains("[materials.umbilical]"));
    assert!(has(
        &desk,
        |e| matches!(e, Effect::Copy(text) if text == fragment)
    ));
    assert_eq!(written.next().unwrap().0, "section-tables.txt");
    assert_eq!(written.next().unwrap().0, "section-drawing.txt");
}

#[test]
fn leaving_asks_about_changes_and_goes_back_to_the_list() {
    let mut desk = Desk::with_section(SMALL);
    edit(&mut desk, "section.voids", "flooded");
    desk.keys("esc esc");
    let question = Overlay::Ask(Question::Unsaved { quit: false });
    let asked = desk.state.overlay.as_ref().map(|o| format!("{o:?}"));
    assert_eq!(asked, Some(format!("{question:?}")), "{}", said(&desk));
    desk.keys("d");
    assert_eq!(desk.state.focus(), PaneId::Cases);
}
