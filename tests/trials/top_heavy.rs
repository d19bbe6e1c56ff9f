//! Floats that are unstable upright find the pose that they have, and say that the upright one is unstable.

use seacable::numerics::V3;
use seacable::system::SolvedSystem;
use seacable::system::analysis::analyses::Analyses;
use seacable::system::stability::Stability;
use seacable::system::warnings::warnings;

use crate::members::{file, parsed};

/// Height of the centre of gravity and angle between the axis z of the first body and the vertical \[deg\].
fn pose(system: &SolvedSystem) -> (f64, f64) {
    let (body, pose) = (&system.network.bodies[0], &system.rest.placement.bodies[0]);
    let centre = pose.origin + pose.arm(&body.centre_of_gravity);
    (centre.z, pose.arm(&V3::z()).angle(&V3::z()).to_degrees())
}

/// A cylinder with its centre of gravity 1.2 m above its metacentre.
fn top_heavy(keys: &str) -> String {
    let text = std::fs::read_to_string(file("floating_cylinder.toml")).unwrap();
    let text = text.replace("[system]\ntitle = \"t\"\n", "");
    text.replace("kind = \"free\"\n", &format!("kind = \"free\"\n{keys}\n"))
        .replace("position_m = [0.0, 0.0, 0.0]\n", "")
}

fn is_unstable(how: &Stability) -> bool {
    matches!(how, Stability::Unstable(_))
}

/// Upright it has GM = -1.2 m: it heels until weight and buoyancy are above each other again. Before: refused after 400 steps.
#[test]
fn a_top_heavy_cylinder_heels() {
    let system = parsed(&top_heavy("position_m = [0.0, 0.0, 0.0]"));
    assert!(!is_unstable(&system.stability), "{:?}", system.stability);
    let (z, heel) = pose(&system);
    assert!(heel > 10.0, "{heel}");
    assert!(system.rest.residual < 1e-9 * 200_000.0 * 9.81);
    let said = warnings(&system).join("\n");
    assert!(said.contains("is unstable"), "{said}");
    let others = Analyses::of_system(&system).others;
    let upright = others
        .iter()
        .find(|(rest, how)| is_unstable(how) && rest.placement.bodies[0].arm(&V3::z()).z > 0.9999);
    assert!(upright.is_some());
    // Whatever the start: upright or nearly, turned, mirrored, too deep, on its side.
    for keys in [
        "position_m = [3.0, -2.0, 0.0]\nyaw_deg = 37.0",
        "roll_deg = 1e-9",
        "roll_deg = -1e-5",
        "pitch_deg = 0.5",
        "position_m = [0.0, 0.0, -4.0]",
        "roll_deg = 60.0",
        "pitch_deg = -85.0",
        "roll_deg = 3.0\npitch_deg = -40.0\nyaw_deg = 100.0",
    ] {
        let again = parsed(&top_heavy(keys));
        let (depth, angle) = pose(&again);
        assert!((depth - z).abs() < 1e-5, "{keys}: {depth} {z}");
        assert!((angle - heel).abs() < 1e-3, "{keys}: {angle} {heel}");
    }
}

/// The same on three slack lines, from other directions: the float is round.
#[test]
fn a_moored_top_heavy_float_heels_alike_when_its_lines_are_turned() {
    let at = |turn: f64| {
        let angles = [0.0, 120.0, 240.0].map(|angle| angle + turn);
        parsed(&format!(
            "{}
            [materials.chain]\ndiameter_m = 0.05\nmass_kg_per_m = 20.0\nea_n = 5e7
            [points.anchor]\nkind = \"fixed\"\nposition_m = [150.0, 0.0, -60.0]
            [points.fairlead]\nkind = \"body\"\nbody = \"buoy\"\nposition_m = [3.0, 0.0, -4.0]
            [[lines]]\nname = \"chain\"\nfrom = \"anchor\"\nto = \"fairlead\"\nmaterial = \"chain\"\nlength_m = 165.0\nrepeat_at_deg = {angles:?}
            [seabed]\ndepth_m = 60.0\n",
            top_heavy("")
        ))
    };
    let one = at(0.0);
    assert_eq!(one.stability, Stability::Stable);
    let (z, heel) = pose(&one);
    assert!(heel > 10.0, "{heel}");
    assert!(warnings(&one).join("\n").contains("is unstable"));
    let (depth, angle) = pose(&at(37.0));
    assert!((depth - z).abs() < 1e-4, "{depth} {z}");
    assert!((angle - heel).abs() < 1e-2, "{angle} {heel}");
}

/// A rod that floats upright of itself does not: it lies in the surface.
#[test]
fn an_upright_rod_lies_down() {
    let system = parsed(
        "[rods.spar]\nkind = \"free\"\nend_a_m = [0.0, 0.0, -6.0]\nend_b_m = [0.0, 0.0, 6.0]\nmass_kg = 4000.0\ndiameter_m = 1.0\n",
    );
    let pose = &system.rest.placement.bodies[0];
    let lies = pose.arm(&V3::x());
    assert!(lies.z.abs() < 1e-6, "{lies}");
    assert!(!is_unstable(&system.stability), "{:?}", system.stability);
}

/// A float whose centre of gravity is low stays upright.
#[test]
fn a_stable_float_stays() {
    let text = top_heavy("").replace("[0.0, 0.0, -3.0]", "[0.0, 0.0, -6.0]");
    let system = parsed(&text);
    assert!(pose(&system).1 < 1e-9);
    assert!(system.rest.left.is_none());
}
