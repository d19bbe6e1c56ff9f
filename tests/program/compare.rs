//! `seacable compare` and `seacable report --against`: two runs that differ in one input, and three.

use std::path::Path;

use assert_cmd::Command;
use predicates::{prelude::*, str::contains};

use crate::small::SMALL;

fn seacable(dir: &Path) -> Command {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1");
    command
}

/// A directory with the runs `one`, `two` (a heavier body) and `static` of a small case.
fn runs() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("small.toml"), SMALL).unwrap();
    let more: [(&str, &[&str]); 3] = [
        ("one", &[]),
        (
            "two",
            &[
                "--set",
                "payload.wet_mass_kg=500",
                "--set",
                "current.speed_m_per_s=0.2",
            ],
        ),
        (
            "static",
            &["--solver", "static", "--set", "start.shape=equilibrium"],
        ),
    ];
    for (name, words) in more {
        let mut command = seacable(dir.path());
        command
            .args(["run", "small.toml", "--out", name])
            .args(words);
        command.assert().success();
    }
    dir
}

fn printed(dir: &Path, words: &[&str]) -> String {
    let done = seacable(dir).args(words).assert().success();
    String::from_utf8(done.get_output().stdout.clone()).unwrap()
}

#[test]
fn two_runs_are_compared_by_inputs_results_channels_and_cost() {
    let dir = runs();
    let text = printed(dir.path(), &["compare", "one", "two"]);
    for word in [
        "A  one: small.toml",
        "B  two: small.toml with payload.wet_mass_kg=500",
        "payload.wet_mass_kg",
        "400 kg",
        "500 kg",
        "not given",
        "0.2 m/s",
        "tension_n[rope|payload]",
        "differ",
        "CPU time",
        "Channels",
        "Tension at the joints: B - A",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert!(
        text.lines().all(|line| line.chars().count() <= 80),
        "{text}"
    );
    let ascii = printed(dir.path(), &["compare", "one", "two", "--ascii"]);
    assert!(ascii.is_ascii() && ascii.contains(" +/- "), "{ascii}");
    // Nothing that is the same is listed.
    assert!(!text.contains("payload.dry_mass_kg"), "{text}");
    let wide = printed(dir.path(), &["compare", "one", "two", "--width", "140"]);
    assert!(wide.lines().count() < text.lines().count());
}

#[test]
fn a_run_agrees_with_itself() {
    let dir = runs();
    let text = printed(dir.path(), &["compare", "one", "one"]);
    assert!(
        !text.contains("B - A\n"),
        "a curve of no difference:\n{text}"
    );
    assert!(
        text.contains("None.") && text.contains(" equal. Results"),
        "{text}"
    );
    let csv = printed(dir.path(), &["compare", "one", "one", "--csv"]);
    let results = csv
        .lines()
        .filter(|line| line.starts_with("result,") && line.contains(",B,"));
    assert!(results.clone().count() > 10);
    assert!(
        results.into_iter().all(|line| line.ends_with(",equal")),
        "{csv}"
    );
}

#[test]
fn csv_keeps_every_digit_and_names_what_is_missing() {
    let dir = runs();
    let csv = printed(dir.path(), &["compare", "one", "two", "static", "--csv"]);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let of = |section: &str, name: &str, run: &str| {
        let found = rows
            .iter()
            .find(|r| &r[0] == section && &r[1] == name && &r[3] == run);
        found
            .unwrap_or_else(|| panic!("{section} {name} {run} is missing in\n{csv}"))
            .clone()
    };
    let name = "tension_n[rope|payload].max";
    let number = |run: &str, column: usize| of("result", name, run)[column].parse::<f64>().unwrap();
    assert_eq!(number("B", 8), number("B", 4) - number("A", 4));
    assert!(number("B", 5) > 0.0);
    assert_eq!(&of("result", "energy_in_j.final", "C")[11], "missing");
    assert_eq!(&of("input", "payload.wet_mass_kg", "B")[4], "500");
    assert_eq!(&of("setting", "method", "C")[4], "static");
    let text = printed(dir.path(), &["compare", "one", "two", "static"]);
    assert!(text.contains("missing") && text.contains("run"), "{text}");
}

#[test]
fn what_is_no_run_is_named() {
    let dir = runs();
    std::fs::create_dir(dir.path().join("empty")).unwrap();
    for (words, why) in [
        (
            &["compare", "one", "nowhere"][..],
            "no run directory at nowhere",
        ),
        (&["compare", "one", "empty"], "empty is not a run directory"),
        (&["compare", "one", "small.toml"], "is not a run directory"),
        (&["compare", "one"], "two runs or more"),
    ] {
        let found = seacable(dir.path()).args(words).assert().code(2).stdout("");
        found.stderr(contains(why));
    }
}

#[test]
fn a_report_ends_with_the_comparison_it_is_asked_for() {
    let dir = runs();
    let plain = printed(dir.path(), &["report", "two"]);
    let both = printed(dir.path(), &["report", "two", "--against", "one"]);
    assert!(both.starts_with(&plain));
    let added = &both[plain.len()..];
    assert!(
        added.contains("Comparison") && added.contains("A  one"),
        "{added}"
    );
    // The file asked for is none of either run.
    let inside = "one/summary.csv";
    let refused = seacable(dir.path())
        .args(["report", "two", "--against", "one", "--force", "-o", inside])
        .assert()
        .code(2);
    refused.stderr(contains("--output").and(contains("summary.csv")));
}
