//! The time march of a run from event to event, with the line as it is in between.

use std::collections::BTreeMap;
use std::time::Duration;

use super::line_recorder::LineRecorder;
use super::recorder_state::RecorderState;
use super::store::StoreError;
use super::{Checkpoint, ResumedRun, RunState, Settings, Work};
use crate::dynamics::{March, MarchError, MarchProgress, MethodState, Stepper};
use crate::limits::STEPS;
use crate::scene::Scene;
use crate::solve::{AcceptedStep, Hysteresis, Kinematics, Progressing, Sink, State};

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
    /// A computation that was stopped before its first step.
    pub(super) fn stopped(work: Work) -> Self {
        Self {
            state: RunState::Cancelled,
            failure: None,
            work,
            reached: 0.0,
            lengths: Vec::new(),
        }
    }

    /// A computation that failed before its first step.
    pub(super) fn failed(failure: String, work: Work) -> Self {
        Self {
            state: RunState::Failed,
            failure: Some(failure),
            work,
            reached: 0.0,
            lengths: Vec::new(),
        }
    }
}

/// The line as it is at first, and after each of its events.
pub(super) fn phases(scene: Scene) -> Vec<Scene> {
    let events = scene.events.clone();
    let mut phases = vec![scene];
    for event in events {
        let next = phases[phases.len() - 1].after(event.change);
        phases.push(next);
    }
    phases
}

/// Least wall time between two checkpoints.
const BETWEEN_CHECKPOINTS: Duration = Duration::from_secs(2);

/// The start of a march: at time zero, or at the checkpoint of an earlier run.
pub(super) struct MarchStart<'a> {
    /// An earlier run to be resumed.
    pub(super) resume: Option<&'a ResumedRun>,
    /// Whether the initial state is that of another run.
    pub(super) from_run: bool,
    /// State of the method at the end of that run.
    pub(super) method_state: Option<&'a MethodState>,
    /// Warnings of the start, which a resumed run repeats.
    pub(super) warnings: &'a [String],
    /// Work of the search for the start.
    pub work: Work,
}

/// Marches a line through all its phases.
pub(super) fn march<'a, M: Stepper<Scene>>(
    method: M,
    settings: &Settings,
    phases: &'a [Scene],
    state: &mut State,
    recorder: &mut LineRecorder<'a>,
    start: &MarchStart<'_>,
) -> MarchResult {
    let steps = settings.duration_s / settings.time_step_s;
    if STEPS.is_exceeded_by(steps) {
        let problem = format!(
            "it would take {steps:.1e} steps of {:.1e} s",
            settings.time_step_s
        );
        let remedy = STEPS.remedy(
            "make the line less stiff, or choose the solver `alpha`",
            steps,
        );
        return MarchResult::failed(format!("{problem}; {remedy}"), start.work);
    }
    let mut run = TimeMarch {
        march: March {
            duration: settings.duration_s,
            step: start
                .resume
                .map_or(settings.time_step_s, |from| from.checkpoint.whole_step_s),
        },
        method,
        position: MarchProgress::default(),
        phase: 0,
        recorder,
        start,
    };
    match run.begin(phases, state) {
        Ok(begun) => {
            let result = run.all_phases(begun, phases, state);
            run.result(&result)
        }
        Err(error) => MarchResult::failed(error.to_string(), start.work),
    }
}

/// A march through time under way.
struct TimeMarch<'a, 'r, M> {
    march: March,
    method: M,
    position: MarchProgress,
    /// Events of the line so far.
    phase: usize,
    recorder: &'r mut LineRecorder<'a>,
    start: &'r MarchStart<'r>,
}

