//! Work above a limit is refused before it begins, in a moment, in words that name the option that allows it.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use crate::small::SMALL;

/// A refusal takes no longer than this, on a machine that runs other tests as well.
const MOMENT: Duration = Duration::from_secs(5);
/// What a program prints of a fault, whatever the file holds \[bytes\].
const MOST_PRINTED: usize = 60_000;

struct Bench {
    dir: tempfile::TempDir,
}

impl Bench {
    fn new() -> Self {
        Self {
            dir: tempfile::tempdir().unwrap(),
        }
    }

    fn put(&self, name: &str, text: &str) -> PathBuf {
        let path = self.dir.path().join(name);
        fs::write(&path, text).unwrap();
        path
    }

    fn run(&self, words: &[&str]) -> Output {
        let begun = Instant::now();
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        let done = command.args(words).current_dir(self.dir.path()).output();
        let done = done.unwrap();
        assert!(begun.elapsed() < MOMENT, "{words:?}: {:?}", begun.elapsed());
        done
    }

    /// What the refusal of a file says.
    fn refusal(&self, words: &[&str], text: &str) -> String {
        self.put("case.toml", text);
        let done = self.run(words);
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(2), "{words:?}: {said}");
        assert!(said.len() < MOST_PRINTED, "{words:?}: {} bytes", said.len());
        said
    }
}

const RUN: [&str; 4] = ["run", "case.toml", "--out", "run"];

/// The small case with a table of each kind as often as wanted.
fn repeated(what: impl Fn(usize) -> String, count: usize) -> String {
    let mut text = SMALL.to_owned();
    for number in 0..count {
        let _ = write!(text, "\n{}", what(number));
    }
    text
}

#[test]
fn steps_and_rows_beyond_a_limit_are_refused_with_the_option_that_allows_them() {
    let bench = Bench::new();
    let with = |set: &str| {
        let words = ["run", "case.toml", "--out", "run", "--set", set];
        bench.refusal(&words, SMALL)
    };
    let said = with("solver.time_step_s=1e-12");
    assert!(
        said.contains("would take") && said.contains("`--limit-steps "),
        "{said}"
    );
    let said = with("output.interval_s=1e-9");
    assert!(
        said.contains("would write") && said.contains("`--limit-rows "),
        "{said}"
    );
    assert!(!bench.dir.path().join("run").exists());
    // The option allows them: the step is refused for nothing but its number.
    let words = ["run", "case.toml", "--out", "run", "--limit-steps", "3"];
    let done = bench.run(&[&words[..], &["--set", "solver.time_step_s=0.1"]].concat());
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.contains("3 are allowed"), "{said}");
    let words = ["run", "case.toml", "--out", "run", "--limit-steps", "1e5"];
    let done = bench.run(&[&words[..], &["--set", "solver.time_step_s=0.1"]].concat());
    assert_eq!(done.status.code(), Some(0));
    let done = bench.run(&["run", "case.toml", "--limit-steps", "nan"]);
    assert_eq!(done.status.code(), Some(2));
}

#[test]
fn points_of_a_variation_beyond_a_limit_are_refused_with_the_option_that_allows_them() {
    let bench = Bench::new();
    let vary = |values: &str, limit: &[&str]| {
        let words = ["study", "vary", "case.toml", "--no-store", "--vary", values];
        bench.put("case.toml", SMALL);
        let done = bench.run(&[&words[..], limit].concat());
        (done.status.code(), String::from_utf8(done.stderr).unwrap())
    };
    let durations = "solver.duration_s=1..2/20000";
    let (status, said) = vary(durations, &[]);
    assert_eq!(status, Some(2));
    assert!(said.contains("`--limit-points 20000`"), "{said}");
    let (status, said) = vary("solver.duration_s=1..2/3", &["--limit-points", "2"]);
    assert_eq!(status, Some(2));
    assert!(said.contains("2 are allowed"), "{said}");
    let (status, said) = vary("solver.duration_s=1..2/3", &["--limit-points", "3"]);
    assert_eq!(status, Some(0), "{said}");
}

#[test]
fn very_many_tables_are_refused_in_every_kind_of_file() {
    let bench = Bench::new();
    let tables: [fn(usize) -> String; 4] = [
        |i| format!("[materials.m{i}]\ndiameter_m = 0.1\n"),
        |i| format!("[[study]]\nname = \"s{i}\"\n"),
        |i| format!("[[published]]\nname = \"p{i}\"\n"),
        |i| format!("[[clumps]]\nname = \"c{i}\"\n"),
    ];
    for what in tables {
        for command in ["run", "validate", "modes"] {
            let said = bench.refusal(&[command, "case.toml"], &repeated(what, 30_000));
            assert!(said.contains("`--limit-tables "), "{said}");
        }
    }
    let points: String = (0..30_000)
        .map(|i| format!("[points.p{i}]\nkind = \"fixed\"\nposition_m = [{i}, 0, 0]\n"))
        .collect();
    let said = bench.refusal(&RUN, &format!("[system]\ntitle = \"many\"\n{points}"));
    assert!(said.contains("30000 entries"), "{said}");
}

