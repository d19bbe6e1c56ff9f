//! The sweeps of what is open: which are stored, the one that is shown, and how it is looked at.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::JobNumber;
use super::sweep_verdict::SweepVerdict;
use crate::fuzzy::FuzzyFilter;
use crate::state::Filter;
use crate::study::load_case_table::{
    HeatCell, HeatMap, HeatMapChoice, LoadCaseColumn, LoadCaseTable, ResultValue,
};
use crate::study::sweep::{SweepEntry, SweepSnapshot};
use crate::table_pane::TablePane;

/// Why there is nothing to compute.
pub(super) const NO_LOAD_CASES: &str = "This file has no `[[load_cases]]`.";

/// A view of a sweep.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum SweepTab {
    /// A result over two axes.
    #[default]
    Map,
    /// The load cases with their results.
    LoadCases,
    /// The verdict of the checks.
    Checks,
    /// What the seeds of each sea say together.
    Seas,
}

impl SweepTab {
    /// All of them, in the order of their names.
    pub const ALL: [Self; 4] = [Self::Map, Self::LoadCases, Self::Checks, Self::Seas];

    /// Their names.
    pub const NAMES: [&'static str; 4] = ["Heat map", "Load cases", "Checks", "Seas"];

    /// Its place among all.
    #[must_use]
    pub fn place(self) -> usize {
        let mut all = Self::ALL.iter();
        all.position(|tab| *tab == self).unwrap_or(0)
    }

    /// The one so many places further on.
    #[must_use]
    pub fn turned(self, by: usize) -> Self {
        Self::ALL[(self.place() + by) % Self::ALL.len()]
    }
}

/// The sweeps of what is open.
#[derive(Debug, Clone, Default)]
pub struct SweepsView {
    /// Those that are stored, the newest first.
    pub stored: Vec<SweepEntry>,
    /// The folder of the one that is shown or about to be.
    pub wanted: Option<PathBuf>,
    /// The one that is shown.
    pub open: Option<OpenSweep>,
    /// The folder that is being read.
    pub reading: Option<PathBuf>,
    /// Whether the user asked for it to be read anew.
    pub reload: bool,
    /// Why it cannot be shown.
    pub failure: Option<String>,
    /// Whether checks are being worked out.
    pub checking: bool,
    /// Whether the user looks for the shares that checks use.
    pub wants_verdict: bool,
    /// Whether the sweep that is shown is of the text as it is.
    pub comparison: SweepComparison,
    /// The one that this program computes.
    pub job: Option<SweepJob>,
    /// The view shown.
    pub tab: SweepTab,
}

/// How a sweep compares with the edited text.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SweepComparison {
    /// The folder and the text that were compared.
    pub of: Option<(PathBuf, String)>,
    /// Whether they have the same inputs and load cases.
    pub is_same: bool,
    /// Whether others are being compared.
    pub is_open: bool,
}

impl SweepComparison {
    /// Whether the sweep in a folder is known to be of other inputs or load cases than a text.
    #[must_use]
    pub fn differs(&self, dir: &Path, text: &str) -> bool {
        self.is_of(dir, text) && !self.is_same
    }

    /// Whether these were compared.
    #[must_use]
    pub fn is_of(&self, dir: &Path, text: &str) -> bool {
        let of = self.of.as_ref();
        of.is_some_and(|(known, of)| known == dir && of == text)
    }
}

/// A sweep that this program computes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepJob {
    /// Number of its job.
    pub ticket: JobNumber,
    /// Its folder, once there is one.
    pub dir: Option<PathBuf>,
    /// Load cases that have ended.
    pub ended: usize,
    /// How many had when it was read last.
    pub read: usize,
}

/// A sweep as read behind the screen.
#[derive(Debug, Clone)]
pub struct SweepRead {
    /// The sweep.
    pub snapshot: Arc<SweepSnapshot>,
    /// Its load cases.
    pub table: Arc<LoadCaseTable>,
}

impl SweepRead {
    /// The table of a sweep. For the threads behind the screen.
    #[must_use]
    pub fn new(snapshot: SweepSnapshot) -> Self {
        Self {
            table: Arc::new(LoadCaseTable::of_snapshot(&snapshot)),
            snapshot: Arc::new(snapshot),
        }
    }
}

/// The load cases of a cell, listed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CellList {
    /// The load cases, by their places.
    pub load_cases: Vec<usize>,
    /// Those that pass the filter.
    pub shown: Vec<usize>,
    /// Cursor among those shown.
    pub cursor: usize,
}

/// The sweep that is shown, and how it is looked at.
#[derive(Debug, Clone)]
pub struct OpenSweep {
    /// The sweep.
    pub snapshot: Arc<SweepSnapshot>,
    /// Its load cases.
    pub table: Arc<LoadCaseTable>,
    /// What they say together, once it is worked out.
    pub verdict: Option<Arc<SweepVerdict>>,
    /// The result shown, by its place among those of the table and the shares that checks use.
    pub result: usize,
    /// Axes, rule and values held.
    pub choice: HeatMapChoice,
    /// Which of the axes that are not shown is held next.
    pub other: usize,
    /// The map of it.
    pub map: HeatMap,
    /// Column and row of the cursor.
    pub cursor: (usize, usize),
    /// The load cases of the cell that was entered.
    pub cell: Option<CellList>,
    /// The load cases in the order of the table, as far as they pass the filter.
    pub order: Vec<usize>,
    /// The filter of load cases in lines.
    pub filter: Filter,
    /// Whether the table is sorted by the result shown, the greatest first.
    pub by_result: bool,
    /// Cursor in the table.
    pub row: usize,
    /// Selection and scrolling of the verdict.
    pub checks_pane: TablePane,
    /// Selection and scrolling of the table of the seas.
    pub seas_pane: TablePane,
}

