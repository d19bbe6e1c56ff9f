//! Equilibrium of the discretised line: what it reports, and what it is held against.

use std::sync::atomic::AtomicBool;

use crate::lines;
use crate::lines::line;
use seacable::numerics::V3;
use seacable::scene::{self, Scene};
use seacable::solve::{Kinematics, Residual, State};
use seacable::statics::equilibrium::{EquilibriumSearch, instabilities};

fn build(changes: &str) -> Scene {
    scene::build(&line(changes), 1).unwrap()
}

fn at_rest(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(scene, 0.0, &mut state)
        .unwrap();
    state
}

const BETWEEN_POSTS: &str = r#"
    ends.b = { name = "post", kind = "fixed", position_m = [80.0, 20.0, 10.0] }
    current = { speed_m_per_s = [1.0, 0.2], direction_deg = [90.0, 30.0], depth_m = [0.0, 40.0] }
    environment.water_density_kg_per_m3 = 1025.0
    materials.rope = { mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02 }
    line.segments = 20
"#;

#[test]
fn the_pull_on_an_end_is_all_that_acts_there() {
    let bending = r#"
        materials.rope = { ei_n_m2 = 5e3 }
        ends.a = { clamp_elevation_deg = -20.0, clamp_azimuth_deg = 30.0 }
        seabed = { depth_m = 25.0 }
    "#;
    for more in ["", bending] {
        let clump = r#"clumps = [{ name = "clump", section = "rope", at_m = 30.0, mass_kg = 40.0, wet_mass_kg = 30.0, drag_area_m2 = 0.5 }]"#;
        let case = format!("{clump}\n{BETWEEN_POSTS}");
        let mut table: toml::Table = case.parse().unwrap();
        lines::merge(&mut table, more.parse().unwrap());
        let scene = build(&toml::to_string(&table).unwrap());
        assert_eq!(scene.labels.clumps, [6]);
        let state = at_rest(&scene);
        let mut residual = vec![V3::zeros(); scene.nodes()];
        scene.residual(0.0, &state, &mut residual);
        for node in [0, scene.nodes() - 1] {
            let pull = scene.end_force(node, &state);
            assert!((pull + residual[node]).norm() < 1e-9 * pull.norm());
        }
    }
}

/// 1050 m of line from the floor up to the surface in a uniform current, and the force it pulls on its upper end with, from
/// the differential equations of the stretched line (end point met to 1e-12 of the length).
const IN_CURRENT: [(f64, f64, V3); 4] = [
    (
        0.5,
        90.0,
        V3::new(-70_071.387_205, 19_383.702_669, -219_715.256_532),
    ),
    (
        1.0,
        90.0,
        V3::new(-92_063.688_579, 71_033.797_702, -240_287.132_200),
    ),
    (0.5, 0.0, V3::new(-65_210.013_949, 0.0, -234_919.849_693)),
    (1.0, 0.0, V3::new(-58_389.295_970, 0.0, -286_067.434_958)),
];

fn pull_in_current(speed: f64, direction: f64, segments: usize) -> V3 {
    let scene = build(&format!(
        r#"
        environment = {{ gravity_m_per_s2 = 10.0, water_density_kg_per_m3 = 1025.0 }}
        current = {{ speed_m_per_s = {speed}, direction_deg = {direction} }}
        materials.rope = {{ diameter_m = 0.2, mass_kg_per_m = 60.0, wet_weight_kg_per_m = 20.0, ea_n = 1e9, drag_normal = 1.2 }}
        line = {{ length_m = 1050.0, segments = {segments} }}
        ends.a = {{ position_m = [-600.0, 0.0, -800.0] }}
        ends.b = {{ name = "vessel", kind = "fixed", position_m = [0.0, 0.0, 0.0] }}
        "#
    ));
    scene.end_force(segments, &at_rest(&scene))
}

