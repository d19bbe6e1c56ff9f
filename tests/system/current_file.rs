//! Currents that a file gives over time and place: against the deflection of a taut line, constant currents, profiles by depth.

use std::fmt::Write as _;

use seacable::system::SolvedSystem;
use seacable::system::line_at_rest::LineAtRest;
use seacable::system::motion::run::MotionRun;

use crate::motion::{channel, moved, refused};
use crate::waves::solver;
use crate::{HEAD, solved};

/// A current by a file that the system carries.
fn current(text: &str) -> String {
    let text = text.replace('\n', "\\n");
    format!("[current]\nfile = \"current.csv\"\n[files.\"current.csv\"]\ntext = \"{text}\"\n")
}

/// A line of 100 m upright under a pull of 1 MN, in two parts with a point of no mass between.
fn upright(more: &str) -> String {
    let mut text = "
[materials.wire]
mass_kg_per_m = 3.0
diameter_m = 0.05
ea_n = 1e8
axial_damping_ratio = 0.5
drag_normal = 1.2
added_mass_normal = 1.0
[points.low]
kind = \"fixed\"
position_m = [0.0, 0.0, -110.0]
[points.high]
kind = \"fixed\"
position_m = [0.0, 0.0, -10.0]
[points.middle]
kind = \"free\"
"
    .to_owned();
    for (name, from, to) in [("a", "low", "middle"), ("b", "middle", "high")] {
        write!(
            text,
            "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"wire\"\nlength_m = {:?}\nsegments = 20\n",
            50.0 / 1.01
        )
        .unwrap();
    }
    text.push_str(more);
    text
}

/// A chain between two points, with a buoy on it that has drag, and a body on a second chain.
fn moored(more: &str) -> String {
    let text = "
[seabed]
depth_m = 60.0
[materials.chain]
mass_kg_per_m = 40.0
diameter_m = 0.08
ea_n = 2e8
axial_damping_ratio = 0.3
drag_normal = 1.6
drag_tangential = 0.1
added_mass_normal = 1.0
[points.anchor]
kind = \"fixed\"
position_m = [-90.0, 3.0, -60.0]
[points.buoy]
kind = \"free\"
mass_kg = 600.0
volume_m3 = 4.0
drag_area_m2 = 3.0
[points.end]
kind = \"body\"
body = \"spar\"
position_m = [-1.0, 0.0, -6.0]
[points.other]
kind = \"fixed\"
position_m = [140.0, -10.0, -60.0]
[points.start]
kind = \"body\"
body = \"spar\"
position_m = [1.0, 0.0, -6.0]
[bodies.spar]
kind = \"free\"
position_m = [20.0, 0.0, 0.0]
mass_kg = 11000.0
inertia_kg_m2 = [3e5, 3e5, 3e4]
centre_of_gravity_m = [0.0, 0.0, -8.0]
[[bodies.spar.members]]
from_m = [0.0, 0.0, -12.0]
to_m = [0.0, 0.0, 4.0]
diameter_m = 1.2
drag_normal = 1.0
added_mass_normal = 1.0
[[lines]]
name = \"low\"
from = \"anchor\"
to = \"buoy\"
material = \"chain\"
length_m = 80.0
segments = 16
[[lines]]
name = \"high\"
from = \"buoy\"
to = \"end\"
material = \"chain\"
length_m = 62.0
segments = 12
[[lines]]
name = \"far\"
from = \"start\"
to = \"other\"
material = \"chain\"
length_m = 150.0
segments = 16
";
    format!("{text}{more}")
}

/// Tensions at both ends of all lines at rest.
pub(crate) fn end_tensions(system: &SolvedSystem) -> Vec<f64> {
    let lines = system.rest.balance.lines.iter();
    lines.flat_map(LineAtRest::tensions).collect()
}

