//! Materials that creep without what their model needs, with what it has no use for, or stiffer at rest than in motion.

use seacable::case::Diagnostic;

use super::{assert_fault, spoilt};

const VISCOELASTIC: &str =
    "ea_n = 1e9\ncreep_model = \"viscoelastic\"\ndynamic_ea_n = 3e9\nslow_damping_n_s = 1e11";
const SYROPE: &str = "strain = [0.0, 0.02, 0.04]\ntension_n = [0.0, 1e6, 2e6]\ncreep_model = \"syrope\"\ndynamic_ea_n = 2e8\n\
     slow_damping_n_s = 1e10\npermanent_strain_ratio = 0.3";

/// What is wrong with a chain of these keys, which has no axial damping.
fn creeping(keys: &str) -> Diagnostic {
    spoilt("ea_n = 1e9\naxial_damping_ratio = 0.02", keys)
}

#[test]
fn a_rope_that_creeps_without_its_numbers() {
    for (line, key, remedy) in [
        (
            "\ndynamic_ea_n = 3e9",
            "dynamic_ea_n",
            "add `dynamic_ea_n = ...`",
        ),
        (
            "\nslow_damping_n_s = 1e11",
            "slow_damping_n_s",
            "how fast the rope creeps",
        ),
    ] {
        let fault = creeping(&VISCOELASTIC.replace(line, ""));
        let key = format!("materials.chain.{key}");
        assert_fault(&fault, (8, 1), &key, "is missing", remedy);
    }
    for (from, to, key, remedy) in [
        (
            "\npermanent_strain_ratio = 0.3",
            "",
            "permanent_strain_ratio",
            "or `working_curve_ea_n`",
        ),
        (
            "strain = [0.0, 0.02, 0.04]\ntension_n = [0.0, 1e6, 2e6]",
            "ea_n = 5e7",
            "strain",
            "needs its original curve",
        ),
        (
            "0.3",
            "0.3\nworking_curve = \"quadratic\"",
            "working_curve_shape",
            "the curve is quadratic",
        ),
    ] {
        let fault = creeping(&SYROPE.replace(from, to));
        let key = format!("materials.chain.{key}");
        assert_fault(&fault, (8, 1), &key, "is missing", remedy);
    }
}

#[test]
fn keys_of_a_creep_that_is_not_there() {
    let fault = creeping("ea_n = 1e9\nslow_damping_n_s = 1e11");
    assert_fault(
        &fault,
        (12, 1),
        "materials.chain.slow_damping_n_s",
        "has no effect: creep_model is not given",
        "add `creep_model = \"viscoelastic\"`",
    );
    let fault = creeping(&format!("{VISCOELASTIC}\npast_tension_n = 1e5"));
    assert_fault(
        &fault,
        (15, 1),
        "materials.chain.past_tension_n",
        "has no effect: creep_model is \"viscoelastic\"",
        "set `creep_model = \"syrope\"`",
    );
    let fault = creeping(&format!("{SYROPE}\nworking_curve_shape = 1.0"));
    assert_fault(
        &fault,
        (17, 1),
        "materials.chain.working_curve_shape",
        "has no effect: working_curve is \"linear\"",
        "set working_curve to \"quadratic\" or \"exponential\"",
    );
    let fault = creeping(&format!("{VISCOELASTIC}\naxial_damping_n_s = 1e5"));
    assert_fault(
        &fault,
        (15, 1),
        "materials.chain.axial_damping_n_s",
        "has no effect on a rope that creeps",
        "its dampers are slow_damping_n_s and fast_damping_n_s",
    );
}

#[test]
fn what_a_rope_that_creeps_cannot_have() {
    let fault = creeping(&format!("{VISCOELASTIC}\nei_n_m2 = 1e3"));
    assert_fault(
        &fault,
        (15, 11),
        "materials.chain.ei_n_m2",
        "a rope that creeps does not bend",
        "set it to 0",
    );
    let both = format!("{SYROPE}\nworking_curve_ea_n = 1e8");
    assert_fault(
        &creeping(&both),
        (17, 1),
        "materials.chain.working_curve_ea_n",
        "is given twice",
        "keep one of the two",
    );
    let falls = format!("{SYROPE}\nworking_curve = \"quadratic\"\nworking_curve_shape = 1.5");
    assert_fault(
        &creeping(&falls),
        (18, 23),
        "materials.chain.working_curve_shape",
        "makes a quadratic curve fall",
        "give a number from -1 to 1",
    );
}

#[test]
fn ropes_that_are_stiffer_at_rest_than_in_motion() {
    let fault = creeping(&VISCOELASTIC.replace("3e9", "9e8"));
    assert_fault(
        &fault,
        (13, 16),
        "materials.chain.dynamic_ea_n",
        "motion would meet no more stiffness than slow loading: 1e9 N",
        "give a dynamic_ea_n above the static stiffness",
    );
    let fault = creeping(&SYROPE.replace("2e8", "7e7"));
    assert_fault(
        &fault,
        (14, 16),
        "materials.chain.dynamic_ea_n",
        "than slow loading: 7.14e7 N",
        "softer working curves",
    );
}
