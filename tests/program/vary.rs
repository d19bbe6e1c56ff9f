//! `seacable study vary`: ranges, grids, failures, stored runs.

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use assert_cmd::Command;
use predicates::{prelude::*, str::contains};
use seacable::run::{RunState, store};
use seacable::study::points::{self, BaseCase};
use seacable::study::vary::{Variation, VariedKey};

use crate::small::SMALL;

const OC3: &str = include_str!("../../cases/systems/oc3_spar.toml");
const OC3_FREE: &str = include_str!("../../cases/systems/oc3_free.toml");

fn seacable(dir: &Path) -> Command {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1");
    command
}

fn place() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("small.toml"), SMALL).unwrap();
    dir
}

fn vary(dir: &Path, words: &[&str]) -> Command {
    let mut command = seacable(dir);
    command.args(["study", "vary", "small.toml"]).args(words);
    command
}

/// The folders of sweeps among the runs.
fn sweeps(dir: &Path) -> Vec<PathBuf> {
    let Ok(listed) = std::fs::read_dir(dir.join("runs")) else {
        return Vec::new();
    };
    let all = listed.map(|item| item.unwrap().path());
    all.filter(|path| path.join("sweep.toml").is_file())
        .collect()
}

fn printed(mut command: Command) -> String {
    let done = command.assert().success();
    String::from_utf8(done.get_output().stdout.clone()).unwrap()
}

