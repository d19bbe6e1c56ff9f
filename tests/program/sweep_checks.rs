//! Checks over the load cases of a sweep: the verdict, its exit status, what governs, and what is refused.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::small::SMALL;

/// A chain from the bed to a fixed point at the surface, which the waves move.
pub(crate) const CHAIN: &str = r#"
[system]
title = "Chain in waves"

[seabed]
depth_m = 50.0

[materials.chain]
diameter_m = 0.1
mass_kg_per_m = 200.0
ea_n = 8e8

[points.anchor]
kind = "fixed"
position_m = [-90.0, 0.0, -50.0]

[points.top]
kind = "fixed"
position_m = [0.0, 0.0, -1.0]

[[lines]]
name = "chain"
from = "anchor"
to = "top"
material = "chain"
length_m = 110.0
segments = 10

[[waves]]
kind = "irregular"
significant_height_m = 3.0
peak_period_s = 7.0
components = 20

[solver]
duration_s = 60.0

[output]
uplift = true
"#;
const OC3: &str = include_str!("../../cases/systems/oc3_spar.toml");

pub(crate) fn sweep(dir: &Path, words: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.arg("sweep").args(words).current_dir(dir);
    command.env("NO_COLOR", "1").stdin(Stdio::null());
    let Output {
        status,
        stdout,
        stderr,
    } = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code(), text(stdout), text(stderr))
}

/// The greatest value in a column of the rows that begin so.
pub(crate) fn value(csv: &str, row: &str, column: &str) -> f64 {
    let mut lines = csv.lines();
    let head = lines.next().unwrap();
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let place = reader
        .headers()
        .unwrap()
        .iter()
        .position(|name| name == column);
    let place = place.unwrap_or_else(|| panic!("{column} in {head}"));
    let records = reader.records().map(Result::unwrap);
    let found = records.filter(|record| record[0].starts_with(row));
    // What never changes, such as no pull on an anchor on the bed, has no sample.
    let known = found.filter(|record| !record[place].is_empty());
    let values = known.map(|record| record[place].parse::<f64>().unwrap());
    values
        .reduce(f64::max)
        .unwrap_or_else(|| panic!("{row} in {csv}"))
}

#[test]
fn a_system_at_rest_is_held_to_quasi_static_factors_intact_and_with_a_line_lost() {
    let dir = tempfile::tempdir().unwrap();
    let text = OC3.replace("ea_n = 384.243e6", "ea_n = 384.243e6\nbreak_load_n = 2.0e6")
        + r#"
[[load_cases]]
key = "damage.lost_line"
values = ["none", "mooring@120"]

[[checks]]
rules = "api-rp-2sk"

[[checks]]
name = "uplift"
kind = "uplift"
limit_n = 1.0e5
"#;
    fs::write(dir.path().join("spar.toml"), text).unwrap();
    let (status, out, err) = sweep(dir.path(), &["spar.toml", "--out", "s"]);
    // 2 times 0.911 MN of 2 MN.
    assert_eq!(status, Some(0), "{out}{err}");
    let checks = fs::read_to_string(dir.path().join("s/checks.csv")).unwrap();
    let used = value(&checks, "api-rp-2sk intact-quasi-static", "used");
    assert!((used - 0.91109).abs() < 1e-3, "{checks}");
    assert!(
        out.contains("No load case is for: api-rp-2sk intact-dynamic"),
        "{out}"
    );
    let report = fs::read_to_string(dir.path().join("s/report.txt")).unwrap();
    assert!(
        report.is_ascii() && report.lines().all(|line| line.len() <= 80),
        "{report}"
    );

    // A stronger factor fails, and the exit status says so.
    let text = fs::read_to_string(dir.path().join("spar.toml")).unwrap();
    let stricter = text.replace(
        "rules = \"api-rp-2sk\"",
        "kind = \"safety-factor\"\nfactor = 2.5",
    );
    fs::write(dir.path().join("strict.toml"), stricter).unwrap();
    let (status, out, _) = sweep(dir.path(), &["strict.toml", "--out", "t"]);
    assert_eq!(status, Some(1));
    assert!(out.contains("fails") && out.contains("1.139"), "{out}");
}

