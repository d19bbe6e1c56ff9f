//! Runs stored by other versions of the program: they open and report; they resume, or say which version wrote them.
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use crate::reseal::{reseal, unsealed};
use seacable::case::Case;
use seacable::chart::Glyphs;
use seacable::report::text;
use seacable::run::store::{RunLocation, RunWriter, StoreError, read};
use seacable::run::{Run, job, resume_request};
use seacable::{case, reference};

const TABLES: [&str; 7] = [
    "channels.csv",
    "errors.csv",
    "history.csv",
    "profile.csv",
    "ropes.csv",
    "shapes.csv",
    "summary.csv",
];

/// A run that version 0.1.0 stored, of a line with every kind of table.
fn stored() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/run-0.1.0")
}

/// The same case computed and stored by this version.
fn computed() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(stored().join("case.toml")).unwrap();
    let request = job::Request {
        case: case::parse(&text, "hanging.toml").unwrap(),
        text,
        file: "hanging.toml".to_owned(),
        overrides: Vec::new(),
        id: "hanging".to_owned(),
    };
    let place = RunLocation::Exactly(dir.path().join("run"));
    let mut writer = RunWriter::begin(&place, request.initial_info(), &request.text).unwrap();
    let run = job::execute(&request, &AtomicBool::new(false), &mut |event| {
        writer.event(&event).unwrap();
    });
    writer.finish(&run).unwrap();
    dir
}

/// A copy of a stored run, with the files changed.
fn changed(run: &Path, change: impl Fn(&str, String) -> String) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    for entry in fs::read_dir(run).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let text = fs::read_to_string(run.join(&name)).unwrap();
        fs::write(dir.path().join(&name), change(&name, text)).unwrap();
    }
    dir
}

/// That the run in this directory is not resumed, since its history was changed; sealed anew, it is the run that was never
/// interrupted.
fn assert_resumes(dir: &Path) {
    let refused = resume_request::<Case>(dir, Some(5.0)).unwrap_err();
    assert!(
        refused.contains("history.csv cannot be read: it was changed"),
        "{refused}"
    );
    let checkpoint = fs::read_to_string(dir.join("checkpoint.toml")).unwrap();
    reseal(dir, unsealed(&checkpoint));
    let (request, from) = resume_request::<Case>(dir, Some(5.0)).unwrap();
    let never = AtomicBool::new(false);
    let resumed = job::execute_from(&request, from.as_ref(), &never, &mut |_| ());
    let whole = job::execute(&request, &never, &mut |_| ());
    assert_eq!(resumed.history, whole.history);
    assert_eq!(resumed.shapes, whole.shapes);
    assert_eq!(resumed.profile(), whole.profile());
    assert_eq!(resumed.summary, whole.summary);
}

/// That everything but the warnings is as it was stored.
fn assert_same(run: &Run) {
    let expected = read(&stored()).unwrap();
    assert_eq!(run.history, expected.history);
    assert_eq!(run.shapes, expected.shapes);
    assert_eq!(run.profiles, expected.profiles);
    assert_eq!(run.summary, expected.summary);
}

