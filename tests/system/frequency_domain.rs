//! The quick look in the frequency domain: small motions as in time, closed forms of drag, invariance, what it refuses.

use std::f64::consts::PI;

use seacable::system::motion::frequency::{QuickLook, quick_look, quick_look_at_line};

use crate::motion::moved;
use crate::solved;
use crate::waves::{SOFT, held, solver, swing, swing_in};

const HEAD: &str = "[system]\ntitle = \"test\"\n";

fn look(text: &str) -> QuickLook {
    quick_look(&solved(&format!("{HEAD}{text}")), 1)
        .unwrap_or_else(|why| panic!("{}; {}", why.problem, why.remedy))
}

/// A swing with its lead over `cos(omega t)` in both domains: their difference by the greatest of them.
fn differs(text: &str, period: f64, names: &[&str]) {
    let (run, look) = (moved(text), look(text));
    let mut worst = (0.0, String::new());
    for name in names {
        let (size, lead) = swing(&run, name, period, 3.0);
        let channel = look.channels.iter().find(|c| c.id.to_string() == *name);
        let found = channel
            .unwrap()
            .amplitudes()
            .iter()
            .sum::<nalgebra::Complex<f64>>();
        let in_time = nalgebra::Complex::from_polar(size, lead);
        let difference = (found - in_time).norm() / size;
        if difference > worst.0 {
            worst = (difference, format!("{name}: {found} {in_time}"));
        }
    }
    assert!(worst.0 < 0.01, "{} {}", worst.0, worst.1);
}

/// A spar with members on three soft lines, in waves.
fn spar(waves: &str, turned_deg: f64) -> String {
    let mass = 1025.0 * PI * 9.0 * 40.0;
    let lines = held("spar").replace(
        "[0.0, 120.0, 240.0]",
        &format!(
            "[{turned_deg:?}, {:?}, {:?}]",
            turned_deg + 120.0,
            turned_deg + 240.0
        ),
    );
    format!(
        "{waves}
        [bodies.spar]\nkind = \"free\"\nmass_kg = {mass:?}\ncentre_of_gravity_m = [0.0, 0.0, -25.0]
        inertia_kg_m2 = [2e8, 2e8, 1e7]\ndamping = [2e4, 2e4, 8e4, 3e7, 3e7, 1e7]
        [[bodies.spar.members]]\nfrom_m = [0.0, 0.0, -40.0]\nto_m = [0.0, 0.0, 12.0]\ndiameter_m = 6.0\nadded_mass_normal = 1.0\ndrag_normal = 1.0\ndrag_end = 1.0\nadded_mass_end = 0.6
        {lines}"
    )
}

fn low_wave(period: f64, direction_deg: f64) -> String {
    format!(
        "[[waves]]\nkind = \"regular\"\nheight_m = 0.01\nperiod_s = {period:?}\nramp_s = 60.0\ndirection_deg = {direction_deg:?}\n"
    )
}

#[test]
fn a_spar_in_low_waves_moves_as_in_time() {
    let period = 9.0;
    let text = format!(
        "{}{}",
        spar(&low_wave(period, 20.0), 0.0),
        solver(450.0, 0.1, 0.1)
    );
    let names = [
        "x_m[spar]",
        "y_m[spar]",
        "z_m[spar]",
        "roll_deg[spar]",
        "pitch_deg[spar]",
        "wave_elevation_m[gauge]",
    ];
    differs(&text, period, &names);
}

