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
use crate::dynamics::{Integrator, March, MarchError, MarchProgress, Stepper};
use crate::run::Channel;
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

/// Marches from the start to the end.
pub(super) fn compute(
    begun: Start,
    settings: &MotionSettings,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(f64),
) -> MotionRun {
    let clock = Instant::now();
    let at_start = begun.iterations;
    let mut marching = Marching::new(begun, settings);
    let mut events = by_time(&marching.system).into_iter().peekable();
    let mut failure = marching.begin().err();
    while failure.is_none() && !marching.march.is_over(&marching.place) {
        let until = events.peek().map_or(f64::INFINITY, |event| event.time);
        match marching.advance(until, cancel, progress) {
            Err(why) => failure = Some(why),
            Ok(Some(event)) => marching.release(event),
            Ok(None) => {}
        }
        let (march, place) = (marching.march, marching.place);
        while failure.is_none()
            && let Some(event) = events.next_if(|event| march.is_at(&place, event.time))
        {
            marching.release(event);
        }
    }
    marching.recorder.end();
    let work = MotionWork {
        iterations: at_start + marching.method.work_counts().iterations,
        evaluations: marching.method.work_counts().evaluations,
        seconds: clock.elapsed().as_secs_f64(),
        ..marching.work()
    };
    marching.result(settings, work, failure)
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

    /// The accelerations at the start, and the first row.
    fn begin(&mut self) -> Result<(), String> {
        self.system.update_wave_kinematics(0.0, &mut self.state);
        let begun = self.method.accelerate(&self.system, 0.0, &mut self.state);
        self.system.commit(0.0, 0.0, &mut self.state);
        self.recorder
            .accept(&self.system, &self.bodies, 0.0, &self.state);
        begun.map_err(|why| in_words(&self.system, 0.0, &why))
    }

    /// Marches to a time, to the end, or to where a tension lets an end go.
    fn advance(
        &mut self,
        until: f64,
        cancel: &AtomicBool,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Option<Release>, String> {
        let (system, bodies, recorder) = (&self.system, &self.bodies, &mut self.recorder);
        let mut pulled = None;
        let mut sink = |instant: AcceptedStep<'_, SystemState>| {
            recorder.accept(system, bodies, instant.time, instant.state);
            progress(instant.time);
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
            Err(error) => Err(march_in_words(&self.system, &error)),
            Ok(Progressing::Stop) if pulled.is_none() => Err("it was stopped".to_owned()),
            Ok(_) => Ok(pulled),
        }
    }

    /// Lets an end go, and starts the method anew.
    fn release(&mut self, event: Release) {
        self.system.release(event, &mut self.state);
        self.method
            .restart(&self.system, event.time, &mut self.state);
        self.recorder
            .jump(&self.system, &self.bodies, event.time, &self.state);
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
        work: MotionWork,
        failure: Option<String>,
    ) -> MotionRun {
        let recorder = self.recorder;
        let summaries = recorder.summaries();
        let channels = recorder.history.channels.iter().zip(summaries);
        let channel = |(channel, summary): (&Channel, ChannelSummary)| ChannelResult {
            id: channel.id.clone(),
            summary,
            time_error: None,
            mesh_error: None,
        };
        MotionRun {
            settings: settings.clone(),
            channels: channels.map(channel).collect(),
            history: recorder.history,
            companions: Vec::new(),
            work,
            balance: recorder.balance,
            happened: self.happened,
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
