//! Runs on disk: what is written is what is read, whatever happens in between.

use crate::kills::RESULTS;
use crate::sample;
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
    thread,
    time::Duration,
};

use seacable::run::{
    LineShape, OutputFrame, Progress, Run, RunState,
    event::JobEvent,
    store::{RunLocation, RunWriter, StoreError, list, read, save},
};

fn saved(root: &Path) -> PathBuf {
    save(&RunLocation::Below(root.to_owned()), &sample::run()).unwrap()
}

/// The shape at the time of a row.
fn shape(run: &Run, row: usize) -> LineShape {
    LineShape {
        time: run.history.time[row],
        ..run.shapes[0].clone()
    }
}

/// A writer that has been given this many rows.
fn begun(root: &Path, rows: usize) -> RunWriter {
    let run = sample::run();
    let place = RunLocation::Below(root.to_owned());
    let mut writer = RunWriter::begin(&place, run.info.clone(), &run.case_text).unwrap();
    give(&mut writer, rows);
    writer
}

/// Gives a writer the channels and this many rows.
fn give(writer: &mut RunWriter, rows: usize) {
    let run = sample::run();
    let channels: Vec<_> = run.history.channels.iter().map(|c| c.id.clone()).collect();
    writer
        .event(&JobEvent::Started {
            channels,
            lines: Vec::new(),
        })
        .unwrap();
    for i in 0..rows {
        let frame = OutputFrame {
            time: run.history.time[i],
            values: run.history.channels.iter().map(|c| c.values[i]).collect(),
            shapes: (i % 10 == 0).then(|| shape(&run, i)).into_iter().collect(),
            progress: Progress::default(),
        };
        writer.event(&JobEvent::Frame(Box::new(frame))).unwrap();
    }
}

/// The sample as it reads once this many rows were streamed: the record is what was streamed, not what is kept of it in memory.
fn streamed(id: &str, rows: usize) -> Run {
    let mut expected = sample::run();
    expected.info.id = id.to_owned();
    expected.history.time.truncate(rows);
    for channel in &mut expected.history.channels {
        channel.values.truncate(rows);
    }
    let shapes = (0..rows).step_by(10).map(|i| shape(&expected, i));
    expected.shapes = shapes.collect();
    expected
}

#[test]
fn a_run_reads_back_to_the_same_bits() {
    let root = tempfile::tempdir().unwrap();
    let dir = saved(root.path());
    let mut expected = sample::run();
    expected.info.id = dir.file_name().unwrap().to_string_lossy().into_owned();
    let back = read(&dir).unwrap();
    assert_eq!(back, expected);
    // `==` takes -0 for 0, the text of all numbers does not.
    assert_eq!(format!("{back:?}"), format!("{expected:?}"));
}

#[test]
fn files_begin_with_the_promised_columns() {
    let root = tempfile::tempdir().unwrap();
    let dir = saved(root.path());
    let head = |name: &str| {
        let text = fs::read_to_string(dir.join(name)).unwrap();
        text.lines().next().unwrap().to_owned()
    };
    assert_eq!(head("summary.csv"), "quantity,value,unit,error_estimate");
    assert_eq!(
        head("errors.csv"),
        "quantity,unit,time_error,mesh_error,least,greatest"
    );
    assert_eq!(
        head("history.csv"),
        "time_s,tension_n[wire|payload],\"z_m[pay,load]\""
    );
    assert_eq!(
        head("profile.csv"),
        "node,arc_m,x_m,y_m,z_m,tension_n,tension_min_n,tension_max_n,z_min_m,z_max_m"
    );
    assert_eq!(
        head("shapes.csv"),
        "time_s,node,x_m,y_m,z_m,tension_n,curvature_per_m,height_m"
    );
    assert_eq!(
        fs::read_to_string(dir.join("case.toml")).unwrap(),
        sample::run().case_text
    );
}

#[test]
fn a_run_streamed_and_finished_is_the_run() {
    let root = tempfile::tempdir().unwrap();
    let writer = begun(root.path(), 30);
    let expected = streamed(writer.id(), 30);
    let dir = writer.finish(&sample::run()).unwrap();
    assert_eq!(read(&dir).unwrap(), expected);
    // Nothing but the run is left behind.
    assert_eq!(fs::read_dir(&dir).unwrap().count(), 8);
}

