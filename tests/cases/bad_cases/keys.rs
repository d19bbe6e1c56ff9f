//! Keys that no table knows, lack their unit, or are missing.

use super::{assert_fault, spoilt};

#[test]
fn unknown_key() {
    let fault = spoilt("lift_kg = 100.0", "lift_kg = 100.0\ncolour = 3");
    assert_fault(
        &fault,
        (47, 1),
        "floats.upper.colour",
        "not a known key",
        "the keys known here are `section`",
    );
}

#[test]
fn misspelt_key_names_the_right_one_and_is_not_missing_too() {
    let fault = spoilt("length_m = 80.0", "lenght_m = 80.0");
    assert_fault(
        &fault,
        (18, 1),
        "line.upper.lenght_m",
        "not a known key",
        "did you mean `length_m`?",
    );
}

#[test]
fn key_of_another_table() {
    let fault = spoilt("drag_area_m2 = 2.0", "drag_area_m2 = 2.0\nduration_s = 5.0");
    assert_fault(
        &fault,
        (40, 1),
        "payload.duration_s",
        "not a known key",
        "belongs in `solver`",
    );
}

#[test]
fn unknown_table() {
    let fault = spoilt("[current]", "[curent]");
    assert_fault(
        &fault,
        (4, 2),
        "curent",
        "not a known key",
        "did you mean `current`?",
    );
}

#[test]
fn missing_key() {
    let fault = spoilt("ea_n = 1e9\n", "");
    assert_fault(
        &fault,
        (8, 1),
        "materials.chain.ea_n",
        "is missing",
        "add `ea_n = ...` (axial stiffness EA): greater than 0 N",
    );
}

#[test]
fn missing_table() {
    let fault = spoilt("[case]\ntitle = \"Test\"\n", "");
    assert_fault(&fault, (1, 1), "case", "is missing", "add [case]");
}

#[test]
fn missing_unit() {
    let fault = spoilt("length_m = 80.0", "length = 80.0");
    assert_fault(
        &fault,
        (18, 1),
        "line.upper.length",
        "has no unit in its name",
        "write `length_m`, with the value in m",
    );
}

#[test]
fn wrong_unit() {
    let fault = spoilt("diameter_m = 0.1", "diameter_mm = 100.0");
    assert_fault(
        &fault,
        (9, 1),
        "materials.chain.diameter_mm",
        "has the wrong unit",
        "write `diameter_m`, with the value in m",
    );
    let fault = spoilt("dry_mass_kg = 1000.0", "dry_mass_t = 1.0");
    assert_fault(
        &fault,
        (37, 1),
        "payload.dry_mass_t",
        "has the wrong unit",
        "write `dry_mass_kg`, with the value in kg",
    );
}

#[test]
fn key_given_twice() {
    let fault = spoilt("ea_n = 1e9", "ea_n = 1e9\nea_n = 2e9");
    assert_fault(&fault, (12, 1), "", "duplicate key", "key = value");
}
