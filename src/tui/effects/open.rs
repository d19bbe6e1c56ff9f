//! A file read as what it is: a line case, a cross-section, a ropeway, a ship.

use std::path::Path;

use crate::case::{self, Diagnostic};
use crate::kinds::Kind;
use crate::ropeway;
use crate::section;
use crate::ship;
use crate::tui::msg::{FileRead, Msg};
use crate::tui::state::{Content, LineView, RopewayView, SectionView, ShipView};
use crate::tui::{case_library, recovery};

/// A file, with what an earlier session left of it.
pub(super) fn read_case(path: &Path) -> Msg {
    match read(path) {
        Ok((text, content)) => Msg::FileRead(Box::new(FileRead {
            recovered: recovery::find(path).filter(|recovered| *recovered != text),
            path: path.to_owned(),
            text,
            content,
        })),
        Err(all) => Msg::CaseRejected(path.display().to_string(), case_library::story(path, &all)),
    }
}

/// The text of a file and its result, by the kind of the file.
fn read(path: &Path) -> Result<(String, Content), Vec<Diagnostic>> {
    Ok(match Kind::of(path) {
        Kind::Line => {
            let file = case::load(path)?;
            (file.text, Content::Line(Box::new(LineView::new(file.case))))
        }
        Kind::Section => {
            let file = section::load(path)?;
            (
                file.text,
                Content::Section(Box::new(SectionView::new(file.worked))),
            )
        }
        Kind::Ropeway => {
            let file = ropeway::load(path)?;
            (
                file.text,
                Content::Ropeway(Box::new(RopewayView::new(file.worked))),
            )
        }
        Kind::Ship => {
            let file = ship::load(path)?;
            (
                file.text,
                Content::Ship(Box::new(ShipView::new(file.worked))),
            )
        }
    })
}
