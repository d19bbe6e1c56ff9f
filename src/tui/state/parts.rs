//! Parts of the screen that take more than drawing: views, tables and charts of a model, tables of a run. They are worked out behind
//! the screen where they are seen, and shown with a mark while they are older than what they are of.

use std::sync::Arc;

use crate::chart::Chart;
use crate::line_tables::LineTable;
use crate::run::Run;
use crate::table::{CellStyle, Table};

/// A part of the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScreenPart {
    /// The view of a model.
    Drawing,
    /// A tab of its tables.
    Tab(usize),
    /// A table of a run's line.
    Line(LineTable),
}

/// What a part is of.
#[derive(Debug, Clone)]
pub enum PartOf {
    /// The inputs of a model, and the choice of the user that the part depends on besides.
    Inputs(Arc<()>, u64),
    /// A run, and its name.
    Run(String, Arc<Run>),
}

impl PartialEq for PartOf {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Inputs(a, chosen), Self::Inputs(b, other)) => {
                Arc::ptr_eq(a, b) && chosen == other
            }
            (Self::Run(name, a), Self::Run(other, b)) => name == other && Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

/// A part with what it is of.
#[derive(Debug, Clone, PartialEq)]
pub struct PartKey {
    /// The part.
    pub part: ScreenPart,
    /// What it is of.
    pub of: PartOf,
}

/// What a part shows.
#[derive(Debug, Clone, Default)]
pub struct PartView {
    /// Its chart, where it has one.
    pub chart: Option<Chart>,
    /// Its table.
    pub table: Table,
    /// Limits with what comes nearest to them, above the table.
    pub limits: Option<Table>,
    /// Words beside the chart.
    pub words: Vec<(String, CellStyle)>,
}

/// The parts of a document that are worked out, and those that are being worked out.
#[derive(Debug, Clone, Default)]
pub struct Parts {
    /// The inputs as they are now: another one after every change of them.
    inputs: Arc<()>,
    known: Vec<(PartKey, Arc<PartView>)>,
    asked: Vec<PartKey>,
}

impl Parts {
    /// The inputs have changed: what is known is older.
    pub fn outdate(&mut self) {
        self.inputs = Arc::default();
    }

    /// What a part of the model is of now.
    #[must_use]
    pub fn of_inputs(&self, choice: u64) -> PartOf {
        PartOf::Inputs(Arc::clone(&self.inputs), choice)
    }

    /// What a part showed last.
    #[must_use]
    pub fn last(&self, part: ScreenPart) -> Option<&Arc<PartView>> {
        let known = self.known.iter().find(|(key, _)| key.part == part);
        known.map(|(_, view)| view)
    }

    /// Whether a part is known as it is asked for.
    #[must_use]
    pub fn is_known(&self, key: &PartKey) -> bool {
        self.known.iter().any(|(known, _)| known == key)
    }

    /// Begins to work a part out; false where it is known, or another view of it is being worked out.
    pub fn begin(&mut self, key: &PartKey) -> bool {
        let busy = self.asked.iter().any(|asked| asked.part == key.part);
        if busy || self.is_known(key) {
            return false;
        }
        self.asked.push(key.clone());
        true
    }

    /// Takes a part that was asked for.
    pub fn take(&mut self, key: PartKey, view: Arc<PartView>) {
        let before = self.asked.len();
        self.asked.retain(|asked| *asked != key);
        if self.asked.len() < before {
            self.known.retain(|(known, _)| known.part != key.part);
            self.known.push((key, view));
        }
    }
}