impl<'a, M: Stepper<Scene>> TimeMarch<'a, '_, M> {
    /// Begins at time zero or at the checkpoint.
    fn begin(&mut self, phases: &'a [Scene], state: &mut State) -> Result<Progressing, StoreError> {
        match self.start.resume {
            None => Ok(self.begin_at_zero(&phases[0], state)),
            Some(resume) => self
                .restore(resume, phases, state)
                .map(|()| Progressing::Continue),
        }
    }

    /// Commits the memory of the initial state, and records the first row.
    fn begin_at_zero(&mut self, scene: &'a Scene, state: &mut State) -> Progressing {
        scene.update_wave_kinematics(0.0, state);
        // The state of another run is committed already.
        if !self.start.from_run {
            scene.commit(0.0, 0.0, state);
            if scene.line.begins_off_rest() {
                self.method.restart(scene, 0.0, state);
            }
        }
        if let Some(known) = self.start.method_state {
            self.method.restore(known);
        }
        self.recorder.accept(AcceptedStep {
            time: 0.0,
            state,
            steps: 0,
            whole: true,
        })
    }

    /// Restores everything from a checkpoint.
    fn restore(
        &mut self,
        resume: &ResumedRun,
        phases: &'a [Scene],
        state: &mut State,
    ) -> Result<(), StoreError> {
        let from = &resume.checkpoint;
        let scene = &phases[from.phase.min(phases.len() - 1)];
        let phase = match from.phase < phases.len() {
            true => Ok(()),
            false => Err(format!("this line has not {} events", from.phase)),
        };
        from.check_case(self.recorder.case())
            .and(phase)
            .and_then(|()| from.check(scene, self.recorder.channels()))
            .map_err(|reason| StoreError::Damaged {
                file: resume.dir.join("checkpoint.toml"),
                reason: format!("it does not belong to this case: {reason}"),
            })?;
        self.recorder.restore(resume)?;
        self.recorder.resume_with(scene);
        *state = from.state.clone();
        scene.update_wave_kinematics(from.time(), state);
        self.method.restore(&from.method_state);
        (self.position, self.phase) = (from.place, from.phase);
        Ok(())
    }

    /// Marches from event to event.
    fn all_phases(
        &mut self,
        begun: Progressing,
        phases: &'a [Scene],
        state: &mut State,
    ) -> Result<Progressing, MarchError> {
        let first = self.phase;
        let mut going = begun;
        // Stopped before its first step.
        if going == Progressing::Stop {
            self.send_checkpoint(state);
        }
        for (phase, scene) in phases.iter().enumerate().skip(first) {
            if going == Progressing::Stop {
                break;
            }
            if phase > first {
                let time = self.position.time;
                self.recorder.leave(state);
                self.method.restart(scene, time, state);
                self.recorder.enter(scene, time, state);
            }
            self.phase = phase;
            going = self.one_phase(scene, state)?;
            if self.march.is_over(&self.position) {
                break;
            }
        }
        Ok(going)
    }

    /// Marches to the next event, whole step by whole step; sends checkpoints at intervals, where it is stopped, and at the end:
    /// before the last whole step where the end cuts it short, so that a longer run resumes with a whole one.
    fn one_phase(
        &mut self,
        scene: &'a Scene,
        state: &mut State,
    ) -> Result<Progressing, MarchError> {
        let event = scene.events.get(self.phase);
        let until = event.map_or(f64::INFINITY, |event| event.time);
        let mut saved = std::time::Instant::now();
        while !self.march.is_over(&self.position) && !self.march.is_at(&self.position, until) {
            let next = (self.position.whole + 1) as f64 * self.march.step;
            let cut_by_end = self.march.is_after_end(next);
            if cut_by_end {
                self.send_checkpoint(state);
            }
            let (position, method) = (&mut self.position, &mut self.method);
            let going = self.march.advance(
                position,
                next.min(until),
                method,
                scene,
                state,
                self.recorder,
            )?;
            let due = self.march.is_over(&self.position) || saved.elapsed() >= BETWEEN_CHECKPOINTS;
            if going == Progressing::Stop || (due && !cut_by_end) {
                self.send_checkpoint(state);
                saved = std::time::Instant::now();
            }
            if going == Progressing::Stop {
                return Ok(going);
            }
        }
        Ok(Progressing::Continue)
    }

    fn send_checkpoint(&mut self, state: &State) {
        self.recorder.send_checkpoint(Checkpoint {
            case: BTreeMap::new(),
            whole_step_s: self.march.step,
            phase: self.phase,
            start_iterations: self.start.work.iterations,
            warnings: self.start.warnings.to_vec(),
            place: self.position,
            state: state.clone(),
            method_state: self.method.method_state(),
            // The recorder fills it in.
            recorded: RecorderState::default(),
        });
    }

    /// State, work and step lengths at the end.
    fn result(&self, result: &Result<Progressing, MarchError>) -> MarchResult {
        let (state, failure) = match result {
            Ok(Progressing::Stop) => (RunState::Cancelled, None),
            Ok(Progressing::Continue) => (RunState::Done, None),
            Err(error) => {
                let words = format!("{error}; {}", advice(error));
                (RunState::Failed, Some(words))
            }
        };
        let counts = self.method.work_counts();
        MarchResult {
            state,
            failure,
            work: Work {
                steps: self.position.steps,
                rejections: self.position.rejections,
                iterations: self.start.work.iterations + counts.iterations,
                evaluations: self.start.work.evaluations + counts.evaluations,
            },
            reached: self.position.time,
            lengths: self.march.lengths(&self.position).collect(),
        }
    }
}

/// What to try after a step that failed at every length.
fn advice(error: &MarchError) -> &'static str {
    use crate::solve::NewtonError::{NotConverged, NotFinite, Runaway, Singular, Unstable};
    match error.why {
        NotConverged { .. } => {
            "try a smaller time_step_s, a smaller rho_inf, or more segments near that node"
        }
        Singular { .. } => "give that part of the line mass, drag or tension",
        Runaway { .. } => {
            "give the line tangential drag or axial damping, or use the solver `alpha`"
        }
        Unstable { .. } => "use the solver `alpha`, or try a smaller time_step_s",
        NotFinite { .. } => "try a smaller time_step_s, and look for extreme inputs near that node",
    }
}
