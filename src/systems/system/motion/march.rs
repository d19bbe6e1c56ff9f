//! The march of a system through time, from one end that is let go to the next.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use super::body_equation::MovingBody;
use super::broken_names;
use super::channels::Channels;
use super::checkpoint::{ResumedSystem, SystemCheckpoint};
use super::mesh_of_ends::{EndMesh, Remesh};
use super::method::{SystemMethod, method};
use super::moving_system::MovingSystem;
use super::recorded_system::RecordedSystem;
use super::release::{Release, by_tension, by_time};
use super::settings::MotionSettings;
use super::start::Start;
use super::system_state::SystemState;
use crate::background::cpu_time;
use crate::dynamics::{Integrator, March, MarchError, MarchProgress, MethodState, Stepper};
use crate::run::compute::Computed;
use crate::run::event::JobEvent;
use crate::run::observer::{LineAtEnd, NodeChange, RunEnd};
use crate::run::observers::{ObservedRun, of_lines};
use crate::run::output_times::OutputTimes;
use crate::run::recorder::{Recorder, RecorderPlan};
use crate::run::requested_statistics::{self, of_channels, settled};
use crate::run::time_march::MarchResult;
use crate::run::{Cost, Profile, RunState, Work, step_envelope};
use crate::scene::Scene;
use crate::solve::{AcceptedStep, Marched, NewtonError, Progressing, Sink};
use crate::system::model::MotionMethod;

/// Least wall time between two checkpoints.
const BETWEEN_CHECKPOINTS: Duration = Duration::from_secs(2);

/// A march under way.
pub(super) struct Marching<'a> {
    system: MovingSystem,
    pub(super) state: SystemState,
    pub(super) method: SystemMethod,
    bodies: Vec<MovingBody>,
    channels: Channels,
    pub(super) recorder: Recorder<'a>,
    march: March,
    pub(super) place: MarchProgress,
    /// What happened to the lines, in words.
    pub(super) happened: Vec<String>,
    settings: MotionSettings,
    /// When the latest checkpoint was sent.
    saved: Instant,
}

/// Why a march stops on its way.
enum Pause {
    /// An end is let go.
    Release(Release),
    /// The mesh at an end that is paid out is no longer good.
    Mesh(EndMesh),
}

/// Why a march ended before its end.
enum EarlyEnd {
    /// It was cancelled.
    Cancelled,
    /// A step failed, for this reason.
    Failed(String),
}

/// Marches from the start, or from where a stored run is resumed, to the end, and sends every row to who listens.
pub(super) fn compute<'a>(
    begun: Start,
    settings: &MotionSettings,
    from: Option<&ResumedSystem>,
    cancel: &'a AtomicBool,
    events: Option<&'a mut dyn FnMut(JobEvent)>,
) -> Computed {
    let (cpu, clock) = (cpu_time(), Instant::now());
    let at_start = begun.iterations;
    let channels = Channels::of(&begun.system);
    let plan = plan(&begun, &channels, settings);
    let recorder = Recorder::new(plan, events, cancel);
    let mut marching = Marching::new(begun, settings, channels, recorder);
    let begun = match from {
        Some(from) => marching.resume(from),
        None => marching.begin(),
    };
    let ended = begun.map_err(EarlyEnd::Failed);
    let ended = ended.and_then(|()| marching.march()).err();
    let ((recorded, state), recorder) = marching.recorded();
    recorder.end(&recorded, state);
    let counts = marching.method.work_counts();
    let work = Work {
        steps: marching.place.steps,
        rejections: marching.place.rejections,
        iterations: at_start + counts.iterations,
        evaluations: counts.evaluations,
    };
    let cost = Cost {
        cpu_s: cpu_time() - cpu,
        wall_s: clock.elapsed().as_secs_f64(),
        companions_wall_s: 0.0,
    };
    marching.result(settings, (work, cost), ended)
}

