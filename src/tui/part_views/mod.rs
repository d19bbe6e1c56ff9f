//! What the parts of the screen show that take more than drawing. Nothing here is called on the drawing thread: see
//! [`ScreenPart`].

pub mod line;
mod part_view;
pub mod ropeway;
pub mod section;
pub mod ship;
pub mod system;

use super::state::DocumentContent;
use super::state::part_request::PartRequest;
use super::state::parts::{PartOf, PartView, ScreenPart};

/// A part of a model.
#[must_use]
pub fn of_model(model: &DocumentContent, part: ScreenPart) -> PartView {
    match model {
        DocumentContent::Section(section) => section::view(section, part),
        DocumentContent::Ropeway(ropeway) => ropeway::view(ropeway, part),
        DocumentContent::Ship(ship) => ship::view(ship, part),
        DocumentContent::System(system) => system::view(system, part),
        DocumentContent::Line(_) => PartView::default(),
    }
}

impl PartRequest {
    /// Works the part out.
    #[must_use]
    pub fn view(&self) -> PartView {
        match (&self.key.of, self.key.part, &self.model) {
            (PartOf::Run(name, run), ScreenPart::Line(table), _) => line::view(name, run, table),
            (_, part, Some(model)) => of_model(model, part),
            _ => PartView::default(),
        }
    }
}
