//! Lines that bend, clamped on bodies: they turn with these, at rest and in motion.

use std::f64::consts::TAU;

use nalgebra::{Matrix2, Matrix6, Vector3, Vector6};
use seacable::solve::{Factors, Iterated};
use seacable::system::SolvedSystem;
use seacable::system::clamps::directions;
use seacable::system::equilibrium::search_near;
use seacable::system::motion::border::Border;
use seacable::system::motion::run::MotionRun;
use seacable::system::motion::start::start;
use seacable::system::network::{Held, Network};
use seacable::system::pose::Pose;
use seacable::system::quantities::value;
use seacable::system::stiffness::of_body;

use crate::motion::{channel, moved};
use crate::{HEAD, solved};

type V3 = Vector3<f64>;

fn at_rest(text: &str) -> SolvedSystem {
    solved(&format!("{HEAD}{text}"))
}

/// Length and bending stiffness of a weightless beam, and its segments.
const LONG: f64 = 8.0;
const EI: f64 = 5e3;
const SEGMENTS: usize = 40;

/// A weightless beam from a wall, clamped there and on a body at its tip that is in balance by itself.
fn beam(body: &str, keys: &str) -> String {
    format!(
        "[environment]\nwater_density_kg_per_m3 = 1000.0
        [materials.beam]\nmass_kg_per_m = 0.001\nwet_weight_kg_per_m = 0.0\ndiameter_m = 0.01\nea_n = 1e7\nei_n_m2 = {EI:?}\ndrag_normal = 0.0
        [points.wall]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -20.0]
        [points.tip]\nkind = \"body\"\nbody = \"weight\"\nposition_m = [0.0, 0.0, 0.0]
        [bodies.weight]\nkind = \"free\"\nposition_m = [{LONG:?}, 0.0, -20.0]\nmass_kg = 200.0\nvolume_m3 = 0.2\ninertia_kg_m2 = [80.0, 90.0, 100.0]\n{body}
        [[lines]]\nname = \"beam\"\nfrom = \"wall\"\nto = \"tip\"\nmaterial = \"beam\"\nlength_m = {LONG:?}\nsegments = {SEGMENTS}
        clamp_a_elevation_deg = 0.0\nclamp_b_elevation_deg = 0.0\n{keys}\n"
    )
}

/// Every bend bears the moment: `EI sin(a) / l` within the line, `2 EI sin(a) / l` at its clamps.
#[test]
fn a_moment_on_a_body_bends_its_beam_to_an_arc() {
    for moment in [1e2, 8e2] {
        let system = at_rest(&beam(&format!("moment_n_m = [0.0, {moment:?}, 0.0]"), ""));
        let length = LONG / SEGMENTS as f64;
        let bend = (moment * length / EI).asin();
        let at_clamp = (0.5 * moment * length / EI).asin();
        let turned = (SEGMENTS - 1) as f64 * bend + 2.0 * at_clamp;
        let pose = &system.rest.placement.bodies[0];
        let found = pose.angles()[1];
        assert!((found - turned).abs() < 1e-7, "{found} {turned}");
        // By second order the arc of a beam.
        let arc = moment * LONG / EI;
        assert!((turned / arc - 1.0).abs() < 1e-3);
        let down = -LONG / arc * (1.0 - arc.cos());
        assert!(
            (pose.origin.z + 20.0 - down).abs() < 2e-3 * LONG,
            "{}",
            pose.origin
        );
        let line = &system.rest.balance.lines[0];
        assert!(line.force_a.norm() < 1e-6 * moment);
    }
}

#[test]
fn a_force_on_a_body_bends_its_beam_as_a_cantilever() {
    let force = 5.0;
    let system = at_rest(&beam(&format!("load_n = [0.0, {force:?}, 0.0]"), ""));
    let pose = &system.rest.placement.bodies[0];
    let aside = force * LONG.powi(3) / (3.0 * EI);
    let turned = force * LONG * LONG / (2.0 * EI);
    assert!(
        (pose.origin.y / aside - 1.0).abs() < 1e-3,
        "{}",
        pose.origin
    );
    assert!((pose.angles()[2] / turned - 1.0).abs() < 1e-3);
}

