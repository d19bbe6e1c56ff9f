//! Time of one discretised line of 100 segments at rest in a current: from cold (scene, first guess, Newton), and from its
//! neighbour after a small change of one number. Run with `cargo bench --bench statics`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use seacable::case::{self, Case};
use seacable::scene::{self, Scene};
use seacable::solve::State;
use seacable::statics::equilibrium::EquilibriumSearch;

/// 1050 m of line up to a vessel, in a current that turns and grows towards the surface.
const LINE: &str = r#"
[case]
title = "line in a sheared current"
[current]
depth_m = [0.0, 200.0, 800.0]
speed_m_per_s = [1.2, 0.7, 0.2]
direction_deg = [60.0, 30.0, 0.0]
[materials.line]
diameter_m = 0.2
mass_kg_per_m = 52.6
ea_n = 1.0e9
drag_normal = 1.2
drag_tangential = 0.01
[[line]]
name = "line"
material = "line"
length_m = 1050.0
segments = 100
[ends.a]
name = "anchor"
kind = "anchor"
position_m = [-600.0, 0.0, -800.0]
[ends.b]
name = "vessel"
kind = "fixed"
position_m = [0.0, 0.0, 0.0]
[solver]
method = "static"
"#;

/// What is changed of the line, in the words of the case.
const KINDS: [(&str, &[(&str, &str)]); 5] = [
    ("sheared current", &[]),
    ("still water", &[("[1.2, 0.7, 0.2]", "[0.0, 0.0, 0.0]")]),
    (
        "light line",
        &[("mass_kg_per_m = 52.6", "mass_kg_per_m = 34.0")],
    ),
    (
        "on the bed",
        &[
            ("[case]", "[seabed]\ndepth_m = 800.0\n[case]"),
            ("length_m = 1050.0", "length_m = 1200.0"),
        ],
    ),
    (
        "bending",
        &[("ea_n = 1.0e9", "ea_n = 1.0e9\nei_n_m2 = 1.0e6")],
    ),
];

fn case_of(changes: &[(&str, &str)]) -> Case {
    let mut text = LINE.to_owned();
    for (old, new) in changes {
        assert!(text.contains(old));
        text = text.replacen(old, new, 1);
    }
    case::parse(&text, "statics.toml").unwrap()
}

fn solve(scene: &Scene, state: &mut State) -> u64 {
    let found = EquilibriumSearch::default().run(scene, 0.0, state).unwrap();
    found.iterations
}

fn statics(c: &mut Criterion) {
    for (name, changes) in KINDS {
        let case = case_of(changes);
        let scene = scene::build(&case, 1).unwrap();
        let mut at_rest = scene.initial_state();
        let cold = solve(&scene, &mut at_rest);
        // A change as a keystroke makes it: the last digit of the length.
        let mut changed = case.clone();
        changed.line[0].length_m += 1.0;
        let next = scene::build(&changed, 1).unwrap();
        let warm = solve(&next, &mut at_rest.clone());
        println!("{name}: {cold} iterations from cold, {warm} from its neighbour");
        c.bench_function(&format!("statics/{name}, cold"), |b| {
            b.iter(|| {
                let scene = scene::build(black_box(&case), 1).unwrap();
                let mut state = scene.initial_state();
                solve(&scene, &mut state)
            });
        });
        c.bench_function(&format!("statics/{name}, warm"), |b| {
            b.iter(|| {
                let mut state = at_rest.clone();
                solve(black_box(&next), &mut state)
            });
        });
        c.bench_function(&format!("statics/{name}, scene only"), |b| {
            b.iter(|| scene::build(black_box(&case), 1).unwrap());
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = statics
}
criterion_main!(benches);