#[test]
fn end_forces_in_a_current_converge_with_the_square_of_the_segment() {
    for (speed, direction, expected) in IN_CURRENT {
        let pulls = [25, 50, 100, 200].map(|n| pull_in_current(speed, direction, n));
        let errors = pulls.map(|pull| (pull - expected).norm() / expected.norm());
        assert!(errors[2] < 1e-4, "{errors:?}");
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((order - 2.0).abs() < 0.05, "{errors:?}");
        }
        let extrapolated = pulls[3] + (pulls[3] - pulls[2]) / 3.0;
        assert!(
            (extrapolated - expected).norm() < 1e-7 * expected.norm(),
            "{}",
            (extrapolated - expected).norm() / expected.norm()
        );
    }
}

/// Both ends of a rod clamped at a right angle to each other where a quarter circle ends: pure bending, the moment
/// `(pi/2) EI / L` everywhere and no force, as under a moment at its end.
#[test]
fn a_pure_bend_is_a_quarter_circle() {
    let (length, ei) = (10.0, 100.0);
    let moment = std::f64::consts::FRAC_PI_2 * ei / length;
    let reach = length / std::f64::consts::FRAC_PI_2;
    let errors = [20, 40, 80].map(|segments| {
        let scene = build(&format!(
            r#"
            environment.gravity_m_per_s2 = 0.0
            materials.rope = {{ ea_n = 1e7, ei_n_m2 = {ei} }}
            line = {{ length_m = {length}, segments = {segments} }}
            ends.a = {{ clamp_elevation_deg = 0.0 }}
            ends.b = {{ name = "b", kind = "fixed", position_m = [{reach}, 0.0, {reach}], clamp_elevation_deg = 90.0 }}
            "#
        ));
        let state = at_rest(&scene);
        let moments = scene.elements.flexure.as_ref().unwrap().moments(&scene.line, &state);
        let off = moments.iter().map(|m| (m / moment - 1.0).abs());
        let force = scene.end_force(0, &state).norm() * length / moment;
        off.fold(force, f64::max)
    });
    assert!(errors[2] < 3e-3, "{errors:?}");
    for pair in errors.windows(2) {
        assert!(((pair[0] / pair[1]).log2() - 2.0).abs() < 0.1, "{errors:?}");
    }
}

/// A rod that stands on its clamp under a weight: Euler's load of it is pi² EI / (4 L²) = 2.467 N. Above it the straight
/// rod is still an equilibrium, and one that it leaves in two directions.
#[test]
fn an_unstable_equilibrium_is_distinguished_from_a_stable_one() {
    for (load, ways) in [(2.4, 0), (2.55, 2)] {
        let mut scene = build(
            r#"
            environment.gravity_m_per_s2 = 0.0
            materials.rope = { ea_n = 1e7, ei_n_m2 = 100.0 }
            line = { length_m = 10.0, segments = 60 }
            ends.a = { clamp_elevation_deg = 90.0 }
            start = { shape = "straight", elevation_deg = 90.0 }
            "#,
        );
        // A load that presses exactly along the rod.
        *scene.line.weight.last_mut().unwrap() = load;
        let state = at_rest(&scene);
        assert_eq!(instabilities(&scene, 0.0, &state), Some(ways), "{load}");
    }
}

/// In all that follows Newton as well: pseudo-time, and the bed without friction.
#[test]
fn a_search_that_is_stopped_ends_at_once() {
    let rough = "seabed = { depth_m = 25.0, friction = 0.8 }";
    let scene = build(&format!("{BETWEEN_POSTS}\n{rough}"));
    let mut state = scene.initial_state();
    let guess = state.x.clone();
    let (stop, free) = (AtomicBool::new(true), AtomicBool::new(false));
    let search = |stop| EquilibriumSearch {
        stop: Some(stop),
        ..EquilibriumSearch::default()
    };
    let error = search(&stop).run(&scene, 0.0, &mut state).unwrap_err();
    assert!(error.stopped && error.iterations == 0, "{error}");
    assert!(error.to_string().contains("it was stopped"), "{error}");
    assert_eq!(state.x, guess);
    search(&free).run(&scene, 0.0, &mut state).unwrap();
    assert_eq!(state.x, at_rest(&scene).x);
}
