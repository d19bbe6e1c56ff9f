//! A system on its way through time: its lines, points and bodies, what is recorded of them, and the ends that are let go or paid out.

use std::collections::VecDeque;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::body_equation::MovingBody;
use super::border::moving_bodies;
use super::broken_names;
use super::channels::Channels;
use super::checkpoint::{ResumedSystem, SystemCheckpoint, check, check_added};
use super::mesh_of_ends::{EndMesh, Remesh};
use super::motion_plan::MotionPlan;
use super::moving_system::MovingSystem;
use super::recorded_system::RecordedSystem;
use super::release::{Release, by_tension, by_time};
use super::start::Start;
use super::system_bounds::{bounds, scale_of_motion};
use super::system_state::SystemState;
use crate::background::cpu_time;
use crate::case::Method;
use crate::case::Subject;
use crate::dynamics::{March, MethodState};
use crate::modes::WkbMedium;
use crate::run::compute::Computed;
use crate::run::event::Listener;
use crate::run::march::{MarchStart, Marching};
use crate::run::method::method;
use crate::run::observer::{LineAtEnd, NodeChange, RunEnd, RunRecord};
use crate::run::observers::{ObservedRun, RecordedResponse, of_lines};
use crate::run::output_times::OutputTimes;
use crate::run::published_curve::differences;
use crate::run::recorded::Recorded;
use crate::run::recorder::{Recorder, RecorderPlan};
use crate::run::requested_statistics::{self, StatisticSource, add_stated, of_channels, settled};
use crate::run::response::AskedResponse;
use crate::run::settings::set_numerical_damping;
use crate::run::steady_state::settling_quantity;
use crate::run::under_way::{MethodOf, UnderWay, halved};
use crate::run::{Cost, Profile, Work, step_envelope};
use crate::scene::Scene;
use crate::solve::NewtonError;

/// A system under way.
struct SystemUnderWay<'a> {
    system: MovingSystem,
    /// The bodies that turn, with their mass.
    bodies: Vec<MovingBody>,
    channels: Channels,
    plan: &'a MotionPlan,
    /// What is let go at a time, the earliest first.
    releases: VecDeque<Release>,
    happened: Vec<String>,
}

/// What changes a system.
#[derive(Debug, Clone, Copy)]
enum SystemChange {
    /// An end is let go.
    Release(Release),
    /// The mesh at an end that is paid out is no longer good.
    Mesh(EndMesh),
}

/// Marches from the start, or from where a stored run is resumed, to the end, and sends every row to who listens.
pub(super) fn compute<'a>(
    begun: Start,
    motion: &MotionPlan,
    from: Option<&'a ResumedSystem>,
    cancel: &'a AtomicBool,
    events: Listener<'a>,
) -> Computed {
    let (cpu, clock) = (cpu_time(), Instant::now());
    let work = Work {
        iterations: begun.iterations,
        ..Work::default()
    };
    let channels = Channels::of_system(&begun.system);
    let recorder = Recorder::new(plan(&begun, &channels, motion), events, cancel);
    let Start { system, state, .. } = begun;
    let subject = SystemUnderWay {
        bodies: bodies(&system, &state, motion.solver.method),
        channels,
        plan: motion,
        releases: by_time(&system).into(),
        happened: Vec::new(),
        system,
    };
    let march = March {
        duration: motion.settings.duration_s,
        step: motion.settings.time_step_s,
    };
    let start = MarchStart::at_rest(from, work);
    let mut marching = Marching::new(subject, state, march, recorder, start);
    let outcome = match motion.solver.method {
        Method::Static => marching.record_alone(work),
        _ => marching.run(),
    };
    let cost = Cost {
        cpu_s: cpu_time() - cpu,
        wall_s: clock.elapsed().as_secs_f64(),
        companions_wall_s: 0.0,
    };
    let (subject, state, recorder) = marching.into_parts();
    let record = finished(recorder, &subject.system, &state);
    let mut settings = motion.settings.clone();
    let period = bounds(&subject.system).forced_period;
    set_numerical_damping(&mut settings, period, &outcome.lengths);
    Computed {
        warnings: Vec::new(),
        settings,
        outcome,
        cost,
        modes: Vec::from_iter(settling_quantity(motion.recorded.response, &record.shapes)),
        curves: differences(&motion.recorded.curves, &record.history),
        record,
        happened: subject.happened,
    }
}

