//! Classical Runge-Kutta of order 4: the independent reference for accuracy, and the method for short lines that snap.
//!
//! Stable up to `h omega = 2.785` for the fastest axial mode, known beforehand, and to `h lambda = 2.785` for the fastest
//! decay by drag, which grows with velocity: a longer step is rejected and halved.

use std::mem::swap;

use super::step_control::DOUBLING_ERROR;
use super::{Integrator, MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{ExplicitRhs, NewtonError, State};

/// A step \[s\] above the stability limit \[s\] that a segment sets, in words.
#[must_use]
pub fn above_limit(step: f64, limit: f64, at: &str) -> String {
    format!("time step {step} s is above the stability limit of RK4, {limit:.3e} s, set by {at}")
}

/// What to do about it.
pub const BELOW_LIMIT: &str = "choose a smaller step, leave it open, or use the solver `alpha`";

/// Stability limit on the negative real axis.
const REAL_AXIS_LIMIT: f64 = 2.785;

/// The method and its work arrays; allocates only in [`Rk4::new`].
#[derive(Debug, Clone)]
pub struct Rk4 {
    stage: State,
    next: State,
    /// The fastest decay at the end of the last step \[1/s\] and its node, once known.
    decay: Option<(f64, usize)>,
    work_counts: WorkCounts,
}

impl Rk4 {
    /// For a system of `nodes` nodes.
    #[must_use]
    pub fn new(nodes: usize) -> Self {
        let state = State::at_rest(vec![V3::zeros(); nodes]);
        Self {
            stage: state.clone(),
            next: state,
            decay: None,
            work_counts: WorkCounts::default(),
        }
    }

    /// Evaluates the stage and adds its derivative, times `weight`, to the next state.
    fn add_stage<S: ExplicitRhs>(&mut self, system: &S, t: f64, weight: f64) {
        system.prescribe(t, &mut self.stage);
        system.update_wave_kinematics(t, &mut self.stage);
        system.accelerate(t, &mut self.stage);
        self.work_counts.evaluations += 1;
        for i in system.free() {
            self.next.x[i] += self.stage.v[i] * weight;
            self.next.v[i] += self.stage.a[i] * weight;
        }
        self.next.add_creep(&self.stage, weight);
    }

    /// Sets the stage to `state + h * derivative of the stage before`.
    fn move_stage<S: ExplicitRhs>(&mut self, system: &S, state: &State, h: f64) {
        for i in system.free() {
            self.stage.x[i] = state.x[i] + self.stage.v[i] * h;
            self.stage.v[i] = state.v[i] + self.stage.a[i] * h;
        }
        self.stage.move_creep(state, h);
    }

    /// Rejects a step with a number that is not finite (divergence shows in accelerations first), and one too long for the
    /// decay by drag at its start or end. Returns an error ratio that allows doubling where the decay does.
    fn check<S: ExplicitRhs>(
        &mut self,
        system: &S,
        h: f64,
        state: &State,
    ) -> Result<f64, NewtonError> {
        let finite = |p: &V3| p.iter().all(|c| c.is_finite());
        let next = &self.next;
        let diverged = |i: usize| !finite(&next.x[i]) || !finite(&next.v[i]) || !finite(&next.a[i]);
        if let Some(node) = system.free().find(|&i| diverged(i)) {
            return Err(NewtonError::NotFinite { node });
        }
        let mut ratio = 0.0_f64;
        let start = self.decay.unwrap_or_else(|| system.fastest_decay(state));
        self.decay = Some(start);
        let end = system.fastest_decay(next);
        for (rate, node) in [end, start] {
            if h * rate > REAL_AXIS_LIMIT {
                return Err(NewtonError::Unstable { node });
            }
            ratio = ratio.max(2.0 * DOUBLING_ERROR * h * rate / REAL_AXIS_LIMIT);
        }
        self.decay = Some(end);
        Ok(ratio)
    }
}

impl<S: ExplicitRhs> Stepper<S> for Rk4 {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut State) -> Result<f64, StepError> {
        let TimeStep { t, dt, .. } = at;
        self.stage.copy_from(state);
        self.next.copy_from(state);
        for own in [&mut self.stage, &mut self.next] {
            own.integrate_creep();
        }
        let half = 0.5 * dt;
        self.add_stage(system, t, dt / 6.0);
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0);
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0);
        self.move_stage(system, state, dt);
        self.add_stage(system, t + dt, dt / 6.0);
        system.prescribe(t + dt, &mut self.next);
        swap(&mut self.next.kept_waves, &mut self.stage.kept_waves);
        system.update_wave_kinematics(t + dt, &mut self.next);
        swap(&mut self.next.kept_waves, &mut self.stage.kept_waves);
        // The acceleration of the last stage is that at the end of the step: good for output.
        self.next.a.copy_from_slice(&self.stage.a);
        let ratio = self.check(system, dt, state)?;
        state.copy_from(&self.next);
        Ok(ratio)
    }

    fn restart(&mut self, system: &S, t: f64, state: &mut State) {
        system.update_wave_kinematics(t, state);
        system.accelerate(t, state);
        self.decay = None;
    }

    fn pass_kink(&mut self, system: &S, t: f64, state: &mut State) -> bool {
        let jumps = system.pass_kink(t, state);
        if jumps {
            self.restart(system, t, state);
        }
        jumps
    }
}

impl Integrator for Rk4 {
    fn method_state(&self) -> MethodState {
        MethodState {
            decay: self.decay,
            work_counts: self.work_counts,
            ..MethodState::default()
        }
    }

    fn restore(&mut self, saved: &MethodState) {
        self.decay = saved.decay;
        self.work_counts = saved.work_counts;
    }

    fn work_counts(&self) -> WorkCounts {
        self.work_counts
    }
}
