//! The program as its users call it: words, output, exit status.

use std::{
    fs,
    io::Read,
    path::{Path, PathBuf},
    process::{Command as Process, Stdio},
};

use crate::small::SMALL;
use assert_cmd::Command;
use predicates::{prelude::*, str::contains};
use seacable::run::{RunState, store};

/// A published row about its final tension, which is the weight of the body.
fn published(value: f64, more: &str) -> String {
    format!(
        "\n[[published]]\nname = \"final tension\"\nchannel = \"tension_n[rope|payload]\"\n\
         statistic = \"mean\"\nvalue = {value:?}\ntolerance_rel = 0.5\nsource = \"nowhere\"\n\
         inputs = \"published\"\n{more}\n"
    )
}

fn seacable(dir: &Path) -> Command {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1");
    command
}

fn place(text: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("small.toml"), text).unwrap();
    dir
}

/// The one run below `runs`.
fn only_run(dir: &Path) -> PathBuf {
    let mut runs: Vec<PathBuf> = fs::read_dir(dir.join("runs"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    assert_eq!(runs.len(), 1, "{runs:?}");
    runs.remove(0)
}

#[test]
fn help_names_every_word() {
    let dir = tempfile::tempdir().unwrap();
    seacable(dir.path())
        .arg("--help")
        .assert()
        .success()
        .stdout(
            contains("run")
                .and(contains("validate"))
                .and(contains("report")),
        );
    let run = contains("--set <KEY=VALUE>")
        .and(contains("static"))
        .and(contains("quasi"))
        .and(contains("rk4"))
        .and(contains("alpha"))
        .and(contains("--out <DIR>"));
    seacable(dir.path())
        .args(["run", "--help"])
        .assert()
        .success()
        .stdout(run);
    seacable(dir.path())
        .arg("--version")
        .assert()
        .success()
        .stdout(contains("seacable"));
}

#[test]
fn unknown_words_get_a_suggestion() {
    let dir = tempfile::tempdir().unwrap();
    seacable(dir.path())
        .arg("valdate")
        .assert()
        .code(2)
        .stderr(contains("`validate` meant"));
    seacable(dir.path())
        .args(["run", "x.toml", "--solver", "rk"])
        .assert()
        .code(2)
        .stderr(contains("rk4"));
    seacable(dir.path())
        .args(["run", "x.toml", "--sett", "a=b"])
        .assert()
        .code(2)
        .stderr(contains("--set"));
}

#[test]
fn without_a_terminal_it_says_what_to_do() {
    let dir = place(SMALL);
    for args in [&[][..], &["small.toml"]] {
        seacable(dir.path())
            .args(args)
            .assert()
            .code(2)
            .stdout("")
            .stderr(contains("needs a terminal").and(contains("seacable run CASE")));
    }
}

#[test]
fn a_run_prints_its_directory_and_its_results() {
    let dir = place(SMALL);
    let done = seacable(dir.path())
        .args(["run", "small.toml"])
        .assert()
        .success();
    let out = String::from_utf8(done.get_output().stdout.clone()).unwrap();
    let written = dir.path().join(out.lines().next().unwrap());
    assert_eq!(written, only_run(dir.path()));
    for word in [
        "tension_n[rope|payload]",
        ".max",
        "z_m[payload]",
        "time error",
        "mesh error",
    ] {
        assert!(out.contains(word), "{word} is missing in\n{out}");
    }
    assert!(
        done.get_output().stderr.is_empty(),
        "no progress without a terminal"
    );

    let run = store::read(&written).unwrap();
    assert_eq!(run.info.state, RunState::Done);
    assert_eq!(run.case_text, SMALL);
    assert_eq!(run.info.id, written.file_name().unwrap().to_string_lossy());
    assert!(
        run.info.warnings.iter().all(|w| !w.contains(".csv")),
        "{:?}",
        run.info.warnings
    );
}

#[test]
fn keys_and_solver_are_set_on_top_of_the_file() {
    let dir = place(SMALL);
    let chosen = dir.path().join("here");
    seacable(dir.path())
        .args(["run", "small.toml", "--set", "payload.drag_area_m2=2.5"])
        .args([
            "--set",
            "line.rope.segments = 8",
            "--solver",
            "quasi",
            "--out",
            "here",
        ])
        .assert()
        .success()
        .stdout(predicates::str::starts_with("here\n"));
    let run = store::read(&chosen).unwrap();
    assert_eq!(run.info.settings.method, "quasi");
    assert_eq!(run.info.settings.nodes, 9);
    assert!(run.case_text.contains("drag_area_m2 = 2.5"));
    assert_eq!(run.info.overrides.len(), 3);

    // A run never overwrites another.
    seacable(dir.path())
        .args(["run", "small.toml", "--out", "here"])
        .assert()
        .code(2)
        .stderr(contains("never overwrites"));
}

#[test]
fn bad_input_is_status_2_and_leaves_nothing_behind() {
    let dir = place(SMALL);
    fs::write(
        dir.path().join("bad.toml"),
        SMALL.replace("length_m = 20.0", "length_m = -20.0"),
    )
    .unwrap();
    let cases: [(&[&str], &str); 6] = [
        (&["run", "none.toml"], "none.toml"),
        (&["run", "bad.toml"], "length_m"),
        (&["run", "."], "directory"),
        (
            &["run", "small.toml", "--set", "payload.drag_area_m2"],
            "KEY=VALUE",
        ),
        (
            &["run", "small.toml", "--set", "payload.colour=3"],
            "colour",
        ),
        (
            &["run", "small.toml", "--set", "payload.drag_area_m2=-3"],
            "drag_area_m2",
        ),
    ];
    for (args, said) in cases {
        seacable(dir.path())
            .args(args)
            .assert()
            .code(2)
            .stdout("")
            .stderr(contains(said));
    }
    assert!(!dir.path().join("runs").exists());
}

#[test]
fn a_report_is_printed_or_written() {
    let dir = place(&format!("{SMALL}{}", published(4000.0, "")));
    seacable(dir.path())
        .args(["run", "small.toml", "--out", "r"])
        .assert()
        .success();
    let printed = seacable(dir.path())
        .args(["report", "r"])
        .assert()
        .success();
    let text = String::from_utf8(printed.get_output().stdout.clone()).unwrap();
    for section in [
        "A small pendulum",
        "Inputs",
        "Results",
        "Published values",
        "Work and cost",
    ] {
        assert!(text.contains(section), "{section} is missing in\n{text}");
    }
    seacable(dir.path())
        .args(["report", "r", "-o", "report.txt"])
        .assert()
        .success()
        .stdout("");
    assert_eq!(
        fs::read_to_string(dir.path().join("report.txt")).unwrap(),
        text
    );

    let ascii = seacable(dir.path())
        .args(["report", "r", "--ascii"])
        .assert()
        .success();
    assert!(ascii.get_output().stdout.is_ascii());

    seacable(dir.path())
        .args(["report", "nowhere"])
        .assert()
        .code(2)
        .stderr(contains("nowhere"));
    seacable(dir.path())
        .args(["report", "."])
        .assert()
        .code(2)
        .stderr(contains("run.toml"));
    seacable(dir.path())
        .args(["report", "r", "-o", "no/such/dir.txt"])
        .assert()
        .code(2)
        .stderr(contains("no/such/dir.txt"));
}

#[test]
fn validation_sets_the_exit_status() {
    let status = |rows: &str, code: i32, said: &str| {
        let dir = place(&format!("{SMALL}{rows}"));
        seacable(dir.path())
            .args(["validate", "small.toml"])
            .assert()
            .code(code)
            .stdout(contains(said));
    };
    status(&published(4000.0, ""), 0, "1 PASS, 0 FAIL");
    status(&published(400.0, ""), 1, "0 PASS, 1 FAIL");
    let unreachable = published(400.0, "out_of_reach = \"It is another body.\"");
    status(&unreachable, 0, "1 DIFFERS");
    status(&unreachable, 0, "It is another body.");
}

#[test]
fn at_rest_each_quantity_is_shown_once() {
    let dir = place(SMALL);
    seacable(dir.path())
        .args(["run", "small.toml", "--out", "r", "--solver", "static"])
        .assert()
        .success()
        .stdout(contains("tension_n[rope|payload]  "))
        .stdout(contains(".mean").not());
    // The file for other programs has all of them.
    let summary = fs::read_to_string(dir.path().join("r/summary.csv")).unwrap();
    assert!(summary.contains("tension_n[rope|payload].mean,"));
}

#[test]
fn published_values_do_not_judge_an_edited_case() {
    let dir = place(&format!("{SMALL}{}", published(400.0, "")));
    let validate = |set: &[&str]| {
        let mut command = seacable(dir.path());
        command.args(["validate", "small.toml"]);
        for word in set {
            command.args(["--set", word]);
        }
        command.assert()
    };
    validate(&[]).code(1).stdout(contains("1 FAIL"));
    validate(&["payload.wet_mass_kg=500"])
        .success()
        .stdout(contains("0 FAIL, 0 DIFFERS, 1 EDITED"))
        .stdout(contains("payload.wet_mass_kg is yours: 500 kg for"));
    // A published value holds for every well-resolved computation, so another solver is judged by it.
    validate(&["solver.time_step_s=0.01"])
        .code(1)
        .stdout(contains("1 FAIL"));
    seacable(dir.path())
        .args(["validate", "--set", "solver.rho_inf=0.5"])
        .assert()
        .code(2);

    seacable(dir.path())
        .args(["run", "small.toml", "--out", "r"])
        .args(["--set", "payload.wet_mass_kg=500"])
        .assert()
        .success();
    seacable(dir.path())
        .args(["report", "r"])
        .assert()
        .success()
        .stdout(contains("1 EDITED"))
        .stdout(contains(
            "payload.wet_mass_kg: yours; set on top of the file",
        ));
}

/// A report that nobody read to its end is none: the status says so, as it does for a full disk.
#[test]
fn a_reader_that_leaves_is_an_error_in_a_line() {
    let dir = place(SMALL);
    seacable(dir.path())
        .args(["run", "small.toml", "--out", "r"])
        .assert()
        .success();
    let mut child = Process::new(env!("CARGO_BIN_EXE_seacable"))
        .args(["report", "r"])
        .current_dir(dir.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let mut said = String::new();
    child
        .stderr
        .take()
        .unwrap()
        .read_to_string(&mut said)
        .unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(2));
    assert!(
        said.starts_with("error: Writing standard output failed"),
        "{said}"
    );
    assert_eq!(said.lines().count(), 1, "{said}");
}

/// A page a table: the tables in a line each, one with its keys, all of them.
#[test]
fn keys_are_a_page_a_table() {
    let dir = place(SMALL);
    let page = |words: &[&str]| {
        let done = seacable(dir.path()).args(words).assert().success();
        String::from_utf8(done.get_output().stdout.clone()).unwrap()
    };
    for kind in ["case", "system", "section", "ship", "ropeway"] {
        let tables = page(&["keys", "--kind", kind]);
        let all = page(&["keys", "--kind", kind, "--all"]);
        let heads = all.lines().filter(|line| line.starts_with('['));
        let named = tables
            .lines()
            .filter(|line| line.trim_start().starts_with('['));
        assert_eq!(named.clone().count(), heads.count(), "{kind}\n{tables}");
        assert!(
            named.clone().count() + 5 >= tables.lines().count(),
            "{tables}"
        );
        assert!(
            tables.lines().all(|line| line.chars().count() <= 100),
            "{tables}"
        );
        let counts = named.map(|line| {
            let mut words = line.split_whitespace();
            let count = words.find_map(|word| word.parse::<usize>().ok());
            count.unwrap_or_else(|| panic!("{line}"))
        });
        let whole: usize = counts.sum();
        assert!(tables.starts_with(|c: char| c.is_ascii_digit()), "{tables}");
        assert!(tables.contains(&format!("with {whole} keys")), "{tables}");
    }
    let solver = page(&["keys", "--kind", "system", "solver"]);
    assert!(
        solver.starts_with("[solver]") && solver.lines().count() > 20,
        "{solver}"
    );
    let wrong = seacable(dir.path())
        .args(["keys", "solvr"])
        .assert()
        .code(2);
    wrong.stderr(contains("did you mean `solver`?"));
}

#[test]
fn modes_prints_frequencies_and_shapes_and_writes_them() {
    let dir = place(SMALL);
    let words = [
        "modes",
        "small.toml",
        "--count",
        "4",
        "--ascii",
        "-o",
        "modes.csv",
    ];
    let done = seacable(dir.path()).args(words).assert().success();
    let page = String::from_utf8(done.get_output().stdout.clone()).unwrap();
    assert!(page.is_ascii());
    for word in ["frequency [Hz]", "half waves", "Mode shapes along the line"] {
        assert!(page.contains(word), "{word} is missing in\n{page}");
    }
    let csv = fs::read_to_string(dir.path().join("modes.csv")).unwrap();
    let columns: Vec<usize> = csv.lines().map(|line| line.split(',').count()).collect();
    assert!(
        columns.iter().all(|count| *count == 4 + 3 * 4),
        "{columns:?}"
    );
    for words in [["--shape", "99"], ["--count", "0"]] {
        let mut command = seacable(dir.path());
        command.args(["modes", "small.toml"]).args(words);
        command.assert().code(2);
    }
}

/// Everything but the times and the name of the run: errors from companions, and the table of a case with a study.
#[test]
fn the_number_of_threads_changes_no_bit_of_what_is_written() {
    let dir = tempfile::tempdir().unwrap();
    let shipped = |name: &str| {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("cases")
            .join(name)
    };
    let on = |threads: &str, words: &[&str], case: &Path| {
        let mut command = seacable(dir.path());
        command.env("RAYON_NUM_THREADS", threads);
        let out = command.args(words).arg(case).assert().success();
        out.get_output().stdout.clone()
    };
    let run = |threads: &str| {
        let words = ["run", "--set", "solver.duration_s=20", "--out", threads];
        on(threads, &words, &shipped("pendulous/manifold.toml"));
        [
            "history.csv",
            "shapes.csv",
            "profile.csv",
            "summary.csv",
            "errors.csv",
        ]
        .map(|file| fs::read(dir.path().join(threads).join(file)).unwrap())
    };
    assert!(run("1") == run("2"));
    let study = shipped("benchmarks/current_across.toml");
    assert_eq!(
        on("1", &["validate"], &study),
        on("2", &["validate"], &study)
    );
}

#[test]
fn line_types_are_listed_computed_and_written_as_materials() {
    let dir = tempfile::tempdir().unwrap();
    let lines = |args: &[&str]| {
        let mut command = seacable(dir.path());
        command.arg("lines").args(args);
        command.assert()
    };
    let all = contains("chain-r5-stud").and(contains("spiral-strand").and(contains("hmpe")));
    lines(&[]).success().stdout(all);
    let chain = contains("13.57 MN").and(contains("2.74e7 d^2 (44 - 80 d)"));
    lines(&["chain-r4-studless", "120mm"])
        .success()
        .stdout(chain);
    lines(&["chain-r4-studless", "--diameter", "0.12", "--csv"])
        .success()
        .stdout(contains("mass in air,286.56,kg/m,19900 d^2"));
    let table = contains("[materials.mine]").and(contains(
        "break_load_n = 1.357286e7 # 2.74e7 d^2 (44 - 80 d) (IACS UR W22)",
    ));
    lines(&["chain-r4-studless", "120mm", "--toml", "--name", "mine"])
        .success()
        .stdout(table);
    lines(&["spiral-strand", "300mm"])
        .success()
        .stderr(contains("extrapolated"));
    lines(&["chain-r4", "120mm"])
        .code(2)
        .stderr(contains("chain-r4-studless"));
    lines(&["nylon"])
        .code(2)
        .stderr(contains("Give the nominal diameter"));
    lines(&["nylon", "500"])
        .code(2)
        .stderr(contains("such as 120mm"));
}

#[test]
fn line_types_of_a_library_are_listed_and_computed() {
    let dir = tempfile::tempdir().unwrap();
    let text =
        "lineProps:\n  rope: {mass_d2: 700, MBL_d2: 300e6, EA_MBL: 15, density: 1400, Cd: 2.0}\n";
    fs::write(dir.path().join("own.yaml"), text).unwrap();
    let lines = |args: &[&str]| {
        let mut command = seacable(dir.path());
        command.args(["lines", "--library", "own.yaml"]).args(args);
        command.assert()
    };
    lines(&[]).success().stdout(contains("15 times the"));
    lines(&["rope", "100mm", "--csv"])
        .success()
        .stdout(contains("breaking load,3000000,N,3e8 d^2,own.yaml"));
    lines(&["rope", "100mm", "--toml"])
        .success()
        .stdout(contains("[materials.rope-100mm]"));
    lines(&["chain", "100mm"])
        .code(2)
        .stderr(contains("It has rope."));
    fs::write(dir.path().join("own.yaml"), text.replace("700", "soft")).unwrap();
    lines(&[]).code(2).stderr(contains("own.yaml:2:19"));
}

#[test]
fn a_yaml_file_without_a_mooring_says_what_was_looked_for() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("other.yaml"), "name: nothing\n").unwrap();
    for command in ["run", "modes", "import"] {
        let mut program = seacable(dir.path());
        program.args([command, "other.yaml"]);
        let said = contains("other.yaml:1:1").and(contains("IEA ontology"));
        program.assert().code(2).stderr(said);
    }
}

#[test]
fn a_table_of_numbers_is_no_case() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("motion.txt"), "0.0 1.0 2.0\n0.1 1.0 2.0\n").unwrap();
    let mut program = seacable(dir.path());
    program.args(["run", "motion.txt"]);
    let said = contains("motion.txt:1:1").and(contains("a table of numbers"));
    program.assert().code(2).stderr(said);
}