/// The record, completed by the lines as they are at the end of the run.
fn finished(recorder: Recorder<'_>, system: &MovingSystem, state: &SystemState) -> RunRecord {
    let ends = recorder.fault().is_none();
    let lines = system.lines(state);
    let lines: Vec<LineAtEnd<'_>> = lines
        .map(|(scene, state)| LineAtEnd {
            scene,
            state: ends.then_some(state),
        })
        .collect();
    recorder.finish(&RunEnd { lines: &lines })
}

/// What is recorded of a run.
fn plan(begun: &Start, channels: &Channels, motion: &MotionPlan) -> RecorderPlan {
    let (settings, recorded) = (&motion.settings, &motion.recorded);
    // Without inertia no energy balances.
    let balances = !matches!(motion.solver.method, Method::Quasi | Method::Static);
    let duration = settings.duration_s;
    let output_times = OutputTimes::new(duration, settings.output_interval_s);
    let window = recorded.settled_from_s.map(|from| [from, duration]);
    let quantities = channels.ids.iter().map(|id| id.quantity);
    let lines = begun.system.lines(&begun.state).map(|(scene, _)| scene);
    let scenes: Vec<&Scene> = lines.collect();
    let mut statistics: Vec<_> = of_channels(channels.ids.len())
        .chain(requested_statistics::of_lines(scenes.len()))
        .chain(settled(quantities, window))
        .collect();
    add_stated(&mut statistics, &recorded.stated, |of| {
        source_of(of, begun, channels)
    });
    let observers = of_lines(ObservedRun {
        channels: channels.ids.clone(),
        scenes: &scenes,
        along: begun.along.clone(),
        balances,
        duration,
        rows: output_times.rows(),
        statistics,
        response: recorded.response.map(|asked| response(asked, begun)),
    });
    RecorderPlan {
        channels: channels.ids.clone(),
        profiles: profiles(&begun.system, &begun.state),
        observers,
        balances,
        output_times,
        shape_interval: recorded.shape_interval_s,
        duration,
    }
}

/// The response of the lines, and each of them where the system rests.
fn response(asked: AskedResponse, begun: &Start) -> RecordedResponse {
    let lines = begun.system.lines(&begun.state);
    let at_rest = lines.map(|(scene, state)| WkbMedium::of_line_at_rest(scene, state));
    RecordedResponse {
        asked,
        at_rest: at_rest.collect(),
    }
}

