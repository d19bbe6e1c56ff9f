//! Records a run while it marches through time: rows at output times, shapes at their interval, statistics of every step; passes
//! the rows on.
//!
//! What lies between two steps is interpolated with the steps around them ([`step_interval`](super::step_interval)): it is
//! taken in once the next step is known, one step late.

use std::sync::atomic::{AtomicBool, Ordering};

use super::event::{JobEvent, Listener};
use super::observer::{LineStep, NodeChange, Observer, OutputSample, RecordRow, RunEnd, RunRecord};
use super::output_times::OutputTimes;
use super::recorded::Recorded;
use super::recorder_state::RecorderState;
use super::replay;
use super::step_interval::{LatestSteps, StepInterval, StepSample};
use super::store::StoreError;
use super::{LineShape, OutputFrame, Profile, Progress, step_envelope};
use crate::case::{ChannelId, ChannelQuantity};
use crate::numerics::V3;
use crate::scene::{EnergyRates, Scene};
use crate::solve::{Progressing, State};

/// Records a run. Between output times a step costs the tensions of the lines and no allocation.
pub struct Recorder<'a> {
    channels: Vec<ChannelId>,
    latest: LatestSteps,
    /// Whether the energy balance is read: that of a dynamic run.
    balances: bool,
    /// Which channels are nowhere negative: tensions.
    positive: Vec<bool>,
    /// The values of the channels at an output time, and the lines there where they are read.
    row: StepSample,
    /// Whether an observer reads the lines at every output time.
    reads_lines: bool,
    /// Rows recorded so far.
    rows: u64,
    output_times: OutputTimes,
    shape_interval: Option<f64>,
    /// The first value that is not finite, in words: what ends the run.
    fault: Option<String>,
    observers: Vec<Box<dyn Observer>>,
    record: RunRecord,
    /// Energy before the latest change.
    left: Option<EnergyRates>,
    /// Time of the latest shape \[s\].
    latest_shape: Option<f64>,
    duration: f64,
    clock: std::time::Instant,
    progress: Progress,
    /// Receives every output time.
    events: Listener<'a>,
    cancel: &'a AtomicBool,
}

/// What a run records.
pub struct RecorderPlan {
    /// Its channels.
    pub channels: Vec<ChannelId>,
    /// Its lines before the first step.
    pub profiles: Vec<Profile>,
    /// What records more of it.
    pub observers: Vec<Box<dyn Observer>>,
    /// Whether the energy balance is read.
    pub balances: bool,
    /// When rows are due.
    pub output_times: OutputTimes,
    /// The least time between two shapes \[s\]; none where no shapes are kept.
    pub shape_interval: Option<f64>,
    /// Its end \[s\].
    pub duration: f64,
}

impl<'a> Recorder<'a> {
    /// A recorder for one run.
    #[must_use]
    pub fn new(plan: RecorderPlan, events: Listener<'a>, cancel: &'a AtomicBool) -> Self {
        let RecorderPlan {
            channels,
            profiles,
            observers,
            balances,
            output_times,
            shape_interval,
            duration,
        } = plan;
        let nodes = profiles.iter().map(|profile| profile.arc.len()).sum();
        Self {
            reads_lines: observers.iter().any(|observer| observer.reads_lines()),
            observers,
            record: RunRecord {
                profiles,
                ..RunRecord::default()
            },
            balances,
            latest: LatestSteps::new(channels.len(), nodes),
            positive: channels
                .iter()
                .map(|id| id.quantity == ChannelQuantity::Tension)
                .collect(),
            row: StepSample::new(channels.len(), nodes),
            rows: 0,
            output_times,
            shape_interval,
            fault: None,
            channels,
            left: None,
            latest_shape: None,
            duration,
            clock: std::time::Instant::now(),
            progress: Progress::default(),
            events,
            cancel,
        }
    }

