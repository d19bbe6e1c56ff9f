//! What acts on nothing is said, once; checks have their verdict on a run, or the reason why there is none.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A file of the trials.
fn file(name: &str) -> PathBuf {
    Path::new("tests/trials/files")
        .join(name)
        .canonicalize()
        .unwrap()
}

/// Exit status and everything printed by the program in a folder of its own.
fn seacable(words: &[&str]) -> (Option<i32>, String) {
    let dir = tempfile::tempdir().unwrap();
    let program = env!("CARGO_BIN_EXE_seacable");
    let done = Command::new(program)
        .args(words)
        .current_dir(dir.path())
        .output()
        .unwrap();
    let text = [done.stdout, done.stderr].concat();
    let text = String::from_utf8(text).unwrap();
    (
        done.status.code(),
        text.split_whitespace().collect::<Vec<_>>().join(" "),
    )
}

fn run(path: &Path, more: &[&str]) -> (Option<i32>, String) {
    let path = path.to_str().unwrap();
    seacable(&[&["run", path], more].concat())
}

/// The same file with other text, in a folder that is kept with it.
fn edited(name: &str, edits: &[(&str, &str)]) -> (tempfile::TempDir, PathBuf) {
    let mut text = std::fs::read_to_string(file(name)).unwrap();
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("edited.toml");
    std::fs::write(&path, text).unwrap();
    (dir, path)
}

const SHORT: [&str; 2] = ["--set", "solver.duration_s=2"];

#[test]
fn a_body_that_feels_no_waves_is_named_once_at_rest_and_in_motion() {
    let barge = file("free_body_in_waves.toml");
    let (status, text) = run(&barge, &SHORT);
    assert_eq!(status, Some(0), "{text}");
    let said =
        "The waves do not act on body barge: give members, or a response_file or excitation_file.";
    assert_eq!(text.matches(said).count(), 1, "{text}");
    // The stored report has it once, too.
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("run");
    let (status, _) = run(
        &barge,
        &[&SHORT[..], &["--out", out.to_str().unwrap()]].concat(),
    );
    assert_eq!(status, Some(0));
    let (_, report) = seacable(&["report", out.to_str().unwrap()]);
    assert_eq!(
        report.matches("The waves do not act on").count(),
        1,
        "{report}"
    );
}

#[test]
fn members_feel_waves_and_areas_feel_their_drag_alone() {
    let area = (
        "inertia_kg_m2",
        "drag_area_m2 = [10.0, 10.0, 10.0]\ninertia_kg_m2",
    );
    let (_dir, path) = edited("free_body_in_waves.toml", &[area]);
    let (_, text) = run(&path, &SHORT);
    assert!(
        text.contains("The waves act by drag alone on body barge"),
        "{text}"
    );
    let member = (
        "[points.fairlead]",
        "[[bodies.barge.members]]\nfrom_m = [0.0, 0.0, -2.0]\nto_m = [0.0, 0.0, 2.0]\ndiameter_m = 5.0\n\n[points.fairlead]",
    );
    let (_dir, path) = edited("free_body_in_waves.toml", &[member]);
    let (_, text) = run(&path, &SHORT);
    assert!(!text.contains("The waves"), "{text}");
}

#[test]
fn a_current_and_a_wind_that_a_body_does_not_feel_are_said() {
    let flow = (
        "[seabed]",
        "[current]\nspeed_m_per_s = 1.0\n\n[wind]\nspeed_m_per_s = 20.0\n\n[seabed]",
    );
    let loads = (
        "[points.fairlead]",
        "[bodies.tug]\nkind = \"held\"\nposition_m = [50.0, 0.0, 0.0]\n[[bodies.tug.wind_loads]]\nheading_deg = 0.0\nsurge_n_s2_per_m2 = 1.0\n\n[points.fairlead]",
    );
    let (_dir, path) = edited("free_body_in_waves.toml", &[flow, loads]);
    let (_, text) = run(&path, &SHORT);
    assert!(
        text.contains("The current does not act on body barge"),
        "{text}"
    );
    assert!(
        text.contains("The wind does not act on body barge: give wind_loads."),
        "{text}"
    );
}

