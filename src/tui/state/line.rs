//! A line case that is open: its live solve, its runs, and what the panes show.

use std::path::PathBuf;
use std::sync::Arc;

use super::curves::{Curves, RunEntry};
use super::document::DocumentKind;
use super::jobs::Ticket;
use super::modes::ModesView;
use super::parameter_editor::ParameterEditor;
use crate::case::{
    self, At, Case, ChannelQuantity, ChannelSpec, Diagnostic, End, Method, OneOrMany, Site,
};
use crate::run::{Run, RunState, response};
use crate::tui::command::{Command, Id, LINE};
use crate::tui::facade::{self, FieldRow, ValidationRow};
use crate::tui::line_tables::LineTable;
use crate::tui::pane::PaneId;
use crate::tui::plot_pane::PlotPane;
use crate::tui::table_pane::TablePane;

/// The charts, in the order in which they are leafed through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ChartKind {
    /// Tension at the joints against time.
    Tensions,
    /// Payload x and z against time.
    Payload,
    /// Path of the payload, z against x, to equal scale.
    Path,
    /// The line at an instant, z against x, to equal scale.
    Shape,
    /// Tension along the line, with its envelope.
    Profile,
    /// The line from above, y against x, to equal scale.
    Plan,
    /// The line along the x axis, z against y, to equal scale.
    Front,
    /// Curvature along the line.
    Curvature,
    /// Bending moment along the line.
    Moment,
    /// Speed of the payload against time.
    Speed,
    /// Tilt of a payload that turns against time.
    Tilt,
    /// Published and computed numbers along the studies.
    Study,
    /// Mean load of fibre ropes against time.
    MeanLoad,
    /// Deviation from the mean load of fibre ropes against time.
    Deviation,
    /// Dynamic stiffness of fibre ropes against time.
    Stiffness,
    /// Dynamic stiffness of fibre ropes along the line.
    StiffnessAlong,
    /// Displacement of the line over time and place.
    Map,
    /// Root mean square displacement along the line.
    Rms,
    /// Amplitudes of the waves at the driving period.
    Amplitudes,
    /// Their lengths.
    Wavelengths,
    /// Height of the waves against time.
    Elevation,
}

impl ChartKind {
    /// All of them.
    pub const ALL: [Self; 21] = [
        Self::Tensions,
        Self::Payload,
        Self::Path,
        Self::Shape,
        Self::Profile,
        Self::Plan,
        Self::Front,
        Self::Curvature,
        Self::Moment,
        Self::Speed,
        Self::Tilt,
        Self::Study,
        Self::MeanLoad,
        Self::Deviation,
        Self::Stiffness,
        Self::StiffnessAlong,
        Self::Map,
        Self::Rms,
        Self::Amplitudes,
        Self::Wavelengths,
        Self::Elevation,
    ];

    /// The charts that a run of this case has something for, in the order in which they are leafed through: those
    /// against time first, but for statics, which have no time.
    #[must_use]
    pub fn of(case: &Case) -> Vec<Self> {
        let channels = case::channels(case);
        let of_end =
            |c: &ChannelSpec| matches!((c.id.quantity, c.site), (ChannelQuantity::X, Site::End(_)));
        let moves = channels.iter().any(of_end);
        let has = |wanted| channels.iter().any(|c| c.id.quantity == wanted);
        let bending = case::bends(case);
        let roped = has(ChannelQuantity::Stiffness);
        if case.solver.method == Method::Static {
            let mut list = vec![Self::Shape, Self::Plan, Self::Front, Self::Profile];
            list.extend([Self::Curvature, Self::Moment].iter().filter(|_| bending));
            list.extend([Self::Study].iter().filter(|_| studied(case)));
            list.extend(roped.then_some(Self::StiffnessAlong));
            return list;
        }
        let mut list = vec![Self::Tensions];
        let speed = has(ChannelQuantity::Speed);
        let tilt = has(ChannelQuantity::Tilt);
        list.extend([Self::Payload, Self::Path].iter().filter(|_| moves));
        list.extend([Self::Speed].iter().filter(|_| speed));
        list.extend([Self::Tilt].iter().filter(|_| tilt));
        // A regular wave is a sine, which nobody needs to see.
        let irregular = |waves: &&case::Waves| waves.kind == case::WaveKind::Irregular;
        let sea = case.waves.as_ref().filter(irregular);
        list.extend(sea.map(|_| Self::Elevation));
        list.push(Self::Shape);
        list.extend([Self::Plan, Self::Front].iter().filter(|_| spatial(case)));
        list.push(Self::Profile);
        list.extend([Self::Curvature, Self::Moment].iter().filter(|_| bending));
        let answers = case.output.response_from_s.is_some();
        let driven = answers && response::period(case).is_some();
        list.extend([Self::Map, Self::Rms].iter().filter(|_| answers));
        let waves = [Self::Amplitudes, Self::Wavelengths];
        list.extend(waves.iter().filter(|_| driven));
        list.extend([Self::Study].iter().filter(|_| studied(case)));
        if roped {
            list.extend([Self::Stiffness, Self::StiffnessAlong]);
            list.extend([Self::MeanLoad, Self::Deviation]);
        }
        list
    }

