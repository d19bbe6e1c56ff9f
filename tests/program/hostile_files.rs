//! Files that are no files, lie elsewhere or have no end; directories that hold themselves; faults shown where they are.

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::time::Duration;

use assert_cmd::Command;
use rustix::fs::{CWD, Mode, mkfifoat};

use crate::small::SMALL;

const PENDULUM: &str = include_str!("../../cases/basics/pendulum.toml");
const VOLTURNUS: &str = include_str!("../../cases/systems/volturnus_in_waves.toml");

/// What no message may quote.
const SECRET: &str = "hunter2";

/// A program that waits or reads without end fails the test.
fn seacable(dir: &Path, words: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1").args(words);
    let done = command.timeout(Duration::from_secs(60)).output().unwrap();
    let said = [done.stdout, done.stderr].concat();
    (
        done.status.code(),
        String::from_utf8_lossy(&said).into_owned(),
    )
}

/// The pendulum with an end that moves by a table.
fn moved_by(table: &str) -> String {
    let still = "kind = \"fixed\"";
    let moving = format!("kind = \"moving\"\nmotion = \"table\"\nmotion_file = \"{table}\"");
    assert!(PENDULUM.contains(still));
    PENDULUM.replacen(still, &moving, 1)
}

/// A project `p` and a file `out/secret.csv` outside it.
fn place() -> (tempfile::TempDir, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    let project = dir.path().join("p");
    for folder in ["p", "out"] {
        fs::create_dir(dir.path().join(folder)).unwrap();
    }
    fs::write(dir.path().join("out/secret.csv"), SECRET).unwrap();
    (dir, project)
}

#[test]
fn every_command_refuses_special_files_at_once() {
    let (_dir, project) = place();
    mkfifoat(CWD, project.join("pipe"), Mode::RUSR | Mode::WUSR).unwrap();
    symlink("/dev/zero", project.join("zero")).unwrap();
    let large = fs::File::create(project.join("large")).unwrap();
    large.set_len(8 << 30).unwrap();
    fs::write(project.join("case.toml"), SMALL).unwrap();
    let commands: [&[&str]; 14] = [
        &["run"],
        &["validate"],
        &["catenary"],
        &["section"],
        &["ship"],
        &["ropeway"],
        &["modes"],
        &["import"],
        &["audit"],
        &["lines", "--library"],
        &["laboratory", "bars"],
        &["study", "effects"],
        &["study", "hard-cases"],
        &["study", "physics"],
    ];
    for file in ["pipe", "zero", "large"] {
        for command in commands {
            let words = [command, &[file]].concat();
            let (status, said) = seacable(&project, &words);
            assert_eq!(status, Some(2), "{words:?}: {said}");
            let reason = match file {
                "large" => "--limit-file-size",
                _ => "not a regular file",
            };
            assert!(said.contains(reason), "{words:?}: {said}");
        }
    }
}

#[test]
fn special_files_that_cases_and_runs_name_are_refused_at_once() {
    let (_dir, project) = place();
    mkfifoat(CWD, project.join("pipe"), Mode::RUSR | Mode::WUSR).unwrap();
    fs::write(project.join("moved.toml"), moved_by("pipe")).unwrap();
    let (status, said) = seacable(&project, &["run", "moved.toml"]);
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("named pipe"), "{said}");
    let foreign = VOLTURNUS.replace("volturnus_data/semi.1", "pipe");
    fs::write(project.join("semi.toml"), foreign).unwrap();
    let (status, said) = seacable(&project, &["run", "semi.toml"]);
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("named pipe"), "{said}");

    fs::write(project.join("case.toml"), SMALL).unwrap();
    seacable(&project, &["run", "case.toml", "--out", "r"]);
    for name in ["run.toml", "case.toml", "history.csv", "checkpoint.toml"] {
        let file = project.join("r").join(name);
        let kept = fs::read(&file).ok();
        let _ = fs::remove_file(&file);
        mkfifoat(CWD, &file, Mode::RUSR | Mode::WUSR).unwrap();
        for words in [
            ["report", "r"].as_slice(),
            &["compare", "r", "r"],
            &["run", "--resume", "r"],
        ] {
            let (status, _) = seacable(&project, words);
            assert!(status.is_some(), "{words:?} waits for {name}");
        }
        fs::remove_file(&file).unwrap();
        if let Some(kept) = kept {
            fs::write(&file, kept).unwrap();
        }
    }
}

#[test]
fn a_limit_of_the_user_holds_for_every_file() {
    let (_dir, project) = place();
    fs::write(project.join("case.toml"), SMALL).unwrap();
    for words in [
        ["run", "case.toml", "--limit-file-size", "10"],
        ["--limit-file-size", "10", "run", "case.toml"],
    ] {
        let (status, said) = seacable(&project, &words);
        assert_eq!(status, Some(2), "{said}");
        assert!(said.contains("above the limit of 10"), "{said}");
    }
}

