//! The method by which a system is computed in time.

use super::border::Border;
use super::moving_system::MovingSystem;
use super::settings::MotionSettings;
use super::system_state::SystemState;
use crate::dynamics::Method;
use crate::dynamics::generalized_alpha::GeneralizedAlpha;
use crate::dynamics::quasi_static::QuasiStatic;
use crate::dynamics::rk4::Rk4;
use crate::scene::Scene;
use crate::system::model::MotionMethod;

/// A method for systems.
pub(super) type SystemMethod = Method<SystemState, Border>;

/// The method of these settings, from a state.
pub(super) fn method(
    settings: &MotionSettings,
    system: &MovingSystem,
    state: &SystemState,
) -> SystemMethod {
    let (tolerance, iterations) = (settings.position_tolerance_m, settings.max_iterations);
    match settings.method {
        MotionMethod::Rk4 => Method::Rk4(Rk4::new(system, state)),
        MotionMethod::Quasi => {
            Method::QuasiStatic(QuasiStatic::new(system, state, tolerance, iterations))
        }
        _ => {
            let rho = settings.rho_inf;
            let alpha = GeneralizedAlpha::new(system, state, rho, tolerance, iterations);
            let alpha = match settings.limits(system) {
                Some(limits) => alpha.controlled(limits),
                None => alpha,
            };
            let resolutions = system.scenes.iter().filter_map(Scene::velocity_resolution);
            Method::Alpha(match resolutions.reduce(f64::min) {
                Some(speed) => alpha.resolving(speed),
                None => alpha,
            })
        }
    }
}
