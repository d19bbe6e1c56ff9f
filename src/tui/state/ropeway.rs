//! A ropeway that is open: its text and edits, what it comes to, where the cargo is, and what the panes show.

use super::sheet::Sheet;
use crate::report::chart::Chart;
use crate::report::table::Table;
use crate::ropeway::{Readings, Trouble, Worked, motions, tables};
use crate::tui::backend::Row;
use crate::tui::command::Place;
use crate::tui::table_pane::TablePane;

/// The leaves of the tables pane, in the order in which they are leafed through.
pub const LEAVES: [&str; 6] = ["Crossing", "Hauling", "Winch", "Cargo", "Ropes", "Check"];

/// Spans that the workbench steps through \[m\]: those of the paper.
pub const SPANS: [f64; 3] = [40.0, 60.0, 80.0];

/// A ropeway that is open.
#[derive(Debug, Clone)]
pub struct OpenRopeway {
    /// Its text and fields.
    pub sheet: Sheet,
    /// What the text comes to.
    pub worked: Worked,
    /// Where the cargo is, from 0 at the platform to 1 at the ship; the file's own place stays in the file.
    pub position: f64,
    /// The readings there.
    pub readings: Result<Readings, Trouble>,
    /// Where the keys go.
    pub pane: Place,
    /// The leaf shown, among [`LEAVES`].
    pub leaf: usize,
    /// Selection, sorting and scrolling of each leaf.
    pub panes: [TablePane; 6],
    /// The validation table.
    pub checks: Vec<Row>,
    /// Selection, sorting and scrolling of it.
    pub checks_pane: TablePane,
}

impl OpenRopeway {
    /// A ropeway as read, with its fields still to be listed.
    #[must_use]
    pub fn new(sheet: Sheet, worked: Worked) -> Self {
        let position = worked.ropeway.cargo.position;
        Self {
            readings: worked.readings(position),
            checks: Vec::new(),
            sheet,
            worked,
            position,
            pane: Place::Ropeway,
            leaf: 0,
            panes: Default::default(),
            checks_pane: TablePane::default(),
        }
    }

    /// Puts the cargo somewhere on the span.
    pub fn put(&mut self, position: f64) {
        self.position = position.clamp(0.0, 1.0);
        self.readings = self.worked.readings(self.position);
    }

    /// The leaf shown: its chart, where it has one, and its table.
    #[must_use]
    pub fn shown(&self) -> (Option<Chart>, Table) {
        let worked = &self.worked;
        match (self.leaf, &self.readings) {
            (0, _) => (None, tables::crossing(worked, 20)),
            (1, _) => (
                Some(motions::hauling_chart(worked)),
                motions::hauling(worked),
            ),
            (2, _) => self.winch(),
            (3, _) => (
                Some(motions::crossing_chart(worked)),
                motions::cargo(worked),
            ),
            (4, Ok(readings)) => (None, tables::ropes(worked, readings)),
            (_, Ok(readings)) => {
                let none = || said("The file has no finite-element check.");
                (None, tables::check(worked, readings).unwrap_or_else(none))
            }
            (_, Err(trouble)) => (None, said(&format!("No answer: {trouble}."))),
        }
    }

    fn winch(&self) -> (Option<Chart>, Table) {
        let Some(series) = self.worked.series() else {
            return (
                None,
                said("The file gives the ship no motion; [motion] does."),
            );
        };
        match self.worked.follow(&series) {
            Ok(followed) => (
                Some(motions::winch_chart(&followed)),
                motions::winch(&self.worked, &followed),
            ),
            Err(trouble) => (None, said(&format!("No answer: {trouble}."))),
        }
    }
}

/// A table that only says something.
fn said(words: &str) -> Table {
    Table {
        title: words.to_owned(),
        ..Table::default()
    }
}
