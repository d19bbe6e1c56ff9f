//! Lines in motion against an independent lumped-mass program: a moored chain, and a load lowered on chain, polyester and chain.
//!
//! The numbers are from a program written in Python for this comparison alone: nodes, Morison loads and added mass at the
//! direction between neighbouring nodes, RK4 in steps of half its stability limit, brought to rest by damping, extrapolated from 80 and
//! 160 segments (the load: 28 and 56) by the square of the segment. Between these meshes its tensions differ by at most
//! 0.3 % of the peak on the chain and by 40 N under the load. `MoorDyn` 2.7.2 (rk4, dtM 0.5 to 2 ms, segment tensions taken
//! on to the end) agrees with it on equal meshes within 0.03 % rms, 0.1 % at most, of the peak on the chain (80 segments) and
//! 0.02 % under the load (56 segments).

use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};

/// Allowed difference by the peak, of tension and of motion.
const SHARE: f64 = 0.005;

/// 652 m of chain from the bed, 200 m deep, to a ship that surges.
const CHAIN: &str = r#"
case.title = "Moored chain"
environment = { gravity_m_per_s2 = 9.81, water_density_kg_per_m3 = 1025.0 }
seabed = { depth_m = 200.0, stiffness_n_per_m3 = 3e5, damping_n_s_per_m3 = 5e4 }
line = [{ name = "chain", material = "chain", length_m = 652.0, segments = 80 }]
solver = { duration_s = 48.0, step_tolerance = 4e-6, error_estimate = false }
output = { interval_s = 0.1, shape_interval_s = 1.0 }
[materials.chain]
diameter_m = 0.16
mass_kg_per_m = 200.0
ea_n = 8e8
axial_damping_n_s = 2e5
drag_normal = 1.4
drag_tangential = 0.4
drag_tangential_width = "perimeter"
added_mass_normal = 1.0
[ends.a]
name = "anchor"
kind = "anchor"
position_m = [0.0, 0.0, -200.0]
[ends.b]
name = "ship"
kind = "moving"
position_m = [596.0, 0.0, -10.0]
amplitude_m = [3.0, 0.0, 0.0]
period_s = 12.0
ramp_s = 12.0
"#;

/// A load of 100 t on chain, polyester and chain, its top on a circle.
const LOWERED: &str = r#"
case.title = "Lowered load"
environment = { gravity_m_per_s2 = 9.81, water_density_kg_per_m3 = 1025.0 }
line = [
    { name = "upper", material = "chain", length_m = 100.0, segments = 4 },
    { name = "rope", material = "polyester", length_m = 900.0, segments = 20 },
    { name = "lower", material = "chain", length_m = 100.0, segments = 4 },
]
payload = { dry_mass_kg = 100e3, volume_m3 = 12.0, drag_area_m2 = 40.0, added_mass_kg = 60e3 }
solver = { duration_s = 54.0, step_tolerance = 4e-6, error_estimate = false }
output = { interval_s = 0.1, shape_interval_s = 1.0 }
[materials.chain]
diameter_m = 0.15
mass_kg_per_m = 180.0
ea_n = 7e8
axial_damping_n_s = 1e5
drag_normal = 1.4
drag_tangential = 0.4
drag_tangential_width = "perimeter"
[materials.polyester]
diameter_m = 0.18
mass_kg_per_m = 24.0
ea_n = 1.2e8
axial_damping_n_s = 5e5
drag_normal = 1.6
drag_tangential = 0.05
drag_tangential_width = "perimeter"
[ends.a]
name = "ship"
kind = "moving"
position_m = [0.0, 0.0, -5.0]
amplitude_m = [1.5, 0.0, 1.5]
phase_deg = [90.0, 0.0, 0.0]
period_s = 9.0
ramp_s = 18.0
[ends.b]
name = "load"
kind = "payload"
"#;

fn run(text: &str) -> Run {
    let request = Request {
        case: case::parse(text, "test.toml").unwrap(),
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

/// Asserts that a channel has these values \[kN, m\] at these times, within [`SHARE`] of `peak`.
fn holds(run: &Run, channel: &str, unit: f64, peak: f64, known: impl Iterator<Item = (f64, f64)>) {
    let values = &run.history.channel(channel).unwrap().values;
    for (time, exact) in known {
        let place = run.history.time.partition_point(|t| *t < time - 1e-6);
        let off = values[place] / unit - exact;
        assert!(
            off.abs() < SHARE * peak,
            "{channel} at {time} s: {exact}, off by {off}"
        );
    }
}

#[test]
fn a_moored_chain_under_surge() {
    let run = run(CHAIN);
    // Time [s], tension at the ship and at the anchor [kN].
    let known = [
        (0.0, 1070.3, 736.3),
        (36.0, 1293.2, 927.3),
        (37.5, 1213.1, 886.5),
        (39.0, 1025.1, 723.1),
        (40.5, 953.1, 656.3),
        (42.0, 861.3, 552.4),
        (43.5, 947.3, 606.8),
        (45.0, 1100.2, 737.2),
        (46.5, 1157.5, 784.2),
        (48.0, 1293.2, 927.3),
    ];
    let top = known.iter().map(|k| (k.0, k.1));
    holds(&run, "tension_n[chain|ship]", 1e3, 1299.2, top);
    let foot = known.iter().map(|k| (k.0, k.2));
    holds(&run, "tension_n[anchor|chain]", 1e3, 939.5, foot);
    // Where the node at three quarters of the line is, which goes up and down by 3.7 m.
    let path = [
        (36.0, 472.009, -115.785),
        (39.0, 471.991, -111.957),
        (42.0, 472.330, -115.637),
        (45.0, 472.400, -119.423),
        (48.0, 472.009, -115.785),
    ];
    for (time, x, z) in path {
        let shape = run.shapes.iter().find(|s| (s.time - time).abs() < 1e-6);
        let node = shape.unwrap().nodes[60];
        let off = (node[0] - x).hypot(node[2] - z);
        assert!(off < SHARE * 3.7, "{time} s: {node:?}, off by {off} m");
    }
}

#[test]
fn a_load_lowered_on_chain_polyester_and_chain() {
    let run = run(LOWERED);
    // Time [s], tension at the ship and at the load [kN], place of the load [m].
    let known = [
        (45.0, 1522.3, 1129.3, 0.101, -1115.481),
        (46.0, 1372.5, 991.8, 0.125, -1113.493),
        (47.0, 1134.7, 821.7, 0.138, -1111.308),
        (48.0, 913.3, 663.9, 0.139, -1109.828),
        (49.0, 789.8, 571.3, 0.132, -1109.679),
        (50.0, 852.8, 650.3, 0.118, -1111.128),
        (51.0, 1061.9, 813.4, 0.106, -1113.354),
        (52.0, 1301.8, 981.6, 0.104, -1115.277),
        (53.0, 1486.8, 1119.3, 0.114, -1116.162),
        (54.0, 1522.2, 1129.2, 0.136, -1115.480),
    ];
    let all = || known.iter();
    holds(
        &run,
        "tension_n[ship|upper]",
        1e3,
        1539.8,
        all().map(|k| (k.0, k.1)),
    );
    holds(
        &run,
        "tension_n[lower|load]",
        1e3,
        1150.0,
        all().map(|k| (k.0, k.2)),
    );
    // The load goes up and down by 3.3 m.
    holds(&run, "x_m[load]", 1.0, 3.3, all().map(|k| (k.0, k.3)));
    holds(&run, "z_m[load]", 1.0, 3.3, all().map(|k| (k.0, k.4)));
}
