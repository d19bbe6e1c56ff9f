//! The umbilical at rest: what its cases give, and how fast they converge.

use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case, edit};
use seacable::run::job::{self, Request};
use seacable::scene::{self, Scene};
use seacable::solve::State;
use seacable::statics::equilibrium::{Equilibrium, EquilibriumSearch};

const WAVE: &str = include_str!("../../cases/umbilical/steep_wave.toml");

fn set(edits: &[(&str, &str)]) -> Case {
    let text = edit::set_all(WAVE, edits).unwrap();
    case::parse(&text, "steep_wave.toml").unwrap()
}

fn catenary() -> Case {
    let text = include_str!("../../cases/umbilical/catenary.toml");
    case::parse(text, "catenary.toml").unwrap()
}

fn rest(case: &Case, coarsening: usize) -> (Scene, State, Equilibrium) {
    let scene = scene::build(case, coarsening).unwrap();
    let mut state = scene.initial_state();
    let found = EquilibriumSearch::default()
        .run(&scene, 0.0, &mut state)
        .unwrap();
    (scene, state, found)
}

/// Every second, fourth, .. node of a mesh, the ones that all meshes share.
fn shared<T: Copy>(values: &[T], every: usize) -> Vec<T> {
    values.iter().copied().step_by(every).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let far = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    far.fold(0.0, f64::max)
}

/// Coordinates, tensions and moments on the nodes of the coarsest mesh.
fn on_coarsest(case: &Case, coarsening: usize, coarsest: usize) -> [Vec<f64>; 3] {
    let (scene, state, _) = rest(case, coarsening);
    let every = coarsest / coarsening;
    let places = shared(&state.x, every);
    let moments = scene
        .elements
        .flexure
        .as_ref()
        .unwrap()
        .moments(&scene.line, &state);
    [
        places.iter().flat_map(|p| [p.x, p.z]).collect(),
        shared(&scene.tensions(&state), every),
        shared(&moments, every),
    ]
}

#[test]
fn shape_tension_and_moment_converge_with_the_square_of_the_segment() {
    let case = set(&[
        ("line.lower.segments", "80"),
        ("line.buoyant.segments", "160"),
        ("line.upper.segments", "640"),
    ]);
    let meshes: Vec<[Vec<f64>; 3]> = [8, 4, 2, 1].map(|c| on_coarsest(&case, c, 8)).into();
    for (what, name) in ["shape", "tension", "moment"].into_iter().enumerate() {
        let steps: Vec<f64> = meshes
            .windows(2)
            .map(|pair| distance(&pair[0][what], &pair[1][what]))
            .collect();
        // On the coarsest mesh, of 2 m, the moment is still on its way to its order.
        let order = (steps[1] / steps[2]).log2();
        println!("{name}: order {order:.3}, differences {steps:?}");
        assert!((order - 2.0).abs() < 0.2, "{name}: {steps:?}");
    }
}

#[test]
fn vanishing_bending_stiffness_is_none() {
    let bare = rest(&set(&[("materials.umbilical.ei_n_m2", "0.0")]), 1).1;
    let mut before = f64::INFINITY;
    for ei in ["1000.0", "100.0", "10.0", "1.0"] {
        let state = rest(&set(&[("materials.umbilical.ei_n_m2", ei)]), 1).1;
        let away = state.x.iter().zip(&bare.x).map(|(a, b)| (a - b).norm());
        let off = away.fold(0.0, f64::max);
        println!("EI = {ei} N m2: {off:.3e} m from the line without");
        assert!(off < before, "EI = {ei}: {off} m");
        before = off;
    }
    assert!(before < 1e-3, "{before} m with 1 N m2");
}

#[test]
fn the_line_is_never_folded_whatever_the_float() {
    for diameter in ["0.25", "0.28", "0.3", "0.32", "0.35", "0.38", "0.4", "0.45"] {
        for coarsening in [1, 2, 4] {
            let case = set(&[("modules.buoyant.diameter_m", diameter)]);
            let (scene, state, _) = rest(&case, coarsening);
            let folded = scene
                .elements
                .flexure
                .as_ref()
                .unwrap()
                .kinked_node(&scene.line, &state);
            assert_eq!(folded, None, "{diameter} m, mesh by {coarsening}");
            let greatest = scene.tensions(&state).into_iter().fold(0.0, f64::max);
            assert!(greatest < 5e4, "{diameter} m: {greatest} N");
        }
    }
}

