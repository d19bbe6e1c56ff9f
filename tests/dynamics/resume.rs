//! A run that goes on from a checkpoint is the run that never stopped, to the last bit.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use crate::reseal::{reseal, unsealed};
use seacable::case;
use seacable::run::job::{self, JobEvent, Request};
use seacable::run::store::{self, RunLocation, RunWriter};
use seacable::run::{Checkpoint, ResumedRun, Run, RunState, resume_request};

/// A line that is dragged over a rough bed, snaps and is let go, so that every memory there is counts.
fn request(method: &str, duration: f64) -> Request {
    let text = format!(
        r#"
        case.title = "goes on"
        current.speed_m_per_s = 0.3
        seabed = {{ depth_m = 60.0, friction = 0.5, damping_n_s_per_m3 = 1e4 }}
        materials.rope = {{ diameter_m = 0.1, mass_kg_per_m = 20.0, ea_n = 1e6, drag_normal = 1.2, drag_tangential = 0.1, axial_damping_ratio = 0.1 }}
        line = [{{ name = "rope", material = "rope", length_m = 120.0, segments = 12 }}]
        ends.a = {{ name = "anchor", kind = "anchor", position_m = [0.0, 0.0, -60.0], release_s = 4.3 }}
        ends.b = {{ name = "ship", kind = "moving", position_m = [80.0, 0.0, 0.0], amplitude_m = [3.0, 0.0, 1.0], period_s = 3.0 }}
        solver = {{ method = "{method}", duration_s = {duration:?}, error_estimate = false }}
        output = {{ interval_s = 0.5, shape_interval_s = 1.0, response_from_s = 2.0 }}
        statistics.from_s = 1.0
        checks = [{{ kind = "fatigue", curve = "dnv-studless-chain", along = true }}]
        "#
    );
    Request {
        case: case::parse(&text, "goes_on.toml").unwrap(),
        text,
        file: "goes_on.toml".to_owned(),
        overrides: Vec::new(),
        id: "goes on".to_owned(),
    }
}

/// The same with the ship moved along a table whose velocity jumps: at 3 s and 6 s too, where the runs below stop.
fn request_by_table(method: &str, duration: f64, interpolation: &str) -> Request {
    let mut request = request(method, duration);
    let harmonic = "amplitude_m = [3.0, 0.0, 1.0], period_s = 3.0";
    let table = format!(
        r#"motion = "table", motion_file = "p.csv", motion_interpolation = "{interpolation}""#
    );
    let rows = r"time_s,x_m,y_m,z_m\n0,0,0,0\n0.7,1,0,0\n3,-2,0,1\n4.3,3,0,0\n5.5,3,0,-1\n6,2,0,1\n9,0,0,0";
    let files = format!("files.\"p.csv\".text = \"{rows}\"\n");
    assert!(request.text.contains(harmonic));
    request.text = files + &request.text.replace(harmonic, &table);
    request.case = case::parse(&request.text, "goes_on.toml").unwrap();
    request
}

fn run(request: &Request, from: Option<&ResumedRun>) -> (Run, Checkpoint) {
    let mut last = None;
    let run = job::execute_from(request, from, &AtomicBool::new(false), &mut |event| {
        if let JobEvent::Checkpoint(checkpoint) = event {
            last = Some(toml::from_str(&checkpoint).unwrap());
        }
    });
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    (run, last.unwrap())
}

/// Runs a request into a directory.
fn stored(request: &Request, from: Option<&ResumedRun>, dir: &Path) -> Run {
    let place = RunLocation::Exactly(dir.to_owned());
    let mut writer = RunWriter::begin(&place, request.initial_info(), &request.text).unwrap();
    let run = job::execute_from(request, from, &AtomicBool::new(false), &mut |event| {
        writer.event(&event).unwrap();
    });
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    writer.finish(&run).unwrap();
    run
}

