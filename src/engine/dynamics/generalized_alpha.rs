//! Implicit generalized-alpha (Chung and Hulbert 1993, doi 10.1115/1.2900803), with the exact tangent.
//!
//! Second order, unconditionally stable on linear problems; the numerical damping of high frequencies is set by the
//! spectral radius rho at infinite frequency:
//!
//! ```text
//! alpha_m = (2 rho - 1)/(rho + 1)   alpha_f = rho/(rho + 1)
//! gamma = 1/2 - alpha_m + alpha_f   beta = (1 - alpha_m + alpha_f)²/4
//! x1 = x0 + h v0 + h² ((1/2 - beta) a0 + beta a1)      v1 = v0 + h ((1 - gamma) a0 + gamma a1)
//! M(x) a = f(t, x, v)  at  x = (1 - alpha_f) x1 + alpha_f x0, v and t likewise,
//!                          a = (1 - alpha_m) a1 + alpha_m a0
//! ```
//!
//! rho = 1 is close to Newmark's average acceleration, rho = 0 damps most. Forces are evaluated at the point between the
//! steps, so that Newton iterates on one state there. The algorithmic acceleration is carried from step to step and never
//! recomputed from the forces. It approximates the acceleration at `t + (alpha_m - alpha_f) h`, before the end of its step:
//! at the end it is shifted to t for output, and at the next step back to the point that belongs to the length of that
//! step. Without the shift the method, or each change of the step, would be of first order.
//!
//! The balance holds at a mix of positions, where the chord of a rotating segment is shorter than before and after the step:
//! [`MidstepBalance::correct_chord_lengths`] accounts for that in the tensions that are output.

use std::mem::swap;

