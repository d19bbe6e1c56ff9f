//! Faults of a disk at every operation in turn: full, denied, broken, and writes that take only a part, each once and from there on. No
//! command panics or says that all is well where it is not; a run is readable, and finished to the same bytes once the disk is well again;
//! an old file is whole or wholly replaced; nothing is left beside it.
//!
//! Every operation of every command: `SEACABLE_FAULTS=1000000 cargo test --test program faults -- --nocapture`; otherwise a sample of
//! them, which `SEACABLE_SEED` draws. The program has the faults built in only with debug assertions.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use seacable::run::{RunState, store};

use crate::chance::{Chance, asked, seed};
#[cfg(target_os = "linux")]
use crate::pty::Start;
use crate::small::SMALL;

/// What a fault is called, and what the system says.
const FAULTS: [(&str, &str); 4] = [
    ("full", "No space left on device"),
    ("denied", "Permission denied"),
    ("broken", "Input/output error"),
    ("part", ""),
];

/// A command that changes the disk, in a directory where all is ready for it.
struct Scene {
    words: &'static [&'static str],
    /// Makes what it needs.
    ready: fn(&Path),
    /// Looks at what it left, and whether it said that all is well.
    check: fn(&Path, bool, &str),
}

fn seacable(dir: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.args(words).current_dir(dir);
    command
}

fn succeeds(dir: &Path, words: &[&str]) {
    let output = seacable(dir, words).output().unwrap();
    assert!(output.status.success(), "{words:?}: {output:?}");
}

fn with_case(dir: &Path) {
    fs::write(dir.join("small.toml"), SMALL).unwrap();
}

fn with_run(dir: &Path) {
    with_case(dir);
    succeeds(dir, &["run", "small.toml", "--out", "run"]);
}

/// A run that a full disk ended.
fn with_failed_run(dir: &Path) {
    with_case(dir);
    let words = ["run", "small.toml", "--out", "run"];
    let log = dir.join("log");
    let mut command = seacable(dir, &words);
    assert!(
        command
            .env("SEACABLE_FAULT_LOG", &log)
            .status()
            .unwrap()
            .success()
    );
    // The first of the last files.
    let log = fs::read_to_string(log).unwrap();
    let number = log.lines().filter(|line| line.contains("summary.csv"));
    let number = number.map(|line| line.split(' ').next().unwrap()).next();
    fs::remove_dir_all(dir.join("run")).unwrap();
    let fault = format!("{}+:full", number.unwrap());
    let mut command = seacable(dir, &words);
    assert!(
        !command
            .env("SEACABLE_FAULT", fault)
            .status()
            .unwrap()
            .success()
    );
}

fn with_old_page(dir: &Path) {
    with_run(dir);
    fs::write(dir.join("page.txt"), "old").unwrap();
}

/// The results of a run, which do not depend on when it was stopped.
fn results(dir: &Path) -> Vec<Vec<u8>> {
    ["summary.csv", "history.csv", "shapes.csv", "profile.csv"]
        .map(|name| fs::read(dir.join(name)).unwrap())
        .into()
}

fn whole(dir: &Path) -> Vec<Vec<u8>> {
    let place = dir.join("reference");
    if !place.exists() {
        succeeds(dir, &["run", "small.toml", "--out", "reference"]);
    }
    results(&place)
}

/// A run that the command was to write: absent, or readable and finished from what it has.
fn run_is_sound(dir: &Path, name: &str, well: bool, said: &str) {
    let at = dir.join(name);
    if !at.exists() {
        assert!(!well, "no run: {said}");
        return;
    }
    let run = store::read(&at).unwrap();
    if well || run.info.state == RunState::Done {
        assert_eq!(run.info.state, RunState::Done, "{said}");
        assert!(results(&at) == whole(dir), "{said}");
        return;
    }
    let checkpoint = at.join("checkpoint.toml");
    if checkpoint.exists() {
        succeeds(dir, &["run", "--resume", name, "--out", "end"]);
        assert!(results(&dir.join("end")) == whole(dir), "{said}");
    }
}

fn page_is_old_or_new(dir: &Path, well: bool, said: &str) {
    let page = fs::read_to_string(dir.join("page.txt")).unwrap();
    succeeds(dir, &["report", "run", "--output", "again.txt"]);
    let new = fs::read_to_string(dir.join("again.txt")).unwrap();
    assert!(page == new || (!well && page == "old"), "{said}");
    fs::remove_file(dir.join("again.txt")).unwrap();
}

fn varied_runs_are_sound(dir: &Path, well: bool, said: &str) {
    let listed = store::list(&dir.join("runs")).unwrap_or_default();
    let states: Vec<_> = listed
        .into_iter()
        .map(|run| run.info.unwrap().state)
        .collect();
    if well {
        assert_eq!(states, [RunState::Done; 2], "{said}");
    }
    let table = fs::read_to_string(dir.join("table.csv"));
    assert!(!well || table.is_ok(), "{said}");
    assert!(table.is_err() || table.unwrap().lines().count() == 3);
}

