//! A ship on the screen: at rest at once, and at sea from a thread of its own.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::document::{DocumentKind, message_table};
use super::parameter_editor::ParameterEditor;
use crate::case::{Diagnostic, kind};
use crate::numerics::V3;
use crate::reference::ValidationRow;
use crate::report::chart::{Chart, Glyphs};
use crate::report::ship::{charts, coupled, motion, rope, statics, text};
use crate::report::table::Table;
use crate::ship::rope::RopeAnalysis;
use crate::ship::{self, DynamicAnalysis, MotionAnalysis, ShipFile, StaticAnalysis, validation};
use crate::tui::facade::{self, FieldRow};
use crate::tui::pane::PaneId;

/// A ship.
#[derive(Debug, Clone)]
pub struct ShipView {
    /// The ship at rest.
    pub rest: StaticAnalysis,
    /// The ship at sea, of the newest text computed.
    pub sea: Option<Arc<DynamicAnalysis>>,
    /// What stops the thread that works the newest text out; nothing once it has answered.
    pub working: Option<Arc<AtomicBool>>,
    /// The heading shown in full, among all in balance.
    pub equilibrium: usize,
    /// The motion that is drawn alone; none: all six.
    pub trace: Option<usize>,
    /// The validation table.
    pub checks: Vec<ValidationRow>,
}

impl ShipView {
    /// A ship as read, at rest.
    #[must_use]
    pub fn new(rest: StaticAnalysis) -> Self {
        Self {
            equilibrium: text::chosen(&rest),
            rest,
            sea: None,
            working: None,
            trace: None,
            checks: Vec::new(),
        }
    }

    /// Something of the ship at sea, or why there is none yet.
    fn at_sea<'a, T>(
        &'a self,
        of: impl Fn(&'a DynamicAnalysis) -> Option<T>,
        none: &str,
    ) -> Result<T, Table> {
        let wait = || message_table("The ship at sea is still being computed.");
        let sea = self.sea.as_ref().ok_or_else(wait)?;
        of(sea).ok_or_else(|| message_table(none))
    }

    fn motion(&self) -> Result<&MotionAnalysis, Table> {
        let none = "The file gives the ship no motion; [motion] does.";
        match self.at_sea(|sea| sea.motion.as_ref(), none)? {
            Ok(motion) => Ok(motion),
            Err(why) => Err(message_table(&format!("No such motion: {why}."))),
        }
    }

    fn rope(&self) -> Result<&RopeAnalysis, Table> {
        let none = "The file names no rope; [rope] does.";
        match self.at_sea(|sea| sea.rope.as_ref(), none)? {
            Ok(rope) => Ok(rope),
            Err(why) => Err(message_table(&format!(
                "The rope does not follow the ship: {why}."
            ))),
        }
    }

    /// Charts and table of the ship at sea, or why there are none.
    fn sailing(&self, tab: usize) -> Result<(Option<Chart>, Table), Table> {
        let seed = self
            .rest
            .ship
            .motion
            .as_ref()
            .map_or(0, ship::model::Motion::seed);
        Ok(match tab {
            1 => {
                let analysis = self.motion()?;
                let table = motion::statistics(analysis, seed);
                (Some(charts::motions(analysis, self.trace)), table)
            }
            2 => (None, motion::spectra(self.motion()?)),
            3 => {
                let rope = self.rope()?;
                (Some(rope::chart(rope)), rope::table(rope))
            }
            4 => {
                let rope = self.rope()?;
                let none = || message_table("The rope made fast has no answer.");
                let table = rope::dynamic_table(rope).unwrap_or_else(none);
                (rope::dynamic_chart(rope), table)
            }
            _ => {
                let none =
                    "The file does not ask for ship and anchor line in time; [coupled] does.";
                match self.at_sea(|sea| sea.coupled.as_ref(), none)? {
                    Ok(coupled) if tab == 5 => (
                        Some(coupled::motions(coupled)),
                        coupled::statistics(coupled),
                    ),
                    Ok(coupled) => (Some(coupled::tension(coupled)), coupled::decay(coupled)),
                    Err(why) => return Err(message_table(&format!("No answer: {why}."))),
                }
            }
        })
    }
}

