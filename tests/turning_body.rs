//! A payload that turns about the end of its line, against closed forms: the two modes of a body on a pendulum, its
//! tilt at rest in a current, its energy, and the same whichever way round it lies.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use std::f64::consts::PI;

use march::{alpha, march, rk4};
use period::Period;
use rest::{at_rest, build};
use seacable::linalg::V3;
use seacable::scene::Scene;
use seacable::solve::State;

mod lines;
#[path = "lines/march.rs"]
mod march;
#[path = "lines/period.rs"]
mod period;
#[path = "lines/rest.rs"]
mod rest;

const G: f64 = 9.80665;

/// A tonne, its centre of gravity 2 m below the end of 10 m of stiff, all but massless line.
const BODY: &str = r#"
    materials.rope = { mass_kg_per_m = 1e-9, ea_n = 1e11 }
    line = { length_m = 10.0, segments = 1 }
    ends.b = { name = "body", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0, rotation = { centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0 } }
    start = { shape = "straight", elevation_deg = -90.0 }
"#;

const LENGTH: f64 = 10.0;
const CENTRE: f64 = 2.0;
const MASS: f64 = 1000.0;
const INERTIA: f64 = 900.0;

/// Line and body at small angles from the vertical in the plane y = 0 \[rad\], stretched by what they carry.
fn inclined(scene: &Scene, line: f64, body: f64) -> State {
    let mut state = scene.initial_state();
    let rod = &scene.segments[1].axial;
    let below = scene.weight[2];
    let lean = |angle: f64, length: f64| V3::new(angle.sin(), 0.0, -angle.cos()) * length;
    state.x[1] = lean(line, LENGTH * (1.0 + MASS * G / 1e11));
    state.x[2] = state.x[1] + lean(body, rod.length * (1.0 + below / rod.ea));
    state
}

/// Squares of the two circular frequencies of a rigid body on a string, and the body's angle by the line's, from
/// `[M L², S L; S L, J] q'' + diag(M L, S) g q = 0`, `S = M c`, `J = I + M c²`: any text on small vibrations. Line and rod
/// are a little longer than at no load.
fn modes(line: f64, rod: f64) -> [(f64, f64); 2] {
    let length = LENGTH * line;
    let first = MASS * CENTRE * rod;
    let second = (INERTIA + MASS * CENTRE * CENTRE) * rod * rod;
    let (a, b, d) = (MASS * length * length, first * length, second);
    let (p, q) = (MASS * G * length, first * G);
    let (two, one, zero) = (a * d - b * b, -(a * q + d * p), p * q);
    let root = (one * one - 4.0 * two * zero).sqrt();
    [-1.0, 1.0].map(|sign| {
        let square = (sign * root - one) / (2.0 * two);
        (square, (p - square * a) / (square * b))
    })
}

/// What a swing of less than 3e-5 rad adds is about a billionth, as is what straight lines between steps misplace. The
/// rod's stretch under the weight is known; to leave it out costs less than a millionth.
#[test]
fn a_body_on_a_string_swings_at_its_two_frequencies() {
    let scene = build(BODY);
    let limit = scene.explicit_limit().0;
    let rod = 1.0 + scene.weight[2] / scene.segments[1].axial.ea;
    let stretched = modes(1.0 + MASS * G / 1e11, rod);
    for ((square, ratio), (rigid, _)) in stretched.into_iter().zip(modes(1.0, 1.0)) {
        let exact = 2.0 * PI / square.sqrt();
        let mut state = inclined(&scene, 3e-6, 3e-6 * ratio);
        let mut period = Period::default();
        let step = (0.8 * limit).min(exact / 5000.0);
        march(
            rk4(&scene),
            &scene,
            &mut state,
            (5.2 * exact, step),
            |t, s| {
                period.see(t, s.x[1].x);
            },
        );
        let off = period.mean() / exact - 1.0;
        assert!(off.abs() < 2e-9, "{exact} s: off by {off}");
        let off = period.mean() * rigid.sqrt() / (2.0 * PI) - 1.0;
        assert!(off.abs() < 1e-6, "{exact} s: off by {off}");
    }
}

/// `tan(tilt) = k U² d / (M g c - B b)`, and the line's own angle `tan = k U² / W`.
#[test]
fn a_body_at_rest_in_a_current_tilts_by_its_balance_of_moments() {
    let scene = build(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        current.speed_m_per_s = 1.5
        materials.rope = { mass_kg_per_m = 1e-6, wet_weight_kg_per_m = 0.0, ea_n = 1e9 }
        line = { length_m = 10.0, segments = 4 }
        ends.b = { name = "body", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, wet_mass_kg = 600.0, drag_area_m2 = 2.0, added_mass_kg = 300.0, rotation = { centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0, centre_of_buoyancy_m = 1.2, centre_of_drag_m = 1.7 } }
        "#,
    );
    let state = at_rest(&scene);
    let push = 0.5 * 1025.0 * 2.0 * 1.5 * 1.5;
    let tilt = (push * 1.7 / (1000.0 * G * 2.0 - 400.0 * G * 1.2)).atan();
    let off = scene.tilt(&state) - tilt;
    assert!(off.abs() < 1e-6, "{} {tilt}", scene.tilt(&state));
    let chord = state.x[4] - state.x[0];
    let line = (chord.x / -chord.z).atan();
    assert!((line - (push / (600.0 * G)).atan()).abs() < 1e-6, "{line}");
    // The end of the line bears the resultant; the rod of the body is no part of the line.
    assert_eq!(scene.tensions(&state).len(), 5);
    let pull = push.hypot(600.0 * G);
    assert!((scene.tension_at(4, &state) / pull - 1.0).abs() < 1e-6);
}