const SCENES: [Scene; 6] = [
    Scene {
        words: &["run", "small.toml", "--out", "run"],
        ready: with_case,
        check: |dir, well, said| run_is_sound(dir, "run", well, said),
    },
    Scene {
        words: &["run", "--resume", "run", "--out", "next"],
        ready: with_failed_run,
        check: |dir, well, said| {
            run_is_sound(dir, "next", well, said);
            let _ = fs::remove_dir_all(dir.join("end"));
            run_is_sound(dir, "run", false, said);
        },
    },
    Scene {
        words: &["run", "small.toml"],
        ready: with_case,
        check: |dir, well, said| {
            let listed = store::list(&dir.join("runs")).unwrap_or_default();
            assert!(!well || listed.len() == 1, "{said}");
            for run in listed {
                let name = run.dir.strip_prefix(dir).unwrap();
                run_is_sound(dir, name.to_str().unwrap(), well, said);
            }
        },
    },
    Scene {
        words: &["report", "run", "--output", "page.txt", "--force"],
        ready: with_old_page,
        check: page_is_old_or_new,
    },
    Scene {
        words: &[
            "study",
            "vary",
            "small.toml",
            "--vary",
            "payload.drag_area_m2=1,2",
            "--output",
            "table.csv",
            "--csv",
        ],
        ready: with_case,
        check: varied_runs_are_sound,
    },
    Scene {
        words: &[
            "sweep",
            "small.toml",
            "--vary",
            "payload.drag_area_m2=1,2",
            "--out",
            "sweep",
            "--csv",
        ],
        ready: with_case,
        check: sweep_goes_on,
    },
];

/// A sweep that a fault ended goes on to its end, if its folder is there; one that said that all is well has its table.
fn sweep_goes_on(dir: &Path, well: bool, said: &str) {
    let folder = dir.join("sweep");
    let results = folder.join("results.csv");
    assert!(!well || results.exists(), "{said}");
    assert!(
        !folder.exists() || folder.join("sweep.toml").exists(),
        "{said}"
    );
    if folder.exists() {
        succeeds(dir, &["sweep", "--resume", "sweep"]);
        let table = fs::read_to_string(results).unwrap();
        assert_eq!(table.matches(",OK,").count(), 2, "{said}: {table}");
    }
}

/// The names of hidden files below a directory.
fn hidden(dir: &Path, found: &mut Vec<String>) {
    for item in fs::read_dir(dir).unwrap().flatten() {
        if item.file_name().to_string_lossy().starts_with('.') {
            found.push(item.path().display().to_string());
        }
        if item.file_type().unwrap().is_dir() {
            hidden(&item.path(), found);
        }
    }
}

/// A copy of a directory.
fn copied(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for item in fs::read_dir(from).unwrap().flatten() {
        let to = to.join(item.file_name());
        if item.file_type().unwrap().is_dir() {
            copied(&item.path(), &to);
        } else {
            fs::copy(item.path(), to).unwrap();
        }
    }
}

/// Runs a command with a fault at an operation.
fn with_fault(dir: &Path, words: &[&str], fault: &str) -> Output {
    let mut command = seacable(dir, words);
    command.env("SEACABLE_FAULT", fault);
    command.env("RAYON_NUM_THREADS", "1");
    command.output().unwrap()
}

