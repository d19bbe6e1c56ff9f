//! The same line gives the same numbers however often it is computed, on however many threads, and wherever and
//! whichever way round it lies.

use crate::{march, rest};
use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::dynamics::Stepper;
use seacable::numerics::V3;
use seacable::physics::CurrentProfile;
use seacable::physics::motion::MotionPath;
use seacable::run::job::{Request, execute};
use seacable::scene::{EndCondition, Scene};
use seacable::solve::State;

/// Everything a run of the manifold computes, its error estimates too, in digits that tell every bit.
fn manifold_in_digits(threads: usize) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/pendulous/manifold.toml");
    let mut case = case::load(&path).unwrap().case;
    case.solver.duration_s = 40.0;
    let request = Request {
        case,
        text: String::new(),
        file: "manifold.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap();
    let run = pool.install(|| execute(&request, &AtomicBool::new(false), &mut |_| {}));
    assert!(
        run.summary
            .iter()
            .any(|q| q.time_error.is_some() && q.mesh_error.is_some())
    );
    format!(
        "{:?} {:?} {:?} {:?} {:?}",
        run.info.work,
        run.summary,
        run.history,
        run.shapes,
        run.profile()
    )
}

#[test]
fn the_same_bits_every_time_and_on_any_number_of_threads() {
    let once = manifold_in_digits(1);
    for threads in [1, 2, 3, 8] {
        assert!(manifold_in_digits(threads) == once, "{threads} threads");
    }
}

/// A payload on a line in a current that turns with depth, swung by its upper end and never slack: where a line
/// snaps, roundings grow until they show.
const SWINGING: &str = r#"
    environment.water_density_kg_per_m3 = 1025.0
    current = { speed_m_per_s = [1.5, 0.3], direction_deg = [20.0, 110.0], depth_m = [0.0, 100.0] }
    materials.rope = { mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0, axial_damping_ratio = 0.02 }
    ends.b = { name = "bob", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = 3.0, added_mass_kg = 500.0 }
    ends.a = { kind = "moving", amplitude_m = [4.0, 2.0, 1.0], period_s = 9.0, ramp_s = 9.0 }
"#;

/// The line with every vector of it mapped.
fn mapped(scene: &Scene, place: impl Fn(&V3) -> V3, turn: impl Fn(&V3) -> V3) -> Scene {
    let mut scene = scene.clone();
    scene.start.positions.iter_mut().for_each(|x| *x = place(x));
    for end in &mut scene.line.ends {
        if let EndCondition::Prescribed(motion) = end {
            motion.position = place(&motion.position);
            if let MotionPath::Harmonic(swing) = &mut motion.course {
                swing.amplitude = turn(&swing.amplitude);
            }
        }
    }
    if let CurrentProfile::Table { velocity, .. } = &mut scene.line.current {
        velocity.iter_mut().for_each(|v| *v = turn(v));
    }
    scene
}

const STEPS: (f64, f64) = (20.0, 0.01);

/// Tensions of all nodes at all steps [N].
fn tensions(scene: &Scene, method: impl Stepper<Scene>) -> Vec<Vec<f64>> {
    let mut all = Vec::new();
    march::march(
        method,
        scene,
        &mut scene.initial_state(),
        STEPS,
        |_, state: &State| {
            all.push(scene.tensions(state));
        },
    );
    all
}

/// Tensions while it swings, by both methods, and at rest.
fn all(scene: &Scene) -> [Vec<Vec<f64>>; 3] {
    [
        tensions(scene, march::rk4(scene)),
        tensions(scene, march::alpha(scene, 0.4)),
        vec![scene.tensions(&rest::at_rest(scene))],
    ]
}

/// Greatest difference as a share of the greatest tension.
fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    let (worst, greatest) = pairs.fold((0.0_f64, 0.0_f64), |(worst, greatest), (p, q)| {
        (worst.max((p - q).abs()), greatest.max(p.abs()))
    });
    assert!(greatest > 1e3);
    worst / greatest
}

/// A sign costs no rounding: the mirror image has the same tensions to the last bit.
#[test]
fn a_mirrored_line_is_its_mirror_image() {
    let scene = rest::build(SWINGING);
    let expected = all(&scene);
    for signs in [V3::new(-1.0, 1.0, 1.0), V3::new(1.0, -1.0, 1.0)] {
        let mirror = |v: &V3| v.component_mul(&signs);
        assert!(
            all(&mapped(&scene, mirror, mirror)) == expected,
            "{signs:?}"
        );
    }
}

#[test]
fn a_turned_line_has_the_same_tensions() {
    let scene = rest::build(SWINGING);
    let expected = all(&scene);
    let turn = nalgebra::Rotation3::from_axis_angle(&V3::z_axis(), 37_f64.to_radians());
    let turned = all(&mapped(&scene, |v| turn * v, |v| turn * v));
    for (a, b) in turned.iter().zip(&expected) {
        let apart = apart(a, b);
        assert!(apart < 1e-9, "{apart}");
    }
}

/// Positions of 1e6 m are rounded to 2⁻³⁴ m = 5.8e-11 m either way, and a segment's tension with them to EA/l times
/// twice that. The steps add up their roundings at random: after n of them sqrt(n) times as much.
#[test]
fn a_line_far_away_has_the_same_tensions() {
    let scene = rest::build(SWINGING);
    let expected = all(&scene);
    let far = V3::new(1e6, -1e6, 0.0);
    let shifted = all(&mapped(&scene, |x| x + far, |v| *v));
    let rounding = 2f64.powi(-34) * 2.0 * 1e6 / 10.0;
    let steps: f64 = STEPS.0 / STEPS.1;
    let greatest = expected[0]
        .iter()
        .flatten()
        .fold(0.0, |a: f64, b| a.max(*b));
    let tolerance = 1e-9 + steps.sqrt() * rounding / greatest;
    for (a, b) in shifted.iter().zip(&expected) {
        let apart = apart(a, b);
        assert!(apart < tolerance, "{apart}, {tolerance}");
    }
}