fn assert_same(whole: &Run, resumed: &Run) {
    assert_eq!(resumed.history, whole.history);
    assert_eq!(resumed.shapes, whole.shapes);
    assert_eq!(resumed.profile(), whole.profile());
    assert_eq!(resumed.summary, whole.summary);
    assert!(!whole.fatigue.is_empty());
    assert_eq!(resumed.fatigue, whole.fatigue);
    assert_eq!(resumed.info.work, whole.info.work);
    assert_eq!(resumed.info.warnings, whole.info.warnings);
}

/// Whole steps end a rounding before, at and after the event.
#[test]
fn an_event_a_rounding_off_a_step_is_passed() {
    let at = 3.0 * 0.1_f64;
    for release in [at.next_down(), at, at.next_up(), at.next_up().next_up()] {
        let mut request = request("alpha", 1.0);
        request.case.solver.time_step_s = Some(0.1);
        request.case.ends.a.release_s = Some(release);
        let (run, _) = run(&request, None);
        assert!(run.info.work.steps >= 10, "{release}");
    }
}

#[test]
fn resumes_to_the_same_bits_before_and_after_an_event() {
    for method in ["alpha", "rk4", "quasi"] {
        resumes_to_the_same_bits(method, |duration| request(method, duration));
    }
}

#[test]
fn resumes_to_the_same_bits_between_and_at_kinks_of_a_table() {
    for method in ["alpha", "rk4", "quasi"] {
        for interpolation in ["linear", "monotone", "spline"] {
            resumes_to_the_same_bits(method, |duration| {
                request_by_table(method, duration, interpolation)
            });
        }
    }
}

/// Whichever of both a trial up to the later end would choose.
#[test]
fn a_resumed_run_of_auto_keeps_its_method() {
    for method in ["alpha", "rk4"] {
        let (whole, _) = run(&request(method, 8.0), None);
        let place = tempfile::tempdir().unwrap();
        let dir = place.path().join("first");
        stored(&request(method, 3.0), None, &dir);
        let (_, checkpoint) = run(&request(method, 3.0), None);
        let from = ResumedRun { checkpoint, dir };
        let (resumed, _) = run(&request("auto", 8.0), Some(&from));
        assert_eq!(resumed.info.settings.method, whole.info.settings.method);
        assert_same(&whole, &resumed);
    }
}

/// A run of 8 s, and the same stopped at 3 s and at 6 s and resumed.
fn resumes_to_the_same_bits(method: &str, request: impl Fn(f64) -> Request) {
    let (whole, _) = run(&request(8.0), None);
    for stop in [3.0, 6.0] {
        let place = tempfile::tempdir().unwrap();
        let [first, second] = ["first", "second"].map(|name| place.path().join(name));
        stored(&request(stop), None, &first);
        let from = store::resume(&first).unwrap();
        // The step that the end cuts short is taken anew.
        let behind = stop - from.checkpoint.time();
        let whole_step = from.checkpoint.whole_step_s;
        assert!((0.0..whole_step).contains(&behind), "{method}: {behind} s");
        let resumed = stored(&request(8.0), Some(&from), &second);
        assert_same(&whole, &resumed);
        assert_same(&whole, &store::read(&second).unwrap());
    }
}

/// 2.9 s are a whole number of intervals of 0.05 s but for rounding, and rows of the run go on at the times of the whole one.
#[test]
fn a_run_goes_on_in_its_output_intervals() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("first");
    let short_interval = |duration| {
        let mut request = request("alpha", duration);
        request.text = request
            .text
            .replace("interval_s = 0.5,", "interval_s = 0.05,");
        request.case = case::parse(&request.text, "goes_on.toml").unwrap();
        request
    };
    stored(&short_interval(2.9), None, &dir);
    let (request, from) = resume_request(&dir, Some(8.0)).unwrap();
    let (resumed, _) = run(&request, from.as_ref());
    let (whole, _) = run(&short_interval(8.0), None);
    assert_eq!(resumed.history.time, whole.history.time);
    assert!(resume_request::<case::Case>(&dir, Some(8.02)).is_err());
}

