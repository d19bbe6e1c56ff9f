//! Lines and where they come to rest.

use seacable::scene::{self, Scene};
use seacable::solve::State;
use seacable::statics::equilibrium::EquilibriumSearch;

use super::lines;

/// The scene of the bare rope with changes.
pub(crate) fn build(changes: &str) -> Scene {
    scene::build(&lines::line(changes), 1).unwrap()
}

/// The line in equilibrium.
pub(crate) fn at_rest(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(scene, 0.0, &mut state)
        .unwrap();
    state
}
