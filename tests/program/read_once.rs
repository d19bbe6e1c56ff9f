//! What a command reads, parses, builds and solves: each file and each table once, a system once a mesh, an answer where it is asked for.
//!
//! The program names these tasks in a log only with debug assertions.

#![cfg(debug_assertions)]

use std::fs;
use std::path::Path;
use std::process::Command;

/// A floating platform in waves by three files of coefficients, and the same lines under one at rest.
const IN_WAVES: &str = "cases/systems/volturnus_in_waves.toml";
const AT_REST: &str = "cases/systems/volturnus.toml";
const COEFFICIENTS: [&str; 3] = ["semi.1", "semi.3", "semi.12d"];

/// What a command did.
struct Log(String);

impl Log {
    /// Of a command that ends well, in the directory of the project.
    fn of(words: &[&str]) -> Self {
        let dir = tempfile::tempdir().unwrap();
        let log = dir.path().join("log");
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        command.args(words).current_dir(env!("CARGO_MANIFEST_DIR"));
        let output = command.env("SEACABLE_WORK_LOG", &log).output().unwrap();
        assert!(output.status.success(), "{words:?}: {output:?}");
        Self(fs::read_to_string(log).unwrap())
    }

    /// How often a task was done, of what ends so.
    fn count(&self, task: &str, of: &str) -> usize {
        let lines = self.0.lines().filter_map(|line| line.split_once(' '));
        lines
            .filter(|(done, what)| *done == task && what.ends_with(of))
            .count()
    }

    /// Builds, searches for an equilibrium, answers of files.
    fn computed(&self) -> [usize; 3] {
        ["build", "rest", "solve"].map(|task| self.count(task, ""))
    }
}

fn run(more: &[&str]) -> (tempfile::TempDir, Log) {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("run").display().to_string();
    let short = ["--set", "solver.duration_s=1", "--out", &out];
    let log = Log::of(&[&["run", IN_WAVES], &short[..], more].concat());
    (dir, log)
}

/// Built three times: on the mesh of the file, and on those of half and of a quarter of the segments, which its errors are told by.
#[test]
fn a_run_of_a_floating_platform_reads_and_parses_once_and_builds_once_a_mesh() {
    let (_dir, log) = run(&[]);
    assert_eq!(log.count("read", IN_WAVES), 1, "{}", log.0);
    for file in COEFFICIENTS {
        assert_eq!(log.count("read", file), 1, "{}", log.0);
        assert_eq!(log.count("parse", file), 1, "{}", log.0);
    }
    assert_eq!(log.computed(), [3, 1, 1], "{}", log.0);
    let (_dir, single) = run(&["--set", "solver.error_estimate=false"]);
    assert_eq!(single.computed(), [1, 1, 1], "{}", single.0);
}

#[test]
fn a_system_at_rest_is_built_and_solved_once_with_keys_set_or_not() {
    let set = ["--set", "environment.gravity_m_per_s2=9.8"];
    for more in [&[][..], &set] {
        let log = Log::of(&[&["run", AT_REST], more].concat());
        assert_eq!(log.count("read", AT_REST), 1, "{}", log.0);
        assert_eq!(log.computed(), [1, 1, 1], "{}", log.0);
    }
}

#[test]
fn an_import_computes_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let foreign = dir.path().join("lines.dat").display().to_string();
    Log::of(&["export", AT_REST, "--moordyn", "-o", &foreign]);
    let log = Log::of(&["import", &foreign]);
    assert_eq!(log.count("read", &foreign), 1, "{}", log.0);
    assert_eq!(log.computed(), [0, 0, 0], "{}", log.0);
}

#[test]
fn the_report_of_a_run_solves_its_system_once() {
    let (dir, _) = run(&[]);
    let run = dir.path().join("run").display().to_string();
    for format in ["text", "json"] {
        let log = Log::of(&["report", &run, "--format", format]);
        assert_eq!(log.computed(), [1, 1, 1], "{}", log.0);
        for file in COEFFICIENTS {
            assert_eq!(log.count("parse", file), 1, "{}", log.0);
        }
    }
}

/// The file as it is, then each of two points; all with the tables that were parsed of the file.
#[test]
fn points_of_a_study_share_the_tables_of_their_file() {
    let dir = tempfile::tempdir().unwrap();
    let case = dir.path().join("platform.toml");
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(IN_WAVES)).unwrap();
    let (text, _) = text.split_once("[[load_cases]]").unwrap();
    fs::write(&case, text.replace("volturnus_data/", "")).unwrap();
    for file in COEFFICIENTS {
        let from = format!(
            "{}/cases/systems/volturnus_data/{file}",
            env!("CARGO_MANIFEST_DIR")
        );
        fs::copy(from, dir.path().join(file)).unwrap();
    }
    let case = case.display().to_string();
    let words = [
        "study",
        "vary",
        &case,
        "--no-store",
        "--set",
        "solver.duration_s=1",
    ];
    let varied = ["--vary", "bodies.platform.mass_kg=2.0093e7,2.01e7"];
    let log = Log::of(&[&words[..], &varied].concat());
    assert_eq!(log.count("read", &case), 1, "{}", log.0);
    for file in COEFFICIENTS {
        assert_eq!(log.count("parse", file), 1, "{}", log.0);
    }
    assert_eq!(log.count("solve", ""), 3, "{}", log.0);
}

#[test]
fn other_kinds_are_read_and_solved_once() {
    let section = "cases/umbilical/section.toml";
    let ropeway = "cases/ropeway/constant_tension.toml";
    let ship = "cases/ship/anchored.toml";
    let set = ["--set", "cargo.mass_kg=49"];
    for (command, file, set) in [
        ("section", section, &[][..]),
        ("ropeway", ropeway, &[]),
        ("ropeway", ropeway, &set),
        ("ship", ship, &[]),
    ] {
        let log = Log::of(&[&[command, file], set].concat());
        assert_eq!(log.count("read", file), 1, "{}", log.0);
        // The ship's ropeway is a file of its own.
        let others = usize::from(command == "ship");
        assert_eq!(log.count("solve", ""), 1 + others, "{}", log.0);
    }
}