    /// The flag that stops the run.
    #[must_use]
    pub fn cancel(&self) -> &'a AtomicBool {
        self.cancel
    }

    /// The channels.
    #[must_use]
    pub fn channels(&self) -> &[ChannelId] {
        &self.channels
    }

    /// When rows are due.
    #[must_use]
    pub const fn output_times(&self) -> OutputTimes {
        self.output_times
    }

    /// Time of the last step \[s\].
    #[must_use]
    pub fn reached(&self) -> f64 {
        self.latest.latest().map_or(0.0, |step| step.time)
    }

    /// Why the run cannot go on: the first value that is not finite, with its time.
    #[must_use]
    pub fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// Whether anybody listens, and nothing is wrong: what a checkpoint is sent by.
    #[must_use]
    pub fn takes_checkpoints(&self) -> bool {
        self.events.is_some() && self.fault.is_none()
    }

    /// Sends an event.
    pub fn send(&mut self, event: JobEvent) {
        if let Some(events) = &mut self.events {
            events(event);
        }
    }

    /// What is recorded so far, but for the rows.
    #[must_use]
    pub fn state(&self) -> RecorderState {
        let mut state = RecorderState {
            output_interval_s: self.output_times.interval,
            rows: self.rows,
            latest: self.latest.clone(),
            profiles: self.record.profiles.clone(),
            ..RecorderState::default()
        };
        for observer in &self.observers {
            observer.save(&mut state);
        }
        state
    }

    /// Whether every observer finds in a state what it needs.
    #[must_use]
    pub fn fits(&self, state: &RecorderState) -> bool {
        self.observers.iter().all(|observer| observer.fits(state))
    }

    /// Continues from a state: the rows recorded before it in this run directory are recorded and sent again.
    ///
    /// # Errors
    /// The earlier record does not reach the state.
    pub fn restore(
        &mut self,
        state: &RecorderState,
        dir: &std::path::Path,
    ) -> Result<(), StoreError> {
        let ids = self.channels.clone();
        replay::replay(dir, state, &ids, &mut |time, values, shapes| {
            self.row.values.copy_from_slice(values);
            self.progress = Progress {
                time,
                duration: self.duration,
                ..self.progress
            };
            self.record_row(time, shapes);
        })?;
        for observer in &mut self.observers {
            observer.restore(state);
        }
        self.latest.clone_from(&state.latest);
        self.record.profiles.clone_from(&state.profiles);
        self.size_row();
        Ok(())
    }

    /// Takes in an accepted step, the `steps`th.
    pub fn accept<R: Recorded>(
        &mut self,
        recorded: &R,
        time: f64,
        state: &R::State,
        steps: u64,
    ) -> Progressing {
        self.read(recorded, time, state);
        if self.fault.is_some() {
            return Progressing::Stop;
        }
        for (number, profile) in self.record.profiles.iter_mut().enumerate() {
            let (scene, state) = recorded.line(number, state);
            let at = LineStep {
                number,
                scene,
                time,
                state,
            };
            for observer in &mut self.observers {
                observer.accepted_step(&at, profile);
            }
        }
        self.progress.steps = steps;
        if self.rows == 0 {
            if let Some(first) = self.latest.latest() {
                self.row.clone_from(first);
            }
            self.output(recorded, state, time);
        }
        self.take_in_interval(recorded, state, false);
        if self.cancel.load(Ordering::Relaxed) {
            Progressing::Stop
        } else {
            Progressing::Continue
        }
    }

    /// Ends a stretch of smooth motion: what follows begins anew, from the state after a jump.
    pub fn jump<R: Recorded>(&mut self, recorded: &R, time: f64, state: &R::State) {
        self.leave(recorded, state);
        self.read(recorded, time, state);
    }

    /// Begins anew after a [`leave`](Self::leave) with the mesh before a node has come or gone, which changes the energy of a line.
    pub fn remesh<R: Recorded>(
        &mut self,
        recorded: &R,
        time: f64,
        state: &R::State,
        change: NodeChange,
    ) {
        if let Some(profile) = self.record.profiles.get_mut(change.line) {
            step_envelope::change_node(profile, change);
        }
        for observer in &mut self.observers {
            observer.node_change(change);
        }
        self.latest = LatestSteps::new(self.channels.len(), recorded.nodes(state));
        self.size_row();
        self.read(recorded, time, state);
        let after = self.latest.latest().map(|step| step.energy);
        if let (Some(before), Some(after)) = (self.left, after) {
            for observer in &mut self.observers {
                observer.energy_jump(&before, &after);
            }
        }
    }

    /// Takes in what is left before a change.
    pub fn leave<R: Recorded>(&mut self, recorded: &R, state: &R::State) {
        self.take_in_interval(recorded, state, true);
        self.left = self.latest.latest().map(|step| step.energy);
        self.latest.clear();
    }

    /// Takes in what is left at the end.
    pub fn end<R: Recorded>(&mut self, recorded: &R, state: &R::State) {
        self.take_in_interval(recorded, state, true);
    }

    /// Sets the energy of the latest step.
    pub(super) fn set_energy(&mut self, energy: EnergyRates) {
        if let Some(latest) = self.latest.latest_mut() {
            latest.energy = energy;
        }
    }

    /// Whether nothing is recorded yet, and the energy is.
    pub(super) fn begins_balance(&self) -> bool {
        self.balances && self.rows == 0 && self.fault.is_none()
    }

    /// The complete record of the run.
    #[must_use]
    pub fn finish(self, end: &RunEnd<'_>) -> RunRecord {
        let mut record = self.record;
        for observer in self.observers {
            observer.finish(end, &mut record);
        }
        record
    }

    /// Room for a row of as many nodes as steps have.
    fn size_row(&mut self) {
        let nodes = self.latest.nodes();
        self.row.tension.resize(nodes, 0.0);
        self.row.nodes.resize(nodes, V3::zeros());
    }

    /// Reads an accepted step into the latest ones.
    pub(super) fn read<R: Recorded>(&mut self, recorded: &R, time: f64, state: &R::State) {
        let sample = self.latest.next();
        sample.time = time;
        recorded.read(time, state, self.balances, sample);
        let wild = sample.values.iter().position(|value| !value.is_finite());
        let wild = match wild {
            Some(channel) => Some(self.channels[channel].to_string()),
            None => sample
                .tension
                .iter()
                .position(|tension| !tension.is_finite())
                .map(|node| tension_in_words(&self.record.profiles, node)),
        };
        let mut first = 0;
        for number in 0..recorded.lines() {
            let (scene, state) = recorded.line(number, state);
            let count = scene.line_nodes();
            sample.nodes[first..first + count].copy_from_slice(&state.x[..count]);
            first += count;
        }
        if let Some(what) = wild {
            // Nothing is recorded of such a step.
            self.latest.forget_latest();
            self.fault
                .get_or_insert_with(|| format!("{what} is not finite at t = {time:.6} s"));
        }
    }

    /// Passes on what lies between the latest two steps that have a step after them, or between the `last` two; then the rows
    /// in it.
    fn take_in_interval<R: Recorded>(&mut self, recorded: &R, state: &R::State, last: bool) {
        let Self {
            latest,
            positive,
            observers,
            ..
        } = self;
        let Some(between) = interval(latest, positive, last) else {
            return;
        };
        for observer in observers {
            observer.interval(&between, &mut self.record.profiles);
        }
        let until = between.time()[1];
        while let Some(time) = self.output_times.due(self.rows, until) {
            let reads_lines = self.reads_lines || self.shape_is_due(time);
            if let Some(between) = interval(&self.latest, &self.positive, last) {
                let row = &mut self.row;
                between.sample_channels(time, &mut row.values);
                if reads_lines {
                    between.sample_line(time, &mut row.tension, &mut row.nodes);
                }
            }
            self.output(recorded, state, time);
        }
    }

    /// Records an output time, read into the row, of lines as they are in a state around it.
    fn output<R: Recorded>(&mut self, recorded: &R, state: &R::State, time: f64) {
        if self.reads_lines {
            let nodes = &self.row.nodes;
            for observer in &mut self.observers {
                observer.output(&OutputSample { time, nodes });
            }
        }
        self.progress = Progress {
            time,
            duration: self.duration,
            wall_s: self.clock.elapsed().as_secs_f64(),
            ..self.progress
        };
        let shapes = match self.shape_is_due(time) {
            true => self.shapes(recorded, state, time),
            false => Vec::new(),
        };
        self.record_row(time, shapes);
    }

    /// The lines at an output time, as they are in the row.
    fn shapes<R: Recorded>(&self, recorded: &R, state: &R::State, time: f64) -> Vec<LineShape> {
        let (mut nodes, mut tension) = (&self.row.nodes[..], &self.row.tension[..]);
        let profiles = self.record.profiles.iter().enumerate();
        let shape = |(line, profile): (usize, &Profile)| {
            let count = profile.arc.len();
            let (own, rest) = nodes.split_at(count);
            let (own_tension, rest_tension) = tension.split_at(count);
            (nodes, tension) = (rest, rest_tension);
            let (scene, _) = recorded.line(line, state);
            let (curvature, height) = shape_reading(scene, own);
            LineShape {
                time,
                line,
                curvature,
                height,
                nodes: own.iter().map(|p| [p.x, p.y, p.z]).collect(),
                tension: own_tension.to_vec(),
            }
        };
        profiles.map(shape).collect()
    }

    /// Whether the shapes at an output time are stored: those of one time an interval, and the last.
    fn shape_is_due(&self, time: f64) -> bool {
        let Some(interval) = self.shape_interval else {
            return false;
        };
        let next = |latest: f64| latest + interval * (1.0 - 1e-9);
        self.latest_shape.is_none_or(|latest| time >= next(latest))
            || time >= self.duration * (1.0 - 1e-12)
    }

    /// Passes the latest values on as a row of the record, and sends them.
    fn record_row(&mut self, time: f64, shapes: Vec<LineShape>) {
        self.latest_shape = shapes.first().map(|s| s.time).or(self.latest_shape);
        self.rows += 1;
        let row = RecordRow {
            time,
            values: &self.row.values,
            shapes: &shapes,
        };
        for observer in &mut self.observers {
            observer.row(&row);
        }
        if let Some(events) = &mut self.events {
            events(JobEvent::Frame(Box::new(OutputFrame {
                time,
                values: self.row.values.clone(),
                shapes,
                progress: self.progress,
            })));
        }
    }
}

