//! Generalized-alpha for systems of lines: the scheme of [`AlphaScheme`] on all nodes, with the bordered iteration.

use super::body_equation::MovingBody;
use super::border::accelerate;
use super::method_state::MethodState;
use super::moving_system::MovingSystem;
use super::payout_border::correct_drives;
use super::point_loads::landing_acceleration;
use super::system_newton::SystemNewton;
use super::system_state::SystemState;
use crate::dynamics::alpha_scheme::{AlphaScheme, ErrorLimits, mix};
use crate::dynamics::{Integrator, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{Factors, Marched, NewtonError};

/// The method and its work arrays; allocates in [`SystemAlpha::new`] only.
#[derive(Debug, Clone)]
pub struct SystemAlpha {
    scheme: AlphaScheme,
    newton: SystemNewton,
    end: SystemState,
    between: SystemState,
    /// Rates of the accelerations over the step before, part by part \[m/s³\].
    jerk: Vec<Vec<V3>>,
    jerk_weight: f64,
    /// Accelerations shifted to the point that belongs to the step, part by part \[m/s²\].
    a0: Vec<Vec<V3>>,
    limits: Option<ErrorLimits>,
}

impl SystemAlpha {
    /// What it takes to the next step.
    #[must_use]
    pub fn method_state(&self) -> MethodState {
        MethodState {
            iterations: self.newton.iterations,
            rate: self.newton.rate,
            jerk_weight: self.jerk_weight,
            jerk: self.jerk.clone(),
            ..MethodState::default()
        }
    }

    /// Continues from a state after an accepted step.
    pub fn restore(&mut self, stored: &MethodState, state: &SystemState) {
        self.newton.iterations = stored.iterations;
        self.newton.rate = stored.rate;
        self.jerk_weight = stored.jerk_weight;
        self.jerk.clone_from(&stored.jerk);
        self.end.clone_from(state);
        self.between.clone_from(state);
    }

    /// For a system from a state. `rho` from 0 to 1; Newton's tolerance \[m\] and greatest number of iterations in a step.
    #[must_use]
    pub fn new(
        system: &MovingSystem,
        state: &SystemState,
        rho: f64,
        tolerance: f64,
        max_iterations: usize,
    ) -> Self {
        let zeros: Vec<Vec<V3>> = state
            .parts()
            .map(|part| vec![V3::zeros(); part.x.len()])
            .collect();
        Self {
            scheme: AlphaScheme::new(rho),
            newton: SystemNewton::new(system, state, tolerance, max_iterations),
            end: state.clone(),
            between: state.clone(),
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
    pub fn resolving(self, speed: f64) -> Self {
        Self {
            newton: self.newton.resolving(speed),
            ..self
        }
    }

    /// Accelerations from positions and velocities, by the forces.
    ///
    /// # Errors
    /// Where nothing has mass.
    pub fn accelerate(
        &mut self,
        system: &MovingSystem,
        t: f64,
        state: &mut SystemState,
    ) -> Result<(), NewtonError> {
        accelerate(&mut self.newton.border, system, t, state)
    }

    /// The free bodies with their mass.
    #[must_use]
    pub fn bodies(&self) -> &[MovingBody] {
        self.newton.border.bodies()
    }

    fn shift_acceleration(&mut self, h: f64, state: &SystemState) {
        let shift = self.scheme.shift(h);
        for ((a0, part), jerk) in self.a0.iter_mut().zip(state.parts()).zip(&self.jerk) {
            for ((a0, a), jerk) in a0.iter_mut().zip(&part.a).zip(jerk) {
                *a0 = a + jerk * shift;
            }
        }
    }

    /// Predicts the state at the end with the jerk of the step before, and the state between.
    fn predict(&mut self, system: &MovingSystem, t: f64, h: f64, state: &SystemState) {
        self.between.copy_history_from(state);
        self.end.copy_history_from(state);
        for ((number, end), start) in self.end.parts_mut().enumerate().zip(state.parts()) {
            // What is prescribed keeps its place unless it moves.
            end.x.copy_from_slice(&start.x);
            end.v.copy_from_slice(&start.v);
            end.a.copy_from_slice(&start.a);
            for i in system.free(number) {
                let a0 = self.a0[number][i];
                let a1 = a0 + self.jerk[number][i] * (h * self.jerk_weight);
                let at = (&start.x[i], &start.v[i]);
                (end.x[i], end.v[i]) = self.scheme.end(h, at, (&a0, &a1));
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
        // Accelerations of unknowns are of a time of their own; prescribed ones act at that of the balance.
        let held = 0..system.joints.free.start;
        let (before, after) = (
            &state.joints.a[held.clone()],
            &self.end.joints.a[held.clone()],
        );
        mix(alpha_f, after, before, &mut self.between.joints.a[held]);
        system.follow(&mut self.between);
    }

    /// Newton's iteration on the state between.
    fn solve(&mut self, system: &MovingSystem, t: f64, c: Factors) -> Result<(), NewtonError> {
        let transverse = self
            .limits
            .map_or(0.0, |limits| limits.transverse_tolerance(&self.scheme, &c));
        self.newton
            .solve(system, t, &mut self.between, c, transverse)
    }

    fn extrapolate_to_end(&mut self, system: &MovingSystem, h: f64, state: &SystemState) {
        let parts = self.end.parts_mut().zip(self.between.parts());
        for (number, ((end, between), start)) in parts.zip(state.parts()).enumerate() {
            for i in system.free(number) {
                let a0 = self.a0[number][i];
                let a1 = self.scheme.acceleration_at_end(&a0, &between.a[i]);
                let at = (&start.x[i], &start.v[i]);
                (end.x[i], end.v[i]) = self.scheme.end(h, at, (&a0, &a1));
                end.a[i] = a1;
            }
        }
        system.follow(&mut self.end);
    }

    /// Estimated error of the step relative to the limits, rotations by the arm of their body.
    fn error_ratio(&self, system: &MovingSystem, h: f64, limits: &ErrorLimits) -> f64 {
        let mut ratio = 0.0_f64;
        for (number, end) in self.end.parts().enumerate() {
            let joints = number == system.scenes.len();
            for i in system.free(number) {
                let scale = if joints { system.scale(i) } else { 1.0 };
                let change = (end.a[i] - self.a0[number][i]) * scale;
                let predicted = self.jerk[number][i] * (h * self.jerk_weight * scale);
                ratio = ratio.max(self.scheme.squared_error(h, limits, &change, &predicted));
            }
        }
        let alpha_f = self.scheme.alpha_f;
        let snaps = |line: usize| {
            let (between, end) = (&self.between, &self.end);
            let at = |state| &system.scene(line, state).line;
            at(end).acceleration_by_snaps((at(between), &between.lines[line]), &end.lines[line])
        };
        let snap = (0..system.scenes.len()).map(snaps).fold(0.0, f64::max);
        let jolt = snap.max(self.landing_acceleration(system));
        ratio.sqrt().max(jolt * alpha_f * h / limits.velocity)
    }

    /// The greatest acceleration at which the bed stops a point or body that this step brought onto it unseen \[m/s²\].
    fn landing_acceleration(&self, system: &MovingSystem) -> f64 {
        let landings = system.bearing().map(|(joint, foot)| {
            let places = [&self.between, &self.end].map(|state| foot.place(&state.joints.x[joint]));
            landing_acceleration(&system.network, &foot.point, &places[0], &places[1])
        });
        landings.fold(0.0, f64::max)
    }

    /// Accepts the end state, its accelerations shifted to the end of the step.
    fn accept(&mut self, system: &MovingSystem, t: f64, h: f64, state: &mut SystemState) {
        let shift = -self.scheme.shift(h);
        for (number, end) in self.end.parts_mut().enumerate() {
            for i in system.free(number) {
                self.jerk[number][i] = (end.a[i] - self.a0[number][i]) / h;
                end.a[i] += self.jerk[number][i] * shift;
            }
        }
        self.jerk_weight = 1.0;
        system.follow(&mut self.end);
        self.end.swap_kept_waves(&mut self.between);
        let time = self.scheme.alpha_f * h;
        system.write_wave_kinematics(t + h, Some((time, &self.between)), &mut self.end);
        self.end.swap_kept_waves(&mut self.between);
        let alpha_f = self.scheme.alpha_f;
        if alpha_f > 0.0 {
            for (number, (scene, before)) in system.lines(state).enumerate() {
                let SystemState { lines, paid, .. } = &mut self.end;
                let line = &system.scene_among(number, paid).line;
                line.chord_corrections(alpha_f, (&scene.line, before), &mut lines[number]);
            }
            correct_drives(system, alpha_f, (state, &self.between), &mut self.end);
        }
        state.copy_from(&self.end);
    }
}

impl Stepper<MovingSystem, SystemState> for SystemAlpha {
    fn step(
        &mut self,
        system: &MovingSystem,
        at: TimeStep,
        state: &mut SystemState,
    ) -> Result<f64, StepError> {
        let TimeStep { t, dt, reject } = at;
        self.shift_acceleration(dt, state);
        self.predict(system, t, dt, state);
        let balance = t + (1.0 - self.scheme.alpha_f) * dt;
        system.update_wave_kinematics(balance, &mut self.between);
        if let Err(why) = self.solve(system, balance, self.scheme.factors(dt)) {
            self.jerk_weight = 0.0;
            return Err(why.into());
        }
        self.extrapolate_to_end(system, dt, state);
        let limits = self.limits;
        let error = limits.map_or(0.0, |limits| self.error_ratio(system, dt, &limits));
        let error = error.max(system.passes(state, &self.end));
        if reject && error > 1.0 {
            return Err(StepError::Inaccurate(error));
        }
        self.accept(system, t, dt, state);
        Ok(error)
    }

    /// Where nothing has mass the accelerations are zero, and the next step finds them.
    fn restart(&mut self, system: &MovingSystem, t: f64, state: &mut SystemState) {
        system.update_wave_kinematics(t, state);
        let _ = self.accelerate(system, t, state);
        for part in &mut self.jerk {
            part.fill(V3::zeros());
        }
        self.jerk_weight = 1.0;
        self.newton.rate = None;
    }

    fn pass_kink(&mut self, _: &MovingSystem, _: f64, _: &mut SystemState) -> bool {
        false
    }
}

impl Integrator for SystemAlpha {
    fn work_counts(&self) -> WorkCounts {
        WorkCounts {
            iterations: self.newton.iterations,
            evaluations: 0,
        }
    }
}
