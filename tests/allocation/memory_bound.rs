//! What a run takes in memory does not grow with the time it simulates, nor does reading it back from disk.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use crate::small::SMALL;
use allocation_counter::measure;
use seacable::case::{self, edit};
use seacable::chart::Glyphs;
use seacable::reference;
use seacable::report::text;
use seacable::run::job::{self, Request};
use seacable::run::store::{self, RunLocation, RunWriter};
use seacable::run::{Run, RunState};

/// A pendulum for so many output times, each a step of the solver.
fn request(rows: u32) -> Request {
    let duration = f64::from(rows) * 0.005;
    let mut text = SMALL.to_owned();
    for (key, value) in [
        ("solver.method", "rk4".to_owned()),
        ("solver.time_step_s", "0.005".to_owned()),
        ("solver.duration_s", format!("{duration:?}")),
        ("solver.error_estimate", "false".to_owned()),
        ("output.interval_s", "0.005".to_owned()),
        ("output.shape_interval_s", "0.005".to_owned()),
    ] {
        text = edit::set(&text, key, &value).unwrap();
    }
    let case = case::parse(&text, "long.toml").unwrap();
    Request {
        case,
        text,
        file: "long.toml".to_owned(),
        overrides: Vec::new(),
        id: "long".to_owned(),
    }
}

/// Computes into a directory; the run, and the most memory it ever held \[bytes\].
fn computed(request: &Request, dir: &Path) -> (Run, u64) {
    let mut run = None;
    let info = measure(|| {
        let mut writer: Option<RunWriter> = None;
        let computed = job::execute(request, &AtomicBool::new(false), &mut |event| {
            let writer = writer.get_or_insert_with(|| {
                let place = RunLocation::Exactly(dir.to_owned());
                RunWriter::begin(&place, request.initial_info(), &request.text).unwrap()
            });
            writer.event(&event).unwrap();
        });
        writer.unwrap().finish(&computed).unwrap();
        run = Some(computed);
    });
    let run = run.unwrap();
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    (run, info.bytes_max)
}

#[test]
fn twice_the_rows_take_no_more_memory() {
    let place = tempfile::tempdir().unwrap();
    let rows = [60_000_u32, 120_000];
    let mut computing = Vec::new();
    let mut reading = Vec::new();
    for count in rows {
        let request = request(count);
        let dir = place.path().join(count.to_string());
        let (run, bytes) = computed(&request, &dir);
        computing.push(bytes);
        let info = measure(|| {
            let back = store::read(&dir).unwrap();
            let rows = reference::rows_of_run(&back, &request.case);
            let report = text::report(&back, &request.case, &rows, Glyphs::Braille);
            assert!(report.contains("Tension at the joints"));
            // What is kept of it in memory is the same, computed or read.
            assert_eq!(back.history, run.history);
            assert_eq!(back.shapes, run.shapes);
        });
        reading.push(info.bytes_max);
        let written = std::fs::read_to_string(dir.join("history.csv")).unwrap();
        assert_eq!(written.lines().count(), count as usize + 2);
        let kept = run.history.time.len();
        assert!(kept < 50_000, "{kept} rows of {count} in memory");
        assert_eq!(run.history.time.last(), Some(&run.info.settings.duration_s));
    }
    for (what, bytes) in [("computing", &computing), ("reading", &reading)] {
        let growth = bytes[1] as f64 / bytes[0] as f64;
        assert!(growth < 1.1, "{what}: {bytes:?} bytes");
    }
}
