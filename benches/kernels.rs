//! What one node costs in the kernels of dynamics, on one core: a Newton iteration, all in (residual, exact tangent,
//! factorization, solution, update), and the explicit evaluation of forces and accelerations, each as the least of many short
//! repeats, so that other work on the machine does not count. Three lines: one in open water, one half on a bed with friction,
//! and one that bends. Then what a line between held ends costs that is solved again for another place of an end, and what it costs
//! to read the waves at a node. Run with `cargo bench --bench kernels`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

use std::hint::black_box;
use std::time::Instant;

use seacable::case::{self, Case, EndKind};
use seacable::line_between_ends::LineBetweenEnds;
use seacable::numerics::{BlockBand, V3};
use seacable::physics::sea::{
    DepthDecay, KeptPlaces, Sea, SeaClock, SeaReader, Spectrum, Stretching, WaveField, WaveLoad,
    WaveSettings, synthesise,
};
use seacable::scene::{self, Scene};
use seacable::solve::{ExplicitRhs, Factors, Kinematics, Newton, Residual, State};
use seacable::statics::equilibrium::EquilibriumSearch;

const MANIFOLD: &str = include_str!("../cases/pendulous/manifold.toml");
const CHAIN: &str = include_str!("../cases/benchmarks/lindahl_chain.toml");
const RISER: &str = include_str!("../cases/benchmarks/current_across.toml");

/// Repeats of a measurement, and evaluations in each.
const REPEATS: usize = 1000;
const EVALUATIONS: usize = 50;

fn main() {
    println!(
        "{:<30} {:>5} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}",
        "ns per node", "nodes", "residual", "tangent", "solution", "update", "Newton", "explicit"
    );
    let manifold = case::parse(MANIFOLD, "manifold.toml").unwrap();
    row("open water", &scene_of(&manifold), &factors(0.5), swinging);
    let chain = case::parse(CHAIN, "lindahl_chain.toml").unwrap();
    row(
        "half on a bed with friction",
        &scene_of(&chain),
        &factors(0.01),
        at_rest,
    );
    let mut bending = manifold;
    for material in bending.materials.values_mut() {
        material.ei_n_m2 = 1e4;
    }
    row("bending", &scene_of(&bending), &factors(0.5), swinging);
    println!(
        "\n{:<30} {:>5} {:>9} {:>10} {:>9}",
        "line between ends, warm", "nodes", "ns/node", "iterations", "us"
    );
    let mut riser = case::parse(RISER, "current_across.toml").unwrap();
    warm_row("in a current", &riser);
    for material in riser.materials.values_mut() {
        material.ei_n_m2 = 1e6;
    }
    warm_row("in a current, bending", &riser);
    let mut chain = chain;
    chain.ends.b.kind = EndKind::Fixed;
    warm_row("half on a bed with friction", &chain);
    wave_row();
}

/// A chain of 51 nodes from the bed at 200 m to 14 m below the surface, in 100 components of Hs 6 m and Tp 12 s.
fn wave_row() {
    let components = synthesise(&Spectrum::jonswap(6.0, 12.0, 1.6), 100, 1, 0);
    let setting = WaveSettings {
        direction: 0.3,
        depth: 200.0,
        gravity: 9.81,
        stretching: Stretching::Vertical,
        decay: DepthDecay::Airy,
        ramp: 0.0,
        load: WaveLoad::Morison,
    };
    let sea = Sea::new(vec![WaveField::new(components, &setting)]);
    let nodes: Vec<V3> = (0..=50_u32)
        .map(|node| {
            let along = f64::from(node) / 50.0;
            let rise = ((along - 0.45) / 0.55).max(0.0);
            V3::new(-837.0 + 780.0 * along, 0.0, -200.0 + 186.0 * rise.powf(1.6))
        })
        .collect();
    let (mut clock, mut kept, mut t) = (SeaClock::default(), KeptPlaces::default(), 0.0);
    let mut reading = |kept_ones: bool| {
        best(nodes.len(), || {
            t += 0.07;
            clock.move_to(&sea, t);
            let mut reader = match kept_ones {
                true => SeaReader::Again(&sea, &clock, &mut kept),
                false => SeaReader::Once(&sea, t),
            };
            for (number, place) in nodes.iter().enumerate() {
                black_box(reader.flow(number, place, false));
            }
        })
    };
    let (again, once) = (reading(true), reading(false));
    println!(
        "\n{:<30} {:>5} {:>9} {:>10}\n{:<30} {:>5} {again:>9.1} {once:>10.1}",
        "waves, ns per node and read",
        "nodes",
        "again",
        "for once",
        "100 components",
        nodes.len()
    );
}