#[test]
fn a_vessel_out_of_plane_takes_the_line_along() {
    let (_, state, _) = rest(&set(&[("ends.b.position_m.y", "10.0")]), 1);
    let sideways: Vec<f64> = state.x.iter().map(|p| p.y).collect();
    assert!((sideways[sideways.len() - 1] - 10.0).abs() < 1e-9);
    assert!(sideways.windows(2).all(|pair| pair[1] > pair[0] - 1e-9));
}

/// Told, not judged: machines differ.
#[test]
fn how_long_a_cold_start_takes() {
    for (name, case) in [("steep wave", set(&[])), ("catenary", catenary())] {
        let scene = scene::build(&case, 1).unwrap();
        let start = scene.initial_state();
        let mut fastest = std::time::Duration::MAX;
        let mut iterations = 0;
        for _ in 0..20 {
            let mut state = start.clone();
            let clock = std::time::Instant::now();
            iterations = EquilibriumSearch::default()
                .run(&scene, 0.0, &mut state)
                .unwrap()
                .iterations;
            fastest = fastest.min(clock.elapsed());
        }
        println!(
            "{name}: {fastest:?} for {} segments, {iterations} iterations",
            scene.line.segments.len()
        );
    }
}

#[test]
fn the_catenary_lies_on_the_bed_and_rises_to_the_vessel() {
    let (_, state, _) = rest(&catenary(), 1);
    let lying = state.x.iter().filter(|p| p.z < -129.9).count();
    assert!((10..120).contains(&lying), "{lying} nodes");
    assert!(state.x.windows(2).all(|pair| pair[1].z > pair[0].z - 0.01));
}

#[test]
fn exceeded_limits_are_reported() {
    let run = |edits: &[(&str, &str)]| {
        let text = edit::set_all(WAVE, edits).unwrap();
        let request = Request {
            case: case::parse(&text, "steep_wave.toml").unwrap(),
            text,
            file: "steep_wave.toml".to_owned(),
            overrides: Vec::new(),
            id: String::new(),
        };
        job::execute(&request, &AtomicBool::new(false), &mut |_| ())
    };
    assert!(run(&[]).info.warnings.is_empty());
    let run = run(&[
        ("materials.umbilical.break_load_n", "1.5e4"),
        ("materials.umbilical.min_bend_radius_m", "20.0"),
    ]);
    let reported = &run.info.warnings;
    assert_eq!(reported.len(), 2, "{reported:?}");
    assert!(
        reported[0].contains("section `buoyant` is bent more sharply"),
        "{reported:?}"
    );
    assert!(
        reported[1].contains("section `upper` is loaded beyond"),
        "{reported:?}"
    );
    let named = |name: &str| run.quantity(name).unwrap();
    let (radius, curvature) = (named("bend_radius_m.min"), named("curvature_per_m.max"));
    assert!((radius.value * curvature.value - 1.0).abs() < 1e-12);
    // It lies where the floats end and the load jumps.
    assert!(radius.mesh_error.unwrap() < 0.05 * radius.value);
    assert_eq!(named("moment_nm.max").unit(), "N m");
    assert!((named("tension_n.arc_of_max").value - 220.0).abs() < 1e-9);
}

/// Volume and mass per length of floats and cable are kept (eqs 20 and 21 of Lin et al. 2016), and so is drag.
#[test]
fn floats_are_spread_by_volume_and_mass() {
    let (scene, ..) = rest(&set(&[("modules.buoyant.diameter_m", "0.35")]), 1);
    let (dp, df, filled, rho): (f64, f64, f64, f64) = (0.0941, 0.35, 0.75, 1025.0);
    let od = ((df * df - dp * dp) * filled + dp * dp).sqrt();
    let volume = std::f64::consts::FRAC_PI_4 * (od * od - dp * dp);
    let [bare, floated] = [10, 40].map(|i| scene.line.segments[i]);
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    let per_metre = 2.0 / bare.axial.length;
    near(
        per_metre * (floated.half_mass - bare.half_mass),
        volume * 400.0,
    );
    near(
        per_metre * (bare.half_weight - floated.half_weight),
        volume * (rho - 400.0) * 9.80665,
    );
    near(
        per_metre * (floated.added.normal - bare.added.normal),
        volume * rho,
    );
    near(floated.drag.floats, 0.5 * rho * 1.0 * df * filled);
    near(floated.drag.normal, 0.25 * bare.drag.normal);
}
