//! SIGKILL at random moments: of runs, studies, reports and deletions. Every run is readable and can be finished, to the bytes of a run that
//! was never killed; no file is half written, and none is lost.
//!
//! `SEACABLE_KILLS=500 cargo test --test program kills -- --nocapture` makes that many, `SEACABLE_SEED` sets others.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use seacable::run::{RunState, store};

use crate::chance::{Chance, asked, seed};
use crate::small::SMALL;

/// Cases, and how long their runs are, of lines and of a system; the second searches an accuracy.
const CASES: [(&str, &str, &[&str]); 4] = [
    ("small.toml", SMALL, &["solver.duration_s=40"]),
    (
        "search.toml",
        SMALL,
        &["solver.duration_s=4", "solver.accuracy=0.01"],
    ),
    (
        "stick_slip.toml",
        include_str!("../../cases/hard/stick_slip.toml"),
        &[],
    ),
    (
        "bridle.toml",
        include_str!("../../cases/systems/bridle_in_heave.toml"),
        &["solver.duration_s=6", "lines.left.segments=12"],
    ),
];

/// The files of a run that its end writes, in their order, before `run.toml`; their bytes do not depend on when it was stopped.
pub(crate) const RESULTS: [&str; 7] = [
    "case.toml",
    "summary.csv",
    "errors.csv",
    "channels.csv",
    "history.csv",
    "profile.csv",
    "shapes.csv",
];

fn seacable(dir: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.args(words).current_dir(dir);
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Runs to the end, and how long that took.
fn ended(command: &mut Command) -> Duration {
    let begun = Instant::now();
    let status = command.status().unwrap();
    assert!(status.success(), "{command:?}: {status}");
    begun.elapsed()
}

/// Kills a program at a moment of the time that it takes.
fn kill(mut child: Child, whole: Duration, chance: &mut Chance) {
    // A fifth of them early.
    let share = if chance.below(5) == 0 { 0.1 } else { 1.05 };
    thread::sleep(whole.mul_f64(share * chance.share()));
    // It may have ended by itself.
    let _ = child.kill();
    child.wait().unwrap();
}

fn run_words<'a>(file: &'a str, keys: &[&'a str], out: &'a str) -> Vec<&'a str> {
    let set = keys.iter().flat_map(|key| ["--set", key]);
    ["run", file, "--out", out].into_iter().chain(set).collect()
}

/// The files of a run that do not depend on when it was stopped.
fn files(dir: &Path) -> BTreeMap<&'static str, Option<Vec<u8>>> {
    let same = RESULTS.into_iter().chain(["checkpoint.toml"]);
    same.map(|name| (name, fs::read(dir.join(name)).ok()))
        .collect()
}

fn assert_same(what: &str, expected: &Path, found: &Path) {
    let (expected, found) = (files(expected), files(found));
    for (name, bytes) in expected {
        assert!(found[name] == bytes, "{what}: {name} differs");
    }
}

/// Resumes a run until it is done, and may be killed on its way again. Returns where it was done.
fn finished(dir: &Path, first: &str, whole: Duration, chance: &mut Chance) -> String {
    let mut at = first.to_owned();
    for hop in 0..4 {
        let info = store::read(&dir.join(&at)).unwrap().info;
        if info.state == RunState::Done {
            return at;
        }
        let next = format!("{first}-{hop}");
        let mut command = seacable(dir, &["run", "--resume", &at, "--out", &next]);
        if hop < 3 && chance.below(3) == 0 {
            kill(command.spawn().unwrap(), whole, chance);
            if dir.join(&next).exists() {
                at = next;
            }
        } else {
            ended(&mut command);
            return next;
        }
    }
    let next = format!("{first}-last");
    ended(&mut seacable(
        dir,
        &["run", "--resume", &at, "--out", &next],
    ));
    next
}

#[test]
fn a_killed_run_can_be_finished_to_the_same_bytes() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path();
    let mut chance = Chance::new(seed());
    let mut wholes = Vec::new();
    for (number, (file, text, keys)) in CASES.iter().enumerate() {
        fs::write(dir.join(file), text).unwrap();
        let out = format!("whole-{number}");
        wholes.push(ended(&mut seacable(dir, &run_words(file, keys, &out))));
    }
    let (mut killed, mut none) = (0, 0);
    for number in 0..asked("SEACABLE_KILLS", 8) {
        let case = number % CASES.len();
        let (file, _, keys) = CASES[case];
        let name = format!("run-{number}");
        let child = seacable(dir, &run_words(file, keys, &name))
            .spawn()
            .unwrap();
        kill(child, wholes[case], &mut chance);
        if !dir.join(&name).exists() {
            none += 1;
            continue;
        }
        killed += 1;
        let last = finished(dir, &name, wholes[case], &mut chance);
        // Also of a search, whose time is not over: what it tries does not depend on how long that takes.
        assert_same(&name, &dir.join(format!("whole-{case}")), &dir.join(&last));
        for item in fs::read_dir(dir).unwrap().flatten() {
            let of = item.file_name().into_string().unwrap();
            if of.starts_with("run-") {
                fs::remove_dir_all(item.path()).unwrap();
            }
        }
    }
    eprintln!(
        "{killed} killed under way or at the end, all the same at their ends, {none} before they began"
    );
    assert!(killed > 0);
}

