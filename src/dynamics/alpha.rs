//! Implicit generalized-alpha (Chung and Hulbert 1993, doi 10.1115/1.2900803), with the exact tangent.
//!
//! Second order, unconditionally stable on linear problems, and with the numerical damping of high
//! frequencies set by one number, the spectral radius rho at infinite frequency:
//!
//! ```text
//! alpha_m = (2 rho - 1)/(rho + 1)   alpha_f = rho/(rho + 1)
//! gamma = 1/2 - alpha_m + alpha_f   beta = (1 - alpha_m + alpha_f)²/4
//! x1 = x0 + h v0 + h² ((1/2 - beta) a0 + beta a1)      v1 = v0 + h ((1 - gamma) a0 + gamma a1)
//! M(x) (.)a = f(t, x, v) at  x = (1 - alpha_f) x1 + alpha_f x0, v and t likewise,
//!                            a = (1 - alpha_m) a1 + alpha_m a0
//! ```
//!
//! rho = 1 is close to Newmark's average acceleration, rho = 0 damps most. The forces are taken at the
//! point between the steps, so that Newton works on one state there. The algorithmic acceleration
//! is carried from step to step: taken anew from the forces, the method falls to first order.

use super::{Stepper, Tally};
use crate::linalg::V3;
use crate::solve::{Factors, Newton, NewtonError, State, System};

/// The method and its scratch for one line; allocates only when made.
#[derive(Debug, Clone)]
pub struct Alpha {
    alpha_m: f64,
    alpha_f: f64,
    beta: f64,
    gamma: f64,
    newton: Newton,
    /// The state at the end of the step.
    end: State,
    /// The state between, at which forces are in balance.
    between: State,
    /// Change of acceleration over the step before, per second, for the predictor \[m/s³\].
    jerk: Vec<V3>,
}

impl Alpha {
    /// For a line of `nodes` nodes. `rho` from 0 to 1; tolerance \[m\] and iterations as in [`Newton`].
    #[must_use]
    pub fn new(nodes: usize, rho: f64, tolerance: f64, max_iterations: usize) -> Self {
        let alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
        let alpha_f = rho / (rho + 1.0);
        let state = State::at_rest(vec![V3::zeros(); nodes]);
        Self {
            alpha_m,
            alpha_f,
            beta: 0.25 * (1.0 - alpha_m + alpha_f).powi(2),
            gamma: 0.5 - alpha_m + alpha_f,
            newton: Newton::new(nodes, tolerance, max_iterations),
            end: state.clone(),
            between: state,
            jerk: vec![V3::zeros(); nodes],
        }
    }

    /// Shares of position, velocity and acceleration in the tangent for a step of h seconds.
    fn factors(&self, h: f64) -> Factors {
        let (k_f, k_m) = (1.0 - self.alpha_f, 1.0 - self.alpha_m);
        Factors {
            mass: k_m / (k_f * self.beta * h * h),
            damping: self.gamma / (self.beta * h),
            stiffness: 1.0,
        }
    }

    /// The end state foretold with the acceleration going on as before, and the state between.
    fn predict<S: System + ?Sized>(&mut self, system: &S, t: f64, h: f64, state: &State) {
        let (beta, gamma) = (self.beta, self.gamma);
        for i in system.free() {
            let a0 = state.a[i];
            let a1 = a0 + self.jerk[i] * h;
            self.end.x[i] = state.x[i] + (state.v[i] + (a0 * (0.5 - beta) + a1 * beta) * h) * h;
            self.end.v[i] = state.v[i] + (a0 * (1.0 - gamma) + a1 * gamma) * h;
            self.end.a[i] = a1;
        }
        system.prescribe(t + h, &mut self.end);
        let mix = |k: f64, new: &[V3], old: &[V3], out: &mut [V3]| {
            for ((o, n), p) in out.iter_mut().zip(new).zip(old) {
                *o = n * (1.0 - k) + p * k;
            }
        };
        mix(self.alpha_f, &self.end.x, &state.x, &mut self.between.x);
        mix(self.alpha_f, &self.end.v, &state.v, &mut self.between.v);
        mix(self.alpha_m, &self.end.a, &state.a, &mut self.between.a);
    }

    /// The end state from the converged state between.
    fn finish<S: System + ?Sized>(&mut self, system: &S, h: f64, state: &mut State) {
        let (m, k) = (1.0 / (1.0 - self.alpha_m), self.alpha_m);
        let (beta, gamma) = (self.beta, self.gamma);
        for i in system.free() {
            let a0 = state.a[i];
            let a1 = (self.between.a[i] - a0 * k) * m;
            self.jerk[i] = (a1 - a0) / h;
            self.end.x[i] = state.x[i] + (state.v[i] + (a0 * (0.5 - beta) + a1 * beta) * h) * h;
            self.end.v[i] = state.v[i] + (a0 * (1.0 - gamma) + a1 * gamma) * h;
            self.end.a[i] = a1;
        }
        state.copy_from(&self.end);
    }
}

impl Stepper for Alpha {
    fn step<S: System + ?Sized>(
        &mut self,
        system: &S,
        t: f64,
        dt: f64,
        state: &mut State,
    ) -> Result<(), NewtonError> {
        self.predict(system, t, dt, state);
        let at = t + (1.0 - self.alpha_f) * dt;
        let factors = self.factors(dt);
        match self.newton.solve(system, at, &mut self.between, factors) {
            Ok(_) => {
                self.finish(system, dt, state);
                Ok(())
            }
            Err(why) => {
                self.jerk.fill(V3::zeros());
                Err(why)
            }
        }
    }

    fn tally(&self) -> Tally {
        Tally {
            iterations: self.newton.iterations,
            evaluations: 0,
        }
    }
}
