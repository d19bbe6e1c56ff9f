//! Energy: what a line has, gains and loses adds up, and a swing without drag keeps what it has.

use crate::{lines, march, rest};
use std::path::Path;

use rayon::prelude::*;
use seacable::case;
use seacable::dynamics::Stepper;
use seacable::numerics::V3;
use seacable::scene::{self, EnergyRates, Scene};
use seacable::solve::{Kinematics, State};
use toml::Table;

/// Kinetic energy that the line would have at velocities `v` with the added mass it has in this state \[J\].
fn kinetic(scene: &Scene, state: &State, v: &[V3]) -> f64 {
    let mut moving = state.clone();
    moving.v.copy_from_slice(v);
    let mut still = state.clone();
    still.v.fill(V3::zeros());
    scene.energy(&moving) - scene.energy(&still)
}

/// What the books are out by at most, as a share of all that goes through them: energy gained, less the work of ends and
/// waves and of what takes energy out, summed over the steps by the trapezoidal rule, and less `v' dM v / 2`, the
/// growth of the added mass as it turns and gets wet, which is no force's work. The other number is the same without that.
pub(crate) fn out_by(
    scene: &Scene,
    method: impl Stepper<Scene>,
    state: &mut State,
    time: (f64, f64),
) -> (f64, f64) {
    let mut last: Option<(f64, f64, f64, State)> = None;
    let (mut given, mut grown, mut through) = (0.0, 0.0, 0.0);
    let (mut worst, mut worst_without): (f64, f64) = (0.0, 0.0);
    let mut before = f64::NAN;
    march::march(method, scene, state, time, |t, s| {
        let travels = scene.traveller_energy(t, s).unwrap_or_default();
        let power = scene.power_of_ends(t, s) + scene.power_of_waves(s) + travels.1;
        let (power, lost) = (power, scene.dissipation(s));
        let energy = scene.energy(s) + travels.0;
        if let Some((then, gain, loss, old)) = last.take() {
            let h = 0.5 * (t - then);
            given += h * (power - lost + gain - loss);
            through += h * (power.abs() + lost.abs() + gain.abs() + loss.abs());
            let mean: Vec<V3> = s.v.iter().zip(&old.v).map(|(a, b)| (a + b) * 0.5).collect();
            grown += kinetic(scene, s, &mean) - kinetic(scene, &old, &mean);
        } else {
            before = energy;
        }
        let gained = energy - before;
        worst = worst.max((gained - given - grown).abs());
        worst_without = worst_without.max((gained - given).abs());
        last = Some((t, power, lost, s.clone()));
    });
    (worst / through, worst_without / through)
}

/// The trapezoidal rule is what is left: a quarter of it at half the step.
#[test]
fn the_books_of_a_falling_payload_balance() {
    let scene = rest::build(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = { mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0, axial_damping_ratio = 0.1 }
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = 2.0, added_mass_kg = 500.0 }
        start = { shape = "straight", elevation_deg = -30.0 }
        "#,
    );
    let out = [0.004, 0.002, 0.001].map(|h| {
        let mut state = scene.initial_state();
        let (out, without) = out_by(&scene, march::rk4(&scene), &mut state, (30.0, h));
        assert!((1e-4..2e-4).contains(&without), "{without}");
        out
    });
    assert!(out[0] < 1e-6, "{out:?}");
    for pair in out.windows(2) {
        assert!((pair[0] / pair[1] - 4.0).abs() < 0.4, "{out:?}");
    }
}

/// Clumps that are aligned with the line, in a current and in still water, one at its lower end: what the water puts in and takes out.
#[test]
fn the_books_of_clumps_aligned_with_the_line_balance() {
    the_books_of_clumps_balance("added_mass_kg = 40.0");
    the_books_of_clumps_balance("added_mass_normal_kg = 90.0, added_mass_tangential_kg = 10.0");
}

