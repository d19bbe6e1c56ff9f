//! Files that options name: never onto an input, never through a link, onto an existing file only with `--force`.

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command as Process, Stdio};

use assert_cmd::Command;
use predicates::{prelude::*, str::contains};
use rustix::process::{Pid, Signal, kill_process};

use crate::small::SMALL;

/// Every command that writes a file, up to the name of the file, with its input.
const COMMANDS: [(&[&str], &str); 8] = [
    (&["modes", "case.toml", "-o"], "case.toml"),
    (&["report", "run", "-o"], "run/history.csv"),
    (&["catenary", "lines.csv", "-o"], "lines.csv"),
    (&["section", "section.toml", "-o"], "section.toml"),
    (&["ropeway", "ropeway.toml", "--line"], "ropeway.toml"),
    (&["study", "hard-cases", "case.toml", "-o"], "case.toml"),
    (&["study", "speed", "case.toml", "-o"], "case.toml"),
    (&["study", "steps", "case.toml", "-o"], "case.toml"),
];

/// Those of them that answer at once.
const QUICK: usize = 5;

fn seacable(dir: &Path) -> Command {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1");
    command
}

/// A directory with an input for every command, and a file `old.txt`.
fn place() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    let put = |name: &str, text: &str| fs::write(dir.path().join(name), text).unwrap();
    put("case.toml", SMALL);
    put(
        "lines.csv",
        "x_m,z_m,length_m,ea_n,weight_n_per_m\n100,0,120,1e9,50\n",
    );
    put("old.txt", "old");
    for (name, shipped) in [
        ("section.toml", "umbilical/section.toml"),
        ("ropeway.toml", "ropeway/span_60.toml"),
    ] {
        fs::copy(cases.join(shipped), dir.path().join(name)).unwrap();
    }
    let run = ["run", "case.toml", "--out", "run"];
    seacable(dir.path()).args(run).assert().success();
    dir
}

/// The names in a directory, hidden ones as well.
fn names(dir: &Path) -> Vec<String> {
    let items = fs::read_dir(dir).unwrap();
    let mut names: Vec<String> = items
        .map(|item| item.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn no_command_writes_onto_its_input() {
    let dir = place();
    for (words, input) in COMMANDS {
        let before = fs::read(dir.path().join(input)).unwrap();
        let link = dir.path().join("hard-link");
        fs::hard_link(dir.path().join(input), &link).unwrap();
        for name in [input, "hard-link"] {
            for force in [&["--force"][..], &[]] {
                let mut command = seacable(dir.path());
                let refused = command.args(words).arg(name).args(force).assert().code(2);
                let option = format!("{}: ", words.last().unwrap().replace("-o", "--output"));
                refused
                    .stderr(contains("is an input of this command").and(contains(option)))
                    .stderr(contains(name));
            }
        }
        fs::remove_file(link).unwrap();
        assert_eq!(fs::read(dir.path().join(input)).unwrap(), before);
    }
}

#[test]
fn a_file_that_a_case_names_is_an_input() {
    let dir = place();
    let case = format!(
        "{SMALL}\n[marks]\n\"payload.drag_area_m2\" = {{ status = \"assumed\", reason = \"old.txt\" }}\n"
    );
    fs::write(dir.path().join("case.toml"), case).unwrap();
    let words = ["modes", "case.toml", "-o", "old.txt", "--force"];
    let refused = seacable(dir.path()).args(words).assert().code(2);
    refused.stderr(contains("old.txt is an input"));
}

#[test]
fn an_existing_file_is_replaced_only_with_force() {
    let dir = place();
    for (words, _) in COMMANDS {
        let refused = seacable(dir.path()).args(words).arg("old.txt").assert();
        refused
            .code(2)
            .stderr(contains("old.txt exists").and(contains("--force")));
        assert_eq!(
            fs::read_to_string(dir.path().join("old.txt")).unwrap(),
            "old"
        );
    }
    for (words, _) in &COMMANDS[..QUICK] {
        let mut command = seacable(dir.path());
        command.args(*words).args(["old.txt", "--force"]);
        command.assert().success();
        assert_ne!(
            fs::read_to_string(dir.path().join("old.txt")).unwrap(),
            "old"
        );
        fs::write(dir.path().join("old.txt"), "old").unwrap();
    }
}

#[test]
fn nothing_is_written_through_a_link_or_into_a_device() {
    let dir = place();
    symlink("old.txt", dir.path().join("link")).unwrap();
    symlink("absent.txt", dir.path().join("dangling")).unwrap();
    for (words, _) in COMMANDS {
        for (name, said) in [
            ("link", "symbolic link"),
            ("dangling", "symbolic link"),
            ("/dev/full", "not a regular file"),
            ("run", "not a regular file"),
        ] {
            let mut command = seacable(dir.path());
            let refused = command.args(words).args([name, "--force"]).assert();
            refused.code(2).stderr(contains(said));
        }
    }
    assert_eq!(
        fs::read_to_string(dir.path().join("old.txt")).unwrap(),
        "old"
    );
    assert!(!dir.path().join("absent.txt").exists());
}

#[test]
fn a_directory_that_refuses_is_reported() {
    let dir = place();
    let words = ["modes", "case.toml", "-o", "/proc/modes.csv"];
    let refused = seacable(dir.path()).args(words).assert().code(2);
    refused.stderr(contains("writing /proc/modes.csv failed"));
    if rustix::process::geteuid().is_root() {
        // Root may write into any directory.
        return;
    }
    fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o555)).unwrap();
    let words = ["modes", "case.toml", "-o", "modes.csv"];
    let refused = seacable(dir.path()).args(words).assert().code(2);
    fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o755)).unwrap();
    refused.stderr(contains("modes.csv"));
}

/// A limit on the size of files stands for a full disk.
#[test]
fn a_full_disk_leaves_the_old_file_and_nothing_else() {
    let dir = place();
    let before = names(dir.path());
    let script = r#"trap "" XFSZ; ulimit -f 0; exec "$0" modes case.toml -o old.txt --force"#;
    let mut command = Process::new("/bin/bash");
    command.args(["-c", script, env!("CARGO_BIN_EXE_seacable")]);
    let done = command.current_dir(dir.path()).output().unwrap();
    assert_eq!(done.status.code(), Some(2), "{done:?}");
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.contains("writing old.txt failed"), "{said}");
    assert_eq!(
        fs::read_to_string(dir.path().join("old.txt")).unwrap(),
        "old"
    );
    assert_eq!(names(dir.path()), before);
}

#[test]
fn an_interrupted_command_leaves_the_old_file_and_nothing_else() {
    let dir = place();
    let before = names(dir.path());
    for signal in [Signal::INT, Signal::KILL] {
        let words = ["study", "speed", "case.toml", "-o", "old.txt", "--force"];
        let longer = ["--set", "solver.duration_s=100000"];
        let mut child = Process::new(env!("CARGO_BIN_EXE_seacable"))
            .args(words)
            .args(longer)
            .current_dir(dir.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_millis(200));
        let pid = Pid::from_raw(i32::try_from(child.id()).unwrap()).unwrap();
        kill_process(pid, signal).unwrap();
        assert!(!child.wait().unwrap().success());
        assert_eq!(
            fs::read_to_string(dir.path().join("old.txt")).unwrap(),
            "old"
        );
        assert_eq!(names(dir.path()), before);
    }
}
