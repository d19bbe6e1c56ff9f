//! Records a run: reads the channels of every accepted step and passes them to the observers.

use super::channel_reading::ChannelReading;
use super::event::Event;
use super::observer::{Observation, Observer, RecordRow, RunEnd, RunRecord};
use super::observers::observers;
use super::store::StoreError;
use super::{Checkpoint, Frame, LineShape, Progress, Resume, output_envelope, replay};
use crate::case::{self, Case, ChannelSpec, Method};
use crate::scene::Scene;
use crate::solve::{Instant, Progressing, Sink};

/// Records a run. Between output times a step costs a few tensions and no allocation.
pub(super) struct Recorder<'a> {
    case: &'a Case,
    initial: &'a Scene,
    scene: &'a Scene,
    channels: Vec<ChannelSpec>,
    /// Values of the channels at the latest step.
    values: Vec<f64>,
    observers: Vec<Box<dyn Observer>>,
    record: RunRecord,
    /// Time of the latest shape \[s\].
    latest_shape: Option<f64>,
    duration: f64,
    clock: std::time::Instant,
    progress: Progress,
    /// Receives every output time.
    events: &'a mut dyn FnMut(Event),
    stop: &'a dyn Fn() -> bool,
}

impl<'a> Recorder<'a> {
    /// A recorder for one run.
    pub(super) fn new(
        case: &'a Case,
        scene: &'a Scene,
        events: &'a mut dyn FnMut(Event),
        stop: &'a dyn Fn() -> bool,
    ) -> Self {
        let channels = case::channels(case);
        let at_rest = case.solver.method == Method::Static;
        Self {
            case,
            initial: scene,
            scene,
            observers: observers(case, scene, &channels),
            record: RunRecord {
                profile: output_envelope::profile(scene),
                ..RunRecord::default()
            },
            values: vec![0.0; channels.len()],
            channels,
            latest_shape: None,
            duration: if at_rest { 0.0 } else { case.solver.duration_s },
            clock: std::time::Instant::now(),
            progress: Progress::default(),
            events,
            stop,
        }
    }

    /// Completes a checkpoint by the state of the observers, and sends it.
    pub(super) fn send_checkpoint(&mut self, mut checkpoint: Checkpoint) {
        checkpoint.profile = self.record.profile.clone();
        for observer in &self.observers {
            observer.save(&mut checkpoint);
        }
        (self.events)(Event::Checkpoint(Box::new(checkpoint)));
    }

    /// Continues from a checkpoint: the rows recorded before it are recorded and sent again.
    ///
    /// # Errors
    /// The earlier record does not reach the checkpoint.
    pub(super) fn restore(&mut self, from: &Resume) -> Result<(), StoreError> {
        replay::replay(from, &mut |time, values, shape| {
            self.values.copy_from_slice(values);
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
        self.record.profile.clone_from(&from.checkpoint.profile);
        Ok(())
    }

    /// Continues with the line as it is after an event.
    pub(super) fn enter(&mut self, scene: &'a Scene) {
        for observer in &mut self.observers {
            observer.line_changes(self.scene, &mut self.record.profile);
        }
        self.scene = scene;
    }

    /// The complete record of the run.
    pub(super) fn finish(self) -> RunRecord {
        let end = RunEnd {
            case: self.case,
            initial: self.initial,
            last: self.scene,
        };
        let mut record = self.record;
        for observer in self.observers {
            observer.finish(&end, &mut record);
        }
        record
    }

    /// Records an output time.
    fn output(&mut self, instant: &Instant<'_>) {
        let tension = self.scene.tensions(instant.state);
        let at = Observation {
            scene: self.scene,
            time: instant.time,
            state: instant.state,
            values: &self.values,
        };
        for observer in &mut self.observers {
            observer.output(&at, &tension, &mut self.record.profile);
        }
        self.progress = Progress {
            time: instant.time,
            duration: self.duration,
            steps: instant.steps,
            wall_s: self.clock.elapsed().as_secs_f64(),
            estimating: false,
        };
        let shape = self.shape_is_due(instant.time).then(|| {
            let nodes = instant.state.x.iter().map(|p| [p.x, p.y, p.z]);
            LineShape {
                time: instant.time,
                nodes: nodes.take(tension.len()).collect(),
                tension,
            }
        });
        self.record_row(instant.time, shape);
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
        let row = RecordRow {
            time,
            values: &self.values,
            shape: shape.as_ref(),
        };
        for observer in &mut self.observers {
            observer.row(&row);
        }
        let frame = Frame {
            time,
            values: self.values.clone(),
            shape,
            progress: self.progress,
        };
        (self.events)(Event::Frame(Box::new(frame)));
    }
}

impl Sink for Recorder<'_> {
    fn accept(&mut self, instant: Instant<'_>) -> Progressing {
        let (time, state) = (instant.time, instant.state);
        let mut reading = ChannelReading::new(self.scene, time, state);
        for (value, channel) in self.values.iter_mut().zip(&self.channels) {
            let read = reading.channel(channel.id.quantity, channel.site);
            *value = read.unwrap_or(f64::NAN);
        }
        let at = Observation {
            scene: self.scene,
            time,
            state,
            values: &self.values,
        };
        for observer in &mut self.observers {
            observer.accepted_step(&at, &mut self.record.profile);
        }
        if instant.output {
            self.output(&instant);
        }
        if (self.stop)() {
            Progressing::Stop
        } else {
            Progressing::Continue
        }
    }
}