#[test]
fn a_key_over_a_range_gives_a_table_a_chart_and_stored_runs() {
    let dir = place();
    let words = [
        "--vary",
        "payload.wet_mass_kg=0.3..0.5 t/3",
        "--result",
        "tension_n.max",
        "--ascii",
    ];
    let text = printed(vary(dir.path(), &words));
    for word in [
        "payload.wet_mass_kg",
        "300 kg",
        "400 kg",
        "500 kg",
        "tension_n.max",
        " +/- ",
        "OK",
        "CPU time",
        "its table is results.csv",
        "tension_n.max against payload.wet_mass_kg",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert!(
        text.is_ascii() && text.lines().all(|line| line.len() <= 80),
        "{text}"
    );
    let [sweep] = &sweeps(dir.path())[..] else {
        panic!("{text}")
    };
    let table = std::fs::read_to_string(sweep.join("results.csv")).unwrap();
    assert_eq!(table.lines().count(), 4, "{table}");
    let stored = store::list(&dir.path().join("runs")).unwrap();
    let mut set: Vec<String> = stored
        .iter()
        .map(|run| run.info.as_ref().unwrap())
        .map(|info| {
            assert_eq!(
                (info.state, info.case_file.as_str()),
                (RunState::Done, "small.toml")
            );
            info.overrides.join(" ")
        })
        .collect();
    set.sort();
    assert_eq!(
        set,
        ["300", "400", "500"].map(|kg| format!("payload.wet_mass_kg={kg}"))
    );
}

/// A point of a study is the run of its case: the same bits as computed alone.
#[test]
fn a_grid_has_every_combination_and_the_results_of_single_runs() {
    let dir = place();
    let words = [
        "--vary",
        "payload.drag_area_m2=1,2",
        "--vary",
        "line.rope.segments=4..8/3",
        "--csv",
        "--result",
        "tension_n[rope|payload].max",
        "--set",
        "solver.duration_s=3",
    ];
    let csv = printed(vary(dir.path(), &words));
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let heads = reader.headers().unwrap().clone();
    assert_eq!(&heads[1], "payload.drag_area_m2 [m²]");
    assert_eq!(&heads[4], "error of tension_n[rope|payload].max [N]");
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let values: Vec<(&str, &str)> = rows.iter().map(|row| (&row[1], &row[2])).collect();
    let [one, two] = ["1", "2"].map(|area| ["4", "6", "8"].map(|count| (area, count)));
    assert_eq!(values, [one, two].concat());
    let alone = [
        "run",
        "small.toml",
        "--out",
        "alone",
        "--set",
        "solver.duration_s=3",
        "--set",
        "payload.drag_area_m2=2",
        "--set",
        "line.rope.segments=6",
    ];
    seacable(dir.path()).args(alone).assert().success();
    let run = store::read(&dir.path().join("alone")).unwrap();
    let value = run.quantity("tension_n[rope|payload].max").unwrap();
    assert_eq!(
        rows[4][3].parse::<f64>().unwrap().to_bits(),
        value.value.to_bits()
    );
    let stored = store::read(&dir.path().join(&rows[4][8])).unwrap();
    assert_eq!(
        stored.info.overrides,
        [
            "solver.duration_s=3",
            "payload.drag_area_m2=2",
            "line.rope.segments=6"
        ]
    );
}

#[test]
fn a_point_that_fails_says_why_and_stops_no_other() {
    let dir = place();
    let words = [
        "--set",
        "solver.method=rk4",
        "--vary",
        "solver.time_step_s=0.001,1.0",
        "--no-store",
        "--result",
        "tension_n.max",
    ];
    let failed = vary(dir.path(), &words).assert().code(1);
    failed.stdout(
        contains("FAILED [2]")
            .and(contains("stability limit"))
            .and(contains("OK")),
    );
    // The line does not reach where end B is put at the second point.
    let held = SMALL.replace(
        "kind = \"payload\"",
        "kind = \"fixed\"\nposition_m = [15.0, 0.0, -10.0]",
    );
    let held =
        held.split("[payload]").next().unwrap().to_owned() + "[solver]\nmethod = \"static\"\n";
    std::fs::write(dir.path().join("small.toml"), held).unwrap();
    let words = [
        "--vary",
        "ends.b.position_m.x=15,1e5",
        "--no-store",
        "--result",
        "tension_n.max",
    ];
    let refused = vary(dir.path(), &words).assert().code(1);
    refused.stdout(
        contains("REFUSED [2]")
            .or(contains("FAILED [2]"))
            .and(contains("OK")),
    );
    assert!(!dir.path().join("runs").exists());
}

#[test]
fn what_is_wrong_is_named_before_anything_is_computed() {
    let dir = place();
    for (words, why) in [
        (
            &["--vary", "payload.wet_mas_kg=1,2"][..],
            "did you mean `wet_mass_kg`",
        ),
        (
            &["--vary", "payload.wet_mass_kg=1..2"],
            "lacks the number of values",
        ),
        (
            &["--vary", "payload.wet_mass_kg=1..2 furlong/3"],
            "give it in kg",
        ),
        (
            &[
                "--vary",
                "payload.wet_mass_kg=1,2",
                "--result",
                "tension_n.mx",
            ],
            "did you mean `tension_n.max`",
        ),
        (&[], "--vary"),
    ] {
        let found = vary(dir.path(), words).assert().code(2).stdout("");
        found.stderr(contains(why));
    }
    assert!(!dir.path().join("runs").exists());
}

/// One engine: both commands make the same table, and either goes on with what the other began.
#[test]
fn it_is_a_sweep_with_the_rows_of_all_points() {
    let dir = place();
    let words = [
        "small.toml",
        "--vary",
        "payload.wet_mass_kg=300,400",
        "--vary",
        "solver.duration_s=2,3",
        "--jobs",
        "1",
        "--csv",
        "--out",
    ];
    let made = |command: &[&str], out: &str| {
        let mut command = {
            let mut made = seacable(dir.path());
            made.args(command).args(words).arg(out);
            made
        };
        command.assert().success();
        let folder = dir.path().join(out);
        std::fs::read_to_string(folder.join("results.csv")).unwrap()
    };
    let varied = made(&["study", "vary"], "same");
    for name in std::fs::read_dir(dir.path()).unwrap() {
        let path = name.unwrap().path();
        if path.is_dir() {
            std::fs::remove_dir_all(path).unwrap();
        }
    }
    assert_eq!(varied, made(&["sweep"], "same"));
    // A run that is gone is computed again.
    std::fs::remove_dir_all(dir.path().join("same-0003")).unwrap();
    let mut again = seacable(dir.path());
    again.args(["study", "vary", "--resume", "same", "--csv"]);
    let csv = printed(again);
    assert_eq!(csv.lines().count(), 5, "{csv}");
    let table = std::fs::read_to_string(dir.path().join("same/results.csv")).unwrap();
    assert_eq!(varied, table);
}

#[test]
fn what_is_read_from_stored_runs_is_not_left_unstored() {
    let dir = place();
    let check = "\n[[checks]]\nname = \"strength\"\nkind = \"safety-factor\"\nfactor = 1.5\nbreak_load_n = 1e6\n";
    let text = std::fs::read_to_string(dir.path().join("small.toml")).unwrap();
    std::fs::write(dir.path().join("small.toml"), text + check).unwrap();
    let words = ["--vary", "payload.wet_mass_kg=300,400"];
    let refused = vary(dir.path(), &[&words[..], &["--no-store"]].concat())
        .assert()
        .code(2);
    refused.stderr(contains("leave out --no-store"));
    let text = printed(vary(dir.path(), &words));
    assert!(
        text.contains("Verdict") && text.contains("400 kg"),
        "{text}"
    );
}

#[test]
fn cancelled_points_have_no_outcome() {
    let base = BaseCase::new(SMALL, "small.toml");
    let key = VariedKey::parse("payload.wet_mass_kg=300..500/21", SMALL).unwrap();
    let variation = Variation::of_keys(base, vec![key]).unwrap();
    let (cancel, seen) = (AtomicBool::new(false), Mutex::new(0));
    let outcomes = points::compute(variation.requests(), &cancel, &|progress| {
        assert_eq!(progress.of, 21);
        *seen.lock().unwrap() += 1;
        cancel.store(true, Ordering::Relaxed);
    });
    let begun = outcomes.iter().flatten().count();
    assert_eq!((outcomes.len(), begun), (21, *seen.lock().unwrap()));
    assert!(begun < 21, "{begun}");
}

/// A directory with a system.
fn system(words: &[&str]) -> (tempfile::TempDir, Command) {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("oc3.toml"), OC3).unwrap();
    let mut command = seacable(dir.path());
    command.args(["study", "vary", "oc3.toml"]).args(words);
    (dir, command)
}

