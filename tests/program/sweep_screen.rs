//! Load cases computed from the screen: begun, cancelled, gone on with, followed from the heat map to a run; the same folder as that of
//! `seacable sweep`.

#![cfg(target_os = "linux")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::pty::{Pty, Start, place};
use crate::small::SMALL;

/// Two axes and a check of the small case.
const TABLES: &str = r#"
[[load_cases]]
key = "payload.dry_mass_kg"
values = [500.0, 600.0, 700.0]

[[load_cases]]
key = "solver.duration_s"
values = [4.0, 6.0]

[[checks]]
name = "chain holds"
kind = "safety-factor"
factor = 1.5
break_load_n = 1e8
"#;

const ENTER: &str = "\r";

/// The folders of sweeps below runs.
fn sweeps(dir: &Path) -> Vec<PathBuf> {
    let inside = fs::read_dir(dir.join("runs")).unwrap();
    let all = inside.map(|item| item.unwrap().path());
    all.filter(|dir| dir.join("sweep.toml").is_file()).collect()
}

fn started(args: &[&str]) -> Pty {
    let dir = place();
    fs::write(dir.path().join("small.toml"), format!("{SMALL}{TABLES}")).unwrap();
    let start = Start {
        args,
        ..Start::default()
    };
    start.go_in(dir)
}

#[test]
fn load_cases_are_computed_and_followed_to_a_run() {
    let mut pty = started(&["small.toml"]);
    pty.wait_for("Inputs");
    pty.send("W");
    pty.wait_for("6 of 6 load cases are done");
    pty.wait_for("6 of 6 done");
    // The map: masses across, durations down.
    pty.wait_for("across: dry mass [kg]");
    pty.wait_for("down: duration [s]");
    pty.send("]]");
    pty.wait_for("passes");
    pty.send("[[");
    pty.send(ENTER);
    pty.wait_for("Enter shows the run");
    pty.send(ENTER);
    pty.wait_for("Charts and report show load case 1 ");
    pty.send("C\x1b");
    pty.wait_for("across: dry mass [kg]");
    let sweeps = sweeps(pty.dir.path());
    assert_eq!(sweeps.len(), 1);
    let results = fs::read_to_string(sweeps[0].join("results.csv")).unwrap();
    let report = fs::read_to_string(sweeps[0].join("report.txt")).unwrap();
    assert!(results.lines().count() == 7 && report.contains("passes"));
    // The same key finds the sweep again, and the command line has nothing to compute.
    pty.send("W");
    pty.wait_for("6 of 6 load cases are done");
    pty.send("q");
    pty.ended(0);
    let resumed = Command::new(env!("CARGO_BIN_EXE_seacable"))
        .args(["sweep", "--resume"])
        .arg(sweeps[0].strip_prefix(pty.dir.path()).unwrap())
        .current_dir(pty.dir.path())
        .output()
        .unwrap();
    assert!(resumed.status.success(), "{resumed:?}");
    assert_eq!(self::sweeps(pty.dir.path()), sweeps);
    assert_eq!(
        fs::read_to_string(sweeps[0].join("results.csv")).unwrap(),
        results
    );
    assert_eq!(
        fs::read_to_string(sweeps[0].join("report.txt")).unwrap(),
        report
    );
}
