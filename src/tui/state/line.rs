//! A line case that is open: its live solve, its runs, and what the panes show.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::curves::{RunCurves, RunEntry};
use super::document::DocumentContent;
use super::document_kind::{DocumentKind, KindInfo};
use super::jobs::JobNumber;
use super::modes::ModesView;
use super::report::ReportRequest;
use super::run_list::RunList;
use super::value_check::{Checking, ValidationTable};
use super::variants::VariantPlan;
use crate::case::{Case, QuantityId, StudyPoint, TextDigest};
use crate::report::figures::{FIGURES, FigureId};
use crate::run::settings::method_name;
use crate::run::{Run, RunState};
use crate::tui::command::{Command, CommandId, LINE};
use crate::tui::line_tables::LineTable;
use crate::tui::msg::StudyOf;
use crate::tui::pane::PaneId;
use crate::tui::plot_pane::PlotPane;
use crate::tui::table_pane::TablePane;

/// The re-solve after an edit.
#[derive(Debug, Clone, Default)]
pub struct LiveSolve {
    /// The job that computes now.
    pub ticket: Option<JobNumber>,
    /// Its curves so far.
    pub going: Option<RunCurves>,
    /// The text that `going` computes.
    pub going_text: String,
    /// The coarse answer, until the full solve is complete.
    pub coarse: Option<CoarseAnswer>,
    /// The last complete curves, dimmed while `going` is incomplete.
    pub done: Option<RunCurves>,
    /// The text that `done` computed.
    pub done_text: String,
    /// Where it was kept on disk, if the user did.
    pub kept: Option<PathBuf>,
    /// Why the last one failed.
    pub failure: Option<String>,
    /// Taken off the charts while other runs are shown alone.
    pub hidden: bool,
}

impl LiveSolve {
    /// Why the last complete solve cannot be stored as a run.
    fn why_not_kept(&self) -> Option<&'static str> {
        if self.kept.is_some() {
            Some("The live run is already kept.")
        } else if self.ticket.is_some() {
            Some("The live run is still being computed; it can be kept when it is complete.")
        } else if self.done.as_ref().is_none_or(|done| done.run.is_none()) {
            Some("There is no live run to keep.")
        } else {
            None
        }
    }
}

/// What a coarse solve gave: it is shown, and never stored, compared or reported.
#[derive(Debug, Clone)]
pub struct CoarseAnswer {
    /// Its curves.
    pub curves: RunCurves,
    /// The text that it computed.
    pub text: String,
}

/// A study that computes behind the screen.
#[derive(Debug, Clone)]
pub struct RunningStudy {
    /// What it varies.
    pub of: StudyOf,
    /// Stops it.
    pub cancel: Arc<AtomicBool>,
    /// Variants computed so far.
    pub done: usize,
    /// All variants; 0 before they are known.
    pub all: usize,
}

impl RunningStudy {
    /// A study that begins.
    #[must_use]
    pub const fn new(of: StudyOf, cancel: Arc<AtomicBool>) -> Self {
        Self {
            of,
            cancel,
            done: 0,
            all: 0,
        }
    }
}

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
    /// The chart shown.
    pub chart: FigureId,
    /// Zoom, cursor and marks of each chart.
    pub views: [PlotPane; FIGURES.len()],
    /// The joint or component shown alone; absent: all, or the last one when several runs are shown.
    pub series: Option<usize>,
    /// Curves that are not drawn: chart and name.
    pub hidden_curves: Vec<(FigureId, String)>,
    /// Whether curves against time are drawn less those of the run held against.
    pub differences: bool,
    /// Whether charts leave out limits and published values.
    pub without_limits: bool,
    /// The instant that all charts show \[s\]; absent: the newest.
    pub instant: Option<f64>,
    /// The re-solve after an edit.
    pub live: LiveSolve,
    /// The results beside the inputs.
    pub results: Vec<QuantityId>,
    /// The run that they are held against, and its name.
    pub against: Option<(String, Arc<Run>)>,
    /// The directory of a run that will be held against when it is read.
    pub hold: Option<PathBuf>,
    /// A study that computes.
    pub study: Option<RunningStudy>,
    /// Cursor among all results.
    pub result: usize,
    /// Runs of the case.
    pub runs: RunList,
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
    /// The report shown: name of the run and text.
    pub report: Option<(String, String)>,
    /// What it is the report of.
    pub report_of: Option<ReportRequest>,
    /// The report that is being made.
    pub report_asked: Option<ReportRequest>,
    /// First line and column shown of the report.
    pub report_scroll: (usize, usize),
}

