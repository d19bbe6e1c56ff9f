//! A ship on the screen: its static analysis at once, its dynamic analysis from a thread of its own.

use std::fmt::Write;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::document_kind::{DocumentKind, KindInfo};
use super::parts::ScreenPart;
use super::value_check::ValidationTable;
use crate::case::EditedKey;
use crate::facade::FieldRow;
use crate::numerics::V3;
use crate::pane::PaneId;
use crate::report::ship as views;
use crate::report::subject::ReportSubject;
use crate::ship::{DynamicAnalysis, MotionAnalysis, StaticAnalysis, validation};

/// A ship.
#[derive(Debug, Clone)]
pub struct ShipView {
    /// Its static analysis.
    pub statics: Arc<StaticAnalysis>,
    /// Its dynamic analysis, of the newest text that was analysed.
    pub dynamic: Option<Arc<DynamicAnalysis>>,
    /// Stops the dynamic analysis of the newest text; none once it is complete.
    pub running: Option<Arc<AtomicBool>>,
    /// Index of the equilibrium shown in full.
    pub equilibrium: usize,
    /// The motion that is drawn alone; none: all six.
    pub trace: Option<usize>,
    /// The validation table.
    pub checks: ValidationTable,
}

/// The tab of its motions.
pub const MOTIONS: usize = 1;

/// The tabs of its dynamic analysis.
pub const AT_SEA: RangeInclusive<usize> = 1..=6;

/// The validation table of a ship, of whose inputs these are the user's.
fn checks(
    statics: &StaticAnalysis,
    dynamic: Option<&DynamicAnalysis>,
    edited: &[EditedKey],
) -> ValidationTable {
    let motion = dynamic.and_then(|dynamic| dynamic.motion.as_ref());
    ValidationTable::edited(validation::rows(&statics.ship, motion), edited)
}

/// A ship that is to be computed at sea.
#[derive(Debug, Clone)]
pub struct ShipAtSea {
    /// Its static analysis.
    pub statics: Arc<StaticAnalysis>,
    /// The folder of its file.
    pub folder: PathBuf,
    /// The inputs that are the user's.
    pub edited: Vec<EditedKey>,
    /// Stops the computation, and tells it from others.
    pub stop: Arc<AtomicBool>,
}

impl ShipAtSea {
    /// Its dynamic analysis with the validation table; nothing where it was stopped.
    #[must_use]
    pub fn computed(&self) -> Option<(Arc<DynamicAnalysis>, Box<ValidationTable>)> {
        let dynamic = DynamicAnalysis::new(&self.statics, &self.folder, &self.stop)?;
        let table = checks(&self.statics, Some(&dynamic), &self.edited);
        Some((Arc::new(dynamic), Box::new(table)))
    }
}

impl ShipView {
    /// A ship as read, without a dynamic analysis yet.
    #[must_use]
    pub fn new(statics: StaticAnalysis) -> Self {
        Self {
            equilibrium: views::governing(&statics),
            statics: Arc::new(statics),
            dynamic: None,
            running: None,
            trace: None,
            checks: ValidationTable::default(),
        }
    }

    /// Its motion in the sea, where that is computed.
    fn motion(&self) -> Option<&MotionAnalysis> {
        let dynamic = self.dynamic.as_ref()?;
        dynamic.motion.as_ref()?.as_ref().ok()
    }

    /// Whether its motion in the sea is computed.
    #[must_use]
    pub fn has_motion(&self) -> bool {
        self.motion().is_some()
    }
}

impl ShipView {
    /// Replaces the result by that of a newer text; what the user looks at stays.
    pub(super) fn renew(&mut self, newer: Self) {
        let count = |statics: &StaticAnalysis| statics.equilibria.as_ref().map_or(0, Vec::len);
        if count(&newer.statics) != count(&self.statics) {
            self.equilibrium = newer.equilibrium;
        }
        self.statics = newer.statics;
        self.checks = newer.checks;
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

    fn choice(&self, part: ScreenPart) -> u64 {
        let chosen = match part {
            ScreenPart::Drawing => Some(self.equilibrium),
            ScreenPart::Tab(MOTIONS) => self.trace,
            _ => None,
        };
        chosen.map_or(0, |chosen| chosen as u64 + 1)
    }

    fn is_behind(&self, part: ScreenPart) -> bool {
        let at_sea = matches!(part, ScreenPart::Tab(tab) if AT_SEA.contains(&tab));
        at_sea && self.running.is_some() && self.dynamic.is_some()
    }

    fn validate(&mut self, _text: &str, edited: &[EditedKey]) {
        let dynamic = self.dynamic.as_deref();
        self.checks = checks(&self.statics, dynamic, edited);
    }

    fn checks(&self) -> Option<&ValidationTable> {
        Some(&self.checks)
    }

    fn stop(&mut self) {
        if let Some(running) = self.running.take() {
            running.store(true, Ordering::Relaxed);
        }
    }

    fn busy(&self) -> Option<&'static str> {
        self.running.as_ref().map(|_| "dynamic analysis: running")
    }

    fn report<'a>(&'a self, rows: &'a [FieldRow]) -> Option<ReportSubject<'a>> {
        let dynamic = self.dynamic.as_deref();
        Some(ReportSubject::Ship(&self.statics, dynamic, rows))
    }

    fn line_input(&self, stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let arm = self.statics.ship.motion.as_ref().map(|m| m.hang_point_m);
        let table = self.motion().zip(arm).map(|(motion, arm)| {
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
