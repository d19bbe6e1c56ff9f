//! What records something of a run: the trait that the time march drives, and what it is given.

use std::sync::LazyLock;

use super::along::FatigueSpot;
use super::energy_balance::EnergyBalance;
use super::late_samples::LateSamples;
use super::recorder_state::RecorderState;
use super::requested_statistics::RequestedStatistic;
use super::step_interval::StepInterval;
use super::{History, LineShape, Profile, Quantity};
use crate::numerics::V3;
use crate::scene::{EnergyRates, Scene};
use crate::solve::State;

/// A line at an accepted step.
#[derive(Clone, Copy)]
pub struct LineStep<'a> {
    /// Its number.
    pub number: usize,
    /// The line, as it is since its last event.
    pub scene: &'a Scene,
    /// Time \[s\].
    pub time: f64,
    /// The state of the line at that time.
    pub state: &'a State,
}

/// A node of a line that comes or goes, next to an end that is paid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NodeChange {
    /// Number of the line.
    pub line: usize,
    /// Number of the node, of one that goes before it goes.
    pub node: usize,
    /// Whether it comes.
    pub comes: bool,
}

/// The lines at an output time, interpolated between two steps.
#[derive(Clone, Copy)]
pub struct OutputSample<'a> {
    /// Time \[s\].
    pub time: f64,
    /// Positions of the nodes \[m\], one line after the other.
    pub nodes: &'a [V3],
}

/// A row of the record, computed now or read back from an earlier run.
#[derive(Clone, Copy)]
pub struct RecordRow<'a> {
    /// Time \[s\].
    pub time: f64,
    /// Values of the channels.
    pub values: &'a [f64],
    /// The shapes of the lines, at the times at which shapes are stored.
    pub shapes: &'a [LineShape],
}

/// A run that is over.
#[derive(Clone, Copy)]
pub struct RunEnd<'a> {
    /// The lines.
    pub lines: &'a [LineAtEnd<'a>],
}

/// A line at the end of a run.
#[derive(Clone, Copy)]
pub struct LineAtEnd<'a> {
    /// The line after its last event.
    pub scene: &'a Scene,
    /// Its last state, where there was one.
    pub state: Option<&'a State>,
}

/// All that is recorded of a run.
#[derive(Debug, Clone, Default)]
pub struct RunRecord {
    /// Channels against time.
    pub history: History,
    /// Shapes of the lines.
    pub shapes: Vec<LineShape>,
    /// The lines node by node.
    pub profiles: Vec<Profile>,
    /// The statistics asked for; `None` where one cannot be taken.
    pub statistics: Vec<(RequestedStatistic, Option<f64>)>,
    /// The channels shortly before the end.
    pub late: LateSamples,
    /// The energy balance, without errors; empty where none is stated.
    pub energy: Vec<Quantity>,
    /// The same as sums.
    pub balance: Option<EnergyBalance>,
    /// The damage along the lines, where checks count it.
    pub fatigue: Vec<FatigueSpot>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

impl RunRecord {
    /// The first line node by node; one without nodes where there is none.
    pub(super) fn profile(&self) -> &Profile {
        static NONE: LazyLock<Profile> = LazyLock::new(Profile::default);
        self.profiles.first().unwrap_or(&NONE)
    }
}

/// Records something of a run. The profiles are shared: several observers widen their envelopes.
pub trait Observer {
    /// Takes in an accepted step, line by line; must not allocate.
    fn accepted_step(&mut self, _at: &LineStep<'_>, _profile: &mut Profile) {}

    /// Takes in what lies between two accepted steps, one after the other without gaps; must not allocate.
    fn interval(&mut self, _between: &StepInterval<'_>, _profiles: &mut [Profile]) {}

    /// Follows a node of a line that comes or goes.
    fn node_change(&mut self, _change: NodeChange) {}

    /// Takes in the energy before and after a node came or went.
    fn energy_jump(&mut self, _before: &EnergyRates, _after: &EnergyRates) {}

    /// Whether it reads the lines at every output time.
    fn reads_lines(&self) -> bool {
        false
    }

    /// Takes in an output time, where [any](Observer::reads_lines) reads the lines.
    fn output(&mut self, _sample: &OutputSample<'_>) {}

    /// Takes in a row of the record.
    fn row(&mut self, _row: &RecordRow<'_>) {}

    /// Writes what it needs to be resumed.
    fn save(&self, _state: &mut RecorderState) {}

    /// Whether a state holds what it needs, in these sizes.
    fn fits(&self, _state: &RecorderState) -> bool {
        true
    }

    /// Continues from a state, after the rows recorded before it.
    fn restore(&mut self, _state: &RecorderState) {}

    /// Completes the record once the run is over.
    fn finish(self: Box<Self>, _end: &RunEnd<'_>, _record: &mut RunRecord) {}
}