/// The runs below `runs`.
fn runs(dir: &Path) -> Vec<PathBuf> {
    let listed = store::list(&dir.join("runs")).unwrap();
    let all = listed.into_iter().map(|run| {
        run.info.unwrap();
        run.dir
    });
    all.collect()
}

#[test]
fn a_killed_study_goes_on_with_the_same_bits() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path();
    fs::write(dir.join("small.toml"), SMALL).unwrap();
    let words = [
        "study",
        "vary",
        "small.toml",
        "--vary",
        "payload.drag_area_m2=1,2,3,4",
        "--set",
        "solver.duration_s=20",
        "--out",
        "study",
        "--output",
        "table.csv",
        "--csv",
        "--force",
    ];
    let whole = ended(&mut seacable(dir, &words));
    let table = fs::read_to_string(dir.join("table.csv")).unwrap();
    let results = fs::read(dir.join("study/results.csv")).unwrap();
    let mut chance = Chance::new(seed());
    let mut continued = 0;
    for _ in 0..asked("SEACABLE_KILLS", 8).div_ceil(4) {
        for item in fs::read_dir(dir).unwrap() {
            let path = item.unwrap().path();
            if path.is_dir() {
                fs::remove_dir_all(path).unwrap();
            }
        }
        kill(seacable(dir, &words).spawn().unwrap(), whole, &mut chance);
        // CPU times in it may differ in length.
        let found = fs::read_to_string(dir.join("table.csv")).unwrap();
        assert!(found.ends_with('\n') && found.lines().count() == table.lines().count());
        if dir.join("study/sweep.toml").exists() {
            ended(&mut seacable(dir, &["study", "vary", "--resume", "study"]));
            assert_eq!(fs::read(dir.join("study/results.csv")).unwrap(), results);
            continued += 1;
        }
    }
    eprintln!("{continued} killed studies went on");
}

#[test]
fn a_killed_report_leaves_the_old_file_or_the_new_one() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path();
    fs::write(dir.join("small.toml"), SMALL).unwrap();
    ended(&mut seacable(dir, &["run", "small.toml", "--out", "run"]));
    let words = ["report", "run", "--output", "page.txt", "--force"];
    let whole = ended(&mut seacable(dir, &words));
    let page = fs::read_to_string(dir.join("page.txt")).unwrap();
    let old = "x".repeat(page.len() + 1);
    let mut chance = Chance::new(seed());
    let (mut before, mut after) = (0, 0);
    for _ in 0..asked("SEACABLE_KILLS", 8) {
        fs::write(dir.join("page.txt"), &old).unwrap();
        kill(seacable(dir, &words).spawn().unwrap(), whole, &mut chance);
        let found = fs::read_to_string(dir.join("page.txt")).unwrap();
        assert!(found == old || found == page);
        if found == old {
            before += 1;
        } else {
            after += 1;
        }
    }
    eprintln!("{before} times the old page, {after} times the new one");
}

/// Deletes the runs of the folder that the test below names: in a process of its own, to be killed.
#[test]
#[ignore = "a part of the test below"]
fn deletes_runs() {
    if let Ok(dir) = std::env::var("SEACABLE_DELETES") {
        for run in runs(Path::new(&dir)) {
            store::delete(&run).unwrap();
        }
    }
}

#[test]
fn a_killed_deletion_leaves_whole_runs() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path();
    fs::write(dir.join("small.toml"), SMALL).unwrap();
    ended(&mut seacable(dir, &["run", "small.toml", "--out", "run"]));
    let original = store::read(&dir.join("run")).unwrap();
    let names: Vec<_> = fs::read_dir(dir.join("run")).unwrap().collect();
    let delete = || {
        let mut command = Command::new(std::env::current_exe().unwrap());
        command.args(["--exact", "kills::deletes_runs", "--ignored"]);
        command.env("SEACABLE_DELETES", dir);
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command
    };
    let copies = || {
        let _ = fs::remove_dir_all(dir.join("runs"));
        for copy in 0..30 {
            let to = dir.join(format!("runs/run-{copy}"));
            fs::create_dir_all(&to).unwrap();
            for item in fs::read_dir(dir.join("run")).unwrap().flatten() {
                fs::copy(item.path(), to.join(item.file_name())).unwrap();
            }
        }
    };
    copies();
    let whole = ended(&mut delete());
    assert!(runs(dir).is_empty());
    let mut chance = Chance::new(seed());
    let mut left = 0;
    for _ in 0..asked("SEACABLE_KILLS", 8) {
        copies();
        kill(delete().spawn().unwrap(), whole, &mut chance);
        for run in runs(dir) {
            assert_eq!(fs::read_dir(&run).unwrap().count(), names.len());
            assert!(store::read(&run).unwrap().summary == original.summary);
            left += 1;
        }
    }
    eprintln!("{left} runs left whole");
}
