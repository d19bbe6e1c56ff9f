//! Offsets, watch circles, periods, clearances and wanted results.

use seacable::system::analysis::analyses::Analyses;
use seacable::system::analysis::offset::{HeldAway, curve};
use seacable::system::analysis::periods::periods;
use seacable::system::analysis::seek::seek;
use seacable::system::analysis::watch_circle::{under, watch_circle};
use seacable::system::analysis::{clearance, watch_circle as circle};

use crate::{HEAD, solved};

const OC3: &str = include_str!("../../cases/systems/oc3_spar.toml");

/// The restoring force rises with the offset at the rate of the stiffness.
#[test]
fn the_offset_curve_begins_with_the_stiffness() {
    let system = solved(OC3);
    let mut held = HeldAway::new(&system.network, &system.rest, 0);
    let points = curve(&mut held, 0.0, 0.02, 2);
    let stiffness = (points[0].force_n.x - points[2].force_n.x) / 0.02;
    assert!((stiffness / system.stiffness[0][(0, 0)] - 1.0).abs() < 1e-3);
    assert!(points[0].force_n.x.abs() < 1e-6 * points[0].greatest.1);
}

/// The body is where the lines hold the load, and the circle has the symmetry of the system.
#[test]
fn the_watch_circle_holds_the_load() {
    let system = solved(OC3);
    let load = 5e5;
    let headings: Vec<f64> = (0..6)
        .map(|k| std::f64::consts::FRAC_PI_3 * f64::from(k))
        .collect();
    let found = watch_circle(&system.network, &system.rest, 0, load, headings.clone());
    for (k, heading) in headings.iter().enumerate() {
        let point = found.intact[k].as_ref().unwrap();
        assert!((point.force_n.x + load * heading.cos()).abs() < 1e-8 * point.greatest.1);
        assert!((point.force_n.y + load * heading.sin()).abs() < 1e-8 * point.greatest.1);
        let third = found.intact[(k + 2) % 6].as_ref().unwrap();
        assert!((point.distance_m() - third.distance_m()).abs() < 1e-6);
    }
    assert_eq!(found.damaged.len(), 3);
    let mut held = HeldAway::new(&system.network, &system.rest, 0);
    let far: Result<_, String> = under(&mut held, 1e12, 0.0, [0.0; 2]);
    assert!(far.is_err() || far.is_ok_and(|point| point.distance_m() > 100.0));
    let _: &circle::WatchCircle = &found;
}

/// A mass on a vertical tether under its buoyancy swings with the stiffness T/L.
#[test]
fn a_tethered_buoy_swings_as_an_inverted_pendulum() {
    let text = format!(
        "{HEAD}[seabed]\ndepth_m = 120.0\n[materials.rope]\ndiameter_m = 0.01\nmass_kg_per_m = 1.0\nwet_weight_kg_per_m = 0.0\nea_n = 1e9
[points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -120.0]
[bodies.buoy]\nkind = \"free\"\nposition_m = [0.0, 0.0, -20.0]\nmass_kg = 1000.0\nvolume_m3 = 2.0\ninertia_kg_m2 = [500.0, 500.0, 500.0]\ncentre_of_buoyancy_m = [0.0, 0.0, 1.0]
[points.eye]\nkind = \"body\"\nbody = \"buoy\"\nposition_m = [0.0, 0.0, 0.0]
[[lines]]\nname = \"tether\"\nfrom = \"anchor\"\nto = \"eye\"\nmaterial = \"rope\"\nlength_m = 100.0\n"
    );
    let system = solved(&text);
    let modes = periods(&system.network, &system.rest).unwrap().modes;
    let tension = (2.0 * 1025.0 - 1000.0) * 9.806_65;
    let swing = std::f64::consts::TAU / (tension / 100.0 / 1000.0_f64).sqrt();
    // Yaw has nothing that restores it; the two swings follow.
    assert_eq!(modes[0].period_s, Some(f64::INFINITY));
    for mode in &modes[1..3] {
        assert!(
            (mode.period_s.unwrap() / swing - 1.0).abs() < 1e-4,
            "{mode:?} {swing}"
        );
    }
}

