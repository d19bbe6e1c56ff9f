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

#[test]
fn signals_stop_a_run_and_keep_what_it_had() {
    for (which, code) in [(Signal::INT, 130), (Signal::TERM, 143)] {
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
                    assert!(!run.summary.is_empty() && !run.profile.nodes.is_empty());
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
