//! Materials, names, ends, reach and floats.

use seacable::case;

use super::{GOOD, assert_fault, faults, spoilt};

#[test]
fn unknown_material() {
    let fault = spoilt(
        "name = \"upper\"\nmaterial = \"chain\"",
        "name = \"upper\"\nmaterial = \"chian\"",
    );
    assert_fault(
        &fault,
        (17, 12),
        "line.upper.material",
        "there is no material named \"chian\"",
        "did you mean \"chain\"?",
    );
}

#[test]
fn name_used_twice() {
    let fault = spoilt("name = \"vessel\"", "name = \"upper\"");
    assert_fault(
        &fault,
        (28, 8),
        "ends.a.name",
        "the name \"upper\" is used twice",
        "a name of its own",
    );
}

#[test]
fn end_off_the_lines_reach() {
    let fault = spoilt(
        "kind = \"payload\"",
        "kind = \"payload\"\nposition_m = [0.0, 0.0, -1000.0]",
    );
    assert_fault(
        &fault,
        (35, 14),
        "ends.b.position_m",
        "off the line's reach: the ends are 1000 m apart and the line is 100 m long",
        "within 150 m of each other",
    );
    let taut = GOOD.replace(
        "kind = \"payload\"",
        "kind = \"payload\"\nposition_m = [0.0, 0.0, -101.0]",
    );
    assert!(case::parse(&taut, "taut").is_ok());
}

#[test]
fn held_end_without_position() {
    let fault = spoilt("position_m = [0.0, 0.0, 0.0]\n", "");
    assert_fault(
        &fault,
        (27, 1),
        "ends.a.position_m",
        "is missing",
        "position_m = [x, y, z]",
    );
}

#[test]
fn moving_end_without_period() {
    let fault = spoilt(
        "kind = \"fixed\"",
        "kind = \"moving\"\namplitude_m = [0.0, 0.0, 1.0]",
    );
    assert_fault(
        &fault,
        (27, 1),
        "ends.a.period_s",
        "is missing",
        "needs the period of its motion",
    );
}

#[test]
fn nothing_holds_the_line() {
    let fault = spoilt("kind = \"fixed\"", "kind = \"free\"");
    assert_fault(
        &fault,
        (34, 8),
        "ends.b.kind",
        "nothing holds the line",
        "start.shape = \"straight\"",
    );
}

#[test]
fn payload_without_an_end_and_end_without_payload() {
    let text = GOOD.replace("kind = \"payload\"", "kind = \"free\"");
    assert_fault(
        &faults(&text)[0],
        (36, 1),
        "payload",
        "no end carries the payload",
        "\"payload\", or remove [payload]",
    );
    let payload = "[payload]\ndry_mass_kg = 1000.0\nwet_mass_kg = 800.0\ndrag_area_m2 = 2.0\nadded_mass_kg = 500.0\n";
    let found = faults(&GOOD.replace(payload, ""));
    assert_fault(
        &found[0],
        (34, 8),
        "ends.b.kind",
        "carries a payload, and the case has none",
        "add a table [payload]",
    );
    let fault = spoilt(
        "kind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n",
        "kind = \"payload\"\nposition_m = [0.0, 0.0, 0.0]\n[start]\nshape = \"straight\"\n",
    );
    assert_fault(
        &fault,
        (36, 8),
        "ends.b.kind",
        "both ends carry the payload",
        "leave it on one end",
    );
    let turned = GOOD
        .replace(
            "kind = \"payload\"",
            "kind = \"fixed\"\nposition_m = [0.0, 0.0, -95.0]",
        )
        .replace(
            "kind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]",
            "kind = \"payload\"",
        );
    assert_fault(
        &faults(&turned)[0],
        (29, 8),
        "ends.a.kind",
        "the payload hangs at end B",
        "swap the tables of the ends",
    );
}

#[test]
fn floats_off_their_section() {
    let fault = spoilt("to_m = 30.0", "to_m = 90.0");
    assert_fault(
        &fault,
        (45, 8),
        "floats.upper.to_m",
        "reach beyond their section: 90 m",
        "section \"upper\" is 80 m long",
    );
    let fault = spoilt("from_m = 10.0", "from_m = 40.0");
    assert_fault(
        &fault,
        (44, 10),
        "floats.upper.from_m",
        "the stretch is empty",
        "begin before it ends",
    );
    let fault = spoilt("section = \"upper\"", "section = \"middle\"");
    assert_fault(
        &fault,
        (43, 11),
        "floats.middle.section",
        "there is no section named \"middle\"",
        "`upper` and `lower`",
    );
}

#[test]
fn bodies_off_their_section_or_without_a_name_of_their_own() {
    let with = |name: &str, at: f64| {
        let clump = format!(
            "[[clumps]]\nname = \"{name}\"\nsection = \"upper\"\nat_m = {at:.1}\nmass_kg = 5.0\nwet_mass_kg = 4.0\n\n[[floats]]"
        );
        GOOD.replace("[[floats]]", &clump)
    };
    assert!(case::parse(&with("weight", 20.0), "good.toml").is_ok());
    let found = faults(&with("weight", 81.0));
    assert_eq!(found.len(), 1, "{found:#?}");
    assert_fault(
        &found[0],
        (45, 8),
        "clumps.weight.at_m",
        "beyond its section: at 81 m",
        "section \"upper\" is 80 m long",
    );
    let found = faults(&with("vessel", 20.0));
    assert_eq!(found.len(), 1, "{found:#?}");
    assert_fault(
        &found[0],
        (43, 8),
        "clumps.vessel.name",
        "the name \"vessel\" is used twice",
        "a name of its own",
    );
}

#[test]
fn added_mass_of_a_clump_given_twice() {
    let clump = "[[clumps]]\nname = \"module\"\nsection = \"upper\"\nat_m = 5.0\nmass_kg = 10.0\nwet_mass_kg = -5.0";
    let faults = faults(&format!(
        "{GOOD}\n{clump}\nadded_mass_kg = 5.0\nadded_mass_normal_kg = 8.0\n"
    ));
    assert_eq!(faults.len(), 1, "{faults:#?}");
    let line = u32::try_from(GOOD.lines().count()).unwrap() + 8;
    assert_fault(
        &faults[0],
        (line, 17),
        "clumps.module.added_mass_kg",
        "is given beside `added_mass_normal_kg`",
        "leave it out for added mass across and along the line",
    );
}

#[test]
fn drag_of_a_clump_given_twice() {
    let clump = "[[clumps]]\nname = \"module\"\nsection = \"upper\"\nat_m = 5.0\nmass_kg = 10.0\nwet_mass_kg = -5.0";
    let faults = faults(&format!(
        "{GOOD}\n{clump}\ndrag_area_tangential_m2 = 0.5\ndrag_area_m2 = 2.0\n"
    ));
    assert_eq!(faults.len(), 1, "{faults:#?}");
    let line = u32::try_from(GOOD.lines().count()).unwrap() + 9;
    assert_fault(
        &faults[0],
        (line, 16),
        "clumps.module.drag_area_m2",
        "is given beside `drag_area_tangential_m2`",
        "leave it out for drag across and along the line",
    );
}