    /// Name on its tab.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Tensions => "Tensions",
            Self::Payload => "Payload",
            Self::Path => "Path",
            Self::Shape => "Shape",
            Self::Profile => "Profile",
            Self::Plan => "Plan",
            Self::Front => "Front",
            Self::Curvature => "Curvature",
            Self::Moment => "Moment",
            Self::Speed => "Speed",
            Self::Tilt => "Tilt",
            Self::Study => "Study",
            Self::MeanLoad => "Mean load",
            Self::Deviation => "Deviation",
            Self::Stiffness => "Stiffness",
            Self::StiffnessAlong => "Along rope",
            Self::Map => "Map",
            Self::Rms => "Rms",
            Self::Amplitudes => "Waves",
            Self::Wavelengths => "Wavelength",
            Self::Elevation => "Sea",
        }
    }

    /// Its place among [`Self::ALL`].
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// The next or previous one of a list, around its end; the first where it is not among them.
    #[must_use]
    pub fn beside(self, list: &[Self], forward: bool) -> Self {
        let Some(at) = list.iter().position(|kind| *kind == self) else {
            return list.first().copied().unwrap_or(self);
        };
        let step = if forward { 1 } else { list.len() - 1 };
        list[(at + step) % list.len()]
    }

    /// True for the line in space, which the instant moves.
    #[must_use]
    pub fn in_space(self) -> bool {
        matches!(self, Self::Path | Self::Shape | Self::Plan | Self::Front)
    }
}

/// Whether the case states anything along a study.
fn studied(case: &Case) -> bool {
    let mut rows = case.published.iter();
    !case.trend.is_empty() || !case.published_curve.is_empty() || rows.any(|p| p.at.is_some())
}

/// Whether anything in the case takes the line out of a plane along x.
fn spatial(case: &Case) -> bool {
    let aside = |end: &End| {
        let y = |p: &[f64; 3]| p[1].abs() > 0.0;
        end.position_m.as_ref().is_some_and(y) || y(&end.amplitude_m)
    };
    let oblique = case.current.as_ref().is_some_and(|current| {
        let turns = |degrees: &f64| degrees.to_radians().sin().abs() > 1e-9;
        match &current.direction_deg {
            OneOrMany::One(one) => turns(one),
            OneOrMany::Many(many) => many.iter().any(turns),
        }
    });
    aside(&case.ends.a) || aside(&case.ends.b) || oblique
}

/// The re-solve after an edit.
#[derive(Debug, Clone, Default)]
pub struct LiveSolve {
    /// The job that computes now.
    pub ticket: Option<Ticket>,
    /// Its curves so far.
    pub going: Option<Curves>,
    /// The text that `going` computes.
    pub going_text: String,
    /// The last complete curves, dimmed while `going` is on its way.
    pub done: Option<Curves>,
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

/// A line case that is open.
#[derive(Debug, Clone)]
pub struct LineView {
    /// What the text says.
    pub case: Case,
    /// The chart shown.
    pub chart: ChartKind,
    /// Zoom, cursor and marks of each chart.
    pub views: [PlotPane; ChartKind::ALL.len()],
    /// The joint or component shown alone; absent: all, or the last one when several runs are shown.
    pub series: Option<usize>,
    /// The instant that all charts show \[s\]; absent: the newest.
    pub instant: Option<f64>,
    /// The re-solve after an edit.
    pub live: LiveSolve,
    /// Runs of the case, the oldest first.
    pub runs: Vec<RunEntry>,
    /// Cursor among the runs; 0 is the live one.
    pub run: usize,
    /// The validation table, made anew when a run lands.
    pub checks: Vec<ValidationRow>,
    /// The table of the line that is shown.
    pub line_table: LineTable,
    /// Selection, sorting and scrolling of that table.
    pub nodes_pane: TablePane,
    /// Natural modes.
    pub modes: ModesView,
    /// The report shown: name of the run and text.
    pub report: Option<(String, String)>,
    /// First line and column shown of the report.
    pub report_scroll: (usize, usize),
}

impl LineView {
    /// A case as read, before its first solve.
    #[must_use]
    pub fn new(case: Case) -> Self {
        let charts = ChartKind::of(&case);
        Self {
            chart: charts.first().copied().unwrap_or(ChartKind::Shape),
            case,
            views: Default::default(),
            series: None,
            instant: None,
            live: LiveSolve::default(),
            runs: Vec::new(),
            run: 0,
            checks: Vec::new(),
            line_table: LineTable::default(),
            nodes_pane: TablePane::default(),
            modes: ModesView::default(),
            report: None,
            report_scroll: (0, 0),
        }
    }

