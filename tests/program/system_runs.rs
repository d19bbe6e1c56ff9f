//! Runs of systems of lines in time: stored, reported, compared, listed.

use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use assert_cmd::Command;
use predicates::prelude::PredicateBooleanExt;
use predicates::str::contains;
use seacable::case::kind;
use seacable::run::index::RunIndex;
use seacable::run::job::JobEvent;
use seacable::run::job::execute_from;
use seacable::run::resume_request;
use seacable::run::store::{RunLocation, RunWriter};
use seacable::run::{Run, RunState, store};
use seacable::system::SystemFile;
use seacable::system::motion::checkpoint::ResumedSystem;
use seacable::system::motion::job::{self as system_job, SystemRequest};
use seacable::system::quantities::value;

const BRIDLE: &str = include_str!("../../cases/systems/bridle_in_heave.toml");
const PLATFORM: &str = include_str!("../../cases/systems/volturnus_in_waves.toml");
/// Its ends are meshed anew on the way.
const POLYESTER: &str = include_str!("../../cases/systems/polyester_stages.toml");
/// Chain and rope in each line.
const SPREAD: &str = include_str!("../../cases/systems/moved_spread.toml");
const CARGO: &str = include_str!("../../cases/systems/sliding_cargo.toml");

fn seacable(dir: &Path, words: &[&str]) -> Command {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir).env("NO_COLOR", "1").args(words);
    command
}

/// A directory with the bridle, short and coarse.
fn folder() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let short = BRIDLE
        .replace("segments = 40", "segments = 16")
        .replace("duration_s = 60.0", "duration_s = 4.0");
    fs::write(dir.path().join("bridle.toml"), short).unwrap();
    dir
}

/// The rest of a system by the method `static` is a run: its accuracy is reached, what it has no use for is said, it is stored, listed, reported
/// and compared.
#[test]
fn the_rest_of_a_system_is_a_run_by_the_method_static() {
    let dir = folder();
    let at_rest = |words: &[&str]| {
        let all = [&["run", "bridle.toml", "--solver", "static"], words].concat();
        let output = seacable(dir.path(), &all).assert().success();
        String::from_utf8(output.get_output().stdout.clone()).unwrap()
    };
    let asked = at_rest(&["--set", "solver.accuracy=1e-2", "--out", "asked"]);
    assert!(asked.contains("Accuracy: 0.01 asked; "), "{asked}");
    let steps = at_rest(&["--set", "solver.time_step_s=0.1", "--out", "rest"]);
    assert!(
        steps.contains("`solver.time_step_s` has no effect"),
        "{steps}"
    );
    assert!(steps.contains("top does not move: "), "{steps}");
    assert!(steps.contains("Along the lines"), "{steps}");
    let heavier = ["--set", "points.clump.mass_kg=9000", "--out", "heavier"];
    at_rest(&heavier);
    let done = |words: &[&str], wanted: &str| {
        let run = seacable(dir.path(), words).assert().success();
        run.stdout(contains(wanted));
    };
    done(&["report", "rest"], "Method");
    done(
        &["report", "heavier", "--against", "rest"],
        "points.clump.mass_kg",
    );
    done(&["compare", "rest", "heavier"], "tension_n[left|a].final");
    seacable(
        dir.path(),
        &[
            "run",
            "bridle.toml",
            "--solver",
            "static",
            "--accuracy",
            "3",
        ],
    )
    .assert()
    .code(2)
    .stderr(contains("solver.accuracy: is out of range: 3"));
}

#[test]
fn a_run_of_a_system_is_stored_like_that_of_a_line() {
    let dir = folder();
    let breaks = [
        "--set",
        "lines.left.break_at_m=50",
        "--set",
        "lines.left.break_s=2",
    ];
    seacable(dir.path(), &[&["run", "bridle.toml"], &breaks[..]].concat())
        .assert()
        .success()
        .stdout(contains("runs/bridle-").and(contains("line left breaks")));
    let root = dir.path().join("runs");
    let stored = store::list(&root).unwrap();
    let run = store::read(&stored[0].dir).unwrap();
    assert_eq!(run.info.state, RunState::Done);
    assert_eq!(run.info.warnings, Vec::<String>::new());
    assert_eq!(run.info.overrides.len(), 2);
    assert_eq!(run.info.happened.len(), 1);
    assert!(run.info.work.steps > 0 && run.info.settings.nodes > 20);
    assert_eq!(run.history.time.len(), 41);
    let greatest = run.quantity("tension_n[upper|b].max").unwrap();
    let channel = run.history.channel("tension_n[upper|b]").unwrap();
    assert_eq!(greatest.value.to_bits(), channel.peak.0.to_bits());
    assert!(greatest.time_error.is_some() && greatest.mesh_error.unwrap() > 0.0);
    assert!(
        run.quantity("energy_drift_percent.final")
            .unwrap()
            .value
            .abs()
            < 2.0
    );
    assert!(run.case_text.contains("break_at_m = 50"));

    let mut index = RunIndex::open(&root, None).unwrap();
    index.sync(&AtomicBool::new(false), &mut |_| {}).unwrap();
    let rows = index.rows(&["bridle.toml".to_owned()], 0).unwrap();
    assert_eq!(rows.changed.len(), 1);
    assert_eq!(rows.changed[0].method, "alpha");
}

