//! A cross-section that is open: its text and edits, the design, and what the panes show.

use super::sheet::Sheet;
use crate::report::table::Table;
use crate::section::stiffness::Twist;
use crate::section::{Design, tables, text};
use crate::tui::command::Place;
use crate::tui::plot_pane::PlotPane;
use crate::tui::table_pane::TablePane;

/// The tables of a design, in the order in which they are leafed through.
pub const TABLES: [&str; 4] = ["Layers", "Whole", "Stiffness", "Carried"];

/// A cross-section that is open.
#[derive(Debug, Clone)]
pub struct OpenSection {
    /// Its text and fields.
    pub sheet: Sheet,
    /// What the text comes to.
    pub design: Design,
    /// Where the keys go.
    pub pane: Place,
    /// Zoom and pan of the drawing.
    pub view: PlotPane,
    /// The table shown, among [`TABLES`].
    pub table: usize,
    /// Selection, sorting and scrolling of each table.
    pub panes: [TablePane; 4],
}

impl OpenSection {
    /// The table shown.
    #[must_use]
    pub fn shown(&self) -> Table {
        let design = &self.design;
        match self.table {
            0 => tables::layers(design),
            1 => tables::whole(design),
            2 => tables::stiffness(design),
            _ => {
                let core = design.section.about.core;
                tables::carried(design, core, Twist::Held, text::tension(design))
            }
        }
    }
}