#[test]
fn a_run_of_a_moment_is_there_at_once_or_not_at_all() {
    let root = tempfile::tempdir().unwrap();
    let run = sample::run();
    let begin = |name: &str| {
        let dir = root.path().join("runs").join(name);
        let writer = RunWriter::begin_late(&dir, run.info.clone(), &run.case_text);
        (dir, writer)
    };
    let entries = || fs::read_dir(root.path().join("runs")).unwrap().count();
    let checkpoint = JobEvent::Checkpoint("a = 1\n".to_owned());

    let (dir, writer) = begin("whole");
    let mut writer = writer.unwrap();
    give(&mut writer, 30);
    writer.event(&checkpoint).unwrap();
    assert_eq!((writer.id(), entries()), ("whole", 0));
    assert_eq!(writer.finish(&run).unwrap(), dir);
    assert_eq!(read(&dir).unwrap(), streamed("whole", 30));
    let files = fs::read_dir(&dir).unwrap().count();
    assert_eq!((entries(), files), (1, 9));
    assert!(matches!(begin("whole").1, Err(StoreError::Taken(_))));

    // One that is dropped, as by a kill, leaves nothing.
    let (_, writer) = begin("killed");
    give(&mut writer.unwrap(), 30);
    assert_eq!(entries(), 1);

    // One that takes a second is there from then on, and has the same files.
    let (long, writer) = begin("long");
    let mut writer = writer.unwrap();
    give(&mut writer, 30);
    writer.event(&checkpoint).unwrap();
    thread::sleep(Duration::from_millis(1050));
    writer.event(&JobEvent::Estimating).unwrap();
    assert_eq!(read(&long).unwrap().info.state, RunState::Partial);
    assert_eq!(read(&long).unwrap().history.time.len(), 30);
    writer.finish(&run).unwrap();
    assert_eq!(read(&long).unwrap(), streamed("long", 30));
    for file in fs::read_dir(&dir).unwrap() {
        let name = file.unwrap().file_name();
        let [one, other] = [&dir, &long].map(|dir| fs::read_to_string(dir.join(&name)).unwrap());
        assert_eq!(one.replace("whole", "long"), other, "{name:?}");
    }
}

#[test]
fn a_run_that_never_finished_reads_as_partial() {
    let root = tempfile::tempdir().unwrap();
    let mut writer = begun(root.path(), 30);
    writer.flush().unwrap();
    let back = read(writer.dir()).unwrap();
    assert_eq!(back.info.state, RunState::Partial);
    assert_eq!(back.history.time.len(), 30);
    assert_eq!(back.shapes.len(), 3);
    assert_eq!(back.history.channels[0].unit(), "N");
    let values = &back.history.channels[0].values;
    let peak = values.iter().copied().fold(f64::MIN, f64::max);
    assert_eq!(back.history.channels[0].peak.0.to_bits(), peak.to_bits());
    assert!(
        back.info.warnings.last().unwrap().contains("partial"),
        "{:?}",
        back.info.warnings
    );
}

#[test]
fn a_run_that_only_just_began_reads_as_partial() {
    let root = tempfile::tempdir().unwrap();
    let run = sample::run();
    let writer = RunWriter::begin(
        &RunLocation::Below(root.path().to_owned()),
        run.info.clone(),
        &run.case_text,
    )
    .unwrap();
    let back = read(writer.dir()).unwrap();
    assert_eq!(back.info.state, RunState::Partial);
    assert_eq!(back.case_text, run.case_text);
    assert!(back.history.time.is_empty());
}