#[test]
fn checks_have_their_verdict_on_a_run() {
    // The greatest tension is 69.2 kN of 100 kN: twice that is 1.38 of the limit.
    let checks = file("checks_without_load_cases.toml");
    let (status, text) = run(&checks, &[]);
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("Verdict") && text.contains("fails"), "{text}");
    assert!(text.contains("upper|b"), "{text}");
    let (status, json) = run(&checks, &["--json"]);
    assert_eq!(status, Some(1));
    let object: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(object["checks"]["verdict"], "fails");
    let (_dir, path) = edited(
        "checks_without_load_cases.toml",
        &[("factor = 2.0", "factor = 1.2")],
    );
    let (status, text) = run(&path, &[]);
    assert_eq!(status, Some(0), "{text}");
    assert!(text.contains("passes"), "{text}");
}

#[test]
fn checks_have_their_verdict_at_rest() {
    let at_rest = [
        ("[solver]\nduration_s = 20\n", ""),
        ("[output]\ninterval_s = 0.1\n", ""),
    ];
    let (_dir, path) = edited("checks_without_load_cases.toml", &at_rest);
    let (status, text) = run(&path, &[]);
    assert_eq!(status, Some(1), "{text}");
    assert!(
        text.contains("Verdict") && text.contains("upper|b"),
        "{text}"
    );
}

/// A cable of 10 kN m2 that bends to 26 m where it lies down.
#[test]
fn a_bend_radius_of_a_system_is_compared_line_by_line() {
    for (limit, verdict, status) in [("2.0", "passes", 0), ("200.0", "fails", 1)] {
        let changes = [("limit_m = 2.0", format!("limit_m = {limit}"))];
        let changes = changes.each_ref().map(|(from, to)| (*from, to.as_str()));
        let (_dir, path) = edited("cs_bend.toml", &changes);
        let (found, text) = run(&path, &["--set", "solver.duration_s=5"]);
        assert_eq!(found, Some(status), "{text}");
        assert!(
            text.contains(&format!("bend-radius [1] {verdict}")),
            "{text}"
        );
    }
}

#[test]
fn options_of_a_line_hold_for_a_system() {
    let checks = file("checks_without_load_cases.toml");
    // At rest and in time its check fails.
    let (status, text) = run(&checks, &["--solver", "static"]);
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("The equilibrium is stable."), "{text}");
    let (status, text) = run(&checks, &["--accuracy", "0.01"]);
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("Accuracy: 0.01 asked; "), "{text}");
}

#[test]
fn quick_looks_have_verdicts_in_json_and_refuse_a_folder_that_they_would_not_write() {
    let waves =
        "\n[[waves]]\nkind = \"irregular\"\nsignificant_height_m = 1.0\npeak_period_s = 9.0\n";
    let tail = ("factor = 2.0", &*format!("factor = 2.0\n{waves}"));
    let (_dir, path) = edited("checks_without_load_cases.toml", &[tail]);
    let sweep = [
        "sweep",
        path.to_str().unwrap(),
        "--vary",
        "waves.1.seed=1..2/2",
        "--quick",
    ];
    let (_, json) = seacable(&[&sweep[..], &["--json"]].concat());
    let object: serde_json::Value =
        serde_json::from_str(&json).unwrap_or_else(|_| panic!("{json}"));
    assert!(object["checks"]["verdict"].is_string(), "{json}");
    let (status, text) = seacable(&[&sweep[..], &["--out", "looks"]].concat());
    assert_eq!(status, Some(2), "{text}");
    assert!(text.contains("--sampled"), "{text}");
}

#[test]
fn lists_are_csv_where_csv_is_asked_for() {
    for (words, head) in [
        (&["statistics", "--curves", "--csv"][..], "curve,of,m,"),
        (&["rules", "--csv"], "rules,standard,edition,checks"),
        (&["rules", "api-rp-2sk", "--csv"], "rule,kind,condition,"),
    ] {
        let (status, text) = seacable(words);
        assert_eq!(status, Some(0), "{text}");
        assert!(text.starts_with(head), "{text}");
    }
    let (status, text) = seacable(&["rules", "dnv-os-e302"]);
    assert_eq!(status, Some(2));
    assert!(text.contains("Did you mean `dnv-os-e301`?"), "{text}");
}