impl LineView {
    /// A case as read, before its first solve.
    #[must_use]
    pub fn new(case: Case) -> Self {
        let charts = FigureId::of(&case);
        Self {
            chart: charts.first().copied().unwrap_or(FigureId::Shape),
            case,
            views: Default::default(),
            series: None,
            hidden_curves: Vec::new(),
            differences: false,
            without_limits: false,
            instant: None,
            live: LiveSolve::default(),
            results: Vec::new(),
            against: None,
            hold: None,
            study: None,
            result: 0,
            runs: RunList::empty(),
            plan: VariantPlan::default(),
            planning: false,
            planned: None,
            checks: ValidationTable::default(),
            checking: Checking::default(),
            line_table: LineTable::default(),
            nodes_pane: TablePane::default(),
            modes: ModesView::default(),
            report: None,
            report_of: None,
            report_asked: None,
            report_scroll: (0, 0),
        }
    }

    /// The run under the cursor; nothing for the live solve.
    #[must_use]
    pub fn current_run(&self) -> Option<&RunEntry> {
        self.runs.current()
    }

    /// The run that tables and report show: the one under the cursor of the list, else the live solve.
    #[must_use]
    pub fn reported(&self) -> Option<(String, Arc<Run>, Option<PathBuf>)> {
        if let Some(entry) = self.current_run()
            && let Some(run) = &entry.curves.run
        {
            return Some((entry.id.clone(), Arc::clone(run), entry.dir.clone()));
        }
        let run = self.live.done.as_ref()?.run.clone()?;
        Some(("live".to_owned(), run, self.live.kept.clone()))
    }

    /// Takes all runs off the charts.
    pub fn hide_runs(&mut self) {
        self.live.hidden = true;
        self.runs.hide_all();
    }

    /// The runs that the validation table of this text is made from, by their points.
    #[must_use]
    pub fn checked_runs(&self, text: &str) -> Vec<(Option<StudyPoint>, Arc<Run>)> {
        // The variants follow when they are worked out.
        if self.plan.text != text {
            let run = self.complete_run(TextDigest::of(text));
            return run.into_iter().map(|run| (None, run)).collect();
        }
        let needed = self.plan.of_published_values().iter();
        let found = needed.filter_map(|v| Some((v.at.clone(), self.complete_run(v.digest)?)));
        found.collect()
    }

    /// The newest complete run of exactly this text.
    fn complete_run(&self, text: TextDigest) -> Option<Arc<Run>> {
        let live = self.live.done.as_ref();
        let live = live.filter(|_| TextDigest::of(&self.live.done_text) == text);
        let entries = self.runs.all().iter().rev();
        let curves = entries
            .filter(|entry| entry.text == text)
            .map(|entry| &entry.curves);
        curves
            .chain(live)
            .filter_map(|curves| curves.run.as_ref())
            .find(|run| run.info.state == RunState::Done)
            .cloned()
    }
}

impl DocumentKind for LineView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "line case",
            title: &self.case.case.title,
            source: &self.case.case.source,
            panes: &[
                PaneId::Inputs,
                PaneId::Charts,
                PaneId::Runs,
                PaneId::Validation,
                PaneId::Report,
                PaneId::Jobs,
                PaneId::Nodes,
                PaneId::Modes,
                PaneId::Results,
            ],
            first: PaneId::Inputs,
            tabs: &[],
        }
    }

    fn headline(&self) -> String {
        format!("solver {}", method_name(self.case.solver.method))
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
            CommandId::Keep => self.live.why_not_kept(),
            CommandId::Trials => when(
                case.trial.is_empty(),
                "This case has no trials. A `[[trial]]` table in its file makes one; in the list of cases `T` computes all.",
            ),
            _ => None,
        }
    }

    fn renew(&mut self, newer: DocumentContent) {
        let DocumentContent::Line(newer) = newer else {
            return;
        };
        self.case = newer.case;
    }

    fn checks(&self) -> Option<&ValidationTable> {
        Some(&self.checks)
    }
}
