//! The body against finite differences, and its accelerations against its residual.

use super::*;
use crate::scene::{self, Scene};
use crate::solve::{ExplicitRhs, Kinematics, Residual};

const BODY: &str = r#"
    line = [{ name = "rope", material = "rope", length_m = 20.0, segments = 2 }]
    case.title = "rigid_payload"
    current = { speed_m_per_s = [0.2, 2.7], direction_deg = [0.0, 80.0], depth_m = [0.0, 60.0] }
    materials.rope = { diameter_m = 0.1, mass_kg_per_m = 5.0, ea_n = 1e6 }
    ends.a = { name = "vessel", kind = "fixed", position_m = [0, 0, 0] }
    ends.b = { name = "body", kind = "payload" }
    start = { shape = "straight", elevation_deg = -50.0 }
    [payload]
    dry_mass_kg = 2000.0
    wet_mass_kg = 1500.0
    drag_area_m2 = [3.0, 3.0, 1.0]
    added_mass_kg = [700.0, 700.0, 400.0]
    [payload.rotation]
    centre_of_gravity_m = 2.0
    inertia_kg_m2 = 1500.0
    centre_of_buoyancy_m = 1.7
    centre_of_drag_m = 2.4
    drag_length_m = 3.0
    spin_deg_per_s = 90.0
    spin_inertia_kg_m2 = 2000.0
    added_inertia_kg_m2 = 200.0
    start_tilt_deg = 35.0
    start_azimuth_deg = 20.0
"#;

fn scene() -> Scene {
    scene::build(&crate::case::parse_keys(BODY).unwrap(), 1).unwrap()
}

/// The same in waves, hung so that it is partly out of the water.
fn at_sea(surface: &str) -> Scene {
    let height = if surface == "crossed" { 17.4 } else { 0.0 };
    let text = BODY.replace("[0, 0, 0]", &format!("[0, 0, {height:?}]"));
    let more = format!(
        "\nwaves = {{ kind = \"regular\", height_m = 1.5, period_s = 5.0, direction_deg = 25.0 }}\n\
         environment.water_surface = \"{surface}\"\n"
    );
    let text = text.replace("case.title", &format!("{more}case.title"));
    scene::build(&crate::case::parse_keys(&text).unwrap(), 1).unwrap()
}

fn scenes() -> [Scene; 3] {
    [scene(), at_sea("ignored"), at_sea("crossed")]
}

/// A state in which everything moves.
fn moving(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    for i in 1..scene.nodes() {
        let k = i as f64;
        state.x[i] += V3::new((7.0 * k).sin(), (5.0 * k).cos(), (3.0 * k).sin()) * 0.01;
        state.v[i] = V3::new((2.0 * k).cos(), (4.0 * k).sin(), (6.0 * k).cos());
        state.a[i] = V3::new((9.0 * k).sin(), (8.0 * k).sin(), (5.0 * k).cos()) * 3.0;
    }
    scene.update_wave_kinematics(1.3, &mut state);
    state
}

#[test]
fn it_is_partly_wet_in_the_tests() {
    let scene = at_sea("crossed");
    let (share, slope) = scene
        .elements
        .rigid_payload
        .unwrap()
        .wet(&scene.line, &moving(&scene));
    assert!((0.1..0.9).contains(&share) && slope.norm() > 0.1, "{share}");
}

/// Without the rod, whose stiffness would hide everything else in a share of the whole.
#[test]
fn the_tangent_of_the_body_is_the_finite_difference() {
    scenes().iter().for_each(has_its_tangent);
}

fn has_its_tangent(scene: &Scene) {
    let rigid_payload = scene.elements.rigid_payload.unwrap();
    let state = moving(scene);
    let forces = |state: &State| {
        let mut r = vec![V3::zeros(); scene.nodes()];
        rigid_payload.add_residual(scene.at(0.0, state), &mut r);
        r
    };
    let size = forces(&state).iter().map(V3::amax).fold(0.0, f64::max);
    for factors in [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)] {
        let c = Factors {
            mass: factors.0,
            damping: factors.1,
            stiffness: factors.2,
        };
        let mut tangent = BlockBand::new(scene.nodes());
        let mut r = vec![V3::zeros(); scene.nodes()];
        rigid_payload.linearise(scene.at(0.0, &state), c, &mut r, &mut tangent);
        for (j, axis) in (0..2).flat_map(|j| (0..3).map(move |axis| (j, axis))) {
            let shifted = |h: f64| {
                let (mut moved, node) = (state.clone(), rigid_payload.node + j);
                moved.x[node][axis] += h * c.stiffness;
                moved.v[node][axis] += h * c.damping;
                moved.a[node][axis] += h * c.mass;
                forces(&moved)
            };
            let (up, down) = (shifted(1e-5), shifted(-1e-5));
            for i in 0..2 {
                let row = rigid_payload.node + i;
                let block = match (i, j) {
                    (0, 1) => tangent.upper[row],
                    (1, 0) => tangent.lower[row],
                    _ => tangent.diag[row],
                };
                let off = block.column(axis) - (up[row] - down[row]) / 2e-5;
                assert!(off.amax() < 1e-7 * size, "{c:?} {i} {j} {axis}: {off}");
            }
        }
    }
}

#[test]
fn the_explicit_acceleration_leaves_no_residual() {
    for scene in scenes() {
        let mut state = moving(&scene);
        scene.accelerate(0.0, &mut state);
        let mut r = vec![V3::zeros(); scene.nodes()];
        scene.residual(0.0, &state, &mut r);
        let size = scene.stiffest() * 0.01;
        assert!(r[1..].iter().all(|r| r.norm() < 1e-12 * size), "{r:?}");
    }
}

/// The body is hung as tilted; where it is and how fast, by its centre of gravity.
#[test]
fn place_velocity_and_tilt_are_those_of_the_body() {
    let scene = scene();
    let mut state = scene.initial_state();
    assert_eq!(scene.line_nodes(), 3);
    assert!((scene.tilt(&state).to_degrees() - 35.0).abs() < 1e-9);
    let tilt = 35_f64.to_radians();
    let aside = V3::new(20_f64.to_radians().cos(), 20_f64.to_radians().sin(), 0.0);
    let centre = state.x[2] + (aside * tilt.sin() - V3::z() * tilt.cos()) * 2.0;
    assert!((scene.end_b_position(&state) - centre).norm() < 1e-9);
    // Turning about the hang point at 1 rad/s about the vertical.
    let spin = V3::z();
    state.v[3] = spin.cross(&(state.x[3] - state.x[2]));
    let expected = spin.cross(&(centre - state.x[2]));
    assert!((scene.end_b_velocity(&state) - expected).norm() < 1e-9);
}