/// Curvatures \[1/m\] and heights above the bed \[m\] of a line whose nodes are at these places; none of a line that does not bend, or has no
/// bed.
fn shape_reading(scene: &Scene, nodes: &[V3]) -> (Vec<f64>, Vec<f64>) {
    let bed = scene.elements.bed.as_ref();
    let height = bed.map_or_else(Vec::new, |bed| {
        nodes.iter().map(|x| bed.height(x)).collect()
    });
    let curvature = scene
        .elements
        .flexure
        .as_ref()
        .map_or_else(Vec::new, |flexure| {
            let state = State::at_rest(nodes.to_vec());
            let at = |i| flexure.bent_at(i, &scene.line, &state).0;
            (0..nodes.len()).map(at).collect()
        });
    (curvature, height)
}

/// The tension at a node of all, in words.
fn tension_in_words(profiles: &[Profile], node: usize) -> String {
    let mut rest = node;
    for profile in profiles {
        if rest < profile.arc.len() {
            return match profile.line.as_str() {
                "" => format!("the tension at node {rest}"),
                name => format!("the tension at node {rest} of line {name}"),
            };
        }
        rest -= profile.arc.len();
    }
    format!("the tension at node {node}")
}

/// The latest interval that has a step after it, or the `last` one.
fn interval<'a>(
    latest: &'a LatestSteps,
    positive: &'a [bool],
    last: bool,
) -> Option<StepInterval<'a>> {
    if last {
        latest.last_interval(positive)
    } else {
        latest.complete_interval(positive)
    }
}
