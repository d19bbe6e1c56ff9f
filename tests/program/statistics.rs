//! `seacable statistics`: of one run and of several, what it refuses; and the study of its intervals.

use std::fs;
use std::process::Command;

use crate::small::SMALL;

struct Place(tempfile::TempDir);

impl Place {
    /// Five runs that differ a little, of a line that swings long enough.
    fn new() -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        fs::write(place.0.path().join("small.toml"), SMALL).unwrap();
        for number in 1..=5 {
            let area = format!("payload.drag_area_m2=0.{number}");
            let out = format!("run-{number}");
            let words = [
                "run",
                "small.toml",
                "--set",
                &area,
                "--set",
                "solver.duration_s=60",
                "--set",
                "output.interval_s=0.25",
                "--out",
                &out,
            ];
            let (status, _, said) = place.seacable(&words);
            assert_eq!(status, Some(0), "{said}");
        }
        place
    }

    fn seacable(&self, words: &[&str]) -> (Option<i32>, String, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        command
            .args(words)
            .current_dir(self.0.path())
            .env("NO_COLOR", "1");
        let done = command.output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (done.status.code(), text(done.stdout), text(done.stderr))
    }
}

const RUNS: [&str; 5] = ["run-1", "run-2", "run-3", "run-4", "run-5"];

#[test]
fn runs_have_moments_greatest_values_and_fatigue() {
    let place = Place::new();
    let more = [
        "--channel",
        "tension_n[vessel|rope]",
        "--from",
        "5s",
        "--fatigue",
        "api-six-strand-rope",
        "--strength",
        "40kN",
        "--ascii",
        "--width",
        "120",
    ];
    let words = [&["statistics"][..], &RUNS, &more].concat();
    let (status, text, said) = place.seacable(&words);
    assert_eq!(status, Some(0), "{said}");
    for word in [
        "Statistics",
        "Greatest of 3 h",
        "Gumbel",
        "Fatigue: ",
        "years",
        "tension_n[vessel|rope]",
    ] {
        assert!(text.contains(word), "{word}: {text}");
    }
    // The table for programs has the moments of the rows themselves.
    let words = [
        &["statistics"][..],
        &RUNS[..1],
        &["--channel", "tension_n[vessel|rope]", "--csv"],
    ]
    .concat();
    let (status, csv, said) = place.seacable(&words);
    assert_eq!(status, Some(0), "{said}");
    let mut rows = csv.lines();
    let (head, row) = (rows.next().unwrap(), rows.next().unwrap());
    let column = head.split(',').position(|name| name == "mean").unwrap();
    let mean: f64 = row.split(',').nth(column).unwrap().parse().unwrap();
    let history = fs::read_to_string(place.0.path().join("run-1/history.csv")).unwrap();
    let mut lines = history.lines();
    let at = lines
        .next()
        .unwrap()
        .split(',')
        .position(|name| name == "tension_n[vessel|rope]")
        .unwrap();
    let values: Vec<f64> = lines
        .map(|line| line.split(',').nth(at).unwrap().parse().unwrap())
        .collect();
    let expected = values.iter().sum::<f64>() / values.len() as f64;
    assert!((mean / expected - 1.0).abs() < 1e-12, "{mean} {expected}");
}

#[test]
fn what_is_missing_is_said() {
    let place = Place::new();
    let refused = |words: &[&str], why: &str| {
        let (status, _, said) = place.seacable(&[&["statistics"][..], words].concat());
        assert_eq!(status, Some(2), "{words:?}: {said}");
        assert!(said.contains(why), "{words:?}: {said}");
    };
    refused(&["nowhere"], "nowhere");
    refused(
        &["run-1", "--channel", "x_m[ghost]"],
        "has no channel x_m[ghost]",
    );
    refused(&["run-1", "--from", "1e6s"], "has 0 rows");
    refused(&["run-1", "--fatigue", "api-six"], "there is no such curve");
    refused(&["run-1", "--fatigue", "api-studless-chain"], "--strength");
    refused(&["run-1", "--level", "1"], "from 0.5 to 0.999");
    let (status, text, _) = place.seacable(&["statistics", "--curves", "--width", "400"]);
    assert_eq!(status, Some(0));
    assert!(
        text.contains("dnv-studless-chain") && text.contains("check against your edition"),
        "{text}"
    );
}

#[test]
fn the_study_of_intervals_is_the_same_for_the_same_seed() {
    let place = tempfile::tempdir().map(Place).unwrap();
    let words = [
        "laboratory",
        "intervals",
        "--draws",
        "40",
        "--values",
        "30",
        "--ascii",
        "--width",
        "120",
    ];
    let (status, text, said) = place.seacable(&words);
    assert_eq!(status, Some(0), "{said}");
    assert!(
        text.contains("90 % quantile") && text.contains("nine in ten"),
        "{text}"
    );
    assert_eq!(place.seacable(&words).1, text);
}
