//! Bodies on the sea bed: at rest, landing, sliding, and pulled off it, against balances and closed forms of one line.

use crate::{lines, march, rest};
use seacable::numerics::V3;
use seacable::scene::Scene;
use seacable::solve::{Hysteresis, State};
use toml::Table;

const G: f64 = 9.80665;

/// A body of 1000 kg on a light rope from 30 m above a bed 40 m below.
const HUNG: &str = r#"
environment.water_density_kg_per_m3 = 0.0
materials.rope = { diameter_m = 0.02, mass_kg_per_m = 0.01, ea_n = 1e6, axial_damping_ratio = 0.3 }
line = { length_m = 50.0, segments = 10 }
ends.a = { name = "top", kind = "fixed", position_m = [0.0, 0.0, -10.0] }
ends.b = { name = "body", kind = "payload" }
payload = { dry_mass_kg = 1000.0, wet_mass_kg = 1000.0, drag_area_m2 = 0.0, added_mass_kg = 0.0, bed_area_m2 = 2.0 }
seabed = { depth_m = 40.0, stiffness_n_per_m3 = 1e5, damping_n_s_per_m3 = 0.0 }
"#;

/// The same with changes.
fn hung(changes: &str) -> Scene {
    let mut case: Table = HUNG.parse().unwrap();
    lines::merge(&mut case, changes.parse().unwrap());
    rest::build(&toml::to_string(&case).unwrap())
}

/// Of the body and of the half segment of rope at its node \[m²\].
const AREA: f64 = 2.0 + 0.02 * 2.5;

fn bed_force(scene: &Scene, state: &State) -> f64 {
    scene.bed_force_at(scene.line_nodes() - 1, state)
}

#[test]
fn a_body_at_rest_sinks_by_its_weight_over_its_area() {
    for (changes, bottom, area) in [("", 0.0, AREA), ("payload.bottom_m = 1.5", 1.5, 2.0)] {
        let scene = hung(changes);
        let state = rest::at_rest(&scene);
        let depth = 1000.0 * G / (1e5 * area);
        let end = state.x[scene.line_nodes() - 1].z;
        // The rope beside it weighs 3 N.
        assert!(
            (end - bottom + 40.0 + depth).abs() < 1e-3 * depth + 2e-5,
            "{end}"
        );
        assert!((bed_force(&scene, &state) / (1000.0 * G) - 1.0).abs() < 1e-3);
    }
}

#[test]
fn a_body_that_rotates_bears_on_its_axis() {
    let rotation = "payload.rotation = { centre_of_gravity_m = 1.0, inertia_kg_m2 = 500.0 }";
    for (bottom, place) in [("", 1.0), ("payload.bottom_m = 2.0", 2.0)] {
        let scene = hung(&format!(
            "{rotation}\n{bottom}\nends.a.position_m = [0.0, 0.0, 9.9]"
        ));
        let state = rest::at_rest(&scene);
        let node = scene.line_nodes() - 1;
        let axis = (state.x[node + 1] - state.x[node]).normalize();
        let foot = state.x[node] + axis * place;
        let borne = bed_force(&scene, &state);
        assert!(
            (foot.z + 40.0 + borne / 2e5).abs() < 1e-4,
            "{foot:?} {borne}"
        );
        let top = scene.tension_at(0, &state);
        assert!(
            (borne + top - (1000.0 + 0.5) * G).abs() < 1.0,
            "{borne} {top}"
        );
    }
}