fn the_books_of_clumps_balance(added_mass: &str) {
    let clump = |name: &str, at: f64| {
        format!(
            "{{ name = \"{name}\", section = \"rope\", at_m = {at:?}, mass_kg = 80.0, wet_mass_kg = 20.0, \
             drag_area_normal_m2 = 3.0, drag_area_tangential_m2 = 0.8, {added_mass} }}"
        )
    };
    let clumps = [
        clump("middle", 50.0),
        clump("low", 80.0),
        clump("end", 100.0),
    ]
    .join(", ");
    let text = format!(
        "environment.water_density_kg_per_m3 = 1025.0\n\
         materials.rope = {{ mass_kg_per_m = 12.0, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0, axial_damping_ratio = 0.1 }}\n\
         clumps = [{clumps}]\nstart = {{ shape = \"straight\", elevation_deg = -30.0 }}\n"
    );
    for current in [
        "",
        "current = { speed_m_per_s = 0.8, direction_deg = 130.0 }\n",
    ] {
        let scene = rest::build(&format!("{text}{current}"));
        let time = (20.0, 0.004);
        let (march, mut state) = (march::rk4(&scene), scene.initial_state());
        let out = out_by(&scene, march, &mut state.clone(), time).0;
        assert!(out < 2e-6, "{current}{out}");
        let march = march::rk4(&scene);
        let rates = rates_out_by(&scene, march, &mut state, time);
        assert!(rates < 2e-6, "{current}{rates}");
    }
}

/// 57 segments, some of them slack at first, drag coefficients that jump: 100 s of it.
#[test]
fn the_books_of_the_manifold_balance() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/pendulous/manifold.toml");
    let scene = scene::build(&case::load(&path).unwrap().case, 1).unwrap();
    let mut state = scene.initial_state();
    let (out, without) = out_by(&scene, march::rk4(&scene), &mut state, (100.0, 0.0035));
    assert!((1e-5..3e-5).contains(&without), "{without}");
    assert!(out < 1e-6, "{out}");
}

/// Whatever takes energy and gives it, all of it is booked: a quarter of what is left is left at half the step, a little
/// more where segments snap and friction turns round.
#[test]
fn the_books_of_every_scene_balance() {
    const DRIVEN: &str = "ends.a = { kind = \"moving\", position_m = [0.0, 0.0, 2.0], amplitude_m = [1.0, 0.5, 1.5], period_s = 5.0 }\n";
    const SEA: &str =
        "environment = { water_density_kg_per_m3 = 1025.0, water_surface = \"crossed\" }\n";
    const WAVES: &str =
        "waves = { kind = \"regular\", height_m = 3.0, period_s = 6.0, direction_deg = 20.0 }\n";
    const ROPE: &str = "materials.rope = { mass_kg_per_m = 9.0, drag_normal = 1.2, drag_tangential = 0.05, added_mass_normal = 1.0, axial_damping_ratio = 0.1 }\n";
    const BODY: &str = "ends.b = { name = \"bob\", kind = \"payload\" }\npayload = { dry_mass_kg = 900.0, wet_mass_kg = 500.0, drag_area_m2 = 1.0, added_mass_kg = 300.0 }\n";
    let scenes = [
        // A rope thrown out of the water, which comes down on it.
        (
            "thrown",
            format!("{SEA}{ROPE}start = {{ shape = \"straight\", elevation_deg = 30.0 }}\n"),
            1e-3,
        ),
        // A body that is let fall through the surface.
        (
            "splash",
            format!(
                "{SEA}{ROPE}{BODY}line = {{ length_m = 30.0, segments = 6 }}\nends.a.position_m = [0.0, 0.0, 25.0]\nstart = {{ shape = \"straight\", elevation_deg = -20.0 }}\n"
            ),
            1e-4,
        ),
        // The same in waves, its upper end moved through the crests.
        (
            "crests",
            format!(
                "{SEA}{ROPE}{BODY}{WAVES}{DRIVEN}line = {{ length_m = 30.0, segments = 6 }}\nstart = {{ shape = \"straight\", elevation_deg = -40.0 }}\n"
            ),
            1e-6,
        ),
        // Waves without a surface, bending, a current.
        (
            "bending",
            format!(
                "{}{BODY}{WAVES}{DRIVEN}environment.water_density_kg_per_m3 = 1025.0\ncurrent.speed_m_per_s = 0.8\nline = {{ length_m = 30.0, segments = 6 }}\nstart = {{ shape = \"straight\", elevation_deg = -60.0 }}\n",
                ROPE.replace("{ mass", "{ ei_n_m2 = 2e4, mass")
            ),
            1e-5,
        ),
        // A line damped by its mass, its end moved.
        (
            "damped by mass",
            format!(
                "{}{BODY}{DRIVEN}environment.water_density_kg_per_m3 = 1025.0\nline = {{ length_m = 30.0, segments = 6 }}\nstart = {{ shape = \"straight\", elevation_deg = -60.0 }}\n",
                ROPE.replace("{ mass", "{ mass_damping_per_s = 0.8, mass")
            ),
            1e-5,
        ),
        // A bed with friction, an end dragged over it.
        (
            "dragged",
            format!(
                "{ROPE}environment.water_density_kg_per_m3 = 1025.0\nseabed = {{ depth_m = 10.0, stiffness_n_per_m3 = 1e5, friction = 0.4, damping_n_s_per_m3 = 1e4 }}\nline = {{ length_m = 60.0, segments = 12 }}\nends.a = {{ kind = \"moving\", position_m = [0.0, 0.0, 0.0], amplitude_m = [2.0, 1.0, 1.0], period_s = 5.0 }}\nends.b = {{ name = \"anchor\", kind = \"anchor\", position_m = [57.0, 0.0, -10.0] }}\n"
            ),
            2e-5,
        ),
    ];
    for (name, text, bound) in scenes {
        let scene = rest::build(&text);
        let limit = scene.explicit_limit().0;
        let by_rates = [0.2, 0.1].map(|share| {
            let mut state = scene.initial_state();
            if !text.contains("start") {
                state = rest::at_rest(&scene);
                scene.prescribe(0.0, &mut state);
            }
            let time = (20.0, share * limit);
            rates_out_by(&scene, march::rk4(&scene), &mut state, time)
        });
        assert!(
            by_rates[1] < bound && by_rates[0] > 2.8 * by_rates[1],
            "{name}: {by_rates:?}"
        );
        let out = [0.2, 0.1].map(|share| {
            let mut state = scene.initial_state();
            if !text.contains("start") {
                state = rest::at_rest(&scene);
                scene.prescribe(0.0, &mut state);
            }
            out_by(
                &scene,
                march::rk4(&scene),
                &mut state,
                (20.0, share * limit),
            )
            .0
        });
        assert!(out[1] < bound && out[0] > 2.8 * out[1], "{name}: {out:?}");
    }
}

