//! What `--json` prints, against the schema that comes with the program, and how systems are refused on the command line.

use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::PredicateBooleanExt;
use predicates::str::contains;
use serde_json::Value;

use crate::small::SMALL;

const AGED: &str = include_str!("../../cases/systems/aged_chains.toml");
const OC3: &str = include_str!("../../cases/systems/oc3_spar.toml");
const SCHEMA: &str = include_str!("../../docs/output.schema.json");

fn seacable(dir: &Path) -> Command {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1");
    command
}

/// A directory with a small line case and a system.
fn folder() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("small.toml"), SMALL).unwrap();
    std::fs::write(dir.path().join("oc3.toml"), OC3).unwrap();
    dir
}

fn printed(dir: &Path, words: &[&str]) -> Value {
    let output = seacable(dir).args(words).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Every key that the schema requires of this kind of object is there, and no other.
pub(crate) fn fits(object: &Value, kind: &str) {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let required = schema["$defs"][kind]["required"].as_array().unwrap();
    let mut required: Vec<&str> = required.iter().filter_map(Value::as_str).collect();
    let mut given: Vec<&str> = object
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    required.sort_unstable();
    given.sort_unstable();
    assert_eq!(given, required, "{kind}");
}

#[test]
fn a_system_as_json() {
    let dir = folder();
    let system = printed(dir.path(), &["run", "oc3.toml", "--json"]);
    fits(&system, "system");
    assert!(system["ageing"].is_null());
    let lines = system["lines"].as_array().unwrap();
    assert_eq!(lines.len(), 3);
    for line in lines {
        fits(line, "line");
        assert!((line["tension_b_n"].as_f64().unwrap() / 911_089.457 - 1.0).abs() < 1e-8);
        assert!(line["error_n"].as_f64().unwrap() < 1e-6);
        // The line pulls its fairlead down and its anchor along the bed.
        assert!(line["force_b_n"][2].as_f64().unwrap() < 0.0);
        assert_eq!(line["force_a_n"][2].as_f64().unwrap(), 0.0);
    }
    assert_eq!(lines[1]["name"], "mooring@120");
    fits(&system["goals"][0], "goal");
    assert!((system["goals"][0]["comes_to"].as_f64().unwrap() / 9.5e5 - 1.0).abs() < 1e-9);
    fits(&system["stability"], "stability");
    fits(&system["points"][0], "point");
    fits(&system["bodies"][0], "body");
    let surge = system["bodies"][0]["stiffness"][0][0].as_f64().unwrap();
    assert!((surge / 41_180.0 - 1.0).abs() < 0.003);
}

#[test]
fn an_aged_system_as_json() {
    let dir = folder();
    std::fs::write(dir.path().join("aged.toml"), AGED).unwrap();
    let system = printed(dir.path(), &["run", "aged.toml", "--json"]);
    fits(&system, "system");
    fits(&system["ageing"], "ageing");
    assert_eq!(system["ageing"]["years"], 20.0);
    assert_eq!(system["ageing"]["growth_m"], 0.1);
    let share = system["lines"][0]["share_of_breaking_load"]
        .as_f64()
        .unwrap();
    assert!((share - 0.3).abs() < 0.01, "{share}");
}

#[test]
fn a_run_and_a_validation_as_json() {
    let dir = folder();
    let run = printed(dir.path(), &["run", "small.toml", "--out", "one", "--json"]);
    fits(&run, "run");
    let results = run["results"].as_array().unwrap();
    assert!(!results.is_empty());
    fits(&results[0], "result");
    let validation = printed(dir.path(), &["validate", "oc3.toml", "--json"]);
    fits(&validation, "validation");
    assert_eq!(validation["files"][0]["rows"].as_array().unwrap().len(), 10);
}

#[test]
fn analyses_as_json() {
    let dir = folder();
    let words = [
        "study",
        "watch-circle",
        "oc3.toml",
        "--load",
        "5e5",
        "--headings",
        "6",
        "--json",
    ];
    let circle = printed(dir.path(), &words);
    fits(&circle, "watch_circle");
    fits(&circle["intact"][0], "offset_point");
    fits(&circle["line_lost"][0], "line_lost");
    assert_eq!(circle["intact"].as_array().unwrap().len(), 6);
    assert_eq!(circle["line_lost"].as_array().unwrap().len(), 3);
    let words = [
        "study", "offsets", "oc3.toml", "--to", "10", "--steps", "5", "--json",
    ];
    let offsets = printed(dir.path(), &words);
    fits(&offsets, "offsets");
    assert_eq!(offsets["points"].as_array().unwrap().len(), 6);
    let want = "tension_n[mooring|b]=9.5e5";
    let key = "lines.mooring.length_m";
    let words = [
        "study",
        "seek",
        "oc3.toml",
        "--vary",
        key,
        "--between",
        "890..910",
        "--want",
        want,
        "--json",
    ];
    let found = printed(dir.path(), &words);
    fits(&found, "seek");
    assert!((found["comes_to"].as_f64().unwrap() / 9.5e5 - 1.0).abs() < 1e-9);
}

#[test]
fn modes_and_studies_as_json() {
    let dir = folder();
    let heavy = format!("{OC3}\n").replace(
        "[bodies.spar]\n",
        "[bodies.spar]\nmass_kg = 8.1e6\ninertia_kg_m2 = [6e10, 6e10, 2e8]\n",
    );
    std::fs::write(dir.path().join("heavy.toml"), heavy).unwrap();
    let modes = printed(dir.path(), &["modes", "heavy.toml", "--json"]);
    fits(&modes, "modes");
    fits(&modes["modes"][0], "mode");
    assert_eq!(modes["modes"].as_array().unwrap().len(), 6);
    fits(&modes["whole"][0], "system_mode");
    assert_eq!(modes["whole"].as_array().unwrap().len(), 10);
    let page = seacable(dir.path())
        .args(["modes", "heavy.toml", "--count", "3", "-o", "heavy.csv"])
        .assert()
        .success();
    let page = String::from_utf8(page.get_output().stdout.clone()).unwrap();
    for word in [
        "Mode shapes along the lines",
        "mostly",
        "Natural periods of bodies",
    ] {
        assert!(page.contains(word), "{word} is missing in\n{page}");
    }
    let shapes = std::fs::read_to_string(dir.path().join("heavy.csv")).unwrap();
    let mut rows = shapes.lines();
    assert!(
        rows.next().unwrap().starts_with("line,arc_m,x_m"),
        "{shapes}"
    );
    assert!(rows.all(|row| row.split(',').count() == 5 + 3 * 3));
    let of_line = printed(
        dir.path(),
        &["modes", "small.toml", "--count", "3", "--json"],
    );
    fits(&of_line, "line_modes");
    fits(&of_line["modes"][0], "line_mode");
    let words = ["laboratory", "systems", "--count", "30", "--json"];
    let study = printed(dir.path(), &words);
    fits(&study, "study");
    let rows = study["rows"].as_array().unwrap();
    assert!(rows.iter().all(|row| row["inexact"] == 0.0));
    let words = [
        "study",
        "vary",
        "small.toml",
        "--vary",
        "line.rope.length_m=20,21",
        "--no-store",
        "--json",
    ];
    let study = printed(dir.path(), &words);
    fits(&study, "study");
    assert_eq!(study["rows"].as_array().unwrap().len(), 2);
}

#[test]
fn options_that_have_no_effect_on_a_system_are_refused() {
    let dir = folder();
    let words = ["run", "oc3.toml", "--out", "kept"];
    let refused = seacable(dir.path()).args(words).assert().code(2);
    refused.stderr(contains("Systems of lines do not take --out"));
}

#[test]
fn refusals_end_with_a_status_and_a_message() {
    let dir = folder();
    std::fs::write(
        dir.path().join("bad.toml"),
        OC3.replace("from = \"anchor\"", "from = \"ancor\""),
    )
    .unwrap();
    let mut bad = seacable(dir.path());
    bad.args(["run", "bad.toml", "--json"]);
    bad.assert()
        .code(2)
        .stderr(contains("there is no point named \"ancor\""))
        .stderr(contains("did you mean"));
    let mut never = seacable(dir.path());
    let key = "lines.mooring.length_m";
    never.args([
        "study",
        "seek",
        "oc3.toml",
        "--vary",
        key,
        "--between",
        "900..905",
        "--want",
        "tension_n[mooring|b]=5e7",
    ]);
    never
        .assert()
        .code(1)
        .stderr(contains("is not among these"));
    // Where no body has a mass, the modes are those of the lines.
    let mut modes = seacable(dir.path());
    let page = modes.args(["modes", "oc3.toml"]).assert().success();
    page.stdout(contains("mooring").and(contains("Natural periods of bodies").not()));
}

const BRIDLE: &str = include_str!("../../cases/systems/bridle_in_heave.toml");

#[test]
fn a_system_in_motion_as_json_and_kept() {
    let dir = folder();
    std::fs::write(dir.path().join("bridle.toml"), BRIDLE).unwrap();
    let words = ["run", "bridle.toml", "--json", "--out", "kept", "--set"];
    let system = printed(
        dir.path(),
        &[&words[..], &["solver.duration_s=20"]].concat(),
    );
    fits(&system, "system");
    let motion = &system["motion"];
    fits(motion, "motion");
    assert_eq!(motion["state"], "done");
    assert_eq!(motion["directory"], "kept");
    let channels = motion["channels"].as_array().unwrap();
    let upper = channels
        .iter()
        .find(|c| c["name"] == "tension_n[upper|b]")
        .unwrap();
    fits(upper, "motion_channel");
    let greatest = upper["greatest"].as_f64().unwrap();
    let error = |which: &str| upper[which][1].as_f64().unwrap();
    // As MoorDyn's, whose greatest is 69.18 kN.
    assert!(
        (greatest - 69.18e3).abs() < 0.1e3 + error("time_errors") + error("mesh_errors"),
        "{upper}"
    );
    let history = std::fs::read_to_string(dir.path().join("kept/history.csv")).unwrap();
    let mut rows = history.lines();
    let names: Vec<&str> = rows.next().unwrap().split(',').collect();
    assert_eq!(
        names[..3],
        ["time_s", "tension_n[upper|a]", "tension_n[upper|b]"]
    );
    assert!(names.contains(&"z_m[clump]"));
    assert_eq!(rows.clone().count(), 201);
    let last: Vec<f64> = rows
        .next_back()
        .unwrap()
        .split(',')
        .map(|n| n.parse().unwrap())
        .collect();
    assert_eq!(last.len(), names.len());
    assert!((last[0] - 20.0).abs() < 1e-9);
    seacable(dir.path())
        .args(["run", "bridle.toml", "--out", "kept"])
        .assert()
        .code(2)
        .stderr(contains("already holds files"));
}

#[test]
fn what_moves_without_a_period_is_refused() {
    let dir = folder();
    let still = BRIDLE.replace("period_s = 8.0\n", "");
    std::fs::write(dir.path().join("bridle.toml"), still).unwrap();
    seacable(dir.path())
        .args(["run", "bridle.toml"])
        .assert()
        .code(2)
        .stderr(contains("period_s").and(contains("add the period of its motion")));
    let broken = BRIDLE.replace("name = \"left\"\n", "name = \"left\"\nbreak_n = 1e5\n");
    std::fs::write(dir.path().join("bridle.toml"), broken).unwrap();
    seacable(dir.path())
        .args(["run", "bridle.toml"])
        .assert()
        .code(2)
        .stderr(contains("break_at_m"));
}