#[test]
fn what_lies_outside_is_neither_read_nor_quoted() {
    let (dir, project) = place();
    let secret = dir.path().join("out/secret.csv");
    symlink("../out/secret.csv", project.join("link.csv")).unwrap();
    symlink("../out", project.join("linked")).unwrap();
    fs::create_dir(project.join("sub")).unwrap();
    let names = [
        secret.to_str().unwrap(),
        "../out/secret.csv",
        "link.csv",
        "linked/secret.csv",
        "sub/../../out/secret.csv",
    ];
    for name in names {
        fs::write(project.join("moved.toml"), moved_by(name)).unwrap();
        for words in [["run", "moved.toml"], ["validate", "moved.toml"]] {
            let (status, said) = seacable(&project, &words);
            assert_eq!(status, Some(2), "{name}: {said}");
            assert!(said.contains("outside"), "{name}: {said}");
            assert!(said.contains("--root"), "{name}: {said}");
            assert!(said.contains("ends.a.motion_file"), "{name}: {said}");
            assert!(!said.contains(SECRET), "{name}: {said}");
        }
    }
    // What the user types may be read, and is not quoted either.
    fs::write(project.join("moved.toml"), moved_by("m.csv")).unwrap();
    fs::write(
        project.join("m.csv"),
        "time_s,x_m,y_m,z_m\n0,0,0,0\n100,0,0,0\n",
    )
    .unwrap();
    for root in [None, Some("--root=..")] {
        let set = format!("ends.a.motion_file={}", names[0]);
        let mut words = vec!["run", "moved.toml", "--set", &set];
        words.extend(root);
        let (status, said) = seacable(&project, &words);
        assert_eq!(status, Some(2), "{said}");
        assert_eq!(said.contains(SECRET), root.is_some(), "{said}");
        assert!(said.contains("secret.csv"), "{said}");
    }
}

#[test]
fn the_root_of_the_user_allows_what_lies_below_it() {
    let (dir, project) = place();
    let table = "time_s,x_m,y_m,z_m\n0,0,0,0\n1000,0,0,0\n";
    fs::write(dir.path().join("out/secret.csv"), table).unwrap();
    fs::write(project.join("moved.toml"), moved_by("../out/secret.csv")).unwrap();
    let validate = |words: &[&str]| seacable(&project, &[&["validate"], words].concat());
    assert_eq!(validate(&["moved.toml"]).0, Some(2));
    for words in [
        ["moved.toml", "--root", ".."].as_slice(),
        // A directory that is opened is the root of what lies below it.
        &[".."],
    ] {
        let (status, said) = validate(words);
        assert_eq!(status, Some(0), "{words:?}: {said}");
    }
    let (status, said) = validate(&["moved.toml", "--root", "absent"]);
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("--root"), "{said}");
}

#[test]
fn files_of_other_programs_name_files_below_their_root_alone() {
    let (_dir, project) = place();
    // A design that names its mooring.
    let text = "mooring:\n  water_depth: 320\n  file: ../out/secret.csv\n";
    fs::write(project.join("design.yaml"), text).unwrap();
    let (status, said) = seacable(&project, &["import", "design.yaml"]);
    assert_eq!(status, Some(2), "{said}");
    assert!(!said.contains(SECRET), "{said}");
    assert!(said.contains("outside"), "{said}");
}

#[test]
fn files_of_a_run_are_no_links() {
    let (dir, project) = place();
    fs::write(project.join("case.toml"), SMALL).unwrap();
    seacable(&project, &["run", "case.toml", "--out", "r"]);
    let secret = dir.path().join("out/secret.csv");
    for name in [
        "run.toml",
        "case.toml",
        "history.csv",
        "summary.csv",
        "notes.toml",
        "checkpoint.toml",
    ] {
        let file = project.join("r").join(name);
        let kept = fs::read(&file).ok();
        let _ = fs::remove_file(&file);
        symlink(&secret, &file).unwrap();
        for words in [
            ["report", "r"].as_slice(),
            &["compare", "r", "r"],
            &["run", "--resume", "r"],
        ] {
            let (_, said) = seacable(&project, words);
            assert!(!said.contains(SECRET), "{name}, {words:?}: {said}");
        }
        fs::remove_file(&file).unwrap();
        if let Some(kept) = kept {
            fs::write(&file, kept).unwrap();
        }
    }
    // A run that says that its case stood elsewhere has nothing read from there.
    let run = fs::read_to_string(project.join("r/run.toml")).unwrap();
    let elsewhere = format!(
        "case_file = \"{}/c.toml\"",
        dir.path().join("out").display()
    );
    let run = run.replacen("case_file = \"case.toml\"", &elsewhere, 1);
    assert!(run.contains(&elsewhere));
    fs::write(project.join("r/run.toml"), run).unwrap();
    fs::write(project.join("r/case.toml"), moved_by("secret.csv")).unwrap();
    for words in [
        ["report", "r"].as_slice(),
        &["compare", "r", "r"],
        &["run", "--resume", "r"],
    ] {
        let (_, said) = seacable(&project, words);
        assert!(!said.contains(SECRET), "{words:?}: {said}");
    }
}

