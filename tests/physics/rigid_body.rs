//! A payload that turns about the end of its line, against closed forms: the two modes of a body on a pendulum in air and
//! in water and how drag damps them, its tilt at rest in a current, its energy, its precession while it spins, and the same
//! whichever way round it lies.

use std::f64::consts::PI;

use crate::march::{alpha, march, rk4};
use crate::period::Period;
use crate::rest::{at_rest, build};
use seacable::numerics::V3;
use seacable::scene::Scene;
use seacable::solve::State;

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
    let rod = &scene.line.segments[1].axial;
    let (hung, below) = (
        scene.line.weight[1] + scene.line.weight[2],
        scene.line.weight[2],
    );
    let lean = |angle: f64, length: f64| V3::new(angle.sin(), 0.0, -angle.cos()) * length;
    state.x[1] = lean(line, LENGTH * (1.0 + hung / 1e11));
    state.x[2] = state.x[1] + lean(body, rod.length * (1.0 + below / rod.ea));
    state
}

/// Mass, first and second moment about the hang point of what moves, and weight and its moment [N, N m].
struct Moments {
    mass: f64,
    first: f64,
    second: f64,
    weight: f64,
    righting: f64,
}

/// Squares of the two circular frequencies of a rigid body on a string, and the body's angle by the line's, from
/// `[M L², S L; S L, J] q'' + diag(W L, w) q = 0`: any text on small vibrations.
fn modes_of(length: f64, of: &Moments) -> [(f64, f64); 2] {
    let (a, b, d) = (of.mass * length * length, of.first * length, of.second);
    let (p, q) = (of.weight * length, of.righting);
    let (two, one, zero) = (a * d - b * b, -(a * q + d * p), p * q);
    let root = (one * one - 4.0 * two * zero).sqrt();
    [-1.0, 1.0].map(|sign| {
        let square = (sign * root - one) / (2.0 * two);
        (square, (p - square * a) / (square * b))
    })
}

/// The same of the body in air, `S = M c`, `J = I + M c²`. Line and rod are a little longer than at no load.
fn modes(line: f64, rod: f64) -> [(f64, f64); 2] {
    let first = MASS * CENTRE * rod;
    let in_air = Moments {
        mass: MASS,
        first,
        second: (INERTIA + MASS * CENTRE * CENTRE) * rod * rod,
        weight: MASS * G,
        righting: first * G,
    };
    modes_of(LENGTH * line, &in_air)
}