/// Periods of a mass and its inertia on a weightless cantilever \[s\], the longer first.
fn periods(mass: f64, inertia: f64) -> [f64; 2] {
    let k = Matrix2::new(12.0, -6.0 * LONG, -6.0 * LONG, 4.0 * LONG * LONG) * (EI / LONG.powi(3));
    let scale =
        Matrix2::from_diagonal(&nalgebra::Vector2::new(mass.powf(-0.5), inertia.powf(-0.5)));
    let values = (scale * k * scale).symmetric_eigenvalues();
    [values.min(), values.max()].map(|value| TAU / value.sqrt())
}

#[test]
fn a_body_on_a_beam_alone_swings_at_the_periods_of_a_cantilever() {
    let system = at_rest(&beam("", ""));
    let [roll, across, up] = [80.0, 100.0, 90.0];
    assert!(roll > 0.0);
    let mut known: Vec<f64> = [periods(200.0, up), periods(200.0, across)].concat();
    known.sort_by(|a, b| b.total_cmp(a));
    // A body that a line alone holds spins about it freely.
    let found: Vec<f64> = (1..=4)
        .map(|k| value(&system, &format!("period_s[{k}]")).unwrap())
        .collect();
    for (found, known) in found.iter().zip(&known) {
        assert!((found / known - 1.0).abs() < 1e-3, "{found} {known}");
    }
}

#[test]
fn in_time_it_swings_at_them() {
    let [period, _] = periods(200.0, 90.0);
    let step = period / 400.0;
    let run = moved(&beam(
        "start_offset_m = [0.0, 0.0, 0.02]",
        &format!(
            "[solver]\nduration_s = {:?}\ntime_step_s = {step:?}\nrho_inf = 1.0\nposition_tolerance_m = 1e-10\nerror_estimate = false
            [output]\ninterval_s = {step:?}\n",
            10.0 * period
        ),
    ));
    let z = channel(&run, "z_m[weight]");
    let ups: Vec<f64> = (1..z.len())
        .filter(|k| z[k - 1] < -20.0 && z[*k] >= -20.0)
        .map(|k| k as f64 - (z[k] + 20.0) / (z[k] - z[k - 1]))
        .collect();
    // The short mode is on it: the mean over many periods.
    let found = (ups.last().unwrap() - ups[0]) / (ups.len() - 1) as f64 * step;
    assert!((found / period - 1.0).abs() < 0.02, "{found} {period}");
}

/// A rod spins freely about a clamp along its axis, and not about one across it.
#[test]
fn a_clamp_across_a_rod_holds_its_spin() {
    let rod = |to: &str, azimuth: f64| {
        at_rest(&format!(
            "[materials.cable]\nmass_kg_per_m = 10.0\ndiameter_m = 0.05\nea_n = 1e6\nei_n_m2 = 1e4
            [points.wall]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -20.0]
            [rods.rod]\nkind = \"free\"\nend_a_m = [5.0, 0.0, -20.0]\nend_b_m = {to}\nmass_kg = 200.0\ndiameter_m = 0.5
            [[lines]]\nname = \"cable\"\nfrom = \"wall\"\nto = \"rod-a\"\nmaterial = \"cable\"\nlength_m = 5.0\nsegments = 10
            clamp_a_elevation_deg = -60.0\nclamp_b_elevation_deg = 0.0\nclamp_b_azimuth_deg = {azimuth:?}\n"
        ))
    };
    let along = rod("[6.0, 0.0, -20.0]", 0.0);
    assert!(along.network.bodies[0].spins_about.is_some());
    let across = rod("[5.0, 1.0, -20.0]", 0.0);
    assert_eq!(across.network.bodies[0].spins_about, None);
    let periods = |system: &SolvedSystem| {
        let modes = seacable::system::analysis::periods::periods(&system.network, &system.rest);
        modes.unwrap().modes.len()
    };
    assert_eq!([periods(&along), periods(&across)], [5, 6]);
}