#[test]
fn the_tension_where_sections_meet_is_recorded_and_known_at_rest() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("spread.toml"), SPREAD).unwrap();
    let words = [
        "run",
        "spread.toml",
        "--set",
        "solver.duration_s=2",
        "--out",
        "run",
    ];
    seacable(dir.path(), &words).assert().success();
    let run = store::read(&dir.path().join("run")).unwrap();
    let of = |place: &str| {
        let name = format!("tension_n[mooring@120|{place}]");
        run.history.channel(&name).unwrap().values[0]
    };
    let (bottom, meeting, top) = (of("a"), of("1"), of("b"));
    assert!(
        bottom <= meeting && meeting < top,
        "{bottom} {meeting} {top}"
    );
    let file = dir.path().join("spread.toml");
    let loaded = seacable::open::load::<SystemFile>(&file).unwrap();
    let rest = value(&loaded.computed, "tension_n[mooring@120|1]").unwrap();
    assert!((meeting / rest - 1.0).abs() < 0.01, "{meeting} {rest}");
    assert!(value(&loaded.computed, "tension_n[mooring@120|2]").is_err());
}

#[test]
fn runs_of_systems_are_reported_and_compared() {
    let dir = folder();
    for (name, set) in [
        ("a", "points.clump.mass_kg=500"),
        ("b", "points.clump.mass_kg=700"),
    ] {
        seacable(
            dir.path(),
            &["run", "bridle.toml", "--out", name, "--set", set],
        )
        .assert()
        .success();
    }
    seacable(dir.path(), &["report", "a"])
        .assert()
        .success()
        .stdout(
            contains("implicit generalized-alpha")
                .and(contains("Tension at ends A"))
                .and(contains("z_m[clump]"))
                .and(contains("points.clump.mass_kg"))
                .and(contains("Newton iterations")),
        );
    seacable(dir.path(), &["report", "b", "--against", "a"])
        .assert()
        .success();
    seacable(dir.path(), &["compare", "a", "b"])
        .assert()
        .success()
        .stdout(
            contains("points.clump.mass_kg")
                .and(contains("tension_n[upper|b].max"))
                .and(contains("cannot be read").not()),
        );
}

/// A run that is continued to a later time has the rows and results of one that was never stopped, to the last bit: with a line that
/// breaks before, and one that is let go after.
#[test]
fn a_resumed_run_is_that_of_one_never_stopped() {
    let dir = folder();
    let events = [
        "lines.left.break_at_m=50",
        "lines.left.break_s=1.5",
        "lines.right.release_b_s=3.2",
    ];
    let set: Vec<&str> = events.iter().flat_map(|set| ["--set", set]).collect();
    let run = |words: &[&str]| {
        seacable(dir.path(), &[words, &set].concat())
            .assert()
            .success();
    };
    run(&["run", "bridle.toml", "--out", "whole"]);
    run(&[
        "run",
        "bridle.toml",
        "--out",
        "first",
        "--set",
        "solver.duration_s=2.5",
    ]);
    let resume = [
        "run", "--resume", "first", "--until", "4", "--out", "second",
    ];
    seacable(dir.path(), &resume).assert().success();
    let read =
        |name: &str, file: &str| fs::read_to_string(dir.path().join(name).join(file)).unwrap();
    for file in ["history.csv", "summary.csv", "channels.csv", "errors.csv"] {
        assert!(read("whole", file) == read("second", file), "{file}");
    }
    let happened = |name: &str| store::read_info(&dir.path().join(name)).unwrap().happened;
    assert_eq!(happened("second"), happened("whole"));
    assert_eq!(happened("second").len(), 2);
    seacable(dir.path(), &["run", "--resume", "whole"])
        .assert()
        .code(2)
        .stderr(contains("is at 4 s already"));
}

/// The bridle or the platform in waves, coarse and without error estimates, with these keys of the solver.
fn request(text: &str, solver: &str) -> SystemRequest {
    let solver = format!("[solver]\nerror_estimate = false\n{solver}\n[output]");
    let (before, rest) = text.split_once("[solver]").unwrap();
    let (_, after) = rest.split_once("[output]").unwrap();
    let text = format!("{before}{solver}{after}");
    let text = text
        .replace("segments = 40", "segments = 16")
        .replace("segments = 50", "segments = 10");
    let at = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/systems/short.toml");
    let solved = kind::parse::<SystemFile>(&text, at).unwrap();
    system_job::request(solved.into(), &text, "short.toml".to_owned(), Vec::new()).unwrap()
}

