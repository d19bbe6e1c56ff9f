//! The march of a run through time, from one change to the next.

use std::time::{Duration, Instant};

use super::checkpoint::{Checkpoint, Resumed};
use super::event::JobEvent;
use super::recorder::Recorder;
use super::store::{CHECKPOINT, StoreError};
use super::under_way::{MethodOf, StateOf, UnderWay};
use super::{RunState, Work};
use crate::dynamics::{Integrator, March, MarchError, MarchProgress, MethodState, Stepper};
use crate::limits::STEPS;
use crate::solve::{AcceptedStep, Marched, Progressing, Sink};

/// Least wall time between two checkpoints.
const BETWEEN_CHECKPOINTS: Duration = Duration::from_secs(2);

/// How a computation ended.
#[derive(Debug, Clone)]
pub struct MarchResult {
    /// Its state.
    pub state: RunState,
    /// Why it failed, if it did.
    pub failure: Option<String>,
    /// What it took.
    pub work: Work,
    /// Time that it came to \[s\].
    pub reached: f64,
    /// Lengths of the steps \[s\], and how many of each.
    pub lengths: Vec<(f64, u64)>,
}

impl MarchResult {
    /// A computation without steps.
    #[must_use]
    pub fn without_steps(state: RunState, failure: Option<String>, work: Work) -> Self {
        Self {
            state,
            failure,
            work,
            reached: 0.0,
            lengths: Vec::new(),
        }
    }

    /// A computation that was stopped before its first step.
    #[must_use]
    pub fn stopped(work: Work) -> Self {
        Self::without_steps(RunState::Cancelled, None, work)
    }

    /// A computation that failed before its first step.
    #[must_use]
    pub fn failed(failure: String, work: Work) -> Self {
        Self::without_steps(RunState::Failed, Some(failure), work)
    }
}

/// Why a march of so many steps is refused, and what to do: `fewer` steps, or a shorter run.
#[must_use]
pub fn too_many_steps(duration_s: f64, step_s: f64, fewer: &str) -> Option<(String, String)> {
    let steps = duration_s / step_s;
    STEPS.is_exceeded_by(steps).then(|| {
        (
            format!("it would take {steps:.1e} steps of {step_s:.1e} s"),
            STEPS.remedy(fewer, steps),
        )
    })
}

/// The start of a march: at time zero, or at the checkpoint of an earlier run.
pub struct MarchStart<'a, X> {
    /// An earlier run to be resumed.
    pub resume: Option<&'a Resumed<X>>,
    /// Whether the initial state is that of another run, whose history is taken in already.
    pub from_run: bool,
    /// State of the method at the end of that run.
    pub method_state: Option<MethodState>,
    /// Warnings of the start, which a resumed run repeats.
    pub warnings: Vec<String>,
    /// Work of the search for the start.
    pub work: Work,
}

impl<'a, X> MarchStart<'a, X> {
    /// At rest, found with this work, or at a checkpoint.
    #[must_use]
    pub fn at_rest(resume: Option<&'a Resumed<X>>, work: Work) -> Self {
        Self {
            resume,
            from_run: false,
            method_state: None,
            warnings: Vec::new(),
            work,
        }
    }
}

/// A march through time under way.
pub struct Marching<'a, T: UnderWay> {
    subject: T,
    state: StateOf<T>,
    method: MethodOf<T>,
    recorder: Recorder<'a>,
    march: March,
    place: MarchProgress,
    start: MarchStart<'a, StateOf<T>>,
    /// When the latest checkpoint was sent.
    saved: Instant,
}

impl<'a, T: UnderWay> Marching<'a, T> {
    /// From a state; nothing has moved yet. `march`: simulated time and length of a whole step.
    pub fn new(
        subject: T,
        state: StateOf<T>,
        march: March,
        recorder: Recorder<'a>,
        start: MarchStart<'a, StateOf<T>>,
    ) -> Self {
        let whole_step = start.resume.map(|from| from.checkpoint.whole_step_s);
        Self {
            method: subject.method(&state),
            subject,
            state,
            recorder,
            march: March {
                step: whole_step.unwrap_or(march.step),
                ..march
            },
            place: MarchProgress::default(),
            start,
            saved: Instant::now(),
        }
    }

    /// Marches to the end.
    pub fn run(&mut self) -> MarchResult {
        let begun = match self.start.resume {
            Some(from) => self.resume(from).map(|()| Progressing::Continue),
            None => self.begin(),
        };
        let ended = begun.and_then(|going| match going {
            Progressing::Continue => self.march(),
            Progressing::Stop => {
                self.checkpoint();
                Ok(going)
            }
        });
        self.end();
        self.result(ended)
    }

