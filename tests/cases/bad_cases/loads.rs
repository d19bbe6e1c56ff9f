//! Current, damping, payload and output.

use super::{assert_fault, spoilt};

#[test]
fn current_table() {
    let fault = spoilt("depth_m = [0.0, 100.0]\n", "");
    assert_fault(
        &fault,
        (5, 17),
        "current.speed_m_per_s",
        "the depths it belongs to are missing",
        "with 2 depths in m",
    );
    let fault = spoilt("depth_m = [0.0, 100.0]", "depth_m = [0.0, 50.0, 100.0]");
    assert_fault(
        &fault,
        (5, 17),
        "current.speed_m_per_s",
        "has 2 values for 3 depths",
        "one value for each depth",
    );
    let fault = spoilt("depth_m = [0.0, 100.0]", "depth_m = [100.0, 0.0]");
    assert_fault(
        &fault,
        (6, 19),
        "current.depth_m",
        "must increase: 0 m follows 100 m",
        "from the surface down",
    );
    let fault = spoilt("speed_m_per_s = [0.5, 0.2]", "speed_m_per_s = 0.5");
    assert_fault(
        &fault,
        (6, 11),
        "current.depth_m",
        "has no effect",
        "a list of speeds",
    );
}

#[test]
fn friction_without_effect() {
    let with = |bed: &str| {
        spoilt(
            "[materials.chain]",
            &format!("[seabed]\ndepth_m = 900.0\n{bed}\n[materials.chain]"),
        )
    };
    let fault = with("friction_law = \"zhu-2017\"");
    assert_fault(
        &fault,
        (10, 16),
        "seabed.friction_law",
        "has no effect: the bed has no friction",
        "add `friction = ...`",
    );
    let fault = with("friction = 0.5\nslip_speed_m_per_s = 0.1");
    assert_fault(
        &fault,
        (11, 22),
        "seabed.slip_speed_m_per_s",
        "has no effect with the friction law `grip`",
        "choose the other law",
    );
    let fault = with("friction = 0.5\nfriction_law = \"zhu-2017\"\nfriction_lateral = 0.7");
    assert_fault(
        &fault,
        (12, 20),
        "seabed.friction_lateral",
        "has no effect with the friction law `zhu-2017`",
        "choose the other law",
    );
}

#[test]
fn a_payload_that_turns_without_an_axis() {
    let turns = "\n[payload.rotation]\ncentre_of_gravity_m = 2.0\ninertia_kg_m2 = 10.0\n\n";
    let case = |payload: &str| {
        format!(
            "case.title = \"c\"\nmaterials.m = {{ diameter_m = 0.1, mass_kg_per_m = 9.0, ea_n = 1e8 }}\n\
             line = [{{ name = \"s\", material = \"m\", length_m = 9.0, segments = 2 }}]\n\
             ends.a = {{ name = \"a\", kind = \"fixed\", position_m = [0, 0, 0] }}\n\
             ends.b = {{ name = \"b\", kind = \"payload\" }}\n[payload]\ndry_mass_kg = 9.0\nvolume_m3 = 0.0\n{payload}\n{turns}"
        )
    };
    let faults = |text: &str| {
        seacable::case::parse(text, "t.toml")
            .err()
            .unwrap_or_default()
    };
    assert_eq!(
        faults(&case("drag_area_m2 = 2.0\nadded_mass_kg = [3, 3, 1]")),
        []
    );
    let reported = faults(&case("drag_area_m2 = [2.0, 3.0, 1.0]\nadded_mass_kg = 1.0"));
    assert_eq!(reported.len(), 1, "{reported:?}");
    assert_eq!(
        (reported[0].line, reported[0].key.as_str()),
        (9, "payload.drag_area_m2")
    );
    assert!(
        reported[0].problem.contains("symmetric about its axis"),
        "{reported:?}"
    );
    let shape = "shape = { kind = \"box\", length_m = 3.0, breadth_m = 2.0, height_m = 1.0 }";
    let reported = faults(&case(&format!("drag_area_m2 = 2.0\n{shape}")));
    assert_eq!(reported.len(), 1, "{reported:?}");
    assert_eq!(reported[0].key, "payload.shape");
    assert_eq!(
        faults(&case(&format!(
            "drag_area_m2 = 2.0\nadded_mass_kg = 1.0\n{shape}"
        ))),
        []
    );
}

#[test]
fn damping_given_twice() {
    let fault = spoilt(
        "axial_damping_ratio = 0.02",
        "axial_damping_ratio = 0.02\naxial_damping_n_s = 1e5",
    );
    assert_fault(
        &fault,
        (13, 1),
        "materials.chain.axial_damping_n_s",
        "given twice",
        "keep one",
    );
}

#[test]
fn payload_weight() {
    let fault = spoilt(
        "wet_mass_kg = 800.0",
        "wet_mass_kg = 800.0\nvolume_m3 = 0.2",
    );
    assert_fault(
        &fault,
        (39, 13),
        "payload.volume_m3",
        "given twice",
        "keep one",
    );
    let fault = spoilt("wet_mass_kg = 800.0", "wet_mass_kg = 1800.0");
    assert_fault(
        &fault,
        (38, 15),
        "payload.wet_mass_kg",
        "more than the 1000 kg in air",
        "less the mass of the displaced water",
    );
    let fault = spoilt("wet_mass_kg = 800.0\n", "");
    assert_fault(
        &fault,
        (36, 1),
        "payload.wet_mass_kg",
        "the weight in water is not known",
        "volume_m3",
    );
}

#[test]
fn payload_shape_of_another_kind() {
    let shape = "added_mass_kg = 500.0\nshape = { kind = \"box\", length_m = 1.0, breadth_m = 1.0, height_m = 1.0, sphere_diameter_m = 2.0 }";
    let fault = spoilt("added_mass_kg = 500.0", shape);
    assert_fault(
        &fault,
        (41, 74),
        "payload.shape.sphere_diameter_m",
        "belongs to a table with kind = \"sphere-and-cylinder\"",
        "remove it",
    );
    let shape =
        "added_mass_kg = 500.0\nshape = { kind = \"box\", length_m = 1.0, breadth_m = 1.0 }";
    let fault = spoilt("added_mass_kg = 500.0", shape);
    assert_fault(
        &fault,
        (41, 9),
        "payload.shape.height_m",
        "is missing",
        "box height",
    );
}

#[test]
fn more_output_than_a_disk_holds() {
    let fault = spoilt("[marks]", "[output]\ninterval_s = 1e-6\n[marks]");
    assert_fault(
        &fault,
        (49, 14),
        "output.interval_s",
        "rows in 600 s",
        "at least",
    );
}
