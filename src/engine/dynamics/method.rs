//! The methods of time integration as one.

use super::generalized_alpha::GeneralizedAlpha;
use super::quasi_static::QuasiStatic;
use super::rk4::Rk4;
use super::{Integrator, MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::solve::{BandedEquations, Integrated, NewtonError, Parted, State};

/// One of the methods, for states X and the equations W of a system.
#[derive(Debug, Clone)]
pub enum Method<X = State, W = BandedEquations> {
    /// Generalized-alpha.
    Alpha(GeneralizedAlpha<X, W>),
    /// Runge-Kutta of order 4.
    Rk4(Rk4<X, W>),
    /// Without inertia.
    QuasiStatic(QuasiStatic<X, W>),
}

impl<X: Parted, W: 'static> Method<X, W> {
    fn integrator(&self) -> &dyn Integrator {
        match self {
            Self::Alpha(method) => method,
            Self::Rk4(method) => method,
            Self::QuasiStatic(method) => method,
        }
    }
}

impl<X: Parted, W: 'static> Integrator for Method<X, W> {
    fn work_counts(&self) -> WorkCounts {
        self.integrator().work_counts()
    }

    fn method_state(&self) -> MethodState {
        self.integrator().method_state()
    }

    fn restore(&mut self, saved: &MethodState) {
        match self {
            Self::Alpha(method) => method.restore(saved),
            Self::Rk4(method) => method.restore(saved),
            Self::QuasiStatic(method) => method.restore(saved),
        }
    }
}

impl<S: Integrated> Stepper<S> for Method<S::State, S::Work> {
    fn step(&mut self, system: &S, at: TimeStep, state: &mut S::State) -> Result<f64, StepError> {
        match self {
            Self::Alpha(method) => method.step(system, at, state),
            Self::Rk4(method) => method.step(system, at, state),
            Self::QuasiStatic(method) => method.step(system, at, state),
        }
    }

    fn accelerate(&mut self, system: &S, t: f64, state: &mut S::State) -> Result<(), NewtonError> {
        match self {
            Self::Alpha(method) => method.accelerate(system, t, state),
            Self::Rk4(method) => method.accelerate(system, t, state),
            Self::QuasiStatic(method) => method.accelerate(system, t, state),
        }
    }

    fn restart(&mut self, system: &S, t: f64, state: &mut S::State) {
        match self {
            Self::Alpha(method) => method.restart(system, t, state),
            Self::Rk4(method) => method.restart(system, t, state),
            Self::QuasiStatic(method) => method.restart(system, t, state),
        }
    }

    fn pass_kink(&mut self, system: &S, t: f64, state: &mut S::State) -> bool {
        match self {
            Self::Alpha(method) => method.pass_kink(system, t, state),
            Self::Rk4(method) => method.pass_kink(system, t, state),
            Self::QuasiStatic(method) => method.pass_kink(system, t, state),
        }
    }
}
