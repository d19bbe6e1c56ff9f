//! A ropeway on the screen: what it comes to, and where the cargo is.

use std::path::PathBuf;

use super::open_file::{FileView, message_table};
use crate::case::{Diagnostic, kind};
use crate::reference::ValidationRow;
use crate::report::chart::{Chart, Glyphs};
use crate::report::table::Table;
use crate::ropeway::exact::Carrier;
use crate::ropeway::{self, Readings, RopewayFile, Trouble, Worked, held, line, motions, tables};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;

/// Spans that the workbench steps through \[m\]: those of the paper.
pub const SPANS: [f64; 3] = [40.0, 60.0, 80.0];

/// A ropeway.
#[derive(Debug, Clone)]
pub struct RopewayView {
    /// What the text comes to.
    pub worked: Worked,
    /// Where the cargo is, from 0 at the platform to 1 at the ship; the file's own place stays in the file.
    pub position: f64,
    /// The readings there.
    pub readings: Result<Readings, Trouble>,
}

impl RopewayView {
    /// A ropeway as read.
    #[must_use]
    pub fn new(worked: Worked) -> Self {
        let position = worked.ropeway.cargo.position;
        Self {
            readings: worked.readings(position),
            worked,
            position,
        }
    }

    /// Puts the cargo somewhere on the span.
    pub fn put(&mut self, position: f64) {
        self.position = position.clamp(0.0, 1.0);
        self.readings = self.worked.readings(self.position);
    }

    fn winch(&self) -> (Option<Chart>, Table) {
        let Some(series) = self.worked.series() else {
            return (
                None,
                message_table("The file gives the ship no motion; [motion] does."),
            );
        };
        match self.worked.follow(&series) {
            Ok(followed) => (
                Some(motions::winch_chart(&followed)),
                motions::winch(&self.worked, &followed),
            ),
            Err(trouble) => (None, message_table(&format!("No answer: {trouble}."))),
        }
    }
}

impl FileView for RopewayView {
    fn word(&self) -> &'static str {
        "ropeway"
    }

    fn title(&self) -> &str {
        &self.worked.ropeway.about.title
    }

    fn panes(&self) -> &'static [PaneId] {
        &[
            PaneId::Keys,
            PaneId::Ropeway,
            PaneId::Tables,
            PaneId::Checks,
        ]
    }

    fn tabs(&self) -> &'static [&'static str] {
        &["Crossing", "Hauling", "Winch", "Cargo", "Ropes", "Check"]
    }

    fn tab(&self, tab: usize) -> (Option<Chart>, Table) {
        let worked = &self.worked;
        match (tab, &self.readings) {
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
                let none = || message_table("The file has no finite-element check.");
                (None, tables::check(worked, readings).unwrap_or_else(none))
            }
            (_, Err(trouble)) => (None, message_table(&format!("No answer: {trouble}."))),
        }
    }

    fn rows(&self, text: &str) -> Vec<FieldRow> {
        kind::rows::<RopewayFile>(text)
    }

    fn set(&self, text: &str, key: &str, value: &str) -> Result<String, Vec<Diagnostic>> {
        ropeway::edit::set(text, key, value)
    }

    fn passes(&self, text: &str, file: &str) -> Result<(), Vec<Diagnostic>> {
        ropeway::parse(text, file).map(drop)
    }

    fn take(&mut self, text: &str, file: &str) -> Result<(), Vec<Diagnostic>> {
        let worked = ropeway::parse(text, file)?;
        // Where the file's own place changes, the cargo goes there.
        let moved = self.worked.ropeway.cargo.position != worked.ropeway.cargo.position;
        let position = if moved {
            worked.ropeway.cargo.position
        } else {
            self.position
        };
        self.worked = worked;
        self.put(position);
        Ok(())
    }

    fn checks(&self, text: &str) -> Vec<ValidationRow> {
        held::rows(&self.worked, text)
    }

    fn report(&self, text: &str, glyphs: Glyphs) -> Option<String> {
        let readings = self.readings.as_ref().ok()?;
        Some(ropeway::text::text(&self.worked, readings, text, glyphs))
    }

    fn hand_over(&self, stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let readings = self.readings.as_ref().ok();
        let on_rope = readings.filter(|readings| readings.exact.carrier == Carrier::Rope);
        let text = on_rope.map(|readings| {
            line::case_text(
                &self.worked.ropeway,
                readings.length_m,
                readings.exact.arc_m,
            )
        });
        (
            PathBuf::from(format!("{stem}-line.toml")),
            text,
            "The rope with its cargo as a line case",
        )
    }
}