#[test]
fn a_fault_at_any_operation_is_survived() {
    if !cfg!(debug_assertions) {
        eprintln!("not tested: the program has no faults built in");
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let mut tried = Vec::new();
    for (number, scene) in SCENES.iter().enumerate() {
        let ready = place.path().join(format!("ready-{number}"));
        fs::create_dir(&ready).unwrap();
        (scene.ready)(&ready);
        // How many operations there are.
        let dir = place.path().join(format!("count-{number}"));
        copied(&ready, &dir);
        let mut command = seacable(&dir, scene.words);
        command.env("RAYON_NUM_THREADS", "1");
        let log = place.path().join(format!("log-{number}"));
        let output = command.env("SEACABLE_FAULT_LOG", &log).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        let log = fs::read_to_string(log).unwrap();
        eprintln!(
            "{}: {} operations",
            scene.words.join(" "),
            log.lines().count()
        );
        for (at, line) in log.lines().enumerate() {
            for fault in &FAULTS {
                for goes_on in ["", "+"] {
                    let what = line.split(' ').nth(1).unwrap().to_owned();
                    let named = format!("{}{goes_on}:{}", at + 1, fault.0);
                    tried.push((number, named, what, fault.1));
                }
            }
        }
    }
    let mut chance = Chance::new(seed());
    let wanted = asked("SEACABLE_FAULTS", 40);
    let (mut well_ones, mut count) = (0, 0);
    let all = tried.len();
    while count < wanted && !tried.is_empty() {
        let (number, fault, what, reason) = tried.swap_remove(chance.below(tried.len()));
        // A part is taken of writes only.
        if reason.is_empty() && what != "Write" {
            continue;
        }
        let scene = &SCENES[number];
        let dir = place.path().join("tried");
        copied(&place.path().join(format!("ready-{number}")), &dir);
        let output = with_fault(&dir, scene.words, &fault);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let told = format!("{} with {fault} ({what}): {said}", scene.words.join(" "));
        let well = output.status.success();
        assert!(matches!(output.status.code(), Some(0..=2)), "{told}");
        assert!(!said.contains("panicked"), "{told}");
        let page = String::from_utf8_lossy(&output.stdout);
        assert!(
            well || said.contains(reason) || page.contains(reason),
            "{told}"
        );
        // Nothing else goes wrong where writes take a part.
        assert!(well || !reason.is_empty(), "{told}");
        (scene.check)(&dir, well, &told);
        let mut left = Vec::new();
        hidden(&dir, &mut left);
        // What a disk that removes nothing any more keeps is removed by a later command.
        assert!(left.is_empty() || fault.contains('+'), "{told}: {left:?}");
        well_ones += usize::from(well);
        count += 1;
        fs::remove_dir_all(&dir).unwrap();
    }
    eprintln!("{count} of {all} faults tried, {well_ones} of them without harm");
}

/// Of four points whose first cannot be stored the others are not computed.
#[test]
fn a_study_ends_at_the_first_run_that_cannot_be_stored() {
    if !cfg!(debug_assertions) {
        eprintln!("not tested: the program has no faults built in");
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let words = [
        "study",
        "vary",
        "small.toml",
        "--vary",
        "payload.drag_area_m2=1,2,3,4",
    ];
    let dir = place.path().join("whole");
    fs::create_dir(&dir).unwrap();
    with_case(&dir);
    let log = place.path().join("log");
    let mut command = seacable(&dir, &words);
    command.env("RAYON_NUM_THREADS", "1");
    command.env("SEACABLE_FAULT_LOG", &log);
    assert!(command.status().unwrap().success());
    assert_eq!(store::list(&dir.join("runs")).unwrap().len(), 4);
    let log = fs::read_to_string(log).unwrap();
    let write = log
        .lines()
        .find(|line| line.contains("Write") && line.ends_with("history.csv"));
    let number = write.unwrap().split(' ').next().unwrap();
    let dir = place.path().join("tried");
    fs::create_dir(&dir).unwrap();
    with_case(&dir);
    let output = with_fault(&dir, &words, &format!("{number}:broken"));
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let page = String::from_utf8_lossy(&output.stdout);
    assert!(page.contains("its run cannot be stored"), "{page}");
    // A run of less than a second is there whole or not at all.
    assert_eq!(store::list(&dir.join("runs")).unwrap().len(), 0, "{page}");
}

/// The workbench shows the run, and its last word is that it is not stored.
#[cfg(target_os = "linux")]
#[test]
fn a_run_of_the_workbench_that_cannot_be_stored_says_so_last() {
    if !cfg!(debug_assertions) {
        eprintln!("not tested: the program has no faults built in");
        return;
    }
    let run_until = |variable: &str, value: &str, words: &str| {
        let dir = tempfile::tempdir().unwrap();
        with_case(dir.path());
        let mut pty = Start {
            args: &["--in-process", "small.toml"],
            vars: &[("LANG", "C.UTF-8"), (variable, value)],
            ..Start::default()
        }
        .go_in(dir);
        pty.wait("the case", |screen| screen.contents().contains("Inputs"));
        pty.send("R");
        pty.wait(words, |screen| screen.contents().contains(words));
        pty
    };
    let place = tempfile::tempdir().unwrap();
    let log = place.path().join("log");
    run_until("SEACABLE_FAULT_LOG", log.to_str().unwrap(), "is done");
    let log = fs::read_to_string(log).unwrap();
    let row = |line: &&str| line.contains("Write") && line.ends_with("history.csv");
    let number = log.lines().find(row).unwrap().split(' ').next().unwrap();
    let pty = run_until(
        "SEACABLE_FAULT",
        &format!("{number}:broken"),
        "but not stored",
    );
    let runs = store::list(&pty.dir.path().join("runs")).unwrap();
    assert_eq!(runs[0].info.as_ref().unwrap().state, RunState::Failed);
}

#[test]
fn a_wrong_clock_spoils_no_run() {
    if !cfg!(debug_assertions) {
        eprintln!("not tested: the program has no clock built in");
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let dir = place.path();
    with_case(dir);
    let clocks = [
        "0",
        "-86400",
        "-9000000000000000",
        "9000000000000000",
        "1790000000,-3600",
        "1790000000,100000000",
    ];
    for clock in clocks {
        // Two runs whose stamps are the same, or come in the wrong order.
        for _ in 0..2 {
            let mut command = seacable(dir, &["run", "small.toml"]);
            let output = command.env("SEACABLE_CLOCK", clock).output().unwrap();
            assert!(output.status.success(), "{clock}: {output:?}");
        }
        let listed = store::list(&dir.join("runs")).unwrap();
        assert_eq!(listed.len(), 2, "{clock}");
        for run in listed {
            assert_eq!(run.info.unwrap().state, RunState::Done, "{clock}");
            let name = run.dir.strip_prefix(dir).unwrap();
            run_is_sound(dir, name.to_str().unwrap(), true, clock);
            succeeds(dir, &["report", name.to_str().unwrap()]);
        }
        fs::remove_dir_all(dir.join("runs")).unwrap();
    }
}