/// What a swing of less than 3e-5 rad adds is about a billionth, as is what straight lines between steps misplace. The
/// rod's stretch under the weight is known; to leave it out costs less than a millionth.
#[test]
fn a_body_on_a_string_swings_at_its_two_frequencies() {
    let scene = build(BODY);
    let limit = scene.explicit_limit().0;
    let rod = 1.0 + scene.line.weight[2] / scene.line.segments[1].axial.ea;
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

/// In water: 400 kg of buoyancy 1.2 m below the hang point, where 300 kg of water go along across the axis, more or less
/// along it, with a moment of inertia of their own.
const IN_WATER: &str = r#"
    environment.water_density_kg_per_m3 = 1000.0
    materials.rope = { diameter_m = 1e-6, mass_kg_per_m = 1e-9, ea_n = 1e11 }
    line = { length_m = 10.0, segments = 1 }
    ends.b = { name = "body", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, wet_mass_kg = 600.0, drag_area_m2 = 0.0, added_mass_kg = [300.0, 300.0, 120.0], rotation = { centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0, centre_of_buoyancy_m = 1.2, added_inertia_kg_m2 = 250.0 } }
    start = { shape = "straight", elevation_deg = -90.0 }
"#;

fn water_moments() -> Moments {
    Moments {
        mass: MASS + 300.0,
        first: MASS * CENTRE + 300.0 * 1.2,
        second: INERTIA + MASS * CENTRE * CENTRE + 250.0 + 300.0 * 1.2 * 1.2,
        weight: 600.0 * G,
        righting: (MASS * CENTRE - 400.0 * 1.2) * G,
    }
}

/// Added mass counts at its own centre, with its own moment of inertia. The rod's stretch, a millionth, is left out.
#[test]
fn in_water_it_swings_slower_by_the_water_that_goes_along() {
    let scene = build(IN_WATER);
    let limit = scene.explicit_limit().0;
    for (square, ratio) in modes_of(LENGTH, &water_moments()) {
        let exact = 2.0 * PI / square.sqrt();
        let mut state = inclined(&scene, 3e-6, 3e-6 * ratio);
        let mut period = Period::default();
        let step = (0.8 * limit).min(exact / 3000.0);
        let rk = rk4(&scene);
        march(rk, &scene, &mut state, (5.2 * exact, step), |t, s| {
            period.see(t, s.x[1].x);
        });
        let off = period.mean() / exact - 1.0;
        assert!(off.abs() < 2e-6, "{exact} s: off by {off}");
    }
}

/// Drag along 3 m of the body damps both modes: with mode shape `phi = L + r s` at a depth s below the hang point and modal mass
/// m, `1/a` grows by `8/3 k/m <|phi|³>` a cycle (the work of `k |u| u` over a cosine; any text on quadratic damping).
#[test]
fn drag_along_it_damps_its_swings() {
    let (area, length, middle) = (500.0, 3.0, 1.6);
    let scene = build(&IN_WATER.replace("drag_area_m2 = 0.0", &format!("drag_area_m2 = {area:?}")).replace(
        "centre_of_buoyancy_m",
        &format!("centre_of_drag_m = {middle:?}, drag_length_m = {length:?}, centre_of_buoyancy_m"),
    ));
    let of = water_moments();
    for (square, ratio) in modes_of(LENGTH, &of) {
        let modal =
            of.mass * LENGTH * LENGTH + 2.0 * of.first * LENGTH * ratio + of.second * ratio * ratio;
        let cubed = |s: f64| {
            let phi = LENGTH + ratio * s;
            phi.powi(3) * phi.abs() / (4.0 * ratio)
        };
        let mean = (cubed(middle + 0.5 * length) - cubed(middle - 0.5 * length)) / length;
        let rate = 8.0 / 3.0 * 0.5 * 1000.0 * area * mean / modal;
        let (start, cycles) = (2e-3 / rate, 8.0);
        let mut state = inclined(&scene, start, start * ratio);
        let exact = 2.0 * PI / square.sqrt();
        // How much of this mode there is: the modes are orthogonal by the mass.
        let (of_line, of_body) = (
            of.mass * LENGTH * LENGTH + of.first * LENGTH * ratio,
            of.first * LENGTH + of.second * ratio,
        );
        let share = |s: &State| {
            let (line, body) = (s.x[1] - s.x[0], s.x[2] - s.x[1]);
            (of_line * line.x / line.norm() + of_body * body.x / body.norm()) / modal
        };
        let (mut last, step) = (
            0.0_f64,
            (0.8 * scene.explicit_limit().0).min(exact / 1000.0),
        );
        let rk = rk4(&scene);
        march(rk, &scene, &mut state, (cycles * exact, step), |t, s| {
            if t > (cycles - 0.25) * exact {
                last = last.max(share(s));
            }
        });
        let grown = (1.0 / last - 1.0 / start) / cycles;
        assert!((grown / rate - 1.0).abs() < 0.01, "{ratio}: {grown} {rate}");
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

/// Nor does water take any that flows as an ideal fluid, whichever way it is heavier.
#[test]
fn a_body_that_tumbles_in_water_keeps_its_energy() {
    for along in ["120.0", "900.0"] {
        let scene = build(&IN_WATER.replace("120.0", along));
        // Thrown less far than in air, where it weighs more: the line stays taut.
        let mut state = inclined(&scene, 0.3, 0.8);
        state.v[2].y = 0.5;
        let before = scene.energy(&state);
        let step = 0.4 * scene.explicit_limit().0;
        march(rk4(&scene), &scene, &mut state, (30.0, step), |_, _| ());
        let lost = (before - scene.energy(&state)) / (600.0 * G * (LENGTH + CENTRE));
        assert!(lost.abs() < 1e-6, "{along}: {lost}");
    }
}

/// A string at the angle alpha and a body at beta that go round together at the rate W, the body spinning about its axis with
/// the angular momentum h: `T cos(alpha) = M g`, `T sin(alpha) = M W² (L sin(alpha) + c sin(beta))` and
/// `T c sin(beta - alpha) = W sin(beta) (I W cos(beta) + h)`.
#[test]
fn a_spinning_body_goes_round_as_the_top_does() {
    let (alpha, beta) = (0.15_f64, 0.6_f64);
    let out = LENGTH * alpha.sin() + CENTRE * beta.sin();
    let rate = (G * alpha.tan() / out).sqrt();
    let pull = MASS * G / alpha.cos() * CENTRE * (beta - alpha).sin();
    let spin = pull / (rate * beta.sin()) - INERTIA * rate * beta.cos();
    let inertia = 1500.0;
    let degrees = (spin / inertia).to_degrees();
    let scene = build(&BODY.replace(
        "inertia_kg_m2 = 900.0",
        &format!(
            "inertia_kg_m2 = 900.0, spin_inertia_kg_m2 = {inertia:?}, spin_deg_per_s = {degrees:?}"
        ),
    ));
    let mut state = inclined(&scene, alpha, beta);
    for (v, x) in state.v.iter_mut().zip(&state.x) {
        *v = V3::z().cross(x) * rate;
    }
    let end = 3.0;
    let step = 0.5 * scene.explicit_limit().0;
    march(rk4(&scene), &scene, &mut state, (end, step), |_, s| {
        assert!(
            (scene.tilt(s) - beta).abs() < 1e-4,
            "{} {beta}",
            scene.tilt(s)
        );
    });
    let gone = state.x[1].y.atan2(state.x[1].x);
    assert!((gone - rate * end).abs() < 1e-4, "{gone} {}", rate * end);
}

/// `k U² d cos = (M g c - B b) sin + (A_n - A_t) U² sin cos`: Munk's moment turns a body with less water along its axis across
/// the flow, and so helps to right it.
#[test]
fn in_a_current_munks_moment_rights_it() {
    let text = |added: &str| {
        format!(
            r#"
            environment.water_density_kg_per_m3 = 1025.0
            current.speed_m_per_s = 2.5
            materials.rope = {{ mass_kg_per_m = 1e-6, wet_weight_kg_per_m = 0.0, ea_n = 1e9 }}
            line = {{ length_m = 10.0, segments = 4 }}
            ends.b = {{ name = "body", kind = "payload" }}
            payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 600.0, drag_area_m2 = 1.0, added_mass_kg = {added}, rotation = {{ centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0, centre_of_drag_m = 1.7, drag_length_m = 2.0, centre_of_buoyancy_m = 1.2 }} }}
            "#
        )
    };
    let tilt = |added: &str| {
        let scene = build(&text(added));
        scene.tilt(&at_rest(&scene))
    };
    let righting = (1000.0 * 2.0 - 400.0 * 1.2) * G;
    let drag = 0.5 * 1025.0 * 2.5 * 2.5 * 1.7;
    let sphere = (drag / righting).atan();
    assert!((tilt("300.0") - sphere).abs() < 1e-6);
    let held = tilt("[500.0, 500.0, 100.0]");
    let munk = 400.0 * 2.5 * 2.5 * held.sin() * held.cos();
    let off = drag * held.cos() - righting * held.sin() - munk;
    assert!(off.abs() < 1e-5 * righting, "{off} {held}");
    assert!(held < sphere - 0.01, "{held} {sphere}");
}

/// Energy gone, less what drag took, summed over the steps by the trapezoidal rule.
#[test]
fn the_books_of_a_dragged_body_balance() {
    // In still water, and in a current that takes and gives through the water that goes along.
    for speed in ["0.0", "1.5"] {
        let scene = build(&format!(
            r#"
            environment.water_density_kg_per_m3 = 1025.0
            current.speed_m_per_s = {speed}
            materials.rope = {{ mass_kg_per_m = 2.0, ea_n = 1e8, drag_normal = 1.2, added_mass_normal = 0.0 }}
            line = {{ length_m = 20.0, segments = 3 }}
            ends.b = {{ name = "body", kind = "payload" }}
            payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = [2.0, 2.0, 0.5], added_mass_kg = [300.0, 300.0, 150.0], rotation = {{ centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0, centre_of_drag_m = 2.6, drag_length_m = 3.0, added_inertia_kg_m2 = 150.0, start_tilt_deg = -60.0, spin_deg_per_s = 200.0, spin_inertia_kg_m2 = 700.0 }} }}
            start = {{ shape = "straight", elevation_deg = -20.0 }}
            "#
        ));
        let mut state = scene.initial_state();
        let before = scene.energy(&state);
        let (mut lost, mut worst, mut taken) = (0.0, 0.0_f64, 0.0);
        let mut last: Option<(f64, f64)> = None;
        let step = 0.8 * scene.explicit_limit().0;
        march(rk4(&scene), &scene, &mut state, (20.0, step), |t, s| {
            let power = scene.dissipation(s);
            if let Some((t0, before)) = last {
                lost += 0.5 * (t - t0) * (power + before);
                taken += 0.5 * (t - t0) * (power + before).abs();
            }
            last = Some((t, power));
            worst = worst.max((before - scene.energy(s) - lost).abs());
        });
        assert!(
            worst < 3e-6 * taken,
            "{speed}: {} of {taken}",
            worst / taken
        );
    }
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
            payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = [2.0, 2.0, 0.5], added_mass_kg = [300.0, 300.0, 500.0], rotation = {{ centre_of_gravity_m = 2.0, inertia_kg_m2 = 900.0, drag_length_m = 2.5, spin_deg_per_s = 300.0, spin_inertia_kg_m2 = 900.0, start_tilt_deg = 40.0, start_azimuth_deg = {} }} }}
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
        (scene.end_b_position(&state), scene.tilt(&state))
    };
    let (plain, turned) = (end(0.0), end(37.0));
    let (sin, cos) = 37_f64.to_radians().sin_cos();
    let p = plain.0;
    let expected = V3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z);
    assert!((turned.0 - expected).norm() < 1e-8, "{turned:?} {expected}");
    assert!((turned.1 - plain.1).abs() < 1e-9);
    assert!(plain.1 > 0.01 && p.y.abs() > 0.01, "{plain:?}");
}