#[test]
fn a_system_over_a_range_gives_a_table_and_charts_and_stores_the_table_alone() {
    let (dir, command) = system(&["--vary", "lines.mooring.length_m=890..910 m/3", "--ascii"]);
    let text = printed(command);
    for word in [
        "lines.mooring.length_m",
        "890 m",
        "900 m",
        "910 m",
        "tension_n[mooring|b]",
        "OK",
        "tension_n[mooring|b] against lines.mooring.length_m",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    // What only runs have, and bars of rounding errors.
    for word in ["CPU time", "its runs", "error bars"] {
        assert!(!text.contains(word), "{word} in\n{text}");
    }
    assert!(text.is_ascii(), "{text}");
    assert!(store::list(&dir.path().join("runs")).unwrap().is_empty());
    let [sweep] = &sweeps(dir.path())[..] else {
        panic!("{text}")
    };
    let table = std::fs::read_to_string(sweep.join("results.csv")).unwrap();
    assert_eq!(table.lines().count(), 4, "{table}");
    let (dir, command) = system(&["--vary", "lines.mooring.length_m=890,900", "--no-store"]);
    assert!(printed(command).contains("890 m") && !dir.path().join("runs").exists());
}

#[test]
fn the_results_of_a_system_are_those_of_single_runs() {
    let words = [
        "--vary",
        "lines.mooring.length_m=902.2,905",
        "--vary",
        "seabed.friction=0,0.5",
        "--result",
        "tension_n[mooring|a]",
        "--result",
        "stiffness[spar|11]",
        "--csv",
    ];
    let (dir, command) = system(&words);
    let csv = printed(command);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let heads = reader.headers().unwrap().clone();
    let expected = [
        "point",
        "lines.mooring.length_m [m]",
        "seabed.friction",
        "tension_n[mooring|a] [N]",
        "error of tension_n[mooring|a] [N]",
        "stiffness[spar|11] [N/m]",
        "error of stiffness[spar|11] [N/m]",
        "state",
        "reason",
    ];
    assert_eq!(heads.iter().collect::<Vec<_>>(), expected);
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 4);
    let set = "lines.mooring.length_m=905";
    let alone = seacable(dir.path())
        .args(["run", "oc3.toml", "--json", "--set", set])
        .args(["--set", "seabed.friction=0.5"])
        .output()
        .unwrap();
    let alone: serde_json::Value = serde_json::from_slice(&alone.stdout).unwrap();
    let number = |value: &serde_json::Value| value.as_f64().unwrap().to_bits();
    let found = |column: usize| rows[3][column].parse::<f64>().unwrap().to_bits();
    assert_eq!(found(3), number(&alone["lines"][0]["tension_a_n"]));
    assert_eq!(found(4), number(&alone["lines"][0]["error_n"]));
    assert_eq!(found(5), number(&alone["bodies"][0]["stiffness"][0][0]));
    assert!(rows.iter().all(|row| &row[7] == "OK"), "{csv}");
    let (_dir, mut json) = system(&["--vary", "seabed.friction=0,0.5", "--json"]);
    let json = json.output().unwrap();
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["study"], "vary");
    assert_eq!(json["rows"].as_array().unwrap().len(), 2);
}

#[test]
fn a_free_body_has_its_offset_and_its_periods_among_the_main_results() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("oc3.toml"), OC3_FREE).unwrap();
    let mut command = seacable(dir.path());
    command.args(["study", "vary", "oc3.toml", "--csv"]);
    command.args(["--vary", "bodies.spar.mass_kg=8.0e6,8.1e6"]);
    let csv = printed(command);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let heads = reader.headers().unwrap().clone();
    let place = |name: &str| heads.iter().position(|head| head == name).unwrap();
    let longest = place("period_s[1] [s]");
    place("offset_m[spar] [m]");
    place("period_s[6] [s]");
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let period = |row: usize| rows[row][longest].parse::<f64>().unwrap();
    assert!(period(1) > period(0) && period(0) > 100.0, "{csv}");
}

#[test]
fn a_point_of_a_system_that_is_refused_says_why_and_stops_no_other() {
    // The anchors are 320 m deep.
    let (_dir, mut command) = system(&["--vary", "seabed.depth_m=320,300,321"]);
    let refused = command.assert().code(1);
    refused.stdout(
        contains("REFUSED [2]")
            .and(contains("REFUSED [1]").not())
            .and(contains("REFUSED [3]").not())
            .and(contains("below the bed")),
    );
    for (words, why) in [
        (&["--vary", "lines.mooring.lenth_m=1,2"][..], "length_m"),
        (&["--vary", "lines.moring.length_m=1,2"], "moring"),
        (&["--vary", "points.anchor.position_m=1,2"], "position_m.x"),
        (
            &["--vary", "seabed.depth_m=320,321", "--result", "tension"],
            "no result `tension`",
        ),
    ] {
        let (_dir, mut command) = system(words);
        command.assert().code(2).stdout("").stderr(contains(why));
    }
}
