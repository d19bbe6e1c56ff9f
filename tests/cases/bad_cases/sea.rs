//! Waves.

use super::{assert_fault, spoilt};

/// The good case with waves of these keys before its first line of line.
fn waves(keys: &str) -> seacable::case::Diagnostic {
    let text = format!("[waves]\n{keys}\n\n[materials.chain]");
    spoilt("[materials.chain]", &text)
}

#[test]
fn heights_of_the_wrong_kind() {
    let fault =
        waves("kind = \"regular\"\nheight_m = 2.0\nsignificant_height_m = 2.0\nperiod_s = 8.0");
    assert_fault(
        &fault,
        (11, 1),
        "waves.significant_height_m",
        "belongs to a table with kind = \"irregular\"",
        "remove it",
    );
    let fault = waves("kind = \"irregular\"\nsignificant_height_m = 2.0");
    assert_fault(
        &fault,
        (8, 1),
        "waves.peak_period_s",
        "is missing",
        "add `peak_period_s",
    );
}

#[test]
fn keys_without_effect() {
    let irregular = "kind = \"irregular\"\nsignificant_height_m = 2.0\npeak_period_s = 8.0\n";
    let fault = waves(&format!(
        "{irregular}spectrum = \"pierson-moskowitz\"\ngamma = 2.0"
    ));
    assert_fault(&fault, (13, 9), "waves.gamma", "has no effect", "jonswap");
    let fault = waves(&format!("{irregular}decay_depth_m = 100.0"));
    assert_fault(
        &fault,
        (12, 17),
        "waves.decay_depth_m",
        "has no effect",
        "airy-cut",
    );
    let fault = waves(&format!(
        "{irregular}depth_m = 100.0\n[seabed]\ndepth_m = 100.0"
    ));
    assert_fault(
        &fault,
        (12, 11),
        "waves.depth_m",
        "given twice",
        "remove it",
    );
}

/// The good case with this motion of its vessel.
fn moving(keys: &str) -> seacable::case::Diagnostic {
    spoilt(
        "kind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]",
        &format!("kind = \"moving\"\nposition_m = [0.0, 0.0, 0.0]\n{keys}"),
    )
}

#[test]
fn motions_without_what_they_need() {
    let fault = moving("motion = \"table\"");
    assert_fault(
        &fault,
        (31, 10),
        "ends.a.motion_file",
        "is missing",
        "time_s,x_m,y_m,z_m",
    );
    let fault = moving("motion = \"irregular\"\nrms_m = [1.0, 0.0, 0.5]");
    assert_fault(
        &fault,
        (31, 10),
        "ends.a.peak_period_s",
        "is missing",
        "in s",
    );
    let fault = moving("motion = \"vessel\"\nmotion_file = \"rao.csv\"");
    assert_fault(
        &fault,
        (31, 10),
        "ends.a.motion",
        "the case has none",
        "add [waves]",
    );
    let fault = moving("motion = \"table\"\nmotion_file = \"no_such_file.csv\"");
    assert_fault(
        &fault,
        (32, 15),
        "ends.a.motion_file",
        "cannot be read",
        "beside the case file",
    );
}