/// The largest difference of any channel of two runs, by the largest value of that channel.
fn difference(one: &MotionRun, other: &MotionRun) -> f64 {
    let mut worst: f64 = 0.0;
    let names = one.history.channels.iter().map(|channel| &channel.id);
    for name in names.map(ToString::to_string) {
        let (a, b) = (channel(one, &name), channel(other, &name));
        assert_eq!(a.len(), b.len());
        let size = a
            .iter()
            .fold(1e-3, |size: f64, value| size.max(value.abs()));
        let far = a.iter().zip(b).map(|(a, b)| (a - b).abs() / size);
        worst = far.fold(worst, f64::max);
    }
    worst
}

#[test]
fn a_taut_line_follows_a_current_that_rises_with_time() {
    // Deflection of a taut string under a uniform load q L² / 8 T, the load growing with the square of the speed.
    let rising = current("t_s,u_m_per_s,v_m_per_s\n0,0,0\n80,0.8,0.4\n90,0.8,0.4\n");
    let run = moved(&upright(&(rising + &solver(110.0, 0.05, 1.0))));
    let at_rest = channel(&run, "x_m[middle]")[0];
    assert!(at_rest.abs() < 1e-9, "{at_rest}");
    for t in [40.0, 60.0, 80.0, 85.0, 110.0_f64] {
        let share = (t / 80.0).min(1.0);
        let speed = 0.8_f64.hypot(0.4) * share;
        let load = 0.5 * 1025.0 * 1.2 * 0.05 * speed * speed;
        let far = load * 100.0 * 100.0 / (8.0 * 1e6);
        let row = run
            .history
            .time
            .iter()
            .position(|time| (time - t).abs() < 1e-6);
        let [x, y] = ["x_m[middle]", "y_m[middle]"].map(|name| channel(&run, name)[row.unwrap()]);
        assert!(
            (x.hypot(y) / far - 1.0).abs() < 0.02,
            "{t} s: {x} {y} for {far}"
        );
        assert!((y / x - 0.5).abs() < 1e-3, "{t} s: {x} {y}");
    }
}

#[test]
fn a_constant_grid_is_a_constant_current() {
    let plain = "[current]\nspeed_m_per_s = 1.3\ndirection_deg = 0.0\n";
    let (mut place, mut time) = (String::new(), String::new());
    for x in [-100, 0, 70] {
        for y in [-20, 40] {
            for z in [-60, -20, 5] {
                writeln!(place, "{x},{y},{z},1.3,0").unwrap();
                for t in [0, 7, 30] {
                    writeln!(time, "{t},{x},{y},{z},1.3,0").unwrap();
                }
            }
        }
    }
    let steady = current(&format!("x_m,y_m,z_m,u_m_per_s,v_m_per_s\n{place}"));
    let timed = current(&format!("t_s,x_m,y_m,z_m,u_m_per_s,v_m_per_s\n{time}"));
    let rest = |current: &str| end_tensions(&solved(&format!("{HEAD}{}", moored(current))));
    let wanted = rest(plain);
    for given in [&steady, &timed] {
        for (found, wanted) in rest(given).iter().zip(&wanted) {
            assert!((found / wanted - 1.0).abs() < 1e-9, "{found} for {wanted}");
        }
    }
    let run = |current: &str| moved(&moored(&(current.to_owned() + &solver(12.0, 0.05, 0.5))));
    let wanted = run(plain);
    for given in [&steady, &timed] {
        let worst = difference(&run(given), &wanted);
        assert!(worst < 1e-7, "{worst}");
    }
}