/// The time of a solution after end B has moved by a thousandth of the line's length, with end stiffness, positions and tensions.
fn warm_row(name: &str, case: &Case) {
    let mut line = LineBetweenEnds::new(case).unwrap();
    let (a, b) = (
        case.ends.a.position_m.unwrap(),
        case.ends.b.position_m.unwrap(),
    );
    let length: f64 = case.line.iter().map(|s| s.length_m).sum();
    line.solve(a, b).unwrap();
    let (mut sign, mut most) = (1.0, 0);
    let nodes = case.line.iter().map(|s| s.segments).sum::<usize>() + 1;
    let time = best(nodes, || {
        sign = -sign;
        let there = [b[0] + 5e-4 * sign * length, b[1], b[2]];
        let found = line.solve(a, black_box(there)).unwrap();
        most = found.iterations.max(most);
    });
    println!(
        "{name:<30} {nodes:>5} {time:>9.1} {most:>10} {:>9.1}",
        time * nodes as f64 * 1e-3
    );
}

fn scene_of(case: &Case) -> Scene {
    scene::build(case, 1).unwrap()
}

/// Those of generalized-alpha without numerical damping in steps of h seconds.
fn factors(h: f64) -> Factors {
    Factors {
        mass: 4.0 / (h * h),
        damping: 2.0 / h,
        stiffness: 1.0,
    }
}

/// A line part of the way down, moving.
fn swinging(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    for i in 0..scene.nodes() {
        let s = i as f64;
        state.x[i].z -= 0.3 * s * s;
        state.v[i] = V3::new(0.5, 0.01 * s, -0.08 * s);
    }
    scene.accelerate(0.0, &mut state);
    state
}

/// A line at rest, whose free part is set in motion.
fn at_rest(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(scene, 0.0, &mut state)
        .unwrap();
    let bed = scene.elements.bed.as_ref().unwrap();
    let mut borne = 0;
    for i in scene.free() {
        if bed.height(&state.x[i]) > 0.0 {
            state.v[i] = V3::new(0.02, 0.03, -0.01);
        } else {
            borne += 1;
        }
    }
    assert!((0.3..0.7).contains(&(f64::from(borne) / scene.nodes() as f64)));
    scene.accelerate(0.0, &mut state);
    state
}

/// A row of the table. The update is what an iteration costs beyond tangent and solution.
fn row(name: &str, scene: &Scene, c: &Factors, state: impl Fn(&Scene) -> State) {
    let (c, nodes) = (*c, scene.nodes());
    let start = state(scene);
    let mut r = vec![V3::zeros(); nodes];
    let mut tangent = BlockBand::new(nodes);
    if scene.is_pentadiagonal() {
        tangent.widen();
    }
    let mut state = start.clone();
    let mut newton = Newton::new(nodes, 1e-9, 10);
    let iteration = best(nodes, || {
        newton
            .iterate(scene, 0.0, black_box(&mut state), c)
            .unwrap();
    });
    let residual = best(nodes, || scene.residual(0.0, &state, black_box(&mut r)));
    let assembly = best(nodes, || {
        scene.linearise(0.0, &state, c, black_box(&mut r), &mut tangent);
    });
    let solved = best(nodes, || {
        scene.linearise(0.0, &state, c, &mut r, &mut tangent);
        tangent.solve(scene.free(), black_box(&mut r)).unwrap();
    });
    let mut state = start;
    let acceleration = best(nodes, || scene.accelerate(0.0, black_box(&mut state)));
    println!(
        "{name:<30} {nodes:>5} {residual:>9.1} {assembly:>9.1} {:>9.1} {:>9.1} {iteration:>9.1} {acceleration:>9.1}",
        solved - assembly,
        iteration - solved,
    );
}

/// The least time of many repeats, by node \[ns\].
fn best(nodes: usize, mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        for _ in 0..EVALUATIONS {
            work();
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    least * 1e9 / (EVALUATIONS * nodes) as f64
}
