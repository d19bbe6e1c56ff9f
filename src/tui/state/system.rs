//! A system of lines on the screen: its result and its validation table.

use std::sync::Arc;

use super::document::DocumentContent;
use super::document_kind::{DocumentKind, KindInfo};
use super::parts::Part;
use super::value_check::ValidationTable;
use crate::case::EditedKey;
use crate::report::chart::Glyphs;
use crate::report::system as views;
use crate::system::analysis::analyses::Analyses;
use crate::system::{SolvedSystem, validation};
use crate::tui::command::{Command, REPORTED};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;

/// A system of lines.
#[derive(Debug, Clone)]
pub struct SystemView {
    /// The result of the text.
    pub solved: Arc<SolvedSystem>,
    /// Its analyses, once they are worked out.
    pub analyses: Option<Arc<Analyses>>,
    /// The validation table.
    pub checks: ValidationTable,
    /// The view shown: from above, from the side, obliquely.
    pub view: usize,
}

impl SystemView {
    /// A system as read.
    #[must_use]
    pub fn new(solved: SolvedSystem) -> Self {
        Self {
            solved: Arc::new(solved),
            analyses: None,
            checks: ValidationTable::default(),
            view: 0,
        }
    }

    /// How many views there are.
    pub const VIEWS: usize = 3;

    /// Shows the view so many further on.
    pub fn turn(&mut self, by: usize) {
        self.view = (self.view + by) % Self::VIEWS;
    }
}

impl DocumentKind for SystemView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "system of lines",
            title: &self.solved.file.about.title,
            source: &self.solved.file.about.source,
            panes: &[
                PaneId::Inputs,
                PaneId::System,
                PaneId::Tables,
                PaneId::Validation,
            ],
            first: PaneId::System,
            tabs: &[
                "Lines",
                "Points",
                "Bodies",
                "Stiffness",
                "Clearances",
                "Periods",
                "Equilibria",
                "Offsets",
                "Watch circle",
                "Goals",
            ],
        }
    }

    fn choice(&self, part: Part) -> u64 {
        match part {
            Part::Drawing => self.view as u64,
            _ => 0,
        }
    }

    fn commands(&self) -> &'static [Command] {
        REPORTED
    }

    fn renew(&mut self, newer: DocumentContent) {
        let DocumentContent::System(newer) = newer else {
            return;
        };
        self.solved = newer.solved;
        self.analyses = newer.analyses;
        self.checks = newer.checks;
    }

    fn validate(&mut self, _text: &str, edited: &[EditedKey]) {
        self.analyses = Some(Arc::new(Analyses::of(&self.solved)));
        let rows = validation::rows(&self.solved, None);
        self.checks = ValidationTable::edited(rows, edited);
    }

    fn checks(&self) -> Option<&ValidationTable> {
        Some(&self.checks)
    }

    fn report(&self, rows: &[FieldRow], glyphs: Glyphs) -> Option<String> {
        let analyses = self.analyses.as_ref()?;
        let report = views::report(&self.solved, analyses, &self.checks.rows, rows, glyphs);
        Some(report)
    }
}
