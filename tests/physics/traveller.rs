//! A body that travels along the line: its tangent, its drag, its books of energy, the static influence line that a slow
//! crossing comes to, a fast one against d'Alembert's waves and against the equation of a mass on a string without mass, and
//! the two solvers against each other.

use crate::{march, rest};
use seacable::case;
use seacable::numerics::{BlockBand, V3};
use seacable::scene::Scene;
use seacable::solve::{ExplicitRhs, Factors, Kinematics, Residual, State};

/// 80 m of rope between level ends, stretched to about 20 kN, with a cargo on its way.
fn taut(segments: usize, traveller: &str) -> Scene {
    taut_in(segments, traveller, "")
}

/// The same with a current and what else is said.
fn taut_in(segments: usize, traveller: &str, more: &str) -> Scene {
    rest::build(&format!(
        r#"
        materials.rope = {{ mass_kg_per_m = 2.2, ea_n = 2.0e7, diameter_m = 0.02, axial_damping_ratio = 0.05 }}
        line = {{ length_m = 79.92, segments = {segments} }}
        ends.b = {{ name = "ship", kind = "fixed", position_m = [80.0, 0.0, 0.0] }}
        ends.a.position_m = [0.0, 0.0, 0.0]
        traveller = {{ name = "cargo", mass_kg = 50.0, wet_mass_kg = 50.0, {traveller} }}
        {more}
        "#
    ))
}

const DRAGGED: &str =
    "from_m = 10.0, speed_m_per_s = 3.0, ramp_s = 4.0, drag_area_m2 = [0.5, 0.7, 0.3]";
const CURRENT: &str = "environment.water_density_kg_per_m3 = 1025.0\n\
    current = { speed_m_per_s = [0.3, 2.0], direction_deg = [20.0, 70.0], depth_m = [0.0, 9.0] }";

#[test]
fn its_tangent_is_the_finite_difference() {
    let scene = taut_in(6, DRAGGED, CURRENT);
    let mut state = rest::at_rest(&scene);
    // Somewhere, in motion, while it gathers speed.
    for i in 0..state.x.len() {
        let k = i as f64;
        state.x[i] += V3::new((1.3 * k).sin(), (2.1 * k).cos(), k.sin()) * 0.3;
        state.v[i] = V3::new((0.7 * k).cos(), k.sin(), (1.7 * k).cos());
        state.a[i] = V3::new(k.sin(), (0.3 * k).cos(), (2.7 * k).sin());
    }
    let (t, n) = (2.2, scene.nodes());
    let factors = Factors {
        mass: 7.0,
        damping: 3.0,
        stiffness: 1.0,
    };
    let (mut r, mut tangent) = (vec![V3::zeros(); n], BlockBand::new(n));
    tangent.widen();
    scene.linearise(t, &state, factors, &mut r, &mut tangent);
    let mut plain = vec![V3::zeros(); n];
    scene.residual(t, &state, &mut plain);
    for (a, b) in r.iter().zip(&plain) {
        assert!((a - b).norm() < 1e-9 * scene.line.force_scale);
    }
    let h = 1e-6;
    for node in 0..n {
        for axis in 0..3 {
            let shifted = |sign: f64| {
                let mut s = state.clone();
                s.x[node][axis] += sign * h;
                s.v[node][axis] += sign * h * factors.damping;
                s.a[node][axis] += sign * h * factors.mass;
                let mut r = vec![V3::zeros(); n];
                scene.residual(t, &s, &mut r);
                r
            };
            let (up, down) = (shifted(1.0), shifted(-1.0));
            for row in node.saturating_sub(2)..(node + 3).min(n) {
                let slope = (up[row] - down[row]) / (2.0 * h);
                let block = match row as isize - node as isize {
                    0 => tangent.diag[row],
                    1 => tangent.lower[row],
                    -1 => tangent.upper[row],
                    2 => tangent.far_lower[row],
                    _ => tangent.far_upper[row],
                };
                let off = (slope - block.column(axis)).norm();
                assert!(
                    off < 1e-5 * (block.norm() + 1e3),
                    "{node} {axis} {row}: {off}"
                );
            }
        }
    }
}

