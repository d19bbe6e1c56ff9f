//! The method by which a system is computed in time.

use super::alpha::SystemAlpha;
use super::body_equation::MovingBody;
use super::method_state::MethodState;
use super::moving_system::MovingSystem;
use super::quasi_static::SystemQuasiStatic;
use super::rk4::SystemRk4;
use super::settings::MotionSettings;
use super::system_state::SystemState;
use crate::dynamics::{Integrator, StepError, Stepper, TimeStep, WorkCounts};
use crate::scene::Scene;
use crate::solve::NewtonError;
use crate::system::model::MotionMethod;

/// One of the methods.
#[derive(Debug, Clone)]
pub enum Method {
    /// Generalized-alpha.
    Alpha(SystemAlpha),
    /// Runge-Kutta of order 4.
    Rk4(SystemRk4),
    /// Without inertia.
    QuasiStatic(SystemQuasiStatic),
}

impl Method {
    /// The method of these settings.
    #[must_use]
    pub fn new(settings: &MotionSettings, system: &MovingSystem, state: &SystemState) -> Self {
        if settings.method == MotionMethod::Rk4 {
            return Self::Rk4(SystemRk4::new(system, state));
        }
        if settings.method == MotionMethod::Quasi {
            return Self::QuasiStatic(SystemQuasiStatic::new(
                system,
                state,
                settings.position_tolerance_m,
                settings.max_iterations,
            ));
        }
        let alpha = SystemAlpha::new(
            system,
            state,
            settings.rho_inf,
            settings.position_tolerance_m,
            settings.max_iterations,
        );
        let alpha = match settings.limits(system) {
            Some(limits) => alpha.controlled(limits),
            None => alpha,
        };
        let resolutions = system.scenes.iter().filter_map(Scene::velocity_resolution);
        Self::Alpha(match resolutions.reduce(f64::min) {
            Some(speed) => alpha.resolving(speed),
            None => alpha,
        })
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
        match self {
            Self::Alpha(method) => method.accelerate(system, t, state),
            Self::Rk4(method) => method.accelerate(system, t, state),
            // There are none.
            Self::QuasiStatic(_) => Ok(()),
        }
    }

    /// What it takes to the next step.
    #[must_use]
    pub fn method_state(&self) -> MethodState {
        match self {
            Self::Alpha(method) => method.method_state(),
            Self::Rk4(method) => MethodState {
                evaluations: method.work_counts().evaluations,
                ..MethodState::default()
            },
            Self::QuasiStatic(method) => method.method_state(),
        }
    }

    /// Continues from a state after an accepted step.
    pub fn restore(&mut self, stored: &MethodState, state: &SystemState) {
        match self {
            Self::Alpha(method) => method.restore(stored, state),
            Self::Rk4(method) => method.restore(stored.evaluations),
            Self::QuasiStatic(method) => method.restore(stored, state),
        }
    }

    /// The free bodies with their mass.
    #[must_use]
    pub fn bodies(&self) -> &[MovingBody] {
        match self {
            Self::Alpha(method) => method.bodies(),
            Self::Rk4(method) => method.bodies(),
            Self::QuasiStatic(method) => method.bodies(),
        }
    }
}

impl Integrator for Method {
    fn work_counts(&self) -> WorkCounts {
        match self {
            Self::Alpha(method) => method.work_counts(),
            Self::Rk4(method) => method.work_counts(),
            Self::QuasiStatic(method) => method.work_counts(),
        }
    }
}

impl Stepper<MovingSystem, SystemState> for Method {
    fn step(
        &mut self,
        system: &MovingSystem,
        at: TimeStep,
        state: &mut SystemState,
    ) -> Result<f64, StepError> {
        match self {
            Self::Alpha(method) => method.step(system, at, state),
            Self::Rk4(method) => method.step(system, at, state),
            Self::QuasiStatic(method) => method.step(system, at, state),
        }
    }

    fn restart(&mut self, system: &MovingSystem, t: f64, state: &mut SystemState) {
        match self {
            Self::Alpha(method) => method.restart(system, t, state),
            Self::Rk4(method) => method.restart(system, t, state),
            Self::QuasiStatic(method) => method.restart(system, t, state),
        }
    }

    fn pass_kink(&mut self, system: &MovingSystem, t: f64, state: &mut SystemState) -> bool {
        match self {
            Self::Alpha(method) => method.pass_kink(system, t, state),
            Self::Rk4(method) => method.pass_kink(system, t, state),
            Self::QuasiStatic(method) => method.pass_kink(system, t, state),
        }
    }
}
