//! Signals and kills: what a run leaves when it is not let come to its end.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Child, Command as Process, Stdio},
    thread,
    time::{Duration, Instant},
};

use crate::small::SMALL;
use rustix::process::{Pid, Signal, kill_process};
use seacable::run::{RunState, store};

fn place(text: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("small.toml"), text).unwrap();
    dir
}

/// A case that would compute for minutes.
fn endless() -> tempfile::TempDir {
    place(
        &SMALL
            .replace(
                "duration_s = 5.0",
                "duration_s = 50000.0\ntime_step_s = 0.01",
            )
            .replace("interval_s = 0.5", "interval_s = 0.1"),
    )
}

fn spawn(dir: &Path) -> Child {
    Process::new(env!("CARGO_BIN_EXE_seacable"))
        .args(["run", "small.toml"])
        .current_dir(dir)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn signal(child: &Child, signal: Signal) {
    let pid = Pid::from_raw(i32::try_from(child.id()).unwrap()).unwrap();
    kill_process(pid, signal).unwrap();
}

/// Waits until the run has written rows of its history.
fn computing(dir: &Path) -> PathBuf {
    let patience = Instant::now();
    loop {
        let entries = store::list(&dir.join("runs")).unwrap();
        if let Some(entry) = entries.first() {
            let rows = store::read(&entry.dir).map_or(0, |run| run.history.time.len());
            if rows > 3 {
                return entry.dir.clone();
            }
        }
        assert!(
            patience.elapsed() < Duration::from_secs(60),
            "no rows appear"
        );
        thread::sleep(Duration::from_millis(20));
    }
}

/// Whether this program, and so what it starts, ignores SIGHUP, as below `nohup`.
fn hang_up_is_ignored() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (Signal::HUP.as_raw() - 1) & 1 == 1)
}

/// The signals that stop a program which is started from here, with its exit status.
fn stopping() -> Vec<(Signal, i32)> {
    let all = [(Signal::INT, 130), (Signal::TERM, 143), (Signal::HUP, 129)];
    let all = all.into_iter();
    all.filter(|(which, _)| *which != Signal::HUP || !hang_up_is_ignored())
        .collect()
}

/// A program that was started to outlive its terminal goes on.
#[test]
fn a_hang_up_that_is_ignored_stays_ignored() {
    let dir = endless();
    let mut child = Process::new("sh")
        .args(["-c", "trap '' HUP; exec \"$0\" run small.toml"])
        .arg(env!("CARGO_BIN_EXE_seacable"))
        .current_dir(dir.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let run = computing(dir.path());
    let rows = || store::read(&run).map_or(0, |run| run.history.time.len());
    signal(&child, Signal::HUP);
    let (before, patience) = (rows(), Instant::now());
    while rows() <= before + 3 {
        assert!(child.try_wait().unwrap().is_none(), "it ended");
        assert!(patience.elapsed() < Duration::from_secs(60), "no more rows");
        thread::sleep(Duration::from_millis(20));
    }
    signal(&child, Signal::TERM);
    assert_eq!(child.wait().unwrap().code(), Some(143));
}

#[test]
fn signals_stop_a_run_and_keep_what_it_had() {
    for (which, code) in stopping() {
        let dir = endless();
        let mut child = spawn(dir.path());
        let run = computing(dir.path());
        signal(&child, which);
        assert_eq!(child.wait().unwrap().code(), Some(code));
        let run = store::read(&run).unwrap();
        assert_eq!(run.info.state, RunState::Cancelled);
        assert!(run.history.time.len() > 3);
    }
}

#[test]
fn a_kill_at_any_moment_leaves_a_whole_run_or_a_partial_one() {
    let text = SMALL.replace("duration_s = 5.0", "duration_s = 50.0\ntime_step_s = 0.002");
    let dir = place(&text);
    let time = Instant::now();
    assert!(spawn(dir.path()).wait().unwrap().success());
    let whole = time.elapsed();
    fs::remove_dir_all(dir.path().join("runs")).unwrap();

    // Moments spread over the run and a little beyond; the last one is left to end by itself.
    let (mut done, mut partial) = (0, 0);
    for i in 0..24_u32 {
        let mut child = spawn(dir.path());
        if i < 23 {
            thread::sleep(whole * i / 20);
            // It may have ended by itself.
            let _ = child.kill();
        }
        child.wait().unwrap();
        for entry in store::list(&dir.path().join("runs")).unwrap() {
            let run = store::read(&entry.dir).unwrap();
            assert_eq!(run.case_text, text);
            match run.info.state {
                RunState::Done => {
                    done += 1;
                    assert_eq!(run.history.time.len(), 101);
                    assert!(!run.summary.is_empty() && !run.profile().nodes.is_empty());
                    assert!(run.info.warnings.iter().all(|w| !w.contains(".csv")));
                }
                RunState::Partial => {
                    partial += 1;
                    assert!(run.info.warnings.iter().any(|w| w.contains("partial")));
                }
                other => panic!("{other:?}"),
            }
        }
        let _ = fs::remove_dir_all(dir.path().join("runs"));
    }
    assert!(done > 0 && partial > 0, "{done} whole, {partial} partial");
}

/// Stopped before its first step, in the trial by which `auto` chooses, on its way or among its companions: resumed, it gives
/// the bytes of a run that was never stopped.
#[test]
fn a_run_stopped_at_any_moment_resumes_to_the_same_results() {
    let small = SMALL.replace(
        "duration_s = 5.0",
        "duration_s = 100.0\ntime_step_s = 0.002",
    );
    for text in [
        small.clone(),
        small.replace(
            "time_step_s = 0.002",
            "step_tolerance = 1e-9\nmethod = \"auto\"",
        ),
    ] {
        let dir = place(&text);
        let run = |more: &[&str]| {
            let mut process = Process::new(env!("CARGO_BIN_EXE_seacable"));
            process.arg("run").args(more).current_dir(dir.path());
            process.stdout(Stdio::null()).stderr(Stdio::null());
            process.spawn().unwrap()
        };
        let read = |run: &str| {
            let file = |name: &&str| fs::read(dir.path().join(run).join(name)).unwrap();
            ["summary.csv", "errors.csv", "history.csv", "profile.csv"].map(|name| file(&name))
        };
        let time = Instant::now();
        assert!(
            run(&["small.toml", "--out", "whole"])
                .wait()
                .unwrap()
                .success()
        );
        let mut whole = time.elapsed();
        let mut stopped = 0;
        // Twelve moments spread over the run; more of them where it was slower or faster than the first, under load.
        for i in 0..72_u32 {
            if i >= 12 && stopped > 6 {
                break;
            }
            let (first, second) = (format!("first-{i}"), format!("second-{i}"));
            let mut child = run(&["small.toml", "--out", &first]);
            thread::sleep(whole * (i % 12) / 12 + whole * (i / 12) / 72);
            let signals = stopping();
            signal(&child, signals[i as usize % signals.len()].0);
            child.wait().unwrap();
            // Signalled before it listened it leaves nothing, and at its end the whole run.
            let state = store::read(&dir.path().join(&first)).map(|run| run.info.state);
            if state.as_ref().is_ok_and(|state| *state == RunState::Done) {
                whole = whole * 9 / 10;
            }
            if state.is_ok_and(|state| state == RunState::Cancelled) {
                let resumed = run(&["--resume", &first, "--out", &second]).wait();
                assert!(resumed.unwrap().success(), "{i}");
                assert!(read(&second) == read("whole"), "stopped at moment {i}");
                stopped += 1;
            }
        }
        assert!(stopped > 6, "{stopped} stopped");
    }
}

/// Whether a program catches a signal.
#[cfg(target_os = "linux")]
fn catches(child: &Child, signal: Signal) -> bool {
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal.as_raw() - 1) & 1 == 1)
}