/// An umbilical from the bed to a body that is tilted, clamped at both ends, beside a mooring line to hold it.
fn umbilical(body: &str) -> String {
    format!(
        "[environment]\nwater_density_kg_per_m3 = 1025.0
        [materials.cable]\nmass_kg_per_m = 40.0\ndiameter_m = 0.15\nea_n = 1e7\nei_n_m2 = 3e4
        [materials.wire]\nmass_kg_per_m = 20.0\ndiameter_m = 0.05\nea_n = 1e7
        [points.foot]\nkind = \"fixed\"\nposition_m = [25.0, 4.0, -50.0]
        [points.anchor]\nkind = \"fixed\"\nposition_m = [-40.0, 3.0, -50.0]
        [points.hang_off]\nkind = \"body\"\nbody = \"buoy\"\nposition_m = [2.0, 0.5, -1.0]
        [points.fairlead]\nkind = \"body\"\nbody = \"buoy\"\nposition_m = [-2.0, 0.0, -1.0]
        [bodies.buoy]\nposition_m = [0.0, 0.0, -5.0]\nroll_deg = 4.0\npitch_deg = -7.0\nyaw_deg = 20.0\n{body}
        [[lines]]\nname = \"cable\"\nfrom = \"foot\"\nto = \"hang_off\"\nmaterial = \"cable\"\nlength_m = 60.0\nsegments = 40
        clamp_a_elevation_deg = 80.0\nclamp_b_elevation_deg = 60.0\nclamp_b_azimuth_deg = 150.0
        [[lines]]\nname = \"wire\"\nfrom = \"anchor\"\nto = \"fairlead\"\nmaterial = \"wire\"\nlength_m = 60.0\n"
    )
}

/// Force and moment of the lines on a held body at a pose.
fn load(system: &SolvedSystem, pose: Pose) -> Vector6<f64> {
    let mut network = system.network.clone();
    network.bodies[0].pose = pose;
    let mut near = system.rest.placement.clone();
    near.bodies[0] = pose;
    let rest = search_near(&network, &near).unwrap();
    let mut sum = Vector6::zeros();
    for (line, found) in network.lines.iter().zip(&rest.balance.lines) {
        for (end, force) in [(line.from, found.force_a), (line.to, found.force_b)] {
            if let Held::On(_, place) = &network.points[end].held {
                let moment = pose.arm(place).cross(&force);
                sum += Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
            }
        }
        let along = directions(&network, line, &rest.placement);
        for (direction, force) in along
            .iter()
            .zip(found.clamped().map(|c| c.force_n_m).into_iter().flatten())
        {
            let moment = direction.map_or_else(V3::zeros, |d| d.cross(&force));
            sum += Vector6::new(0.0, 0.0, 0.0, moment.x, moment.y, moment.z);
        }
    }
    sum
}