#[test]
fn a_history_cut_anywhere_reads_up_to_the_cut() {
    let root = tempfile::tempdir().unwrap();
    let dir = saved(root.path());
    let whole = read(&dir).unwrap();
    let file = dir.join("history.csv");
    let bytes = fs::read(&file).unwrap();
    for cut in 0..bytes.len() {
        fs::write(&file, &bytes[..cut]).unwrap();
        let back = read(&dir).unwrap();
        let n = back.history.time.len();
        assert_eq!(back.history.time[..], whole.history.time[..n]);
        let lines = bytes[..cut].iter().filter(|b| **b == b'\n').count();
        assert_eq!(n, lines.saturating_sub(1), "cut at byte {cut}");
        let reported = back.info.warnings.iter().any(|w| w.contains("history.csv"));
        let clean = cut > 0 && bytes[cut - 1] == b'\n';
        assert_eq!(
            reported, !clean,
            "cut at byte {cut}: {:?}",
            back.info.warnings
        );
    }
}

#[test]
fn damage_is_reported_by_file_and_line() {
    let root = tempfile::tempdir().unwrap();
    let check = |name: &str, damage: &dyn Fn(String) -> String, expected: &str| {
        let dir = saved(root.path());
        let text = fs::read_to_string(dir.join(name)).unwrap();
        fs::write(dir.join(name), damage(text)).unwrap();
        let back = read(&dir).unwrap();
        assert_eq!(back.info.state, RunState::Done);
        assert!(
            back.info.warnings.iter().any(|w| w.contains(expected)),
            "{name}: {:?}",
            back.info.warnings
        );
    };
    check(
        "history.csv",
        &|t| t.replacen("\n0.1,", "\nabc,", 1),
        "history.csv, line 3",
    );
    for wild in ["inf", "-inf", "NaN"] {
        check(
            "history.csv",
            &|t| t.replacen("\n0.1,", &format!("\n{wild},"), 1),
            "history.csv, line 3 holds something that is not a finite number",
        );
    }
    check(
        "summary.csv",
        &|t| t.replacen(",2020000,", ",inf,", 1),
        "summary.csv, line 3 holds something that is not a finite number",
    );
    check(
        "history.csv",
        &|t| t.replacen("\n0.1,", "\n0.1,7,", 1),
        "history.csv, line 3: 4 fields where 3",
    );
    check("history.csv", &|t| t.replacen("time_s", "t", 1), "time_s");
    check(
        "summary.csv",
        &|t| t.replacen("value", "wert", 1),
        "summary.csv has the columns",
    );
    check("summary.csv", &|_| String::new(), "summary.csv is empty");
    check(
        "summary.csv",
        &|t| t.replacen(",2020000,", ",many,", 1),
        "summary.csv, line 3",
    );
    check(
        "profile.csv",
        &|t| t.replacen("\n1,", "\none,", 1),
        "profile.csv, line 3",
    );
    check(
        "shapes.csv",
        &|t| t.replacen("\n0,1,", "\n0,?,", 1),
        "shapes.csv, line 3",
    );
    for name in [
        "case.toml",
        "history.csv",
        "summary.csv",
        "errors.csv",
        "channels.csv",
        "shapes.csv",
    ] {
        let dir = saved(root.path());
        fs::remove_file(dir.join(name)).unwrap();
        let back = read(&dir).unwrap();
        assert!(
            back.info.warnings.iter().any(|w| w.contains(name)),
            "{:?}",
            back.info.warnings
        );
    }
}

#[test]
fn without_run_toml_there_is_no_run() {
    let root = tempfile::tempdir().unwrap();
    assert!(matches!(
        read(&root.path().join("nowhere")),
        Err(StoreError::NotFound(_))
    ));
    assert!(matches!(read(root.path()), Err(StoreError::NotARun(_))));

    let dir = saved(root.path());
    assert!(matches!(
        read(&dir.join("case.toml")),
        Err(StoreError::NotARun(_))
    ));
    let text = fs::read_to_string(dir.join("run.toml")).unwrap();
    let (_, rest) = text.split_once("duration_s = ").unwrap();
    let duration = rest.lines().next().unwrap();
    let infinite = text.replace(&format!("duration_s = {duration}"), "duration_s = inf");
    for damaged in [
        &infinite,
        &text[..text.len() / 2],
        "",
        "state = \"asleep\"",
        "\0\0\0",
    ] {
        fs::write(dir.join("run.toml"), damaged).unwrap();
        let error = read(&dir).unwrap_err();
        assert!(matches!(error, StoreError::Damaged { .. }), "{error}");
        assert!(error.to_string().contains("run.toml"), "{error}");
    }
    fs::write(dir.join("run.toml"), [0xff, 0xfe]).unwrap();
    assert!(read(&dir).unwrap_err().to_string().contains("UTF-8"));
}

