//! Lines that bend, against closed forms: the elastica, beams, buckling, clamps, and the order in segment length.
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use seacable::case;
use seacable::linalg::V3;
use seacable::scene::{self, Scene};
use seacable::solve::State;
use seacable::statics::equilibrium::Search;

/// A rod of length 10 m along x from a clamp at the origin, in no water, with a load at its tip. EI = 100 N m².
fn cantilever(segments: usize, tip_load_n: f64, weight_n_per_m: f64) -> (Scene, State) {
    let text = format!(
        r#"
[case]
title = "cantilever"
[environment]
gravity_m_per_s2 = 10.0
water_density_kg_per_m3 = 0.0
[materials.rod]
diameter_m = 0.05
mass_kg_per_m = 1.0
wet_weight_kg_per_m = {weight}
ea_n = 1.0e7
ei_n_m2 = 100.0
[[line]]
name = "rod"
material = "rod"
length_m = 10.0
segments = {segments}
[ends.a]
name = "wall"
kind = "fixed"
position_m = [0, 0, 0]
clamp_elevation_deg = 0.0
[ends.b]
name = "tip"
kind = "payload"
[payload]
dry_mass_kg = {load}
drag_area_m2 = 0.0
added_mass_kg = 0.0
wet_mass_kg = {load}
[start]
shape = "straight"
"#,
        weight = weight_n_per_m / 10.0,
        load = (tip_load_n / 10.0).max(1e-9),
    );
    let scene = scene::build(&case::parse(&text, "cantilever.toml").unwrap(), 1).unwrap();
    let mut state = scene.initial_state();
    Search::default().run(&scene, 0.0, &mut state).unwrap();
    (scene, state)
}

fn tip(segments: usize, load: f64) -> V3 {
    let (_, state) = cantilever(segments, load, 0.0);
    *state.x.last().unwrap()
}

/// Deflection w/L and shortening u/L of a cantilever under a tip load P, by elliptic integrals, for P L²/EI.
const ELASTICA: [(f64, f64, f64); 6] = [
    (0.2, 0.066_364_5, 0.002_646_5),
    (1.0, 0.301_720_8, 0.056_433_2),
    (2.0, 0.493_457_5, 0.160_641_7),
    (5.0, 0.713_791_5, 0.387_628_4),
    (10.0, 0.810_609_0, 0.554_995_6),
    (20.0, 0.868_695_9, 0.683_885_6),
];

#[test]
fn cantilever_elastica_under_tip_load() {
    for (load, w, u) in ELASTICA {
        // P L²/EI = P with these numbers; order 2, so two meshes extrapolate.
        let (coarse, fine) = (tip(80, load), tip(160, load));
        let p = fine + (fine - coarse) / 3.0;
        // Axial compression and stretch: P/EA L at most 2e-5 m.
        assert!(
            (-p.z / 10.0 - w).abs() < 5e-6,
            "{load}: {} {w}",
            -p.z / 10.0
        );
        assert!(
            (1.0 - p.x / 10.0 - u).abs() < 5e-6,
            "{load}: {} {u}",
            1.0 - p.x / 10.0
        );
    }
}

#[test]
fn the_elastica_converges_with_the_square_of_the_segment() {
    let (_, w, _) = ELASTICA[3];
    let errors: Vec<f64> = [10, 20, 40, 80]
        .iter()
        .map(|n| (-tip(*n, 5.0).z / 10.0 - w).abs())
        .collect();
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}");
    }
}

#[test]
fn euler_bernoulli_beam_under_its_weight() {
    // w = q L⁴ / (8 EI), root moment q L² / 2: so light that the deflection is a thousandth of the length.
    let q = 8.0 * 100.0 * 0.01 / 1e4;
    let (scene, state) = cantilever(160, 0.0, q);
    let deflection = -state.x.last().unwrap().z;
    assert!((deflection - 0.01).abs() < 1e-5, "{deflection}");
    let moment = scene.flexure.as_ref().unwrap().moments(&scene, &state)[0];
    assert!((moment - q * 50.0).abs() < 1e-4 * q * 50.0, "{moment}");
}

/// A rod between two hinges, pushed together by `push` metres, in no water, with a slight weight to choose a side.
fn pushed(push: f64) -> (Scene, State) {
    let text = format!(
        r#"
[case]
title = "strut"
[environment]
water_density_kg_per_m3 = 0.0
[materials.rod]
diameter_m = 0.05
mass_kg_per_m = 1.0
wet_weight_kg_per_m = 1.0e-6
ea_n = 1.0e7
ei_n_m2 = 100.0
[[line]]
name = "rod"
material = "rod"
length_m = 10.0
segments = 100
[ends.a]
name = "a"
kind = "fixed"
position_m = [0, 0, 0]
[ends.b]
name = "b"
kind = "fixed"
position_m = [{}, 0, 0]
"#,
        10.0 - push
    );
    let scene = scene::build(&case::parse(&text, "strut.toml").unwrap(), 1).unwrap();
    let mut state = scene.initial_state();
    Search::default().run(&scene, 0.0, &mut state).unwrap();
    (scene, state)
}

#[test]
fn a_strut_buckles_at_eulers_load() {
    // pi² EI / L² = 9.8696 N; past it the load grows by 1 + (pi a / L)² / 8 with the amplitude a, here about 1e-3.
    let (scene, state) = pushed(0.01);
    let load = -scene.tension_at(50, &state);
    let euler = std::f64::consts::PI.powi(2) * 100.0 / 100.0;
    assert!((load / euler - 1.0).abs() < 2e-3, "{load} against {euler}");
    let sag = state.x[50].z.abs();
    // Shortening is (pi a)² / (4 L).
    assert!(
        (sag - (4.0 * 10.0 * 0.01_f64).sqrt() / std::f64::consts::PI).abs() < 1e-3,
        "{sag}"
    );
}
