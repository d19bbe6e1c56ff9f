//! A system of lines on the screen: its result and its validation table.

use std::sync::Arc;

use super::document_kind::{DocumentKind, KindInfo};
use super::modes::ModesView;
use super::parts::ScreenPart;
use super::runs_view::RunsView;
use super::sweeps::{NO_LOAD_CASES, SweepsView};
use super::trials::NO_TRIALS;
use super::value_check::ValidationTable;
use crate::case::{ChannelId, EditedKey, QuantityId, Statistic, Subject};
use crate::command::{Command, CommandId, MOVING, REPORTED};
use crate::facade::FieldRow;
use crate::pane::PaneId;
use crate::report::figures::{FigureId, SystemContents};
use crate::report::subject::ReportSubject;
use crate::run::Quantity;
use crate::system::analysis::analyses::Analyses;
use crate::system::at_rest::readings;
use crate::system::motion::channels::quantities;
use crate::system::motion::driving_period::asked_response;
use crate::system::{SolvedSystem, quantities, validation};

/// A system of lines.
#[derive(Debug, Clone)]
pub struct SystemView {
    /// The result of the text.
    pub solved: Arc<SolvedSystem>,
    /// Its analyses, once they are worked out.
    pub analyses: Option<Arc<Analyses>>,
    /// The validation table.
    pub checks: ValidationTable,
    /// Its results before a run of it is complete, worked out with the analyses.
    pub expected: Vec<ExpectedResult>,
    /// The view shown: from above, from the side, obliquely.
    pub view: usize,
    /// Its runs in time, and what the panes show of them.
    pub runs_view: RunsView,
    /// The sweeps of its load cases.
    pub sweeps: SweepsView,
    /// Natural modes.
    pub modes: ModesView,
}

impl SystemView {
    /// A system as read.
    #[must_use]
    pub fn new(solved: SolvedSystem) -> Self {
        Self {
            runs_view: RunsView::new(figures(&solved), false),
            sweeps: SweepsView::default(),
            modes: ModesView::default(),
            solved: Arc::new(solved),
            analyses: None,
            checks: ValidationTable::default(),
            expected: Vec::new(),
            view: 0,
        }
    }

    /// Whether its file has a run of it computed.
    #[must_use]
    pub fn has_runs(&self) -> bool {
        self.solved.file.as_run().is_some()
    }

    /// Whether it has load cases, or sweeps of others are stored.
    fn has_sweeps(&self) -> bool {
        !self.solved.file.load_cases.is_empty() || !self.sweeps.stored.is_empty()
    }

    /// How many views there are.
    pub const VIEWS: usize = 3;

    /// Shows the view so many further on.
    pub fn turn(&mut self, by: usize) {
        self.view = (self.view + by) % Self::VIEWS;
    }
}

/// The panes of a system that is computed in time and has load cases.
const SWEPT_IN_MOTION: [PaneId; 11] = [
    PaneId::Inputs,
    PaneId::System,
    PaneId::Tables,
    PaneId::Validation,
    PaneId::Charts,
    PaneId::Runs,
    PaneId::Report,
    PaneId::Jobs,
    PaneId::Results,
    PaneId::Sweep,
    PaneId::Modes,
];

/// The same without load cases.
const IN_MOTION: [PaneId; 10] = [
    PaneId::Inputs,
    PaneId::System,
    PaneId::Tables,
    PaneId::Validation,
    PaneId::Charts,
    PaneId::Runs,
    PaneId::Report,
    PaneId::Jobs,
    PaneId::Results,
    PaneId::Modes,
];

/// The panes of a system at rest with load cases.
const SWEPT_AT_REST: [PaneId; 8] = [
    PaneId::Inputs,
    PaneId::System,
    PaneId::Tables,
    PaneId::Validation,
    PaneId::Results,
    PaneId::Sweep,
    PaneId::Jobs,
    PaneId::Modes,
];

/// The same without load cases.
const AT_REST: [PaneId; 6] = [
    PaneId::Inputs,
    PaneId::System,
    PaneId::Tables,
    PaneId::Validation,
    PaneId::Results,
    PaneId::Modes,
];