#[test]
fn lines_keep_their_distance() {
    let system = solved(OC3);
    let all = clearance::distances(&system.network, &system.rest);
    // Nearest at the fairleads, 5.2 m from the axis: the side of the triangle.
    for distances in &all {
        assert!((distances.line.unwrap().1 - 5.2 * 3.0_f64.sqrt()).abs() < 1e-3);
    }
    let first = &all[0];
    assert!(first.above_bed.unwrap().abs() < 1e-9 && (first.below_surface - 70.0).abs() < 1e-9);
}

#[test]
fn a_wanted_tension_gives_a_length_or_a_reason() {
    let wanted = 9.5e5;
    let found = seek(
        OC3,
        "lines.mooring.length_m",
        (890.0, 910.0),
        "tension_n[mooring|b]",
        wanted,
    )
    .unwrap();
    let system = solved(&found.text);
    assert!((crate::tensions(&system, "mooring")[1] - wanted).abs() < 1e-6 * wanted);
    assert!(found.value < 902.2 && found.value > 890.0);
    // The radius of the anchors for a tension, and that of the fairleads for a clearance.
    let key = "points.anchor.position_m.x";
    let found = seek(OC3, key, (850.0, 865.0), "tension_n[mooring|b]", 1.2e6).unwrap();
    assert!(found.value > 853.87, "{}", found.value);
    let key = "points.fairlead.position_m.x";
    let apart = seek(OC3, key, (4.0, 8.0), "clearance_m[mooring]", 10.0).unwrap();
    assert!(
        (apart.value - 10.0 / 3.0_f64.sqrt()).abs() < 1e-3,
        "{}",
        apart.value
    );
    let why = seek(
        OC3,
        "lines.mooring.length_m",
        (900.0, 905.0),
        "tension_n[mooring|b]",
        5e7,
    )
    .unwrap_err();
    assert!(why.contains("is not among these"), "{why}");
}

/// What a file asks for is what the commands compute, and is worked out anew with every edit.
#[test]
fn analyses_that_a_file_asks_for_come_with_the_system() {
    let text = include_str!("../../cases/systems/oc3_spar.toml");
    let system = solved(text);
    let asked = Analyses::of_system(&system);
    assert_eq!((asked.offsets.len(), asked.circles.len()), (1, 1));
    let curve = &asked.offsets[0];
    assert_eq!((curve.points.len(), curve.ends_before_m), (21, None));
    let mut held = HeldAway::new(&system.network, &system.rest, 0);
    let last = held.at([-20.0, 0.0]).unwrap();
    let off = (curve.points[20].force_n - last.force_n).norm();
    assert!(off < 1e-9 * last.force_n.norm(), "{off}");
    let (body, circle) = &asked.circles[0];
    assert_eq!(
        (*body, circle.headings.len(), circle.damaged.len()),
        (0, 12, 3)
    );
    let (goal, sought) = &asked.goals[0];
    let sought = sought.as_ref().unwrap();
    assert!((sought.result / goal.value - 1.0).abs() < 1e-9);
    let with = text.replace(
        "length_m = 902.2",
        &format!("length_m = {:?}", sought.value),
    );
    let tension = crate::tensions(&solved(&with), "mooring")[1];
    assert!((tension / 9.5e5 - 1.0).abs() < 1e-9, "{tension}");
    // A goal that nothing meets says why, and the system stands.
    let never = solved(&text.replace("value = 9.5e5", "value = 9.5e7"));
    let never = Analyses::of_system(&never);
    let why = never.goals[0].1.as_ref().unwrap_err();
    assert!(why.contains("is not among these"), "{why}");
}