#[test]
fn a_run_of_the_version_before_opens_and_reports_and_says_why_it_does_not_resume() {
    let run = read(&stored()).unwrap();
    assert_eq!(run.info.version, "0.1.0");
    assert_eq!(run.info.warnings.len(), 1, "{:?}", run.info.warnings);
    assert_eq!(run.history.time.len(), 17);
    assert_eq!(run.history.channels.len(), 19);
    assert_eq!(
        run.history.channel("stiffness_k[upper.b]").unwrap().unit(),
        "-"
    );
    assert_eq!(run.shapes.len(), 9);
    assert_eq!(run.profile().moment.len(), 9);
    assert_eq!(run.profile().wkb_number.len(), 9);
    assert!(run.profile().towards_a.is_empty());
    assert_eq!(run.profile().ropes.stiffness_max.len(), 4);
    let greatest = run.quantity("tension_n[anchor|lower].max").unwrap();
    assert_eq!(greatest.value, 1_631_483.536_216_028_5);
    assert_eq!(greatest.mesh_error, Some(6.225_505_437_934_771));
    let lines = fs::read_to_string(stored().join("summary.csv")).unwrap();
    assert_eq!(run.summary.len(), lines.lines().count() - 1);

    let case = case::parse(&run.case_text, "hanging.toml").unwrap();
    let rows = reference::rows_of_run(&run, &case);
    let report = text::report(&run, &case, &rows, Glyphs::Ascii);
    assert!(report.contains(&run.info.title) && report.contains("mean_load_percent.max"));
    let refused = resume_request::<Case>(&stored(), Some(5.0)).unwrap_err();
    assert!(refused.contains("Version 0.1.0 wrote it"), "{refused}");
}

#[test]
fn a_column_more_is_left_out() {
    let more = |name: &str, text: String| {
        if !TABLES.contains(&name) {
            return text;
        }
        let mut lines = text.lines().map(|line| line.split_once(',').unwrap());
        let (first, rest) = lines.next().unwrap();
        let head = format!("{first},heat_w[buoy],{rest}\n");
        let rows = lines.map(|(first, rest)| format!("{first},7,{rest}\n"));
        head + &rows.collect::<String>()
    };
    let dir = changed(&stored(), more);
    let run = read(dir.path()).unwrap();
    assert_same(&run);
    for name in TABLES {
        let note = |w: &String| w.starts_with(name) && w.contains("heat_w[buoy]");
        assert!(
            run.info.warnings.iter().any(note),
            "{name}: {:?}",
            run.info.warnings
        );
    }
    let new = computed();
    assert_resumes(changed(&new.path().join("run"), more).path());
}

#[test]
fn columns_in_another_order_and_one_less_are_read() {
    // Swaps the first two columns, and takes the numerical error of the response away.
    let less = |name: &str, text: String| {
        if !TABLES.contains(&name) || name == "shapes.csv" {
            return text;
        }
        let swapped = text.lines().map(|line| {
            let mut fields: Vec<&str> = line.split(',').collect();
            fields.swap(0, 1);
            if name == "profile.csv" {
                fields.remove(19);
            }
            fields.join(",") + "\n"
        });
        swapped.collect()
    };
    let dir = changed(&stored(), less);
    let run = read(dir.path()).unwrap();
    let mut expected = read(&stored()).unwrap();
    assert_eq!(expected.profile().rms_error.len(), 9);
    expected.profiles[0].rms_error.clear();
    assert_eq!(run, expected);
    let new = computed();
    assert_resumes(changed(&new.path().join("run"), less).path());
}

#[test]
fn what_cannot_be_read_says_which_version_wrote_it() {
    let newer = |text: String| text.replace("\"0.1.0\"", "\"9.1.0\"");
    let dir = changed(&stored(), |name, text| match name {
        "run.toml" => newer(text),
        "summary.csv" => text.replace("quantity,", "name,"),
        _ => text,
    });
    let warnings = read(dir.path()).unwrap().info.warnings;
    assert!(warnings.last().unwrap().contains("9.1.0"), "{warnings:?}");

    let dir = changed(&stored(), |name, text| match name {
        "run.toml" => newer(text).replace("state = \"done\"", "state = \"paused\""),
        _ => text,
    });
    let error = read(dir.path()).unwrap_err();
    assert!(matches!(error, StoreError::Damaged { .. }));
    assert!(error.to_string().contains("9.1.0"), "{error}");

    let dir = changed(&stored(), |name, text| match name {
        "run.toml" => newer(text),
        "checkpoint.toml" => text.replace("whole_step_s", "step_s"),
        _ => text,
    });
    let error = resume_request::<Case>(dir.path(), Some(6.0)).unwrap_err();
    assert!(error.contains("9.1.0"), "{error}");
}
