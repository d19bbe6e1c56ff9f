//! Damping proportional to mass: its tangent, a closed form by every method, its place in the balance of energy.

use seacable::dynamics::Stepper;
use seacable::numerics::V3;
use seacable::scene::Scene;
use seacable::solve::{Factors, Kinematics, Residual, State};

use crate::{march, rest, tangents};

/// A rope of one segment, which hangs in a vacuum without tension: half of it on a spring.
const SPRING: &str = r#"
    materials.rope.mass_damping_per_s = 0.5
    line = { length_m = 100.0, segments = 1 }
    start = { shape = "straight", elevation_deg = -90.0 }
"#;

/// How far a mass on a spring, let go without tension, is from `exp(-alpha t / 2)` times its undamped swing \[m\].
fn from_closed_form(scene: &Scene, method: impl Stepper<Scene>, step: f64) -> f64 {
    // Half of the rope's 200 kg on EA / l of 1e4 N/m.
    let (omega, alpha) = (10.0_f64, 0.5);
    let sag = 9.80665 / omega.powi(2);
    let damped = (omega.powi(2) - 0.25 * alpha * alpha).sqrt();
    let mut worst = 0.0_f64;
    let mut state = scene.initial_state();
    march::march(method, scene, &mut state, (10.0, step), |t, s| {
        let (sin, cos) = (damped * t).sin_cos();
        let swing = (-0.5 * alpha * t).exp() * (cos + 0.5 * alpha / damped * sin);
        let exact = -100.0 - sag * (1.0 - swing);
        worst = worst.max((s.x[1].z - exact).abs());
    });
    worst
}

#[test]
fn a_mass_on_a_spring_decays_as_its_closed_form() {
    let scene = rest::build(SPRING);
    let out = from_closed_form(&scene, march::rk4(&scene), 2e-3);
    assert!(out < 1e-7, "{out}");
    let alpha = [2e-3, 1e-3].map(|h| from_closed_form(&scene, march::alpha(&scene, 1.0), h));
    assert!(alpha[1] < 1e-4 && alpha[0] > 3.5 * alpha[1], "{alpha:?}");
}

fn damped_line() -> Scene {
    let text = tangents::LINE
        .replace("\"NORMAL\"", "1.2")
        .replace(
            "mass_kg_per_m = 30.0",
            "mass_kg_per_m = 30.0\nmass_damping_per_s = 0.7",
        )
        .replace(
            "mass_kg_per_m = 60.0",
            "mass_kg_per_m = 60.0\nmass_damping_per_s = 3.0",
        );
    seacable::scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap()
}

#[test]
fn the_tangent_is_the_finite_difference() {
    let scene = damped_line();
    let state = tangents::state(&scene, &[0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9], 0.03, 0.4);
    let c = Factors {
        mass: 0.7,
        damping: 1.3,
        stiffness: 1.1,
    };
    let worst = tangents::mismatch(&scene, &state, c);
    assert!(worst < 1e-6, "{worst}");
}

/// Mass, floats and normal added mass count, the payload does not; both solvers have the same force.
#[test]
fn the_force_is_alpha_times_the_mass_of_the_line() {
    let scene = damped_line();
    let plain = {
        let mut scene = damped_line();
        scene.elements.mass_damping = None;
        scene
    };
    let state = tangents::state(&scene, &[0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9], 0.03, 0.4);
    let residual = |scene: &Scene| {
        let mut r = vec![V3::zeros(); scene.nodes()];
        scene.residual(0.0, &state, &mut r);
        r
    };
    let (with, without) = (residual(&scene), residual(&plain));
    let area = |d: f64| std::f64::consts::FRAC_PI_4 * d * d;
    let rho = 1025.0;
    // Halves of segments of 10 m: 30 kg/m of rope, 60 kg/m of wire with its floats on the last 15 of 20 m.
    let rope = 0.7 * 5.0 * (30.0 + rho * area(0.2));
    let floats = 0.5 * 300.0 / 3.0;
    let wire = 3.0 * (5.0 * (60.0 + rho * area(0.1)) + floats);
    let last = 3.0 * (5.0 * (60.0 + rho * area(0.1)) + 2.0 * floats);
    let expected = [rope, 2.0 * rope, 2.0 * rope, rope + wire, wire + last, last];
    for (node, damping) in expected.into_iter().enumerate() {
        let force = with[node] - without[node];
        let exact = state.v[node] * damping;
        assert!(
            (force - exact).norm() <= 1e-9 * (1.0 + exact.norm()),
            "{node}: {force} {exact}"
        );
    }
    let acceleration = |scene: &Scene| -> State {
        let mut state = state.clone();
        seacable::solve::ExplicitRhs::accelerate(scene, 0.0, &mut state);
        state
    };
    let moved = acceleration(&scene);
    let mut r = vec![V3::zeros(); scene.nodes()];
    scene.residual(0.0, &moved, &mut r);
    for r in &r[1..] {
        assert!(r.norm() < 1e-6, "{r}");
    }
}