#[test]
fn of_very_many_faults_the_first_are_shown_and_the_others_counted() {
    let bench = Bench::new();
    let keys = |count: usize| {
        let keys: String = (0..count).map(|i| format!("qq{i} = 1\n")).collect();
        SMALL.replace("[solver]\n", &format!("[solver]\n{keys}"))
    };
    let said = bench.refusal(&RUN, &keys(1500));
    assert_eq!(said.matches("error: ").count(), 51, "{said}");
    assert!(said.contains("1450 more faults are not shown"), "{said}");
    let twice = |_| {
        "[[line]]\nname = \"s\"\nmaterial = \"rope\"\nlength_m = 1.0\nsegments = 1\n".to_owned()
    };
    let said = bench.refusal(&RUN, &repeated(twice, 1500));
    assert!(said.contains("more faults are not shown"), "{said}");
}

/// A mebibyte in the place of a word: it was compared with every known word, by a table of their lengths' product, and printed whole.
#[test]
fn a_word_of_a_mebibyte_is_refused_at_once_and_not_repeated() {
    let bench = Bench::new();
    let word = "a".repeat(1 << 20);
    let texts = [
        SMALL.replace("[solver]\n", &format!("[solver]\n{word} = 1\n")),
        format!("{SMALL}\n[{word}]\nx = 1\n"),
        format!("{SMALL}\n[materials.{word}]\nea_n = 1.0\n"),
        SMALL.replace("name = \"", &format!("name = \"{word}")),
        SMALL.replace("kind = \"", &format!("kind = \"{word}")),
        SMALL.replace("material = \"", &format!("material = \"{word}")),
        SMALL.replace("title = \"", &format!("title = \"{word}")),
    ];
    for text in texts {
        for command in ["run", "validate"] {
            let said = bench.refusal(&[command, "case.toml"], &text);
            assert!(!said.contains(&word[..2000]), "{}", said.len());
        }
    }
    let done = bench.run(&[&word[..100_000]]);
    assert_eq!(done.status.code(), Some(2));
}

#[test]
fn tables_of_lines_and_studies_have_their_limits() {
    let bench = Bench::new();
    let head = "a_x_m,a_y_m,a_z_m,b_x_m,b_y_m,b_z_m,length_m,weight_n_per_m,ea_n,diameter_m,drag_normal,\
                drag_tangential,water_density_kg_per_m3,current_x_m_per_s,current_y_m_per_s";
    let row = "\n0,0,0,500,0,-100,600,300,1e9,0.1,1.2,0.01,1025,1.0,0.0";
    bench.put("lines.csv", &format!("{head}{}", row.repeat(20_001)));
    let done = bench.run(&["catenary", "lines.csv"]);
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.contains("`--limit-lines 20001`"), "{said}");
    for words in [
        &["laboratory", "systems", "--count", "1000000000000000000"][..],
        &["study", "systems", "--count", "0"],
        &[
            "study",
            "offsets",
            "x.toml",
            "--to",
            "10",
            "--steps",
            "1000000000",
        ],
    ] {
        let done = bench.run(words);
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(2), "{said}");
        assert!(said.contains("is not in 1..="), "{said}");
    }
}

/// Whatever `--force` allows, the files of a stored run are its own.
#[test]
fn no_output_takes_the_place_of_a_file_of_a_run() {
    let bench = Bench::new();
    let case = bench.put("case.toml", SMALL);
    assert_eq!(bench.run(&RUN).status.code(), Some(0));
    let case = case.to_str().unwrap();
    for name in [
        "run.toml",
        "case.toml",
        "history.csv",
        "notes.toml",
        "ropes.csv",
    ] {
        let path = Path::new("run").join(name);
        let before = fs::read(bench.dir.path().join(&path)).ok();
        let output = path.to_str().unwrap();
        for words in [
            &["modes", case, "-o", output, "--force"][..],
            &["section", "x.toml", "-o", output, "--force"],
            &["modes", case, "-o", output],
        ] {
            let done = bench.run(words);
            let said = String::from_utf8(done.stderr).unwrap();
            assert_eq!(done.status.code(), Some(2), "{words:?}: {said}");
            assert!(said.contains("belongs to the run"), "{words:?}: {said}");
        }
        assert_eq!(
            fs::read(bench.dir.path().join(&path)).ok(),
            before,
            "{name}"
        );
    }
    // A report beside them is the user's.
    let done = bench.run(&["report", "run", "-o", "run/report.txt"]);
    assert_eq!(
        done.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
    let done = bench.run(&["run", "case.toml", "--out", "run/inner"]);
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.contains("inside the run"), "{said}");
    let done = bench.run(&["run", "case.toml", "--out", "run9/../run"]);
    assert_eq!(done.status.code(), Some(2));
    assert!(!bench.dir.path().join("run9").exists());
}
