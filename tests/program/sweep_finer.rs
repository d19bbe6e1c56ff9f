//! Verdicts that hang on the numerical error of a load case are settled by finer runs of it, and of it alone.

use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::study::sweep::{SweepSnapshot, stored_sweeps};

use crate::sweep_checks::{CHAIN, sweep, value};

/// A line between two fixed points in a current, at rest.
const IN_CURRENT: &str = r#"
[system]
title = "Rope in a current"

[current]
speed_m_per_s = 1.0
direction_deg = 90.0

[materials.chain]
diameter_m = 0.2
mass_kg_per_m = 60.0
ea_n = 5e7
drag_normal = 1.2

[points.low]
kind = "fixed"
position_m = [-60.0, 0.0, -60.0]

[points.top]
kind = "fixed"
position_m = [0.0, 0.0, 0.0]

[[lines]]
name = "chain"
from = "low"
to = "top"
material = "chain"
length_m = 90.0
segments = 6
"#;
/// A line whose end is moved.
const LINE: &str = r#"
[case]
title = "Heaved rope"

[materials.chain]
diameter_m = 0.2
mass_kg_per_m = 60.0
ea_n = 5e7
drag_normal = 1.2

[[line]]
name = "chain"
material = "chain"
length_m = 90.0
segments = 6

[ends.a]
name = "low"
kind = "anchor"
position_m = [-60.0, 0.0, -60.0]

[ends.b]
name = "top"
kind = "moving"
position_m = [0.0, 0.0, 0.0]
amplitude_m = [0.0, 0.0, 0.5]
period_s = 6.0
ramp_s = 6.0

[solver]
duration_s = 18.0
"#;

/// A scene at two values of a key, held to the strength of its line \[N\].
fn scene(text: &str, (key, values): (&str, &str), strength: f64) -> String {
    let material = format!("[materials.chain]\nbreak_load_n = {strength:.6e}");
    text.replace("[materials.chain]", &material)
        + &format!(
            r#"
[[load_cases]]
key = "{key}"
values = {values}

[[checks]]
name = "strength"
kind = "safety-factor"
factor = 1.67
"#
        )
}

/// Shares of the strength that are used at the second value, by the check: the value, and the greatest that its error allows.
fn used(dir: &Path) -> [f64; 2] {
    let checks = fs::read_to_string(dir.join("checks.csv")).unwrap();
    let of_second: Vec<&str> = checks
        .lines()
        .filter(|row| row.starts_with("check,") || row.split(',').nth(2) == Some("2"))
        .collect();
    ["used", "used, numerical high"].map(|column| value(&of_second.join("\n"), "strength", column))
}

/// Whether a verdict is open by the errors.
fn is_open(dir: &Path) -> bool {
    let checks = fs::read_to_string(dir.join("checks.csv")).unwrap();
    checks.contains("not settled")
}

/// The strength is put where the verdict of the second value lies within the error; the first uses much less of it.
fn is_settled_by_finer_runs(text: &str, varied: (&str, &str), is_stored: bool) {
    let dir = tempfile::tempdir().unwrap();
    let write = |strength: f64| {
        let text = scene(text, varied, strength);
        fs::write(dir.path().join("scene.toml"), text).unwrap();
    };
    write(1e9);
    let (_, out, err) = sweep(dir.path(), &["scene.toml", "--out", "wide"]);
    let [value, high] = used(&dir.path().join("wide"));
    let error = (high - value) / value;
    assert!(error > 1e-5, "{out}{err}");
    write(1e9 * value / (1.0 - 0.2 * error));

    let (status, out, _) = sweep(dir.path(), &["scene.toml", "--out", "as-set"]);
    assert_eq!(status, Some(1), "{out}");
    assert!(
        is_open(&dir.path().join("as-set")) && !out.contains("computed again"),
        "{out}"
    );

    let finer = ["scene.toml", "--finer-runs", "5", "--out", "finer"];
    let (_, out, err) = sweep(dir.path(), &finer);
    let again = "computed again: 1 with segments and steps divided in 2";
    let flat = out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(flat.contains(again), "{out}{err}");
    assert!(!is_open(&dir.path().join("finer")), "{out}");
    let [_, finer_high] = used(&dir.path().join("finer"));
    let [value, high] = used(&dir.path().join("as-set"));
    assert!((finer_high - value).abs() < high - value, "{out}");
    let run = |name: &str| dir.path().join(name).exists();
    assert_eq!(run("finer-finer-1-0001"), is_stored, "{out}");
    assert!(!run("finer-finer-1-0002"));

    // The screen has the sweep with its finer runs, and not their round.
    let listed = stored_sweeps(dir.path(), "scene.toml");
    assert_eq!(listed.len(), 3, "{listed:?}");
    let never = AtomicBool::new(false);
    let shown = SweepSnapshot::read(&dir.path().join("finer"), &never).unwrap();
    let open = shown.answers().unwrap().open_by_error();
    assert!(open.is_empty(), "{open:?}");

    // Gone on with, nothing is computed again that is stored, and the page is the same.
    let (_, resumed, _) = sweep(dir.path(), &["--resume", "finer"]);
    let verdict = |text: &str| text.split("Extremes").next().unwrap().to_owned();
    assert_eq!(verdict(&resumed), verdict(&out));
}

#[test]
fn finer_runs_settle_a_line_in_time() {
    is_settled_by_finer_runs(LINE, ("ends.b.amplitude_m.z", "[0.1, 0.8]"), true);
}

#[test]
fn finer_runs_settle_a_system_in_time() {
    let text = CHAIN
        .replace("kind = \"irregular\"\nsignificant_height_m = 3.0\npeak_period_s = 7.0\ncomponents = 20", "kind = \"regular\"\nheight_m = 3.0\nperiod_s = 7.0")
        .replace("kind = \"fixed\"\nposition_m = [0.0, 0.0, -1.0]", "kind = \"moved\"\nposition_m = [0.0, 0.0, -1.0]\namplitude_m = [0.5, 0.0, 0.5]\nperiod_s = 7.0\nramp_s = 7.0")
        .replace("duration_s = 60.0", "duration_s = 20.0");
    let varied = ("points.top.amplitude_m.z", "[0.1, 0.8]");
    is_settled_by_finer_runs(&text, varied, true);
}

#[test]
fn finer_meshes_settle_a_system_at_rest() {
    is_settled_by_finer_runs(IN_CURRENT, ("current.speed_m_per_s", "[0.3, 1.5]"), false);
}
