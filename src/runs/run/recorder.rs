//! Records a run: reads the channels of every accepted step, and passes them and what lies between to the observers. Rows are
//! written at the output times, which change no step.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use super::channel_reading::ChannelReading;
use super::event::{JobEvent, Listener};
use super::observer::{Observation, Observer, OutputSample, RecordRow, RunEnd, RunRecord};
use super::observers::observers;
use super::step_interval::{LatestSteps, StepInterval, StepSample};
use super::store::{CHECKPOINT, StoreError};
use super::{
    Checkpoint, LineShape, OutputFrame, Progress, ResumedRun, energy_balance, replay, step_envelope,
};
use crate::case::{self, Case, ChannelQuantity, ChannelSpec, Method};
use crate::scene::Scene;
use crate::solve::{AcceptedStep, Kinematics, Progressing, Sink, State};

/// Records a run. Between output times a step costs the tensions of the line and no allocation.
pub(super) struct Recorder<'a> {
    case: &'a Case,
    /// Its digests, once a checkpoint needs them.
    digests: Option<BTreeMap<String, String>>,
    initial: &'a Scene,
    scene: &'a Scene,
    channels: Vec<ChannelSpec>,
    latest: LatestSteps,
    /// Whether the energy balance is read: that of a dynamic run.
    balances: bool,
    /// Which channels are nowhere negative: tensions.
    positive: Vec<bool>,
    /// The values of the channels at an output time, and the line there where it is read.
    row: StepSample,
    /// Whether an observer reads the line at every output time.
    reads_line: bool,
    /// Rows recorded so far.
    rows: u64,
    output_times: OutputTimes,
    /// The first value that is not finite, in words: what ends the run.
    fault: Option<String>,
    observers: Vec<Box<dyn Observer>>,
    record: RunRecord,
    /// Time of the latest shape \[s\].
    latest_shape: Option<f64>,
    duration: f64,
    /// The state at the end.
    end: Option<State>,
    clock: std::time::Instant,
    progress: Progress,
    /// Receives every output time.
    events: Listener<'a>,
    cancel: &'a AtomicBool,
}

impl<'a> Recorder<'a> {
    /// A recorder for one run.
    pub(super) fn new(
        case: &'a Case,
        scene: &'a Scene,
        events: Listener<'a>,
        cancel: &'a AtomicBool,
    ) -> Self {
        let channels = case::channels(case);
        let at_rest = case.solver.method == Method::Static;
        let observers = observers(case, scene, &channels);
        Self {
            case,
            digests: None,
            initial: scene,
            scene,
            reads_line: observers.iter().any(|observer| observer.reads_line()),
            observers,
            record: RunRecord {
                profile: step_envelope::profile(scene),
                ..RunRecord::default()
            },
            balances: energy_balance::is_stated(case),
            latest: LatestSteps::new(channels.len(), scene.line_nodes()),
            positive: channels
                .iter()
                .map(|channel| channel.id.quantity == ChannelQuantity::Tension)
                .collect(),
            row: StepSample::new(channels.len(), scene.line_nodes()),
            rows: 0,
            output_times: OutputTimes::of(case),
            fault: None,
            channels,
            latest_shape: None,
            duration: if at_rest { 0.0 } else { case.solver.duration_s },
            end: None,
            clock: std::time::Instant::now(),
            progress: Progress::default(),
            events,
            cancel,
        }
    }

