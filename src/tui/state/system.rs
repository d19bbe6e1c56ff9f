//! A system of lines on the screen: its result and its validation table.

use super::document::DocumentContent;
use super::document_kind::{DocumentKind, KindInfo};
use crate::case::EditedKey;
use crate::reference::{self, ValidationRow};
use crate::report::chart::{Chart, Glyphs};
use crate::report::system::{self as views, analysis, tables};
use crate::report::table::Table;
use crate::system::analysis::periods::periods;
use crate::system::{SolvedSystem, validation};
use crate::tui::command::{Command, REPORTED};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;

/// A system of lines.
#[derive(Debug, Clone)]
pub struct SystemView {
    /// The result of the text.
    pub solved: SolvedSystem,
    /// The validation table.
    pub checks: Vec<ValidationRow>,
    /// The view shown: from above, from the side, obliquely.
    pub view: usize,
}

impl SystemView {
    /// A system as read.
    #[must_use]
    pub fn new(solved: SolvedSystem) -> Self {
        Self {
            solved,
            checks: Vec::new(),
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

impl SystemView {
    fn periods(&self) -> Table {
        match periods(&self.solved.network, &self.solved.rest) {
            Ok(modes) if modes.is_empty() => Table::titled(
                "No body of the system has a mass; add `mass_kg` and `inertia_kg_m2`.",
            ),
            Ok(modes) => analysis::periods(&self.solved, &modes),
            Err(why) => Table::titled(format!("No natural periods: {why}.")),
        }
    }
}

impl SystemView {
    fn offsets(&self) -> (Option<Chart>, Table) {
        match self.solved.analyses.offsets.first() {
            Some(curve) => (
                Some(analysis::offset_chart(curve.heading_deg, &curve.points)),
                analysis::offset_curve(&self.solved, curve),
            ),
            None => {
                let how = "None is asked for; add [[offset_curves]] with heading_deg and to_m.";
                (None, Table::titled(how))
            }
        }
    }

    fn goals(&self) -> Table {
        if self.solved.analyses.goals.is_empty() {
            let how = "None is asked for; add [[goals]] with vary, between, result and value.";
            return Table::titled(how);
        }
        analysis::goals(&self.solved)
    }

    fn watch_circle(&self) -> (Option<Chart>, Table) {
        match self.solved.analyses.circles.first() {
            Some((_, circle)) => (
                Some(analysis::watch_chart(&self.solved, circle)),
                analysis::watch_circle(&self.solved, circle),
            ),
            None => {
                let how = "None is asked for; add [[watch_circles]] with load_n.";
                (None, Table::titled(how))
            }
        }
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

    fn tab(&self, tab: usize) -> (Option<Chart>, Table) {
        let solved = &self.solved;
        match tab {
            0 => (None, tables::lines(solved)),
            1 => (None, tables::points(solved)),
            2 => (None, tables::bodies(solved)),
            4 => (None, analysis::clearances(solved)),
            5 => (None, self.periods()),
            6 => (None, analysis::equilibria(solved)),
            7 => self.offsets(),
            8 => self.watch_circle(),
            9 => (None, self.goals()),
            _ => {
                let first = !solved.network.bodies.is_empty();
                let none = || Table::titled("The system has no body.");
                let table = first.then(|| tables::stiffness(solved, 0));
                (None, table.unwrap_or_else(none))
            }
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
        self.checks = newer.checks;
    }

    fn validate(&mut self, _text: &str, edited: &[EditedKey]) {
        self.checks = validation::rows(&self.solved);
        reference::set_edited_aside(&mut self.checks, edited);
    }

    fn checks(&self) -> &[ValidationRow] {
        &self.checks
    }

    fn report(&self, rows: &[FieldRow], glyphs: Glyphs) -> Option<String> {
        let checks = &self.checks;
        Some(views::report(&self.solved, checks, rows, glyphs))
    }
}
