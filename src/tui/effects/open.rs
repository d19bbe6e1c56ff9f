//! A file read as what it is: a line case, a cross-section, a ropeway, a ship.

use std::path::Path;

use crate::case::{self, Diagnostic, Opened};
use crate::kinds::Kind;
use crate::ropeway;
use crate::section;
use crate::ship;
use crate::tui::msg::{CaseRead, FileRead, Msg};
use crate::tui::state::{Content, RopewayView, SectionView, ShipView};
use crate::tui::{case_library, recovery};

pub(super) fn read_case(path: &Path) -> Msg {
    match Kind::of(path) {
        Kind::Line => line_read(path),
        Kind::Section => file_read(section::load(path), path, |design| {
            Content::Section(Box::new(SectionView::new(design)))
        }),
        Kind::Ropeway => file_read(ropeway::load(path), path, |worked| {
            Content::Ropeway(Box::new(RopewayView::new(worked)))
        }),
        Kind::Ship => file_read(ship::load(path), path, |rest| {
            Content::Ship(Box::new(ShipView::new(rest)))
        }),
    }
}

/// A line case, with what an earlier session left of it.
fn line_read(path: &Path) -> Msg {
    match case::load(path) {
        Ok(loaded) => Msg::CaseRead(Box::new(CaseRead {
            recovered: recovery::find(path).filter(|text| *text != loaded.text),
            path: loaded.path,
            text: loaded.text,
            case: loaded.case,
        })),
        Err(all) => Msg::CaseRejected(path.display().to_string(), case_library::story(path, &all)),
    }
}

/// A file of another kind, with what an earlier session left of it.
fn file_read<W>(
    read: Result<Opened<W>, Vec<Diagnostic>>,
    path: &Path,
    content: impl FnOnce(W) -> Content,
) -> Msg {
    match read {
        Ok(loaded) => Msg::FileRead(Box::new(FileRead {
            recovered: recovery::find(path).filter(|text| *text != loaded.text),
            path: loaded.path,
            text: loaded.text,
            content: content(loaded.worked),
        })),
        Err(all) => Msg::CaseRejected(path.display().to_string(), case_library::story(path, &all)),
    }
}