    /// The flag that stops the run.
    pub(super) fn cancel(&self) -> &'a AtomicBool {
        self.cancel
    }

    /// Completes a checkpoint by the state of the observers, and sends it.
    pub(super) fn send_checkpoint(&mut self, mut checkpoint: Checkpoint) {
        let Some(events) = self.events.as_mut().filter(|_| self.fault.is_none()) else {
            return;
        };
        let digests = self.digests.get_or_insert_with(|| case::digests(self.case));
        checkpoint.case.clone_from(digests);
        checkpoint.profile = self.record.profile.clone();
        checkpoint.output_interval_s = self.output_times.interval;
        checkpoint.rows = self.rows;
        checkpoint.latest = self.latest.clone();
        for observer in &self.observers {
            observer.save(&mut checkpoint);
        }
        events(JobEvent::Checkpoint(Box::new(checkpoint)));
    }

    /// Continues from a checkpoint: the rows recorded before it are recorded and sent again, and it with them, so that the new run
    /// can be resumed before it has one of its own.
    ///
    /// # Errors
    /// The earlier record does not reach the checkpoint, or the checkpoint is not that of this line.
    pub(super) fn restore(&mut self, from: &ResumedRun) -> Result<(), StoreError> {
        let mut observers = self.observers.iter();
        if !observers.all(|observer| observer.fits(&from.checkpoint)) {
            return Err(StoreError::Damaged {
                file: from.dir.join(CHECKPOINT),
                reason:
                    "it does not belong to this case: it has not the statistics of its channels"
                        .to_owned(),
            });
        }
        let ids: Vec<_> = self.channels.iter().map(|c| c.id.clone()).collect();
        replay::replay(from, &ids, &mut |time, values, shape| {
            self.row.values.copy_from_slice(values);
            self.progress = Progress {
                time,
                duration: self.duration,
                ..self.progress
            };
            self.record_row(time, shape);
        })?;
        for observer in &mut self.observers {
            observer.restore(&from.checkpoint);
        }
        self.latest.clone_from(&from.checkpoint.latest);
        self.record.profile.clone_from(&from.checkpoint.profile);
        if let Some(events) = &mut self.events {
            events(JobEvent::Checkpoint(Box::new(from.checkpoint.clone())));
        }
        Ok(())
    }

    /// Takes in what is left before the line changes by an event.
    pub(super) fn leave(&mut self) {
        self.take_in_interval(true);
        self.latest.clear();
    }

    /// Continues with the line as it is after an event, from this state on.
    pub(super) fn enter(&mut self, scene: &'a Scene, time: f64, state: &State) {
        self.scene = scene;
        self.read(time, state);
    }

    /// The case.
    pub(super) fn case(&self) -> &Case {
        self.case
    }

    /// Number of channels.
    pub(super) fn channels(&self) -> usize {
        self.channels.len()
    }

    /// Continues with the line as it was at a checkpoint.
    pub(super) fn resume_with(&mut self, scene: &'a Scene) {
        self.scene = scene;
    }

    /// Takes in what is left at the end.
    pub(super) fn end(&mut self, state: &State) {
        self.take_in_interval(true);
        self.end = self.fault.is_none().then(|| state.clone());
    }

    /// Why the run cannot go on: the first value that is not finite, with its time.
    pub(super) fn fault(&self) -> Option<String> {
        self.fault.clone()
    }

    /// The complete record of the run.
    pub(super) fn finish(self) -> RunRecord {
        let end = RunEnd {
            case: self.case,
            initial: self.initial,
            last: self.scene,
            state: self.end.as_ref(),
        };
        let mut record = self.record;
        for observer in self.observers {
            observer.finish(&end, &mut record);
        }
        record
    }

    /// Reads an accepted step into the latest ones.
    fn read(&mut self, time: f64, state: &State) {
        let sample = self.latest.next();
        sample.time = time;
        let StepSample {
            values,
            tension,
            nodes,
            energy,
            ..
        } = sample;
        *energy = self.scene.read_step(time, state, self.balances, tension);
        let mut reading = ChannelReading::new(self.scene, time, state, tension);
        for (value, channel) in values.iter_mut().zip(&self.channels) {
            let read = reading.channel(channel.id.quantity, channel.site);
            *value = read.unwrap_or(f64::NAN);
        }
        let wild = values.iter().position(|value| !value.is_finite());
        let fault = match wild {
            Some(channel) => Some(self.channels[channel].id.to_string()),
            None => tension
                .iter()
                .position(|tension| !tension.is_finite())
                .map(|node| format!("the tension at node {node}")),
        };
        let known = nodes.len();
        nodes.copy_from_slice(&state.x[..known]);
        if let Some(what) = fault {
            // Nothing is recorded of such a step.
            self.latest.forget_latest();
            self.fault
                .get_or_insert_with(|| format!("{what} is not finite at t = {time:.6} s"));
            return;
        }
        if self.balances && self.rows == 0 {
            self.begin_balance(time, state);
        }
    }

    /// Reads the energy of the first state with its ends in motion: a line at rest whose ends move from time zero on is pulled along
    /// at once, and the kinetic energy of the ends themselves is no work of a force.
    fn begin_balance(&mut self, time: f64, state: &State) {
        let mut moving = state.clone();
        self.scene.prescribe(time, &mut moving);
        if let Some(first) = self.latest.latest_mut() {
            first.energy = self.scene.energy_rates(time, &moving);
        }
    }

    /// Passes on what lies between the latest two steps that have a step after them, or between the `last` two; then the rows
    /// in it.
    fn take_in_interval(&mut self, last: bool) {
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
            observer.interval(&between, &mut self.record.profile);
        }
        let until = between.time()[1];
        while let Some(time) = self.output_times.due(self.rows, until) {
            let reads_line = self.reads_line || self.shape_is_due(time);
            if let Some(between) = interval(&self.latest, &self.positive, last) {
                let row = &mut self.row;
                between.sample_channels(time, &mut row.values);
                if reads_line {
                    between.sample_line(time, &mut row.tension, &mut row.nodes);
                }
            }
            self.output(time);
        }
    }

    /// Records an output time, read into the row.
    fn output(&mut self, time: f64) {
        if self.reads_line {
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
        let shape = self.shape_is_due(time).then(|| LineShape {
            time,
            nodes: self.row.nodes.iter().map(|p| [p.x, p.y, p.z]).collect(),
            tension: self.row.tension.clone(),
        });
        self.record_row(time, shape);
    }

    /// Whether the shape at an output time is stored: one an interval, and the last.
    fn shape_is_due(&self, time: f64) -> bool {
        let interval = self.case.output.shape_interval_s;
        let next = |latest: f64| latest + interval * (1.0 - 1e-9);
        self.latest_shape.is_none_or(|latest| time >= next(latest))
            || time >= self.duration * (1.0 - 1e-12)
    }

    /// Passes the latest values on as a row of the record, and sends them.
    fn record_row(&mut self, time: f64, shape: Option<LineShape>) {
        self.latest_shape = shape.as_ref().map(|s| s.time).or(self.latest_shape);
        self.rows += 1;
        let row = RecordRow {
            time,
            values: &self.row.values,
            shape: shape.as_ref(),
        };
        for observer in &mut self.observers {
            observer.row(&row);
        }
        if let Some(events) = &mut self.events {
            events(JobEvent::Frame(Box::new(OutputFrame {
                time,
                values: self.row.values.clone(),
                shape,
                progress: self.progress,
            })));
        }
    }
}

