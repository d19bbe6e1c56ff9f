//! Classical Runge-Kutta of order 4 for systems of lines: the independent reference of generalized-alpha.
//!
//! Accelerations come from the bordered solution with the masses alone. A rotation vector v from the base of its body changes by
//! `v' = J(v)^-1 w` with the angular velocity w along the axes of the body and
//!
//! ```text
//! J(v)^-1 = I + [v]/2 + (1/a² - (1 + cos a)/(2 a sin a)) [v]²,   a = |v|
//! ```
//!
//! (Müller 2021, doi 10.1007/s00707-021-03036-1), so that its order is that of the method.

use super::body_equation::MovingBody;
use super::border::{Border, accelerate};
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::dynamics::{Integrator, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{Marched, NewtonError, State};

/// The method and its work arrays; allocates in [`SystemRk4::new`] only.
#[derive(Debug, Clone)]
pub struct SystemRk4 {
    border: Border,
    stage: SystemState,
    next: SystemState,
    evaluations: u64,
}

impl SystemRk4 {
    /// For a system from a state.
    #[must_use]
    pub fn new(system: &MovingSystem, state: &SystemState) -> Self {
        Self {
            border: Border::new(system, state),
            stage: state.clone(),
            next: state.clone(),
            evaluations: 0,
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
        accelerate(&mut self.border, system, t, state)
    }

    /// Continues after so many evaluations.
    pub const fn restore(&mut self, evaluations: u64) {
        self.evaluations = evaluations;
    }

    /// The free bodies with their mass.
    #[must_use]
    pub fn bodies(&self) -> &[MovingBody] {
        self.border.bodies()
    }

    /// Accelerations of the stage, whose derivative goes into the next state with this weight.
    fn add_stage(&mut self, system: &MovingSystem, t: f64, weight: f64) -> Result<(), NewtonError> {
        self.evaluations += 1;
        system.prescribe(t, &mut self.stage);
        system.follow(&mut self.stage);
        system.update_wave_kinematics(t, &mut self.stage);
        accelerate(&mut self.border, system, t, &mut self.stage)?;
        system.write_creep_rates(t, &mut self.stage);
        let parts = self.next.parts_mut().zip(self.stage.parts());
        for (number, (next, stage)) in parts.enumerate() {
            for i in system.free(number) {
                next.x[i] += rate(system, number, stage, i) * weight;
                next.v[i] += stage.a[i] * weight;
            }
            next.add_creep(stage, weight);
        }
        Ok(())
    }

    /// Sets the stage to `state + h * derivative of the stage before`.
    fn move_stage(&mut self, system: &MovingSystem, state: &SystemState, h: f64) {
        let parts = self.stage.parts_mut().zip(state.parts());
        for (number, (stage, state)) in parts.enumerate() {
            for i in system.free(number) {
                stage.x[i] = state.x[i] + rate(system, number, stage, i) * h;
                stage.v[i] = state.v[i] + stage.a[i] * h;
            }
            stage.move_creep(state, h);
        }
    }

    /// The first node whose numbers are not finite.
    fn diverged(&self, system: &MovingSystem) -> Option<usize> {
        let finite = |p: &V3| p.iter().all(|c| c.is_finite());
        self.next.parts().enumerate().find_map(|(number, part)| {
            let mut free = system.free(number);
            let node = free.find(|&i| !finite(&part.x[i]) || !finite(&part.v[i]));
            node.map(|node| system.offset(number) + node)
        })
    }

    fn try_step(
        &mut self,
        system: &MovingSystem,
        t: f64,
        dt: f64,
        state: &SystemState,
    ) -> Result<(), NewtonError> {
        self.stage.copy_from(state);
        self.next.copy_from(state);
        let own = self.stage.lines.iter_mut().chain(&mut self.next.lines);
        own.for_each(State::integrate_creep);
        let half = 0.5 * dt;
        self.add_stage(system, t, dt / 6.0)?;
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0)?;
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0)?;
        self.move_stage(system, state, dt);
        self.add_stage(system, t + dt, dt / 6.0)?;
        if let Some(node) = self.diverged(system) {
            return Err(NewtonError::NotFinite { node });
        }
        // The acceleration of the last stage is that at the end of the step to third order: good for output.
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

/// How fast what a free node counts in changes: its velocity, or of a rotation vector what its angular velocity makes of it.
fn rate(system: &MovingSystem, part: usize, state: &State, node: usize) -> V3 {
    let joints = part == system.scenes.len();
    if !joints || !matches!(system.joints.roles[node], Role::Rotation(_)) {
        return state.v[node];
    }
    let (v, w) = (&state.x[node], &state.v[node]);
    let square = v.norm_squared();
    let weight = if square < 1e-6 {
        1.0 / 12.0 + square / 720.0
    } else {
        let a = square.sqrt();
        1.0 / square - (1.0 + a.cos()) / (2.0 * a * a.sin())
    };
    let across = v.cross(w);
    w + across * 0.5 + v.cross(&across) * weight
}

impl Stepper<MovingSystem, SystemState> for SystemRk4 {
    fn step(
        &mut self,
        system: &MovingSystem,
        at: TimeStep,
        state: &mut SystemState,
    ) -> Result<f64, StepError> {
        self.try_step(system, at.t, at.dt, state)?;
        state.copy_from(&self.next);
        Ok(0.0)
    }

    fn restart(&mut self, system: &MovingSystem, t: f64, state: &mut SystemState) {
        system.update_wave_kinematics(t, state);
        let _ = self.accelerate(system, t, state);
    }

    fn pass_kink(&mut self, _: &MovingSystem, _: f64, _: &mut SystemState) -> bool {
        false
    }
}

impl Integrator for SystemRk4 {
    fn work_counts(&self) -> WorkCounts {
        WorkCounts {
            iterations: 0,
            evaluations: self.evaluations,
        }
    }
}