/// What the energy rates of a scene are out by, summed over the steps by the trapezoidal rule, as a share of all that goes
/// through them; the rates agree with the sums of the scene at every step.
fn rates_out_by(
    scene: &Scene,
    method: impl Stepper<Scene>,
    state: &mut State,
    time: (f64, f64),
) -> f64 {
    let mut last: Option<(f64, EnergyRates)> = None;
    let (mut out, mut through, mut worst) = (0.0, 0.0, 0.0_f64);
    let mut tensions = vec![0.0; scene.line_nodes()];
    march::march(method, scene, state, time, |t, s| {
        let now = scene.read_step(t, s, true, &mut tensions);
        let travels = scene.traveller_energy(t, s).unwrap_or_default();
        let energy = scene.energy(s) + travels.0;
        assert!((now.energy - energy).abs() <= 1e-9 * (energy.abs() + now.kinetic));
        let net = now.supplied - now.dissipated;
        let ends = scene.power_of_ends(t, s);
        let all = ends + scene.power_of_waves(s) + travels.1 - scene.dissipation(s);
        let size = now.supplied.abs() + now.dissipated.abs() + ends.abs();
        assert!((net - all).abs() <= 1e-9 * size + 1e-6, "{net} {all}");
        for (i, tension) in tensions.iter().enumerate() {
            assert_eq!(*tension, scene.tension_at(i, s));
        }
        if let Some((then, old)) = last.replace((t, now)) {
            let given = |r: &EnergyRates| r.supplied - r.dissipated + r.growth;
            out += now.energy - old.energy - 0.5 * (t - then) * (given(&now) + given(&old));
            through += (t - then) * (now.supplied.abs() + now.dissipated.abs());
            worst = worst.max(out.abs());
        }
    });
    worst / through
}

/// A body let fall on the bed and dragged along it by its rope, lifted off against suction, and let fall again.
const LANDING: &str = r#"
    environment.water_density_kg_per_m3 = 1025.0
    materials.rope = { diameter_m = 0.03, mass_kg_per_m = 2.0, ea_n = 2e6, drag_normal = 1.2, drag_tangential = 0.02, added_mass_normal = 1.0, axial_damping_ratio = 0.2 }
    line = { length_m = 30.0, segments = 6 }
    ends.a = { kind = "moving", position_m = [0.0, 0.0, -10.0], amplitude_m = [2.0, 0.0, 2.0], period_s = 8.0 }
    ends.b = { name = "body", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, wet_mass_kg = 700.0, drag_area_m2 = 1.0, added_mass_kg = 300.0, bed_area_m2 = 2.0 }
    start = { shape = "straight", elevation_deg = -85.0 }
    "#;

