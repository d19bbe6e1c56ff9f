//! Checks along lines: the least height above the bed and the sharpest bend over a stretch, at rest, in motion, and over seeds of a sea.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::sweep_checks::{CHAIN, sweep, value};

/// A chain between two supports at one height that heave together by 1 m: its shape is the same at all times but for its stretch, since
/// gravity alone changes.
fn hung(ea: f64) -> String {
    format!(
        r#"
        environment.water_density_kg_per_m3 = 0.0
        seabed = {{ depth_m = 50.0 }}
        materials.chain = {{ diameter_m = 0.1, mass_kg_per_m = 200.0, ea_n = {ea:?} }}
        points.left = {{ kind = "moved", position_m = [-30.0, 0.0, -20.0], amplitude_m = [0.0, 0.0, 1.0], period_s = 40.0, ramp_s = 10.0 }}
        points.right = {{ kind = "moved", position_m = [30.0, 0.0, -20.0], amplitude_m = [0.0, 0.0, 1.0], period_s = 40.0, ramp_s = 10.0 }}
        lines = [{{ name = "chain", from = "left", to = "right", material = "chain", length_m = 63.0, segments = 32 }}]
        system.title = "Hung"
        "#
    )
}

/// How far a catenary of this length sags between supports 60 m apart \[m\], from a place along it on \[m\].
fn sag(length: f64, arc: f64) -> f64 {
    // 2 a sinh(30 / a) = length, by bisection.
    let (mut low, mut high) = (10.0_f64, 1000.0);
    for _ in 0..200 {
        let a = 0.5 * (low + high);
        match 2.0 * a * (30.0 / a).sinh() > length {
            true => low = a,
            false => high = a,
        }
    }
    let rise = |from_middle: f64| low.hypot(from_middle);
    rise(0.5 * length) - rise(0.5 * length - arc)
}

/// The status of `seacable run` of a file, the rows of its checks, and what else it says of them.
fn checked(dir: &Path, text: &str, words: &[&str]) -> (Option<i32>, Vec<Value>, Value) {
    fs::write(dir.join("scene.toml"), text).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.args(["run", "scene.toml", "--json"]).args(words);
    let output = command.current_dir(dir).output().unwrap();
    let page: Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)));
    let checks = &page["checks"];
    let rows = checks["rows"].as_array().unwrap().clone();
    (output.status.code(), rows, checks["missing"].clone())
}

fn load(row: &Value) -> f64 {
    row["load"].as_f64().unwrap()
}

/// The whole line, and its first 10 m, with their limits \[m\].
fn limits([whole, first]: [f64; 2]) -> String {
    format!(
        "[[checks]]\nkind = \"bed-clearance\"\nof = [\"chain\"]\nlimit_m = {whole:?}\n\
         [[checks]]\nname = \"near the support\"\nkind = \"bed-clearance\"\nstretch_m = [0.0, 10.0]\nlimit_m = {first:?}\n"
    )
}

#[test]
fn a_line_at_rest_is_as_high_as_its_catenary_over_every_stretch() {
    let dir = tempfile::tempdir().unwrap();
    let text = format!("{}{}", hung(8e11), limits([20.0, 25.0]));
    let (status, rows, missing) = checked(dir.path(), &text, &[]);
    assert_eq!((status, rows.len()), (Some(0), 2), "{rows:?} {missing}");
    for (row, sag) in rows.iter().zip([sag(63.0, 31.5), sag(63.0, 10.0)]) {
        // Its stretch is a millionth.
        assert!((load(row) - (30.0 - sag)).abs() < 5e-5, "{row} {sag}");
    }
    assert_eq!(rows[1]["place"], "chain, 0 to 10 m");

    let text = text.replace("limit_m = 25.0", "limit_m = 26.0");
    let (_, rows, _) = checked(dir.path(), &text, &[]);
    assert_eq!(rows[1]["verdict"], "fails");

    // The same divided into segments.
    let text = text + "[solver]\nduration_s = 1.0\nmethod = \"quasi\"\n";
    let (_, segments, _) = checked(dir.path(), &text, &[]);
    let near = |a: &Value, b: &Value| (load(a) - load(b)).abs() < 0.02;
    assert!(
        segments.iter().zip(&rows).all(|(a, b)| near(a, b)),
        "{segments:?}"
    );
}

#[test]
fn a_line_in_motion_comes_as_low_as_its_ends_take_it() {
    let dir = tempfile::tempdir().unwrap();
    let text = format!("{}{}", hung(8e8), limits([10.0, 10.0]));
    let (_, at_rest, _) = checked(dir.path(), &text, &[]);
    for method in ["alpha", "rk4", "quasi"] {
        let text = format!("{text}[solver]\nduration_s = 60.0\nmethod = \"{method}\"\n");
        let (status, rows, missing) = checked(dir.path(), &text, &[]);
        assert_eq!(status, Some(0), "{rows:?} {missing}");
        for (row, rest) in rows.iter().zip(&at_rest) {
            let used = |end: &str| row[format!("used, numerical {end}")].as_f64().unwrap();
            let bar = (used("high") - used("low")) / row["used"].as_f64().unwrap() * load(row);
            let off = load(row) - (load(rest) - 1.0);
            assert!(off.abs() < bar + 1e-3, "{method}: {row} {off:e} {bar:e}");
            assert!(bar < 0.1, "{method}: {bar}");
        }
    }
}

