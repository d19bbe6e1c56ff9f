//! Dynamic stiffness: history of a rope and the stiffness that follows.

use seacable::dynamics::Stepper;
use seacable::scene::Scene;
use seacable::solve::{ExplicitRhs, Hysteresis, Kinematics, Residual};

use crate::{march, rest};

const ALPHA: f64 = 14.0;
const BETA: f64 = 0.2;
const GAMMA: f64 = 0.25;
const STRENGTH: f64 = 1e5;
const STATIC: f64 = 1.2e6;

/// A body hung on a fibre rope of 100 m, with more words for its material.
fn hung(reading: &str, segments: usize, more: &str) -> Scene {
    rest::build(&format!(
        "materials.rope = {{ ea_n = {STATIC}, break_load_n = {STRENGTH}, dynamic_stiffness = \"{reading}\", \
         dynamic_alpha = {ALPHA}, dynamic_beta = {BETA}, dynamic_gamma = {GAMMA}{more} }}\n\
         line.segments = {segments}\n\
         ends.b = {{ name = \"bob\", kind = \"payload\" }}\n\
         payload = {{ dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}"
    ))
}

/// For a rope whose segments share one stiffness.
const ROPE: &str = ", stiffness_scope = \"rope\"";

/// At rest the mean is the tension itself: `T = MBL e (alpha + beta 100 T / MBL)`, or the static stiffness.
#[test]
fn a_rope_at_rest_has_the_stiffness_of_its_own_tension() {
    for reading in ["secant", "about-the-mean"] {
        let scene = hung(reading, 10, "");
        let state = rest::at_rest(&scene);
        for i in 0..10 {
            let beyond = 9 - i;
            let tension = 9.80665 * (1000.0 + 2.0 * (5.0 + 10.0 * f64::from(beyond)));
            let node = usize::try_from(i).unwrap();
            let strain = (state.x[node + 1] - state.x[node]).norm() / 10.0 - 1.0;
            let found = scene.line.rope_reading(node, &state).unwrap();
            assert!((found.mean_load - 100.0 * tension / STRENGTH).abs() < 1e-6);
            assert_eq!(found.deviation, 0.0);
            let k = ALPHA + BETA * found.mean_load;
            assert!((found.stiffness - k).abs() < 1e-12);
            let stiffness = if reading == "secant" {
                k * STRENGTH
            } else {
                STATIC
            };
            assert!(
                (strain * stiffness / tension - 1.0).abs() < 1e-8,
                "{reading} {i}"
            );
        }
    }
}

/// What is at rest stays at rest, and remembers nothing but that.
#[test]
fn a_rope_at_rest_stays_at_rest() {
    for reading in ["secant", "about-the-mean"] {
        let scene = hung(reading, 5, "");
        let rest = rest::at_rest(&scene);
        let mut state = rest.clone();
        march::march(
            march::alpha(&scene, 0.4),
            &scene,
            &mut state,
            (20.0, 0.1),
            |_, s| {
                for (a, b) in s.x.iter().zip(&rest.x) {
                    assert!((a - b).norm() < 1e-7, "{reading}");
                }
            },
        );
        assert!(
            state
                .memory
                .ropes
                .iter()
                .all(|past| past.tension_rate.abs() < 1.0)
        );
    }
}

/// A rope whose lower end is driven up and down, with a window of the mean.
fn driven(reading: &str, window: Option<f64>) -> Scene {
    let window = window.map_or_else(String::new, |w| format!("mean_window_s = {w:?}, "));
    rest::build(&format!(
        "materials.rope = {{ ea_n = {STATIC}, break_load_n = {STRENGTH}, dynamic_stiffness = \"{reading}\", {window}\
         dynamic_alpha = {ALPHA}, dynamic_beta = {BETA}, dynamic_gamma = {GAMMA} }}\n\
         line.segments = 4\n\
         ends.b = {{ name = \"bob\", kind = \"moving\", position_m = [0.0, 0.0, -101.0], \
         amplitude_m = [0.0, 0.0, 0.2], period_s = 6.0 }}"
    ))
}

