//! The length of a taut line that drag acts on.

use crate::rest;
use seacable::numerics::V3;
use seacable::scene::Scene;
use seacable::solve::{Kinematics, Residual};

/// A rope from east to west, in a current across.
fn rope(drag_length: &str) -> Scene {
    rest::build(&format!(
        r#"
        environment = {{ water_density_kg_per_m3 = 1025.0{drag_length} }}
        current = {{ speed_m_per_s = 1.5, direction_deg = 90.0 }}
        materials.rope = {{ drag_normal = 1.2, drag_tangential = 0.0 }}
        start = {{ shape = "straight", elevation_deg = 0.0 }}
        "#
    ))
}

/// Drag across a straight rope of this strain \[N\].
fn across(scene: &Scene, strain: f64) -> f64 {
    let mut state = scene.initial_state();
    for (x, arc) in state.x.iter_mut().zip(&scene.line.arc) {
        *x = V3::x() * (arc * (1.0 + strain));
    }
    let mut residual = vec![V3::zeros(); scene.nodes()];
    scene.residual(0.0, &state, &mut residual);
    -residual.iter().map(|r| r.y).sum::<f64>()
}

#[test]
fn drag_acts_on_the_stretched_or_the_unstretched_length() {
    // 1/2 rho C_D D U² on 100 m.
    let plain = 0.5 * 1025.0 * 1.2 * 0.1 * 1.5 * 1.5 * 100.0;
    for (key, strain, length) in [
        ("", 0.08, 1.08),
        (", drag_length = \"stretched\"", 0.08, 1.08),
        (", drag_length = \"unstretched\"", 0.08, 1.0),
        (", drag_length = \"stretched\"", -0.05, 1.0),
        (", drag_length = \"unstretched\"", -0.05, 1.0),
    ] {
        let drag = across(&rope(key), strain);
        assert!(
            (drag / (plain * length) - 1.0).abs() < 1e-12,
            "{key} {strain}: {drag}"
        );
    }
}

/// Drag along a straight rope that lies in the current acts on its diameter (Jia et al. 2019, eq. 3).
#[test]
fn drag_along_a_rope_is_on_its_diameter() {
    let scene = rest::build(
        r#"
        environment = { water_density_kg_per_m3 = 1025.0 }
        current = { speed_m_per_s = 1.5, direction_deg = 0.0 }
        materials.rope = { drag_normal = 0.0, drag_tangential = 0.062 }
        start = { shape = "straight", elevation_deg = 0.0 }
        "#,
    );
    let state = scene.initial_state();
    let mut residual = vec![V3::zeros(); scene.nodes()];
    scene.residual(0.0, &state, &mut residual);
    let drag = -residual.iter().map(|r| r.x).sum::<f64>();
    let expected = 0.5 * 1025.0 * 0.062 * 0.1 * 1.5 * 1.5 * 100.0;
    assert!((drag / expected - 1.0).abs() < 1e-12, "{drag}");
}