    /// The run under the cursor; nothing for the live solve.
    #[must_use]
    pub fn current_run(&self) -> Option<&RunEntry> {
        self.run.checked_sub(1).and_then(|i| self.runs.get(i))
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

    /// The points of the studies that the validation table needs, with the text of each.
    #[must_use]
    pub fn needed(&self, source: &ParameterEditor) -> Vec<(Option<At>, String)> {
        let variant = |at: Option<At>| {
            let found = facade::variant(&source.text, &self.case, at.as_ref(), &source.file);
            Some((at, found.ok()?.0))
        };
        let points = facade::plan(&self.case).into_iter();
        points.filter_map(variant).collect()
    }

    /// Takes all runs off the charts.
    pub fn hide_runs(&mut self) {
        self.live.hidden = true;
        self.runs.iter_mut().for_each(|entry| entry.shown = false);
    }

    /// The newest complete run of exactly this text.
    fn complete_run(&self, text: &str) -> Option<Arc<Run>> {
        let live = self.live.done.as_ref();
        let live = live.filter(|_| self.live.done_text == text);
        let entries = self.runs.iter().rev().filter(|entry| entry.text == text);
        let curves = entries.map(|entry| &entry.curves).chain(live);
        curves
            .filter_map(|curves| curves.run.as_ref())
            .find(|run| run.info.state == RunState::Done)
            .cloned()
    }
}

impl DocumentKind for LineView {
    fn word(&self) -> String {
        format!("solver {}", facade::method_word(self.case.solver.method))
    }

    fn title(&self) -> &str {
        &self.case.case.title
    }

    fn panes(&self) -> &'static [PaneId] {
        &[
            PaneId::Inputs,
            PaneId::Charts,
            PaneId::Runs,
            PaneId::Validation,
            PaneId::Report,
            PaneId::Jobs,
            PaneId::Nodes,
            PaneId::Modes,
        ]
    }

    fn commands(&self) -> &'static [Command] {
        LINE
    }

    fn reason(&self, id: Id) -> Option<&'static str> {
        let when = |condition: bool, reason: &'static str| condition.then_some(reason);
        let case = &self.case;
        match id {
            Id::Study => when(
                case.study.is_empty(),
                "This case has no study. A `[[study]]` table in its file makes one.",
            ),
            Id::Validate => when(
                case.published.is_empty()
                    && case.trend.is_empty()
                    && case.published_curve.is_empty(),
                "This case states no published values to compare with.",
            ),
            Id::Keep => self.live.why_not_kept(),
            Id::Trials => when(
                case.trial.is_empty(),
                "This case has no trials. A `[[trial]]` table in its file makes one; in the list of cases `T` computes all.",
            ),
            _ => None,
        }
    }

    fn first_pane(&self) -> PaneId {
        PaneId::Inputs
    }

    fn rows(&self, text: &str, source: &ParameterEditor) -> Vec<FieldRow> {
        let case = facade::parse_at(text, &source.path, &source.file);
        case.map_or_else(|_| Vec::new(), |case| facade::rows(text, &case))
    }

    fn set(&self, text: &str, key: &str, value: &str) -> Result<String, String> {
        facade::set(text, key, value)
    }

    fn unset(&self, text: &str, key: &str) -> Option<Result<String, String>> {
        Some(facade::unset(text, key))
    }

    fn check(&self, text: &str, source: &ParameterEditor) -> Result<(), Vec<Diagnostic>> {
        facade::parse_at(text, &source.path, &source.file).map(drop)
    }

    fn read(&mut self, source: &ParameterEditor) -> Result<(), Vec<Diagnostic>> {
        self.case = facade::parse_at(&source.text, &source.path, &source.file)?;
        Ok(())
    }

    fn validate(&mut self, source: &ParameterEditor) {
        let needed = self.needed(source).into_iter();
        let runs = needed.filter_map(|(at, text)| Some((at, self.complete_run(&text)?)));
        self.checks = facade::checks(&self.case, &runs.collect::<Vec<_>>());
    }

    fn checks(&self) -> &[ValidationRow] {
        &self.checks
    }
}