/// Thrown over by 100 degrees, the body tumbles and the line swings.
fn thrown(scene: &Scene) -> State {
    let mut state = inclined(scene, 0.4, 1.75);
    state.v[2].y = 3.0;
    state
}

#[test]
fn a_tumbling_body_keeps_its_energy() {
    let scene = build(BODY);
    let swing = MASS * G * (LENGTH + CENTRE);
    let lost = |method: bool, step: f64| {
        let mut state = thrown(&scene);
        let before = scene.energy(&state);
        if method {
            march(rk4(&scene), &scene, &mut state, (60.0, step), |_, _| ());
        } else {
            march(
                alpha(&scene, 1.0),
                &scene,
                &mut state,
                (60.0, step),
                |_, _| (),
            );
        }
        (before - scene.energy(&state)) / swing
    };
    let explicit = lost(true, 0.4 * scene.explicit_limit().0);
    assert!(explicit.abs() < 1e-6, "{explicit}");
    let average = lost(false, 2e-3);
    assert!(average.abs() < 1e-4, "{average}");
}

/// Energy gone, less what drag took, summed over the steps by the trapezoidal rule.
#[test]
fn the_books_of_a_dragged_body_balance() {
    let scene = build(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = { mass_kg_per_m = 2.0, ea_n = 1e8, drag_normal = 1.2 }
        line = { length_m = 20.0, segments = 3 }
        ends.b = { name = "body", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = [2.0, 2.0, 0.5], added_mass_kg = 300.0, rotation = { centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0, centre_of_drag_m = 2.6, added_inertia_kg_m2 = 150.0, start_tilt_deg = -60.0 } }
        start = { shape = "straight", elevation_deg = -20.0 }
        "#,
    );
    let mut state = scene.initial_state();
    let before = scene.energy(&state);
    let (mut lost, mut worst) = (0.0, 0.0_f64);
    let mut last: Option<(f64, f64)> = None;
    let step = 0.8 * scene.explicit_limit().0;
    march(rk4(&scene), &scene, &mut state, (20.0, step), |t, s| {
        let power = scene.dissipation(s);
        if let Some((t0, before)) = last {
            lost += 0.5 * (t - t0) * (power + before);
        }
        last = Some((t, power));
        worst = worst.max((before - scene.energy(s) - lost).abs());
    });
    assert!(worst < 1e-6 * lost, "{} of {lost}", worst / lost);
}

/// The whole scene turned about the vertical by 37 degrees: the same motion, turned.
#[test]
fn it_does_not_matter_which_way_round_the_scene_lies() {
    let scene = |turn: f64| {
        build(&format!(
            r#"
            environment.water_density_kg_per_m3 = 1025.0
            current = {{ speed_m_per_s = [1.0, 0.3], direction_deg = [{}, {}], depth_m = [0.0, 30.0] }}
            materials.rope = {{ mass_kg_per_m = 2.0, ea_n = 1e7, drag_normal = 1.2 }}
            line = {{ length_m = 20.0, segments = 3 }}
            ends.b = {{ name = "body", kind = "payload" }}
            payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = [2.0, 2.0, 0.5], added_mass_kg = [300.0, 300.0, 500.0], rotation = {{ centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0, start_tilt_deg = 40.0, start_azimuth_deg = {} }} }}
            start = {{ shape = "straight", elevation_deg = -30.0, azimuth_deg = {} }}
            "#,
            20.0 + turn,
            110.0 + turn,
            70.0 + turn,
            turn
        ))
    };
    let end = |turn: f64| {
        let scene = scene(turn);
        let mut state = scene.initial_state();
        march(
            alpha(&scene, 0.4),
            &scene,
            &mut state,
            (8.0, 0.02),
            |_, _| (),
        );
        (scene.place_of_b(&state), scene.tilt(&state))
    };
    let (plain, turned) = (end(0.0), end(37.0));
    let (sin, cos) = 37_f64.to_radians().sin_cos();
    let p = plain.0;
    let expected = V3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z);
    assert!((turned.0 - expected).norm() < 1e-8, "{turned:?} {expected}");
    assert!((turned.1 - plain.1).abs() < 1e-9);
    assert!(plain.1 > 0.01 && p.y.abs() > 0.01, "{plain:?}");
}
