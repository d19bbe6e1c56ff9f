//! A system of lines on the screen: its result and its validation table.

use std::sync::Arc;

use super::document::DocumentContent;
use super::document_kind::{DocumentKind, KindInfo};
use crate::case::EditedKey;
use crate::reference::{self, ValidationRow};
use crate::report::chart::{Chart, Glyphs};
use crate::report::system::{self as views, analysis, tables};
use crate::report::table::Table;
use crate::system::analysis::analyses::{Analyses, OffsetCurve};
use crate::system::analysis::periods::SystemMode;
use crate::system::analysis::watch_circle::WatchCircle;
use crate::system::{SolvedSystem, validation};
use crate::tui::command::{Command, REPORTED};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;

/// Numbers of the tabs of analyses.
const CLEARANCES: usize = 4;
const PERIODS: usize = 5;
const EQUILIBRIA: usize = 6;
const OFFSETS: usize = 7;
const WATCH_CIRCLE: usize = 8;

/// A system of lines.
#[derive(Debug, Clone)]
pub struct SystemView {
    /// The result of the text.
    pub solved: SolvedSystem,
    /// Its analyses, once they are worked out.
    pub analyses: Option<Arc<Analyses>>,
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
            analyses: None,
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
    /// The table of a tab of the analyses, once they are worked out.
    fn analysis(&self, tab: usize) -> (Option<Chart>, Table) {
        let Some(analyses) = &self.analyses else {
            return (None, Table::titled("Not worked out yet."));
        };
        match tab {
            CLEARANCES => {
                let table = analysis::clearances(&self.solved, &analyses.clearances);
                (None, table)
            }
            PERIODS => (None, self.periods(&analyses.periods)),
            EQUILIBRIA => {
                let table = analysis::equilibria(&self.solved, &analyses.others);
                (None, table)
            }
            OFFSETS => self.offsets(&analyses.offsets),
            WATCH_CIRCLE => self.watch_circle(&analyses.circles),
            _ if analyses.goals.is_empty() => (None, none_asked("[[goals]]")),
            _ => (None, analysis::goals(&analyses.goals)),
        }
    }

    fn periods(&self, periods: &Result<Vec<SystemMode>, String>) -> Table {
        match periods {
            Ok(modes) if modes.is_empty() => Table::titled(
                "No body and no free point of the system has a mass; add `mass_kg` and `inertia_kg_m2`.",
            ),
            Ok(modes) => analysis::periods(&self.solved, modes),
            Err(why) => Table::titled(format!("No natural periods: {why}.")),
        }
    }

    fn offsets(&self, curves: &[OffsetCurve]) -> (Option<Chart>, Table) {
        let Some(curve) = curves.first() else {
            return (None, none_asked("[[offset_curves]]"));
        };
        let chart = analysis::offset_chart(curve.heading_deg, &curve.points);
        let table = analysis::offset_curve(&self.solved, curve);
        (Some(chart), with_rest_in_report(table, curves.len()))
    }

    fn watch_circle(&self, circles: &[(usize, WatchCircle)]) -> (Option<Chart>, Table) {
        let Some((_, circle)) = circles.first() else {
            return (None, none_asked("[[watch_circles]]"));
        };
        let chart = analysis::watch_chart(&self.solved, circle);
        let table = analysis::watch_circle(&self.solved, circle);
        (Some(chart), with_rest_in_report(table, circles.len()))
    }
}

fn none_asked(table: &str) -> Table {
    Table::titled(format!("The file asks for none; add {table} to it."))
}

/// The tab shows the first of several; the table says where the others are.
fn with_rest_in_report(mut table: Table, count: usize) -> Table {
    if count > 1 {
        let note = format!("The first of {count}; the report has all.");
        table.notes.push(note);
    }
    table
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
            CLEARANCES.. => self.analysis(tab),
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
        self.analyses = newer.analyses;
        self.checks = newer.checks;
    }

    fn validate(&mut self, _text: &str, edited: &[EditedKey]) {
        self.analyses = Some(Arc::new(Analyses::of(&self.solved)));
        self.checks = validation::rows(&self.solved);
        reference::set_edited_aside(&mut self.checks, edited);
    }

    fn checks(&self) -> &[ValidationRow] {
        &self.checks
    }

    fn report(&self, rows: &[FieldRow], glyphs: Glyphs) -> Option<String> {
        let analyses = self.analyses.as_ref()?;
        let report = views::report(&self.solved, analyses, &self.checks, rows, glyphs);
        Some(report)
    }
}
