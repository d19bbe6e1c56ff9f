//! Equilibrium of the discretised line: what it reports, and what it is held against.
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use lines::line;
use seacable::linalg::V3;
use seacable::scene::{self, Scene};
use seacable::solve::{State, System};
use seacable::statics::equilibrium::Search;

mod lines;

fn build(changes: &str) -> Scene {
    scene::build(&line(changes), 1).unwrap()
}

fn at_rest(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    Search::default().run(scene, 0.0, &mut state).unwrap();
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
        assert_eq!(scene.clumps, [6]);
        let state = at_rest(&scene);
        let mut residual = vec![V3::zeros(); scene.nodes()];
        scene.residual(0.0, &state, &mut residual);
        for node in [0, scene.nodes() - 1] {
            let pull = scene.end_force(node, &state);
            assert!((pull + residual[node]).norm() < 1e-9 * pull.norm());
        }
    }
}
