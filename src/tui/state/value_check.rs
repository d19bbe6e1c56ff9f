//! Runs of a line case compared with its published values, behind the screen.

use std::sync::Arc;

use crate::case::{Case, EditedKey, StudyPoint};
use crate::facade::{self, ValidationRow};
use crate::reference;
use crate::run::Run;
use crate::table::Table;

/// Whether the validation table is being made.
#[derive(Debug, Clone, Default)]
pub struct Checking {
    /// True when it is older than the runs or the text.
    pub is_due: bool,
    /// The comparison under way.
    pub asked: Option<Arc<()>>,
}

impl Checking {
    /// Whether the table is older than the runs or the text.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        self.is_due || self.asked.is_some()
    }
}

/// Rows of a validation table, and the table as it is shown.
#[derive(Debug, Clone, Default)]
pub struct ValidationTable {
    /// The rows.
    pub rows: Vec<ValidationRow>,
    /// The table.
    pub table: Table,
}

impl ValidationTable {
    /// The table of these rows.
    #[must_use]
    pub fn new(rows: Vec<ValidationRow>) -> Self {
        Self {
            table: reference::table(&rows),
            rows,
        }
    }

    /// The table of these rows, of which the inputs of the user do not count as published.
    #[must_use]
    pub fn edited(mut rows: Vec<ValidationRow>, edited: &[EditedKey]) -> Self {
        reference::set_edited_aside(&mut rows, edited);
        Self::new(rows)
    }
}

/// A comparison that is asked for.
#[derive(Debug, Clone)]
pub struct ValueCheck {
    /// Tells it from others.
    pub token: Arc<()>,
    /// The case.
    pub case: Box<Case>,
    /// The inputs that are the user's.
    pub edited: Vec<EditedKey>,
    /// The runs, by their points.
    pub runs: Vec<(Option<StudyPoint>, Arc<Run>)>,
}

impl ValueCheck {
    /// The validation table.
    #[must_use]
    pub fn table(&self) -> ValidationTable {
        ValidationTable::new(facade::checks(&self.case, &self.edited, &self.runs))
    }
}
