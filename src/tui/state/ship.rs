//! A ship on the screen: its static analysis at once, its dynamic analysis from a thread of its own.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::document::DocumentContent;
use super::document_kind::{DocumentKind, KindInfo};
use crate::case::EditedKey;
use crate::numerics::V3;
use crate::reference::{self, ValidationRow};
use crate::report::chart::{Chart, Glyphs};
use crate::report::ship::{coupled, motion, rope, statics, text};
use crate::report::table::Table;
use crate::ship::rope::RopeAnalysis;
use crate::ship::{self, DynamicAnalysis, MotionAnalysis, StaticAnalysis, validation};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;

/// A ship.
#[derive(Debug, Clone)]
pub struct ShipView {
    /// Its static analysis.
    pub statics: StaticAnalysis,
    /// Its dynamic analysis, of the newest text that was analysed.
    pub dynamic: Option<Arc<DynamicAnalysis>>,
    /// Stops the dynamic analysis of the newest text; none once it is complete.
    pub running: Option<Arc<AtomicBool>>,
    /// Index of the equilibrium shown in full.
    pub equilibrium: usize,
    /// The motion that is drawn alone; none: all six.
    pub trace: Option<usize>,
    /// The validation table.
    pub checks: Vec<ValidationRow>,
}

/// The tab of its motions.
pub const MOTIONS: usize = 1;

impl ShipView {
    /// A ship as read, without a dynamic analysis yet.
    #[must_use]
    pub fn new(statics: StaticAnalysis) -> Self {
        Self {
            equilibrium: text::governing(&statics),
            statics,
            dynamic: None,
            running: None,
            trace: None,
            checks: Vec::new(),
        }
    }

    /// Whether its motion in the sea is computed.
    #[must_use]
    pub fn has_motion(&self) -> bool {
        self.motion().is_ok()
    }

    /// A part of the dynamic analysis, or why there is none.
    fn part<'a, T>(
        &'a self,
        of: impl Fn(&'a DynamicAnalysis) -> Option<T>,
        none: &str,
    ) -> Result<T, Table> {
        let wait = || Table::titled("The dynamic analysis is still running.");
        let dynamic = self.dynamic.as_ref().ok_or_else(wait)?;
        of(dynamic).ok_or_else(|| Table::titled(none))
    }

    fn motion(&self) -> Result<&MotionAnalysis, Table> {
        let none = "No motion analysis: the file has no [motion].";
        match self.part(|dynamic| dynamic.motion.as_ref(), none)? {
            Ok(motion) => Ok(motion),
            Err(error) => Err(Table::titled(format!(
                "The motion analysis failed: {error}."
            ))),
        }
    }

    fn rope(&self) -> Result<&RopeAnalysis, Table> {
        let none = "No rope analysis: the file has no [rope].";
        match self.part(|dynamic| dynamic.rope.as_ref(), none)? {
            Ok(rope) => Ok(rope),
            Err(error) => Err(Table::titled(format!("The rope analysis failed: {error}."))),
        }
    }

    /// Chart and table of the dynamic analysis, or why there are none.
    fn dynamic_tab(&self, tab: usize) -> Result<(Option<Chart>, Table), Table> {
        let seed = self
            .statics
            .ship
            .motion
            .as_ref()
            .map_or(0, ship::model::MotionSettings::seed);
        Ok(match tab {
            MOTIONS => {
                let analysis = self.motion()?;
                let table = motion::statistics(analysis, seed);
                (Some(motion::motions(analysis, self.trace)), table)
            }
            2 => (None, motion::spectra(self.motion()?)),
            3 => {
                let rope = self.rope()?;
                (Some(rope::chart(rope)), rope::table(rope))
            }
            4 => {
                let rope = self.rope()?;
                let none = || Table::titled("The rope made fast has no solution.");
                let table = rope::dynamic_table(rope).unwrap_or_else(none);
                (rope::dynamic_chart(rope), table)
            }
            _ => {
                let none = "No coupled analysis: the file has no [coupled].";
                match self.part(|dynamic| dynamic.coupled.as_ref(), none)? {
                    Ok(coupled) if tab == 5 => (
                        Some(coupled::motions(coupled)),
                        coupled::statistics(coupled),
                    ),
                    Ok(coupled) => (Some(coupled::tension(coupled)), coupled::decay(coupled)),
                    Err(error) => {
                        return Err(Table::titled(format!(
                            "The coupled analysis failed: {error}."
                        )));
                    }
                }
            }
        })
    }
}

