//! Reports in every format, from the command line.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::PredicateBooleanExt;
use predicates::str::contains;
use serde_json::Value;

use crate::json::fits;
use crate::small::SMALL;

const SECTION: &str = include_str!("../../cases/umbilical/section.toml");
const CROSSING: &str = include_str!("../../cases/ropeway/span_60.toml");
const SHIP: &str = include_str!("../../cases/ship/coupled.toml");
const RESPONSES: &str = include_str!("../../cases/ship/landing_craft.csv");
const BRIDLE: &str = include_str!("../../cases/systems/bridle_in_heave.toml");
const CHAINS: &str = include_str!("../../cases/systems/three_chains.toml");

/// Formats with the ending of their files.
const FORMATS: [(&str, &str); 5] = [
    ("text", "txt"),
    ("markdown", "md"),
    ("html", "html"),
    ("csv", "csv"),
    ("json", "json"),
];

fn seacable(dir: &Path) -> Command {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1");
    command
}

fn printed(dir: &Path, words: &[&str]) -> String {
    let done = seacable(dir).args(words).assert().success();
    String::from_utf8(done.get_output().stdout.clone()).unwrap()
}

/// A directory with a stored run, another of other inputs, and a sweep.
fn runs() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("small.toml"), SMALL).unwrap();
    printed(dir.path(), &["run", "small.toml", "--out", "one"]);
    let key = "--set=solver.duration_s=1.5";
    printed(dir.path(), &["run", "small.toml", key, "--out", "two"]);
    dir
}

/// What a page in each format begins with, and what it holds of a report of the small pendulum.
fn looks_like(format: &str, text: &str) {
    let (begin, has) = match format {
        "text" => ("", "Work and cost\n-------------"),
        "markdown" => ("# ", "## Work and cost"),
        "html" => ("<!DOCTYPE html>", "<h2>Work and cost</h2>"),
        "csv" => ("quantity,value,unit,error,", "history.csv"),
        _ => ("{", "\"kind\": \"run\""),
    };
    assert!(text.starts_with(begin), "{format}: {text}");
    assert!(text.contains(has), "{format}: {text}");
}

#[test]
fn a_run_is_reported_in_every_format() {
    let dir = runs();
    for (format, ending) in FORMATS {
        let text = printed(dir.path(), &["report", "one", "--format", format]);
        looks_like(format, &text);
        // A file has the format of its ending, and the same bytes each time.
        let file = format!("page.{ending}");
        printed(dir.path(), &["report", "one", "-o", &file]);
        assert_eq!(fs::read_to_string(dir.path().join(&file)).unwrap(), text);
        let again = ["report", "one", "-o", &file];
        let refused = seacable(dir.path()).args(again).assert().code(2);
        refused.stderr(contains("--force"));
        printed(dir.path(), &["report", "one", "--force", "-o", &file]);
        assert_eq!(fs::read_to_string(dir.path().join(&file)).unwrap(), text);
    }
    // What is asked for goes before the ending.
    printed(
        dir.path(),
        &["report", "one", "--format", "html", "-o", "page"],
    );
    let page = fs::read_to_string(dir.path().join("page")).unwrap();
    looks_like("html", &page);
}

#[test]
fn numbers_are_whole_in_csv_and_json() {
    let dir = runs();
    let csv = printed(dir.path(), &["report", "one", "--format", "csv"]);
    let summary = fs::read_to_string(dir.path().join("one/summary.csv")).unwrap();
    for line in summary.lines().skip(1) {
        let [name, value, unit] = [0, 1, 2].map(|i| line.split(',').nth(i).unwrap());
        let same = |row: &str| row.starts_with(&format!("{name},")) && row.contains(unit);
        let row = csv.lines().find(|row| same(row)).unwrap();
        let written: f64 = row.split(',').nth(1).unwrap().parse().unwrap();
        assert_eq!(written.to_bits(), value.parse::<f64>().unwrap().to_bits());
    }
    let json = printed(dir.path(), &["report", "one", "--format", "json"]);
    let json: Value = serde_json::from_str(&json).unwrap();
    fits(&json, "report_of_run");
    let rows = csv.lines().count() - 1;
    assert_eq!(json["results"].as_array().unwrap().len(), rows);
}

#[test]
fn a_comparison_is_in_every_format() {
    let dir = runs();
    let words = |format| ["report", "two", "--against", "one", "--format", format];
    let html = printed(dir.path(), &words("html"));
    assert!(html.contains("<h1>Comparison</h1>") && html.contains("solver.duration_s"));
    let markdown = printed(dir.path(), &words("markdown"));
    assert!(markdown.contains("# Comparison\n") && markdown.contains("- **A** one: small.toml"));
    let csv = printed(dir.path(), &words("csv"));
    assert!(csv.starts_with("section,name,unit,run,") && csv.contains("\nresult,"));
    let json: Value = serde_json::from_str(&printed(dir.path(), &words("json"))).unwrap();
    fits(&json, "report_of_run");
    assert_eq!(json["against"]["run"], "one");
    assert!(!json["against"]["results"].as_array().unwrap().is_empty());
}

