//! Materials whose stiffness is given twice, by half or by a table that does not rise.

use super::{assert_fault, spoilt};

const TABLE: &str = "strain = [0.0, 0.1, 0.2]\ntension_n = [0.0, 1e5, 4e5]";

#[test]
fn stiffness_given_twice() {
    let fault = spoilt("ea_n = 1e9", &format!("ea_n = 1e9\n{TABLE}"));
    assert_fault(
        &fault,
        (12, 1),
        "materials.chain.strain",
        "the stiffness is given twice, by ea_n and by a table of strain and tension_n",
        "keep one of the two",
    );
}

#[test]
fn half_a_table() {
    let fault = spoilt("ea_n = 1e9", "ea_n = 1e9\ntension_n = [0.0, 1e5]");
    assert_fault(
        &fault,
        (12, 1),
        "materials.chain.tension_n",
        "is half a table: strain is missing",
        "add `strain = [0.0, ...]`, as long as tension_n, or remove tension_n",
    );
    let fault = spoilt("ea_n = 1e9", "strain = [0.0, 0.1]");
    assert_fault(
        &fault,
        (11, 1),
        "materials.chain.strain",
        "is half a table: tension_n is missing",
        "add `tension_n = [0.0, ...]`",
    );
}

#[test]
fn lists_of_unlike_length() {
    let fault = spoilt("ea_n = 1e9", &TABLE.replace(", 4e5", ""));
    assert_fault(
        &fault,
        (12, 13),
        "materials.chain.tension_n",
        "has 2 values for 3 strains",
        "give one tension for each strain",
    );
}

#[test]
fn tables_that_do_not_rise_from_zero() {
    let fault = spoilt("ea_n = 1e9", &TABLE.replace("1e5", "5e5"));
    assert_fault(
        &fault,
        (12, 24),
        "materials.chain.tension_n",
        "does not rise: 4e5 comes after 5e5",
        "give values that grow from one to the next",
    );
    let fault = spoilt(
        "ea_n = 1e9",
        &TABLE.replace("[0.0, 0.1, 0.2]", "[0.01, 0.1, 0.2]"),
    );
    assert_fault(
        &fault,
        (11, 11),
        "materials.chain.strain",
        "begins at 0.01",
        "begin at 0",
    );
    let fault = spoilt("ea_n = 1e9", "strain = [0.0]\ntension_n = [0.0, 1.0]");
    assert_fault(
        &fault,
        (11, 10),
        "materials.chain.strain",
        "is a table of one point",
        "give at least two values",
    );
}

#[test]
fn dynamic_stiffness_without_its_numbers() {
    let words = "ea_n = 1e9\ndynamic_stiffness = \"secant\"\nbreak_load_n = 1e7";
    let fault = spoilt("ea_n = 1e9", words);
    assert_fault(
        &fault,
        (8, 1),
        "materials.chain.dynamic_alpha",
        "is missing",
        "add `dynamic_alpha = ...`",
    );
    let words = "ea_n = 1e9\ndynamic_stiffness = \"secant\"\ndynamic_alpha = 14.0";
    let fault = spoilt("ea_n = 1e9", words);
    assert_fault(
        &fault,
        (8, 1),
        "materials.chain.break_load_n",
        "is missing",
        "the breaking load that the stiffness refers to",
    );
}

#[test]
fn numbers_of_a_dynamic_stiffness_that_is_not_there() {
    let fault = spoilt("ea_n = 1e9", "ea_n = 1e9\ndynamic_gamma = 0.3");
    assert_fault(
        &fault,
        (12, 1),
        "materials.chain.dynamic_gamma",
        "has no effect: dynamic_stiffness is not given",
        "add `dynamic_stiffness = \"secant\"`",
    );
    let fault = spoilt("ea_n = 1e9", "ea_n = 1e9\nstiffness_scope = \"rope\"");
    assert_fault(
        &fault,
        (12, 1),
        "materials.chain.stiffness_scope",
        "has no effect: dynamic_stiffness is not given",
        "add `dynamic_stiffness = \"secant\"`",
    );
    let fault = spoilt("ea_n = 1e9", "ea_n = 1e9\ndynamic_stiffness = \"cosecant\"");
    assert_fault(
        &fault,
        (12, 21),
        "materials.chain.dynamic_stiffness",
        "is not known: \"cosecant\"",
        "did you mean \"secant\"?",
    );
}

#[test]
fn a_rope_with_dynamic_stiffness_does_not_bend() {
    let words = "ea_n = 1e9\ndynamic_stiffness = \"secant\"\ndynamic_alpha = 14.0\nbreak_load_n = 1e7\nei_n_m2 = 1e3";
    let fault = spoilt("ea_n = 1e9", words);
    assert_fault(
        &fault,
        (15, 11),
        "materials.chain.ei_n_m2",
        "a rope with dynamic stiffness does not bend",
        "set it to 0",
    );
}

#[test]
fn bores_that_are_none() {
    let bore = |keys: &str| format!("ea_n = 1e9\nbore = {{ {keys} }}");
    let fault = spoilt("ea_n = 1e9", &bore("diameter_m = 0.1"));
    assert_fault(
        &fault,
        (12, 23),
        "materials.chain.bore.diameter_m",
        "is no bore of a pipe 0.1 m wide",
        "give less than diameter_m",
    );
    let heavy = bore("diameter_m = 0.09, content_density_kg_per_m3 = 2e4");
    let light = heavy.replace("ea_n = 1e9", "ea_n = 1e9\nbreak_load_n = 1e7");
    let fault = spoilt(
        "mass_kg_per_m = 200.0\nea_n = 1e9",
        &format!("mass_kg_per_m = 100.0\n{light}"),
    );
    assert_fault(
        &fault,
        (13, 57),
        "materials.chain.bore.content_density_kg_per_m3",
        "the content alone weighs 127.235 kg/m, and mass_kg_per_m, of which it is part, is 100",
        "give the mass of pipe and content as mass_kg_per_m",
    );
}

#[test]
fn wall_tension_of_what_is_no_pipe() {
    let fault = spoilt(
        "channel = \"tension_n[lower|load]\"",
        "channel = \"wall_tension_n[lower.b]\"",
    );
    assert_fault(
        &fault,
        (58, 11),
        "published.\"tension at the load\".channel",
        "section lower has no wall tension: its material chain is no pipe with a bore",
        "add [materials.chain.bore] with its diameter_m",
    );
}
