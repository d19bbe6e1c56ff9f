//! A line case that is open: its live solve, its runs, and what the panes show.

use std::sync::Arc;

use super::document_kind::{DocumentKind, KindInfo};
use super::modes::ModesView;
use super::runs_view::RunsView;
use super::sweeps::{NO_LOAD_CASES, SweepsView};
use super::trials::NO_TRIALS;
use super::value_check::{Checking, ValidationTable};
use super::variants::VariantPlan;
use crate::case::{Case, QuantityId, StudyPoint, TextDigest};
use crate::command::{Command, CommandId, LINE};
use crate::line_tables::LineTable;
use crate::pane::PaneId;
use crate::report::figures::FigureId;
use crate::run::Run;
use crate::table_pane::TablePane;

/// Work that needs the variants of the case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlannedWork {
    /// Run the study of this number.
    Study(usize),
    /// Run what the published values need.
    Validate,
}

/// A line case that is open.
#[derive(Debug, Clone)]
pub struct LineView {
    /// What the text says.
    pub case: Case,
    /// Its runs, and what the panes show of them.
    pub runs_view: RunsView,
    /// The sweeps of its load cases.
    pub sweeps: SweepsView,
    /// The results beside the inputs.
    pub results: Vec<QuantityId>,
    /// The variants of the case, of the text that is named there.
    pub plan: VariantPlan,
    /// True while the variants of a newer text are worked out.
    pub planning: bool,
    /// What was asked for and waits for the variants.
    pub planned: Option<PlannedWork>,
    /// The validation table, made anew behind the screen when a run lands.
    pub checks: ValidationTable,
    /// Whether it is, or has to be.
    pub checking: Checking,
    /// The table of the line that is shown.
    pub line_table: LineTable,
    /// Selection, sorting and scrolling of that table.
    pub nodes_pane: TablePane,
    /// Natural modes.
    pub modes: ModesView,
}

impl LineView {
    /// A case as read, before its first solve.
    #[must_use]
    pub fn new(case: Case) -> Self {
        let runs_view = RunsView::new(FigureId::of_case(&case), true);
        Self {
            runs_view,
            sweeps: SweepsView::default(),
            case,
            results: Vec::new(),
            plan: VariantPlan::default(),
            planning: false,
            planned: None,
            checks: ValidationTable::default(),
            checking: Checking::default(),
            line_table: LineTable::default(),
            nodes_pane: TablePane::default(),
            modes: ModesView::default(),
        }
    }

    /// The runs that the validation table of this text is made from, by their points.
    #[must_use]
    pub fn checked_runs(&self, text: &str) -> Vec<(Option<StudyPoint>, Arc<Run>)> {
        // The variants follow when they are worked out.
        if self.plan.text != text {
            let run = self.runs_view.complete_run(TextDigest::of_text(text));
            return run.into_iter().map(|run| (None, Arc::clone(run))).collect();
        }
        let needed = self.plan.of_published_values().iter();
        let found = needed.filter_map(|v| {
            let run = self.runs_view.complete_run(v.digest)?;
            Some((v.at.clone(), Arc::clone(run)))
        });
        found.collect()
    }

    /// Whether it has load cases, or sweeps of others are stored.
    fn has_sweeps(&self) -> bool {
        !self.case.load_cases.is_empty() || !self.sweeps.stored.is_empty()
    }
}

/// The panes of a line case; the first [`WITHOUT_SWEEPS`] are those of one without load cases.
const PANES: [PaneId; 10] = [
    PaneId::Inputs,
    PaneId::Charts,
    PaneId::Runs,
    PaneId::Validation,
    PaneId::Report,
    PaneId::Jobs,
    PaneId::Nodes,
    PaneId::Modes,
    PaneId::Results,
    PaneId::Sweep,
];
const WITHOUT_SWEEPS: usize = 9;

impl LineView {
    /// Replaces the result by that of a newer text; what the user looks at stays.
    pub(super) fn renew(&mut self, newer: Self) {
        self.case = newer.case;
        self.runs_view.set_figures(newer.runs_view.figures);
    }
}

impl DocumentKind for LineView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "line case",
            title: &self.case.case.title,
            source: &self.case.case.source,
            panes: match self.has_sweeps() {
                true => &PANES,
                false => &PANES[..WITHOUT_SWEEPS],
            },
            first: PaneId::Inputs,
            tabs: &[],
        }
    }

    fn headline(&self) -> String {
        format!("solver {}", self.case.solver.method.name())
    }

    fn commands(&self) -> &'static [Command] {
        LINE
    }

    fn reason(&self, id: CommandId) -> Option<&'static str> {
        let when = |condition: bool, reason: &'static str| condition.then_some(reason);
        let case = &self.case;
        match id {
            CommandId::Study => when(
                case.study.is_empty(),
                "This case has no study. A `[[study]]` table in its file makes one.",
            ),
            CommandId::Validate => when(
                case.published.is_empty()
                    && case.trend.is_empty()
                    && case.published_curve.is_empty(),
                "This case states no published values to compare with.",
            ),
            CommandId::Sweep => when(!self.has_sweeps(), NO_LOAD_CASES),
            CommandId::StartSweep => self.sweeps.why_not_started(!case.load_cases.is_empty()),
            CommandId::Keep => self.runs_view.live.why_not_kept(),
            CommandId::Trials => when(case.trial.is_empty(), NO_TRIALS),
            _ => None,
        }
    }

    fn checks(&self) -> Option<&ValidationTable> {
        Some(&self.checks)
    }
}