#[test]
fn directories_that_hold_themselves_and_runs_are_listed_once() {
    let (_dir, project) = place();
    fs::write(project.join("case.toml"), SMALL).unwrap();
    symlink(".", project.join("a")).unwrap();
    symlink(".", project.join("b")).unwrap();
    symlink("..", project.join("up")).unwrap();
    let (status, said) = seacable(&project, &["run", "case.toml"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(project.join("runs").is_dir());
    let (status, said) = seacable(&project, &["validate", "."]);
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(said.matches("case.toml").count(), 1, "{said}");
    let (status, said) = seacable(&project, &["laboratory", "bars", "."]);
    assert_eq!(status, Some(0), "{said}");
}

#[test]
fn links_to_cases_outside_a_directory_are_refused() {
    let (_dir, project) = place();
    symlink("../out/secret.csv", project.join("x.toml")).unwrap();
    let (status, said) = seacable(&project, &["validate", "."]);
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("x.toml"), "{said}");
    assert!(said.contains("outside"), "{said}");
    assert!(!said.contains(SECRET), "{said}");
}

#[test]
fn faults_of_tables_are_shown_in_the_table() {
    let (_dir, project) = place();
    fs::write(project.join("moved.toml"), moved_by("m.csv")).unwrap();
    let faulty = |table: &str| {
        fs::write(project.join("m.csv"), table).unwrap();
        for command in ["run", "validate"] {
            let (status, said) = seacable(&project, &[command, "moved.toml"]);
            assert_eq!(status, Some(2), "{command}: {said}");
            has_place(&said, "m.csv:3:");
            assert!(said.contains("3 | 1,"), "{command}: {said}");
        }
        seacable(&project, &["run", "moved.toml"]).1
    };
    let said = faulty("time_s,x_m,y_m,z_m\n0,0,0,0\n1,CSVBAD,0,0\n");
    assert!(said.contains("CSVBAD"), "{said}");
    let said = faulty("time_s,x_m,y_m,z_m\n5,0,0,0\n1,0,0,0\n");
    assert!(said.contains("does not come after 5 s"), "{said}");
}

/// That a text has a line of a place.
fn has_place(said: &str, place: &str) {
    let mut lines = said.lines();
    assert!(
        lines.any(|line| line.contains("--> ") && line.contains(place)),
        "{place}: {said}"
    );
}

#[test]
fn faults_name_their_file_or_their_option() {
    let (_dir, project) = place();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    for (shipped, good, bad) in [
        ("ropeway/span_60.toml", "span_m = ", "span_m = -"),
        (
            "umbilical/section.toml",
            "[section]",
            "[section]\nnonsense = 1",
        ),
    ] {
        let text = fs::read_to_string(cases.join(shipped)).unwrap();
        assert!(text.contains(good), "{shipped}");
        fs::write(project.join("bad.toml"), text.replacen(good, bad, 1)).unwrap();
        let (status, said) = seacable(&project, &["validate", "bad.toml"]);
        assert_eq!(status, Some(2), "{said}");
        has_place(&said, "bad.toml:");
    }
    fs::write(project.join("case.toml"), SMALL).unwrap();
    let set = ["--set", "solver.duration_s=-1"];
    for words in [["run", "case.toml"], ["study", "effects"]] {
        let words = match words[0] {
            "run" => [&words, set.as_slice()].concat(),
            _ => [&words, ["case.toml"].as_slice(), &set].concat(),
        };
        let (status, said) = seacable(&project, &words);
        assert_eq!(status, Some(2), "{said}");
        assert!(
            said.contains("--> --set solver.duration_s=-1\n"),
            "{words:?}: {said}"
        );
    }
}

#[test]
fn an_override_that_is_no_text_is_named() {
    let (_dir, project) = place();
    fs::write(project.join("case.toml"), SMALL).unwrap();
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(&project).args(["run", "case.toml"]);
    command.args(["--set", "solver.duration_s=1"]);
    command
        .arg("--set")
        .arg(OsStr::from_bytes(b"case.title=a\xffb"));
    let done = command.output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(2), "{said}");
    assert!(said.contains("`--set $'case.title=a\\377b'`"), "{said}");
    assert!(!said.contains("duration"), "{said}");
}
