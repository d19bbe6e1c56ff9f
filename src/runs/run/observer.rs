//! What records something of a run: the trait that the time march drives, and what it is given.

use super::along::FatigueSpot;
use super::late_samples::LateSamples;
use super::requested_statistics::RequestedStatistic;
use super::step_interval::StepInterval;
use super::{Checkpoint, History, LineShape, Profile, Quantity};
use crate::case::Case;
use crate::numerics::V3;
use crate::scene::Scene;
use crate::solve::State;

/// An accepted step.
#[derive(Clone, Copy)]
pub(super) struct Observation<'a> {
    /// The line, as it is since its last event.
    pub(super) scene: &'a Scene,
    /// Time \[s\].
    pub(super) time: f64,
    /// The state at that time.
    pub(super) state: &'a State,
}

/// The line at an output time, interpolated between two steps.
#[derive(Clone, Copy)]
pub(super) struct OutputSample<'a> {
    /// Time \[s\].
    pub(super) time: f64,
    /// Positions of the nodes of the line \[m\].
    pub(super) nodes: &'a [V3],
}

/// A row of the record, computed now or read back from an earlier run.
#[derive(Clone, Copy)]
pub(super) struct RecordRow<'a> {
    /// Time \[s\].
    pub(super) time: f64,
    /// Values of the channels.
    pub(super) values: &'a [f64],
    /// The shape of the line, at the times at which shapes are stored.
    pub(super) shape: Option<&'a LineShape>,
}

/// A run that is over.
#[derive(Clone, Copy)]
pub(super) struct RunEnd<'a> {
    /// The case.
    pub(super) case: &'a Case,
    /// The line at the start.
    pub(super) initial: &'a Scene,
    /// The line after its last event.
    pub(super) last: &'a Scene,
    /// Its last state, where there was one.
    pub(super) state: Option<&'a State>,
}

/// All that is recorded of a run.
#[derive(Debug, Clone, Default)]
pub(super) struct RunRecord {
    /// Channels against time.
    pub(super) history: History,
    /// Shapes of the line.
    pub(super) shapes: Vec<LineShape>,
    /// The line node by node.
    pub(super) profile: Profile,
    /// The statistics asked for; `None` where one cannot be taken.
    pub(super) statistics: Vec<(RequestedStatistic, Option<f64>)>,
    /// The channels shortly before the end.
    pub(super) late: LateSamples,
    /// The energy balance, without errors; empty where none is stated.
    pub(super) energy: Vec<Quantity>,
    /// The damage along the line, where checks count it.
    pub(super) fatigue: Vec<FatigueSpot>,
    /// What the user should know.
    pub(super) warnings: Vec<String>,
}

/// Records something of a run. The profile is shared: several observers widen its envelopes.
pub(super) trait Observer {
    /// Takes in an accepted step; must not allocate.
    fn accepted_step(&mut self, _at: &Observation<'_>, _profile: &mut Profile) {}

    /// Takes in what lies between two accepted steps, one after the other without gaps; must not allocate.
    fn interval(&mut self, _between: &StepInterval<'_>, _profile: &mut Profile) {}

    /// Whether it reads the line at every output time.
    fn reads_line(&self) -> bool {
        false
    }

    /// Takes in an output time, where [any](Observer::reads_line) reads the line.
    fn output(&mut self, _sample: &OutputSample<'_>) {}

    /// Takes in a row of the record.
    fn row(&mut self, _row: &RecordRow<'_>) {}

    /// Writes what it needs to be resumed.
    fn save(&self, _checkpoint: &mut Checkpoint) {}

    /// Whether a checkpoint holds what it needs, in these sizes.
    fn fits(&self, _checkpoint: &Checkpoint) -> bool {
        true
    }

    /// Continues from a checkpoint, after the rows recorded before it.
    fn restore(&mut self, _checkpoint: &Checkpoint) {}

    /// Completes the record once the run is over.
    fn finish(self: Box<Self>, _end: &RunEnd<'_>, _record: &mut RunRecord) {}
}