/// Stopped while it looks for its equilibrium it has no rows, wrong ones least of all, and is begun anew.
#[test]
fn a_run_stopped_at_rest_begins_anew() {
    for method in ["static", "alpha"] {
        let place = tempfile::tempdir().unwrap();
        let dir = place.path().join("stopped");
        let request = request(method, 2.0);
        let computed = |request, stop| job::execute(request, &AtomicBool::new(stop), &mut |_| {});
        let whole = computed(&request, false);
        assert_eq!(whole.info.state, RunState::Done);
        let at = RunLocation::Exactly(dir.clone());
        let mut writer = RunWriter::begin(&at, whole.info.clone(), &request.text).unwrap();
        let stopped = job::execute(&request, &AtomicBool::new(true), &mut |event| {
            writer.event(&event).unwrap();
        });
        assert_eq!(stopped.info.state, RunState::Cancelled);
        assert!(stopped.info.failure.is_none() && stopped.history.time.is_empty());
        writer.finish(&stopped).unwrap();
        let (again, from) = resume_request(&dir, None).unwrap();
        assert!(from.is_none());
        assert_eq!(whole.summary, computed(&again, false).summary);
    }
}

/// Killed after it had recorded more than its last checkpoint: everything after that is computed again.
#[test]
fn a_killed_run_resumes_from_its_last_checkpoint() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("killed");
    let whole = request("alpha", 8.0);
    let (run_whole, _) = run(&whole, None);
    let (_, checkpoint) = run(&request("alpha", 3.0), None);
    let info = run_whole.info.clone();
    let mut writer =
        RunWriter::begin(&RunLocation::Exactly(dir.clone()), info, &whole.text).unwrap();
    job::execute(&whole, &AtomicBool::new(false), &mut |event| {
        let late = matches!(&event, JobEvent::Frame(frame) if frame.time > 5.0);
        let checkpoint = matches!(event, JobEvent::Checkpoint(_));
        if !late && !checkpoint {
            writer.event(&event).unwrap();
        }
    });
    let checkpoint = toml::to_string(&checkpoint).unwrap();
    writer.event(&JobEvent::Checkpoint(checkpoint)).unwrap();
    assert!(store::is_locked(&dir));
    let refused = resume_request::<case::Case>(&dir, None).unwrap_err();
    assert!(refused.contains("still being computed"), "{refused}");
    let reported = store::read(&dir).unwrap().info.warnings;
    assert!(
        reported.iter().any(|w| w.contains("still computing it")),
        "{reported:?}"
    );
    // A writer that is gone holds nothing, however it went.
    drop(writer);
    assert!(!store::is_locked(&dir));
    let reported = store::read(&dir).unwrap().info.warnings;
    assert!(
        reported
            .iter()
            .any(|w| w.contains("was stopped while it computed")),
        "{reported:?}"
    );
    let (partial, from) = (store::read(&dir).unwrap(), store::resume(&dir).unwrap());
    assert_eq!(partial.info.state, RunState::Partial);
    assert_eq!(partial.history.time.last(), Some(&5.0));
    assert_eq!(from.checkpoint.place.time, 3.0);
    let (resumed, _) = run(&whole, Some(&from));
    assert_same(&run_whole, &resumed);
}

/// A record that does not reach to where the run is to go on is no record of it.
#[test]
fn a_record_cut_short_is_told() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("cut");
    stored(&request("alpha", 3.0), None, &dir);
    let history = dir.join("history.csv");
    let text = std::fs::read_to_string(&history).unwrap();
    std::fs::write(&history, &text[..text.len() / 2]).unwrap();
    let refused = store::resume(&dir).unwrap_err().to_string();
    assert!(
        refused.contains("history.csv cannot be read: it was changed or cut"),
        "{refused}"
    );
    // Sealed anew it still lacks rows.
    let checkpoint = std::fs::read_to_string(dir.join("checkpoint.toml")).unwrap();
    reseal(&dir, unsealed(&checkpoint));
    let from = store::resume(&dir).unwrap();
    let run = job::execute_from(
        &request("alpha", 8.0),
        Some(&from),
        &AtomicBool::new(false),
        &mut |_| {},
    );
    assert_eq!(run.info.state, RunState::Failed);
    let why = run.info.failure.unwrap();
    assert!(
        why.contains("history.csv") && why.contains("middle of a line"),
        "{why}"
    );
}

