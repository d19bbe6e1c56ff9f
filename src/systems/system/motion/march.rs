//! The march of a system through time, from one end that is let go to the next.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::body_equation::MovingBody;
use super::broken_names;
use super::checkpoint::{ResumedSystem, SystemCheckpoint};
use super::mesh_of_ends::{EndMesh, Remesh};
use super::method::Method;
use super::method_state::MethodState;
use super::moving_system::MovingSystem;
use super::recorder::{ChannelSummary, Recorder};
use super::release::{Release, by_tension, by_time};
use super::run::{ChannelResult, MotionRun, MotionWork};
use super::settings::MotionSettings;
use super::start::Start;
use super::system_state::SystemState;
use crate::background::cpu_time;
use crate::case::ChannelId;
use crate::dynamics::{Integrator, March, MarchError, MarchProgress, Stepper};
use crate::run::event::JobEvent;
use crate::run::{Cost, OutputFrame, Progress, RunState, replay_rows};
use crate::scene::Scene;
use crate::solve::{AcceptedStep, Marched, NewtonError, Progressing};

/// Least wall time between two checkpoints.
const BETWEEN_CHECKPOINTS: Duration = Duration::from_secs(2);

/// A march under way.
pub(super) struct Marching {
    system: MovingSystem,
    pub(super) state: SystemState,
    pub(super) method: Method,
    bodies: Vec<MovingBody>,
    pub(super) recorder: Recorder,
    march: March,
    pub(super) place: MarchProgress,
    /// What happened to the lines, in words.
    pub(super) happened: Vec<String>,
    settings: MotionSettings,
}

/// Why a march stops on its way.
enum Pause {
    /// An end is let go.
    Release(Release),
    /// The mesh at an end that is paid out is no longer good.
    Mesh(EndMesh),
}

/// What a march that is stored needs: the checkpoint from where it is resumed, if it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stored<'a> {
    pub(super) from: Option<&'a ResumedSystem>,
}

/// Why a march ended before its end.
enum EarlyEnd {
    /// It was cancelled.
    Cancelled,
    /// A step failed, for this reason.
    Failed(String),
}

/// Sends the rows of a march as they are recorded.
struct RowSender<'a> {
    events: &'a mut dyn FnMut(JobEvent),
    clock: Instant,
    progress: Progress,
    /// The interval of the rows \[s\], as checkpoints name it; absent: none are sent.
    checkpoints: Option<f64>,
    saved: Instant,
}

impl RowSender<'_> {
    /// Sends a row; `steps` are accepted by then.
    fn send(&mut self, steps: u64, time: f64, values: &[f64]) {
        let progress = Progress {
            time,
            steps,
            wall_s: self.clock.elapsed().as_secs_f64(),
            ..self.progress
        };
        (self.events)(JobEvent::Frame(Box::new(OutputFrame {
            time,
            values: values.to_vec(),
            shape: None,
            progress,
        })));
    }

    /// Sends the state of a march.
    fn checkpoint(&mut self, march: &Marching) {
        if let Some(interval) = self.checkpoints {
            self.send_checkpoint(&SystemCheckpoint::of(march, interval));
        }
    }

    fn send_checkpoint(&mut self, checkpoint: &SystemCheckpoint) {
        // What cannot be written is no checkpoint; the run goes on without.
        if let Ok(text) = toml::to_string(checkpoint) {
            (self.events)(JobEvent::SystemCheckpoint(text));
        }
        self.saved = Instant::now();
    }
}

/// Marches from the start, or from where a stored run is resumed, to the end, and sends every row.
pub(super) fn compute(
    begun: Start,
    settings: &MotionSettings,
    stored: Option<Stored<'_>>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> MotionRun {
    let (cpu, clock) = (cpu_time(), Instant::now());
    let mut rows = RowSender {
        events,
        clock,
        progress: Progress {
            duration: settings.duration_s,
            ..Progress::default()
        },
        checkpoints: stored.map(|_| settings.interval_s),
        saved: clock,
    };
    let at_start = begun.iterations;
    let mut marching = Marching::new(begun, settings);
    let from = stored.and_then(|stored| stored.from);
    let begun = match from {
        Some(from) => marching.resume(from, &mut rows),
        None => marching.begin(&mut rows),
    };
    let ended = begun.map_err(EarlyEnd::Failed);
    let ended = ended.and_then(|()| marching.march(cancel, &mut rows)).err();
    let steps = marching.place.steps;
    let last = &mut |time, values: &[f64]| rows.send(steps, time, values);
    marching.recorder.end(last);
    let work = MotionWork {
        iterations: at_start + marching.method.work_counts().iterations,
        evaluations: marching.method.work_counts().evaluations,
        ..marching.work()
    };
    let cost = Cost {
        cpu_s: cpu_time() - cpu,
        wall_s: clock.elapsed().as_secs_f64(),
        companions_wall_s: 0.0,
    };
    marching.result(settings, (work, cost), ended)
}