use super::alpha_scheme::{AlphaScheme, ErrorLimits, mix};
use super::{Integrator, MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{ExplicitRhs, Kinematics, MidstepBalance, Newton, Residual, State};

/// The method and its work arrays; allocates only in [`GeneralizedAlpha::new`].
#[derive(Debug, Clone)]
pub struct GeneralizedAlpha {
    scheme: AlphaScheme,
    newton: Newton,
    /// The state at the end of the step.
    end: State,
    /// The state between, at which forces balance.
    between: State,
    /// Rate of the acceleration over the step before, for the predictor \[m/s³\].
    jerk: Vec<V3>,
    /// Weight of the jerk in the predictor: 1, or 0 after a step that could not be solved.
    jerk_weight: f64,
    /// Algorithmic acceleration at the start of the step, shifted to the point that belongs to its length \[m/s²\].
    a0: Vec<V3>,
    limits: Option<ErrorLimits>,
}

/// Iterations without progress after which a step is halved: the half converges where the whole cycles.
const STAGNATION_LIMIT: usize = 6;

impl GeneralizedAlpha {
    /// For a system of `nodes` nodes. `rho` from 0 to 1; tolerance \[m\] and iterations as in [`Newton`].
    #[must_use]
    pub fn new(nodes: usize, rho: f64, tolerance: f64, max_iterations: usize) -> Self {
        let state = State::at_rest(vec![V3::zeros(); nodes]);
        let mut newton = Newton::new(nodes, tolerance, max_iterations);
        newton.stagnation_limit = STAGNATION_LIMIT;
        Self {
            scheme: AlphaScheme::new(rho),
            newton,
            end: state.clone(),
            between: state,
            jerk: vec![V3::zeros(); nodes],
            jerk_weight: 1.0,
            a0: vec![V3::zeros(); nodes],
            limits: None,
        }
    }

    /// The same with error control: a step that exceeds the limits is rejected.
    #[must_use]
    pub fn controlled(self, limits: ErrorLimits) -> Self {
        Self {
            limits: Some(limits),
            ..self
        }
    }

    /// The same with a tolerance on the velocities in Newton's iteration \[m/s\].
    #[must_use]
    pub fn resolving(mut self, speed: f64) -> Self {
        self.newton.velocity_tolerance = speed;
        self
    }

    /// Shifts the acceleration of the state to the point of the algorithmic acceleration in a step of h.
    fn shift_acceleration(&mut self, h: f64, state: &State) {
        let shift = self.scheme.shift(h);
        for ((a0, a), jerk) in self.a0.iter_mut().zip(&state.a).zip(&self.jerk) {
            *a0 = a + jerk * shift;
        }
    }

    /// Predicts the end state with the jerk of the step before, and the state between.
    fn predict<S: Kinematics>(&mut self, system: &S, t: f64, h: f64, state: &State) {
        for i in system.free() {
            let a0 = self.a0[i];
            let a1 = a0 + self.jerk[i] * (h * self.jerk_weight);
            let start = (&state.x[i], &state.v[i]);
            (self.end.x[i], self.end.v[i]) = self.scheme.end(h, start, (&a0, &a1));
            self.end.a[i] = a1;
        }
        self.between.memory.copy_from(&state.memory);
        self.end.memory.copy_from(&state.memory);
        system.prescribe(t + h, &mut self.end);
        let AlphaScheme {
            alpha_m, alpha_f, ..
        } = self.scheme;
        mix(alpha_f, &self.end.x, &state.x, &mut self.between.x);
        mix(alpha_f, &self.end.v, &state.v, &mut self.between.v);
        mix(alpha_m, &self.end.a, &self.a0, &mut self.between.a);
    }

    /// Computes the end state from the converged state between.
    fn extrapolate_to_end<S: Kinematics>(&mut self, system: &S, h: f64, state: &State) {
        for i in system.free() {
            let a0 = self.a0[i];
            let a1 = self.scheme.acceleration_at_end(&a0, &self.between.a[i]);
            let start = (&state.x[i], &state.v[i]);
            (self.end.x[i], self.end.v[i]) = self.scheme.end(h, start, (&a0, &a1));
            self.end.a[i] = a1;
        }
    }

    /// Estimated error of the step, relative to the limits: of the nodes ([`AlphaScheme::squared_error`]), and by segments that
    /// snap taut after the point of balance.
    fn error_ratio<S: MidstepBalance>(&self, system: &S, h: f64, limits: &ErrorLimits) -> f64 {
        let mut ratio = 0.0_f64;
        for i in system.free() {
            let change = self.end.a[i] - self.a0[i];
            let predicted = self.jerk[i] * (h * self.jerk_weight);
            ratio = ratio.max(self.scheme.squared_error(h, limits, &change, &predicted));
        }
        // The balance has not seen the energy of a segment that snaps taut after it.
        let alpha_f = self.scheme.alpha_f;
        let by_snap = if alpha_f > 0.0 {
            system.snap_acceleration(&self.between, &self.end) * alpha_f * h / limits.velocity
        } else {
            0.0
        };
        ratio.sqrt().max(by_snap)
    }

    /// Accepts the end state, its acceleration shifted to the end of the step.
    fn accept<S: MidstepBalance>(&mut self, system: &S, t: f64, h: f64, state: &mut State) {
        let shift = -self.scheme.shift(h);
        for i in system.free() {
            self.jerk[i] = (self.end.a[i] - self.a0[i]) / h;
            self.end.a[i] += self.jerk[i] * shift;
        }
        self.jerk_weight = 1.0;
        swap(&mut self.end.kept_waves, &mut self.between.kept_waves);
        let time = self.scheme.alpha_f * h;
        system.extrapolate_wave_kinematics(t + h, time, &self.between, &mut self.end);
        swap(&mut self.end.kept_waves, &mut self.between.kept_waves);
        if self.scheme.alpha_f > 0.0 {
            system.correct_chord_lengths(self.scheme.alpha_f, state, &mut self.end);
        }
        state.copy_from(&self.end);
    }
}

impl<S: Residual + MidstepBalance + ExplicitRhs> Stepper<S> for GeneralizedAlpha {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut State) -> Result<f64, StepError> {
        let TimeStep { t, dt, reject } = at;
        self.shift_acceleration(dt, state);
        self.predict(system, t, dt, state);
        let factors = self.scheme.factors(dt);
        self.newton.transverse_tolerance = self.limits.map_or(0.0, |limits| {
            limits.transverse_tolerance(&self.scheme, &factors)
        });
        let balance = t + (1.0 - self.scheme.alpha_f) * dt;
        system.update_wave_kinematics(balance, &mut self.between);
        let solved = self
            .newton
            .solve(system, balance, &mut self.between, factors);
        if let Err(why) = solved {
            self.jerk_weight = 0.0;
            return Err(why.into());
        }
        self.extrapolate_to_end(system, dt, state);
        let error = self
            .limits
            .map_or(0.0, |limits| self.error_ratio(system, dt, &limits));
        if reject && error > 1.0 {
            return Err(StepError::Inaccurate(error));
        }
        self.accept(system, t, dt, state);
        Ok(error)
    }

    fn restart(&mut self, system: &S, t: f64, state: &mut State) {
        system.update_wave_kinematics(t, state);
        system.accelerate(t, state);
        self.jerk.fill(V3::zeros());
        self.jerk_weight = 1.0;
        self.newton.reset_rate();
    }

    /// The acceleration, which is never recomputed from the forces, takes the jump of that by the forces.
    fn pass_kink(&mut self, system: &S, t: f64, state: &mut State) -> bool {
        self.end.copy_from(state);
        if !system.pass_kink(t, state) {
            return false;
        }
        self.between.copy_from(state);
        for side in [&mut self.end, &mut self.between] {
            system.update_wave_kinematics(t, side);
            system.accelerate(t, side);
        }
        for i in system.free() {
            state.a[i] += self.between.a[i] - self.end.a[i];
        }
        // Forces between two steps are those of the chords there.
        self.between.chord_correction.clear();
        self.jerk.fill(V3::zeros());
        self.jerk_weight = 1.0;
        self.newton.reset_rate();
        true
    }
}

impl Integrator for GeneralizedAlpha {
    fn method_state(&self) -> MethodState {
        MethodState {
            jerk: self.jerk.clone(),
            jerk_weight: self.jerk_weight,
            rate: self.newton.rate(),
            work_counts: self.work_counts(),
            ..MethodState::default()
        }
    }

    fn restore(&mut self, saved: &MethodState) {
        self.jerk.clone_from(&saved.jerk);
        self.jerk_weight = saved.jerk_weight;
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
