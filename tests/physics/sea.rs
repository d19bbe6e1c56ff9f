//! Waves and the surface of the water on lines: closed forms, balances, and what must not depend on anything.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use crate::march::{alpha, march, rk4};
use seacable::case::Case;
use seacable::numerics::V3;
use seacable::scene::{self, Scene};
use seacable::solve::{Kinematics, Residual, State};
use seacable::statics::equilibrium::EquilibriumSearch;

const G: f64 = 9.80665;
const RHO: f64 = 1025.0;

/// A line of one material with tables of the test's own.
fn line(material: &str, section: &str, ends: [&str; 2], tables: &str) -> Scene {
    let text = format!(
        "[case]\ntitle = \"test\"\n[materials.m]\n{material}\n[[line]]\nname = \"s\"\nmaterial = \"m\"\n{section}\n\
         [ends.a]\nname = \"a\"\n{}\n[ends.b]\nname = \"b\"\n{}\n{tables}",
        ends[0], ends[1]
    );
    let case: Case = seacable::case::parse_keys(&text).unwrap_or_else(|e| panic!("{e:?}\n{text}"));
    scene::build(&case, 1).unwrap()
}

/// The line in equilibrium.
fn at_rest(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(scene, 0.0, &mut state)
        .unwrap();
    state
}

/// Total load of the water on an upright, very taut line from the bed to still water, held at both ends and at rest:
/// the sum of the residual, without the weight.
fn load_on_cylinder(scene: &Scene, t: f64) -> V3 {
    let mut state = scene.initial_state();
    let n = scene.nodes();
    scene.update_wave_kinematics(t, &mut state);
    let mut r = vec![V3::zeros(); n];
    scene.residual(t, &state, &mut r);
    // Pulls cancel in the sum; weights are taken away.
    let weight: f64 = scene.line.weight.iter().sum();
    -(r.iter().sum::<V3>() - V3::z() * weight)
}

#[test]
fn morisons_load_on_an_upright_cylinder_is_the_integral() {
    let (depth, d, cd, ca, h, period) = (30.0, 0.8, 1.1, 0.9, 4.0, 9.0);
    let scene = |segments: usize| {
        line(
            &format!(
                "diameter_m = {d}\nmass_kg_per_m = 900.0\nea_n = 1e9\ndrag_normal = {cd}\nadded_mass_normal = {ca}"
            ),
            &format!("length_m = {depth}\nsegments = {segments}"),
            [
                &format!("kind = \"anchor\"\nposition_m = [0.0, 0.0, -{depth}]"),
                "kind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]",
            ],
            &format!(
                "[start]\nshape = \"straight\"\n[waves]\nkind = \"regular\"\nheight_m = {h}\nperiod_s = {period}\n\
                 depth_m = {depth}\ndirection_deg = 30.0"
            ),
        )
    };
    let (a, omega) = (0.5 * h, TAU / period);
    let k = seacable::physics::sea::wave_number(omega, G, depth);
    let (sh, s2) = ((k * depth).sinh(), (2.0 * k * depth).sinh());
    // Airy at the cylinder, integrated from bed to still water: cosh gives sinh(kh)/k, cosh² gives (sinh 2kh + 2kh)/4k.
    let drag = 0.5 * RHO * cd * d * (a * omega / sh).powi(2) * (s2 + 2.0 * k * depth) / (4.0 * k);
    let inertia = RHO * FRAC_PI_4 * d * d * (1.0 + ca) * a * omega * omega / k;
    let direction = V3::new((PI / 6.0).cos(), (PI / 6.0).sin(), 0.0);
    for t in [0.0, 0.7, 2.0, 4.1, 6.6] {
        let (sin, cos) = (omega * t).sin_cos();
        let expected = drag * cos * cos.abs() - inertia * sin;
        let error = |segments| {
            let load = load_on_cylinder(&scene(segments), t);
            let across = load - direction * load.dot(&direction);
            assert!(across.xy().norm() < 1e-9 * drag, "{across}");
            (load.dot(&direction) - expected).abs() / (drag + inertia)
        };
        let (coarse, fine) = (error(50), error(100));
        assert!(fine < 2e-4, "{t}: {fine}");
        // Trapezes: second order.
        assert!(
            fine < 1e-7 || (3.8..4.2).contains(&(coarse / fine)),
            "{coarse} {fine}"
        );
    }
}