/// What is recorded of a run.
fn plan(begun: &Start, channels: &Channels, settings: &MotionSettings) -> RecorderPlan {
    // Without inertia no energy balances.
    let balances = settings.method != MotionMethod::Quasi;
    let duration = settings.duration_s;
    let output_times = OutputTimes::new(duration, settings.interval_s);
    let window = settings.settled_from_s.map(|from| [from, duration]);
    let quantities = channels.ids.iter().map(|id| id.quantity);
    let lines = begun.system.lines(&begun.state).map(|(scene, _)| scene);
    let scenes: Vec<&Scene> = lines.collect();
    let statistics = of_channels(channels.ids.len())
        .chain(requested_statistics::of_lines(scenes.len()))
        .chain(settled(quantities, window));
    let observers = of_lines(ObservedRun {
        channels: channels.ids.clone(),
        scenes: &scenes,
        along: begun.along.clone(),
        balances,
        duration,
        rows: output_times.rows(),
        statistics: statistics.collect(),
    });
    RecorderPlan {
        channels: channels.ids.clone(),
        profiles: profiles(&begun.system, &begun.state),
        observers,
        balances,
        output_times,
        shape_interval: settings.shape_interval_s,
        duration,
    }
}

/// The lines node by node, before anything is recorded of them.
pub(super) fn profiles(system: &MovingSystem, state: &SystemState) -> Vec<Profile> {
    let names = system.network.lines.iter().map(|line| &line.name);
    let lines = names.zip(system.lines(state));
    lines
        .map(|(name, (scene, _))| Profile {
            line: name.clone(),
            ..step_envelope::profile(scene)
        })
        .collect()
}

impl<'a> Marching<'a> {
    fn new(
        begun: Start,
        settings: &MotionSettings,
        channels: Channels,
        recorder: Recorder<'a>,
    ) -> Self {
        let Start { system, state, .. } = begun;
        let method = method(settings, &system, &state);
        Self {
            bodies: method.equations().bodies().to_vec(),
            channels,
            recorder,
            march: March {
                duration: settings.duration_s,
                step: settings.time_step_s,
            },
            place: MarchProgress::default(),
            happened: Vec::new(),
            settings: settings.clone(),
            saved: Instant::now(),
            system,
            state,
            method,
        }
    }

    /// Sends the state of the march.
    fn checkpoint(&mut self) {
        if self.recorder.takes_checkpoints() {
            self.send_checkpoint(&SystemCheckpoint::of(self));
        }
    }

    fn send_checkpoint(&mut self, checkpoint: &SystemCheckpoint) {
        // What cannot be written is no checkpoint; the run goes on without.
        if let Ok(text) = toml::to_string(checkpoint) {
            self.recorder.send(JobEvent::SystemCheckpoint(text));
        }
        self.saved = Instant::now();
    }

    /// Marches to the end, from one end that is let go to the next; sends checkpoints at intervals, where it is stopped, and at the end:
    /// before the last whole step where the end cuts it short, so that a longer run resumes with a whole one.
    fn march(&mut self) -> Result<(), EarlyEnd> {
        let mut events = by_time(&self.system);
        events.retain(|event| !self.is_over_with(*event));
        let mut events = events.into_iter().peekable();
        while !self.march.is_over(&self.place) {
            let next = (self.place.whole + 1) as f64 * self.march.step;
            let cut_by_end = self.march.is_after_end(next);
            if cut_by_end {
                self.checkpoint();
            }
            let event = events.peek().map_or(f64::INFINITY, |event| event.time);
            match self.advance(next.min(event)) {
                Ok(Some(Pause::Release(event))) => {
                    self.release(event);
                    self.release_by_tension(event.time);
                }
                Ok(Some(Pause::Mesh(end))) => self.remesh(end)?,
                Ok(None) => {}
                Err(end) => {
                    if matches!(end, EarlyEnd::Cancelled) {
                        self.checkpoint();
                    }
                    return Err(end);
                }
            }
            let (march, place) = (self.march, self.place);
            while let Some(event) = events.next_if(|event| march.is_at(&place, event.time)) {
                match self.system.is_released(event, &self.state) {
                    true => self.happened.push(gone_before(&self.system, event)),
                    false => self.release(event),
                }
            }
            let due = march.is_over(&place) || self.saved.elapsed() >= BETWEEN_CHECKPOINTS;
            if due && !cut_by_end {
                self.checkpoint();
            }
        }
        Ok(())
    }

