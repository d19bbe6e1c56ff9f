//! A disk that fills up while a run is computed: the run ends with the reason, and keeps a checkpoint from which it is finished elsewhere.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use seacable::run::{RunState, store};

use crate::small::SMALL;

/// Runs a shell script in a mount namespace with a small file system at `disk`.
fn on_small_disk(dir: &Path, kilobytes: usize, script: &str) -> Output {
    fs::create_dir_all(dir.join("disk")).unwrap();
    let script = format!("mount -t tmpfs -o size={kilobytes}k none disk || exit 77\n{script}");
    let mut command = Command::new("unshare");
    command.args(["-rm", "sh", "-c", &script]);
    command.env("SEACABLE", env!("CARGO_BIN_EXE_seacable"));
    command.current_dir(dir).output().unwrap()
}

/// Whether this machine lets a test mount anything.
fn can_mount(dir: &Path) -> bool {
    let can = on_small_disk(dir, 64, "true").status.success();
    if !can {
        eprintln!("not tested: no file system can be mounted here");
    }
    can
}

#[test]
fn a_full_disk_leaves_a_checkpoint_and_the_reason() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path();
    if !can_mount(dir) {
        return;
    }
    let long = SMALL.replace("duration_s = 5.0", "duration_s = 400.0");
    let text = long.replace("interval_s = 0.5", "interval_s = 0.05");
    fs::write(dir.join("small.toml"), text).unwrap();
    let seacable = |words: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        command.args(words).current_dir(dir).output().unwrap()
    };
    assert!(
        seacable(&["run", "small.toml", "--out", "whole"])
            .status
            .success()
    );
    for kilobytes in [160, 320, 640] {
        let script = "\"$SEACABLE\" run small.toml --out disk/run\ncode=$?\ncp -r disk/run kept\nls -A disk/run >names\nexit $code";
        let output = on_small_disk(dir, kilobytes, script);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{kilobytes} kB: {said}");
        assert!(said.contains("No space left"), "{kilobytes} kB: {said}");
        let names = fs::read_to_string(dir.join("names")).unwrap();
        assert!(!names.lines().any(|name| name.starts_with('.')), "{names}");
        let run = store::read(&dir.join("kept")).unwrap();
        assert_eq!(run.info.state, RunState::Failed, "{kilobytes} kB");
        let why = run.info.failure.unwrap();
        assert!(why.contains("No space left"), "{kilobytes} kB: {why}");
        assert!(store::resume(&dir.join("kept")).is_ok(), "{kilobytes} kB");
        let output = seacable(&["run", "--resume", "kept", "--out", "again"]);
        assert!(output.status.success(), "{kilobytes} kB: {output:?}");
        for name in ["history.csv", "summary.csv", "shapes.csv", "profile.csv"] {
            let read = |run: &str| fs::read(dir.join(run).join(name)).unwrap();
            assert!(read("again") == read("whole"), "{kilobytes} kB: {name}");
        }
        for run in ["kept", "again"] {
            fs::remove_dir_all(dir.join(run)).unwrap();
        }
    }
}
