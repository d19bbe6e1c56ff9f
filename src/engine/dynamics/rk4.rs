//! Classical Runge-Kutta of order 4: the independent reference for accuracy, and the method for short lines that snap.
//!
//! Stable up to `h omega = 2.785` for the fastest axial mode, known beforehand, and to `h lambda = 2.785` for the fastest
//! decay by drag, which grows with velocity: a longer step is rejected and halved.
//!
//! A rotation vector v from the base of its body changes by `v' = J(v)^-1 w` with the angular velocity w along the axes of the body
//! ([`Integrated::rate`]), so that its order is that of the method.

use super::step_control::DOUBLING_ERROR;
use super::{Integrator, MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{BandedEquations, Integrated, NewtonError, Parted, State};

/// A step \[s\] above the stability limit \[s\] that a segment sets, in words.
#[must_use]
pub fn above_limit(step: f64, limit: f64, at: &str) -> String {
    format!("time step {step} s is above the stability limit of RK4, {limit:.3e} s, set by {at}")
}

/// What to do about it.
pub const BELOW_LIMIT: &str = "choose a smaller step, leave it open, or use the solver `alpha`";

/// Stability limit on the negative real axis.
const REAL_AXIS_LIMIT: f64 = 2.785;

/// The method and its work arrays, for states X and the equations W of a system; allocates only in [`Rk4::new`].
#[derive(Debug, Clone)]
pub struct Rk4<X = State, W = BandedEquations> {
    equations: W,
    stage: X,
    next: X,
    /// The fastest decay at the end of the last step \[1/s\] and its node, once known.
    decay: Option<(f64, usize)>,
    work_counts: WorkCounts,
}

impl<X: Parted, W> Rk4<X, W> {
    /// For a system with states of the size of this one.
    #[must_use]
    pub fn new<S: Integrated<State = X, Work = W>>(system: &S, state: &X) -> Self {
        Self {
            equations: system.equations(state),
            stage: state.clone(),
            next: state.clone(),
            decay: None,
            work_counts: WorkCounts::default(),
        }
    }

    /// Evaluates the stage and adds its derivative, times `weight`, to the next state.
    fn add_stage<S: Integrated<State = X, Work = W>>(
        &mut self,
        system: &S,
        t: f64,
        weight: f64,
    ) -> Result<(), NewtonError> {
        self.work_counts.evaluations += 1;
        system.prescribe(t, &mut self.stage);
        system.follow(&mut self.stage);
        system.update_wave_kinematics(t, &mut self.stage);
        system.accelerate(&mut self.equations, t, &mut self.stage)?;
        let parts = self.next.parts_mut().zip(self.stage.parts());
        for (number, (next, stage)) in parts.enumerate() {
            for i in system.free(number) {
                next.x[i] += system.rate(number, stage, i) * weight;
                next.v[i] += stage.a[i] * weight;
            }
            next.add_creep(stage, weight);
        }
        Ok(())
    }

    /// Sets the stage to `state + h * derivative of the stage before`.
    fn move_stage<S: Integrated<State = X>>(&mut self, system: &S, state: &X, h: f64) {
        let parts = self.stage.parts_mut().zip(state.parts());
        for (number, (stage, state)) in parts.enumerate() {
            for i in system.free(number) {
                stage.x[i] = state.x[i] + system.rate(number, stage, i) * h;
                stage.v[i] = state.v[i] + stage.a[i] * h;
            }
            stage.move_creep(state, h);
        }
    }

    /// The first free node whose numbers are not finite: divergence shows in accelerations first.
    fn diverged<S: Integrated<State = X>>(&self, system: &S) -> Option<usize> {
        let finite = |p: &V3| p.iter().all(|c| c.is_finite());
        self.next.parts().enumerate().find_map(|(number, next)| {
            let diverged =
                |i: &usize| !finite(&next.x[*i]) || !finite(&next.v[*i]) || !finite(&next.a[*i]);
            let node = system.free(number).find(diverged)?;
            Some(system.offset(number) + node)
        })
    }

    /// Rejects a step with a number that is not finite, and one too long for the decay by drag at its start or end. Returns an error ratio
    /// that allows doubling where the decay does.
    fn check<S: Integrated<State = X, Work = W>>(
        &mut self,
        system: &S,
        h: f64,
        state: &X,
    ) -> Result<f64, NewtonError> {
        if let Some(node) = self.diverged(system) {
            return Err(NewtonError::NotFinite { node });
        }
        let mut ratio = 0.0_f64;
        let start = self
            .decay
            .unwrap_or_else(|| system.fastest_decay(&self.equations, state));
        self.decay = Some(start);
        let end = system.fastest_decay(&self.equations, &self.next);
        for (rate, node) in [end, start] {
            if h * rate > REAL_AXIS_LIMIT {
                return Err(NewtonError::Unstable { node });
            }
            ratio = ratio.max(2.0 * DOUBLING_ERROR * h * rate / REAL_AXIS_LIMIT);
        }
        self.decay = Some(end);
        Ok(ratio)
    }

    /// The four stages, and the state at the end of the step.
    fn take<S: Integrated<State = X, Work = W>>(
        &mut self,
        system: &S,
        (t, dt): (f64, f64),
        state: &X,
    ) -> Result<(), NewtonError> {
        self.stage.copy_from(state);
        self.next.copy_from(state);
        let own = self.stage.parts_mut().chain(self.next.parts_mut());
        own.for_each(State::integrate_creep);
        let half = 0.5 * dt;
        self.add_stage(system, t, dt / 6.0)?;
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0)?;
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0)?;
        self.move_stage(system, state, dt);
        self.add_stage(system, t + dt, dt / 6.0)?;
        // The acceleration of the last stage is that at the end of the step: good for output.
        for (next, stage) in self.next.parts_mut().zip(self.stage.parts()) {
            next.a.copy_from_slice(&stage.a);
        }
        system.prescribe(t + dt, &mut self.next);
        system.follow(&mut self.next);
        self.next.swap_kept_waves(&mut self.stage);
        system.update_wave_kinematics(t + dt, &mut self.next);
        self.next.swap_kept_waves(&mut self.stage);
        Ok(())
    }
}

impl<S: Integrated> Stepper<S> for Rk4<S::State, S::Work> {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut S::State) -> Result<f64, StepError> {
        self.take(system, (at.t, at.dt), state)?;
        let ratio = self.check(system, at.dt, state)?;
        state.copy_from(&self.next);
        Ok(ratio)
    }

    fn accelerate(&mut self, system: &S, t: f64, state: &mut S::State) -> Result<(), NewtonError> {
        system.accelerate(&mut self.equations, t, state)
    }

    fn restart(&mut self, system: &S, t: f64, state: &mut S::State) {
        system.update_wave_kinematics(t, state);
        // Where nothing has mass the first stage says so.
        let _ = self.accelerate(system, t, state);
        self.decay = None;
    }

    fn pass_kink(&mut self, system: &S, t: f64, state: &mut S::State) -> bool {
        let jumps = system.pass_kink(t, state);
        if jumps {
            self.restart(system, t, state);
        }
        jumps
    }
}

impl<X, W> Integrator for Rk4<X, W> {
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