#[test]
fn studies_are_included_where_they_were_run() {
    let dir = runs();
    let without = printed(dir.path(), &["report", "one"]);
    assert!(without.contains("because none was run"));
    fs::write(
        dir.path().join("hard.csv"),
        "trial,outcome\nslack <b>,PASS\n",
    )
    .unwrap();
    let words = ["report", "one", "--study", "hard.csv", "--format", "html"];
    let with = printed(dir.path(), &words);
    assert!(with.contains("slack &lt;b&gt;") && !with.contains("because none was run"));
    fs::write(dir.path().join("empty.csv"), "").unwrap();
    for (file, says) in [("empty.csv", "no table"), ("nowhere.csv", "nowhere.csv")] {
        let refused = seacable(dir.path())
            .args(["report", "one", "--study", file])
            .assert();
        refused
            .code(2)
            .stderr(contains("--study").and(contains(says)));
    }
}

#[test]
fn a_sweep_is_reported_from_its_folder() {
    let dir = runs();
    let vary = "--vary=solver.duration_s=1..2/3";
    printed(dir.path(), &["sweep", "small.toml", vary, "--out", "all"]);
    let text = printed(dir.path(), &["report", "all"]);
    assert!(text.starts_with("Load cases of small.toml\n"), "{text}");
    assert!(text.contains("Varied      solver.duration_s"), "{text}");
    let html = printed(dir.path(), &["report", "all", "--format", "html"]);
    assert!(html.contains("<svg") && html.contains("<h2>Inputs</h2>"));
    let csv = printed(dir.path(), &["report", "all", "--format", "csv"]);
    let stored = fs::read_to_string(dir.path().join("all/results.csv")).unwrap();
    assert_eq!(csv.lines().count(), stored.lines().count());
    let json = printed(dir.path(), &["report", "all", "--format", "json"]);
    let json: Value = serde_json::from_str(&json).unwrap();
    fits(&json, "study");
    assert_eq!(json["rows"].as_array().unwrap().len(), 3);
    let refused = seacable(dir.path())
        .args(["report", "all", "--against", "one"])
        .assert();
    refused.code(2).stderr(contains("--against compares runs"));
}

#[test]
fn files_that_need_no_run_are_reported_as_they_are() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("landing_craft.csv"), RESPONSES).unwrap();
    let files = [
        ("section.toml", SECTION, "report"),
        ("ropeway.toml", CROSSING, "report"),
        ("ship.toml", SHIP, "report"),
        ("system.toml", CHAINS, "system"),
    ];
    for (file, text, kind) in files {
        fs::write(dir.path().join(file), text).unwrap();
        let html = printed(dir.path(), &["report", file, "--format", "html"]);
        assert!(html.contains("<svg") && html.contains("<table"), "{file}");
        let json = printed(dir.path(), &["report", file, "--format", "json"]);
        let json: Value = serde_json::from_str(&json).unwrap();
        fits(&json, kind);
        if kind == "report" {
            fits(&json["tables"][0], "report_table");
            fits(&json["charts"][0], "report_chart");
        }
        let csv = printed(dir.path(), &["report", file, "--format", "csv"]);
        assert!(csv.starts_with("table,row,column,value\n") && csv.lines().count() > 10);
    }
    for (file, text) in [("line.toml", SMALL), ("moving.toml", BRIDLE)] {
        fs::write(dir.path().join(file), text).unwrap();
        let refused = seacable(dir.path()).args(["report", file]).assert().code(2);
        refused.stderr(contains(format!("`seacable run {file}` stores one")));
    }
}

#[test]
fn a_system_in_time_is_reported_in_every_format() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("moving.toml"), BRIDLE).unwrap();
    let key = "--set=solver.duration_s=2";
    printed(dir.path(), &["run", "moving.toml", key, "--out", "r"]);
    let html = printed(dir.path(), &["report", "r", "--format", "html"]);
    assert!(html.contains("<h2>Charts</h2>") && html.contains("<svg"));
    let json = printed(dir.path(), &["report", "r", "--format", "json"]);
    let json: Value = serde_json::from_str(&json).unwrap();
    fits(&json, "report_of_system_run");
    fits(&json["motion"], "motion");
    let csv = printed(dir.path(), &["report", "r", "--format", "csv"]);
    assert!(csv.contains("history.csv"));
}

/// Whatever a case is called, its report has no markup of it.
#[test]
fn hostile_names_are_no_markup() {
    let dir = tempfile::tempdir().unwrap();
    let hostile = "</title><script>alert(1)</script><img src=x onerror=y>```";
    let text = SMALL.replace("A small pendulum", hostile);
    assert_ne!(text, SMALL);
    fs::write(dir.path().join("small.toml"), text).unwrap();
    printed(dir.path(), &["run", "small.toml", "--out", "r"]);
    let html = printed(dir.path(), &["report", "r", "--format", "html"]);
    assert!(html.contains("&lt;script&gt;"));
    for word in ["<script", "<img", "onerror=y>"] {
        assert!(!html.contains(word), "{word}");
    }
    let markdown = printed(dir.path(), &["report", "r", "--format", "markdown"]);
    assert!(!markdown.contains("\n# </title><script>"), "{markdown}");
    assert!(markdown.contains("&lt;script>") && markdown.contains("\\`\\`\\`"));
}
