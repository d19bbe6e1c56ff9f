//! A cross-section on the screen: its panes, its drawing, its tables, and handing it over to a line.

use std::path::PathBuf;

use super::{charts, edit, overlay, runs};
use crate::report::chart;
use crate::section::{self, picture};
use crate::tui::command::{Id, Place};
use crate::tui::msg::{Effect, SectionRead};
use crate::tui::plot_pane::PlotPane;
use crate::tui::state::section::TABLES;
use crate::tui::state::{OpenSection, Overlay, Question, Sheet, State};
use crate::tui::view::layout;

/// Columns of what is written to a file.
const PAPER_WIDTH: usize = 100;

pub(super) fn opened(state: &mut State, read: SectionRead) -> Vec<Effect> {
    state.open = None;
    state.ropeway = None;
    state.section = Some(OpenSection {
        sheet: Sheet::new(read.path, read.text),
        design: read.design,
        pane: Place::Keys,
        view: PlotPane::default(),
        table: 0,
        panes: Default::default(),
    });
    edit::refresh(state);
    if let Some(text) = read.recovered {
        state.overlay = Some(Overlay::Ask(Question::Recover { text }));
    }
    Vec::new()
}

/// What a command does to a cross-section; absent: the same as everywhere.
pub(super) fn command(state: &mut State, id: Id) -> Option<Vec<Effect>> {
    let glyphs = state.looks.glyphs;
    let area = layout::drawing_area(state);
    let section = state.section.as_mut()?;
    let leaf = |by: usize| (section.table + by) % TABLES.len();
    match id {
        Id::NextTable => section.table = leaf(1),
        Id::PreviousTable => section.table = leaf(TABLES.len() - 1),
        Id::ScrollLeft | Id::ScrollRight | Id::Sort => {
            let table = section.shown();
            section.panes[section.table].act(runs::table_verb(id), &table);
        }
        Id::Material => return Some(material(section)),
        Id::Copy => return Some(vec![Effect::Copy(section::fragment(&section.design))]),
        Id::Write => return Some(write(section, glyphs)),
        _ => {
            let verb = charts::verb(id)?;
            let base = picture::chart(&section.design);
            let size = (area.width.into(), area.height.into());
            let frame = chart::frame(&section.view.chart(&base), size.0, size.1, glyphs);
            section.view.act(&verb, &base, frame);
        }
    }
    Some(Vec::new())
}

/// Hands the section over: the table that a line case takes, in a file of its own.
fn material(section: &OpenSection) -> Vec<Effect> {
    let name = &section.design.section.about.name;
    runs::write(
        PathBuf::from(format!("{name}-material.txt")),
        Some(section::fragment(&section.design)),
        "The table [materials] for a line case",
    )
}

/// Writes the drawing alone from its pane, drawing and all tables from any other.
fn write(section: &OpenSection, glyphs: chart::Glyphs) -> Vec<Effect> {
    let stem = section.sheet.file.trim_end_matches(".toml");
    if section.pane == Place::Drawing {
        let base = section.view.chart(&picture::chart(&section.design));
        let text = chart::draw(&base, PAPER_WIDTH, PAPER_WIDTH / 2, glyphs).to_text();
        let path = PathBuf::from(format!("{stem}-drawing.txt"));
        return runs::write(path, Some(text), "The drawing");
    }
    let text = section::text::text(&section.design, PAPER_WIDTH, glyphs, None);
    let path = PathBuf::from(format!("{stem}-tables.txt"));
    runs::write(path, Some(text), "The cross-section with its tables")
}

/// Goes to another pane.
pub(super) fn pane(state: &mut State, id: Id) -> Vec<Effect> {
    if let Some(section) = &mut state.section {
        let panes = Place::OF_SECTION;
        let now = panes.iter().position(|p| *p == section.pane).unwrap_or(0);
        section.pane = panes[match id {
            Id::NextPane => (now + 1) % panes.len(),
            Id::PreviousPane => (now + panes.len() - 1) % panes.len(),
            Id::Pane(n) => usize::from(n.saturating_sub(1)).min(panes.len() - 1),
            _ => now,
        }];
    }
    Vec::new()
}

/// Moves the cursor of the pane.
pub(super) fn move_by(state: &mut State, by: isize) -> Vec<Effect> {
    if let Some(section) = &mut state.section {
        if section.pane == Place::Tables {
            let table = section.shown();
            section.panes[section.table].act(overlay::by_rows(by), &table);
        } else {
            let sheet = &mut section.sheet;
            sheet.field = super::moved(sheet.field, by, sheet.fields().count());
        }
    }
    Vec::new()
}
