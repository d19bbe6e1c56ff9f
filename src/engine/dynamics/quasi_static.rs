//! The quasi-static march: at each instant tension, weight and drag are in equilibrium, without inertia. Compared with a
//! dynamic run it shows when inertia matters.
//!
//! `0 = f(t, x, v)` with v by backward differences of second order at variable step (BDF2; the first step by backward
//! Euler). L-stable: the fast decay to the velocity limited by drag needs no small step. Drag coefficients are frozen over a
//! step at the velocities of the step before: where a coefficient jumps (drag crisis), a line without inertia has two
//! velocities in equilibrium, and so keeps to the branch it is on as long as that exists.

use super::{Integrator, MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{Factors, Hysteresis, Kinematics, Newton, NewtonError, Residual, State};

/// The method and its work arrays; allocates only in [`QuasiStatic::new`].
#[derive(Debug, Clone)]
pub struct QuasiStatic {
    newton: Newton,
    trial: State,
    /// Length of the last accepted step \[s\].
    last_step: Option<f64>,
    /// Positions one accepted step back.
    x_before: Vec<V3>,
    /// Whether there are velocities at which drag coefficients are frozen.
    drag_is_frozen: bool,
}

/// Coefficients (c, d) of the backward difference `v = c (x - x0) + d (x0 - x_before)` in a step of h \[s\] after one of another length; the first
/// step by backward Euler.
#[must_use]
pub fn backward_differences(last_step: Option<f64>, h: f64) -> (f64, f64) {
    match last_step {
        None => (1.0 / h, 0.0),
        Some(last) => {
            let ratio = h / last;
            let c = (1.0 + 2.0 * ratio) / (h * (1.0 + ratio));
            (c, -ratio / (last * (1.0 + ratio)))
        }
    }
}

/// Fractions of inertia for a step that does not converge without; the last is none.
pub const INERTIA: [f64; 6] = [1.0, 0.3, 0.1, 0.03, 0.01, 0.0];

impl QuasiStatic {
    /// For a system of `nodes` nodes; tolerance \[m\] and iterations as in [`Newton`].
    #[must_use]
    pub fn new(nodes: usize, tolerance: f64, max_iterations: usize) -> Self {
        Self {
            newton: Newton::new(nodes, tolerance, max_iterations),
            trial: State::at_rest(vec![V3::zeros(); nodes]),
            last_step: None,
            x_before: vec![V3::zeros(); nodes],
            drag_is_frozen: false,
        }
    }

    fn differences(&self, h: f64) -> (f64, f64) {
        backward_differences(self.last_step, h)
    }

    /// Predicts the trial state at the velocities of the state before, without inertia.
    fn predict<S: Kinematics>(&mut self, system: &S, t: f64, h: f64, state: &State) {
        let (c, d) = self.differences(h);
        self.trial.copy_from(state);
        for i in system.free() {
            self.trial.x[i] = state.x[i] + state.v[i] * h;
            self.trial.v[i] = state.v[i] * (h * c) + (state.x[i] - self.x_before[i]) * d;
            self.trial.a[i] = V3::zeros();
        }
        system.prescribe(t + h, &mut self.trial);
        system.update_wave_kinematics(t + h, &mut self.trial);
        // The acceleration of driven ends counts no more than that of free nodes.
        let free = system.free();
        self.trial.a[..free.start].fill(V3::zeros());
        self.trial.a[free.end..].fill(V3::zeros());
    }

    /// Newton without inertia; if that fails, with decreasing fractions of it.
    fn converge<S: Residual>(
        &mut self,
        system: &S,
        t: f64,
        h: f64,
        state: &State,
    ) -> Result<(), NewtonError> {
        let massless = Factors {
            mass: 0.0,
            damping: self.differences(h).0,
            stiffness: 1.0,
        };
        let solved = self.newton.solve(system, t + h, &mut self.trial, massless);
        if solved.is_ok() {
            return Ok(());
        }
        self.predict(system, t, h, state);
        self.converge_with_inertia(system, t, h, state, &INERTIA)
    }

    /// Newton with these fractions of inertia, one after the other.
    fn converge_with_inertia<S: Residual>(
        &mut self,
        system: &S,
        t: f64,
        h: f64,
        state: &State,
        fractions: &[f64],
    ) -> Result<(), NewtonError> {
        let (c, _) = self.differences(h);
        for fraction in fractions {
            let factors = Factors {
                mass: fraction * c / h,
                damping: c,
                stiffness: 1.0,
            };
            for i in system.free() {
                self.trial.a[i] = (self.trial.v[i] - state.v[i]) * (fraction / h);
            }
            self.newton.solve(system, t + h, &mut self.trial, factors)?;
        }
        Ok(())
    }

    /// Rejects a root beyond three times the length of the line: without inertia a slack line without axial drag has no
    /// velocity of its own, and the equations have roots at any distance.
    fn check_reach<S: Kinematics>(&self, system: &S, state: &State) -> Result<(), NewtonError> {
        let length: f64 = state.x.windows(2).map(|x| (x[1] - x[0]).norm()).sum();
        let moved = |i: usize| (self.trial.x[i] - state.x[i]).norm();
        system
            .free()
            .find(|&i| moved(i) > 3.0 * length)
            .map_or(Ok(()), |node| {
                Err(NewtonError::Runaway {
                    node,
                    moved: moved(node),
                })
            })
    }
}

impl<S: Residual + Hysteresis> Stepper<S> for QuasiStatic {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut State) -> Result<f64, StepError> {
        let TimeStep { t, dt, .. } = at;
        if !self.drag_is_frozen {
            // A line at rest has no velocities for its drag coefficients: take those after one step with inertia.
            self.predict(system, t, dt, state);
            self.converge_with_inertia(system, t, dt, state, &INERTIA[..1])?;
            system.freeze_drag_coefficients(&mut self.trial);
            state.memory.copy_from(&self.trial.memory);
            self.drag_is_frozen = true;
        }
        self.predict(system, t, dt, state);
        self.converge(system, t, dt, state)?;
        self.check_reach(system, state)?;
        self.x_before.copy_from_slice(&state.x);
        self.last_step = Some(dt);
        state.copy_from(&self.trial);
        system.freeze_drag_coefficients(state);
        Ok(0.0)
    }

    fn restart(&mut self, _system: &S, _t: f64, _state: &mut State) {
        self.last_step = None;
        self.newton.reset_rate();
    }

    /// Velocities are by backward differences: none of them reaches across a jump.
    fn pass_kink(&mut self, system: &S, t: f64, state: &mut State) -> bool {
        let jumps = system.pass_kink(t, state);
        if jumps {
            self.restart(system, t, state);
        }
        jumps
    }
}

impl Integrator for QuasiStatic {
    fn method_state(&self) -> MethodState {
        MethodState {
            last_step: self.last_step,
            x_before: self.x_before.clone(),
            drag_is_frozen: self.drag_is_frozen,
            rate: self.newton.rate(),
            work_counts: self.work_counts(),
            ..MethodState::default()
        }
    }

    fn restore(&mut self, saved: &MethodState) {
        self.last_step = saved.last_step;
        self.x_before.clone_from(&saved.x_before);
        self.drag_is_frozen = saved.drag_is_frozen;
        self.newton
            .restore(saved.rate, saved.work_counts.iterations);
    }

    fn work_counts(&self) -> WorkCounts {
        WorkCounts {
            iterations: self.newton.iterations,
            evaluations: 0,
        }
    }
}