/// What a statistic is taken of; nothing of what the run has no channel or line for.
fn source_of(of: &Subject, begun: &Start, channels: &Channels) -> Option<StatisticSource> {
    match of {
        Subject::Channel(id) => {
            let index = channels.ids.iter().position(|known| known == id);
            index.map(StatisticSource::Channel)
        }
        Subject::Along(quantity, line) => {
            let number = begun.system.network.line(line)?;
            Some(StatisticSource::Line(number, *quantity))
        }
        _ => None,
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

/// The bodies that turn; a method without inertia reads no force of it at their pins.
fn bodies(system: &MovingSystem, state: &SystemState, method: Method) -> Vec<MovingBody> {
    let bodies = moving_bodies(system, state).into_iter();
    match method {
        Method::Quasi | Method::Static => bodies.map(|body| body.massless()).collect(),
        _ => bodies.collect(),
    }
}

impl SystemUnderWay<'_> {
    /// Lets an end go.
    fn release(&mut self, release: Release, state: &mut SystemState) {
        self.system.release(release, state);
        self.happened.push(in_time(&self.system, release));
    }

    /// Parts or joins the segment of an end that is paid out.
    fn remesh(
        &mut self,
        end: EndMesh,
        time: f64,
        state: &mut SystemState,
        method: &mut MethodState,
    ) -> Result<NodeChange, String> {
        let (number, at, need) = end;
        let line = self.system.paid[number].line;
        if need == Remesh::Stop {
            return Err(format!(
                "at t = {time:.6} s nothing is left of line {} to pass its end {}: a section, a clump or its other end is there; let it run a shorter way, or begin with a longer line",
                self.system.network.lines[line].name,
                ["A", "B"][at]
            ));
        }
        let (node, comes) = self.system.remesh(end, time, state, method)?;
        Ok(NodeChange { line, node, comes })
    }
}

impl UnderWay for SystemUnderWay<'_> {
    type System = MovingSystem;
    type Change = SystemChange;

    fn system(&self) -> &MovingSystem {
        &self.system
    }

    fn recorded(&self) -> impl Recorded<State = SystemState> {
        RecordedSystem {
            system: &self.system,
            bodies: &self.bodies,
            channels: &self.channels,
        }
    }

    fn method(&self, state: &SystemState) -> MethodOf<Self> {
        let MotionPlan {
            solver, settings, ..
        } = self.plan;
        let system = &self.system;
        let resolutions = system.scenes.iter().filter_map(Scene::velocity_resolution);
        method(
            (solver, settings),
            (system, state),
            || scale_of_motion(system),
            resolutions.reduce(f64::min),
        )
    }

    fn begins_off_rest(&self) -> bool {
        let mut lines = self.system.scenes.iter();
        lines.any(|scene| scene.line.begins_off_rest())
    }

    fn next_change(&self) -> f64 {
        let first = self.releases.front();
        first.map_or(f64::INFINITY, |release| release.time)
    }

    fn due(&mut self, has_come: &dyn Fn(f64) -> bool, state: &SystemState) -> Option<SystemChange> {
        while has_come(self.next_change())
            && let Some(release) = self.releases.pop_front()
        {
            if !self.system.is_released(release, state) {
                return Some(SystemChange::Release(release));
            }
            self.happened.push(gone_before(&self.system, release));
        }
        None
    }

    fn by_state(&self, time: f64, state: &SystemState) -> Option<SystemChange> {
        let release = by_tension(&self.system, state, time).map(SystemChange::Release);
        release.or_else(|| self.system.end_mesh(state).map(SystemChange::Mesh))
    }

    fn change(
        &mut self,
        change: SystemChange,
        time: f64,
        state: &mut SystemState,
        method: &mut MethodState,
    ) -> Result<Option<NodeChange>, String> {
        match change {
            SystemChange::Release(release) => {
                self.release(release, state);
                Ok(None)
            }
            SystemChange::Mesh(end) => self.remesh(end, time, state, method).map(Some),
        }
    }

    fn happened(&self) -> &[String] {
        &self.happened
    }

    fn resume(
        &mut self,
        from: &SystemCheckpoint,
        state: &mut SystemState,
        channels: usize,
        march: March,
    ) -> Result<(), String> {
        if from.state.added != state.added {
            check_added(from, state)?;
            self.system.mesh_as(&from.state.added, state)?;
            state.size_as(&from.state);
        }
        check(from, state, channels, &profiles(&self.system, state))?;
        state.restore(&from.state);
        for that_turn in [false, true] {
            self.system.turn_clamps(state, that_turn);
        }
        self.system.free_released_ends(state);
        self.system.pay_out(state);
        let gone = |release: &Release| {
            march.is_at(&from.place, release.time) && self.system.is_released(*release, state)
        };
        self.releases.retain(|release| !gone(release));
        self.happened.clone_from(&from.happened);
        Ok(())
    }

    fn in_words(&self, time: f64, step: Option<f64>, why: &NewtonError) -> String {
        let node = self.system.node_name(why.node());
        let problem = match why {
            NewtonError::NotConverged {
                iterations, moved, ..
            } => format!(
                "Newton did not converge in {iterations} iterations: {node} still moves by {moved:.3e} m; try a smaller time_step_s, or more segments there"
            ),
            NewtonError::Singular { .. } => {
                format!(
                    "the tangent is singular at {node}: nothing holds it; give it mass, drag or tension"
                )
            }
            NewtonError::NotFinite { .. } => format!("a force is not finite at {node}"),
            NewtonError::Runaway { .. } | NewtonError::Unstable { .. } => format!("{why}, {node}"),
        };
        format!("at t = {time:.6} s {problem}{}", halved(step))
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