#[test]
fn seeds_of_a_sea_are_one_sample_and_the_verdict_has_two_errors() {
    let dir = tempfile::tempdir().unwrap();
    let text = format!(
        "{CHAIN}
[[load_cases]]
key = \"waves.1.seed\"
range = \"1..6/6\"

[statistics]
hours = 0.5
from_s = 5.0

[[checks]]
name = \"strength\"
kind = \"safety-factor\"
factor = 1.67
break_load_n = 1e9

[[checks]]
name = \"anchor\"
kind = \"uplift\"
of = [\"anchor\"]
limit_n = 1e6

[[checks]]
name = \"fatigue\"
kind = \"fatigue\"
curve = \"dnv-studless-chain\"
diameter_m = 0.1
"
    );
    fs::write(dir.path().join("chain.toml"), text).unwrap();
    let (status, out, err) = sweep(dir.path(), &["chain.toml", "--out", "s"]);
    assert!(status.is_some(), "{out}{err}");
    let seas = fs::read_to_string(dir.path().join("s/seas.csv")).unwrap();
    assert_eq!(value(&seas, "1", "runs"), 6.0, "{seas}");
    let [low, most, high] =
        ["greatest, low", "greatest", "greatest, high"].map(|name| value(&seas, "1", name));
    assert!(low < most && most < high, "{seas}");
    assert!(value(&seas, "1", "greatest, numerical error") > 0.0);
    let checks = fs::read_to_string(dir.path().join("s/checks.csv")).unwrap();
    let used = value(&checks, "strength", "used");
    let greatest = value(&checks, "strength", "load");
    assert!(
        (used - greatest / 1e9).abs() < 1e-9 && used < 0.5,
        "{checks}"
    );
    assert!(
        checks.contains("fatigue") && checks.contains("anchor,"),
        "{checks}"
    );

    // The same tables whatever the threads, and again from the stored runs.
    let (_, _, err) = sweep(dir.path(), &["chain.toml", "--jobs", "1", "--out", "t"]);
    for file in ["seas.csv", "checks.csv"] {
        let read = |sweep: &str| fs::read(dir.path().join(sweep).join(file)).unwrap();
        assert_eq!(read("s"), read("t"), "{err}");
    }
    fs::remove_file(dir.path().join("s/checks.csv")).unwrap();
    sweep(dir.path(), &["--resume", "s"]);
    assert_eq!(
        fs::read_to_string(dir.path().join("s/checks.csv")).unwrap(),
        checks
    );
}

#[test]
fn seeds_are_drawn_until_every_check_is_settled_and_no_longer() {
    let dir = tempfile::tempdir().unwrap();
    let text = |strength: &str| {
        format!(
            "{CHAIN}
[[load_cases]]
key = \"waves.1.significant_height_m\"
values = [0.5, 3.0]

[[load_cases]]
key = \"waves.1.seed\"
range = \"1..12/12\"

[statistics]
hours = 0.1
from_s = 5.0

[[checks]]
kind = \"safety-factor\"
factor = 1.67
break_load_n = {strength}
"
        )
    };
    let unneeded = |name: &str| {
        let results = fs::read_to_string(dir.path().join(name).join("results.csv")).unwrap();
        results.matches("NOT NEEDED").count()
    };
    fs::write(dir.path().join("strong.toml"), text("1e9")).unwrap();
    let words = ["strong.toml", "--until-settled", "--out", "s"];
    let (status, out, err) = sweep(dir.path(), &words);
    assert_eq!(status, Some(0), "{out}{err}");
    assert_eq!(
        unneeded("s"),
        2 * (12 - 5),
        "five seeds of each sea are enough"
    );
    assert!(out.contains("14 load cases were not needed"), "{out}");
    // Nothing more is computed by going on, and the same is said.
    let before = fs::read(dir.path().join("s/checks.csv")).unwrap();
    sweep(dir.path(), &["--resume", "s"]);
    assert_eq!(unneeded("s"), 14);
    assert_eq!(fs::read(dir.path().join("s/checks.csv")).unwrap(), before);

    // A limit at the greatest tension of the rough sea takes all its seeds, and the calm one still five.
    let seas = fs::read_to_string(dir.path().join("s/seas.csv")).unwrap();
    let near = 1.67 * value(&seas, "2", "greatest");
    let near = text(&near.to_string()).replace("[solver]", "[solver]\nerror_estimate = false");
    fs::write(dir.path().join("near.toml"), near).unwrap();
    let (status, out, err) = sweep(dir.path(), &["near.toml", "--until-settled", "--out", "t"]);
    assert_eq!(status, Some(1), "{out}{err}");
    assert_eq!(unneeded("t"), 12 - 5, "{out}");
    assert!(
        out.contains("not settled") || out.contains("not\n"),
        "{out}"
    );
}

#[test]
fn the_greatest_value_that_passes_is_found_for_each_sea() {
    let dir = tempfile::tempdir().unwrap();
    // At rest: a heavier chain is tighter.
    let text = OC3.replace("ea_n = 384.243e6", "ea_n = 384.243e6\nbreak_load_n = 2.0e6")
        + r#"
[[load_cases]]
key = "damage.lost_line"
values = ["none", "mooring@120"]

[[checks]]
rules = "api-rp-2sk"
only = ["intact-quasi-static", "line-lost-quasi-static"]
"#;
    fs::write(dir.path().join("spar.toml"), text).unwrap();
    let words = [
        "spar.toml",
        "--window",
        "materials.chain.mass_kg_per_m=78..94/33",
        "--out",
        "w",
    ];
    let (status, out, err) = sweep(dir.path(), &words);
    assert_eq!(status, Some(0), "{out}{err}");
    let window = fs::read_to_string(dir.path().join("w/window.csv")).unwrap();
    let passes = value(&window, "none", "materials.chain.mass_kg_per_m, passes");
    let fails = value(&window, "none", "materials.chain.mass_kg_per_m, does not");
    assert!((fails - passes - 0.5).abs() < 1e-12, "{window}");
    // The same by running both values alone.
    for (x, wanted) in [(passes, "passes"), (fails, "fails")] {
        let set = format!("materials.chain.mass_kg_per_m={x}");
        let name = format!("at-{x}");
        let (_, out, err) = sweep(dir.path(), &["spar.toml", "--set", &set, "--out", &name]);
        let checks = fs::read_to_string(dir.path().join(name).join("checks.csv")).unwrap();
        let intact = checks
            .lines()
            .filter(|line| line.contains("intact-quasi-static"));
        let worst = intact.clone().any(|line| line.contains(",fails,"));
        assert_eq!(worst, wanted == "fails", "{out}{err}");
    }
    // It goes on where it was, and says the same.
    fs::remove_file(dir.path().join("w/window.csv")).unwrap();
    let (status, _, err) = sweep(dir.path(), &["--resume", "w"]);
    assert_eq!(status, Some(0), "{err}");
    assert_eq!(
        fs::read_to_string(dir.path().join("w/window.csv")).unwrap(),
        window
    );

    for (wrong, words) in [
        ("damage.lost_line=none,mooring", "takes words"),
        ("seabed.friction=0.3", "fewer than two values"),
        ("bodies.spar.place=1..2/3", "no key"),
    ] {
        let (status, _, err) = sweep(dir.path(), &["spar.toml", "--window", wrong, "--out", "x"]);
        assert_eq!(status, Some(2), "{wrong}");
        assert!(err.contains(words), "{wrong}: {err}");
        assert!(!dir.path().join("x").exists());
    }
}

#[test]
fn a_load_case_without_results_leaves_its_checks_open() {
    let dir = tempfile::tempdir().unwrap();
    let text = format!(
        "{CHAIN}
[[load_cases]]
key = \"seabed.depth_m\"
values = [50.0, 10.0]

[[load_cases]]
key = \"waves.1.seed\"
range = \"1..5/5\"

[statistics]
from_s = 5.0

[[checks]]
kind = \"safety-factor\"
factor = 1.67
break_load_n = 1e10
"
    );
    fs::write(dir.path().join("chain.toml"), text).unwrap();
    let set = ["--set", "solver.duration_s=10"];
    let (status, out, err) = sweep(dir.path(), &["chain.toml", set[0], set[1], "--out", "s"]);
    assert_eq!(status, Some(1), "{out}{err}");
    let results = fs::read_to_string(dir.path().join("s/results.csv")).unwrap();
    assert_eq!(results.matches("REFUSED").count(), 5, "{results}");
    assert!(
        out.contains("5 load cases of sea 2 have no results"),
        "{out}"
    );
    assert!(
        out.contains("not settled") || out.contains("not  "),
        "{out}"
    );
}

#[test]
fn checks_that_cannot_be_are_refused_before_anything_is_computed() {
    let dir = tempfile::tempdir().unwrap();
    let refused = |check: &str, wanted: &[&str]| {
        let text = format!(
            "{OC3}\n[[load_cases]]\nkey = \"seabed.friction\"\nvalues = [0.0, 0.1]\n{check}"
        );
        fs::write(dir.path().join("spar.toml"), text).unwrap();
        let (status, out, err) = sweep(dir.path(), &["spar.toml", "--out", "s"]);
        assert_eq!(status, Some(2), "{check}: {out}{err}");
        for words in wanted {
            assert!(err.contains(words), "{check}: {err}");
        }
        assert!(!dir.path().join("s").exists());
    };
    refused(
        "[[checks]]\nrules = \"dnv-os-e302\"\n",
        &["spar.toml:", "did you mean `dnv-os-e301`"],
    );
    refused(
        "[[checks]]\nname = \"n\"\n",
        &["neither what it compares nor by which rules"],
    );
    refused(
        "[[checks]]\nkind = \"offset\"\nlimit_m = 2.0\n",
        &["`limit_m` and `of`"],
    );
    refused(
        "[[checks]]\nkind = \"uplift\"\nlimit_n = 2.0\nfactor = 3.0\n",
        &["`factor` is not used"],
    );
    refused(
        "[[checks]]\nrules = \"dnv-os-e301\"\nonly = [\"uls-3\"]\n",
        &["no rule `uls-3`", "did you mean"],
    );
    refused(
        "[[checks]]\nrules = \"mine.toml\"\n",
        &["mine.toml cannot be read"],
    );
    let of = "[[checks]]\nkind = \"offset\"\nlimit_m = 2.0\nof = [\"spart\"]\n";
    refused(of, &["holds `spart`", "Did you mean `spar`?"]);
    fs::write(dir.path().join("mine.toml"), "[rules]\ntitle = \"t\"\n").unwrap();
    refused(
        "[[checks]]\nrules = \"mine.toml\"\n",
        &["mine.toml:", "edition"],
    );
}

/// The greatest value of a run is that of all its steps, of which its rows are few; where the start is left out, of those after it.
#[test]
fn the_greatest_value_of_a_run_is_that_of_all_its_steps() {
    let dir = tempfile::tempdir().unwrap();
    let line = SMALL.replace(
        "[output]",
        "[waves]\nkind = \"regular\"\nheight_m = 2.0\nperiod_s = 6.0\n[output]",
    );
    for (file, text, place, end) in [
        ("chain.toml", CHAIN, "chain|b", 60),
        ("small.toml", line.as_str(), "rope|payload", 5),
    ] {
        let text = text.replace("interval_s = 0.5\n", "interval_s = 0.9\n");
        let text = match file {
            "chain.toml" => text.replace("[output]", "[output]\ninterval_s = 2.5"),
            _ => text,
        };
        let seed = match file {
            "chain.toml" => "waves.1.seed=1,2",
            _ => "payload.drag_area_m2=1,2",
        };
        for from in [0, end / 3] {
            let statistics = format!(
                "{text}\n[statistics]\nmethod = \"seen\"\nfrom_s = {from}\n[[checks]]\nname = \"strength\"\nkind = \"safety-factor\"\nfactor = 1.0\nbreak_load_n = 1e9\n"
            );
            fs::write(dir.path().join(file), statistics).unwrap();
            let name = format!("{file}-{from}");
            let (_, out, err) = sweep(dir.path(), &[file, "--vary", seed, "--out", &name]);
            let checks = fs::read_to_string(dir.path().join(&name).join("checks.csv"));
            let checks = checks.unwrap_or_else(|why| panic!("{why}: {out}{err}"));
            let window = match from {
                0 => String::new(),
                from => format!("({from}..{end})"),
            };
            let of_run = |number: usize| {
                let run = dir.path().join(format!("{name}-{number:04}"));
                let summary = fs::read_to_string(run.join("summary.csv")).unwrap();
                let quantity = format!("tension_n[{place}].max{window}");
                let rows = fs::read_to_string(run.join("history.csv")).unwrap();
                let heads = rows.lines().next().unwrap();
                let column = format!("tension_n[{place}]");
                let column = heads.split(',').position(|head| head == column).unwrap();
                let read = |row: &str| -> Vec<f64> {
                    row.split(',').map(|word| word.parse().unwrap()).collect()
                };
                let rows: Vec<Vec<f64>> = rows.lines().skip(1).map(read).collect();
                let rows = rows.iter().filter(|row| row[0] >= f64::from(from));
                let greatest = rows.map(|row| row[column]).fold(f64::MIN, f64::max);
                (value(&summary, &quantity, "value"), greatest)
            };
            let found = [of_run(1), of_run(2)];
            let [own, rows] = [|f: &(f64, f64)| f.0, |f: &(f64, f64)| f.1]
                .map(|of| found.iter().map(of).fold(f64::MIN, f64::max));
            let wanted = f64::max(own, rows);
            let mut reader = csv::Reader::from_reader(checks.as_bytes());
            let heads = reader.headers().unwrap().clone();
            let column = |name: &str| {
                heads
                    .iter()
                    .position(|head| head.starts_with(name))
                    .unwrap()
            };
            let (at, load) = (column("place"), column("load"));
            let loads = reader.records().map(Result::unwrap);
            let loads = loads.filter(|row| &row[at] == place);
            let load = loads.map(|row| row[load].parse::<f64>().unwrap());
            let load = load.fold(f64::MIN, f64::max);
            assert_eq!(
                load.to_bits(),
                wanted.to_bits(),
                "{name}: {found:?} {checks}"
            );
            assert!(own >= rows || file == "chain.toml", "{name}: {found:?}");
        }
    }
}

/// Damage along a line is that of its recorded end at that end, names where it governs, and goes on after a kill to the same bits.
#[test]
fn fatigue_is_counted_along_the_lines() {
    let dir = tempfile::tempdir().unwrap();
    let check = |name: &str, more: &str| {
        format!(
            "[[checks]]\nname = \"{name}\"\nkind = \"fatigue\"\ncurve = \"dnv-studless-chain\"\n{more}\n"
        )
    };
    let text = CHAIN.replace("[output]", "[output]\ninterval_s = 0.02");
    let along = check("along", "along = true");
    let text = format!("{text}\n{}{along}", check("ends", ""));
    fs::write(dir.path().join("chain.toml"), text).unwrap();
    let words = ["chain.toml", "--vary", "waves.1.seed=1..3/3", "--out", "s"];
    let (_, out, err) = sweep(dir.path(), &words);
    let checks = fs::read_to_string(dir.path().join("s/checks.csv"));
    let checks = checks.unwrap_or_else(|why| panic!("{why}: {out}{err}"));
    let mut reader = csv::Reader::from_reader(checks.as_bytes());
    let heads = reader.headers().unwrap().clone();
    let column = |name: &str| heads.iter().position(|head| head == name).unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let damage = |check: &str, place: &str| {
        let mut found = rows.iter();
        let row = found.find(|row| &row[0] == check && &row[column("place")] == place);
        let row = row.unwrap_or_else(|| panic!("{check} {place}: {checks}"));
        row[column("load")].parse::<f64>().unwrap()
    };
    for (end, place) in [("chain|a", "chain|0 m"), ("chain|b", "chain|110 m")] {
        let (recorded, counted) = (damage("ends", end), damage("along", place));
        assert!(
            (counted / recorded - 1.0).abs() < 0.02,
            "{end}: {recorded} {counted}"
        );
    }
    let places = rows.iter().filter(|row| &row[0] == "along");
    let places: Vec<&str> = places.map(|row| &row[column("place")]).collect();
    assert_eq!(places.len(), 11, "{places:?}");
    assert_eq!(places[..3], ["chain|0 m", "chain|11 m", "chain|22 m"]);
    assert!(out.contains("along [2]"), "{out}");
    // A run that was lost is computed again, to the same damage.
    let spots = fs::read(dir.path().join("s-0002/fatigue.csv")).unwrap();
    fs::remove_dir_all(dir.path().join("s-0002")).unwrap();
    sweep(dir.path(), &["--resume", "s"]);
    assert_eq!(
        fs::read(dir.path().join("s-0002/fatigue.csv")).unwrap(),
        spots
    );
    assert_eq!(
        fs::read_to_string(dir.path().join("s/checks.csv")).unwrap(),
        checks
    );
}

#[test]
fn what_fatigue_along_a_line_cannot_take_is_said() {
    let dir = tempfile::tempdir().unwrap();
    let refused = |more: &str, why: &str| {
        let check = "\n[[checks]]\nkind = \"fatigue\"\ncurve = \"dnv-studless-chain\"\n";
        fs::write(
            dir.path().join("chain.toml"),
            format!("{CHAIN}{check}{more}"),
        )
        .unwrap();
        let (status, _, err) = sweep(dir.path(), &["chain.toml", "--vary", "waves.1.seed=1,2"]);
        assert!(status == Some(2) && err.contains(why), "{more}: {err}");
    };
    refused(
        "units = [\"tube\"]\n",
        "of the units of a cross-section, which is not given",
    );
    refused("section = \"none.toml\"\n", "none.toml");
    refused("section = \"none\"\n", "is no file");
    let again =
        "along = true\n[[checks]]\nkind = \"fatigue\"\ncurve = \"dnv-stud-chain\"\nalong = true\n";
    refused(again, "has the same name");
}