impl Marching {
    fn new(begun: Start, settings: &MotionSettings) -> Self {
        let Start {
            system,
            state,
            along,
            ..
        } = begun;
        let method = Method::new(settings, &system, &state);
        Self {
            bodies: method.bodies().to_vec(),
            recorder: Recorder::new(&system, settings.interval_s)
                .settled_from(settings.settled_from_s)
                .counting(along),
            march: March {
                duration: settings.duration_s,
                step: settings.time_step_s,
            },
            place: MarchProgress::default(),
            happened: Vec::new(),
            settings: settings.clone(),
            system,
            state,
            method,
        }
    }

    /// Marches to the end, from one end that is let go to the next; sends checkpoints at intervals, where it is stopped, and at the end:
    /// before the last whole step where the end cuts it short, so that a longer run resumes with a whole one.
    fn march(&mut self, cancel: &AtomicBool, rows: &mut RowSender<'_>) -> Result<(), EarlyEnd> {
        let mut events = by_time(&self.system);
        events.retain(|event| !self.is_over_with(*event));
        let mut events = events.into_iter().peekable();
        while !self.march.is_over(&self.place) {
            let next = (self.place.whole + 1) as f64 * self.march.step;
            let cut_by_end = self.march.is_after_end(next);
            if cut_by_end {
                rows.checkpoint(self);
            }
            let event = events.peek().map_or(f64::INFINITY, |event| event.time);
            match self.advance(next.min(event), cancel, rows) {
                Ok(Some(Pause::Release(event))) => {
                    self.release(event, rows);
                    self.release_by_tension(event.time, rows);
                }
                Ok(Some(Pause::Mesh(end))) => self.remesh(end, rows)?,
                Ok(None) => {}
                Err(end) => {
                    if matches!(end, EarlyEnd::Cancelled) {
                        rows.checkpoint(self);
                    }
                    return Err(end);
                }
            }
            let (march, place) = (self.march, self.place);
            while let Some(event) = events.next_if(|event| march.is_at(&place, event.time)) {
                match self.system.is_released(event, &self.state) {
                    true => self.happened.push(gone_before(&self.system, event)),
                    false => self.release(event, rows),
                }
            }
            let due = march.is_over(&place) || rows.saved.elapsed() >= BETWEEN_CHECKPOINTS;
            if due && !cut_by_end {
                rows.checkpoint(self);
            }
        }
        Ok(())
    }

    /// Continues from the checkpoint of a stored run; its rows are recorded and sent again, and it with them, so that the new run can
    /// be resumed before it has one of its own.
    fn resume(&mut self, from: &ResumedSystem, rows: &mut RowSender<'_>) -> Result<(), String> {
        let stored = &from.checkpoint;
        let remeshed = stored.state.added != self.state.added;
        if remeshed {
            stored.check_added(&self.state)?;
            self.system.mesh_as(&stored.state.added, &mut self.state)?;
            self.state.size_as(&stored.state);
        }
        stored.check(&self.state, self.recorder.channels().len())?;
        if !self.recorder.fits(&stored.recorder) {
            return Err("its checkpoint.toml counts fatigue at other places".to_owned());
        }
        if stored.interval_s.to_bits() != self.recorder.interval().to_bits() {
            return Err("the interval of its history is another one".to_owned());
        }
        let span = (stored.recorder.rows, stored.recorder.time());
        let recorder = &mut self.recorder;
        let channels = recorder.channels().to_vec();
        replay_rows(&from.dir, &channels, span, &mut |time, values| {
            recorder.take_row(time, values);
            rows.send(0, time, values);
        })
        .map_err(|why| why.to_string())?;
        self.recorder.restore(&stored.recorder);
        self.state.restore(&stored.state);
        self.system.free_released_ends(&mut self.state);
        self.system.pay_out(&mut self.state);
        self.renew_method(span.1, &stored.method);
        self.place = stored.place;
        self.happened.clone_from(&stored.happened);
        rows.send_checkpoint(stored);
        Ok(())
    }

