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
//! is carried from step to step, never taken anew from the forces. It stands for the true one at
//! `t + (alpha_m - alpha_f) h`, before the end of its step. So at the end it is moved on to t, for what is read off the
//! state, and at the next step back to the place that belongs to that step's length: left where it was, the method, or
//! each change of step, would be of first order.
//!
//! Forces are in balance at a mix of positions, and the chord of a segment that turns is shorter there than before and
//! after: [`System::correct_chord_lengths`] accounts for that where tensions are read.

use super::{MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{Factors, Newton, State, System};

/// The method and its scratch for one line; allocates only when made.
#[derive(Debug, Clone)]
pub struct GeneralizedAlpha {
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
    /// 1, or 0 where the predictor leaves that change out: after a step that could not be solved.
    trust: f64,
    /// Acceleration carried into the step, at the place that belongs to its length \[m/s²\].
    carried: Vec<V3>,
    control: Option<ErrorLimits>,
}

/// Iterations without gain after which a step is halved: the half converges where the whole goes in a circle.
const IDLE: usize = 6;

/// Share of the error allowed in a step that its iteration may leave across the line (1/10 to 1/100 in Hairer and Wanner
/// 1996, sec. IV.8; where convergence is foretold, Newton's factor of safety leaves less).
const LEFT_BY_ITERATION: f64 = 0.1;

/// Errors allowed in one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorLimits {
    /// In the position of any node \[m\].
    pub position: f64,
    /// In the velocity of any node \[m/s\].
    pub velocity: f64,
}

impl GeneralizedAlpha {
    /// For a line of `nodes` nodes. `rho` from 0 to 1; tolerance \[m\] and iterations as in [`Newton`].
    #[must_use]
    pub fn new(nodes: usize, rho: f64, tolerance: f64, max_iterations: usize) -> Self {
        let alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
        let alpha_f = rho / (rho + 1.0);
        let state = State::at_rest(vec![V3::zeros(); nodes]);
        let mut newton = Newton::new(nodes, tolerance, max_iterations);
        newton.stagnation_limit = IDLE;
        Self {
            alpha_m,
            alpha_f,
            beta: 0.25 * (1.0 - alpha_m + alpha_f).powi(2),
            gamma: 0.5 - alpha_m + alpha_f,
            newton,
            end: state.clone(),
            between: state,
            jerk: vec![V3::zeros(); nodes],
            trust: 1.0,
            carried: vec![V3::zeros(); nodes],
            control: None,
        }
    }

    /// The same with errors controlled: a step that exceeds them is refused.
    #[must_use]
    pub fn controlled(self, control: ErrorLimits) -> Self {
        Self {
            control: Some(control),
            ..self
        }
    }

    /// How far a node may be off across the line between the steps \[m\], so that its position and velocity at their end
    /// are off by a small share of what is allowed; no more than along it where no error is controlled.
    fn tolerance_across(&self, factors: &Factors) -> f64 {
        self.control.map_or(0.0, |control| {
            let at_end = control.position.min(control.velocity / factors.damping);
            LEFT_BY_ITERATION * (1.0 - self.alpha_f) * at_end
        })
    }

