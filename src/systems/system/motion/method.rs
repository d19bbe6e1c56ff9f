//! The method by which a system is computed in time.

use super::border::Border;
use super::moving_system::MovingSystem;
use super::settings::MotionSettings;
use super::system_state::SystemState;
use crate::case::Method;
use crate::dynamics;
use crate::dynamics::generalized_alpha::GeneralizedAlpha;
use crate::dynamics::quasi_static::QuasiStatic;
use crate::dynamics::rk4::Rk4;
use crate::scene::Scene;

/// A method for systems.
pub(super) type SystemMethod = dynamics::Method<SystemState, Border>;

/// The method of these settings, from a state.
pub(super) fn method(
    settings: &MotionSettings,
    system: &MovingSystem,
    state: &SystemState,
) -> SystemMethod {
    let (tolerance, iterations) = (settings.position_tolerance_m, settings.max_iterations);
    match settings.method {
        Method::Rk4 => dynamics::Method::Rk4(Rk4::new(system, state)),
        Method::Quasi => {
            dynamics::Method::QuasiStatic(QuasiStatic::new(system, state, tolerance, iterations))
        }
        _ => {
            let rho = settings.rho_inf;
            let alpha = GeneralizedAlpha::new(system, state, rho, tolerance, iterations);
            let alpha = match settings.limits(system) {
                Some(limits) => alpha.controlled(limits),
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