/// A module around a tether that leans in a current: its drag follows the tether.
#[test]
fn a_module_on_a_tether_in_a_current_and_low_waves_moves_as_in_time() {
    let period = 6.0;
    let text = format!(
        "{SOFT}{}
        [current]\nspeed_m_per_s = 0.8\ndirection_deg = 0.0
        [materials.rope]\nmass_kg_per_m = 2.0\ndiameter_m = 0.05\nea_n = 2e5\ndrag_normal = 1.2\nadded_mass_normal = 1.0\naxial_damping_n_s = 2e4
        [points.below]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -60.0]
        [points.buoy]\nkind = \"free\"\nmass_kg = 800.0\nvolume_m3 = 2.0\nadded_mass_kg = 1000.0\ndrag_area_m2 = 2.0\nposition_m = [5.0, 0.0, -10.0]
        [[lines]]\nname = \"tether\"\nfrom = \"below\"\nto = \"buoy\"
        [[lines.sections]]\nmaterial = \"rope\"\nlength_m = 25.0\nsegments = 10\nclump_kg = -50.0\nclump_mass_kg = 150.0
        clump_drag_area_normal_m2 = 6.0\nclump_drag_area_tangential_m2 = 1.0\nclump_added_mass_normal_kg = 400.0\nclump_added_mass_tangential_kg = 30.0
        [[lines.sections]]\nmaterial = \"rope\"\nlength_m = 25.0\nsegments = 10
        {}",
        low_wave(period, 0.0),
        solver(240.0, 0.05, 0.1)
    );
    let names = [
        "x_m[buoy]",
        "z_m[buoy]",
        "tension_n[tether|a]",
        "tension_n[tether|b]",
    ];
    differs(&text, period, &names);
}

/// Free points that feel drag and inertia of the water, in a current that makes the drag linear about itself.
#[test]
fn a_buoy_in_a_current_and_low_waves_moves_as_in_time() {
    let period = 6.0;
    let text = format!(
        "{SOFT}{}
        [current]\nspeed_m_per_s = 0.8\ndirection_deg = 0.0
        [materials.rope]\nmass_kg_per_m = 2.0\ndiameter_m = 0.05\nea_n = 2e5\ndrag_normal = 1.2\nadded_mass_normal = 1.0\naxial_damping_n_s = 2e4
        [points.below]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -60.0]
        [points.buoy]\nkind = \"free\"\nmass_kg = 800.0\nvolume_m3 = 2.0\nadded_mass_kg = 1000.0\ndrag_area_m2 = 2.0\nposition_m = [5.0, 0.0, -10.0]
        [[lines]]\nname = \"tether\"\nfrom = \"below\"\nto = \"buoy\"\nmaterial = \"rope\"\nlength_m = 50.0\nsegments = 20
        {}",
        low_wave(period, 0.0),
        solver(240.0, 0.05, 0.1)
    );
    differs(
        &text,
        period,
        &[
            "x_m[buoy]",
            "z_m[buoy]",
            "tension_n[tether|a]",
            "tension_n[tether|b]",
        ],
    );
}

/// Prescribed motion of a body with a line on it: ends that nothing is solved for.
#[test]
fn a_line_under_a_body_that_sways_a_little_moves_as_in_time() {
    let period = 7.0;
    let text = format!(
        "[current]\nspeed_m_per_s = 1.0\ndirection_deg = 60.0
        [materials.chain]\nmass_kg_per_m = 100.0\ndiameter_m = 0.15\nea_n = 1e8\naxial_damping_n_s = 1e6\ndrag_normal = 1.2\nadded_mass_normal = 1.0
        [bodies.barge]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.004, 0.003, 0.005]\namplitude_deg = [0.02, 0.01, 0.03]\nperiod_s = [{period:?}]\nphase_deg = [0.0, 40.0, 80.0, 10.0, 70.0, 120.0]\nramp_s = 30.0
        [points.below]\nkind = \"fixed\"\nposition_m = [80.0, 0.0, -100.0]
        [points.stern]\nkind = \"body\"\nbody = \"barge\"\nposition_m = [-8.0, 3.0, -2.0]
        [[lines]]\nname = \"chain\"\nfrom = \"below\"\nto = \"stern\"\nmaterial = \"chain\"\nlength_m = 140.0\nsegments = 30
        {}",
        solver(240.0, 0.05, 0.1)
    );
    differs(
        &text,
        period,
        &[
            "tension_n[chain|a]",
            "tension_n[chain|b]",
            "x_m[stern]",
            "z_m[stern]",
        ],
    );
}

fn irregular(direction_deg: f64) -> String {
    format!(
        "[[waves]]\nkind = \"irregular\"\nsignificant_height_m = 5.0\npeak_period_s = 11.0\ngamma = 2.0\ndirection_deg = {direction_deg:?}\n"
    )
}

