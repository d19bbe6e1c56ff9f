//! Arrays of floating turbines: those of RAFT with shared lines, and those of `FAModel`.

use std::fs;

use seacable::system::SystemFile;
use seacable::system::quantities::value;

use super::foreign_yaml::{FAMODEL, MOORDYN, RAFT, assert_fairlead, case_of, read, solved};

/// Two turbines with the mooring of [`RAFT`].
fn array(rows: &str) -> String {
    format!(
        "{RAFT}\narray:\n  keys: [turbineID, platformID, mooringID, x_location, y_location, heading_adjust]\n  data:\n{rows}"
    )
}

#[test]
fn an_array_places_and_turns_the_mooring_of_each_turbine() {
    let text = array("    - [1, 1, 1, 0, 0, 0]\n    - [1, 1, 1, 2000, 100, 90]\n");
    let system = solved(&case_of(&text));
    assert_eq!(
        (system.network.bodies.len(), system.network.lines.len()),
        (2, 6)
    );
    let [one, other] = ["t1-line1", "t2-line1"]
        .map(|line| value(&system, &format!("tension_n[{line}|b]")).unwrap());
    assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
    let case = case_of(&text);
    let turned = case.split("[points.t2-anchor1]").nth(1).unwrap();
    let place = turned
        .lines()
        .find(|line| line.starts_with("position_m"))
        .unwrap();
    assert!(place.contains("[2000.0, -737.6, -200.0]"), "{place}");
    for (rows, problem) in [
        ("    - [1, 1, 2, 0, 0, 0]\n", "no mooring 2"),
        ("    - [1, 1, 0, 0, 0, 0]\n", "no `array_mooring`"),
        (
            "    - [1, 1, 0.5, 0, 0, 0]\n",
            "not the number of a mooring",
        ),
        ("    - [1, 1, 1, 0, 0]\n", "5 values for 6 keys"),
        ("    []\n", "no rows"),
    ] {
        let all = read(&array(rows)).unwrap_err();
        assert!(
            all.iter().any(|fault| fault.problem.contains(problem)),
            "{rows}: {all:#?}"
        );
    }
}

#[test]
fn turbines_share_the_lines_of_a_file() {
    let dir = tempfile::tempdir().unwrap();
    let shared = MOORDYN
        .replace("1 Fixed 853.87 0 -320", "1 Turbine2 -5.2 0 -70")
        .replace("2 Vessel 5.2 0 -70", "2 Turbine1 5.2 0 -70")
        .replace(
            "--- POINTS",
            "--- BODIES ---\nID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*\n(#) (-)\n--- POINTS",
        );
    fs::write(dir.path().join("shared.dat"), shared).unwrap();
    let path = dir.path().join("farm.yaml");
    let rows = "    - [1, 1, 1, 0, 0, 0]\n    - [1, 1, 1, 880, 0, 180]\narray_mooring:\n  file: shared.dat\n";
    fs::write(&path, array(rows)).unwrap();
    let loaded = seacable::open::load::<SystemFile>(&path).unwrap();
    let network = &loaded.computed.network;
    assert_eq!((network.bodies.len(), network.lines.len()), (2, 7));
    let ends =
        ["a", "b"].map(|end| value(&loaded.computed, &format!("tension_n[line1|{end}]")).unwrap());
    assert!((ends[0] / ends[1] - 1.0).abs() < 1e-6, "{ends:?}");
}

#[test]
fn an_array_of_famodel_has_the_lines_of_each_platform() {
    let case = case_of(FAMODEL);
    let system = solved(&case);
    let network = &system.network;
    assert_eq!((network.bodies.len(), network.lines.len()), (2, 8));
    let raft = value(&solved(&case_of(RAFT)), "tension_n[line1|b]").unwrap();
    for line in ["one-1-s1", "one-3-s1", "two-1-s1"] {
        assert_fairlead(&system, line, raft, 1e-9);
    }
    // A link without weight changes nothing.
    assert_fairlead(&system, "one-2-s2", raft, 1e-6);
    // 270 degrees of a compass is west; turned by 90 it is north.
    let anchor = case.split("[points.two-1-p0]").nth(1).unwrap();
    let place = anchor
        .lines()
        .find(|line| line.starts_with("position_m"))
        .unwrap();
    let numbers: Vec<f64> = place
        .split(['[', ']'])
        .nth(1)
        .unwrap()
        .split(',')
        .map(|number| number.trim().parse().unwrap())
        .collect();
    for (number, wanted) in numbers.iter().zip([2500.0, 937.6, -200.0]) {
        assert!((number - wanted).abs() < 1e-9, "{place}");
    }
    assert!(case.contains("Cables of the array are not read."));
    assert!(case.contains("# line 44, EA"), "{case}");
}

