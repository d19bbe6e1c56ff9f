//! Lines marched through time in steps of one length, for tests that look at every step.

use seacable::dynamics::generalized_alpha::GeneralizedAlpha;
use seacable::dynamics::rk4::Rk4;
use seacable::dynamics::{March, Stepper};
use seacable::scene::Scene;
use seacable::solve::{AcceptedStep, ExplicitRhs, Progressing, State};

/// Marches in steps of `step`, showing every step.
pub(crate) fn march(
    mut method: impl Stepper<Scene>,
    scene: &Scene,
    state: &mut State,
    (duration, step): (f64, f64),
    mut see: impl FnMut(f64, &State),
) {
    scene.accelerate(0.0, state);
    let march = March { duration, step };
    let outcome = march
        .run(&mut method, scene, state, &mut |i: AcceptedStep<'_>| {
            see(i.time, i.state);
            Progressing::Continue
        })
        .unwrap();
    assert_eq!(outcome.rejections, 0);
}

/// Runge-Kutta for this line.
pub(crate) fn rk4(scene: &Scene) -> Rk4 {
    Rk4::new(scene, &scene.initial_state())
}

/// Generalized-alpha for this line, its equations solved to 1e-12 m.
pub(crate) fn alpha(scene: &Scene, rho: f64) -> GeneralizedAlpha {
    GeneralizedAlpha::new(scene, &scene.initial_state(), rho, 1e-12, 30)
}