    /// Whether an end that is let go at a time has gone by then, at that time or before.
    fn is_over_with(&self, event: Release) -> bool {
        self.march.is_at(&self.place, event.time) && self.system.is_released(event, &self.state)
    }

    /// The accelerations at the start, the first row, and the ends whose tension at rest lets them go.
    fn begin(&mut self, rows: &mut RowSender<'_>) -> Result<(), String> {
        self.system.update_wave_kinematics(0.0, &mut self.state);
        let mut begun = self.method.accelerate(&self.system, 0.0, &mut self.state);
        self.system.commit(0.0, 0.0, &mut self.state);
        let mut lines = self.system.scenes.iter();
        if lines.any(|scene| scene.line.begins_off_rest()) {
            begun = self.method.accelerate(&self.system, 0.0, &mut self.state);
        }
        let first = &mut |time, values: &[f64]| rows.send(0, time, values);
        self.recorder
            .accept(&self.system, &self.bodies, (0.0, &self.state), first);
        begun.map_err(|why| in_words(&self.system, 0.0, &why))?;
        self.release_by_tension(0.0, rows);
        Ok(())
    }

    /// Marches to a time, to the end, or to where a tension lets an end go.
    fn advance(
        &mut self,
        until: f64,
        cancel: &AtomicBool,
        rows: &mut RowSender<'_>,
    ) -> Result<Option<Pause>, EarlyEnd> {
        let (system, bodies, recorder) = (&self.system, &self.bodies, &mut self.recorder);
        let mut pulled = None;
        let mut sink = |instant: AcceptedStep<'_, SystemState>| {
            let send = &mut |time, values: &[f64]| rows.send(instant.steps, time, values);
            recorder.accept(system, bodies, (instant.time, instant.state), send);
            let release = by_tension(system, instant.state, instant.time).map(Pause::Release);
            pulled = release.or_else(|| system.end_mesh(instant.state).map(Pause::Mesh));
            match recorder.fault().is_some() || pulled.is_some() || cancel.load(Ordering::Relaxed) {
                true => Progressing::Stop,
                false => Progressing::Continue,
            }
        };
        let (place, method, state) = (&mut self.place, &mut self.method, &mut self.state);
        let going = self
            .march
            .advance(place, until, method, system, state, &mut sink);
        if let (Ok(_), Some(fault)) = (&going, self.recorder.fault()) {
            return Err(EarlyEnd::Failed(fault.to_owned()));
        }
        match going {
            Err(error) => Err(EarlyEnd::Failed(march_in_words(&self.system, &error))),
            Ok(Progressing::Stop) if pulled.is_none() => Err(EarlyEnd::Cancelled),
            Ok(_) => Ok(pulled),
        }
    }

    /// Lets an end go, and starts the method anew.
    fn release(&mut self, event: Release, rows: &mut RowSender<'_>) {
        self.system.release(event, &mut self.state);
        self.method
            .restart(&self.system, event.time, &mut self.state);
        let steps = self.place.steps;
        let last = &mut |time, values: &[f64]| rows.send(steps, time, values);
        self.recorder
            .jump(&self.system, &self.bodies, (event.time, &self.state), last);
        self.happened.push(in_time(&self.system, event));
    }

    /// Lets go every end whose tension is at its limit at this time \[s\], one after the other.
    fn release_by_tension(&mut self, time: f64, rows: &mut RowSender<'_>) {
        while let Some(event) = by_tension(&self.system, &self.state, time) {
            self.release(event, rows);
        }
    }

    /// Parts or joins the segment of an end that is paid out.
    fn remesh(&mut self, end: EndMesh, rows: &mut RowSender<'_>) -> Result<(), EarlyEnd> {
        let t = self.recorder.reached();
        let (number, at, need) = end;
        let line = self.system.paid[number].line;
        if need == Remesh::Stop {
            return Err(EarlyEnd::Failed(format!(
                "at t = {t:.6} s nothing is left of line {} to pass its end {}: a section, a clump or its other end is there; let it run a shorter way, or begin with a longer line",
                self.system.network.lines[line].name,
                ["A", "B"][at]
            )));
        }
        let mut kept = self.method.method_state();
        self.system
            .remesh(end, t, &mut self.state, &mut kept)
            .map_err(EarlyEnd::Failed)?;
        self.renew_method(t, &kept);
        let steps = self.place.steps;
        let last = &mut |time, values: &[f64]| rows.send(steps, time, values);
        self.recorder
            .jump(&self.system, &self.bodies, (t, &self.state), last);
        Ok(())
    }

    /// The method for lines of another number of nodes.
    fn renew_method(&mut self, t: f64, kept: &MethodState) {
        self.system.update_wave_kinematics(t, &mut self.state);
        self.method = Method::new(&self.settings, &self.system, &self.state);
        self.method.restore(kept, &self.state);
    }

    fn work(&self) -> MotionWork {
        MotionWork {
            nodes: self.system.scenes.iter().map(Scene::line_nodes).sum(),
            joints: self.system.joints.envelope.len(),
            steps: self.place.steps,
            rejections: self.place.rejections,
            reached: self.recorder.reached(),
            ..MotionWork::default()
        }
    }

    fn result(
        self,
        settings: &MotionSettings,
        (work, cost): (MotionWork, Cost),
        ended: Option<EarlyEnd>,
    ) -> MotionRun {
        let mut recorder = self.recorder;
        let along = recorder.take_along();
        let summaries = recorder.summaries();
        let channels = recorder.channels().iter().zip(summaries).enumerate();
        let channel =
            |(number, (id, summary)): (usize, (&ChannelId, ChannelSummary))| ChannelResult {
                id: id.clone(),
                summary,
                settled: recorder.settled(number),
                time_error: None,
                mesh_error: None,
            };
        let (state, failure) = match ended {
            None => (RunState::Done, None),
            Some(EarlyEnd::Cancelled) => (RunState::Cancelled, None),
            Some(EarlyEnd::Failed(why)) => (RunState::Failed, Some(why)),
        };
        let (fatigue, warnings) = along.finish();
        MotionRun {
            settings: settings.clone(),
            fatigue,
            channels: channels.map(channel).collect(),
            companions: Vec::new(),
            balance: recorder.balance,
            history: recorder.into_history(),
            work,
            cost,
            happened: self.happened,
            state,
            failure,
            warnings,
        }
    }
}

