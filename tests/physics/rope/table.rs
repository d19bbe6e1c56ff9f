//! Tension-strain tables.

use seacable::dynamics::Stepper;
use seacable::physics::rope::TensionTable;
use seacable::scene::Scene;
use seacable::solve::State;

use crate::{march, rest};

/// A hanging rope of a table with a body at its end. `ea_n` of the bare rope gives way to the table.
fn hung(table: &str, more: &str) -> Scene {
    rest::build(&format!(
        "materials.rope = {{ ea_n = \"\", {table} }}\n\
         ends.b = {{ name = \"bob\", kind = \"payload\" }}\n\
         payload = {{ dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}\n{more}"
    ))
}

const STRAIN: [f64; 4] = [0.0, 0.01, 0.03, 0.06];
const TENSION: [f64; 4] = [0.0, 2e3, 1.2e4, 6e4];
const WORDS: &str = "strain = [0.0, 0.01, 0.03, 0.06], tension_n = [0.0, 2e3, 1.2e4, 6e4]";

/// Every segment stretches by what the table says of the weight below its middle.
#[test]
fn a_hanging_rope_is_as_long_as_its_table_says() {
    let scene = hung(WORDS, "");
    let state = rest::at_rest(&scene);
    let table = TensionTable::new(&STRAIN, &TENSION).unwrap();
    let mut z = 0.0;
    for i in 0..10 {
        let tension = 9.80665 * (1000.0 + 2.0 * (95.0 - 10.0 * f64::from(i)));
        z -= 10.0 * (1.0 + table.strain_at(tension));
        assert!((state.x[usize::try_from(i).unwrap() + 1].z - z).abs() < 1e-8);
    }
    assert!(z < -102.0, "the rope stretches: {z}");
}

/// A table whose points lie on a straight line is a stiffness, at rest and in motion.
#[test]
fn a_straight_table_is_a_stiffness() {
    let more = "start = { shape = \"straight\", elevation_deg = -40.0 }";
    let body = "ends.b = { name = \"bob\", kind = \"payload\" }\n\
         payload = { dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }\n";
    let by_table = hung(
        "strain = [0.0, 0.03, 0.1], tension_n = [0.0, 3e4, 1e5]",
        more,
    );
    let by_number = rest::build(&format!("{body}{more}"));
    let end = |scene: &Scene| {
        let mut state = scene.initial_state();
        march::march(
            march::alpha(scene, 0.4),
            scene,
            &mut state,
            (20.0, 0.02),
            |_, _| (),
        );
        state
    };
    let (a, b) = (end(&by_table), end(&by_number));
    for (p, q) in a.x.iter().zip(&b.x) {
        assert!((p - q).norm() < 1e-7, "{p} {q}");
    }
}

/// What a swing loses, as a share of its first kinetic energy.
fn lost(scene: &Scene, method: impl Stepper<Scene>, step: f64) -> f64 {
    let mut state: State = rest::at_rest(scene);
    for (v, s) in state.v.iter_mut().zip(&scene.line.arc) {
        v.x = 0.1 * s;
    }
    let before = scene.energy(&state);
    march::march(method, scene, &mut state, (200.0, step), |_, _| ());
    (before - scene.energy(&state)) / (0.5 * 1000.0 * 100.0)
}

/// The energy that the table stores comes back: a swing without drag keeps what it has.
#[test]
fn a_swing_on_a_table_keeps_its_energy() {
    let scene = hung(WORDS, "line.segments = 5");
    let explicit = lost(&scene, march::rk4(&scene), 0.01);
    assert!(explicit.abs() < 1e-6, "{explicit}");
    let implicit = lost(&scene, march::alpha(&scene, 1.0), 0.02);
    assert!(implicit.abs() < 1e-4, "{implicit}");
}

/// A body bobbing on a rope without mass to speak of: small swings go at the table's slope, not at its secant.
#[test]
fn small_swings_go_at_the_slope() {
    let scene = hung(
        &format!("mass_kg_per_m = 0.001, {WORDS}"),
        "line.segments = 1",
    );
    let mut state = rest::at_rest(&scene);
    state.v[1].z = 0.01;
    let middle = state.x[1].z;
    let mut crossings: Vec<f64> = Vec::new();
    let mut before = (0.0, 1.0);
    march::march(
        march::rk4(&scene),
        &scene,
        &mut state,
        (40.0, 0.005),
        |t, s| {
            let z = s.x[1].z - middle;
            if before.1 < 0.0 && z >= 0.0 {
                crossings.push(before.0 + (t - before.0) * before.1 / (before.1 - z));
            }
            before = (t, z);
        },
    );
    let period = (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64;
    let table = TensionTable::new(&STRAIN, &TENSION).unwrap();
    let slope = table.at(table.strain_at(1000.0 * 9.80665)).by_strain;
    let exact = std::f64::consts::TAU * (1000.0 * 100.0 / slope).sqrt();
    assert!((period / exact - 1.0).abs() < 1e-3, "{period} {exact}");
}

/// The explicit limit is that of the steepest part of the table.
#[test]
fn the_explicit_limit_knows_the_steepest_part() {
    let scene = hung(WORDS, "line.segments = 10");
    let (limit, _) = scene.explicit_limit();
    let steepest = TensionTable::new(&STRAIN, &TENSION)
        .unwrap()
        .max_stiffness();
    let exact = 2.785 / (2.0 * 2.0 * steepest / 10.0 / 20.0).sqrt();
    assert!((limit / exact - 1.0).abs() < 1e-9, "{limit} {exact}");
}
