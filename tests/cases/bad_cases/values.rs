//! Values of the wrong type, out of range, or not finite.

use super::{GOOD, assert_fault, faults, spoilt};

#[test]
fn wrong_type() {
    let fault = spoilt("length_m = 80.0", "length_m = true");
    assert_fault(
        &fault,
        (18, 12),
        "line.upper.length_m",
        "must be a number, and is true or false",
        "greater than 0 m",
    );
    let fault = spoilt("segments = 8", "segments = 8.0");
    assert_fault(
        &fault,
        (19, 12),
        "line.upper.segments",
        "must be a whole number without a decimal point",
        "a whole number from 1 to 10000",
    );
    let fault = spoilt("title = \"Test\"", "title = 5");
    assert_fault(
        &fault,
        (2, 9),
        "case.title",
        "must be text in quotes, and is a whole number",
        "text",
    );
}

#[test]
fn unit_in_the_value() {
    let fault = spoilt("length_m = 80.0", "length_m = \"80 m\"");
    assert_fault(
        &fault,
        (18, 12),
        "line.upper.length_m",
        "must be a number, and is text",
        "without quotes and without a unit, with the value in m: length_m = 80",
    );
}

#[test]
fn a_number_as_one_types_it() {
    for (typed, problem, remedy) in [
        (
            "0.5 km",
            "must be a number, and is text",
            "the value in m, without quotes and without a unit: length_m = 500",
        ),
        (
            "5 furlongs",
            "must be a number, and is text",
            "the value in m, without quotes and without a unit",
        ),
        (
            "1,5",
            "is not a number: 1,5",
            "with a decimal point: length_m = 1.5",
        ),
        (
            "2*250",
            "is not a number: 2*250",
            "the result, nothing is computed here: length_m = 500",
        ),
    ] {
        let fault = spoilt("length_m = 80.0", &format!("length_m = \"{typed}\""));
        assert_fault(&fault, (18, 12), "line.upper.length_m", problem, remedy);
    }
}

#[test]
fn table_written_as_a_value() {
    let fault = spoilt(
        "[marks]\n\"payload.drag_area_m2\" = { status = \"assumed\", reason = \"a guess\" }",
        "[marks]\n\"payload.drag_area_m2\" = \"assumed\"",
    );
    assert_fault(
        &fault,
        (49, 26),
        "marks.\"payload.drag_area_m2\"",
        "must be written as [marks.<name>], and is text",
        "[marks.<name>]",
    );
}

#[test]
fn list_written_as_a_table() {
    let text = GOOD.replace("[[floats]]", "[floats]");
    let found = faults(&text);
    assert_fault(
        &found[0],
        (42, 1),
        "floats",
        "must be written as [[floats]], and is a table",
        "[[floats]]",
    );
}

#[test]
fn negative_length() {
    let fault = spoilt("length_m = 80.0", "length_m = -80.0");
    assert_fault(
        &fault,
        (18, 12),
        "line.upper.length_m",
        "is out of range: -80 m",
        "give greater than 0 m, up to 1e5 m",
    );
}

#[test]
fn zero_segments() {
    let fault = spoilt("segments = 8", "segments = 0");
    assert_fault(
        &fault,
        (19, 12),
        "line.upper.segments",
        "is out of range: 0",
        "give a whole number from 1 to 10000",
    );
}

#[test]
fn not_a_number_and_infinite() {
    let fault = spoilt("ea_n = 1e9", "ea_n = nan");
    assert_fault(
        &fault,
        (11, 8),
        "materials.chain.ea_n",
        "must be a finite number, and is nan",
        "greater than 0 N",
    );
    let fault = spoilt("ea_n = 1e9", "ea_n = inf");
    assert_fault(
        &fault,
        (11, 8),
        "materials.chain.ea_n",
        "must be a finite number, and is inf",
        "greater than 0 N",
    );
    let fault = spoilt(
        "position_m = [0.0, 0.0, 0.0]",
        "position_m = [0.0, nan, 0.0]",
    );
    assert_fault(
        &fault,
        (30, 20),
        "ends.a.position_m",
        "must be a finite number, and is nan",
        "along x, y, z",
    );
}

#[test]
fn wrong_count() {
    let fault = spoilt("position_m = [0.0, 0.0, 0.0]", "position_m = [0.0, 0.0]");
    assert_fault(
        &fault,
        (30, 14),
        "ends.a.position_m",
        "must hold 3 numbers, and holds 2",
        "three numbers along x, y, z",
    );
}

#[test]
fn unknown_word() {
    let fault = spoilt("kind = \"fixed\"", "kind = \"fixd\"");
    assert_fault(
        &fault,
        (29, 8),
        "ends.a.kind",
        "is not known: \"fixd\"",
        "did you mean \"fixed\"?",
    );
    let fault = spoilt("drag_normal = 1.2", "drag_normal = \"jia\"");
    assert_fault(
        &fault,
        (13, 15),
        "materials.chain.drag_normal",
        "is not known: \"jia\"",
        "`jia-2019-normal`",
    );
}

#[test]
fn name_that_channels_cannot_carry() {
    let fault = spoilt("name = \"vessel\"", "name = \"the|vessel\"");
    assert_fault(
        &fault,
        (28, 8),
        "ends.a.name",
        "is not a usable name",
        "letters, digits, - and _",
    );
}