#[test]
fn the_stiffness_of_a_body_has_that_of_its_clamps() {
    let system = at_rest(&umbilical("kind = \"held\""));
    let pose = system.network.bodies[0].pose;
    let exact = of_body(&system.network, &system.rest, 0).unwrap();
    let mut found = Matrix6::zeros();
    for column in 0..6 {
        let side = |by: f64| {
            let motion = Vector6::ith(column, by);
            load(
                &system,
                pose.moved(
                    &motion.fixed_rows::<3>(0).into_owned(),
                    &motion.fixed_rows::<3>(3).into_owned(),
                ),
            )
        };
        let h = 1e-5;
        found.set_column(column, &(-(side(h) - side(-h)) / (2.0 * h)));
    }
    for (row, column) in (0..6).flat_map(|r| (0..6).map(move |c| (r, c))) {
        let scale = (exact[(row, row)] * exact[(column, column)]).abs().sqrt();
        let off = (found[(row, column)] - exact[(row, column)]).abs();
        assert!(off < 1e-4 * scale, "{row} {column}: {found}{exact}");
    }
    // A hinge there is softer.
    let hinged = umbilical("kind = \"held\"").replace(
        "clamp_b_elevation_deg = 60.0\nclamp_b_azimuth_deg = 150.0",
        "",
    );
    let hinged = at_rest(&hinged);
    let without = of_body(&hinged.network, &hinged.rest, 0).unwrap();
    assert!(exact[(4, 4)] > without[(4, 4)] + 1e3, "{exact}{without}");
}

const FREE: &str = "kind = \"free\"\nmass_kg = 8e3\nvolume_m3 = 11.5\ncentre_of_gravity_m = [0.0, 0.0, -1.0]\ncentre_of_buoyancy_m = [0.0, 0.0, 0.8]
        inertia_kg_m2 = [1e4, 1.2e4, 9e3]\nadded_mass = [3e3, 3e3, 4e3, 2e3, 2e3, 1e3]\ndrag_area_m2 = [4.0, 4.0, 5.0]";

fn free() -> &'static str {
    FREE
}

/// All forces and moments on a free body are in balance, those of its clamp among them.
#[test]
fn a_free_body_rests_where_the_moments_of_its_clamps_balance() {
    let system = at_rest(&umbilical(free()));
    let pose = system.rest.placement.bodies[0];
    let body = &system.network.bodies[0];
    let mut sum = load_at_rest(&system.network, &system);
    for (at, force) in [
        (&body.centre_of_gravity, -body.weight),
        (&body.centre_of_buoyancy, body.buoyancy),
    ] {
        let force = V3::z() * force;
        let moment = pose.arm(at).cross(&force);
        sum += Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
    }
    assert!(sum.norm() < 1e-5 * body.weight, "{sum}");
    let line = system.rest.balance.lines[0].clamped().unwrap();
    assert!(line.force_n_m[1].norm() > 1e3);
    // Turned about the vertical, it rests as before.
    let turned = at_rest(&turned_about(&umbilical(free()), 70.0));
    for name in ["tension_n[cable|b]", "tension_n[wire|b]"] {
        let [one, other] = [&system, &turned].map(|system| value(system, name).unwrap());
        assert!((one / other - 1.0).abs() < 1e-7, "{one} {other}");
    }
}

fn load_at_rest(network: &Network, system: &SolvedSystem) -> Vector6<f64> {
    let mut held = system.clone();
    held.network = network.clone();
    held.network.bodies[0].free = false;
    load(&held, system.rest.placement.bodies[0])
}

/// The umbilical turned about the vertical.
fn turned_about(text: &str, angle: f64) -> String {
    let (sin, cos) = angle.to_radians().sin_cos();
    let at = |x: f64, y: f64, z: f64| {
        format!("[{:?}, {:?}, {z:?}]", cos * x - sin * y, sin * x + cos * y)
    };
    text.replace("[25.0, 4.0, -50.0]", &at(25.0, 4.0, -50.0))
        .replace("[-40.0, 3.0, -50.0]", &at(-40.0, 3.0, -50.0))
        .replace("yaw_deg = 20.0", &format!("yaw_deg = {:?}", 20.0 + angle))
        .replace(
            "clamp_b_azimuth_deg = 150.0",
            &format!("clamp_b_azimuth_deg = {:?}", 150.0 + angle),
        )
        .replace(
            "clamp_a_elevation_deg = 80.0",
            &format!("clamp_a_elevation_deg = 80.0\nclamp_a_azimuth_deg = {angle:?}"),
        )
}