/// Unstretched arc length at which the line goes through still water \[m\].
fn arc_at_surface(scene: &Scene, state: &State) -> f64 {
    let i = (0..scene.nodes()).find(|i| state.x[i + 1].z < 0.0).unwrap();
    let (above, below) = (state.x[i].z, state.x[i + 1].z);
    scene.line.arc[i] + (scene.line.arc[i + 1] - scene.line.arc[i]) * above / (above - below)
}

/// A free line that is lighter than water when wet and floats upright, ballasted at its foot.
fn spar(clump: f64) -> Scene {
    line(
        "diameter_m = 0.5\nmass_kg_per_m = 60.0\nea_n = 1e8\nei_n_m2 = 1e6\naxial_damping_ratio = 0.2\n\
         drag_normal = 1.0\ndrag_tangential = 0.2",
        "length_m = 20.0\nsegments = 20",
        [
            "kind = \"free\"",
            "kind = \"fixed\"\nposition_m = [0.0, 0.0, -60.0]",
        ],
        &format!(
            "[[line]]\nname = \"tether\"\nmaterial = \"wire\"\nlength_m = 45.0\nsegments = 9\n[materials.wire]\n\
             diameter_m = 0.01\nmass_kg_per_m = 1.0\nwet_weight_kg_per_m = 0.9215\nea_n = 1e7\n\
             [environment]\nwater_surface = \"crossed\"\n[[clumps]]\nname = \"ballast\"\nsection = \"s\"\nat_m = 20.0\n\
             mass_kg = {clump}\nwet_mass_kg = {clump}"
        ),
    )
}

#[test]
fn a_spar_on_a_tether_settles_where_archimedes_has_it() {
    let scene = spar(600.0);
    let state = at_rest(&scene);
    let top = state.x[0].z;
    // Tether taut: its foot is 15 m under; the spar's own draught and the tether's tension balance.
    let area = FRAC_PI_4 * 0.25;
    let draught = 20.0 - arc_at_surface(&scene, &state);
    let lift = RHO * area * draught - (60.0 * 20.0 + 600.0);
    let below = scene.tension_at(29, &state);
    let expected = (lift - 45.0 * 0.9215) * G;
    assert!((below / expected - 1.0).abs() < 1e-7, "{below} {expected}");
    assert!(top > 1.0, "{top}");
    // The pull at the foot is what holds all of it.
    let force = scene.end_force(29, &state);
    assert!((force.z - below).abs() < 1e-6 * below);
}

#[test]
fn a_line_hung_from_above_weighs_its_weight_in_air_there() {
    let scene = line(
        "diameter_m = 0.1\nmass_kg_per_m = 30.0\nea_n = 1e9",
        "length_m = 50.0\nsegments = 37",
        [
            "kind = \"fixed\"\nposition_m = [0.0, 0.0, 20.0]",
            "kind = \"free\"",
        ],
        "[environment]\nwater_surface = \"crossed\"",
    );
    let state = at_rest(&scene);
    let under = 50.0 - arc_at_surface(&scene, &state);
    let expected = (30.0 * 50.0 - RHO * FRAC_PI_4 * 0.01 * under) * G;
    let top = scene.tension_at(0, &state);
    assert!((top / expected - 1.0).abs() < 1e-9, "{top} {expected}");
}

const AT_SEA: &str = "[waves]\nkind = \"irregular\"\nsignificant_height_m = 4.0\npeak_period_s = 7.0\n\
     components = 30\nseed = SEED\ndirection_deg = DIRECTION\nramp_s = 5.0\n[environment]\nwater_surface = \"SURFACE\"";