impl DocumentKind for ShipView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "ship",
            title: &self.statics.ship.ship.title,
            source: &self.statics.ship.ship.source,
            panes: &[
                PaneId::Inputs,
                PaneId::Ship,
                PaneId::Tables,
                PaneId::Validation,
            ],
            first: PaneId::Ship,
            tabs: &[
                "Headings",
                "Motion",
                "Spectra",
                "Rope",
                "Inertia",
                "Coupled",
                "Decay",
                "Stability",
                "Loads",
                "Mooring",
            ],
        }
    }

    fn tab(&self, tab: usize) -> (Option<Chart>, Table) {
        let statics = &self.statics;
        let or = |table: Option<Table>, words: &str| table.unwrap_or_else(|| Table::titled(words));
        match tab {
            0 => (Some(statics::moments(statics)), statics::headings(statics)),
            1..=6 => self.dynamic_tab(tab).unwrap_or_else(|table| (None, table)),
            7 => {
                let words = "Dynamic stability needs [hull], and [mooring] with a solution.";
                (None, or(statics::eigenvalues(statics), words))
            }
            8 => (
                None,
                or(statics::loads(statics), "There is no stable equilibrium."),
            ),
            _ => {
                let words = "There is no stable equilibrium, or no [mooring] with a solution.";
                (None, or(statics::mooring(statics), words))
            }
        }
    }

    fn renew(&mut self, newer: DocumentContent) {
        let DocumentContent::Ship(newer) = newer else {
            return;
        };
        let count = |statics: &StaticAnalysis| statics.equilibria.as_ref().map_or(0, Vec::len);
        if count(&newer.statics) != count(&self.statics) {
            self.equilibrium = newer.equilibrium;
        }
        self.statics = newer.statics;
    }

    fn validate(&mut self, _text: &str, edited: &[EditedKey]) {
        let motion = self
            .dynamic
            .as_ref()
            .and_then(|dynamic| dynamic.motion.as_ref());
        self.checks = validation::rows(&self.statics.ship, motion);
        reference::set_edited_aside(&mut self.checks, edited);
    }

    fn checks(&self) -> &[ValidationRow] {
        &self.checks
    }

    fn stop(&mut self) {
        if let Some(running) = self.running.take() {
            running.store(true, Ordering::Relaxed);
        }
    }

    fn busy(&self) -> Option<&'static str> {
        self.running.as_ref().map(|_| "dynamic analysis: running")
    }

    fn report(&self, rows: &[FieldRow], glyphs: Glyphs) -> Option<String> {
        Some(text::text(
            &self.statics,
            self.dynamic.as_deref(),
            rows,
            glyphs,
        ))
    }

    fn line_input(&self, stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let arm = self.statics.ship.motion.as_ref().map(|m| m.hang_point_m);
        let table = self.motion().ok().zip(arm).map(|(motion, arm)| {
            let mut table = String::from("time_s,x_m,y_m,z_m\n");
            for (i, at) in motion
                .point_displacements(&V3::from(arm))
                .iter()
                .enumerate()
            {
                let t = motion.motion.time(i);
                // Writing to a text does not fail.
                let _ = writeln!(table, "{t:?},{:?},{:?},{:?}", at.x, at.y, at.z);
            }
            table
        });
        (
            PathBuf::from(format!("{stem}-hang-off-point.csv")),
            table,
            "The motion of the hang-off point, a table for the moving end of a line case,",
        )
    }
}