/// Falls 5 m freely onto a bed without damping: peak force `W + sqrt(W² + k m v²)`, landing speed `sqrt(2 g h)`.
#[test]
fn a_landing_body_meets_the_closed_form() {
    let scene = hung(
        "start = { shape = \"given\", arc_m = [0.0, 50.0], x_m = [0.0, 0.0], z_m = [-10.0, -35.0] }",
    );
    let mut state = scene.initial_state();
    let (mut peak, mut landing) = (0.0_f64, 0.0_f64);
    march::march(
        march::rk4(&scene),
        &scene,
        &mut state,
        (1.3, 2e-4),
        |_, s| {
            peak = peak.max(bed_force(&scene, s));
            landing = s.memory.bodies[0].landing_speed;
        },
    );
    let (weight, speed) = (1000.0 * G, (2.0 * G * 5.0).sqrt());
    assert!((landing / speed - 1.0).abs() < 1e-4, "{landing} {speed}");
    let exact = weight + (weight * weight + 1e5 * AREA * 1000.0 * speed * speed).sqrt();
    assert!((peak / exact - 1.0).abs() < 1e-3, "{peak} {exact}");
}

/// Pulled along the bed the body holds up to the friction that its weight gives, and slides at that force.
#[test]
fn friction_holds_a_body_up_to_its_limit() {
    let scene = hung(
        r#"
        line = { length_m = 50.0, segments = 5 }
        ends.a = { name = "top", kind = "moving", position_m = [-49.999, 0.0, -39.0], amplitude_m = [0.6, 0.0, 0.0], period_s = 400.0, phase_deg = [180.0, 0.0, 0.0] }
        start = { shape = "given", arc_m = [0.0, 50.0], x_m = [-49.999, 0.0], z_m = [-39.0, -39.049] }
        payload.bottom_m = 1.0
        seabed = { depth_m = 40.0, stiffness_n_per_m3 = 1e5, damping_n_s_per_m3 = 2e4, friction = 0.3 }
        "#,
    );
    let mut state = scene.initial_state();
    let (mut most, mut held) = (0.0_f64, 0.0_f64);
    march::march(
        march::rk4(&scene),
        &scene,
        &mut state,
        (60.0, 5e-4),
        |_, s| {
            let tension = scene.tension_at(0, s);
            most = most.max(tension);
            if tension < 0.5 * 0.3 * 1000.0 * G {
                held = held.max(s.x[5].x.abs());
            }
        },
    );
    let limit = 0.3 * 1000.0 * G;
    assert!((most / limit - 1.0).abs() < 0.02, "{most} {limit}");
    assert!(held < 0.5 * limit / 2e5 + 1e-3, "{held}");
    assert!(state.x[5].x < -0.2, "it slides: {}", state.x[5].x);
}

/// Slowly lifted, the rope pulls with the weight and the breakout force at most, and with the weight after that.
#[test]
fn suction_is_overcome_once() {
    let scene = hung(
        r#"
        line = { length_m = 30.0, segments = 5 }
        payload.breakout_n = 5000.0
        payload.breakout_distance_m = 0.2
        ends.a = { name = "top", kind = "moving", position_m = [0.0, 0.0, -10.5], amplitude_m = [0.0, 0.0, 1.4], period_s = 400.0 }
        seabed = { depth_m = 40.0, stiffness_n_per_m3 = 1e5, damping_n_s_per_m3 = 1e4 }
        "#,
    );
    let mut state = rest::at_rest(&scene);
    scene.commit(0.0, 0.0, &mut state);
    let (mut most, mut mean) = (0.0_f64, 0.0);
    march::march(
        march::alpha(&scene, 0.0),
        &scene,
        &mut state,
        (100.0, 0.01),
        |t, s| {
            let tension = scene.tension_at(0, s);
            most = most.max(tension);
            if t > 60.0 {
                mean += tension * 0.01 / 40.0;
            }
        },
    );
    let weight = 1000.0 * G;
    assert!((most / (weight + 5000.0) - 1.0).abs() < 0.01, "{most}");
    // Let go with a jerk it bounces about its weight.
    assert!((mean / weight - 1.0).abs() < 0.05, "{mean}");
    assert!(!state.memory.bodies[0].stuck);
}

