//! What a displacement is felt as: no force of the line changes by more, and across the line next to nothing is felt.
//! Newton may leave more across the line than along it where a step's error is controlled; nothing else may notice.

use crate::{lines, rest};
use std::sync::atomic::AtomicBool;

use seacable::numerics::V3;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};
use seacable::scene::Scene;
use seacable::solve::{Kinematics, Residual, StaticSearch};

/// The residual of a line displaced by `d`, at rest.
fn forces(scene: &Scene, d: &[V3]) -> Vec<V3> {
    let mut state = rest::at_rest(scene);
    for (x, d) in state.x.iter_mut().zip(d) {
        *x += d;
    }
    let mut r = vec![V3::zeros(); scene.nodes()];
    scene.residual(0.0, &state, &mut r);
    r
}

/// Stiffness of the stiffest part [N/m], from what "converged on force" means.
fn stiffest(scene: &Scene) -> f64 {
    1e-4 * scene.force_scale() / scene.position_tolerance(1e-4)
}

/// Displacements of a micrometre in changing directions, the ends left where they are.
fn crooked(scene: &Scene) -> Vec<V3> {
    let last = scene.nodes() - 1;
    let of = |i: usize| {
        let s = i as f64;
        V3::new((2.1 * s).sin(), (1.3 * s).cos(), (0.7 * s).sin()) * 1e-6
    };
    (0..=last)
        .map(|i| {
            if i == 0 || i == last {
                V3::zeros()
            } else {
                of(i)
            }
        })
        .collect()
}

const HUNG: &str = r#"ends.b = { kind = "fixed", position_m = [80.0, 0.0, 0.0] }"#;
const BENT: &str = r#"
    materials.rope = { ei_n_m2 = 1e6 }
    ends.a = { clamp_elevation_deg = -60.0 }
    ends.b = { kind = "fixed", position_m = [80.0, 0.0, 0.0] }
"#;
const LAID: &str = r#"
    seabed = { depth_m = 20.0, stiffness_n_per_m3 = 1e5, friction = 0.5 }
    ends.b = { kind = "anchor", position_m = [88.0, 0.0, -20.0] }
"#;

/// At every node two segments and three bends pull, and the bed.
#[test]
fn no_force_changes_by_more_than_is_felt() {
    for changes in [HUNG, BENT, LAID] {
        let scene = rest::build(changes);
        let d = crooked(&scene);
        let none = vec![V3::zeros(); d.len()];
        let pairs = forces(&scene, &d).into_iter().zip(forces(&scene, &none));
        let change = pairs
            .skip(1)
            .take(scene.nodes() - 2)
            .map(|(a, b)| (a - b).amax())
            .fold(0.0, f64::max);
        let felt = stiffest(&scene) * scene.force_norm_displacement(&d, &rest::at_rest(&scene));
        assert!(
            change > 0.0 && change < 6.0 * felt,
            "{changes}: {change} {felt}"
        );
    }
}

/// A node that moves along a straight line is felt in full, one that moves across it by the turn of the tension alone; on
/// the bed both are the same.
#[test]
fn across_a_line_next_to_nothing_is_felt() {
    let scene = rest::build("");
    let state = rest::at_rest(&scene);
    let of = |scene: &Scene, state: &_, d: V3| {
        let mut list = vec![V3::zeros(); scene.nodes()];
        list[5] = d;
        scene.force_norm_displacement(&list, state)
    };
    let along = of(&scene, &state, V3::new(0.0, 0.0, 1e-3));
    let across = of(&scene, &state, V3::new(1e-3, 0.0, 0.0));
    assert!((along / 1e-3 - 1.0).abs() < 0.01, "{along}");
    assert!(across > 0.0 && across < 0.01 * along, "{across} {along}");
    let laid = rest::build(LAID);
    let state = rest::at_rest(&laid);
    let lying = (0..laid.nodes()).rfind(|i| state.x[*i].z < -20.0).unwrap();
    let mut list = vec![V3::zeros(); laid.nodes()];
    list[lying].y = 1e-3;
    assert_eq!(laid.force_norm_displacement(&list, &state), 1e-3);
}

fn run(changes: &str) -> Run {
    let request = Request {
        case: lines::line(changes),
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

/// A payload swinging on a line in water, steps that vary: hardly more than one iteration a step, and what it leaves is no
/// floor to the error, which falls with the error allowed in a step to the power of two thirds.
#[test]
fn the_error_falls_with_the_tolerance_and_steps_take_one_iteration() {
    let swing = |more: &str| {
        run(&format!(
            r#"
            environment.water_density_kg_per_m3 = 1025.0
            materials.rope = {{ drag_normal = 1.2, axial_damping_ratio = 0.05 }}
            ends.b = {{ name = "bob", kind = "payload" }}
            payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 800.0, drag_area_m2 = 0.5, added_mass_kg = 300.0 }}
            start = {{ shape = "straight", elevation_deg = -20.0 }}
            solver = {{ duration_s = 60.0, {more} }}
            "#
        ))
    };
    let exact = swing(r#"method = "rk4""#);
    let error = |tolerance: f64| {
        let run = swing(&format!(
            r#"method = "alpha", step_tolerance = {tolerance:e}"#
        ));
        let work = run.info.work;
        assert!(
            (work.iterations as f64) < 1.6 * work.steps as f64,
            "{tolerance}: {work:?}"
        );
        let of = |name: &str| {
            let values = |run: &Run| run.history.channel(name).unwrap().values.clone();
            let pairs = values(&run).into_iter().zip(values(&exact));
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        of("x_m[bob]").max(of("z_m[bob]"))
    };
    // Steps are halved and doubled: the fall is ragged from one tolerance to the next, not over a wide range.
    let (coarse, fine) = (3.2e-4, 6.25e-7);
    let fall = error(coarse) / error(fine);
    let predicted = (coarse / fine).powf(2.0 / 3.0);
    assert!(
        (0.5..=2.0).contains(&(fall / predicted)),
        "{fall} {predicted}"
    );
}