/// The mean is the integral of the past tension by its time, the deviation the remainder, and k what the formula gives for
/// both, at every step; a window forgets exponentially.
#[test]
fn the_mean_is_that_of_the_past() {
    for (reading, window) in [
        ("secant", None),
        ("about-the-mean", None),
        ("secant", Some(10.0)),
    ] {
        let scene = driven(reading, window);
        let mut state = rest::at_rest(&scene);
        // By hand, in steps so short that the rule does not matter.
        let (mut mean, mut before): (f64, Option<(f64, f64)>) = (0.0, None);
        march::march(
            march::alpha(&scene, 0.4),
            &scene,
            &mut state,
            (40.0, 0.01),
            |t, s| {
                let found = scene.line.rope_reading(2, s).unwrap();
                let tension = (found.mean_load + found.deviation) * 0.01 * STRENGTH;
                mean = match before {
                    None => tension,
                    Some((last, was)) => {
                        let over = window.map_or(t, |w| t.min(w));
                        mean + (t - last) / over * (0.5 * (was + tension) - mean)
                    }
                };
                before = Some((t, tension));
                assert!(
                    (found.mean_load * 0.01 * STRENGTH / mean - 1.0).abs() < 2e-4,
                    "{reading} {t}"
                );
                let k = ALPHA + BETA * found.mean_load - GAMMA * found.deviation;
                assert!((found.stiffness - k).abs() < 1e-12);
            },
        );
    }
}

/// Small swings of a heavy body go with the slope of the reading: of the secant `k / (1 + 100 gamma e)`, about the
/// mean `k`.
#[test]
fn small_swings_go_at_the_slope_of_the_reading() {
    for reading in ["secant", "about-the-mean"] {
        let scene = hung(reading, 1, ", mass_kg_per_m = 0.001");
        let mut state = rest::at_rest(&scene);
        let (middle, length) = (state.x[1].z, state.x[1].norm());
        let k = scene.line.rope_reading(0, &state).unwrap().stiffness;
        state.v[1].z = 0.01;
        let mut crossings: Vec<f64> = Vec::new();
        let mut before = (0.0, 1.0);
        march::march(
            march::rk4(&scene),
            &scene,
            &mut state,
            (30.0, 0.002),
            |t, s| {
                let z = s.x[1].z - middle;
                if before.1 < 0.0 && z >= 0.0 {
                    crossings.push(before.0 + (t - before.0) * before.1 / (before.1 - z));
                }
                before = (t, z);
            },
        );
        let swings = (crossings.len() - 1) as f64;
        let period = (crossings[crossings.len() - 1] - crossings[0]) / swings;
        let slope = if reading == "secant" {
            k * STRENGTH / (1.0 + 100.0 * GAMMA * (length / 100.0 - 1.0))
        } else {
            k * STRENGTH
        };
        let exact = std::f64::consts::TAU * (1000.0 * 100.0 / slope).sqrt();
        assert!(
            (period / exact - 1.0).abs() < 2e-3,
            "{reading} {period} {exact}"
        );
    }
}

/// Where the body comes to after a push, by a method in steps of h.
fn after_a_push(scene: &Scene, method: impl Stepper<Scene>, h: f64) -> f64 {
    let mut state = rest::at_rest(scene);
    let last = state.v.len() - 1;
    // All along, so that the rope's own axial modes are not excited.
    for (node, v) in state.v.iter_mut().enumerate() {
        v.z = 0.3 * node as f64 / last as f64;
    }
    march::march(method, scene, &mut state, (8.0, h), |_, _| ());
    state.x[last].z
}