#[test]
fn explicit_accelerations_leave_no_residual() {
    let scene = taut_in(6, DRAGGED, CURRENT);
    let mut state = rest::at_rest(&scene);
    for (i, v) in state.v.iter_mut().enumerate().skip(1).take(5) {
        *v = V3::new(0.3, 0.1, (i as f64).sin());
    }
    // In a segment, on a node, and in the first segment beside a held end.
    for t in [0.5, 2.0, 4.0, 9.0] {
        scene.accelerate(t, &mut state);
        let mut r = vec![V3::zeros(); scene.nodes()];
        scene.residual(t, &state, &mut r);
        for node in scene.free() {
            assert!(
                r[node].norm() < 1e-9 * scene.line.force_scale,
                "{t} {node}: {}",
                r[node]
            );
        }
    }
}

/// The taut string's influence line: with the pull H that it has now, the line hangs (w/2H + Q/HL) x (L - x) below its
/// chord where the load is, as eq. (11) of the ropeway's paper says.
#[test]
fn a_slow_crossing_is_the_static_influence_line() {
    let scene = taut(40, "speed_m_per_s = 0.5, ramp_s = 4.0");
    let mut state = rest::at_rest(&scene);
    let (weight, load) = (2.2 * 9.80665, 50.0 * 9.80665);
    let (mut worst, mut deepest): (f64, f64) = (0.0, 0.0);
    let alpha = march::alpha(&scene, 0.4);
    march::march(alpha, &scene, &mut state, (150.0, 0.05), |t, s| {
        let (place, _) = scene.traveller_at(t, s).unwrap();
        deepest = deepest.max(-place.z);
        let pull = scene.end_force(0, s).x.abs();
        let string = (0.5 * weight + load / 80.0) / pull * place.x * (80.0 - place.x);
        // Shared by nodes 2 m apart it hangs less by a quarter of that times Q/H.
        let string = string - load / pull * 0.25 * 2.0;
        if place.x > 8.0 && place.x < 72.0 {
            worst = worst.max((-place.z / string - 1.0).abs());
        }
    });
    assert!(deepest > 0.7, "{deepest}");
    assert!(worst < 0.0025, "{worst}");
}

/// At every place of a slow crossing the line is where it would rest with the traveller there.
#[test]
fn a_slow_crossing_goes_through_equilibria() {
    let scene = taut(20, "speed_m_per_s = 0.4, ramp_s = 5.0");
    let mut state = rest::at_rest(&scene);
    march::march(
        march::alpha(&scene, 0.4),
        &scene,
        &mut state,
        (82.3, 0.05),
        |_, _| (),
    );
    let arc = scene.traveller_arc(82.3, &state).unwrap();
    let still = taut(20, &format!("from_m = {arc:?}, speed_m_per_s = 0.0"));
    let resting = rest::at_rest(&still);
    let (moving, _) = scene.traveller_at(82.3, &state).unwrap();
    let (resting, _) = still.traveller_at(0.0, &resting).unwrap();
    assert!((arc - 31.92).abs() < 1e-9, "{arc}");
    assert!((moving - resting).norm() < 5e-3, "{moving} {resting}");
}

/// Over the nodes too nothing is left out: energy grows by what the drive does and falls by what damping and drag take.
#[test]
fn its_books_balance() {
    // Four segments of 20 m, two nodes passed; in a current, with a line that it does not drag.
    let scene = taut_in(
        4,
        "from_m = 12.0, speed_m_per_s = 8.0, ramp_s = 2.0, drag_area_m2 = [0.05, 0.05, 0.1]",
        CURRENT,
    );
    let out = [0.002, 0.001].map(|h| {
        let mut state = rest::at_rest(&scene);
        for v in &mut state.v {
            *v = V3::zeros();
        }
        // A push, so that something swings.
        state.v[2] = V3::new(0.0, 0.5, 1.0);
        let energy = |t: f64, s: &State| scene.energy(s) + scene.traveller_energy(t, s).unwrap().0;
        let before = energy(0.0, &state);
        let (mut gained, mut last) = (0.0, None::<(f64, f64)>);
        let mut worst: f64 = 0.0;
        march::march(march::rk4(&scene), &scene, &mut state, (5.0, h), |t, s| {
            let power = scene.traveller_energy(t, s).unwrap().1 - scene.dissipation(s);
            if let Some((then, was)) = last {
                gained += 0.5 * (t - then) * (power + was);
            }
            last = Some((t, power));
            worst = worst.max((energy(t, s) - before - gained).abs());
        });
        worst
    });
    // Of some 50 J that swing; the trapezoidal rule is what is left.
    assert!(out[1] < 0.02, "{out:?}");
    assert!(out[0] / out[1] > 3.0 || out[1] < 1e-3, "{out:?}");
}