/// A light rope from a float at the surface to an anchor, in irregular waves.
fn moored(seed: u64, direction: f64, surface: &str, azimuth: f64) -> Scene {
    let (sin, cos) = azimuth.to_radians().sin_cos();
    let sea = AT_SEA
        .replace("SEED", &seed.to_string())
        .replace("DIRECTION", &direction.to_string())
        .replace("SURFACE", surface);
    line(
        "diameter_m = 0.12\nmass_kg_per_m = 14.0\nea_n = 1e6\naxial_damping_ratio = 0.2\ndrag_normal = 1.2\n\
         drag_tangential = 0.1",
        "length_m = 60.0\nsegments = 12",
        [
            &format!(
                "kind = \"fixed\"\nposition_m = [{}, {}, 3.0]",
                30.0 * cos,
                30.0 * sin
            ),
            "kind = \"anchor\"\nposition_m = [0.0, 0.0, -40.0]",
        ],
        &sea,
    )
}

/// Tension at the upper end every step.
fn record(scene: &Scene) -> (Vec<f64>, State) {
    let mut state = at_rest(scene);
    let mut tensions = Vec::new();
    march(
        alpha(scene, 0.4),
        scene,
        &mut state,
        (20.0, 0.02),
        |_, s| {
            tensions.push(scene.tension_at(0, s));
        },
    );
    (tensions, state)
}

#[test]
fn the_same_seed_gives_the_same_bits_and_another_seed_another_sea() {
    let (first, _) = record(&moored(3, 20.0, "crossed", 0.0));
    let (again, _) = record(&moored(3, 20.0, "crossed", 0.0));
    let (other, _) = record(&moored(4, 20.0, "crossed", 0.0));
    assert!(
        first
            .iter()
            .zip(&again)
            .all(|(a, b)| a.to_bits() == b.to_bits())
    );
    assert!(first.iter().zip(&other).any(|(a, b)| (a - b).abs() > 10.0));
}

#[test]
fn waves_turned_with_the_line_turn_the_answer() {
    let (first, state) = record(&moored(3, 20.0, "crossed", 0.0));
    let (turned, its) = record(&moored(3, 90.0, "crossed", 70.0));
    let scale = first.iter().copied().fold(0.0, f64::max);
    for (a, b) in first.iter().zip(&turned) {
        assert!((a - b).abs() < 1e-7 * scale, "{a} {b}");
    }
    let (sin, cos) = 70_f64.to_radians().sin_cos();
    for (x, y) in state.x.iter().zip(&its.x) {
        let back = V3::new(x.x * cos - x.y * sin, x.x * sin + x.y * cos, x.z);
        assert!((back - y).norm() < 1e-7);
    }
}

#[test]
fn two_methods_agree_in_waves_and_across_the_surface() {
    for surface in ["ignored", "crossed"] {
        let scene = moored(3, 20.0, surface, 0.0);
        let (_, implicit) = record(&scene);
        let mut explicit = at_rest(&scene);
        march(rk4(&scene), &scene, &mut explicit, (20.0, 0.002), |_, _| {});
        let off = implicit.x.iter().zip(&explicit.x);
        let off = off.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        assert!(off < 5e-3, "{surface}: {off}");
    }
}

#[test]
fn a_crest_that_leaves_a_node_dry_makes_no_force_jump() {
    // A flat line of 5 cm at still water: as long waves pass, the force on it must follow continuously.
    let scene = line(
        "diameter_m = 0.05\nmass_kg_per_m = 3.0\nea_n = 1e8\ndrag_normal = 1.0",
        "length_m = 10.0\nsegments = 4",
        [
            "kind = \"fixed\"\nposition_m = [-5.0, 0.0, 0.0]",
            "kind = \"fixed\"\nposition_m = [5.0, 0.0, 0.0]",
        ],
        "[start]\nshape = \"straight\"\n[environment]\nwater_surface = \"crossed\"\n[waves]\nkind = \"regular\"\n\
         height_m = 2.0\nperiod_s = 8.0",
    );
    let load = |t: f64| load_on_cylinder(&scene, t);
    let buoyancy = RHO * FRAC_PI_4 * 0.0025 * 10.0 * G;
    let (mut before, mut dry, mut wet) = (load(0.0), false, false);
    for i in 1..8000 {
        let now = load(1e-3 * f64::from(i));
        // The surface rises at most by 0.8 mm in a step, 1.6 % of the thickness.
        assert!(
            (now - before).norm() < 0.1 * buoyancy,
            "{i}: {now} {before}"
        );
        dry |= (now.z + buoyancy).abs() < 1e-9 * buoyancy;
        wet |= (now.z + buoyancy) > 0.9 * buoyancy;
        before = now;
    }
    assert!(dry && wet);
}

