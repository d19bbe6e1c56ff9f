//! Jobs that go on without a screen: begun, followed, cancelled, resumed, cut off, killed; a few of each. `tests/real_programs` has many.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::time::{Duration, Instant};

use predicates::prelude::{Predicate, predicate};
use seacable::jobs::{JobFolder, JobFolderState, JobPhase};
use seacable::run::{RunState, store};

use crate::chance::{Chance, asked, seed};
use crate::jobs::{
    SLOW, begin_run, command, cut_links, finish_and_compare, folders, killed_jobs, killed_screens,
    left_in_jobs, login, place, processes_in, said, settle,
};
use crate::many_lines::many_lines;
use crate::pty::wait_until;
use crate::small::SMALL;

/// Simulated time of the runs \[s\]: a second or two.
const SHORT: u32 = 1_500;

/// Simulated time of a run that does not end by itself \[s\].
const ENDLESS: u32 = 500_000;

#[test]
fn a_run_goes_on_while_links_are_cut() {
    let mut chance = Chance::new(seed());
    cut_links(SHORT, 2, asked("SEACABLE_CUTS", 5), &mut chance);
}

#[test]
fn killed_screens_leave_nothing_unreadable() {
    let mut chance = Chance::new(seed());
    killed_screens(SHORT, asked("SEACABLE_KILLS", 4), &mut chance);
}

#[test]
fn killed_jobs_can_be_finished() {
    let mut chance = Chance::new(seed());
    killed_jobs(SHORT, asked("SEACABLE_KILLS", 4), &mut chance);
}

/// A directory with a case that does not end by itself.
fn endless() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let duration = format!("duration_s = {ENDLESS}.0\ntime_step_s = 0.01");
    let text = SMALL.replace("duration_s = 5.0", &duration);
    fs::write(dir.path().join(SLOW), text).unwrap();
    dir
}

#[test]
fn a_job_is_cancelled_on_the_screen_and_resumed() {
    let mut pty = begin_run(endless());
    pty.send("6");
    pty.wait("the job runs", |screen| {
        let text = screen.contents();
        text.contains("1: slow, alpha") && text.contains(" of 500000 s")
    });
    pty.send("jx");
    pty.wait("the job is cancelled", |screen| {
        let text = screen.contents();
        text.lines()
            .any(|line| line.contains("1: slow, alpha") && line.contains("cancelled"))
    });
    let path = pty.dir.path().to_owned();
    wait_until("its folder is gone", || left_in_jobs(&path).is_empty());
    let stopped = store::list(&path.join("runs")).unwrap().remove(0);
    assert_eq!(stopped.info.unwrap().state, RunState::Cancelled);
    let row = store::read(&stopped.dir).unwrap().history.time.len();
    assert!(row > 1);
    // Up to a moment that it has passed already is refused, up to one soon after is computed.
    let until = format!("{}", (row as u64 + 2_000) / 10 * 10);
    pty.send("3jc");
    pty.wait_for("last checkpoint");
    pty.send(&"\x7f".repeat(12));
    pty.send(&until);
    pty.send("\r");
    pty.wait_for("is done");
    let all = store::list(&path.join("runs")).unwrap();
    let done = all.into_iter().filter(|run| {
        let info = run.info.as_ref().unwrap();
        info.state == RunState::Done
    });
    assert_eq!(done.count(), 1);
    let dir = settle(pty.kill());
    assert!(processes_in(dir.path()).is_empty());
}

#[test]
fn quitting_leaves_jobs_running_unless_they_are_cancelled() {
    let mut pty = begin_run(endless());
    pty.send("q");
    pty.wait_for("They go on without this screen");
    pty.send("c");
    pty.wait("no question", |screen| {
        !screen.contents().contains("They go on")
    });
    pty.send("q");
    pty.wait_for("They go on without this screen");
    pty.send("\r");
    pty.wait("the end of the screen", |screen| !screen.alternate_screen());
    let dir = pty.kill();
    assert_eq!(folders(dir.path()).len(), 1);
    wait_until("it runs", || {
        said(dir.path(), &["jobs"]).contains("running")
    });

    let mut pty = login(dir, &[SLOW]);
    pty.wait_for("goes on from an earlier login");
    pty.send("2");
    pty.wait_for("1 to go");
    pty.send("q");
    pty.wait_for("They go on without this screen");
    pty.send("x");
    pty.wait("the end of the screen", |screen| !screen.alternate_screen());
    let dir = pty.kill();
    wait_until("the job has ended", || processes_in(dir.path()).is_empty());
    let text = said(dir.path(), &["jobs"]);
    assert!(text.contains("cancelled"), "{text}");
    settle(dir);
}