    /// Records the state as it is, at time zero, and no more.
    pub fn record_alone(&mut self, work: Work) -> MarchResult {
        let _: Progressing = self.record();
        self.end();
        match self.recorder.fault() {
            Some(fault) => MarchResult::failed(fault.to_owned(), work),
            None => MarchResult::without_steps(RunState::Done, None, work),
        }
    }

    fn record(&mut self) -> Progressing {
        let recorded = self.subject.recorded();
        self.recorder.accept(&recorded, 0.0, &self.state, 0)
    }

    /// Takes in what is left at the end.
    fn end(&mut self) {
        let recorded = self.subject.recorded();
        self.recorder.end(&recorded, &self.state);
    }

    /// The system at the end, its last state, and its record, to be finished.
    pub fn into_parts(self) -> (T, StateOf<T>, Recorder<'a>) {
        (self.subject, self.state, self.recorder)
    }

    /// The accelerations at the start, and the first row; a known acceleration stays: derived anew from the forces it would lose an order.
    fn begin(&mut self) -> Result<Progressing, String> {
        let (system, state) = (self.subject.system(), &mut self.state);
        system.update_wave_kinematics(0.0, state);
        let known = self.start.method_state.as_ref();
        let begun = match known {
            Some(_) => Ok(()),
            None => self.method.accelerate(system, 0.0, state),
        };
        if !self.start.from_run {
            system.commit(0.0, 0.0, state);
            if self.subject.begins_off_rest() {
                self.method.restart(system, 0.0, state);
            }
        }
        if let Some(known) = known {
            self.method.restore(known);
        }
        let begins_balance = self.recorder.begins_balance();
        let going = self.record();
        let energy = self.subject.energy_in_motion(&self.state);
        if let Some(energy) = energy.filter(|_| begins_balance) {
            self.recorder.set_energy(energy);
        }
        begun.map_err(|why| self.subject.in_words(0.0, None, &why))?;
        if let Some(fault) = self.recorder.fault() {
            return Err(fault.to_owned());
        }
        self.change_by_state()?;
        Ok(going)
    }

    /// Continues from the checkpoint of a stored run; its rows are recorded and sent again, and it with them, so that the new run can
    /// be resumed before it has one of its own.
    fn resume(&mut self, from: &Resumed<StateOf<T>>) -> Result<(), String> {
        let stored = &from.checkpoint;
        let channels = self.recorder.channels().len();
        let fits = self
            .subject
            .resume(stored, &mut self.state, channels, self.march);
        let fits = fits.and_then(|()| match self.recorder.fits(&stored.recorded) {
            true => Ok(()),
            false => Err("it has not the statistics of these channels and places".to_owned()),
        });
        fits.map_err(|reason| damaged(from, &reason))?;
        self.recorder
            .restore(&stored.recorded, &from.dir)
            .map_err(|why| why.to_string())?;
        self.renew_method(stored.time(), &stored.method);
        self.place = stored.place;
        self.send_checkpoint(stored);
        Ok(())
    }

    /// The method for a system of another size.
    fn renew_method(&mut self, time: f64, kept: &MethodState) {
        let system = self.subject.system();
        system.update_wave_kinematics(time, &mut self.state);
        self.method = self.subject.method(&self.state);
        self.method.restore(kept);
    }

    /// Marches from change to change; sends checkpoints at intervals, where it is stopped, and at the end: before the last whole step where
    /// the end cuts it short, so that a longer run resumes with a whole one.
    fn march(&mut self) -> Result<Progressing, String> {
        self.changes_due()?;
        while !self.march.is_over(&self.place) {
            let next = (self.place.whole + 1) as f64 * self.march.step;
            let cut_by_end = self.march.is_after_end(next);
            if cut_by_end {
                self.checkpoint();
            }
            let going = self.advance(next.min(self.subject.next_change()))?;
            if going == Progressing::Stop {
                self.checkpoint();
                return Ok(going);
            }
            self.changes_due()?;
            let due =
                self.march.is_over(&self.place) || self.saved.elapsed() >= BETWEEN_CHECKPOINTS;
            if due && !cut_by_end {
                self.checkpoint();
            }
        }
        Ok(Progressing::Continue)
    }

    /// Marches to a time, to the end, or to where the state changes the system, which it then does.
    fn advance(&mut self, until: f64) -> Result<Progressing, String> {
        let mut sink = RecordingSink {
            subject: &self.subject,
            recorder: &mut self.recorder,
            change: None,
        };
        let (place, method, state) = (&mut self.place, &mut self.method, &mut self.state);
        let system = self.subject.system();
        let going = self
            .march
            .advance(place, until, method, system, state, &mut sink);
        let change = sink.change;
        let in_words = |error: MarchError| {
            self.subject
                .in_words(error.time, Some(error.step), &error.why)
        };
        let going = going.map_err(in_words)?;
        if let Some(fault) = self.recorder.fault() {
            return Err(fault.to_owned());
        }
        match change {
            Some(change) => {
                self.change(change)?;
                self.change_by_state()?;
                Ok(Progressing::Continue)
            }
            None => Ok(going),
        }
    }