#[test]
fn a_current_by_height_and_time_is_at_rest_a_profile() {
    let table = "z_m,t_s,v_m_per_s,u_m_per_s\n-50,0,0.2,0.1\n-10,0,0.6,0.4\n-50,9,1,1\n-10,9,1,1\n";
    let moordyn = "title\n\n\n\n-50 -10\n\n0 0.1 0.4 0.2 0.6\n9 1 1 1 1\n";
    let angle = |x: f64, y: f64| y.atan2(x).to_degrees();
    let profile = format!(
        "[current]\ndepth_m = [10.0, 50.0]\nspeed_m_per_s = [{:?}, {:?}]\ndirection_deg = [{:?}, {:?}]\n",
        0.4_f64.hypot(0.6),
        0.1_f64.hypot(0.2),
        angle(0.4, 0.6),
        angle(0.1, 0.2)
    );
    let rest = |current: &str| end_tensions(&solved(&format!("{HEAD}{}", moored(current))));
    let (table, moordyn, profile) = (
        rest(&current(table)),
        rest(&current(moordyn)),
        rest(&profile),
    );
    assert_eq!(table, moordyn);
    for (found, wanted) in table.iter().zip(&profile) {
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found} for {wanted}");
    }
}

#[test]
fn a_current_that_differs_from_place_to_place_at_rest() {
    // Two buoys upstream and downstream of where the current turns lean away from each other as much.
    let flow = current("x_m,u_m_per_s,v_m_per_s\n-50,-1,0\n50,1,0\n");
    let buoy = |name: &str, x: f64| {
        format!(
            "[points.{name}_anchor]\nkind = \"fixed\"\nposition_m = [{x:?}, 0.0, -80.0]
             [points.{name}]\nkind = \"free\"\nmass_kg = 900.0\nvolume_m3 = 3.0\ndrag_area_m2 = 6.0
             [[lines]]\nname = \"{name}_line\"\nfrom = \"{name}_anchor\"\nto = \"{name}\"\nmaterial = \"wire\"\nlength_m = 60.0\nsegments = 20\n"
        )
    };
    let wire =
        "[materials.wire]\nmass_kg_per_m = 3.0\ndiameter_m = 0.05\nea_n = 1e7\ndrag_normal = 1.2\n";
    let text = format!(
        "{HEAD}{wire}{}{}{flow}",
        buoy("left", -30.0),
        buoy("right", 30.0)
    );
    let system = solved(&text);
    let place = |name: &str| crate::place(&system, name);
    let (left, right) = (place("left"), place("right"));
    assert!((left[0] + right[0]).abs() < 1e-6, "{left:?} {right:?}");
    assert!((left[2] - right[2]).abs() < 1e-6);
    assert!(right[0] > 35.0, "{right:?}");
}

#[test]
fn faults_of_a_current_have_their_place() {
    let fault = |text: &str| refused(&upright(&current(text)));
    let found = fault("t_s,u_m_per_s,v_m_per_s\n0,1,0\n10,fast,0\n");
    assert!(
        found.contains("current.csv:3:4") && found.contains("`fast` is not a number"),
        "{found}"
    );
    let found = fault("t_s,u_m_per_s\n0,1\n");
    assert!(
        found.contains("v_m_per_s: the column is missing"),
        "{found}"
    );
    let found = fault("x_m,z_m,u_m_per_s,v_m_per_s\n0,0,1,0\n0,-5,1,0\n1,0,1,0\n");
    assert!(found.contains("makes no grid"), "{found}");
    let found = fault("t_s,u_m_per_s,v_m_per_s\n0,100,0\n");
    assert!(found.contains("too fast"), "{found}");
    let found = refused(&upright("[current]\nfile = \"none.csv\"\n"));
    assert!(
        found.contains("current.file") && found.contains("cannot be read"),
        "{found}"
    );
    let both = current("t_s,u_m_per_s,v_m_per_s\n0,1,0\n")
        .replace("[current]\n", "[current]\nspeed_m_per_s = 1.0\n");
    let found = refused(&upright(&both));
    assert!(
        found.contains("has no effect: the current is that of its file"),
        "{found}"
    );
    let found = refused(&upright("[current]\ndirection_deg = 3.0\n"));
    assert!(
        found.contains("current.speed_m_per_s: is missing"),
        "{found}"
    );
}
