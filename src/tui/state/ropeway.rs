//! A ropeway on the screen: its result, and the position of the cargo.

use std::path::PathBuf;
use std::sync::Arc;

use super::document_kind::{DocumentKind, KindInfo};
use super::parts::ScreenPart;
use super::value_check::ValidationTable;
use crate::case::EditedKey;
use crate::facade::FieldRow;
use crate::pane::PaneId;
use crate::report::subject::ReportSubject;
use crate::ropeway::elastic::Carrier;
use crate::ropeway::{ModelResults, RopewayError, SolvedRopeway, line, validation};

/// The tab of its ropes, which the position of the cargo loads.
const ROPES: usize = 4;

/// A ropeway.
#[derive(Debug, Clone)]
pub struct RopewayView {
    /// The result of the text.
    pub worked: Arc<SolvedRopeway>,
    /// Where the cargo is, from 0 at the platform to 1 at the ship; the file's own place stays in the file.
    pub position: f64,
    /// The validation table.
    pub checks: ValidationTable,
}

impl RopewayView {
    /// A ropeway as read.
    #[must_use]
    pub fn new(worked: SolvedRopeway) -> Self {
        Self {
            position: worked.ropeway.cargo.position,
            worked: Arc::new(worked),
            checks: ValidationTable::default(),
        }
    }

    /// Puts the cargo somewhere on the span.
    pub fn put(&mut self, position: f64) {
        self.position = position.clamp(0.0, 1.0);
    }

    /// The results with the cargo there; for the threads behind the screen.
    ///
    /// # Errors
    /// No solution at this position.
    pub fn results(&self) -> Result<ModelResults, RopewayError> {
        self.worked.results(self.position)
    }
}

impl RopewayView {
    /// Replaces the result by that of a newer text; what the user looks at stays.
    pub(super) fn renew(&mut self, newer: Self) {
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

    fn choice(&self, part: ScreenPart) -> u64 {
        match part {
            ScreenPart::Drawing | ScreenPart::Tab(ROPES) => self.position.to_bits(),
            _ => 0,
        }
    }

    fn validate(&mut self, text: &str, edited: &[EditedKey]) {
        let rows = validation::rows(&self.worked, text);
        self.checks = ValidationTable::edited(rows, edited);
    }

    fn checks(&self) -> Option<&ValidationTable> {
        Some(&self.checks)
    }

    fn report<'a>(&'a self, rows: &'a [FieldRow]) -> Option<ReportSubject<'a>> {
        let results = Box::new(self.results().ok()?);
        Some(ReportSubject::Ropeway(&self.worked, results, rows))
    }

    fn line_input(&self, stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let results = self.results().ok();
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