/// Computes a request into a directory, and stops it at a time.
fn computed(request: &SystemRequest, from: Option<&ResumedSystem>, dir: &Path, stop: f64) -> Run {
    let place = RunLocation::Exactly(dir.to_owned());
    let mut writer = RunWriter::begin(&place, request.initial_info(), &request.text).unwrap();
    let cancel = AtomicBool::new(false);
    let run = execute_from(request, from, &cancel, &mut |event| {
        if matches!(&event, JobEvent::Frame(frame) if frame.time >= stop) {
            cancel.store(true, Ordering::Relaxed);
        }
        writer.event(&event).unwrap();
    });
    writer.finish(&run).unwrap();
    run
}

/// Resumes a stored run and holds it against one that was never stopped.
fn assert_resumes_to(whole: &SystemRequest, first: &Path, until: Option<f64>) {
    let place = tempfile::tempdir().unwrap();
    let whole = computed(whole, None, &place.path().join("whole"), f64::INFINITY);
    let (request, from) = resume_request(first, until).unwrap();
    assert!(from.is_some());
    let second = place.path().join("second");
    let resumed = computed(&request, from.as_ref(), &second, f64::INFINITY);
    assert_eq!(resumed.info.state, RunState::Done);
    assert!(resumed.history == whole.history && resumed.summary == whole.summary);
    assert_eq!(resumed.info.work.steps, whole.info.work.steps);
}

/// The tolerance is so small that errors set the steps.
#[test]
fn a_run_resumed_up_to_a_later_end_is_that_of_a_longer_one() {
    let until = |end: f64| format!("duration_s = {end:?}\nstep_tolerance = 1e-8");
    for text in [BRIDLE, PLATFORM] {
        let place = tempfile::tempdir().unwrap();
        let dir = place.path().join("first");
        let first = request(text, &until(3.0));
        assert_eq!(
            computed(&first, None, &dir, f64::INFINITY).info.state,
            RunState::Done
        );
        assert_resumes_to(&request(text, &until(7.5)), &dir, Some(7.5));
    }
}

#[test]
fn a_stopped_run_resumes_to_the_same_bits() {
    // It creeps from its start, and yields.
    let creeping = POLYESTER
        .replace("past_tension_n = 1.3886e6", "past_tension_n = 2e5")
        .replace(
            "slow_damping_n_s",
            "initial_mean_tension_n = 2e5\nslow_damping_n_s",
        )
        .replace("interval_s = 60.0", "interval_s = 0.2");
    // Its wire bends, and is clamped on a ship that pitches.
    let clamped = BRIDLE
        .replace("ea_n = 1e8", "ea_n = 1e8\nei_n_m2 = 1e5")
        .replace(
            "[points.top]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]",
            "[points.top]\nkind = \"body\"\nbody = \"ship\"\nposition_m = [1.0, 0.0, 0.0]\n\
             [bodies.ship]\nkind = \"moved\"\nposition_m = [-1.0, 0.0, 0.0]\namplitude_deg = [0.0, 5.0, 0.0]",
        )
        .replace("period_s = 8.0", "period_s = [8.0]")
        .replace("length_m = 120.0", "length_m = 120.0\nclamp_b_elevation_deg = 90.0");
    for (text, solver, stop) in [
        (PLATFORM, "duration_s = 8.0\ntime_step_s = 0.1", 4.0),
        (&clamped, "duration_s = 4.0", 2.0),
        (BRIDLE, "duration_s = 2.0\nmethod = \"rk4\"", 1.0),
        (CARGO, "duration_s = 12.0", 9.0),
        (BRIDLE, "duration_s = 2.0\nmethod = \"auto\"", 1.0),
        (
            BRIDLE,
            "duration_s = 2.0\nmethod = \"auto\"\nstep_tolerance = 1e-12",
            1.0,
        ),
        (&creeping, "duration_s = 60.0", 30.0),
        (&creeping, "duration_s = 2.0\nmethod = \"rk4\"", 1.0),
    ] {
        let place = tempfile::tempdir().unwrap();
        let dir = place.path().join("first");
        let request = request(text, solver);
        let stopped = computed(&request, None, &dir, stop);
        assert_eq!(stopped.info.state, RunState::Cancelled);
        assert!(stopped.history.time.len() > 3);
        assert_resumes_to(&request, &dir, None);
    }
}

/// What the solver cannot bring to its end is kept, with time, place and reason.
#[test]
fn a_run_that_fails_keeps_what_it_had() {
    let dir = folder();
    let words = [
        "run",
        "bridle.toml",
        "--out",
        "a",
        "--set",
        "solver.position_tolerance_m=1e-300",
    ];
    seacable(dir.path(), &words)
        .assert()
        .code(1)
        .stderr(contains("The run failed: at t = ").and(contains("node")));
    let run = store::read(&dir.path().join("a")).unwrap();
    assert_eq!(run.info.state, RunState::Failed);
    seacable(dir.path(), &["report", "a"])
        .assert()
        .success()
        .stdout(contains("FAILED: at t = "));
}