/// Signals are caught before the case is read, which takes a while here: a stop that early leaves nothing, or a run that can be finished.
#[cfg(target_os = "linux")]
#[test]
fn a_signal_while_the_case_is_read_leaves_nothing_or_a_run_that_can_be_finished() {
    let moved = "kind = \"moving\"\nposition_m = [0.0, 0.0, -10.0]\nmotion = \"table\"\nmotion_file = \"p.csv\"\nmotion_interpolation = \"linear\"";
    let text = SMALL.replace("kind = \"fixed\"\nposition_m = [0.0, 0.0, -10.0]", moved);
    let dir = place(&text.replace("shape = \"straight\"\nelevation_deg = -30.0", ""));
    let row = |i: u32| format!("{},{},0,0\n", f64::from(i) / 1000.0, i % 2);
    let rows: String = (0..200_000).map(row).collect();
    fs::write(
        dir.path().join("p.csv"),
        format!("time_s,x_m,y_m,z_m\n{rows}"),
    )
    .unwrap();
    let runs = || store::list(&dir.path().join("runs")).unwrap();
    let listening = |child: &Child| {
        let begun = Instant::now();
        while !catches(child, Signal::TERM) {
            assert!(begun.elapsed() < Duration::from_secs(60));
            thread::sleep(Duration::from_micros(200));
        }
        begun.elapsed()
    };
    // It listens long before it has read the case.
    let mut child = spawn(dir.path());
    let listens = listening(&child);
    let begun = Instant::now();
    while runs().is_empty() && begun.elapsed() < Duration::from_secs(60) {
        thread::sleep(Duration::from_micros(200));
    }
    let reads = begun.elapsed();
    assert!(reads > Duration::from_millis(20), "{listens:?}, {reads:?}");
    child.kill().unwrap();
    child.wait().unwrap();
    fs::remove_dir_all(dir.path().join("runs")).unwrap();

    let mut child = spawn(dir.path());
    listening(&child);
    signal(&child, Signal::TERM);
    assert_eq!(child.wait().unwrap().code(), Some(143));
    let stopped = runs();
    if stopped.is_empty() {
        return;
    }
    let info = stopped[0].info.as_ref().unwrap();
    let is_stopped = [RunState::Cancelled, RunState::Partial].contains(&info.state);
    assert!(is_stopped, "{:?}", info.state);
    let mut resume = Process::new(env!("CARGO_BIN_EXE_seacable"));
    resume.args(["run", "--resume"]).arg(&stopped[0].dir);
    resume.current_dir(dir.path()).stdout(Stdio::null());
    assert!(resume.status().unwrap().success());
}
