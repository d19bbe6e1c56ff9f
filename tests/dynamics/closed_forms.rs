//! Falling, hanging and swinging lines that are known in closed form. Every tolerance is a stated error of the
//! discretisation or of the closed form's assumptions, not a share that happened to pass.
//!
//! Sources: any text on mechanics. Vibrations and snaps are in `waves.rs`.

use std::f64::consts::PI;

use crate::march::{alpha, march, rk4};
use crate::period::Period;
use crate::rest::{at_rest, build};
use seacable::dynamics::Stepper;
use seacable::numerics::V3;
use seacable::scene::Scene;
use seacable::solve::State;

const G: f64 = 9.80665;

/// `z = -v²/g' ln cosh(g' t / v)`, `v = sqrt(W / k)`, `g' = W / M`: M and k of payload and line together.
#[test]
fn a_dragged_payload_falls_by_the_hyperbolic_tangent() {
    let scene = build(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = { wet_weight_kg_per_m = 0.0, drag_tangential = 0.05, ea_n = 1e8, axial_damping_ratio = 0.1 }
        line = { length_m = 50.0, segments = 5 }
        ends.a.kind = "free"
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, wet_mass_kg = 600.0, drag_area_m2 = 2.0, added_mass_kg = 500.0 }
        start = { shape = "straight", elevation_deg = -90.0 }
        "#,
    );
    let (mass, weight) = (1000.0 + 500.0 + 2.0 * 50.0, 600.0 * G);
    let of_line = 0.5 * 1025.0 * 0.05 * 0.1 * 50.0;
    let k = 0.5 * 1025.0 * 2.0 + of_line;
    let (terminal, g) = ((weight / k).sqrt(), weight / mass);
    // The closed form takes the line as rigid. It is pulled by its inertia at first and its drag at last, and
    // stretches by no more than twice that, suddenly applied; the payload cannot be off by more.
    let pull = 2.0 * 50.0 * g + of_line * terminal * terminal;
    let stretch = 2.0 * pull * 50.0 / 1e8;
    let mut worst = 0.0_f64;
    let mut state = scene.initial_state();
    march(rk4(&scene), &scene, &mut state, (10.0, 7e-4), |t, state| {
        let fall = terminal * terminal / g * (g * t / terminal).cosh().ln();
        worst = worst.max((state.x[5].z + 50.0 + fall).abs());
    });
    assert!(worst < stretch, "{worst} m off, the line gives {stretch} m");
    // tanh(g' t / v) is 1 to 1e-13 at the end; the wetted length grows by the strain, and v with its root.
    let strain = pull / 1e8;
    let speed = -state.v[5].z;
    assert!(
        (speed / terminal - 1.0).abs() < strain * of_line / k,
        "{speed} {terminal}"
    );
}