impl Sink for Recorder<'_> {
    fn accept(&mut self, instant: AcceptedStep<'_>) -> Progressing {
        let (time, state) = (instant.time, instant.state);
        self.read(time, state);
        if self.fault.is_some() {
            return Progressing::Stop;
        }
        let at = Observation {
            scene: self.scene,
            time,
            state,
        };
        for observer in &mut self.observers {
            observer.accepted_step(&at, &mut self.record.profile);
        }
        self.progress.steps = instant.steps;
        if self.rows == 0 {
            if let Some(first) = self.latest.latest() {
                self.row.clone_from(first);
            }
            self.output(time);
        }
        self.take_in_interval(false);
        if self.cancel.load(Ordering::Relaxed) {
            Progressing::Stop
        } else {
            Progressing::Continue
        }
    }

    fn jump(&mut self, time: f64, state: &State) {
        self.leave();
        self.read(time, state);
    }
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

/// The times of the rows of the record: intervals that divide the duration.
pub(super) struct OutputTimes {
    pub(super) interval: f64,
    count: u64,
    duration: f64,
}

impl OutputTimes {
    pub(super) fn of(case: &Case) -> Self {
        const SAME: f64 = 1e-9;
        let (duration, interval) = (case.solver.duration_s, case.output.interval_s);
        let count = (duration / interval).round().max(1.0);
        // A run that is resumed to a later time goes on with the same intervals to the bit, where both are whole numbers of them.
        let whole = (count * interval / duration - 1.0).abs() < SAME;
        Self {
            interval: if whole { interval } else { duration / count },
            count: count as u64,
            duration,
        }
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        self.count as usize + 1
    }

    /// The time of a row by its number, if it is not after `until` \[s\].
    fn due(&self, number: u64, until: f64) -> Option<f64> {
        let time = if number == self.count {
            self.duration
        } else {
            number as f64 * self.interval
        };
        (number <= self.count && time <= until).then_some(time)
    }
}