/// A checkpoint belongs to its case: one of a case that was edited since is refused in words, whatever was edited.
#[test]
fn a_checkpoint_of_an_edited_case_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("run");
    stored(&request("alpha", 3.0), None, &dir);
    let case = dir.join("case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    let resume = |old: &str, new: &str| {
        assert!(text.contains(old));
        std::fs::write(&case, text.replace(old, new)).unwrap();
        resume_request(&dir, Some(8.0))
    };
    for (old, new, table) in [
        ("ea_n = 1e6", "ea_n = 1.1e6", "[materials]"),
        ("friction = 0.5", "friction = 0.4", "[seabed]"),
        ("period_s = 3.0", "period_s = 3.1", "[ends]"),
        ("\"alpha\"", "\"alpha\", rho_inf = 0.3", "[solver]"),
        ("current.speed_m_per_s = 0.3", "", "[current]"),
    ] {
        let refused = resume(old, new).unwrap_err();
        assert!(
            refused.contains(&format!("the case was changed in {table} since")),
            "{refused}"
        );
    }
    for (old, new) in [
        ("goes on", "goes on and on"),
        ("duration_s = 3.0", "duration_s = 20.0"),
        ("interval_s = 0.5", "interval_s = 0.25"),
    ] {
        let refused = resume(old, new).unwrap_err();
        assert!(
            refused.contains("it is not the case that the checkpoint beside it belongs to"),
            "{refused}"
        );
    }
    let (request_as_before, from) = resume("goes on", "goes on").unwrap();
    let from = from.unwrap();
    let (_, checkpoint) = run(&request_as_before, Some(&from));
    assert_eq!(checkpoint.case, from.checkpoint.case);
    // The library holds the checkpoint against the case as the program does.
    let mut other = request("alpha", 8.0);
    other.case.environment.water_density_kg_per_m3 = 1000.0;
    let never = AtomicBool::new(false);
    let failed = job::execute_from(&other, Some(&from), &never, &mut |_| {});
    let why = failed.info.failure.unwrap();
    assert!(why.contains("changed in [environment]"), "{why}");
}

/// Paths of all lists of more than one entry in a table.
fn lists(table: &toml::Table, path: &[String], found: &mut Vec<Vec<String>>) {
    for (key, value) in table {
        let path = [path, std::slice::from_ref(key)].concat();
        match value {
            toml::Value::Array(list) if list.len() > 1 => found.push(path),
            toml::Value::Table(inner) => lists(inner, &path, found),
            _ => {}
        }
    }
}

/// A checkpoint with one list shorter by an entry is refused in words, or does not matter.
#[test]
fn a_checkpoint_that_is_damaged_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("run");
    stored(&request("alpha", 5.0), None, &dir);
    let file = dir.join("checkpoint.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let whole: toml::Table = unsealed(&text).parse().unwrap();
    let mut found = Vec::new();
    lists(&whole, &[], &mut found);
    assert!(found.len() > 15, "{found:?}");
    let mut refused = 0;
    for path in found {
        let mut damaged = whole.clone();
        let mut place = &mut damaged;
        for key in &path[..path.len() - 1] {
            place = place[key].as_table_mut().unwrap();
        }
        place[&path[path.len() - 1]].as_array_mut().unwrap().pop();
        reseal(&dir, &toml::to_string(&damaged).unwrap());
        let Ok(from) = store::resume(&dir) else {
            refused += 1;
            continue;
        };
        let request = request("alpha", 8.0);
        let never = AtomicBool::new(false);
        let run = job::execute_from(&request, Some(&from), &never, &mut |_| {});
        if let Some(why) = run.info.failure {
            assert!(
                why.contains("does not belong to this case"),
                "{path:?}: {why}"
            );
            refused += 1;
        }
    }
    assert!(refused > 12, "{refused}");
}