/// Top tensions \[kN\] every second of one period, 27 s and later after the motion is fully grown, read off the figures
/// of Lowe and Langley (OMAE 2006).
const JUMPER: [(&str, [f64; 27]); 3] = [
    (
        "along",
        [
            49.89, 48.18, 46.12, 44.22, 42.61, 41.77, 41.58, 41.87, 42.55, 43.48, 44.45, 45.64,
            46.48, 47.02, 47.02, 46.68, 46.39, 46.31, 46.64, 47.31, 48.38, 49.63, 50.82, 51.72,
            52.21, 52.21, 51.43,
        ],
    ),
    (
        "across",
        [
            48.25, 47.25, 46.15, 45.16, 44.45, 44.38, 44.9, 45.73, 46.54, 47.6, 48.41, 48.99,
            49.12, 48.67, 47.92, 46.73, 45.57, 44.77, 44.38, 44.64, 45.32, 46.15, 47.12, 47.99,
            48.73, 49.05, 48.99,
        ],
    ),
    (
        "heave",
        [
            55.81, 53.56, 50.31, 48.67, 46.89, 45.48, 44.22, 43.83, 43.03, 41.29, 39.13, 36.81,
            36.91, 38.33, 40.32, 43.35, 46.44, 49.66, 52.63, 54.4, 55.4, 55.65, 55.97, 56.59,
            57.46, 57.78, 57.33,
        ],
    ),
];

#[test]
fn the_jumper_of_lowe_and_langley_pulls_as_published() {
    for (motion, published) in JUMPER {
        let file = format!(
            "{}/cases/benchmarks/jumper_{motion}.toml",
            env!("CARGO_MANIFEST_DIR")
        );
        let case = seacable::case::load(file.as_ref()).unwrap().case;
        let scene = scene::build(&case, 1).unwrap();
        let mut state = at_rest(&scene);
        let mut sum = 0.0;
        march(
            alpha(&scene, 0.4),
            &scene,
            &mut state,
            (80.0, 0.01),
            |t, s| {
                let second = t.round();
                if (t - second).abs() < 1e-6 && second >= 54.0 {
                    let pull = 1e-3 * scene.tension_at(scene.nodes() - 1, s);
                    sum += (pull - published[second as usize - 54]).powi(2);
                }
            },
        );
        let rms = (sum / 27.0).sqrt();
        assert!(rms < 0.4, "{motion}: {rms} kN");
    }
}

/// A rope from an end with this motion to an anchor.
const LED: &str = r#"
[case]
title = "led"
[materials.m]
diameter_m = 0.05
mass_kg_per_m = 5.0
ea_n = 1e7
[[line]]
name = "s"
material = "m"
length_m = 60.0
segments = 4
[ends.a]
name = "a"
kind = "moving"
position_m = [20.0, 5.0, 0.0]
MOTION
[ends.b]
name = "b"
kind = "anchor"
position_m = [20.0, 0.0, -50.0]
[solver]
duration_s = 10.0
WAVES
"#;

fn led(motion: &str, waves: &str) -> String {
    LED.replace("MOTION", motion).replace("WAVES", waves)
}

/// Place of the moving end at a time.
fn place(scene: &Scene, t: f64) -> V3 {
    let mut state = scene.initial_state();
    scene.prescribe(t, &mut state);
    state.x[0]
}