/// A line between two places of one body goes where that goes.
#[test]
fn a_body_that_is_turned_takes_its_line_along_unstrained() {
    let text = |pose: &str, elevation: f64, azimuth: f64| {
        format!(
            "[environment]\nwater_density_kg_per_m3 = 1000.0
            [materials.beam]\nmass_kg_per_m = 1.0\nwet_weight_kg_per_m = 0.0\ndiameter_m = 0.05\nea_n = 1e6\nei_n_m2 = 1e4
            [points.a]\nkind = \"body\"\nbody = \"frame\"\nposition_m = [0.0, 0.0, 0.0]
            [points.b]\nkind = \"body\"\nbody = \"frame\"\nposition_m = [3.0, 4.0, 0.0]
            [bodies.frame]\nkind = \"held\"\nposition_m = [1.0, 2.0, -9.0]\n{pose}
            [[lines]]\nname = \"beam\"\nfrom = \"a\"\nto = \"b\"\nmaterial = \"beam\"\nlength_m = 4.999\nsegments = 10
            clamp_a_elevation_deg = {elevation:?}\nclamp_a_azimuth_deg = {azimuth:?}\nclamp_b_elevation_deg = {elevation:?}\nclamp_b_azimuth_deg = {azimuth:?}\n"
        )
    };
    let system = at_rest(&text("", 0.0, 4.0_f64.atan2(3.0).to_degrees()));
    for angles in [[0.3, -0.4, 1.2], [1.4, 0.9, -2.0]] {
        let [roll, pitch, yaw] = angles;
        let pose = Pose::new(V3::new(5.0, 1.0, -3.0), roll, pitch, yaw);
        assert!(load(&system, pose).norm() < 1e-4);
    }
}

/// A body on a clamped cable below a top that moves in six degrees of freedom.
fn hung(settings: &str) -> String {
    format!(
        "[environment]\nwater_density_kg_per_m3 = 1025.0
        [materials.cable]\nmass_kg_per_m = 20.0\ndiameter_m = 0.08\nea_n = 2e6\nei_n_m2 = 2e4\naxial_damping_n_s = 2e4\ndrag_normal = 1.2\nadded_mass_normal = 1.0
        [points.hang_off]\nkind = \"body\"\nbody = \"ship\"\nposition_m = [2.0, 1.0, -1.0]
        [points.eye]\nkind = \"body\"\nbody = \"box\"\nposition_m = [0.3, 0.0, 1.0]
        [bodies.ship]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.5, 0.2, 1.0]\namplitude_deg = [6.0, 9.0, 3.0]\nperiod_s = [8.0]\nramp_s = 8.0
        [bodies.box]\nkind = \"free\"\nposition_m = [1.7, 1.0, -13.0]\nmass_kg = 3e3\nvolume_m3 = 1.0\ninertia_kg_m2 = [3e3, 3e3, 2e3]
        added_mass = [1e3, 1e3, 1e3, 5e2, 5e2, 5e2]\ndrag_area_m2 = [1.0, 1.5, 2.0]\nquadratic_damping = [0.0, 0.0, 0.0, 2e3, 2e3, 1e3]
        [[lines]]\nname = \"cable\"\nfrom = \"hang_off\"\nto = \"eye\"\nmaterial = \"cable\"\nlength_m = 11.0\nsegments = 11
        clamp_a_elevation_deg = -70.0\nclamp_b_elevation_deg = -85.0\nclamp_b_azimuth_deg = 40.0
        [solver]\n{settings}"
    )
}

fn hung_run(step: f64) -> MotionRun {
    moved(&hung(&format!(
        "duration_s = 16.0\ntime_step_s = {step:?}\nposition_tolerance_m = 1e-10\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
    )))
}