/// A result that a system at rest has, or that its run will have.
#[derive(Debug, Clone)]
pub struct ExpectedResult {
    /// What identifies it.
    pub id: QuantityId,
    /// Its value with its error where no run is to compute it.
    pub at_rest: Option<Quantity>,
}

/// The results of a system: at rest as its analyses have them, else the greatest values that its run will have.
fn expected(solved: &SolvedSystem) -> Vec<ExpectedResult> {
    let has_runs = solved.file.as_run().is_some();
    let one = |(channel, value): (ChannelId, f64)| {
        let name = channel.to_string();
        let subject = Subject::Channel(channel);
        if has_runs {
            return ExpectedResult {
                id: QuantityId::new(subject, Statistic::Max, None),
                at_rest: None,
            };
        }
        let id = QuantityId::single(subject);
        ExpectedResult {
            at_rest: Some(Quantity {
                mesh_error: quantities::error(solved, &name),
                ..Quantity::new(id.clone(), value)
            }),
            id,
        }
    };
    readings(solved).into_iter().map(one).collect()
}

/// The charts of the runs of a system.
fn figures(solved: &SolvedSystem) -> Vec<FigureId> {
    let response = asked_response(&solved.file);
    FigureId::of_system(&SystemContents {
        dynamic: solved.file.in_time().is_some(),
        recorded: quantities(solved),
        bends: solved.network.bends(),
        responds: response.is_some(),
        driven: response.is_some_and(|asked| asked.period.is_some()),
    })
}

impl SystemView {
    /// Replaces the result by that of a newer text; what the user looks at stays.
    pub(super) fn renew(&mut self, newer: Self) {
        self.runs_view.set_figures(newer.runs_view.figures);
        self.solved = newer.solved;
        self.analyses = newer.analyses;
        self.checks = newer.checks;
        self.expected = newer.expected;
    }
}

impl DocumentKind for SystemView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "system of lines",
            title: &self.solved.file.about.title,
            source: &self.solved.file.about.source,
            panes: match (self.has_runs(), self.has_sweeps()) {
                (true, true) => &SWEPT_IN_MOTION,
                (true, false) => &IN_MOTION,
                (false, true) => &SWEPT_AT_REST,
                (false, false) => &AT_REST,
            },
            first: PaneId::System,
            tabs: &[
                "Lines",
                "Points",
                "Bodies",
                "Stiffness",
                "Clearances",
                "Periods",
                "Equilibria",
                "Offsets",
                "Watch circle",
                "Goals",
            ],
        }
    }

    fn choice(&self, part: ScreenPart) -> u64 {
        match part {
            ScreenPart::Drawing => self.view as u64,
            _ => 0,
        }
    }

    fn commands(&self) -> &'static [Command] {
        match self.has_runs() {
            true => MOVING,
            false => REPORTED,
        }
    }

    fn reason(&self, id: CommandId) -> Option<&'static str> {
        match id {
            CommandId::Sweep => (!self.has_sweeps()).then_some(NO_LOAD_CASES),
            CommandId::StartSweep => {
                let has_load_cases = !self.solved.file.load_cases.is_empty();
                self.sweeps.why_not_started(has_load_cases)
            }
            CommandId::Trials => self.solved.file.trial.is_empty().then_some(NO_TRIALS),
            _ => None,
        }
    }

    fn validate(&mut self, _text: &str, edited: &[EditedKey]) {
        self.analyses = Some(Arc::new(Analyses::of_system(&self.solved)));
        let mut rows = validation::rows(&self.solved, None);
        validation::set_edited_aside(&mut rows, &self.solved.file, edited);
        self.checks = ValidationTable::new(rows);
        self.expected = expected(&self.solved);
    }

    fn checks(&self) -> Option<&ValidationTable> {
        Some(&self.checks)
    }

    fn report<'a>(&'a self, rows: &'a [FieldRow]) -> Option<ReportSubject<'a>> {
        let (analyses, checks) = (self.analyses.as_ref()?, &self.checks.rows);
        Some(ReportSubject::System(&self.solved, analyses, checks, rows))
    }
}
