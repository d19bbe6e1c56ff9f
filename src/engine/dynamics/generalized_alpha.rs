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
//! [`correct_chord_lengths`](crate::solve::MidstepBalance::correct_chord_lengths) accounts for that in the tensions that are output.

use super::alpha_scheme::{AlphaScheme, ErrorLimits, mix};
use super::{Integrator, MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{BandedEquations, Integrated, Newton, NewtonError, Parted, State};

/// The method and its work arrays, for states X and the equations W of a system; allocates only in [`GeneralizedAlpha::new`].
#[derive(Debug, Clone)]
pub struct GeneralizedAlpha<X = State, W = BandedEquations> {
    scheme: AlphaScheme,
    newton: Newton<W>,
    /// The state at the end of the step.
    end: X,
    /// The state between, at which forces balance.
    between: X,
    /// Rates of the accelerations over the step before, for the predictor, part by part \[m/s³\].
    jerk: Vec<Vec<V3>>,
    /// Weight of the jerk in the predictor: 1, or 0 after a step that could not be solved.
    jerk_weight: f64,
    /// Algorithmic accelerations at the start of the step, shifted to the point that belongs to its length, part by part \[m/s²\].
    a0: Vec<Vec<V3>>,
    limits: Option<ErrorLimits>,
}

/// Iterations without progress after which a step is halved: the half converges where the whole cycles.
const STAGNATION_LIMIT: usize = 6;

impl<X: Parted, W> GeneralizedAlpha<X, W> {
    /// For a system with states of the size of this one. `rho` from 0 to 1; tolerance \[m\] and iterations as in [`Newton`].
    #[must_use]
    pub fn new<S: Integrated<State = X, Work = W>>(
        system: &S,
        state: &X,
        rho: f64,
        tolerance: f64,
        max_iterations: usize,
    ) -> Self {
        let mut newton = Newton::of_equations(system.equations(state), tolerance, max_iterations);
        newton.stagnation_limit = STAGNATION_LIMIT;
        let zeros = zeros(state);
        let mut between = state.clone();
        forget_chord_corrections(&mut between);
        Self {
            scheme: AlphaScheme::new(rho),
            newton,
            end: state.clone(),
            between,
            jerk: zeros.clone(),
            jerk_weight: 1.0,
            a0: zeros,
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

    /// Shifts the accelerations of the state to the point of the algorithmic acceleration in a step of h.
    fn shift_acceleration(&mut self, h: f64, state: &X) {
        let shift = self.scheme.shift(h);
        for ((a0, part), jerk) in self.a0.iter_mut().zip(state.parts()).zip(&self.jerk) {
            for ((a0, a), jerk) in a0.iter_mut().zip(&part.a).zip(jerk) {
                *a0 = a + jerk * shift;
            }
        }
    }

    /// Predicts the end state with the jerk of the step before, and the state between.
    fn predict<S: Integrated<State = X>>(&mut self, system: &S, t: f64, h: f64, state: &X) {
        self.between.copy_history_from(state);
        self.end.copy_history_from(state);
        for ((number, end), start) in self.end.parts_mut().enumerate().zip(state.parts()) {
            let (a0, jerk) = (&self.a0[number], &self.jerk[number]);
            // What is prescribed keeps its place unless it moves.
            end.x.copy_from_slice(&start.x);
            end.v.copy_from_slice(&start.v);
            end.a.copy_from_slice(&start.a);
            for i in system.free(number) {
                let a1 = a0[i] + jerk[i] * (h * self.jerk_weight);
                let at = (&start.x[i], &start.v[i]);
                (end.x[i], end.v[i]) = self.scheme.end(h, at, (&a0[i], &a1));
                end.a[i] = a1;
            }
        }
        system.prescribe(t + h, &mut self.end);
        system.follow(&mut self.end);
        let AlphaScheme {
            alpha_m, alpha_f, ..
        } = self.scheme;
        let parts = self.between.parts_mut().zip(self.end.parts());
        for (((out, end), start), a0) in parts.zip(state.parts()).zip(&self.a0) {
            mix(alpha_f, &end.x, &start.x, &mut out.x);
            mix(alpha_f, &end.v, &start.v, &mut out.v);
            mix(alpha_m, &end.a, a0, &mut out.a);
        }
        system.prescribe_between(alpha_f, state, &self.end, &mut self.between);
        system.follow(&mut self.between);
    }

    /// Computes the end state from the converged state between.
    fn extrapolate_to_end<S: Integrated<State = X>>(&mut self, system: &S, h: f64, state: &X) {
        let parts = self.end.parts_mut().zip(self.between.parts());
        for (number, ((end, between), start)) in parts.zip(state.parts()).enumerate() {
            let a0 = &self.a0[number];
            for i in system.free(number) {
                let a1 = self.scheme.acceleration_at_end(&a0[i], &between.a[i]);
                let at = (&start.x[i], &start.v[i]);
                (end.x[i], end.v[i]) = self.scheme.end(h, at, (&a0[i], &a1));
                end.a[i] = a1;
            }
        }
        system.follow(&mut self.end);
    }

    /// Estimated error of the step, relative to the limits: of the nodes ([`AlphaScheme::squared_error`]), rotations by their arm, and by
    /// what snaps taut or lands after the point of balance.
    fn error_ratio<S: Integrated<State = X>>(
        &self,
        system: &S,
        h: f64,
        limits: &ErrorLimits,
    ) -> f64 {
        let mut ratio = 0.0_f64;
        for (number, end) in self.end.parts().enumerate() {
            let (a0, jerk) = (&self.a0[number], &self.jerk[number]);
            for i in system.free(number) {
                let scale = system.scale(number, i);
                let change = (end.a[i] - a0[i]) * scale;
                let predicted = jerk[i] * (h * self.jerk_weight * scale);
                ratio = ratio.max(self.scheme.squared_error(h, limits, &change, &predicted));
            }
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

    /// Accepts the end state, its accelerations shifted to the end of the step.
    fn accept<S: Integrated<State = X>>(&mut self, system: &S, t: f64, h: f64, state: &mut X) {
        let shift = -self.scheme.shift(h);
        for (number, end) in self.end.parts_mut().enumerate() {
            let (a0, jerk) = (&self.a0[number], &mut self.jerk[number]);
            for i in system.free(number) {
                jerk[i] = (end.a[i] - a0[i]) / h;
                end.a[i] += jerk[i] * shift;
            }
        }
        self.jerk_weight = 1.0;
        system.follow(&mut self.end);
        self.end.swap_kept_waves(&mut self.between);
        let time = self.scheme.alpha_f * h;
        system.extrapolate_wave_kinematics(t + h, time, &self.between, &mut self.end);
        self.end.swap_kept_waves(&mut self.between);
        let alpha_f = self.scheme.alpha_f;
        if alpha_f > 0.0 {
            system.correct_after_balance(alpha_f, state, &self.between, &mut self.end);
        }
        state.copy_from(&self.end);
    }

    /// Forgets what was measured in the steps before.
    fn begin_anew(&mut self) {
        for part in &mut self.jerk {
            part.fill(V3::zeros());
        }
        self.jerk_weight = 1.0;
        self.newton.reset_rate();
    }
}

/// Forces between two steps are those of the chords there.
fn forget_chord_corrections(between: &mut impl Parted) {
    for part in between.parts_mut() {
        part.chord_correction.clear();
    }
}

/// Zeros for every node of a state, part by part.
pub(super) fn zeros(state: &impl Parted) -> Vec<Vec<V3>> {
    let parts = state.parts();
    parts.map(|part| vec![V3::zeros(); part.x.len()]).collect()
}

impl<S: Integrated> Stepper<S> for GeneralizedAlpha<S::State, S::Work> {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut S::State) -> Result<f64, StepError> {
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
        let error = error.max(system.passes(state, &self.end));
        if reject && error > 1.0 {
            return Err(StepError::Inaccurate(error));
        }
        self.accept(system, t, dt, state);
        Ok(error)
    }

    fn accelerate(&mut self, system: &S, t: f64, state: &mut S::State) -> Result<(), NewtonError> {
        system.accelerate(&mut self.newton.equations, t, state)
    }

    /// Where nothing has mass the accelerations are zero, and the next step finds them.
    fn restart(&mut self, system: &S, t: f64, state: &mut S::State) {
        system.update_wave_kinematics(t, state);
        let _ = self.accelerate(system, t, state);
        self.begin_anew();
    }

    /// The acceleration, which is never recomputed from the forces, takes the jump of that by the forces.
    fn pass_kink(&mut self, system: &S, t: f64, state: &mut S::State) -> bool {
        self.end.copy_from(state);
        if !system.pass_kink(t, state) {
            return false;
        }
        self.between.copy_from(state);
        for side in [&mut self.end, &mut self.between] {
            system.update_wave_kinematics(t, side);
            // Where nothing has mass no acceleration jumps.
            let _ = system.accelerate(&mut self.newton.equations, t, side);
        }
        let sides = self.between.parts().zip(self.end.parts());
        for (number, (part, (after, before))) in state.parts_mut().zip(sides).enumerate() {
            for i in system.free(number) {
                part.a[i] += after.a[i] - before.a[i];
            }
        }
        system.follow(state);
        forget_chord_corrections(&mut self.between);
        self.begin_anew();
        true
    }
}

impl<X: Parted, W> Integrator for GeneralizedAlpha<X, W> {
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