/// `z(s) = -(s + (W s + w (L s - s²/2)) / EA)`, T(0) = W + w L. The tension of a lumped segment is that of the
/// line at its middle, and the midpoint rule is exact for a linear tension: no mesh error at the nodes.
#[test]
fn a_hanging_line_stretches_exactly() {
    for segments in [1, 2, 7, 40] {
        let scene = build(&format!(
            r#"
            line.segments = {segments}
            ends.b = {{ name = "bob", kind = "payload" }}
            payload = {{ dry_mass_kg = 500.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}
            "#
        ));
        let state = at_rest(&scene);
        let (end, w, ea, length) = (500.0 * G, 2.0 * G, 1e6, 100.0);
        // A residual force of 1e-8 of the gross weight may be left at each node and stretches what is above.
        let left = 1e-8 * (end + w * length) * segments as f64;
        for (x, s) in state.x.iter().zip(&scene.line.arc) {
            let z = -(s + (end * s + w * (length * s - 0.5 * s * s)) / ea);
            assert!(
                (x.z - z).abs() <= left * s / ea + 1e-13 * length,
                "{segments}: {} {z}",
                x.z
            );
            assert_eq!((x.x, x.y), (0.0, 0.0));
        }
        for (node, s) in scene.line.arc.iter().enumerate() {
            let tension = end + w * (length - s);
            let off = (scene.tension_at(node, &state) - tension).abs();
            assert!(
                off <= left,
                "{segments}: tension at node {node} off by {off} N"
            );
        }
    }
}

/// Exact period of a pendulum, `2 pi sqrt(L/g) / agm(1, cos(theta/2))`: 1 + theta²/16 + 11 theta⁴/3072 + ...
fn pendulum_period(length: f64, amplitude: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    2.0 * PI * (length / G).sqrt() / a
}

const PENDULUM: &str = r#"
    materials.rope = { mass_kg_per_m = 0.01, ea_n = 1e10 }
    line = { length_m = 100.0, segments = 1 }
    ends.b = { name = "bob", kind = "payload" }
    payload = { dry_mass_kg = 1e4, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }
    start.shape = "straight"
"#;

fn pendulum(method: impl Stepper<Scene>, scene: &Scene, periods: f64, step: f64) -> f64 {
    let mut state = scene.initial_state();
    // Stretched to carry its load at once: no bounce to begin with.
    let along = -state.x[1].z / state.x[1].norm();
    state.x[1] *= 1.0 + along * 1e4 * G / 1e10;
    let mut period = Period::default();
    march(method, scene, &mut state, (20.1 * periods, step), |t, s| {
        period.see(t, s.x[1].x);
    });
    period.mean()
}

#[test]
fn a_pendulum_keeps_its_period_at_any_amplitude() {
    for degrees in [2.0_f64, 20.0, 60.0, 90.0] {
        let scene = build(&format!(
            "{PENDULUM}\nstart.elevation_deg = {}",
            degrees - 90.0
        ));
        // One segment, half of it at the bob: a point mass. Its greatest load, (3 - 2 cos) m g, stretches the line
        // by e; the length enters by its root, the stretch as it changes along the swing by as much again.
        let e = (3.0 - 2.0 * degrees.to_radians().cos()) * 1e4 * G / 1e10;
        let off = pendulum(rk4(&scene), &scene, 5.0, 0.01)
            / pendulum_period(100.0, degrees.to_radians())
            - 1.0;
        // Straight lines between steps place a crossing to h (omega h)², a billionth of a period here.
        assert!(
            (-1e-8..e).contains(&off),
            "{degrees} deg: off by {off}, e = {e}"
        );
    }
}

/// Newmark's average acceleration, to which rho = 1 is close, prolongs a period by `(omega h)² / 12`, in
/// which terms of the fourth power and of the amplitude squared, each 1e-3 of it, are left out.
#[test]
fn generalized_alpha_prolongs_a_period_by_its_known_error() {
    let scene = build(&format!("{PENDULUM}\nstart.elevation_deg = -88.0"));
    let exact = pendulum_period(100.0, 2_f64.to_radians());
    let omega = 2.0 * PI / exact;
    for h in [0.2, 0.4] {
        let off = pendulum(alpha(&scene, 1.0), &scene, 10.0, h) / exact - 1.0;
        let known = (omega * h).powi(2) / 12.0;
        assert!(
            (off / known - 1.0).abs() < 0.05,
            "h = {h}: {off} against {known}"
        );
    }
}

/// Centre of mass at -g t²/2, tensions zero: every method here is exact for a constant acceleration.
#[test]
fn a_line_that_nothing_holds_falls_without_tension() {
    let scene = build(
        r#"
        ends.a.kind = "free"
        start = { shape = "straight", azimuth_deg = 30.0, elevation_deg = -20.0 }
        "#,
    );
    let total: f64 = scene.line.mass.iter().sum();
    let centre = |state: &State| {
        let moments = scene.line.mass.iter().zip(&state.x).map(|(m, x)| x * *m);
        moments.sum::<V3>() / total
    };
    let from = centre(&scene.initial_state());
    let (duration, h) = (5.0, 0.005);
    let mut check = |t: f64, state: &State| {
        // Each of the steps so far may round every node at its greatest distance, 240 m.
        let rounding = (t / h + 1.0) * 240.0 * f64::EPSILON;
        let off = (centre(state) - from + V3::z() * (0.5 * G * t * t)).norm();
        assert!(off <= 2.0 * rounding, "t = {t}: {off} m");
        for i in 0..scene.line.segments.len() {
            let tension = scene.line.segments[i]
                .axial
                .tension(&scene.line.chord(i, state))
                .value;
            let limit = 4.0 * rounding * 1e6 / 10.0;
            assert!(
                tension <= limit,
                "t = {t}, segment {i}: {tension} N, rounding gives {limit} N"
            );
        }
    };
    march(
        rk4(&scene),
        &scene,
        &mut scene.initial_state(),
        (duration, h),
        &mut check,
    );
    march(
        alpha(&scene, 0.4),
        &scene,
        &mut scene.initial_state(),
        (duration, h),
        &mut check,
    );
}
