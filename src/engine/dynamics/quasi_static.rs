//! The quasi-static march: at each instant tension, weight and drag are in equilibrium, without inertia. Compared with a
//! dynamic run it shows when inertia matters.
//!
//! `0 = f(t, x, v)` with v by backward differences of second order at variable step (BDF2; the first step by backward
//! Euler). L-stable: the fast decay to the velocity limited by drag needs no small step. Drag coefficients are frozen over a
//! step at the velocities of the step before: where a coefficient jumps (drag crisis), a line without inertia has two
//! velocities in equilibrium, and so keeps to the branch it is on as long as that exists. What a step displaced is kept, not where it
//! began: rotations count from the pose of the last accepted step.

use super::generalized_alpha::zeros;
use super::{Integrator, MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{BandedEquations, Factors, Integrated, Newton, NewtonError, Parted, State};

/// The method and its work arrays, for states X and the equations W of a system; allocates only in [`QuasiStatic::new`].
#[derive(Debug, Clone)]
pub struct QuasiStatic<X = State, W = BandedEquations> {
    newton: Newton<W>,
    trial: X,
    /// Length of the last accepted step \[s\].
    last_step: Option<f64>,
    /// Its displacements, part by part \[m\].
    displaced: Vec<Vec<V3>>,
    /// Whether there are velocities at which drag coefficients are frozen.
    drag_is_frozen: bool,
}

/// Coefficients (c, d) of the backward difference `v = c (x - x0) + d (x0 - x_before)` in a step of h \[s\] after one of another length; the first
/// step by backward Euler.
fn backward_differences(last_step: Option<f64>, h: f64) -> (f64, f64) {
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
const INERTIA: [f64; 6] = [1.0, 0.3, 0.1, 0.03, 0.01, 0.0];

/// Displacement of a step by the length of its line beyond which it is none.
const REACH: f64 = 3.0;

impl<X: Parted, W> QuasiStatic<X, W> {
    /// For a system with states of the size of this one; tolerance \[m\] and iterations as in [`Newton`].
    #[must_use]
    pub fn new<S: Integrated<State = X, Work = W>>(
        system: &S,
        state: &X,
        tolerance: f64,
        max_iterations: usize,
    ) -> Self {
        Self {
            newton: Newton::of_equations(system.equations(state), tolerance, max_iterations),
            trial: state.clone(),
            last_step: None,
            displaced: zeros(state),
            drag_is_frozen: false,
        }
    }

    fn differences(&self, h: f64) -> (f64, f64) {
        backward_differences(self.last_step, h)
    }

    /// Predicts the trial state at the velocities of the state before, without inertia.
    fn predict<S: Integrated<State = X>>(&mut self, system: &S, t: f64, h: f64, state: &X) {
        let (c, d) = self.differences(h);
        self.trial.copy_from(state);
        let parts = self.trial.parts_mut().zip(state.parts());
        for (number, (trial, start)) in parts.enumerate() {
            for i in system.free(number) {
                trial.x[i] = start.x[i] + start.v[i] * h;
                trial.v[i] = start.v[i] * (h * c) + self.displaced[number][i] * d;
            }
        }
        system.prescribe(t + h, &mut self.trial);
        system.follow(&mut self.trial);
        system.update_wave_kinematics(t + h, &mut self.trial);
        // No acceleration counts, that of driven ends no more than that of free nodes.
        for part in self.trial.parts_mut() {
            part.a.fill(V3::zeros());
        }
        system.follow(&mut self.trial);
    }

    /// Newton without inertia; if that fails, with decreasing fractions of it.
    fn converge<S: Integrated<State = X, Work = W>>(
        &mut self,
        system: &S,
        t: f64,
        h: f64,
        state: &X,
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
    fn converge_with_inertia<S: Integrated<State = X, Work = W>>(
        &mut self,
        system: &S,
        t: f64,
        h: f64,
        state: &X,
        fractions: &[f64],
    ) -> Result<(), NewtonError> {
        let (c, _) = self.differences(h);
        for fraction in fractions {
            let factors = Factors {
                mass: fraction * c / h,
                damping: c,
                stiffness: 1.0,
            };
            let parts = self.trial.parts_mut().zip(state.parts());
            for (number, (trial, start)) in parts.enumerate() {
                for i in system.free(number) {
                    trial.a[i] = (trial.v[i] - start.v[i]) * (fraction / h);
                }
            }
            system.follow(&mut self.trial);
            self.newton.solve(system, t + h, &mut self.trial, factors)?;
        }
        Ok(())
    }

    /// Rejects a root beyond three times the length of its line: without inertia a slack line without axial drag has no
    /// velocity of its own, and the equations have roots at any distance.
    fn check_reach<S: Integrated<State = X>>(
        &self,
        system: &S,
        state: &X,
    ) -> Result<(), NewtonError> {
        let parts = state.parts().zip(self.trial.parts()).enumerate();
        for (number, (before, after)) in parts.filter(|(number, _)| system.is_line(*number)) {
            let length: f64 = before.x.windows(2).map(|x| (x[1] - x[0]).norm()).sum();
            let moved = |i: usize| (after.x[i] - before.x[i]).norm();
            if let Some(node) = system.free(number).find(|i| moved(*i) > REACH * length) {
                return Err(NewtonError::Runaway {
                    node: system.offset(number) + node,
                    moved: moved(node),
                });
            }
        }
        Ok(())
    }

    /// Keeps what the step displaced.
    fn keep_displacements(&mut self, state: &X) {
        let parts = self.trial.parts().zip(state.parts());
        for ((trial, start), displaced) in parts.zip(&mut self.displaced) {
            let places = trial.x.iter().zip(&start.x);
            for (displaced, (now, before)) in displaced.iter_mut().zip(places) {
                *displaced = now - before;
            }
        }
    }
}

impl<S: Integrated> Stepper<S> for QuasiStatic<S::State, S::Work> {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut S::State) -> Result<f64, StepError> {
        let TimeStep { t, dt, reject } = at;
        if !self.drag_is_frozen {
            // Lines at rest have no velocities for their drag coefficients: take those after one step with inertia.
            self.predict(system, t, dt, state);
            self.converge_with_inertia(system, t, dt, state, &INERTIA[..1])?;
            system.freeze_drag_coefficients(&mut self.trial);
            for (part, trial) in state.parts_mut().zip(self.trial.parts()) {
                part.memory.copy_from(&trial.memory);
            }
            self.drag_is_frozen = true;
        }
        self.predict(system, t, dt, state);
        self.converge(system, t, dt, state)?;
        self.check_reach(system, state)?;
        let passed = system.passes(state, &self.trial);
        if reject && passed > 1.0 {
            return Err(StepError::Inaccurate(passed));
        }
        self.keep_displacements(state);
        self.last_step = Some(dt);
        state.copy_from(&self.trial);
        system.freeze_drag_coefficients(state);
        Ok(passed)
    }

    fn restart(&mut self, _system: &S, _t: f64, _state: &mut S::State) {
        self.last_step = None;
        self.newton.reset_rate();
    }

    /// Velocities are by backward differences: none of them reaches across a jump.
    fn pass_kink(&mut self, system: &S, t: f64, state: &mut S::State) -> bool {
        let jumps = system.pass_kink(t, state);
        if jumps {
            self.restart(system, t, state);
        }
        jumps
    }
}

impl<X: Parted, W> Integrator for QuasiStatic<X, W> {
    fn method_state(&self) -> MethodState {
        MethodState {
            last_step: self.last_step,
            displaced: self.displaced.clone(),
            drag_is_frozen: self.drag_is_frozen,
            rate: self.newton.rate(),
            work_counts: self.work_counts(),
            ..MethodState::default()
        }
    }

    fn restore(&mut self, saved: &MethodState) {
        self.drag_is_frozen = saved.drag_is_frozen;
        self.newton
            .restore(saved.rate, saved.work_counts.iterations);
        // Segments that were parted or joined begin anew.
        let nodes = self.displaced.iter().map(Vec::len);
        let is_same = nodes.eq(saved.displaced.iter().map(Vec::len));
        self.last_step = saved.last_step.filter(|_| is_same);
        if is_same {
            self.displaced.clone_from(&saved.displaced);
        }
    }

    fn work_counts(&self) -> WorkCounts {
        WorkCounts {
            iterations: self.newton.iterations,
            evaluations: 0,
        }
    }
}
