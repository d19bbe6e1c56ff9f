//! The method by which a scene is computed in time: that of its file, in the steps that are chosen for it.

use super::Settings;
use super::settings::error_limits;
use crate::case::{Method, Solver};
use crate::dynamics;
use crate::dynamics::generalized_alpha::GeneralizedAlpha;
use crate::dynamics::quasi_static::QuasiStatic;
use crate::dynamics::rk4::Rk4;
use crate::solve::{Integrated, Parted};

/// The method of a run, from a state. `scale` is the distance \[m\] and the speed \[m/s\] that errors of a step are measured by, `resolution` the
/// speed that a force which depends steeply on it resolves \[m/s\].
pub fn method<S: Integrated>(
    (solver, settings): (&Solver, &Settings),
    (system, state): (&S, &S::State),
    scale: impl FnOnce() -> (f64, f64),
    resolution: Option<f64>,
) -> dynamics::Method<S::State, S::Work>
where
    S::State: Parted,
{
    let tolerance = settings.position_tolerance_m.unwrap_or_default();
    let iterations = solver.max_iterations;
    match solver.method {
        Method::Rk4 => dynamics::Method::Rk4(Rk4::new(system, state)),
        Method::Quasi => {
            dynamics::Method::QuasiStatic(QuasiStatic::new(system, state, tolerance, iterations))
        }
        Method::Alpha | Method::Auto | Method::Static => {
            let rho = solver.rho_inf;
            let mut alpha = GeneralizedAlpha::new(system, state, rho, tolerance, iterations);
            if let Some(tolerance) = settings.step_tolerance {
                alpha = alpha.controlled(error_limits(tolerance, scale()));
            }
            dynamics::Method::Alpha(match resolution {
                Some(speed) => alpha.resolving(speed),
                None => alpha,
            })
        }
    }
}