#[test]
fn a_body_on_a_clamped_cable_is_of_second_order_and_its_energy_balances() {
    let runs = [0.04, 0.02, 0.01].map(hung_run);
    for name in [
        "tension_n[cable|b]",
        "moment_nm[cable|a]",
        "moment_nm[cable|b]",
        "pitch_deg[box]",
    ] {
        let [coarse, middle, fine] = [0, 1, 2].map(|k| channel(&runs[k], name));
        let off = |one: &[f64], other: &[f64]| {
            let each = one.iter().zip(other).map(|(a, b)| (a - b).powi(2));
            each.sum::<f64>().sqrt()
        };
        let order = (off(coarse, middle) / off(middle, fine)).log2();
        assert!((1.8..2.4).contains(&order), "{name}: {order}");
    }
    let drifts = [&runs[1], &runs[2]].map(|run| run.balance.relative_drift());
    assert!(drifts[1] < 1e-3, "{drifts:?}");
    assert!(drifts[1] < 0.4 * drifts[0], "{drifts:?}");
}

#[test]
fn explicit_steps_agree_with_implicit_ones() {
    let settings = |method: &str, step: f64| {
        format!(
            "method = {method:?}\nduration_s = 4.0\ntime_step_s = {step:?}\nposition_tolerance_m = 1e-10\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
        )
    };
    let [one, other] = [("alpha", 2e-3), ("rk4", 4e-4)]
        .map(|(method, step)| moved(&hung(&settings(method, step))));
    for name in ["moment_nm[cable|a]", "moment_nm[cable|b]", "pitch_deg[box]"] {
        let (one, other) = (channel(&one, name), channel(&other, name));
        let most = one.iter().map(|v| (v - one[0]).abs()).fold(0.0, f64::max);
        for (one, other) in one.iter().zip(other) {
            assert!(
                (one - other).abs() < 2e-3 * most,
                "{name}: {one} {other} of {most}"
            );
        }
    }
}

/// Written from its other end, or mirrored with all that moves it, it moves alike.
#[test]
fn a_clamped_cable_moves_alike_reversed_and_mirrored() {
    let text = hung(
        "duration_s = 3.0\ntime_step_s = 0.05\nposition_tolerance_m = 1e-10\nerror_estimate = false\n[output]\ninterval_s = 0.25\n",
    );
    let exchanged = |pairs: &[(&str, &str)]| {
        let with = |text: String, (from, to): &(&str, &str)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        };
        pairs.iter().fold(text.clone(), with)
    };
    let reversed = moved(&exchanged(&[
        (
            "from = \"hang_off\"\nto = \"eye\"",
            "from = \"eye\"\nto = \"hang_off\"",
        ),
        (
            "clamp_a_elevation_deg = -70.0\nclamp_b_elevation_deg = -85.0\nclamp_b_azimuth_deg = 40.0",
            "clamp_a_elevation_deg = 85.0\nclamp_a_azimuth_deg = 220.0\nclamp_b_elevation_deg = 70.0\nclamp_b_azimuth_deg = 180.0",
        ),
    ]));
    let mirrored = moved(&exchanged(&[
        (
            "position_m = [2.0, 1.0, -1.0]",
            "position_m = [2.0, -1.0, -1.0]",
        ),
        ("[0.5, 0.2, 1.0]", "[0.5, -0.2, 1.0]"),
        ("[6.0, 9.0, 3.0]", "[-6.0, 9.0, -3.0]"),
        ("[1.7, 1.0, -13.0]", "[1.7, -1.0, -13.0]"),
        ("clamp_b_azimuth_deg = 40.0", "clamp_b_azimuth_deg = -40.0"),
    ]));
    let given = moved(&text);
    for (name, other) in [
        ("tension_n[cable|b]", "tension_n[cable|a]"),
        ("moment_nm[cable|a]", "moment_nm[cable|b]"),
        ("moment_nm[cable|b]", "moment_nm[cable|a]"),
    ] {
        let given = channel(&given, name);
        for same in [channel(&reversed, other), channel(&mirrored, name)] {
            for (one, other) in given.iter().zip(same) {
                assert!(
                    (one - other).abs() < 1e-8 * one.abs(),
                    "{name}: {one} {other}"
                );
            }
        }
    }
}