impl OpenSweep {
    /// A sweep as it is looked at first.
    #[must_use]
    pub fn new(read: SweepRead) -> Self {
        let first = read.table.columns.first();
        let choice = HeatMapChoice::first(&read.table, first.map_or("", |of| &of.name));
        let mut open = Self {
            snapshot: read.snapshot,
            table: read.table,
            verdict: None,
            result: 0,
            choice,
            other: 0,
            map: HeatMap::default(),
            cursor: (0, 0),
            cell: None,
            order: Vec::new(),
            filter: Filter::default(),
            by_result: false,
            row: 0,
            checks_pane: TablePane::default(),
            seas_pane: TablePane::default(),
        };
        open.arrange();
        open
    }

    /// Takes a newer look at the same sweep; what the user looks at stays.
    pub fn renew(&mut self, read: SweepRead) {
        (self.snapshot, self.table) = (read.snapshot, read.table);
        self.arrange();
    }

    /// The results that can be shown: those of the load cases, then the shares that checks use.
    pub fn columns(&self) -> impl Iterator<Item = &LoadCaseColumn> {
        let used = self.verdict.iter().flat_map(|verdict| &verdict.used);
        self.table.columns.iter().chain(used)
    }

    /// The result that is shown.
    #[must_use]
    pub fn shown(&self) -> Option<&LoadCaseColumn> {
        self.columns().nth(self.result)
    }

    /// The value of the result shown at a load case.
    #[must_use]
    pub fn value(&self, load_case: usize) -> Option<ResultValue> {
        self.shown()?.values.get(load_case).copied().flatten()
    }

    /// The cell under the cursor.
    #[must_use]
    pub fn current(&self) -> Option<&HeatCell> {
        self.map.cell(self.cursor.0, self.cursor.1)
    }

    /// Brings map and table in step with the load cases and what is chosen.
    pub fn arrange(&mut self) {
        let values = self.shown().map_or_else(Vec::new, |of| of.values.clone());
        self.map = HeatMap::of_result(&self.table, &values, &self.choice);
        let (column, row) = self.cursor;
        let last = |count: usize| count.saturating_sub(1);
        self.cursor = (
            column.min(last(self.map.columns)),
            row.min(last(self.map.rows)),
        );
        self.order = self.passing((0..self.table.states.len()).collect());
        if self.by_result {
            let key = |case: &usize| values.get(*case).copied().flatten().map(|of| of.value);
            // What has no value comes last.
            let greater = |a: &f64, b: &f64| b.total_cmp(a);
            self.order.sort_by(|a, b| match (key(a), key(b)) {
                (Some(a), Some(b)) => greater(&a, &b),
                (a, b) => b.is_some().cmp(&a.is_some()),
            });
        }
        let shown = self
            .cell
            .as_ref()
            .map(|cell| self.passing(cell.load_cases.clone()));
        if let (Some(cell), Some(shown)) = (&mut self.cell, shown) {
            cell.cursor = cell.cursor.min(last(shown.len()));
            cell.shown = shown;
        }
        self.row = self.row.min(last(self.order.len()));
    }

    /// Those of these load cases that pass the filter.
    fn passing(&self, load_cases: Vec<usize>) -> Vec<usize> {
        if self.filter.is_empty() {
            return load_cases;
        }
        let words = |case: &usize| {
            let state = self.table.states.get(*case).map_or("", |of| of.word());
            vec![
                (case + 1).to_string(),
                self.table.words(*case),
                state.to_owned(),
            ]
        };
        let lines: Vec<Vec<String>> = load_cases.iter().map(words).collect();
        let places = FuzzyFilter::new(self.filter.input.value()).places(&lines);
        places.into_iter().map(|place| load_cases[place]).collect()
    }
}

impl SweepsView {
    /// The filter of the load cases in lines, its cursor, and how many pass; nothing where they are not in lines.
    pub fn filter_mut(&mut self) -> Option<(&mut Filter, &mut usize, usize)> {
        let tab = self.tab;
        let open = self.open.as_mut()?;
        match &mut open.cell {
            Some(cell) => Some((&mut open.filter, &mut cell.cursor, cell.shown.len())),
            None if tab == SweepTab::LoadCases => {
                Some((&mut open.filter, &mut open.row, open.order.len()))
            }
            None => None,
        }
    }

    /// Takes the list of those stored: the newest is shown, unless another is.
    pub fn take(&mut self, stored: Vec<SweepEntry>) {
        self.stored = stored;
        if self.wanted.is_none() {
            self.wanted = self.stored.first().map(|entry| entry.dir.clone());
        }
    }

    /// The place of the one that is shown among those stored.
    #[must_use]
    pub fn place(&self) -> Option<usize> {
        let wanted = self.wanted.as_deref()?;
        self.stored.iter().position(|entry| entry.dir == wanted)
    }

    /// Why its load cases cannot be computed now, of a file that has some or none.
    #[must_use]
    pub fn why_not_started(&self, has_load_cases: bool) -> Option<&'static str> {
        match (&self.job, has_load_cases) {
            (_, false) => Some(NO_LOAD_CASES),
            (Some(_), _) => Some("The load cases are being computed; `ctrl+c` cancels."),
            (None, true) => None,
        }
    }

    /// Whether this program computes the sweep in this folder.
    #[must_use]
    pub fn is_computing(&self, dir: &Path) -> bool {
        let job = self.job.as_ref();
        job.is_some_and(|job| job.dir.as_deref() == Some(dir))
    }
}