/// `1/2 rho C_D A |u| u` with the velocity along the line in u.
#[test]
fn its_drag_is_that_of_the_water_past_it() {
    let scene = |area: &str| {
        taut_in(
            8,
            &format!("speed_m_per_s = 3.0, drag_area_m2 = {area}"),
            CURRENT,
        )
    };
    let (plain, dragged) = (scene("0.0"), scene("[0.5, 0.7, 0.3]"));
    let mut state = rest::at_rest(&plain);
    for (i, v) in state.v.iter_mut().enumerate() {
        *v = V3::new(0.1, 0.4, (i as f64).sin());
    }
    let t = 7.3;
    let asks = |scene: &Scene| -> V3 {
        let mut r = vec![V3::zeros(); scene.nodes()];
        scene.residual(t, &state, &mut r);
        r.iter().sum()
    };
    let (place, velocity) = dragged.traveller_at(t, &state).unwrap();
    let u = dragged.line.current.at(&place).0 - velocity;
    let drag = V3::new(0.5, 0.7, 0.3).component_mul(&u) * (0.5 * 1025.0 * u.norm());
    assert!((asks(&plain) - asks(&dragged) - drag).norm() < 1e-9 * drag.norm());
    assert!(velocity.x > 3.0 && drag.norm() > 1e3, "{velocity} {drag}");
}

/// A rope stretched by a tenth to 20 kN, without weight, that a load of 49 N hardly stretches further, and the load's way on it
/// up to a time: place and sag.
fn crossing(
    segments: usize,
    per_metre: f64,
    mass: f64,
    speed: f64,
    end: f64,
    step: f64,
) -> Vec<(f64, f64)> {
    let scene = rest::build(&format!(
        r#"
        materials.rope = {{ mass_kg_per_m = {per_metre:?}, wet_weight_kg_per_m = 0.0, ea_n = 2.0e5, diameter_m = 0.02, added_mass_normal = 0.0, axial_damping_ratio = 0.05 }}
        line = {{ length_m = {:?}, segments = {segments} }}
        ends.b = {{ name = "far", kind = "fixed", position_m = [80.0, 0.0, 0.0] }}
        ends.a.position_m = [0.0, 0.0, 0.0]
        traveller = {{ name = "cargo", mass_kg = {mass:?}, wet_mass_kg = 5.0, speed_m_per_s = {:?} }}
        "#,
        80.0 / 1.1,
        speed / 1.1
    ));
    let mut state = rest::at_rest(&scene);
    let mut way = Vec::new();
    let alpha = march::alpha(&scene, 0.6);
    march::march(alpha, &scene, &mut state, (end, step), |t, s| {
        let (place, _) = scene.traveller_at(t, s).unwrap();
        way.push((place.x, -place.z));
    });
    way
}

/// A load that enters a string at the speed v stands between a wave that runs ahead at c and the end it came from: until the
/// wave is back its sag is `Q x / T (1 + v/c)`, d'Alembert's, where at rest it would be `Q x (L - x) / T L`.
#[test]
fn a_fast_load_sags_by_the_waves_it_sends_ahead() {
    let (c, v) = (100.0, 40.0);
    let off = |segments: usize| {
        let way = crossing(segments, 2.2, 1e-3, v, 1.0, 0.1 / segments as f64);
        let apart = way
            .iter()
            .filter(|(x, _)| (20.0..40.0).contains(x))
            .map(|(x, sag)| {
                let exact = 5.0 * 9.80665 * x / (2e4 * (1.0 + v / c));
                (sag / exact - 1.0).abs()
            });
        apart.fold(0.0, f64::max)
    };
    let (coarse, fine) = (off(40), off(160));
    assert!(fine < 0.02 && fine < 0.5 * coarse, "{coarse} {fine}");
}