#[test]
fn a_table_beside_the_case_goes_with_it() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("case.toml");
    let text = led("motion = \"table\"\nmotion_file = \"path.csv\"", "");
    std::fs::write(&file, &text).unwrap();
    std::fs::write(
        dir.path().join("path.csv"),
        "time_s,x_m,y_m,z_m\n0,0,0,0\n2,1,0,0\n5,3,-1,0.5\n10,4,-2,1\n",
    )
    .unwrap();
    let loaded = seacable::case::load(&file).unwrap();
    let scene = scene::build(&loaded.case, 1).unwrap();
    assert!((place(&scene, 5.0) - V3::new(23.0, 4.0, 0.5)).norm() < 1e-12);
    // The text that a run keeps needs no file any more.
    let kept = seacable::case::stand_alone(&text, &loaded.case);
    let again = seacable::case::parse(&kept, "elsewhere/case.toml").unwrap();
    assert_eq!(again, loaded.case);
    assert_eq!(seacable::case::stand_alone(&kept, &again), kept);
    // An error in the table is reported at its place there.
    std::fs::write(
        dir.path().join("path.csv"),
        "time_s,x_m,y_m,z_m\n0,0,0,0\n2,1,o,0\n",
    )
    .unwrap();
    let faults = seacable::case::load(&file).unwrap_err();
    assert!(faults[0].file.ends_with("path.csv"), "{faults:?}");
    assert_eq!((faults[0].line, faults[0].column), (3, 5));
    assert_eq!(faults[0].key, "y_m");
}

#[test]
fn a_table_that_ends_before_the_run_makes_no_scene() {
    let short = "\n[files.\"p.csv\"]\ntext = \"time_s,x_m,y_m,z_m\\n0,0,0,0\\n4,1,0,0\"";
    let text = led("motion = \"table\"\nmotion_file = \"p.csv\"", short);
    let case = seacable::case::parse(&text, "case.toml").unwrap();
    let fault = scene::build(&case, 1).unwrap_err().to_string();
    assert!(
        fault.contains("from 0 s to 4 s, and the run from 0 s to 10 s"),
        "{fault}"
    );
}

#[test]
fn an_irregular_motion_has_its_given_root_mean_square() {
    let motion = "motion = \"irregular\"\nrms_m = [0.8, 0.0, 0.4]\npeak_period_s = 9.0\nseed = 7";
    let case = seacable::case::parse(&led(motion, ""), "case.toml").unwrap();
    let scene = scene::build(&case, 1).unwrap();
    let mean = V3::new(20.0, 5.0, 0.0);
    let samples = 60_000;
    let mut sum = V3::zeros();
    for i in 0..samples {
        let d = place(&scene, 0.5 * f64::from(i)) - mean;
        sum += d.component_mul(&d);
    }
    let rms = (sum / f64::from(samples)).map(f64::sqrt);
    // Over 30000 s the record knows its own rms to about 1.5 %.
    assert!(
        (rms.x / 0.8 - 1.0).abs() < 0.05 && (rms.z / 0.4 - 1.0).abs() < 0.05,
        "{rms}"
    );
    assert_eq!(rms.y, 0.0);
}

#[test]
fn a_vessel_that_follows_the_surface_moves_with_it() {
    // Heave as the waves, all else nothing: the end is where the surface is, less its pitch.
    let head = "period_s,surge_m_per_m,surge_phase_deg,sway_m_per_m,sway_phase_deg,heave_m_per_m,heave_phase_deg,\
                roll_deg_per_m,roll_phase_deg,pitch_deg_per_m,pitch_phase_deg,yaw_deg_per_m,yaw_phase_deg";
    let rows = "4,0,0,0,0,1,0,0,0,0,0,0,0\\n30,0,0,0,0,1,0,0,0,0,0,0,0";
    let waves = format!(
        "[waves]\nkind = \"irregular\"\nsignificant_height_m = 3.0\npeak_period_s = 9.0\ndirection_deg = 25.0\n\
         [files.\"rao.csv\"]\ntext = \"{head}\\n{rows}\""
    );
    let motion = "motion = \"vessel\"\nmotion_file = \"rao.csv\"\nhang_point_m = [10.0, 0.0, 4.0]\nheading_deg = 90.0";
    let case = seacable::case::parse(&led(motion, &waves), "case.toml").unwrap();
    let scene = scene::build(&case, 1).unwrap();
    let sea = scene.line.water.as_ref().unwrap().waves.as_ref().unwrap();
    for t in [0.0, 3.3, 47.0] {
        // The reference point lies 10 m aft of the hang point: the ship points along y.
        let surface = sea.elevation(t, &V3::new(20.0, -5.0, 0.0));
        assert!((place(&scene, t) - V3::new(20.0, 5.0, surface)).norm() < 1e-12);
    }
}