/// What happened to an end, in words.
fn in_time(system: &MovingSystem, event: Release) -> String {
    let (what, is_end) = part_in_words(system, event);
    let verb = if is_end { "is let go" } else { "breaks" };
    format!("{:.6} s: {what} {verb}", event.time)
}

/// An end that is stated to be let go at a time, and was before.
fn gone_before(system: &MovingSystem, event: Release) -> String {
    let (what, is_end) = part_in_words(system, event);
    let [verb, before] = match is_end {
        true => ["be let go", "was let go"],
        false => ["break", "broke"],
    };
    format!(
        "{:.6} s: {what} is stated to {verb} here; it {before} earlier",
        event.time
    )
}

/// What lets go, and whether it is an end of a line as the file has it; a line breaks at the others.
fn part_in_words(system: &MovingSystem, Release { line, end, .. }: Release) -> (String, bool) {
    match broken_names::name_of_end(system, line, end) {
        Some(name) => (format!("end {} of line {name}", ["A", "B"][end]), true),
        None => (format!("line {}", system.network.lines[line].name), false),
    }
}

fn march_in_words(system: &MovingSystem, error: &MarchError) -> String {
    format!(
        "{} (the step was halved down to {:.3e} s)",
        in_words(system, error.time, &error.why),
        error.step
    )
}

/// Why a step failed, with the line and node.
fn in_words(system: &MovingSystem, time: f64, why: &NewtonError) -> String {
    let node = system.node_name(why.node());
    let problem = match why {
        NewtonError::NotConverged {
            iterations, moved, ..
        } => format!(
            "Newton did not converge in {iterations} iterations: {node} still moves by {moved:.3e} m; try a smaller time_step_s, or more segments there"
        ),
        NewtonError::Singular { .. } => {
            format!("nothing holds {node}: give it mass, drag or tension")
        }
        NewtonError::NotFinite { .. } => format!("a force is not finite at {node}"),
        NewtonError::Runaway { .. } | NewtonError::Unstable { .. } => format!("{why}, {node}"),
    };
    format!("at t = {time:.6} s {problem}")
}