/// Generalized-alpha stays of second order, for the mean is moved on within the step; so does Runge-Kutta, whose
/// order 4 the mean does not have.
#[test]
fn the_march_is_of_second_order() {
    let scopes = [(1, ""), (3, ROPE)];
    let each = |reading| scopes.map(|(segments, scope)| (reading, segments, scope));
    for (reading, segments, scope) in ["secant", "about-the-mean"].into_iter().flat_map(each) {
        let scene = hung(reading, segments, scope);
        let exact = after_a_push(&scene, march::rk4(&scene), 0.000_5);
        let coarser = after_a_push(&scene, march::rk4(&scene), 0.001);
        assert!(
            (exact - coarser).abs() < 1e-6,
            "{reading} {exact} {coarser}"
        );
        let errors = [0.02, 0.01, 0.005].map(|h| {
            let end = after_a_push(&scene, march::alpha(&scene, 0.4), h);
            (end - exact).abs()
        });
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((1.8..2.3).contains(&order), "{reading}: {errors:?}");
        }
    }
}

/// What the books are out by at most, as a share of the most that was lost: energy gone, less dissipation summed over
/// the steps by trapezes.
fn out_by(scene: &Scene, h: f64) -> f64 {
    let mut state = rest::at_rest(scene);
    state.v[4].z = 0.5;
    // The curve at rest and the branch in motion store unlike energies, and how fast the mean moves is known only once
    // there is a past: the books begin a little later.
    let mut before = None;
    let (mut lost, mut last): (f64, Option<(f64, f64)>) = (0.0, None);
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    march::march(march::rk4(scene), scene, &mut state, (10.0, h), |t, s| {
        if t < 0.015 {
            return;
        }
        let power = scene.dissipation(s);
        if let Some((t0, p0)) = last {
            lost += 0.5 * (t - t0) * (p0 + power);
        }
        last = Some((t, power));
        let gone = *before.get_or_insert(scene.energy(s)) - scene.energy(s);
        worst = worst.max((gone - lost).abs());
        most = most.max(gone.abs());
    });
    assert!(most > 10.0, "{most}");
    worst / most
}

/// What the line has, loses by damping and by the fading of its memory adds up, the better the shorter the steps.
#[test]
fn the_books_balance() {
    for reading in ["secant", "about-the-mean"] {
        for scope in ["", ROPE] {
            let more = format!(", axial_damping_ratio = 0.05{scope}");
            let scene = hung(reading, 4, &more);
            let out = [0.004, 0.002, 0.001].map(|h| out_by(&scene, h));
            assert!(out[2] < 1e-3, "{reading} {scope} {out:?}");
            assert!(
                out[0] > 3.0 * out[1] && out[1] > 3.0 * out[2],
                "{reading} {scope} {out:?}"
            );
        }
    }
}

/// A step that is tried and refused leaves no trace: memory changes where a step is accepted, and nowhere else.
#[test]
fn trials_leave_no_trace() {
    let scene = hung("secant", 4, "");
    let mut state = rest::at_rest(&scene);
    state.v[4].z = 0.3;
    scene.commit(0.0, 0.0, &mut state);
    let memory = state.memory.clone();
    let mut r = vec![seacable::numerics::V3::zeros(); scene.nodes()];
    for step in 1..50 {
        let mut trial = state.clone();
        trial.x[4].z -= 0.01 * f64::from(step);
        scene.residual(f64::from(step), &trial, &mut r);
        scene.accelerate(f64::from(step), &mut trial);
        assert_eq!(trial.memory, memory);
    }
}