/// A system turned as a whole about the vertical has the same tensions, but for the error of the quadrature of drag.
#[test]
fn tensions_turn_with_the_system() {
    let [one, other] = [0.0, 35.0].map(|turn| look(&spar(&irregular(10.0 + turn), turn)));
    for (one, other) in one.channels.iter().zip(&other.channels) {
        if one.id.to_string().starts_with("tension") || one.id.to_string().starts_with("z_m[spar") {
            let (a, b) = (one.deviation(), other.deviation());
            assert!((a / b - 1.0).abs() < 1e-2, "{}: {a} {b}", one.id);
            assert!((one.mean - other.mean).abs() < 1e-6 * one.mean.abs().max(1.0));
        }
    }
}

#[test]
fn drag_grows_with_the_sea_as_by_hand() {
    // A ball held up hard does not move: its tether feels the vertical drag, which grows with the square of the height.
    let deviation = |height: f64| {
        let text = format!(
            "{SOFT}
            [[waves]]\nkind = \"irregular\"\nsignificant_height_m = {height:?}\npeak_period_s = 9.0
            [points.below]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -20.0]
            [points.ball]\nkind = \"free\"\nmass_kg = 10.0\nvolume_m3 = 0.0\nload_n = [0.0, 0.0, 5e5]\ndrag_area_m2 = 10.0\nposition_m = [0.0, 0.0, -10.0]
            [materials.stiff]\nmass_kg_per_m = 0.01\ndiameter_m = 0.001\nea_n = 1e8
            [[lines]]\nname = \"tether\"\nfrom = \"below\"\nto = \"ball\"\nmaterial = \"stiff\"\nlength_m = 10.0\nsegments = 2
            {}",
            solver(10.0, 0.1, 0.1)
        );
        let found = look(&text);
        let tension = found
            .channels
            .iter()
            .find(|c| c.id.to_string() == "tension_n[tether|b]");
        (tension.unwrap().deviation(), found)
    };
    let ((low, _), (high, found)) = (deviation(2.0), deviation(4.0));
    assert!((high / low - 4.0).abs() < 0.01, "{low} {high}");
    // Vertical drag in a circular orbit: E[|w| w_z²]/E[w_z²] of two equal normal components is 3/2 sqrt(pi/2) sigma, on w_z of deviation sigma.
    let waves = found
        .channels
        .iter()
        .find(|c| c.id.to_string() == "wave_elevation_m[gauge]")
        .unwrap();
    let orbit = waves.amplitudes().iter().zip(&found.omegas);
    let square: f64 = orbit
        .map(|(a, w)| 0.5 * (a.norm() * w * (-w * w / 9.80665 * 10.0).exp()).powi(2))
        .sum();
    let exact = 0.5 * 1025.0 * 10.0 * 1.5 * (0.5 * PI).sqrt() * square;
    assert!((high / exact - 1.0).abs() < 0.02, "{high} {exact}");
}

/// A line between two ends with a payload on its free end, under a top that heaves and in low waves of another period.
#[test]
fn a_line_with_a_payload_moves_as_in_time() {
    let (heave, wave) = (5.0, 8.0);
    let text = "[case]\ntitle = \"t\"
        [current]\nspeed_m_per_s = 0.6\ndirection_deg = 30.0
        [materials.wire]\ndiameter_m = 0.06\nmass_kg_per_m = 20.0\nea_n = 5e7\ndrag_normal = 1.2\nadded_mass_normal = 1.0\naxial_damping_n_s = 2e5
        [[line]]\nname = \"wire\"\nmaterial = \"wire\"\nlength_m = 60.0\nsegments = 12
        [ends.a]\nname = \"top\"\nkind = \"moving\"\nposition_m = [0.0, 0.0, -2.0]\namplitude_m = [0.0, 0.0, 0.003]\nperiod_s = 5.0\nramp_s = 40.0
        [ends.b]\nname = \"body\"\nkind = \"payload\"
        [payload]\ndry_mass_kg = 4e3\nvolume_m3 = 1.0\ndrag_area_m2 = 3.0\nadded_mass_kg = 2e3
        [waves]\nkind = \"regular\"\nheight_m = 0.01\nperiod_s = 8.0\nramp_s = 40.0
        [solver]\nduration_s = 400.0\ntime_step_s = 0.02\nerror_estimate = false\n[output]\ninterval_s = 0.1\n";
    let case = seacable::case::parse(text, "t.toml").map_err(|all| all[0].to_string());
    let look = quick_look_at_line(case.as_ref().unwrap(), 1)
        .unwrap_or_else(|why| panic!("{}", why.problem));
    let run = crate::turning::computed(case.unwrap(), text);
    assert_eq!(run.info.failure, None);
    for name in [
        "tension_n[top|wire]",
        "tension_n[wire|body]",
        "x_m[body]",
        "z_m[body]",
    ] {
        let Some(in_time) = run.history.channel(name) else {
            panic!("{name} is not recorded")
        };
        let channel = look
            .channels
            .iter()
            .find(|c| c.id.to_string() == name)
            .unwrap();
        for period in [heave, wave] {
            let (size, lead) = swing_in(&run.history.time, &in_time.values, period, 40.0 / period);
            let of = |(omega, found): (&f64, &nalgebra::Complex<f64>)| {
                ((omega * period / (2.0 * PI) - 1.0).abs() < 1e-9).then_some(*found)
            };
            let found = look.omegas.iter().zip(channel.amplitudes()).filter_map(of);
            let found = found.sum::<nalgebra::Complex<f64>>();
            let difference = (found - nalgebra::Complex::from_polar(size, lead)).norm() / size;
            assert!(
                difference < 0.02,
                "{name} {period}: {difference}, {found} {size} {lead}"
            );
        }
    }
}

