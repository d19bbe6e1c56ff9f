//! The quasi-static march of a system: the method of [`QuasiStatic`](crate::dynamics::quasi_static::QuasiStatic) for lines, points and
//! bodies together, without the inertia of any of them. What a step before displaced is kept, not where it began: rotations count from the
//! pose of the last accepted step.

use super::body_equation::MovingBody;
use super::method_state::MethodState;
use super::moving_system::MovingSystem;
use super::system_newton::SystemNewton;
use super::system_state::SystemState;
use crate::dynamics::quasi_static::{INERTIA, backward_differences};
use crate::dynamics::{Integrator, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{Factors, Hysteresis, Marched, NewtonError};

/// Displacement of a step by the length of its line beyond which it is none: see [`QuasiStatic`](crate::dynamics::quasi_static::QuasiStatic).
const REACH: f64 = 3.0;

/// The method and its work arrays; allocates in [`SystemQuasiStatic::new`] only.
#[derive(Debug, Clone)]
pub struct SystemQuasiStatic {
    newton: SystemNewton,
    trial: SystemState,
    /// Length of the last accepted step \[s\].
    last_step: Option<f64>,
    /// Its displacements, part by part \[m\].
    displaced: Vec<Vec<V3>>,
    /// Whether there are velocities at which drag coefficients are frozen.
    drag_is_frozen: bool,
}

impl SystemQuasiStatic {
    /// For a system from a state, with Newton's tolerance \[m\] and greatest number of iterations in a step.
    #[must_use]
    pub fn new(
        system: &MovingSystem,
        state: &SystemState,
        tolerance: f64,
        max_iterations: usize,
    ) -> Self {
        Self {
            newton: SystemNewton::new(system, state, tolerance, max_iterations),
            trial: state.clone(),
            last_step: None,
            displaced: state
                .parts()
                .map(|part| vec![V3::zeros(); part.x.len()])
                .collect(),
            drag_is_frozen: false,
        }
    }

    /// The free bodies with their mass.
    #[must_use]
    pub fn bodies(&self) -> &[MovingBody] {
        self.newton.border.bodies()
    }

    /// What it takes to the next step.
    #[must_use]
    pub fn method_state(&self) -> MethodState {
        MethodState {
            iterations: self.newton.iterations,
            rate: self.newton.rate,
            last_step: self.last_step,
            displaced: self.displaced.clone(),
            drag_is_frozen: self.drag_is_frozen,
            ..MethodState::default()
        }
    }

    /// Continues from a state after an accepted step.
    pub fn restore(&mut self, stored: &MethodState, state: &SystemState) {
        self.newton.iterations = stored.iterations;
        self.newton.rate = stored.rate;
        self.drag_is_frozen = stored.drag_is_frozen;
        self.trial.clone_from(state);
        // Segments that were parted or joined begin anew.
        let nodes = state.parts().map(|part| part.x.len());
        let is_same = nodes.eq(stored.displaced.iter().map(Vec::len));
        self.last_step = stored.last_step.filter(|_| is_same);
        if is_same {
            self.displaced.clone_from(&stored.displaced);
        }
    }

    /// Predicts the trial state at the velocities of the state before, without inertia.
    fn predict(&mut self, system: &MovingSystem, t: f64, h: f64, state: &SystemState) {
        let (c, d) = backward_differences(self.last_step, h);
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
        self.leave_out_inertia(system);
    }

    /// No acceleration counts, that of driven ends no more than that of free nodes.
    fn leave_out_inertia(&mut self, system: &MovingSystem) {
        for part in self.trial.parts_mut() {
            part.a.fill(V3::zeros());
        }
        system.follow(&mut self.trial);
    }

    /// Newton without inertia; if that fails, with decreasing fractions of it.
    fn converge(
        &mut self,
        system: &MovingSystem,
        t: f64,
        h: f64,
        state: &SystemState,
    ) -> Result<(), NewtonError> {
        let massless = Factors {
            mass: 0.0,
            damping: backward_differences(self.last_step, h).0,
            stiffness: 1.0,
        };
        let Self { newton, trial, .. } = self;
        if newton.solve(system, t + h, trial, massless, 0.0).is_ok() {
            return Ok(());
        }
        self.predict(system, t, h, state);
        self.converge_with_inertia(system, t, h, state, &INERTIA)
    }

    /// Newton with these fractions of inertia, one after the other.
    fn converge_with_inertia(
        &mut self,
        system: &MovingSystem,
        t: f64,
        h: f64,
        state: &SystemState,
        fractions: &[f64],
    ) -> Result<(), NewtonError> {
        let (c, _) = backward_differences(self.last_step, h);
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
            let Self { newton, trial, .. } = self;
            newton.solve(system, t + h, trial, factors, 0.0)?;
        }
        Ok(())
    }

    /// Rejects a root beyond three times the length of its line: without inertia a slack line without axial drag has no velocity of its own,
    /// and the equations have roots at any distance.
    fn check_reach(&self, system: &MovingSystem, state: &SystemState) -> Result<(), NewtonError> {
        for (number, (before, after)) in state.lines.iter().zip(&self.trial.lines).enumerate() {
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

    fn freeze_drag_coefficients(system: &MovingSystem, state: &mut SystemState) {
        let SystemState { lines, paid, .. } = state;
        for (number, line) in lines.iter_mut().enumerate() {
            system
                .scene_among(number, paid)
                .freeze_drag_coefficients(line);
        }
    }
}

impl Stepper<MovingSystem, SystemState> for SystemQuasiStatic {
    fn step(
        &mut self,
        system: &MovingSystem,
        at: TimeStep,
        state: &mut SystemState,
    ) -> Result<f64, StepError> {
        let TimeStep { t, dt, reject } = at;
        if !self.drag_is_frozen {
            // Lines at rest have no velocities for their drag coefficients: take those after one step with inertia.
            self.predict(system, t, dt, state);
            self.converge_with_inertia(system, t, dt, state, &INERTIA[..1])?;
            Self::freeze_drag_coefficients(system, &mut self.trial);
            for (line, trial) in state.lines.iter_mut().zip(&self.trial.lines) {
                line.memory.copy_from(&trial.memory);
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
        let parts = self.trial.parts().zip(state.parts());
        for ((trial, start), displaced) in parts.zip(&mut self.displaced) {
            for (displaced, (now, before)) in displaced.iter_mut().zip(trial.x.iter().zip(&start.x))
            {
                *displaced = now - before;
            }
        }
        self.last_step = Some(dt);
        state.copy_from(&self.trial);
        Self::freeze_drag_coefficients(system, state);
        Ok(passed)
    }

    fn restart(&mut self, _: &MovingSystem, _: f64, _: &mut SystemState) {
        self.last_step = None;
        self.newton.rate = None;
    }

    /// Velocities are by backward differences: none of them reaches across a jump.
    fn pass_kink(&mut self, system: &MovingSystem, t: f64, state: &mut SystemState) -> bool {
        self.restart(system, t, state);
        true
    }
}

impl Integrator for SystemQuasiStatic {
    fn work_counts(&self) -> WorkCounts {
        WorkCounts {
            iterations: self.newton.iterations,
            evaluations: 0,
        }
    }
}