/// On a string without mass a load of 50 kg moves by `m y'' = Q - T L y / x (L - x)`, `x = v t` (Stokes 1849; Frýba 1972).
#[test]
fn a_heavy_load_on_a_light_string_moves_by_stokes_equation() {
    let (v, length, pull) = (22.0, 80.0, 2e4);
    let gain = |t: f64, y: f64| {
        let x = v * t;
        let stiffness = if x > 0.0 {
            pull * length / (x * (length - x))
        } else {
            0.0
        };
        (5.0 * 9.80665 - stiffness * y) / 50.0
    };
    let exact = |end: f64| {
        let (mut y, mut rate, steps) = (0.0, 0.0, 20_000);
        let h = end / f64::from(steps);
        for step in 0..steps {
            let t = f64::from(step) * h;
            let k1 = (rate, gain(t, y));
            let k2 = (rate + 0.5 * h * k1.1, gain(t + 0.5 * h, y + 0.5 * h * k1.0));
            let k3 = (rate + 0.5 * h * k2.1, gain(t + 0.5 * h, y + 0.5 * h * k2.0));
            let k4 = (rate + h * k3.1, gain(t + h, y + h * k3.0));
            y += h / 6.0 * (k1.0 + 2.0 * (k2.0 + k3.0) + k4.0);
            rate += h / 6.0 * (k1.1 + 2.0 * (k2.1 + k3.1) + k4.1);
        }
        y
    };
    let off = |segments: usize| {
        let way = crossing(segments, 1e-3, 50.0, v, 3.2, 0.1 / segments as f64);
        let some = way.iter().filter(|(x, _)| *x > 8.0).step_by(way.len() / 12);
        let apart = some.map(|(x, sag)| (sag - exact(x / v)).abs());
        apart.fold(0.0, f64::max)
    };
    // Of sags of some 0.06 m.
    let (coarse, fine) = (off(40), off(160));
    assert!(fine < 6e-4 && fine < 0.35 * coarse, "{coarse} {fine}");
}

#[test]
fn the_implicit_and_the_explicit_march_agree_over_many_nodes() {
    let end = |implicit: bool| {
        let scene = taut(16, "speed_m_per_s = 4.0, ramp_s = 1.0");
        let mut state = rest::at_rest(&scene);
        if implicit {
            march::march(
                march::alpha(&scene, 0.4),
                &scene,
                &mut state,
                (10.0, 0.002),
                |_, _| (),
            );
        } else {
            march::march(
                march::rk4(&scene),
                &scene,
                &mut state,
                (10.0, 0.001),
                |_, _| (),
            );
        }
        scene.traveller_at(10.0, &state).unwrap().0
    };
    let (a, b) = (end(true), end(false));
    assert!((a - b).norm() < 5e-3, "{a} {b}");
}

#[test]
fn its_channels_are_recorded_and_its_keys_checked() {
    let text = include_str!("../../cases/ropeway/crossing.toml");
    let case = case::parse(text, "crossing").unwrap();
    let names: Vec<String> = case::channels(&case)
        .into_iter()
        .map(|c| c.id.to_string())
        .collect();
    for name in [
        "x_m[cargo]",
        "z_m[cargo]",
        "arc_m[cargo]",
        "tension_n[cargo]",
    ] {
        assert!(names.iter().any(|known| known == name), "{name}");
    }
    // Its way may end where the line does.
    let to_the_end = text.replace("to_m = 77.6", "to_m = 81.6006");
    assert!(case::parse(&to_the_end, "crossing").is_ok());
    let beyond = text.replace("to_m = 77.6", "to_m = 90.0");
    let reported = case::parse(&beyond, "crossing").unwrap_err();
    assert!(
        reported[0].to_string().contains("lies beyond the line"),
        "{}",
        reported[0]
    );
    let twice = text.replace("name = \"cargo\"", "name = \"ship\"");
    let reported = case::parse(&twice, "crossing").unwrap_err();
    assert!(
        reported[0].to_string().contains("used twice"),
        "{}",
        reported[0]
    );
}