/// The same line as a case of one line, whose check names no line.
#[test]
fn a_case_of_one_line_is_held_over_a_stretch() {
    let dir = tempfile::tempdir().unwrap();
    let case = r#"
        [case]
        title = "Hung"
        [environment]
        water_density_kg_per_m3 = 0.0
        [seabed]
        depth_m = 50.0
        stiffness_n_per_m3 = 1e5
        [materials.chain]
        diameter_m = 0.1
        mass_kg_per_m = 200.0
        ea_n = 8e11
        [[line]]
        name = "chain"
        material = "chain"
        length_m = 63.0
        segments = 128
        [ends.a]
        name = "left"
        kind = "fixed"
        position_m = [-30.0, 0.0, -20.0]
        [ends.b]
        name = "right"
        kind = "fixed"
        position_m = [30.0, 0.0, -20.0]
        [solver]
        method = "static"
        [[checks]]
        name = "near the support"
        kind = "bed-clearance"
        stretch_m = [0.0, 10.0]
        limit_m = 25.0
        "#;
    let (status, rows, missing) = checked(dir.path(), case, &[]);
    assert_eq!((status, rows.len()), (Some(0), 1), "{missing}");
    let off = load(&rows[0]) - (30.0 - sag(63.0, 10.0));
    assert!(off.abs() < 3e-3, "{off:e}");
    assert_eq!(rows[0]["place"], "the line, 0 to 10 m");
}

/// Over a bed with a hill, the least height of every node is that of the curve between steps: no output of the shapes lies below it.
#[test]
fn heights_over_a_grid_are_those_of_every_step() {
    let dir = tempfile::tempdir().unwrap();
    let mut depths = String::from("x_m,y_m,depth_m\n");
    for x in (-100..=100).step_by(10) {
        for y in [-50, 50] {
            let depth = 34.0 + 0.002 * f64::from(x * x);
            depths.push_str(&format!("{x},{y},{depth:?}\n"));
        }
    }
    fs::write(dir.path().join("bed.csv"), depths).unwrap();
    let text = hung(8e8)
        .replace("depth_m = 50.0", "depth_m = 50.0, depth_file = \"bed.csv\"")
        .replace(
            "amplitude_m = [0.0, 0.0, 1.0]",
            "amplitude_m = [8.0, 0.0, 1.0]",
        );
    let more = "[solver]\nduration_s = 40.0\nerror_estimate = false\n[output]\ninterval_s = 0.05\nshape_interval_s = 0.05\n";
    let text = format!("{text}{}{more}", limits([1.0, 1.0]));
    let (_, rows, missing) = checked(dir.path(), &text, &["--out", "run"]);
    let table = |file: &str| -> Vec<Vec<String>> {
        let path = dir.path().join("run").join(file);
        let mut reader = csv::Reader::from_path(path).unwrap();
        let head = reader
            .headers()
            .unwrap()
            .iter()
            .map(str::to_owned)
            .collect();
        let rows = reader
            .records()
            .map(|row| row.unwrap().iter().map(str::to_owned).collect());
        std::iter::once(head).chain(rows).collect()
    };
    let column = |table: &[Vec<String>], name: &str| -> Vec<f64> {
        let at = table[0].iter().position(|known| known == name).unwrap();
        table[1..]
            .iter()
            .map(|row| row[at].parse().unwrap())
            .collect()
    };
    let (profile, shapes) = (table("profile.csv"), table("shapes.csv"));
    let least = column(&profile, "bed_clearance_min_m");
    let (nodes, heights) = (column(&shapes, "node"), column(&shapes, "height_m"));
    let mut seen = vec![f64::INFINITY; least.len()];
    for (node, height) in nodes.iter().zip(heights) {
        let seen = &mut seen[*node as usize];
        *seen = seen.min(height);
    }
    for (least, seen) in least.iter().zip(&seen) {
        assert!(least - seen < 1e-6 && seen - least < 2e-3, "{least} {seen}");
    }
    let lowest = least.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((load(&rows[0]) - lowest).abs() < 1e-9, "{rows:?} {missing}");
}

/// Heights and bends of seeds are one sample each; what names no line, and what a run has not recorded, is said.
#[test]
fn seeds_of_a_sea_are_one_sample_of_least_heights() {
    let dir = tempfile::tempdir().unwrap();
    let hung = CHAIN.replace("[-90.0, 0.0, -50.0]", "[-90.0, 0.0, -10.0]");
    let text = format!(
        "{hung}
[[load_cases]]
key = \"waves.1.seed\"
range = \"1..6/6\"

[statistics]
hours = 0.5
from_s = 5.0

[[checks]]
name = \"height\"
kind = \"bed-clearance\"
of = [\"chain\", \"top\"]
stretch_m = [20.0, 90.0]
limit_m = 1.0
"
    );
    fs::write(dir.path().join("chain.toml"), &text).unwrap();
    let (status, out, err) = sweep(dir.path(), &["chain.toml", "--out", "s"]);
    assert!(status.is_some(), "{out}{err}");
    assert!(out.contains("top is no line"), "{out}");
    let checks = fs::read_to_string(dir.path().join("s/checks.csv")).unwrap();
    let [low, used, high] = ["used, sample low", "used", "used, sample high"]
        .map(|name| value(&checks, "height", name));
    assert!(low < used && used < high, "{checks}");
    let at_sag = value(&checks, "height", "load");
    assert!((0.0..40.0).contains(&at_sag), "{checks}");

    let wrong = text.replace("[20.0, 90.0]", "[90.0, 20.0]");
    fs::write(dir.path().join("wrong.toml"), wrong).unwrap();
    let (status, _, err) = sweep(dir.path(), &["wrong.toml", "--out", "w"]);
    assert_eq!(status, Some(2));
    assert!(
        err.contains("stretch_m") && err.contains("runs backward"),
        "{err}"
    );
}
