//! Energy: what a line has, gains and loses adds up, and a swing without drag keeps what it has.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use std::path::Path;

use seacable::case;
use seacable::dynamics::Stepper;
use seacable::linalg::V3;
use seacable::scene::{self, Scene};
use seacable::solve::State;

mod lines;
#[path = "lines/march.rs"]
mod march;
#[path = "lines/rest.rs"]
mod rest;

/// Power by which the energy of the added mass grows without a force doing work \[W\]. The added mass of a segment
/// turns with it, `M = m_n I + (m_t - m_n) t t'`; the force by which the water resists is taken as `M a` (Morison),
/// without the term of the turning, so that the kinetic energy `v' M v / 2` grows by `v' (dM/dt) v / 2` besides: some
/// 1e-5 to 1e-4 of what drag takes.
fn turning(scene: &Scene, state: &State) -> f64 {
    let segments = scene.segments.iter().enumerate();
    let power = segments.map(|(i, segment)| {
        let chord = scene.chord(i, state);
        let t = chord.tangent;
        let turn = (chord.opening - t * t.dot(&chord.opening)) * chord.inverse;
        let k = segment.added.tangential - segment.added.normal;
        let half = |v: &V3| k * t.dot(v) * turn.dot(v);
        half(&state.v[i]) + half(&state.v[i + 1])
    });
    power.sum()
}

/// What the books are out by at most, as a share of all that is lost: energy gone, less dissipation summed over the
/// steps by the trapezoidal rule. The other number is the same with the turning left out.
fn out_by(scene: &Scene, method: impl Stepper, state: &mut State, time: (f64, f64)) -> (f64, f64) {
    let before = scene.energy(state);
    let (mut lost, mut turned) = (0.0, 0.0);
    let mut last: Option<(f64, f64, f64)> = None;
    let (mut worst, mut worst_without): (f64, f64) = (0.0, 0.0);
    march::march(method, scene, state, time, |t, s| {
        let now = (t, scene.dissipation(s), turning(scene, s));
        if let Some(last) = last {
            lost += 0.5 * (t - last.0) * (now.1 + last.1);
            turned += 0.5 * (t - last.0) * (now.2 + last.2);
        }
        last = Some(now);
        let gone = before - scene.energy(s);
        worst = worst.max((gone - lost + turned).abs());
        worst_without = worst_without.max((gone - lost).abs());
    });
    (worst / lost, worst_without / lost)
}

/// The trapezoidal rule is what is left: a quarter of it at half the step.
#[test]
fn the_books_of_a_falling_payload_balance() {
    let scene = rest::build(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = { mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0, axial_damping_ratio = 0.1 }
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = 2.0, added_mass_kg = 500.0 }
        start = { shape = "straight", elevation_deg = -30.0 }
        "#,
    );
    let out = [0.004, 0.002, 0.001].map(|h| {
        let mut state = scene.initial_state();
        let (out, without) = out_by(&scene, march::rk4(&scene), &mut state, (30.0, h));
        assert!((1e-4..2e-4).contains(&without), "{without}");
        out
    });
    assert!(out[0] < 1e-6, "{out:?}");
    for pair in out.windows(2) {
        assert!((pair[0] / pair[1] - 4.0).abs() < 0.4, "{out:?}");
    }
}

/// 57 segments, some of them slack at first, drag coefficients that jump: 100 s of it.
#[test]
fn the_books_of_the_manifold_balance() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/pendulous/manifold.toml");
    let scene = scene::build(&case::load(&path).unwrap().case, 1).unwrap();
    let mut state = scene.initial_state();
    let (out, without) = out_by(&scene, march::rk4(&scene), &mut state, (100.0, 0.0035));
    assert!((1e-5..3e-5).contains(&without), "{without}");
    assert!(out < 1e-6, "{out}");
}

/// Energy that a swing of 1000 s without drag loses, as a share of its kinetic energy at first: a bob on five
/// segments, pushed to 10 m/s from rest, which swings it to 18 degrees and pulls the line taut and less taut.
fn lost_in_a_long_swing(scene: &Scene, method: impl Stepper, step: f64) -> f64 {
    let mut state = rest::at_rest(scene);
    for (v, s) in state.v.iter_mut().zip(&scene.arc) {
        v.x = 0.1 * s;
    }
    let kinetic = 0.5 * 1000.0 * 10.0 * 10.0;
    let before = scene.energy(&state);
    march::march(method, scene, &mut state, (1000.0, step), |_, _| ());
    (before - scene.energy(&state)) / kinetic
}

/// Runge-Kutta and rho = 1 keep a swing; a smaller rho loses by its damping of what is fast, which a line's axial and
/// transverse waves are: the more the smaller rho and the longer the step, and never gains.
#[test]
fn an_undamped_swing_keeps_its_energy_or_loses_it_as_known() {
    let scene = rest::build(
        r#"
        line.segments = 5
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }
        "#,
    );
    let explicit = lost_in_a_long_swing(&scene, march::rk4(&scene), 0.02);
    assert!((0.0..1e-4).contains(&explicit), "{explicit}");
    for step in [0.02, 0.05] {
        let lost = |rho| lost_in_a_long_swing(&scene, march::alpha(&scene, rho), step);
        assert!(lost(1.0).abs() < 1e-4, "{}", lost(1.0));
        // Measured at 0.02 s: 7.5e-4, 7.9e-5, 1.8e-6; at 0.05 s: 3.3e-3, 8.7e-4, 2.1e-5.
        let all = [0.0, 0.4, 0.8].map(lost);
        assert!(
            all[0] > 3.0 * all[1] && all[1] > 10.0 * all[2] && all[2] > 1e-6,
            "{all:?}"
        );
        assert!(all[0] < 5e-3 && all[1] < 1.5e-3 && all[2] < 5e-5, "{all:?}");
    }
}