#[test]
fn fairleads_of_famodel_may_be_a_list_or_in_a_file() {
    let raft = value(&solved(&case_of(RAFT)), "tension_n[line1|b]").unwrap();
    let list = "- type: FOWT\n  fairleads:\n  - {r_rel: [58, 0, -14], headings: [270, 30, 150]}\n";
    let own = "- {type: FOWT, rFair: 58.0, zFair: -14.0}\n";
    assert!(FAMODEL.contains(own));
    let text = FAMODEL.replace(own, list);
    let system = solved(&case_of(&text));
    for line in ["one-1-s1", "two-3-s1"] {
        assert_fairlead(&system, line, raft, 1e-9);
    }
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("array.yaml");
    fs::write(&path, FAMODEL.replace(own, "- !include volturn.yaml\n")).unwrap();
    let all = seacable::open::load::<SystemFile>(&path).unwrap_err();
    assert_eq!(
        (all.len(), all[0].line, all[0].column),
        (1, 19, 3),
        "{all:#?}"
    );
    fs::write(dir.path().join("volturn.yaml"), "rFair: 58\n").unwrap();
    let all = seacable::open::load::<SystemFile>(&path).unwrap_err();
    assert!(all[0].key.contains("volturn.yaml.zFair"), "{all:#?}");
    assert_eq!(all[0].line, 19);
    for (included, place) in [
        ("type: FOWT\n\trFair: 5\n", "line 2, column 1"),
        ("type: FOWT\nrFair: -5\nzFair: -14\n", "line 2, column 8"),
        ("rFair: 58\nrFair: 58\nzFair: -14\n", "line 2, column 1"),
    ] {
        fs::write(dir.path().join("volturn.yaml"), included).unwrap();
        let all = seacable::open::load::<SystemFile>(&path).unwrap_err();
        let problem = &all[0].problem;
        let place = format!("in `volturn.yaml`, {place}: ");
        assert!(problem.starts_with(&place) && all[0].line == 19, "{all:#?}");
    }
    fs::write(dir.path().join("volturn.yaml"), "rFair: 58\nzFair: -14\n").unwrap();
    let loaded = seacable::open::load::<SystemFile>(&path).unwrap();
    assert_fairlead(&loaded.computed, "two-1-s1", raft, 1e-9);
}

#[test]
fn faults_of_an_array_of_famodel_are_at_their_rows() {
    let faults = [
        (
            "one, 1, 1, ms1",
            "one, 1, 1, ms2",
            15,
            "no mooring system `ms2`",
        ),
        ("one, 1, 1, ms1", "one, 1, 4, ms1", 15, "no platform 4"),
        (
            "[plain, 270.0, drag]",
            "[plane, 270.0, drag]",
            24,
            "no configuration `plane`",
        ),
        (
            "[plain, 270.0, drag]",
            "[plain, west, drag]",
            24,
            "not a number",
        ),
        (
            "[plain, 270.0, drag]",
            "[plain, 270.0]",
            24,
            "2 values for 3 keys",
        ),
        ("      length: 850.0\n", "", 32, "no `length`"),
        ("length: 850.0", "length: 0", 33, "not above 0"),
        (
            "connectorType: link",
            "connectorType: ring",
            40,
            "no connector type `ring`",
        ),
        ("EA: 3.27e9", "EA: stiff", 44, "not a number"),
        (
            "    - [200.0, 200.0]\n",
            "    - [200.0, 300.0]\n",
            6,
            "other depths",
        ),
        ("cables: []", "array_mooring: {}", 48, "share"),
        (", zFair: -14.0", "", 19, "no `zFair`"),
    ];
    for (of, by, line, problem) in faults {
        assert!(FAMODEL.contains(of), "{of}");
        let all = read(&FAMODEL.replacen(of, by, 1)).expect_err(by);
        let found = all.iter().find(|fault| fault.problem.contains(problem));
        assert_eq!(found.map(|fault| fault.line), Some(line), "{by}: {all:#?}");
    }
}