/// Newton's residuals of an implicit step fall by their squares: the tangent is exact.
#[test]
fn newton_converges_quadratically_on_turned_clamps() {
    let solved = at_rest(&hung("duration_s = 1.0\n"));
    let begun = start(&solved, 1.0).unwrap();
    let (system, mut state) = (&begun.system, begun.state.clone());
    let body = system.network.body("box").unwrap();
    state.joints.x[system.joints.rotations[body]] = V3::new(0.02, -0.05, 0.03);
    state.joints.x[system.joints.bodies[body]] += V3::new(0.05, -0.03, 0.0);
    system.follow(&mut state);
    let step = Factors {
        mass: 1e3,
        damping: 0.0,
        stiffness: 1.0,
    };
    let mut border = Border::new(system, &state);
    let mut residuals = Vec::new();
    for _ in 0..10 {
        border.solve(system, 0.0, &state, step).unwrap();
        residuals.push(border.residual(system));
        system.apply(&border, &mut state, step, 1.0);
    }
    let quadratic = residuals.windows(3).any(|three| {
        let [a, b, c] = [three[0], three[1], three[2]];
        b < 0.05 * a && (c < 10.0 * b * b / a || c < 1e-9 * residuals[0])
    });
    assert!(
        quadratic && residuals[9] < 1e-8 * residuals[0],
        "{residuals:?}"
    );
}

#[test]
fn quasi_static_steps_end_at_rest() {
    // A quarter of a very long swing: the pose of the ship at its end.
    let run = moved(&hung(
        "method = \"quasi\"\nduration_s = 40.0\ntime_step_s = 0.5\nerror_estimate = false\n[output]\ninterval_s = 40.0\n",
    ).replace("period_s = [8.0]\nramp_s = 8.0", "period_s = [160.0]\nramp_s = 10.0").replace("amplitude_m = [0.5, 0.2, 1.0]", "amplitude_m = [0.0, 0.0, 0.0]").replace("[6.0, 9.0, 3.0]", "[0.0, 9.0, 0.0]"));
    let found = channel(&run, "moment_nm[cable|a]");
    let turned = hung("duration_s = 1.0\n")
        .replace("kind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.5, 0.2, 1.0]\namplitude_deg = [6.0, 9.0, 3.0]\nperiod_s = [8.0]\nramp_s = 8.0", "kind = \"held\"\nposition_m = [0.0, 0.0, 0.0]\npitch_deg = 9.0")
        // Turned with the ship about y.
        .replace("clamp_a_elevation_deg = -70.0", "clamp_a_elevation_deg = -79.0");
    let end = start(&at_rest(&turned), 1.0).unwrap();
    let (scene, line) = (&end.system.scenes[0], &end.state.lines[0]);
    let moment = scene.bending_at_end(false, line).1;
    let last = found.last().unwrap();
    assert!(
        (last / moment - 1.0).abs() < 2e-2,
        "{last} {moment} {}",
        found[0]
    );
    assert!((found[0] / moment - 1.0).abs() > 0.1);
}

/// What is let go holds no direction any more.
#[test]
fn an_end_that_is_let_go_is_clamped_no_more() {
    let text = hung("duration_s = 1.0\ntime_step_s = 0.01\nerror_estimate = false\n[output]\ninterval_s = 0.25\n")
        .replace("segments = 11\n", "segments = 11\nrelease_b_s = 0.1\n");
    let run = moved(&text);
    let moments = channel(&run, "moment_nm[cable|b]");
    assert!(moments[0] > 10.0);
    assert!(
        moments[1..].iter().all(|moment| *moment == 0.0),
        "{moments:?}"
    );
}