    /// The same with Newton going on until velocities are known to this as well \[m/s\].
    #[must_use]
    pub fn resolving(mut self, speed: f64) -> Self {
        self.newton.velocity_tolerance = speed;
        self
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

    /// The acceleration of the state, moved to where the one carried stands in a step of h.
    fn carry(&mut self, h: f64, state: &State) {
        let moved = (self.alpha_m - self.alpha_f) * h;
        for ((carried, a), jerk) in self.carried.iter_mut().zip(&state.a).zip(&self.jerk) {
            *carried = a + jerk * moved;
        }
    }

    /// The end state foretold with the acceleration going on as before, and the state between.
    fn predict<S: System + ?Sized>(&mut self, system: &S, t: f64, h: f64, state: &State) {
        let (beta, gamma) = (self.beta, self.gamma);
        for i in system.free() {
            let a0 = self.carried[i];
            let a1 = a0 + self.jerk[i] * (h * self.trust);
            self.end.x[i] = state.x[i] + (state.v[i] + (a0 * (0.5 - beta) + a1 * beta) * h) * h;
            self.end.v[i] = state.v[i] + (a0 * (1.0 - gamma) + a1 * gamma) * h;
            self.end.a[i] = a1;
        }
        system.prescribe(t + h, &mut self.end);
        self.between.memory.copy_from(&state.memory);
        self.end.memory.copy_from(&state.memory);
        let mix = |k: f64, new: &[V3], old: &[V3], out: &mut [V3]| {
            for ((o, n), p) in out.iter_mut().zip(new).zip(old) {
                *o = n * (1.0 - k) + p * k;
            }
        };
        mix(self.alpha_f, &self.end.x, &state.x, &mut self.between.x);
        mix(self.alpha_f, &self.end.v, &state.v, &mut self.between.v);
        mix(
            self.alpha_m,
            &self.end.a,
            &self.carried,
            &mut self.between.a,
        );
    }

    /// The end state from the converged state between.
    fn conclude<S: System + ?Sized>(&mut self, system: &S, h: f64, state: &State) {
        let (m, k) = (1.0 / (1.0 - self.alpha_m), self.alpha_m);
        let (beta, gamma) = (self.beta, self.gamma);
        for i in system.free() {
            let a0 = self.carried[i];
            let a1 = (self.between.a[i] - a0 * k) * m;
            self.end.x[i] = state.x[i] + (state.v[i] + (a0 * (0.5 - beta) + a1 * beta) * h) * h;
            self.end.v[i] = state.v[i] + (a0 * (1.0 - gamma) + a1 * gamma) * h;
            self.end.a[i] = a1;
        }
    }

    /// Estimated error of the step as a share of what is allowed, from the acceleration at its end: by its change
    /// in position, `|beta - 1/6| h² |a1 - a0|` (Zienkiewicz and Xie 1991, doi 10.1002/eqe.4290200907); by what the
    /// predictor missed, which is the second difference, in velocity, `h |a1 - a0 - h j0| / 12`; and by what came up
    /// between the point of balance and the end of the step.
    fn share_of_error<S: System + ?Sized>(&self, system: &S, h: f64, control: &ErrorLimits) -> f64 {
        let by_change = (self.beta - 1.0 / 6.0).abs() * h * h / control.position;
        let by_miss = h / (12.0 * control.velocity);
        let mut share = 0.0_f64;
        for i in system.free() {
            let change = self.end.a[i] - self.carried[i];
            let miss = change - self.jerk[i] * (h * self.trust);
            share = share
                .max(change.norm_squared() * by_change * by_change)
                .max(miss.norm_squared() * by_miss * by_miss);
        }
        // A segment that snaps taut after the point of balance has its energy from nowhere.
        let unseen = if self.alpha_f > 0.0 {
            system.snap_acceleration(&self.between, &self.end) * self.alpha_f * h / control.velocity
        } else {
            0.0
        };
        share.sqrt().max(unseen)
    }

    /// Takes the end state over, its acceleration moved to the end of the step.
    fn accept<S: System + ?Sized>(&mut self, system: &S, t: f64, h: f64, state: &mut State) {
        let moved = (self.alpha_f - self.alpha_m) * h;
        for i in system.free() {
            self.jerk[i] = (self.end.a[i] - self.carried[i]) / h;
            self.end.a[i] += self.jerk[i] * moved;
        }
        self.trust = 1.0;
        system.update_wave_kinematics(t + h, &mut self.end);
        if self.alpha_f > 0.0 {
            system.correct_chord_lengths(self.alpha_f, state, &mut self.end);
        }
        state.copy_from(&self.end);
    }
}

impl Stepper for GeneralizedAlpha {
    fn step<S: System + ?Sized>(
        &mut self,
        system: &S,
        at: TimeStep,
        state: &mut State,
    ) -> Result<f64, StepError> {
        let TimeStep { t, dt, refuse } = at;
        self.carry(dt, state);
        self.predict(system, t, dt, state);
        let factors = self.factors(dt);
        self.newton.transverse_tolerance = self.tolerance_across(&factors);
        let balance = t + (1.0 - self.alpha_f) * dt;
        system.update_wave_kinematics(balance, &mut self.between);
        if let Err(why) = self
            .newton
            .solve(system, balance, &mut self.between, factors)
        {
            self.trust = 0.0;
            return Err(why.into());
        }
        self.conclude(system, dt, state);
        let share = self
            .control
            .map_or(0.0, |control| self.share_of_error(system, dt, &control));
        if refuse && share > 1.0 {
            return Err(StepError::Inaccurate(share));
        }
        self.accept(system, t, dt, state);
        Ok(share)
    }

    fn method_state(&self) -> MethodState {
        MethodState {
            jerk: self.jerk.clone(),
            trust: self.trust,
            rate: self.newton.rate(),
            work_counts: self.work_counts(),
            ..MethodState::default()
        }
    }

    fn restore(&mut self, carried: &MethodState) {
        self.jerk.clone_from(&carried.jerk);
        self.trust = carried.trust;
        self.newton
            .restore(carried.rate, carried.work_counts.iterations);
    }

    fn restart<S: System + ?Sized>(&mut self, system: &S, t: f64, state: &mut State) {
        system.update_wave_kinematics(t, state);
        system.accelerate(t, state);
        self.jerk.fill(V3::zeros());
        self.trust = 1.0;
        self.newton.reset_rate();
    }

    fn work_counts(&self) -> WorkCounts {
        WorkCounts {
            iterations: self.newton.iterations,
            evaluations: 0,
        }
    }
}