impl DocumentKind for ShipView {
    fn word(&self) -> String {
        "ship".to_owned()
    }

    fn title(&self) -> &str {
        &self.rest.ship.particulars.title
    }

    fn panes(&self) -> &'static [PaneId] {
        &[
            PaneId::Inputs,
            PaneId::Ship,
            PaneId::Tables,
            PaneId::Validation,
        ]
    }

    fn tabs(&self) -> &'static [&'static str] {
        &[
            "Headings", "Motion", "Spectra", "Rope", "Inertia", "Time", "Decay", "Swings", "Loads",
            "Mooring",
        ]
    }

    fn tab(&self, tab: usize) -> (Option<Chart>, Table) {
        let rest = &self.rest;
        let or = |table: Option<Table>, words: &str| table.unwrap_or_else(|| message_table(words));
        match tab {
            0 => (Some(charts::moments(rest)), statics::headings(rest)),
            1..=6 => self.sailing(tab).unwrap_or_else(|table| (None, table)),
            7 => {
                let words = "Small motions need [hull], and a [mooring] that reaches.";
                (None, or(statics::small_motions(rest), words))
            }
            8 => (
                None,
                or(statics::loads(rest), "There is no stable heading."),
            ),
            _ => {
                let words = "There is no stable heading, or no [mooring] that reaches.";
                (None, or(statics::mooring(rest), words))
            }
        }
    }

    fn rows(&self, text: &str, _: &ParameterEditor) -> Vec<FieldRow> {
        kind::rows::<ShipFile>(text)
    }

    fn set(&self, text: &str, key: &str, value: &str) -> Result<String, String> {
        ship::edit::set(text, key, value).map_err(|all| facade::refusal(key, &all))
    }

    fn check(&self, text: &str, source: &ParameterEditor) -> Result<(), Vec<Diagnostic>> {
        ship::parse(text, &source.file).map(drop)
    }

    fn read(&mut self, source: &ParameterEditor) -> Result<(), Vec<Diagnostic>> {
        let rest = ship::parse(&source.text, &source.file)?;
        let count = |rest: &StaticAnalysis| rest.equilibria.as_ref().map_or(0, Vec::len);
        if count(&rest) != count(&self.rest) {
            self.equilibrium = text::chosen(&rest);
        }
        self.rest = rest;
        Ok(())
    }

    fn validate(&mut self, _: &ParameterEditor) {
        let motion = self.sea.as_ref().and_then(|sea| sea.motion.as_ref());
        self.checks = validation::rows(&self.rest.ship, motion);
    }

    fn checks(&self) -> &[ValidationRow] {
        &self.checks
    }

    fn stop(&mut self) {
        if let Some(working) = self.working.take() {
            working.store(true, Ordering::Relaxed);
        }
    }

    fn busy(&self) -> Option<&'static str> {
        self.working.as_ref().map(|_| "at sea: working")
    }

    fn report(&self, words: &str, glyphs: Glyphs) -> Option<String> {
        Some(text::text(&self.rest, self.sea.as_deref(), words, glyphs))
    }

    fn line_input(&self, stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let arm = self.rest.ship.motion.as_ref().map(|m| m.hang_point_m);
        let table = self.motion().ok().zip(arm).map(|(motion, arm)| {
            let mut table = String::from("time_s,x_m,y_m,z_m\n");
            for (i, at) in motion
                .point_displacements(&V3::from(arm))
                .iter()
                .enumerate()
            {
                let t = motion.motions.time(i);
                // Writing to a text does not fail.
                let _ = writeln!(table, "{t:?},{:?},{:?},{:?}", at.x, at.y, at.z);
            }
            table
        });
        (
            PathBuf::from(format!("{stem}-hang-point.csv")),
            table,
            "The motion of the hang point, a table for the moving end of a line case,",
        )
    }
}