    /// Continues from the checkpoint of a stored run; its rows are recorded and sent again, and it with them, so that the new run can
    /// be resumed before it has one of its own.
    fn resume(&mut self, from: &ResumedSystem) -> Result<(), String> {
        let stored = &from.checkpoint;
        let remeshed = stored.state.added != self.state.added;
        if remeshed {
            stored.check_added(&self.state)?;
            self.system.mesh_as(&stored.state.added, &mut self.state)?;
            self.state.size_as(&stored.state);
        }
        let profiles = profiles(&self.system, &self.state);
        stored.check(&self.state, self.channels.ids.len(), &profiles)?;
        if !self.recorder.fits(&stored.recorded) {
            return Err("its checkpoint.toml counts fatigue at other places".to_owned());
        }
        let interval = self.recorder.output_times().interval;
        if stored.recorded.output_interval_s.to_bits() != interval.to_bits() {
            return Err("the interval of its history is another one".to_owned());
        }
        self.recorder
            .restore(&stored.recorded, &from.dir)
            .map_err(|why| why.to_string())?;
        self.state.restore(&stored.state);
        self.system.free_released_ends(&mut self.state);
        self.system.pay_out(&mut self.state);
        self.renew_method(stored.time(), &stored.method);
        self.place = stored.place;
        self.happened.clone_from(&stored.happened);
        self.send_checkpoint(stored);
        Ok(())
    }

    /// Whether an end that is let go at a time has gone by then, at that time or before.
    fn is_over_with(&self, event: Release) -> bool {
        self.march.is_at(&self.place, event.time) && self.system.is_released(event, &self.state)
    }

    /// The accelerations at the start, the first row, and the ends whose tension at rest lets them go.
    fn begin(&mut self) -> Result<(), String> {
        self.system.update_wave_kinematics(0.0, &mut self.state);
        let mut begun = self.method.accelerate(&self.system, 0.0, &mut self.state);
        self.system.commit(0.0, 0.0, &mut self.state);
        let mut lines = self.system.scenes.iter();
        if lines.any(|scene| scene.line.begins_off_rest()) {
            begun = self.method.accelerate(&self.system, 0.0, &mut self.state);
        }
        let ((recorded, state), recorder) = self.recorded();
        recorder.accept(&recorded, 0.0, state, 0);
        begun.map_err(|why| in_words(&self.system, 0.0, &why))?;
        self.release_by_tension(0.0);
        Ok(())
    }