#[test]
fn names_never_collide() {
    let root = tempfile::tempdir().unwrap();
    let threads: Vec<_> = (0..8)
        .map(|_| {
            let root = root.path().to_owned();
            thread::spawn(move || (0..10).map(|_| saved(&root)).collect::<Vec<_>>())
        })
        .collect();
    let dirs: Vec<PathBuf> = threads
        .into_iter()
        .flat_map(|t| t.join().unwrap())
        .collect();
    let different: BTreeSet<_> = dirs.iter().collect();
    assert_eq!(different.len(), 80);
    let visible = fs::read_dir(root.path()).unwrap().count();
    assert_eq!(visible, 80, "nothing hidden is left behind");
}

#[test]
fn a_chosen_directory_must_be_new_or_empty() {
    let root = tempfile::tempdir().unwrap();
    let dir = root.path().join("a").join("b");
    let place = RunLocation::Exactly(dir.clone());
    assert_eq!(save(&place, &sample::run()).unwrap(), dir);
    assert_eq!(read(&dir).unwrap().info.id, "b");
    assert!(matches!(
        save(&place, &sample::run()),
        Err(StoreError::Taken(_))
    ));

    let empty = root.path().join("empty");
    fs::create_dir(&empty).unwrap();
    save(&RunLocation::Exactly(empty), &sample::run()).unwrap();

    let file = root.path().join("file");
    fs::write(&file, "x").unwrap();
    assert!(matches!(
        save(&RunLocation::Exactly(file), &sample::run()),
        Err(StoreError::Taken(_))
    ));
}

#[test]
fn the_list_is_newest_first_and_shows_damaged_runs() {
    let root = tempfile::tempdir().unwrap();
    let with = |started: &str, name: &str| {
        let mut run = sample::run();
        started.clone_into(&mut run.info.started);
        save(&RunLocation::Exactly(root.path().join(name)), &run).unwrap()
    };
    with("2026-11-20T00:00:00Z", "old");
    with("2026-11-22T00:00:00Z", "new");
    with("2026-11-21T00:00:00Z", "middle-2");
    with("2026-11-21T00:00:00Z", "middle-10");
    fs::write(
        with("2027-01-01T00:00:00Z", "damaged").join("run.toml"),
        "?",
    )
    .unwrap();
    fs::create_dir(root.path().join("no run")).unwrap();
    fs::write(root.path().join("file"), "x").unwrap();

    let entries = list(root.path()).unwrap();
    let names: Vec<_> = entries
        .iter()
        .map(|e| e.dir.file_name().unwrap().to_string_lossy().into_owned())
        .collect();
    assert_eq!(names, ["new", "middle-10", "middle-2", "old", "damaged"]);
    assert!(entries[4].info.is_err());
    assert!(list(&root.path().join("nowhere")).unwrap().is_empty());
}

#[test]
fn a_kill_between_any_two_files_of_the_end_leaves_a_partial_run() {
    let root = tempfile::tempdir().unwrap();
    let finished = saved(root.path());
    let mut writer = begun(root.path(), 30);
    writer.flush().unwrap();
    let dir = writer.dir().to_owned();
    for name in RESULTS {
        // A kill while the next file was being written beside its name.
        fs::write(dir.join(format!(".{name}.new")), "half a fi").unwrap();
        assert_eq!(read(&dir).unwrap().info.state, RunState::Partial);
        fs::remove_file(dir.join(format!(".{name}.new"))).unwrap();
        fs::copy(finished.join(name), dir.join(name)).unwrap();
        let back = read(&dir).unwrap();
        assert_eq!(back.info.state, RunState::Partial);
        assert!(back.history.time.len() >= 30);
    }
    fs::copy(finished.join("run.toml"), dir.join("run.toml")).unwrap();
    assert_eq!(read(&dir).unwrap(), read(&finished).unwrap());
}