/// What the wire pulls with above a clump that the bed bears is the wire's own tension.
#[test]
fn the_weight_of_a_body_on_the_bed_is_no_tension() {
    let scene = rest::build(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = { diameter_m = 0.03, mass_kg_per_m = 3.5, wet_weight_kg_per_m = 2.8, ea_n = 6e7 }
        line = { length_m = 250.06, segments = 30 }
        ends.a = { name = "top", kind = "fixed", position_m = [0.0, 0.0, 0.0] }
        ends.b = { name = "foot", kind = "free" }
        clumps = [{ name = "clump", section = "rope", at_m = 250.06, mass_kg = 14e3, wet_mass_kg = 11e3 }]
        seabed = { depth_m = 250.10, stiffness_n_per_m3 = 1e8 }
        "#,
    );
    let state = rest::at_rest(&scene);
    let foot = scene.tension_at(30, &state);
    let (w, ea, l) = (2.8 * G, 6e7, 250.06);
    // The wire's stretch reaches from its length to the bed: `EA e l = F l + w l²/2`.
    let stretch = -state.x[30].z - l;
    let exact = ea * stretch / l - 0.5 * w * l;
    assert!((foot / exact - 1.0).abs() < 1e-3, "{foot} {exact}");
    let borne = scene.bed_force_at(30, &state);
    assert!((borne + foot - 11e3 * G).abs() < 1.0, "{borne} {foot}");
    assert!((state.x[30] - V3::new(0.0, 0.0, -250.10)).norm() < 0.01);
}

/// Lowered onto the bed, left there on a slack rope and lifted off, a body gains the momentum that the reported forces give it:
/// `m dv = (T + N - W) dt`, and the weight of the lower half segment, of 30 g, which lies on it while the rope is slack.
#[test]
fn momentum_is_kept_through_landing_and_lift_off() {
    let scene = hung(
        r#"
        line = { length_m = 30.0, segments = 5 }
        ends.a = { name = "top", kind = "moving", position_m = [0.0, 0.0, -9.0], amplitude_m = [0.0, 0.0, -3.0], period_s = 20.0, ramp_s = 2.0 }
        seabed = { depth_m = 40.0, stiffness_n_per_m3 = 1e5, damping_n_s_per_m3 = 1e4 }
        "#,
    );
    let (weight, slack_rope) = (1000.0 * G, 0.03 * G);
    for (what, step, share) in [("rk4", 2e-4, 1e-5), ("alpha", 1e-3, 1e-4)] {
        let mut state = rest::at_rest(&scene);
        scene.commit(0.0, 0.0, &mut state);
        // Time of the latest step, force then, impulse so far, greatest momentum and greatest difference.
        let (mut before, mut impulse) = ((0.0, 0.0), 0.0);
        let (mut greatest, mut off) = (0.0_f64, 0.0_f64);
        let mut contact = Vec::new();
        let see = |t: f64, s: &State| {
            let borne = bed_force(&scene, s);
            let tension = scene.tension_at(5, s);
            let beside = if tension == 0.0 { slack_rope } else { 0.0 };
            let force = tension + borne - weight - beside;
            impulse += 0.5 * (force + before.1) * (t - before.0);
            before = (t, force);
            let momentum = 1000.0 * s.v[5].z;
            greatest = greatest.max(momentum.abs());
            off = off.max((momentum - impulse).abs());
            if contact.last() != Some(&(borne > 0.0)) {
                contact.push(borne > 0.0);
            }
        };
        let span = (16.0, step);
        match what {
            "rk4" => march::march(march::rk4(&scene), &scene, &mut state, span, see),
            _ => march::march(march::alpha(&scene, 0.4), &scene, &mut state, span, see),
        }
        // Off, on and off the bed, with what bounces there are.
        assert!(
            contact.len() >= 3 && !contact[0] && !contact[contact.len() - 1],
            "{contact:?}"
        );
        assert!(
            greatest > 500.0 && off < share * greatest,
            "{what}: {off} of {greatest}"
        );
    }
}