/// At rest a rope with one stiffness has that of its average tension in every segment; about the mean state it has its
/// static tensions.
#[test]
fn a_whole_rope_at_rest_has_one_stiffness() {
    for reading in ["secant", "about-the-mean"] {
        let scene = hung(reading, 10, &format!(", mass_kg_per_m = 40.0{ROPE}"));
        let mut state = rest::at_rest(&scene);
        let tension = |i: usize| 9.80665 * (1000.0 + 40.0 * (5.0 + 10.0 * (9 - i) as f64));
        let average = (0..10).map(tension).sum::<f64>() / 10.0;
        let k = ALPHA + BETA * 100.0 * average / STRENGTH;
        for _ in 0..2 {
            for i in 0..10 {
                let strain = (state.x[i + 1] - state.x[i]).norm() / 10.0 - 1.0;
                let found = scene.line.rope_reading(i, &state).unwrap();
                assert!((found.mean_load - 100.0 * average / STRENGTH).abs() < 1e-6);
                assert!(found.deviation.abs() < 1e-6);
                assert!((found.stiffness - k).abs() < 1e-6);
                let stiffness = if reading == "secant" {
                    k * STRENGTH
                } else {
                    STATIC
                };
                assert!(
                    (strain * stiffness / tension(i) - 1.0).abs() < 1e-8,
                    "{reading} {i}"
                );
            }
            // The motion begins with what the line at rest has.
            scene.commit(0.0, 0.0, &mut state);
        }
        let rest = state.clone();
        let method = march::alpha(&scene, 0.4);
        march::march(method, &scene, &mut state, (20.0, 0.1), |_, s| {
            for (a, b) in s.x.iter().zip(&rest.x) {
                assert!((a - b).norm() < 1e-7, "{reading}");
            }
        });
    }
}

/// One segment alone shares its stiffness with none: both scopes are the same, to the last digit.
#[test]
fn one_segment_has_the_same_stiffness_in_both_scopes() {
    for reading in ["secant", "about-the-mean"] {
        let end = |scope| {
            let scene = hung(reading, 1, scope);
            after_a_push(&scene, march::alpha(&scene, 0.4), 0.01)
        };
        assert_eq!(end(""), end(ROPE), "{reading}");
    }
}

/// A rope without weight has the same tension all along, which both scopes then agree on: the better, the shorter the
/// steps, for what segments share is extrapolated within the step.
#[test]
fn without_weight_both_scopes_agree() {
    let light = ", mass_kg_per_m = 1e-3";
    for reading in ["secant", "about-the-mean"] {
        let differences = [0.04, 0.02, 0.01].map(|h| {
            let end = |scope: &str| {
                let scene = hung(reading, 3, &format!("{light}{scope}"));
                after_a_push(&scene, march::alpha(&scene, 0.4), h)
            };
            (end("") - end(ROPE)).abs()
        });
        assert!(differences[2] < 1e-5, "{reading} {differences:?}");
        assert!(
            differences[2] < differences[0] / 6.0,
            "{reading} {differences:?}"
        );
    }
}

/// In motion all segments of a rope have one k, by the mean and the deviation of the average tension.
#[test]
fn a_whole_rope_in_motion_has_one_stiffness() {
    for reading in ["secant", "about-the-mean"] {
        let scene = hung(reading, 5, &format!(", mass_kg_per_m = 40.0{ROPE}"));
        let mut state = rest::at_rest(&scene);
        state.v[5].z = 0.5;
        let method = march::alpha(&scene, 0.4);
        let mut swing = 0.0_f64;
        march::march(method, &scene, &mut state, (10.0, 0.01), |t, s| {
            let found: Vec<_> = (0..5)
                .map(|i| scene.line.rope_reading(i, s).unwrap())
                .collect();
            assert!(found.iter().all(|one| *one == found[0]));
            let one = found[0];
            let k = ALPHA + BETA * one.mean_load - GAMMA * one.deviation;
            assert!((one.stiffness - k).abs() < 1e-9, "{reading} {t}");
            let tension = |i: usize| scene.line.pull(i, &scene.line.chord(i, s), t, s).value;
            let average = (0..5).map(tension).sum::<f64>() / 5.0;
            let percent = one.mean_load + one.deviation;
            assert!((percent - 100.0 * average / STRENGTH).abs() < 1e-6);
            swing = swing.max(one.deviation.abs());
        });
        assert!(swing > 1.0, "{swing}");
    }
}