#[test]
fn a_case_is_left_while_its_job_runs_and_its_curves_are_there_on_return() {
    let mut pty = begin_run(endless());
    pty.wait_for("1 to go");
    pty.send("\x1b");
    pty.wait_for("enter open");
    pty.send("/slow\r\r");
    pty.wait_for("solver alpha");
    pty.send("3");
    pty.wait("the run in the table", |screen| {
        let text = screen.contents();
        text.lines()
            .any(|line| line.contains("slow-") && line.contains("running"))
    });
    pty.send("6j");
    pty.wait_for("1: slow, alpha");
    pty.send("x");
    pty.wait_for("cancelled");
    settle(pty.kill());
}

#[test]
fn without_processes_a_run_ends_with_its_screen() {
    let mut pty = login(endless(), &["--in-process", SLOW]);
    pty.wait_for("solver alpha");
    pty.send("R");
    let path = pty.dir.path().to_owned();
    wait_until("a run is stored", || {
        store::list(&path.join("runs")).is_ok_and(|runs| !runs.is_empty())
    });
    assert_eq!(processes_in(&path).len(), 1);
    assert!(left_in_jobs(&path).is_empty());
    let dir = pty.kill();
    wait_until("no process is left", || processes_in(dir.path()).is_empty());
    let run = store::list(&dir.path().join("runs")).unwrap().remove(0);
    assert_eq!(run.info.unwrap().state, RunState::Partial);
}

#[test]
fn where_jobs_cannot_be_kept_runs_are_computed_inside_the_screen() {
    let dir = endless();
    fs::write(dir.path().join("file"), "").unwrap();
    let state = dir.path().join("file/state");
    let vars = [
        ("LANG", "C.UTF-8"),
        ("XDG_STATE_HOME", state.to_str().unwrap()),
    ];
    let start = crate::pty::Start {
        args: &[SLOW],
        vars: &vars,
        script: r#"exec "$0" "$@""#,
        ..crate::pty::Start::default()
    };
    let mut pty = start.go_in(dir);
    pty.wait_for("solver alpha");
    pty.send("!");
    pty.wait_for("Runs are computed inside this screen");
    pty.kill();
}

#[test]
fn load_cases_go_on_without_their_screen() {
    let dir = tempfile::tempdir().unwrap();
    let tables =
        "\n[[load_cases]]\nkey = \"payload.dry_mass_kg\"\nvalues = [500.0, 600.0, 700.0, 800.0]\n";
    let text = SMALL.replace(
        "duration_s = 5.0",
        "duration_s = 1500.0\ntime_step_s = 0.01",
    );
    fs::write(dir.path().join(SLOW), format!("{text}{tables}")).unwrap();
    let mut pty = login(dir, &[SLOW]);
    pty.wait_for("solver alpha");
    pty.send("W");
    let path = pty.dir.path().to_owned();
    wait_until("the first run is stored", || {
        store::list(&path.join("runs")).is_ok_and(|runs| !runs.is_empty())
    });
    let mut pty = login(pty.kill(), &[SLOW]);
    pty.wait_for("load cases of slow.toml");
    pty.send("C");
    pty.wait_for("4 of 4 done");
    let dir = settle(pty.kill());
    let sweeps = fs::read_dir(dir.path().join("runs")).unwrap().flatten();
    let results = sweeps.filter(|item| item.path().join("results.csv").is_file());
    assert_eq!(results.count(), 1);
}

