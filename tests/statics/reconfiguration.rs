//! The clamped rod in a current against its one-dimensional equation.

use seacable::case::{self, edit};
use seacable::scene;
use seacable::statics::equilibrium::EquilibriumSearch;

use super::cantilever::Cantilever;

/// Drag on the rod by that of the same rod, rigid.
fn drag(speed: f64, float_kg: f64, segments: usize) -> f64 {
    let text = include_str!("../../cases/double_stepped/cantilever.toml");
    let edits = [
        ("current.speed_m_per_s", format!("{speed:?}")),
        ("clumps.float.wet_mass_kg", format!("{:?}", -float_kg)),
        ("line.rod.segments", segments.to_string()),
    ];
    let edits: Vec<(&str, &str)> = edits.iter().map(|(k, v)| (*k, v.as_str())).collect();
    let case = case::parse(&edit::set_all(text, &edits).unwrap(), "cantilever.toml").unwrap();
    let scene = scene::build(&case, 1).unwrap();
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(&scene, 0.0, &mut state)
        .unwrap();
    scene.end_force(0, &state).x / (5.0 * speed * speed)
}

fn equation(speed: f64, float_kg: f64) -> f64 {
    let cantilever = Cantilever {
        drag: 1000.0 * speed * speed,
        lift: 0.0,
        float_lift: float_kg * 9.80665 / 0.005,
        float_at: 1.0,
    };
    cantilever.reconfiguration().unwrap()
}

#[test]
fn the_rod_bends_over_as_its_equation_says() {
    for (speed, float) in [
        (0.02, 0.0),
        (0.1, 0.0),
        (0.2, 0.0),
        (0.5, 0.0),
        (1.0, 0.0),
        (0.5, 0.05),
    ] {
        let (ours, theirs) = (drag(speed, float, 200), equation(speed, float));
        println!(
            "U = {speed} m/s, float {float} kg: R = {ours:.5}, equation {theirs:.5}, F = {:.6} N",
            theirs * 5.0 * speed * speed
        );
        assert!(
            (ours / theirs - 1.0).abs() < 2e-3,
            "{speed}: {ours} {theirs}"
        );
    }
}

#[test]
fn drag_converges_with_the_square_of_the_segment() {
    let exact = equation(0.5, 0.0);
    let errors = [25, 50, 100].map(|n| (drag(0.5, 0.0, n) - exact).abs());
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.25, "{errors:?}");
    }
}
