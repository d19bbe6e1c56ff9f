//! The method by which a system is computed in time.

use super::border::Border;
use super::motion_plan::MotionPlan;
use super::moving_system::MovingSystem;
use super::system_bounds::scale_of_motion;
use super::system_state::SystemState;
use crate::case::Method;
use crate::dynamics;
use crate::dynamics::generalized_alpha::GeneralizedAlpha;
use crate::dynamics::quasi_static::QuasiStatic;
use crate::dynamics::rk4::Rk4;
use crate::run::settings::error_limits;
use crate::scene::Scene;

/// A method for systems.
pub(super) type SystemMethod = dynamics::Method<SystemState, Border>;

/// The method of a run, from a state.
pub(super) fn method(
    plan: &MotionPlan,
    system: &MovingSystem,
    state: &SystemState,
) -> SystemMethod {
    let MotionPlan {
        solver, settings, ..
    } = plan;
    let tolerance = settings.position_tolerance_m.unwrap_or_default();
    let iterations = solver.max_iterations;
    match solver.method {
        Method::Rk4 => dynamics::Method::Rk4(Rk4::new(system, state)),
        Method::Quasi => {
            dynamics::Method::QuasiStatic(QuasiStatic::new(system, state, tolerance, iterations))
        }
        _ => {
            let rho = solver.rho_inf;
            let alpha = GeneralizedAlpha::new(system, state, rho, tolerance, iterations);
            let alpha = match settings.step_tolerance {
                Some(tolerance) => {
                    alpha.controlled(error_limits(tolerance, scale_of_motion(system)))
                }
                None => alpha,
            };
            let resolutions = system.scenes.iter().filter_map(Scene::velocity_resolution);
            dynamics::Method::Alpha(match resolutions.reduce(f64::min) {
                Some(speed) => alpha.resolving(speed),
                None => alpha,
            })
        }
    }
}
