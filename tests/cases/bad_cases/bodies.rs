//! Start, release, traveller, rotation and trials, and keys that have no effect: every fault as it is reported.

use super::{GOOD, faults};
use std::fmt::Write;

/// The good case with text put in before a table, or at its end.
fn with(before: &str, new: &str) -> String {
    assert_eq!(GOOD.matches(before).count(), 1, "`{before}`");
    GOOD.replace(before, &format!("{new}\n\n{before}"))
}

fn start(keys: &str) -> String {
    with("[marks]", &format!("[start]\n{keys}"))
}

fn traveller(keys: &str) -> String {
    with(
        "[marks]",
        &format!("[traveller]\nname = \"crab\"\nmass_kg = 9.0\nwet_mass_kg = 8.0\n{keys}"),
    )
}

fn rotation(keys: &str) -> String {
    with(
        "[[floats]]",
        &format!("[payload.rotation]\ncentre_of_gravity_m = 2.0\ninertia_kg_m2 = 10.0\n{keys}"),
    )
}

fn trial(keys: &str) -> String {
    format!("{GOOD}\n[[trial]]\nname = \"first\"\n\n[[trial]]\nname = \"second\"\n{keys}\n")
}

/// The good case with another end A.
fn end_a(keys: &str) -> String {
    let held = "kind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]";
    assert_eq!(GOOD.matches(held).count(), 1);
    GOOD.replace(held, &format!("position_m = [0.0, 0.0, 0.0]\n{keys}"))
}

#[test]
fn every_fault_of_bodies_starts_and_trials_is_reported() {
    let spoilt = [
        start("x_m = [0.0, 1.0]"),
        start("shape = \"given\""),
        start("shape = \"straight\"\narc_m = [0.0, 100.0]\nx_m = [0.0, 1.0]\nz_m = [0.0, 1.0]"),
        start("shape = \"given\"\narc_m = [0.0, 100.0]\nx_m = [0.0, 1.0]"),
        start("shape = \"given\"\narc_m = [0.0, 100.0]\nx_m = [0.0, 1.0, 2.0]\nz_m = [0.0, 1.0]"),
        start(
            "shape = \"given\"\narc_m = [0.0, 60.0, 60.0, 100.0]\nx_m = [0.0, 1.0, 2.0, 3.0]\nz_m = [0.0, 1.0, 2.0, 3.0]",
        ),
        start("shape = \"given\"\narc_m = [0.0, 90.0]\nx_m = [0.0, 1.0]\nz_m = [0.0, 1.0]"),
        start(
            "shape = \"given\"\narc_m = [0.0, 50.0, 100.0]\nx_m = [0.0, 1.0, 1.0]\nz_m = [0.0, 1.0, 1.0]",
        ),
        start("shape = \"slack\""),
        start("velocity_m_per_s = [1.0, 2.0]"),
        trial("set = [\"solver.methd=rk4\"]"),
        trial("set = [\"solver.method\"]"),
        trial("rows = [\"tension at the lod\"]"),
        trial("same_as = \"third\"\nsame_rel = 0.1"),
        trial("same_as = \"first\""),
        trial("same_rel = 0.1"),
        trial("refused = \"no equilibrium\"\ntold = \"slack\""),
        GOOD.replace("kind = \"payload\"", "kind = \"payload\"\nrelease_s = 5.0"),
        end_a("kind = \"fixed\"\nrelease_s = -5.0"),
        end_a("kind = \"fixed\"\nclamp_azimuth_deg = 20.0"),
        with(
            "[materials.chain]",
            "[seabed]\ndepth_m = 900.0\nslope_azimuth_deg = 30.0",
        ),
        traveller(""),
        traveller("speed_m_per_s = -1.0"),
        traveller("speed_m_per_s = 1.0\nto_m = 120.0"),
        traveller("speed_m_per_s = 1.0\nfrom_m = 40.0\nto_m = 40.0"),
        traveller("speed_m_per_s = 1.0\nfrom_m = 100.0"),
        traveller("speed_m_per_s = 1.0\ndrag_area_m2 = [1.0, 2.0]"),
        rotation("centre_of_drag = 2.0"),
        rotation("drag_length_m = -1.0"),
        rotation("spin_deg_per_s = 60.0"),
        rotation("spin_deg_per_s = 60.0\nspin_inertia_kg_m2 = 50.0"),
        rotation("start_tilt_deg = 200.0"),
        rotation("").replace("drag_area_m2 = 2.0", "drag_area_m2 = [2.0, 3.0, 2.0]"),
        rotation("").replace(
            "wet_mass_kg = 800.0",
            "wet_mass_kg = 800.0\nrelease_s = 3.0",
        ),
    ];
    let mut reported = String::new();
    for text in &spoilt {
        let found = faults(text);
        assert_eq!(found.len(), 1, "{found:#?}");
        writeln!(reported, "{}\n", found[0].render(false)).unwrap();
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_omit_expression(true);
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| insta::assert_snapshot!("bad_cases_of_bodies", reported));
}