    /// Changes the system by all whose time has come.
    fn changes_due(&mut self) -> Result<(), String> {
        let (march, place) = (self.march, self.place);
        while let Some(change) = self
            .subject
            .due(&|time| march.is_at(&place, time), &self.state)
        {
            self.change(change)?;
        }
        Ok(())
    }

    /// Changes it by all that its state changes.
    fn change_by_state(&mut self) -> Result<(), String> {
        while let Some(change) = self.subject.by_state(self.recorder.reached(), &self.state) {
            self.change(change)?;
        }
        Ok(())
    }

    /// Changes the system, and starts the method anew, or continues it on another mesh.
    fn change(&mut self, change: T::Change) -> Result<(), String> {
        let time = self.recorder.reached();
        let recorded = self.subject.recorded();
        self.recorder.leave(&recorded, &self.state);
        drop(recorded);
        let mut kept = self.method.method_state();
        let node = self
            .subject
            .change(change, time, &mut self.state, &mut kept)?;
        match node {
            None => {
                let system = self.subject.system();
                self.method.restart(system, time, &mut self.state);
                let recorded = self.subject.recorded();
                self.recorder.read(&recorded, time, &self.state);
            }
            Some(node) => {
                self.renew_method(time, &kept);
                let recorded = self.subject.recorded();
                self.recorder.remesh(&recorded, time, &self.state, node);
            }
        }
        Ok(())
    }

    /// Sends the state of the march.
    fn checkpoint(&mut self) {
        if !self.recorder.takes_checkpoints() {
            return;
        }
        let checkpoint = Checkpoint {
            case: self.subject.digests(),
            whole_step_s: self.march.step,
            phase: self.subject.phase(),
            start_iterations: self.start.work.iterations,
            warnings: self.start.warnings.clone(),
            happened: self.subject.happened().to_vec(),
            place: self.place,
            method: self.method.method_state(),
            recorded: self.recorder.state(),
            state: self.state.clone(),
        };
        self.send_checkpoint(&checkpoint);
    }

    fn send_checkpoint(&mut self, checkpoint: &Checkpoint<StateOf<T>>) {
        if self.recorder.takes_checkpoints()
            // What cannot be written is no checkpoint; the run goes on without.
            && let Ok(text) = toml::to_string(checkpoint)
        {
            self.recorder.send(JobEvent::Checkpoint(text));
        }
        self.saved = Instant::now();
    }

    /// State, work and step lengths at the end.
    fn result(&self, ended: Result<Progressing, String>) -> MarchResult {
        let (state, failure) = match ended {
            Ok(Progressing::Stop) => (RunState::Cancelled, None),
            Ok(Progressing::Continue) => (RunState::Done, None),
            Err(why) => (RunState::Failed, Some(why)),
        };
        let counts = self.method.work_counts();
        MarchResult {
            state,
            failure,
            work: Work {
                steps: self.place.steps,
                rejections: self.place.rejections,
                iterations: self.start.work.iterations + counts.iterations,
                evaluations: self.start.work.evaluations + counts.evaluations,
            },
            reached: self.recorder.reached(),
            lengths: self.march.lengths(&self.place).collect(),
        }
    }
}

/// Why a run cannot be resumed.
fn damaged<X>(from: &Resumed<X>, reason: &str) -> String {
    let file = from.dir.join(CHECKPOINT);
    let reason = format!("it does not belong to this case: {reason}");
    StoreError::Damaged { file, reason }.to_string()
}

/// Records the steps of a march, and stops it where the state changes the system.
struct RecordingSink<'r, 'a, T: UnderWay> {
    subject: &'r T,
    recorder: &'r mut Recorder<'a>,
    change: Option<T::Change>,
}

impl<T: UnderWay> Sink<StateOf<T>> for RecordingSink<'_, '_, T> {
    fn accept(&mut self, instant: AcceptedStep<'_, StateOf<T>>) -> Progressing {
        let (time, state) = (instant.time, instant.state);
        let recorded = self.subject.recorded();
        let going = self.recorder.accept(&recorded, time, state, instant.steps);
        self.change = self.subject.by_state(time, state);
        match self.change {
            Some(_) => Progressing::Stop,
            None => going,
        }
    }

    fn jump(&mut self, time: f64, state: &StateOf<T>) {
        self.recorder.jump(&self.subject.recorded(), time, state);
    }
}
