//! Records a line by itself, as it is between its events.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use super::event::{JobEvent, Listener};
use super::observer::{LineAtEnd, RunEnd, RunRecord};
use super::observers::observers;
use super::output_times::OutputTimes;
use super::recorded::RecordedLine;
use super::recorder::{Recorder, RecorderPlan};
use super::store::{CHECKPOINT, StoreError};
use super::{Checkpoint, ResumedRun, energy_balance, step_envelope};
use crate::case::{self, Case, ChannelSpec, Method};
use crate::scene::Scene;
use crate::solve::{AcceptedStep, Kinematics, Progressing, Sink, State};

/// Records a line.
pub(super) struct LineRecorder<'a> {
    case: &'a Case,
    /// Its digests, once a checkpoint needs them.
    digests: Option<BTreeMap<String, String>>,
    initial: &'a Scene,
    scene: &'a Scene,
    channels: Vec<ChannelSpec>,
    recorder: Recorder<'a>,
    /// The state at the end.
    end: Option<State>,
}

impl<'a> LineRecorder<'a> {
    /// A recorder for one run.
    pub(super) fn new(
        case: &'a Case,
        scene: &'a Scene,
        events: Listener<'a>,
        cancel: &'a AtomicBool,
    ) -> Self {
        let channels = case::channels(case);
        let at_rest = case.solver.method == Method::Static;
        let plan = RecorderPlan {
            channels: channels.iter().map(|channel| channel.id.clone()).collect(),
            profiles: vec![step_envelope::profile(scene)],
            observers: observers(case, scene, &channels),
            balances: energy_balance::is_stated(case),
            output_times: OutputTimes::new(case.solver.duration_s, case.output.interval_s),
            shape_interval: Some(case.output.shape_interval_s),
            duration: if at_rest { 0.0 } else { case.solver.duration_s },
        };
        Self {
            case,
            digests: None,
            initial: scene,
            scene,
            channels,
            recorder: Recorder::new(plan, events, cancel),
            end: None,
        }
    }

    /// The flag that stops the run.
    pub(super) fn cancel(&self) -> &'a AtomicBool {
        self.recorder.cancel()
    }

    /// Completes a checkpoint by what is recorded, and sends it.
    pub(super) fn send_checkpoint(&mut self, mut checkpoint: Checkpoint) {
        if !self.recorder.takes_checkpoints() {
            return;
        }
        let digests = self.digests.get_or_insert_with(|| case::digests(self.case));
        checkpoint.case.clone_from(digests);
        checkpoint.recorded = self.recorder.state();
        self.recorder
            .send(JobEvent::Checkpoint(Box::new(checkpoint)));
    }

    /// Continues from a checkpoint: the rows recorded before it are recorded and sent again, and it with them, so that the new run
    /// can be resumed before it has one of its own.
    ///
    /// # Errors
    /// The earlier record does not reach the checkpoint, or the checkpoint is not that of this line.
    pub(super) fn restore(&mut self, from: &ResumedRun) -> Result<(), StoreError> {
        if !self.recorder.fits(&from.checkpoint.recorded) {
            return Err(StoreError::Damaged {
                file: from.dir.join(CHECKPOINT),
                reason:
                    "it does not belong to this case: it has not the statistics of its channels"
                        .to_owned(),
            });
        }
        self.recorder
            .restore(&from.checkpoint.recorded, &from.dir)?;
        self.recorder
            .send(JobEvent::Checkpoint(Box::new(from.checkpoint.clone())));
        Ok(())
    }

    /// Takes in what is left before the line changes by an event.
    pub(super) fn leave(&mut self, state: &State) {
        let line = RecordedLine {
            scene: self.scene,
            channels: &self.channels,
        };
        self.recorder.leave(&line, state);
    }

    /// Continues with the line as it is after an event, from this state on.
    pub(super) fn enter(&mut self, scene: &'a Scene, time: f64, state: &State) {
        self.scene = scene;
        let line = RecordedLine {
            scene,
            channels: &self.channels,
        };
        self.recorder.read(&line, time, state);
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
        let line = RecordedLine {
            scene: self.scene,
            channels: &self.channels,
        };
        self.recorder.end(&line, state);
        self.end = self.fault().is_none().then(|| state.clone());
    }

    /// Why the run cannot go on: the first value that is not finite, with its time.
    pub(super) fn fault(&self) -> Option<String> {
        self.recorder.fault().map(str::to_owned)
    }

    /// The complete record of the run.
    pub(super) fn finish(self) -> RunRecord {
        self.recorder.finish(&RunEnd {
            single_line: Some((self.case, self.initial)),
            lines: &[LineAtEnd {
                scene: self.scene,
                state: self.end.as_ref(),
            }],
        })
    }

    /// Reads the energy of the first state with its ends in motion: a line at rest whose ends move from time zero on is pulled along
    /// at once, and the kinetic energy of the ends themselves is no work of a force.
    fn begin_balance(&mut self, time: f64, state: &State) {
        let mut moving = state.clone();
        self.scene.prescribe(time, &mut moving);
        let energy = self.scene.energy_rates(time, &moving);
        self.recorder.set_energy(energy);
    }
}

impl Sink for LineRecorder<'_> {
    fn accept(&mut self, instant: AcceptedStep<'_>) -> Progressing {
        let (time, state) = (instant.time, instant.state);
        let begins = self.recorder.begins_balance();
        let line = RecordedLine {
            scene: self.scene,
            channels: &self.channels,
        };
        let going = self.recorder.accept(&line, time, state, instant.steps);
        if begins {
            self.begin_balance(time, state);
        }
        going
    }

    fn jump(&mut self, time: f64, state: &State) {
        let line = RecordedLine {
            scene: self.scene,
            channels: &self.channels,
        };
        self.recorder.jump(&line, time, state);
    }
}
