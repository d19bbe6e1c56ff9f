//! A file read as what it is: a line case, a cross-section, a ropeway, a ship.

use std::path::Path;

use super::state::{Content, LineView, RopewayView, SectionView, ShipView};
use crate::case::{self, Diagnostic};
use crate::kinds::Kind;
use crate::ropeway;
use crate::section;
use crate::ship;

/// The text of a file and its result, by the kind of the file.
pub(super) fn read(path: &Path) -> Result<(String, Content), Vec<Diagnostic>> {
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
