//! A ropeway on the screen: its result, and the position of the cargo.

use std::path::PathBuf;

use super::document::DocumentContent;
use super::document_kind::{DocumentKind, KindInfo};
use crate::case::EditedKey;
use crate::reference::{self, ValidationRow};
use crate::report::chart::{Chart, Glyphs};
use crate::report::ropeway::{self as views, cargo, tables, winch};
use crate::report::table::Table;
use crate::ropeway::elastic::Carrier;
use crate::ropeway::{ModelResults, RopewayError, SolvedRopeway, line, validation};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;

/// A ropeway.
#[derive(Debug, Clone)]
pub struct RopewayView {
    /// The result of the text.
    pub worked: SolvedRopeway,
    /// Where the cargo is, from 0 at the platform to 1 at the ship; the file's own place stays in the file.
    pub position: f64,
    /// The results there.
    pub results: Result<ModelResults, RopewayError>,
    /// The validation table.
    pub checks: Vec<ValidationRow>,
}

impl RopewayView {
    /// A ropeway as read.
    #[must_use]
    pub fn new(worked: SolvedRopeway) -> Self {
        let position = worked.ropeway.cargo.position;
        Self {
            results: worked.results(position),
            worked,
            position,
            checks: Vec::new(),
        }
    }

    /// Puts the cargo somewhere on the span.
    pub fn put(&mut self, position: f64) {
        self.position = position.clamp(0.0, 1.0);
        self.results = self.worked.results(self.position);
    }

    fn winch(&self) -> (Option<Chart>, Table) {
        let Some(series) = self.worked.ship_motion() else {
            return (None, Table::titled("The ship does not move; add [motion]."));
        };
        match self.worked.run_winch(&series) {
            Ok(followed) => (
                Some(winch::winch_chart(&followed)),
                winch::winch(&self.worked, &followed),
            ),
            Err(error) => (None, Table::titled(format!("No solution: {error}."))),
        }
    }
}

impl DocumentKind for RopewayView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "ropeway",
            title: &self.worked.ropeway.about.title,
            source: &self.worked.ropeway.about.source,
            panes: &[
                PaneId::Inputs,
                PaneId::Ropeway,
                PaneId::Tables,
                PaneId::Validation,
            ],
            first: PaneId::Ropeway,
            tabs: &["Crossing", "Hauling", "Winch", "Cargo", "Ropes", "Check"],
        }
    }

    fn tab(&self, tab: usize) -> (Option<Chart>, Table) {
        let worked = &self.worked;
        match (tab, &self.results) {
            (0, _) => (None, tables::crossing(worked, 20)),
            (1, _) => (Some(winch::hauling_chart(worked)), winch::hauling(worked)),
            (2, _) => self.winch(),
            (3, _) => (Some(cargo::crossing_chart(worked)), cargo::cargo(worked)),
            (4, Ok(results)) => (None, tables::ropes(worked, results)),
            (4, Err(error)) => (None, Table::titled(format!("No solution: {error}."))),
            _ => {
                let none = || Table::titled("The file has no finite-element check.");
                (None, tables::weight_check(worked).unwrap_or_else(none))
            }
        }
    }

    fn renew(&mut self, newer: DocumentContent) {
        let DocumentContent::Ropeway(newer) = newer else {
            return;
        };
        // Where the file's own place changes, the cargo goes there.
        let moved = self.worked.ropeway.cargo.position != newer.worked.ropeway.cargo.position;
        let position = if moved {
            newer.worked.ropeway.cargo.position
        } else {
            self.position
        };
        self.worked = newer.worked;
        self.checks = newer.checks;
        self.put(position);
    }

    fn validate(&mut self, text: &str, edited: &[EditedKey]) {
        self.checks = validation::rows(&self.worked, text);
        reference::set_edited_aside(&mut self.checks, edited);
    }

    fn checks(&self) -> &[ValidationRow] {
        &self.checks
    }

    fn report(&self, rows: &[FieldRow], glyphs: Glyphs) -> Option<String> {
        let results = self.results.as_ref().ok()?;
        Some(views::report(&self.worked, results, rows, glyphs))
    }

    fn line_input(&self, stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let results = self.results.as_ref().ok();
        let on_rope = results.filter(|results| results.exact.carrier == Carrier::Rope);
        let text = on_rope.map(|results| {
            line::static_case_file(&self.worked.ropeway, results.length_m, results.exact.arc_m)
        });
        (
            PathBuf::from(format!("{stem}-line.toml")),
            text,
            "The rope with its cargo as a line case",
        )
    }
}
