//! Systems whose answer is known in closed form.

use seacable::system::stability::Stability;

use crate::{HEAD, place, solved, tensions};

const ROPE: &str = "[materials.rope]\ndiameter_m = 0.01\nmass_kg_per_m = 1.0\nwet_weight_kg_per_m = 0.0\nea_n = 1e6\n";

/// Two weightless ropes of 5 m hold a weight on a span of 6 m: a triangle of 3, 4, 5 but for the stretch.
#[test]
fn a_weight_on_two_weightless_ropes() {
    let text = format!(
        "{HEAD}[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n{ROPE}
[points.a]\nkind = \"fixed\"\nposition_m = [-3.0, 0.0, 0.0]
[points.b]\nkind = \"fixed\"\nposition_m = [3.0, 0.0, 0.0]
[points.weight]\nkind = \"free\"\nmass_kg = 80.0
[[lines]]\nname = \"left\"\nfrom = \"a\"\nto = \"weight\"\nmaterial = \"rope\"\nlength_m = 5.0
[[lines]]\nname = \"right\"\nfrom = \"weight\"\nto = \"b\"\nmaterial = \"rope\"\nlength_m = 5.0\n"
    );
    let system = solved(&text);
    let [x, y, z] = place(&system, "weight");
    let stretched = 3.0_f64.hypot(z);
    let tension = 1e6 * (stretched / 5.0 - 1.0);
    // Both ropes bear 800 N: 2 T |z|/l.
    assert!((2.0 * tension * -z / stretched - 800.0).abs() < 1e-6);
    assert!(x.abs() < 1e-12 && y.abs() < 1e-12, "{x} {y}");
    for line in ["left", "right"] {
        assert!((tensions(&system, line)[0] - tension).abs() < 1e-6);
    }
    assert_eq!(system.stability, Stability::Stable);
}

/// A line cut in two by a point without weight hangs as the whole line does.
#[test]
fn a_point_on_a_line_changes_nothing() {
    let line = |name: &str, from: &str, to: &str, length: f64| {
        format!(
            "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"chain\"\nlength_m = {length}\n"
        )
    };
    let head = format!(
        "{HEAD}[seabed]\ndepth_m = 200.0\n[materials.chain]\ndiameter_m = 0.1\nmass_kg_per_m = 200.0\nea_n = 8e8
[points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -200.0]
[points.b]\nkind = \"fixed\"\nposition_m = [500.0, 300.0, -10.0]
[points.middle]\nkind = \"free\"\n"
    );
    let whole = solved(
        &format!("{head}{}", line("whole", "a", "b", 650.0))
            .replace("[points.middle]\nkind = \"free\"\n", ""),
    );
    for cut in [100.0, 350.0, 500.0, 640.0] {
        let parts = line("low", "a", "middle", cut) + &line("high", "middle", "b", 650.0 - cut);
        let system = solved(&format!("{head}{parts}"));
        let [_, top] = tensions(&whole, "whole");
        let error = tensions(&system, "high")[1] / top - 1.0;
        assert!(error.abs() < 1e-9, "cut at {cut} m: {error:.1e}");
        let [low, high] = [tensions(&system, "low")[1], tensions(&system, "high")[0]];
        assert!((low - high).abs() < 1e-9 * top);
    }
}

/// A buoy on a tether stands straight above its anchor; one with more line than water floats.
#[test]
fn a_buoy_on_a_tether() {
    let text = |length: f64| {
        format!(
            "{HEAD}[seabed]\ndepth_m = 50.0\n{ROPE}
[points.anchor]\nkind = \"fixed\"\nposition_m = [1.0, 2.0, -50.0]
[points.buoy]\nkind = \"free\"\nmass_kg = 100.0\nvolume_m3 = 1.0
[[lines]]\nname = \"tether\"\nfrom = \"anchor\"\nto = \"buoy\"\nmaterial = \"rope\"\nlength_m = {length}\n"
        )
    };
    let short = solved(&text(40.0));
    let lift = (1025.0 - 100.0) * 9.806_65;
    assert!((tensions(&short, "tether")[0] - lift).abs() < 1e-6);
    let [x, y, z] = place(&short, "buoy");
    assert!(
        (z - (-50.0 + 40.0 * (1.0 + lift / 1e6))).abs() < 1e-9
            && (x - 1.0).abs() < 1e-6
            && (y - 2.0).abs() < 1e-6
    );
    let afloat = solved(&text(60.0));
    assert_eq!(place(&afloat, "buoy")[2], 0.0);
    assert!(tensions(&afloat, "tether")[0] < 1e-6);
}

/// A clump heavier than its lines can lift rests on the bed, a lighter one hangs.
#[test]
fn a_clump_rests_on_the_bed() {
    let text = |mass: f64| {
        format!(
            "{HEAD}[seabed]\ndepth_m = 100.0\n[materials.wire]\ndiameter_m = 0.05\nmass_kg_per_m = 10.0\nea_n = 1e8
[points.a]\nkind = \"fixed\"\nposition_m = [-120.0, 0.0, -20.0]
[points.b]\nkind = \"fixed\"\nposition_m = [120.0, 0.0, -20.0]
[points.clump]\nkind = \"free\"\nmass_kg = {mass}
[[lines]]\nname = \"left\"\nfrom = \"a\"\nto = \"clump\"\nmaterial = \"wire\"\nlength_m = 142.0
[[lines]]\nname = \"right\"\nfrom = \"clump\"\nto = \"b\"\nmaterial = \"wire\"\nlength_m = 142.0\n"
        )
    };
    let heavy = solved(&text(5e6));
    assert_eq!(place(&heavy, "clump")[2], -100.0);
    let light = solved(&text(500.0));
    assert!(place(&light, "clump")[2] > -99.0);
    // What hangs is borne by the two ends.
    let up = |line: &str, b: bool| {
        let at = &light.rest.balance.lines[light.network.line(line).unwrap()];
        if b { -at.force_b.z } else { -at.force_a.z }
    };
    let wire = (10.0 - 1025.0 * std::f64::consts::PI * 0.05_f64.powi(2) / 4.0) * 284.0;
    let weight = (500.0 + wire) * 9.806_65;
    assert!((up("left", false) + up("right", true) - weight).abs() < 1e-6 * weight);
}

/// A free body hangs with its centre of gravity below its line.
#[test]
fn a_hung_body_turns_its_weight_down() {
    let text = format!(
        "{HEAD}[environment]\nwater_density_kg_per_m3 = 0.0\n{ROPE}
[points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]
[bodies.box]\nkind = \"free\"\nposition_m = [0.5, 0.3, -12.0]\nmass_kg = 1000.0\ncentre_of_gravity_m = [0.4, -0.2, 0.1]
[points.eye]\nkind = \"body\"\nbody = \"box\"\nposition_m = [0.0, 0.0, 1.0]
[[lines]]\nname = \"sling\"\nfrom = \"top\"\nto = \"eye\"\nmaterial = \"rope\"\nlength_m = 10.0\n"
    );
    let system = solved(&text);
    let pose = system.rest.placement.bodies[0];
    let gravity = pose.origin + pose.arm(&nalgebra::Vector3::new(0.4, -0.2, 0.1));
    assert!(
        gravity.x.abs() < 1e-6 && gravity.y.abs() < 1e-6,
        "{gravity}"
    );
    let arm = (0.4_f64 * 0.4 + 0.2 * 0.2 + 0.9 * 0.9).sqrt();
    let stretched = 10.0 * (1.0 + 1000.0 * 9.806_65 / 1e6);
    assert!((gravity.z + stretched + arm).abs() < 1e-6);
}