#[test]
fn what_has_no_steady_motion_is_refused_with_the_reason() {
    let text = format!(
        "{HEAD}{SOFT}
        [points.below]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -60.0]
        [points.top]\nkind = \"moved\"\nposition_m = [5.0, 0.0, 0.0]\ntable_time_s = [0.0, 5.0, 10.0]\ntable_x_m = [0.0, 0.1, 0.0]\ntable_y_m = [0.0, 0.0, 0.0]\ntable_z_m = [0.0, 0.0, 0.0]
        [[lines]]\nname = \"rope\"\nfrom = \"below\"\nto = \"top\"\nmaterial = \"soft\"\nlength_m = 62.0\nsegments = 6
        {}",
        solver(10.0, 0.1, 0.1)
    );
    let why = quick_look(&solved(&text), 1).unwrap_err();
    assert!(
        why.problem.contains("top is moved by a table"),
        "{}",
        why.problem
    );
}

/// A box on a cable clamped on it and on a ship that turns and heaves by little.
#[test]
fn clamps_on_what_turns_are_linear_ones() {
    let period = 5.0;
    let text = format!(
        "[environment]\nwater_density_kg_per_m3 = 1025.0
        [materials.cable]\nmass_kg_per_m = 20.0\ndiameter_m = 0.08\nea_n = 2e6\nei_n_m2 = 2e4\naxial_damping_n_s = 2e5\nadded_mass_normal = 1.0\ndrag_normal = 0.0
        [points.hang_off]\nkind = \"body\"\nbody = \"ship\"\nposition_m = [2.0, 0.0, -1.0]
        [points.eye]\nkind = \"body\"\nbody = \"box\"\nposition_m = [0.0, 0.0, 1.0]
        [bodies.ship]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 0.01]\namplitude_deg = [0.0, 0.2, 0.0]\nperiod_s = [{period:?}]\nramp_s = 40.0
        [bodies.box]\nkind = \"free\"\nposition_m = [3.7, 0.0, -13.0]\nmass_kg = 3e3\nvolume_m3 = 1.0\ninertia_kg_m2 = [3e3, 3e3, 2e3]
        added_mass = [1e3, 1e3, 1e3, 5e2, 5e2, 5e2]\ndamping = [1e3, 1e3, 1e3, 2e3, 2e3, 1e3]
        [[lines]]\nname = \"cable\"\nfrom = \"hang_off\"\nto = \"eye\"\nmaterial = \"cable\"\nlength_m = 11.0\nsegments = 11
        clamp_a_elevation_deg = -70.0\nclamp_b_elevation_deg = -85.0
        {}",
        solver(200.0, 0.05, 0.05)
    );
    differs(
        &text,
        period,
        &[
            "x_m[box]",
            "z_m[box]",
            "pitch_deg[box]",
            "tension_n[cable|a]",
            "moment_nm[cable|a]",
        ],
    );
}
