//! The march of a system through time, from one end that is let go to the next.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::body_equation::MovingBody;
use super::breaks;
use super::method::Method;
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
use crate::run::{Cost, OutputFrame, Progress, RunState};
use crate::scene::Scene;
use crate::solve::{AcceptedStep, Marched, NewtonError, Progressing};

/// A march under way.
struct Marching {
    system: MovingSystem,
    state: SystemState,
    method: Method,
    bodies: Vec<MovingBody>,
    recorder: Recorder,
    march: March,
    place: MarchProgress,
    /// What happened to the lines, in words.
    happened: Vec<String>,
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
}

/// Marches from the start to the end, and sends every row.
pub(super) fn compute(
    begun: Start,
    settings: &MotionSettings,
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
    };
    let at_start = begun.iterations;
    let mut marching = Marching::new(begun, settings);
    let ended = marching.march(cancel, &mut rows).err();
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
        let Start { system, state, .. } = begun;
        let method = Method::new(settings, &system, &state);
        Self {
            bodies: method.bodies().to_vec(),
            recorder: Recorder::new(&system, settings.interval_s),
            march: March {
                duration: settings.duration_s,
                step: settings.time_step_s,
            },
            place: MarchProgress::default(),
            happened: Vec::new(),
            system,
            state,
            method,
        }
    }

    /// Marches from the start to the end, from one end that is let go to the next.
    fn march(&mut self, cancel: &AtomicBool, rows: &mut RowSender<'_>) -> Result<(), EarlyEnd> {
        let mut events = by_time(&self.system).into_iter().peekable();
        self.begin(rows).map_err(EarlyEnd::Failed)?;
        while !self.march.is_over(&self.place) {
            let until = events.peek().map_or(f64::INFINITY, |event| event.time);
            if let Some(event) = self.advance(until, cancel, rows)? {
                self.release(event, rows);
            }
            let (march, place) = (self.march, self.place);
            while let Some(event) = events.next_if(|event| march.is_at(&place, event.time)) {
                self.release(event, rows);
            }
        }
        Ok(())
    }

    /// The accelerations at the start, and the first row.
    fn begin(&mut self, rows: &mut RowSender<'_>) -> Result<(), String> {
        self.system.update_wave_kinematics(0.0, &mut self.state);
        let begun = self.method.accelerate(&self.system, 0.0, &mut self.state);
        self.system.commit(0.0, 0.0, &mut self.state);
        let first = &mut |time, values: &[f64]| rows.send(0, time, values);
        self.recorder
            .accept(&self.system, &self.bodies, (0.0, &self.state), first);
        begun.map_err(|why| in_words(&self.system, 0.0, &why))
    }

    /// Marches to a time, to the end, or to where a tension lets an end go.
    fn advance(
        &mut self,
        until: f64,
        cancel: &AtomicBool,
        rows: &mut RowSender<'_>,
    ) -> Result<Option<Release>, EarlyEnd> {
        let (system, bodies, recorder) = (&self.system, &self.bodies, &mut self.recorder);
        let mut pulled = None;
        let mut sink = |instant: AcceptedStep<'_, SystemState>| {
            let send = &mut |time, values: &[f64]| rows.send(instant.steps, time, values);
            recorder.accept(system, bodies, (instant.time, instant.state), send);
            pulled = by_tension(system, instant.state, instant.time);
            match pulled.is_some() || cancel.load(Ordering::Relaxed) {
                true => Progressing::Stop,
                false => Progressing::Continue,
            }
        };
        let (place, method, state) = (&mut self.place, &mut self.method, &mut self.state);
        let going = self
            .march
            .advance(place, until, method, system, state, &mut sink);
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
        let recorder = self.recorder;
        let summaries = recorder.summaries();
        let channels = recorder.channels().iter().zip(summaries);
        let channel = |(id, summary): (&ChannelId, ChannelSummary)| ChannelResult {
            id: id.clone(),
            summary,
            time_error: None,
            mesh_error: None,
        };
        let (state, failure) = match ended {
            None => (RunState::Done, None),
            Some(EarlyEnd::Cancelled) => (RunState::Cancelled, None),
            Some(EarlyEnd::Failed(why)) => (RunState::Failed, Some(why)),
        };
        MotionRun {
            settings: settings.clone(),
            channels: channels.map(channel).collect(),
            balance: recorder.balance,
            history: recorder.into_history(),
            work,
            cost,
            happened: self.happened,
            state,
            failure,
            warnings: Vec::new(),
        }
    }
}

/// What happened to an end, in words.
fn in_time(system: &MovingSystem, event: Release) -> String {
    let Release { time, line, end } = event;
    match breaks::name_of_end(system, line, end) {
        Some(name) => format!(
            "{time:.6} s: end {} of line {name} is let go",
            ["A", "B"][end]
        ),
        None => format!(
            "{time:.6} s: line {} breaks",
            system.network.lines[line].name
        ),
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