/// Landing, dragging and lift-off, with damping, friction of either law and suction, of a body hung by its top, and of one
/// that rotates: what is left is the trapezoidal rule over the jumps in slope of contact and friction.
#[test]
fn the_books_of_a_body_that_lands_and_lifts_off_balance() {
    const BED: &str =
        "seabed = { depth_m = 40.0, stiffness_n_per_m3 = 1e4, damping_n_s_per_m3 = 2e3";
    const SUCTION: &str = "payload.breakout_n = 3000.0\npayload.breakout_distance_m = 0.2\n";
    const ROTATES: &str =
        "payload.rotation = { centre_of_gravity_m = 1.0, inertia_kg_m2 = 500.0 }\n";
    let bodies = [
        ("damping", "}", ""),
        ("grip", ", friction = 0.4 }", ""),
        (
            "zhu",
            ", friction = 0.4, friction_law = \"zhu-2017\", slip_speed_m_per_s = 0.05 }",
            "",
        ),
        ("suction", ", friction = 0.4 }", SUCTION),
        ("rotates", ", friction = 0.4 }", ROTATES),
    ];
    bodies.par_iter().for_each(|&(name, bed, body)| {
        let mut case: Table = format!("{LANDING}\n{BED}{bed}\n").parse().unwrap();
        lines::merge(&mut case, body.parse().unwrap());
        let scene = rest::build(&toml::to_string(&case).unwrap());
        let limit = scene.explicit_limit().0;
        let out = [0.4, 0.05].map(|share| {
            let time = (24.0, share * limit);
            rates_out_by(&scene, march::rk4(&scene), &mut scene.initial_state(), time)
        });
        // The steps meet the jumps in slope now nearer, now farther: an eighth of the step leaves a tenth to a sixtieth.
        assert!(out[1] < 1e-6 && out[0] > 8.0 * out[1], "{name}: {out:?}");
        assert_eq!(lands_and_lifts_off(&scene), [true; 2], "{name}");
    });
}

/// Whether the body bears on the bed, and whether it is off the bed afterwards.
fn lands_and_lifts_off(scene: &Scene) -> [bool; 2] {
    let mut touched = [false; 2];
    let time = (24.0, 0.4 * scene.explicit_limit().0);
    let mut state = scene.initial_state();
    march::march(march::rk4(scene), scene, &mut state, time, |_, s| {
        let bears = scene.bed_force_at(6, s) > 0.0;
        touched[0] |= bears;
        touched[1] |= touched[0] && !bears;
    });
    touched
}

/// Energy that a swing of 1000 s without drag loses, as a share of its kinetic energy at first: a bob on five
/// segments, pushed to 10 m/s from rest, which swings it to 18 degrees and pulls the line taut and less taut.
fn lost_in_a_long_swing(scene: &Scene, method: impl Stepper<Scene>, step: f64) -> f64 {
    let mut state = rest::at_rest(scene);
    for (v, s) in state.v.iter_mut().zip(&scene.line.arc) {
        v.x = 0.1 * s;
    }
    let kinetic = 0.5 * 1000.0 * 10.0 * 10.0;
    let before = scene.energy(&state);
    march::march(method, scene, &mut state, (1000.0, step), |_, _| ());
    (before - scene.energy(&state)) / kinetic
}

/// Runge-Kutta and rho = 1 keep a swing; a smaller rho loses by its damping of what is fast, which a line's axial and
/// transverse waves are: the more the smaller rho and the longer the step, and never gains.
#[test]
fn an_undamped_swing_keeps_its_energy_or_loses_it_as_known() {
    let scene = rest::build(
        r#"
        line.segments = 5
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }
        "#,
    );
    let explicit = lost_in_a_long_swing(&scene, march::rk4(&scene), 0.02);
    assert!((0.0..1e-4).contains(&explicit), "{explicit}");
    for step in [0.02, 0.05] {
        let lost = |rho| lost_in_a_long_swing(&scene, march::alpha(&scene, rho), step);
        assert!(lost(1.0).abs() < 1e-4, "{}", lost(1.0));
        // Measured at 0.02 s: 7.5e-4, 7.9e-5, 1.8e-6; at 0.05 s: 3.3e-3, 8.7e-4, 2.1e-5.
        let all = [0.0, 0.4, 0.8].map(lost);
        assert!(
            all[0] > 3.0 * all[1] && all[1] > 10.0 * all[2] && all[2] > 1e-6,
            "{all:?}"
        );
        assert!(all[0] < 5e-3 && all[1] < 1.5e-3 && all[2] < 5e-5, "{all:?}");
    }
}
