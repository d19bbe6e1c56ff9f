//! A cross-section on the screen: its drawing, and copying its material.

use std::path::PathBuf;

use super::{charts, export, file};
use crate::report::chart;
use crate::report::section::drawing;
use crate::section;
use crate::tui::command::Id;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::section::PAPER_WIDTH;
use crate::tui::state::{AppState, Content};
use crate::tui::view::layout;

/// What a command does to a cross-section alone; absent: the same as to every file.
pub(super) fn command(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let glyphs = state.capabilities.glyphs;
    let area = layout::drawing_area(state);
    let open = state.file.as_mut()?;
    let path = PathBuf::from(format!("{}-drawing.txt", file::stem(open)));
    let drawn = open.pane == PaneId::Drawing;
    let Content::Section(section) = &mut open.content else {
        return None;
    };
    match id {
        Id::Copy => Some(vec![Effect::Copy(section::fragment(&section.design))]),
        Id::Write if drawn => {
            let base = section.view.chart(&drawing::chart(&section.design));
            let text = chart::draw(&base, PAPER_WIDTH, PAPER_WIDTH / 2, glyphs).to_text();
            Some(export::write(path, Some(text), "The drawing"))
        }
        _ if drawn => {
            let verb = charts::verb(id)?;
            let base = drawing::chart(&section.design);
            let size = (area.width.into(), area.height.into());
            let frame = chart::frame(&section.view.chart(&base), size.0, size.1, glyphs);
            section.view.act(&verb, &base, frame);
            Some(Vec::new())
        }
        _ => None,
    }
}
