//! The umbilical at rest: what its cases give, and how fast they converge.
#![expect(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test may panic"
)]

use seacable::case::{self, Case, edit};
use seacable::scene::{self, Scene};
use seacable::solve::State;
use seacable::statics::equilibrium::{Found, Search};

const WAVE: &str = include_str!("../cases/umbilical/steep_wave.toml");

fn set(edits: &[(&str, &str)]) -> Case {
    let text = edit::set_all(WAVE, edits).unwrap();
    case::parse(&text, "steep_wave.toml").unwrap()
}

fn rest(case: &Case, coarsening: usize) -> (Scene, State, Found) {
    let scene = scene::build(case, coarsening).unwrap();
    let mut state = scene.initial_state();
    let found = Search::default().run(&scene, 0.0, &mut state).unwrap();
    (scene, state, found)
}

#[test]
fn probe() {
    for od in ["0.28", "0.3", "0.32", "0.35", "0.38", "0.4", "0.45"] {
        for c in [1, 2, 4] {
            let case = set(&[("modules.buoyant.diameter_m", od)]);
            let scene = scene::build(&case, c).unwrap();
            let mut state = scene.initial_state();
            let clock = std::time::Instant::now();
            let found = Search::default().run(&scene, 0.0, &mut state);
            println!("{od} {c} {:?} {found:?}", clock.elapsed());
        }
    }
    for ei in ["0.0", "1.0", "100.0", "2860.0", "1e4"] {
        let case = set(&[("materials.umbilical.ei_n_m2", ei)]);
        let scene = scene::build(&case, 1).unwrap();
        let mut state = scene.initial_state();
        let clock = std::time::Instant::now();
        let found = Search::default().run(&scene, 0.0, &mut state);
        println!("EI {ei} {:?} {found:?}", clock.elapsed());
    }
}
