//! The runs of what is open, and what the panes show of them: charts, table and report.

use std::path::PathBuf;
use std::sync::Arc;

use super::curves::{RunCurves, RunEntry};
use super::jobs::JobNumber;
use super::report::ReportRequest;
use super::run_list::RunList;
use crate::case::{Case, TextDigest};
use crate::plot_pane::PlotPane;
use crate::reference::ValidationRow;
use crate::report::figures::{FIGURES, FigureId};
use crate::run::{Run, RunState};

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
    pub(super) fn why_not_kept(&self) -> Option<&'static str> {
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

/// What charts are drawn from.
#[derive(Debug, Clone, Copy)]
pub struct Charted<'a> {
    /// The runs.
    pub view: &'a RunsView,
    /// Their case; absent for systems of lines.
    pub case: Option<&'a Case>,
    /// Their validation table.
    pub checks: &'a [ValidationRow],
}

/// The runs of what is open.
#[derive(Debug, Clone)]
pub struct RunsView {
    /// The charts there are.
    pub figures: Vec<FigureId>,
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
    /// The run that results are held against, and its name.
    pub against: Option<(String, Arc<Run>)>,
    /// The directory of a run that will be held against when it is read.
    pub hold: Option<PathBuf>,
    /// The runs.
    pub runs: RunList,
    /// The report shown: name of the run and text.
    pub report: Option<(String, String)>,
    /// What it is the report of.
    pub report_of: Option<ReportRequest>,
    /// The report that is being made.
    pub report_asked: Option<ReportRequest>,
    /// First line and column shown of the report.
    pub report_scroll: (usize, usize),
}

impl RunsView {
    /// Without runs, with these charts; `has_live` where edits are solved at once.
    #[must_use]
    pub fn new(figures: Vec<FigureId>, has_live: bool) -> Self {
        Self {
            chart: figures.first().copied().unwrap_or(FigureId::Shape),
            figures,
            views: Default::default(),
            series: None,
            hidden_curves: Vec::new(),
            differences: false,
            without_limits: false,
            instant: None,
            live: LiveSolve {
                hidden: !has_live,
                ..LiveSolve::default()
            },
            against: None,
            hold: None,
            runs: RunList::empty(has_live),
            report: None,
            report_of: None,
            report_asked: None,
            report_scroll: (0, 0),
        }
    }

    /// Takes other charts; where the one shown is not among them, the first is shown.
    pub fn set_figures(&mut self, figures: Vec<FigureId>) {
        if !figures.contains(&self.chart) {
            self.chart = figures.first().copied().unwrap_or(self.chart);
        }
        self.figures = figures;
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

    /// The newest complete run of exactly this text.
    #[must_use]
    pub fn complete_run(&self, text: TextDigest) -> Option<&Arc<Run>> {
        let live = self.live.done.as_ref();
        let live = live.filter(|_| TextDigest::of_text(&self.live.done_text) == text);
        let entries = self.runs.all().iter().rev();
        let curves = entries
            .filter(|entry| entry.text == text)
            .map(|entry| &entry.curves);
        curves
            .chain(live)
            .filter_map(|curves| curves.run.as_ref())
            .find(|run| run.info.state == RunState::Done)
    }

    /// Takes all runs off the charts.
    pub fn hide_runs(&mut self) {
        self.live.hidden = true;
        self.runs.hide_all();
    }
}
