//! A line by itself on its way through time, as it is between its events.

use std::cell::OnceCell;
use std::collections::BTreeMap;

use super::line_bounds::scale_of_motion;
use super::method::method;
use super::observers::observers;
use super::output_times::OutputTimes;
use super::recorded::{Recorded, RecordedLine};
use super::recorder::RecorderPlan;
use super::under_way::{MethodOf, UnderWay, halved};
use super::{Checkpoint, Settings, energy_balance, step_envelope};
use crate::case::{self, Case, ChannelSpec, Method};
use crate::dynamics::{March, MethodState};
use crate::run::observer::NodeChange;
use crate::scene::{EnergyRates, Scene};
use crate::solve::{Kinematics, NewtonError, State};

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

/// What is recorded of a line with these channels.
pub(super) fn plan(case: &Case, scene: &Scene, channels: &[ChannelSpec]) -> RecorderPlan {
    let at_rest = case.solver.method == Method::Static;
    RecorderPlan {
        channels: channels.iter().map(|channel| channel.id.clone()).collect(),
        profiles: vec![step_envelope::profile(scene)],
        observers: observers(case, scene, channels),
        balances: energy_balance::is_stated(case),
        output_times: OutputTimes::new(case.solver.duration_s, case.output.interval_s),
        shape_interval: Some(case.output.shape_interval_s),
        duration: if at_rest { 0.0 } else { case.solver.duration_s },
    }
}

/// A line under way.
pub(super) struct LineUnderWay<'a> {
    pub(super) case: &'a Case,
    pub(super) settings: &'a Settings,
    /// The line at first and after each of its events.
    pub(super) phases: &'a [Scene],
    /// Events so far.
    pub(super) phase: usize,
    pub(super) channels: &'a [ChannelSpec],
    /// Digests of its tables, once a checkpoint needs them.
    pub(super) digests: OnceCell<BTreeMap<String, String>>,
}

impl LineUnderWay<'_> {
    /// The line as it is now.
    pub(super) fn scene(&self) -> &Scene {
        &self.phases[self.phase]
    }
}

impl UnderWay for LineUnderWay<'_> {
    type System = Scene;
    /// Its next event.
    type Change = ();

    fn system(&self) -> &Scene {
        self.scene()
    }

    fn recorded(&self) -> impl Recorded<State = State> {
        RecordedLine {
            scene: self.scene(),
            channels: self.channels,
        }
    }

    fn method(&self, state: &State) -> MethodOf<Self> {
        let scene = &self.phases[0];
        method(
            (&self.case.solver, self.settings),
            (scene, state),
            || scale_of_motion(self.case, scene),
            scene.velocity_resolution(),
        )
    }

    fn begins_off_rest(&self) -> bool {
        self.scene().line.begins_off_rest()
    }

    fn energy_in_motion(&self, state: &State) -> Option<EnergyRates> {
        let mut moving = state.clone();
        self.scene().prescribe(0.0, &mut moving);
        Some(self.scene().energy_rates(0.0, &moving))
    }

    fn next_change(&self) -> f64 {
        let event = self.scene().events.get(self.phase);
        event.map_or(f64::INFINITY, |event| event.time)
    }

    fn due(&mut self, has_come: &dyn Fn(f64) -> bool, _: &State) -> Option<()> {
        has_come(self.next_change()).then_some(())
    }

    fn change(
        &mut self,
        (): (),
        _: f64,
        _: &mut State,
        _: &mut MethodState,
    ) -> Result<Option<NodeChange>, String> {
        self.phase += 1;
        Ok(None)
    }

    fn digests(&self) -> BTreeMap<String, String> {
        self.digests
            .get_or_init(|| case::digests(self.case))
            .clone()
    }

    fn phase(&self) -> usize {
        self.phase
    }

    fn resume(
        &mut self,
        from: &Checkpoint,
        state: &mut State,
        channels: usize,
        _: March,
    ) -> Result<(), String> {
        from.check_case(self.case)?;
        if from.phase >= self.phases.len() {
            return Err(format!("this line has not {} events", from.phase));
        }
        self.phase = from.phase;
        from.check(self.scene(), channels)?;
        *state = from.state.clone();
        Ok(())
    }

    fn in_words(&self, time: f64, step: Option<f64>, why: &NewtonError) -> String {
        let (node, halved, advice) = (why.node(), halved(step), advice(why));
        format!("at t = {time:.6} s, node {node}: {why}{halved}; {advice}")
    }
}

/// What to try after a step that failed at every length.
fn advice(why: &NewtonError) -> &'static str {
    use crate::solve::NewtonError::{NotConverged, NotFinite, Runaway, Singular, Unstable};
    match why {
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