    /// What is recorded, its state, and by what.
    fn recorded(&mut self) -> ((RecordedSystem<'_>, &SystemState), &mut Recorder<'a>) {
        let recorded = RecordedSystem {
            system: &self.system,
            bodies: &self.bodies,
            channels: &self.channels,
        };
        ((recorded, &self.state), &mut self.recorder)
    }

    /// Marches to a time, to the end, or to where a tension lets an end go.
    fn advance(&mut self, until: f64) -> Result<Option<Pause>, EarlyEnd> {
        let mut sink = SystemSink {
            recorded: RecordedSystem {
                system: &self.system,
                bodies: &self.bodies,
                channels: &self.channels,
            },
            recorder: &mut self.recorder,
            pause: None,
        };
        let (place, method, state) = (&mut self.place, &mut self.method, &mut self.state);
        let going = self
            .march
            .advance(place, until, method, &self.system, state, &mut sink);
        let pause = sink.pause;
        if let (Ok(_), Some(fault)) = (&going, self.recorder.fault()) {
            return Err(EarlyEnd::Failed(fault.to_owned()));
        }
        match going {
            Err(error) => Err(EarlyEnd::Failed(march_in_words(&self.system, &error))),
            Ok(Progressing::Stop) if pause.is_none() => Err(EarlyEnd::Cancelled),
            Ok(_) => Ok(pause),
        }
    }

    /// Lets an end go, and starts the method anew.
    fn release(&mut self, event: Release) {
        self.system.release(event, &mut self.state);
        self.method
            .restart(&self.system, event.time, &mut self.state);
        let ((recorded, state), recorder) = self.recorded();
        recorder.jump(&recorded, event.time, state);
        self.happened.push(in_time(&self.system, event));
    }

    /// Lets go every end whose tension is at its limit at this time \[s\], one after the other.
    fn release_by_tension(&mut self, time: f64) {
        while let Some(event) = by_tension(&self.system, &self.state, time) {
            self.release(event);
        }
    }

    /// Parts or joins the segment of an end that is paid out.
    fn remesh(&mut self, end: EndMesh) -> Result<(), EarlyEnd> {
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
        let ((recorded, state), recorder) = self.recorded();
        recorder.leave(&recorded, state);
        let mut kept = self.method.method_state();
        let (node, comes) = self
            .system
            .remesh(end, t, &mut self.state, &mut kept)
            .map_err(EarlyEnd::Failed)?;
        self.renew_method(t, &kept);
        let ((recorded, state), recorder) = self.recorded();
        recorder.remesh(&recorded, t, state, NodeChange { line, node, comes });
        Ok(())
    }

    /// The method for lines of another number of nodes.
    fn renew_method(&mut self, t: f64, kept: &MethodState) {
        self.system.update_wave_kinematics(t, &mut self.state);
        self.method = method(&self.settings, &self.system, &self.state);
        self.method.restore(kept);
    }

    fn result(
        self,
        settings: &MotionSettings,
        (work, cost): (Work, Cost),
        ended: Option<EarlyEnd>,
    ) -> Computed {
        let reached = self.recorder.reached();
        let ends = self.recorder.fault().is_none();
        let lines = self.system.lines(&self.state);
        let lines: Vec<LineAtEnd<'_>> = lines
            .map(|(scene, state)| LineAtEnd {
                scene,
                state: ends.then_some(state),
            })
            .collect();
        let record = self.recorder.finish(&RunEnd {
            single_line: None,
            lines: &lines,
        });
        let (state, failure) = match ended {
            None => (RunState::Done, None),
            Some(EarlyEnd::Cancelled) => (RunState::Cancelled, None),
            Some(EarlyEnd::Failed(why)) => (RunState::Failed, Some(why)),
        };
        let lengths: Vec<(f64, u64)> = self.march.lengths(&self.place).collect();
        let settings = settings.of_run(&self.system, &lengths);
        Computed {
            outcome: MarchResult {
                state,
                failure,
                work,
                reached,
                lengths,
            },
            warnings: Vec::new(),
            settings,
            cost,
            record,
            modes: Vec::new(),
            curves: Vec::new(),
            happened: self.happened,
        }
    }
}

/// Records the steps of a march, and stops it where an end is let go or the mesh is no longer good.
struct SystemSink<'r, 'a> {
    recorded: RecordedSystem<'r>,
    recorder: &'r mut Recorder<'a>,
    pause: Option<Pause>,
}

impl Sink<SystemState> for SystemSink<'_, '_> {
    fn accept(&mut self, instant: AcceptedStep<'_, SystemState>) -> Progressing {
        let (time, state) = (instant.time, instant.state);
        let going = self
            .recorder
            .accept(&self.recorded, time, state, instant.steps);
        let system = self.recorded.system;
        let release = by_tension(system, state, time).map(Pause::Release);
        self.pause = release.or_else(|| system.end_mesh(state).map(Pause::Mesh));
        match self.pause {
            Some(_) => Progressing::Stop,
            None => going,
        }
    }

    fn jump(&mut self, time: f64, state: &SystemState) {
        self.recorder.jump(&self.recorded, time, state);
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