#[test]
fn jobs_of_the_shell_are_listed_waited_for_and_cancelled() {
    let dir = place(300);
    let path = dir.path();
    let begun = said(path, &["run", "--detach", SLOW]);
    assert!(begun.starts_with("Job 1 on "), "{begun}");
    let ended = said(path, &["jobs", "wait", "1"]);
    assert!(ended.starts_with("runs/slow-"), "{ended}");
    assert_eq!(said(path, &["jobs"]), "There are no jobs.\n");
    let run = said(
        path,
        &[
            "run",
            "--detach",
            "--json",
            SLOW,
            "--set",
            "solver.duration_s=500000",
        ],
    );
    assert!(run.contains("\"job\": 2"), "{run}");
    let waits = said(path, &["run", "--detach", SLOW, "--out", "named"]);
    assert!(waits.starts_with("Job 3 "), "{waits}");
    said(path, &["run", "--detach", SLOW]);
    wait_until("the first computes", || {
        said(path, &["jobs"]).contains("running")
    });
    for number in ["4", "2"] {
        said(path, &["jobs", "cancel", number]);
    }
    let stopped = command(path, &["jobs", "follow", "2"]).output().unwrap();
    assert_eq!(stopped.status.code(), Some(1));
    assert_eq!(said(path, &["jobs", "wait", "3"]).trim(), "named");
    let again = command(path, &["jobs", "cancel", "4"]).output().unwrap();
    let words = String::from_utf8_lossy(&again.stderr).into_owned();
    assert!(
        predicate::str::contains("cancelled already").eval(&words),
        "{words}"
    );
    let listed = said(path, &["jobs", "--json"]);
    let listed: serde_json::Value = serde_json::from_str(&listed).unwrap();
    assert_eq!(listed["jobs"].as_array().unwrap().len(), 1);
    fs::remove_dir_all(path.join("runs")).unwrap();
    fs::rename(path.join("named"), path.join("again")).unwrap();
    fs::create_dir(path.join("runs")).unwrap();
    fs::rename(path.join("again"), path.join("runs/again")).unwrap();
    assert_eq!(finish_and_compare(path, 1), 0);
    settle(dir);
}

/// Within 0.3 s where it has a core to itself; the search goes on for longer than it may take here.
#[test]
fn a_job_that_searches_an_equilibrium_is_cancelled_in_a_moment() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path();
    let text = many_lines(160) + "[solver]\nduration_s = 1.0\n";
    fs::write(path.join("many.toml"), text).unwrap();
    said(path, &["run", "--detach", "many.toml"]);
    let state = || folders(path).first().map(JobFolder::state);
    wait_until("the job computes", || {
        let status = folders(path).first().and_then(JobFolder::status);
        status.is_some_and(|status| status.phase == JobPhase::Running)
    });
    said(path, &["jobs", "cancel", "1"]);
    let asked = Instant::now();
    wait_until("the job ends", || {
        matches!(state(), Some(JobFolderState::Ended(_)))
    });
    let took = asked.elapsed();
    println!("{:.3} s", took.as_secs_f64());
    let Some(JobFolderState::Ended(status)) = state() else {
        panic!("{:?}", state());
    };
    assert_eq!((status.phase, status.message), (JobPhase::Cancelled, None));
    assert!(took < Duration::from_secs(2), "{took:?}");
    let followed = command(path, &["jobs", "follow", "1"]).output().unwrap();
    assert_eq!(followed.status.code(), Some(1));
    settle(dir);
}

#[test]
fn a_folder_that_others_can_write_is_refused() {
    let dir = endless();
    let path = dir.path();
    said(path, &["run", "--detach", SLOW]);
    let folder = folders(path).remove(0);
    wait_until("it computes", || said(path, &["jobs"]).contains("running"));
    let mode = |mode| fs::Permissions::from_mode(mode);
    fs::set_permissions(&folder.path, mode(0o777)).unwrap();
    let refused = command(path, &["jobs", "cancel", "1"]).output().unwrap();
    assert!(!refused.status.success());
    fs::set_permissions(&folder.path, mode(0o700)).unwrap();
    said(path, &["jobs", "cancel", "1"]);
    settle(dir);
}
