//! The quasi-static march: at each instant the line is in equilibrium of tension, weight and drag, its
//! inertia left out. Beside a dynamic run it shows when inertia matters.
//!
//! `0 = f(t, x, v)` with v by backward differences of second order, variable step (BDF2; the first step by
//! backward Euler). L-stable: the fast decay to the drag-limited speed needs no small step. Drag coefficients are
//! held over a step, at the speeds of the step before: where one jumps (a drag crisis), a line without inertia may
//! move at either of two speeds, and so keeps to the one it has until that is gone.

use super::{MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{Factors, Newton, NewtonError, State, System};

/// The method and its scratch for one line; allocates only when made.
#[derive(Debug, Clone)]
pub struct QuasiStatic {
    newton: Newton,
    trial: State,
    /// Positions one accepted step back, and the length of that step \[s\].
    before: Option<f64>,
    x_before: Vec<V3>,
    /// Whether speeds are known at which drag coefficients can be held.
    remembers: bool,
}

/// Shares of inertia that a step falls back on when it does not converge without; the last is none.
const HELP: [f64; 6] = [1.0, 0.3, 0.1, 0.03, 0.01, 0.0];

impl QuasiStatic {
    /// For a line of `nodes` nodes; tolerance \[m\] and iterations as in [`Newton`].
    #[must_use]
    pub fn new(nodes: usize, tolerance: f64, max_iterations: usize) -> Self {
        Self {
            newton: Newton::new(nodes, tolerance, max_iterations),
            trial: State::at_rest(vec![V3::zeros(); nodes]),
            before: None,
            x_before: vec![V3::zeros(); nodes],
            remembers: false,
        }
    }

    /// Shares of the old positions in the velocity: `v = c (x - x0) + d (x0 - x_before)`, the numbers (c, d).
    fn differences(&self, h: f64) -> (f64, f64) {
        match self.before {
            None => (1.0 / h, 0.0),
            Some(last) => {
                let ratio = h / last;
                let c = (1.0 + 2.0 * ratio) / (h * (1.0 + ratio));
                (c, -ratio / (last * (1.0 + ratio)))
            }
        }
    }

    /// The trial state with positions moved on at the velocity they had, inertia `share` of the true one.
    fn predict<S: System + ?Sized>(&mut self, system: &S, t: f64, h: f64, state: &State) {
        let (c, d) = self.differences(h);
        self.trial.copy_from(state);
        for i in system.free() {
            self.trial.x[i] = state.x[i] + state.v[i] * h;
            self.trial.v[i] = state.v[i] * (h * c) + (state.x[i] - self.x_before[i]) * d;
            self.trial.a[i] = V3::zeros();
        }
        system.prescribe(t + h, &mut self.trial);
        system.update_wave_kinematics(t + h, &mut self.trial);
        self.leave_inertia_out(system);
    }

    /// Ends may be driven; their own acceleration is nothing to the line here.
    fn leave_inertia_out<S: System + ?Sized>(&mut self, system: &S) {
        let free = system.free();
        for i in 0..system.nodes() {
            if !free.contains(&i) {
                self.trial.a[i] = V3::zeros();
            }
        }
    }

    /// Newton without inertia; where that fails, first with a share of it as ballast, in ever smaller doses.
    fn converge<S: System + ?Sized>(
        &mut self,
        system: &S,
        t: f64,
        h: f64,
        state: &State,
    ) -> Result<(), NewtonError> {
        let (c, _) = self.differences(h);
        let plain = Factors {
            mass: 0.0,
            damping: c,
            stiffness: 1.0,
        };
        if self
            .newton
            .solve(system, t + h, &mut self.trial, plain)
            .is_ok()
        {
            return Ok(());
        }
        self.predict(system, t, h, state);
        self.help(system, t, h, state, &HELP)
    }

    /// Without inertia, a slack line that nothing slows along itself has no speed of its own, and the equations have
    /// roots at any distance. None that a line could not reach from where it was (twice its length, and its stretch) is
    /// where the line went.
    fn stays_near<S: System + ?Sized>(&self, system: &S, state: &State) -> Result<(), NewtonError> {
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

    /// Newton with these shares of inertia, one after the other.
    fn help<S: System + ?Sized>(
        &mut self,
        system: &S,
        t: f64,
        h: f64,
        state: &State,
        shares: &[f64],
    ) -> Result<(), NewtonError> {
        let (c, _) = self.differences(h);
        for share in shares {
            let factors = Factors {
                mass: share * c / h,
                damping: c,
                stiffness: 1.0,
            };
            for i in system.free() {
                self.trial.a[i] = (self.trial.v[i] - state.v[i]) * (share / h);
            }
            self.newton.solve(system, t + h, &mut self.trial, factors)?;
        }
        Ok(())
    }
}

impl Stepper for QuasiStatic {
    fn step<S: System + ?Sized>(
        &mut self,
        system: &S,
        at: TimeStep,
        state: &mut State,
    ) -> Result<f64, StepError> {
        let TimeStep { t, dt, .. } = at;
        if !self.remembers {
            // A line at rest has no speeds to take coefficients at: those after one step with its inertia.
            self.predict(system, t, dt, state);
            self.help(system, t, dt, state, &HELP[..1])?;
            system.freeze_drag_coefficients(&mut self.trial);
            state.memory.copy_from(&self.trial.memory);
            self.remembers = true;
        }
        self.predict(system, t, dt, state);
        self.converge(system, t, dt, state)?;
        self.stays_near(system, state)?;
        self.x_before.copy_from_slice(&state.x);
        self.before = Some(dt);
        state.copy_from(&self.trial);
        system.freeze_drag_coefficients(state);
        Ok(0.0)
    }

    fn method_state(&self) -> MethodState {
        MethodState {
            before: self.before,
            x_before: self.x_before.clone(),
            remembers: self.remembers,
            rate: self.newton.rate(),
            work_counts: self.work_counts(),
            ..MethodState::default()
        }
    }

    fn restore(&mut self, carried: &MethodState) {
        self.before = carried.before;
        self.x_before.clone_from(&carried.x_before);
        self.remembers = carried.remembers;
        self.newton
            .restore(carried.rate, carried.work_counts.iterations);
    }

    fn restart<S: System + ?Sized>(&mut self, _system: &S, _t: f64, _state: &mut State) {
        self.before = None;
        self.newton.reset_rate();
    }

    fn work_counts(&self) -> WorkCounts {
        WorkCounts {
            iterations: self.newton.iterations,
            evaluations: 0,
        }
    }
}
