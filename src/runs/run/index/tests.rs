use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::*;
use crate::run::store::{self, RunLocation};
use crate::run::{History, Run, RunInfo};

const FILE: &str = "a.toml";

/// A stored run of a case with this current.
fn stored(root: &Path, name: &str, speed: f64, steps: u64) {
    let mut run = Run {
        info: RunInfo {
            case_file: FILE.to_owned(),
            state: RunState::Done,
            started: format!("2026-11-22T00:00:00Z {name}"),
            overrides: vec![format!("current.speed_m_per_s={speed}")],
            ..info()
        },
        case_text: format!("[current]\nspeed_m_per_s = {speed}\n[solver]\nmethod = 'alpha'\n"),
        history: History::default(),
        shapes: Vec::new(),
        profiles: Vec::new(),
        summary: Vec::new(),
        fatigue: Vec::new(),
    };
    run.info.work.steps = steps;
    store::save(&RunLocation::Exactly(root.join(name)), &run).unwrap();
    let summary = format!(
        "quantity,value,unit,error_estimate\nmax,{},N,0.5\n",
        speed * 10.0
    );
    fs::write(root.join(name).join("summary.csv"), summary).unwrap();
}

fn info() -> RunInfo {
    let text = "id = ''\ntitle = ''\ncase_file = ''\nstate = 'done'\nversion = ''\nstarted = ''\noverrides = []\nwarnings = []
        [settings]\nmethod = 'alpha'\nduration_s = 1.0\ntime_step_s = 1.0\ntime_step_automatic = false\nnodes = 3
        output_interval_s = 1.0\nerror_method = ''
        [work]\nsteps = 1\nrejections = 0\niterations = 0\nevaluations = 0
        [cost]\ncpu_s = 0.0\nwall_s = 0.0\ncompanions_wall_s = 0.0\n";
    toml::from_str(text).unwrap()
}

struct Place {
    dir: tempfile::TempDir,
}

impl Place {
    fn new() -> Self {
        let dir = tempfile::tempdir().unwrap();
        for number in 0..5 {
            let name = format!("a-{number}");
            stored(&dir.path().join("runs"), &name, f64::from(number), 10);
        }
        Self { dir }
    }

    fn root(&self) -> PathBuf {
        self.dir.path().join("runs")
    }

    fn open(&self) -> RunIndex {
        RunIndex::open(&self.root(), Some(&self.dir.path().join("cache"))).unwrap()
    }
}

fn synced(index: &mut RunIndex) -> SyncProgress {
    index.sync(&AtomicBool::new(false), &mut |_| {}).unwrap()
}

fn names(index: &RunIndex) -> Vec<String> {
    let rows = index.rows(&[FILE.to_owned()], 0).unwrap();
    rows.changed.into_iter().map(|run| run.name).collect()
}

/// The speeds and results of all runs, through the columns.
fn table(index: &RunIndex) -> Vec<(String, Option<String>, Option<f64>)> {
    let rows = index.rows(&[FILE.to_owned()], 0).unwrap();
    let columns = index.columns(FILE, &["max".to_owned()]).unwrap();
    let speed = columns
        .inputs
        .iter()
        .find(|c| c.key == "current.speed_m_per_s");
    let row = |run: &IndexedRun| {
        let speed = speed
            .and_then(|c| c.value_in_run(run.id))
            .map(str::to_owned);
        let max = columns.results[0]
            .result_in_run(run.id)
            .map(|result| result.value);
        (run.name.clone(), speed, max)
    };
    rows.changed.iter().map(row).collect()
}

#[test]
fn what_differs_among_runs_becomes_columns() {
    let place = Place::new();
    let mut index = place.open();
    assert!(names(&index).is_empty());
    assert_eq!(synced(&mut index), SyncProgress { done: 5, all: 5 });
    let expected: Vec<_> = (0..5)
        .map(|n| {
            (
                format!("a-{n}"),
                Some(n.to_string()),
                Some(f64::from(n) * 10.0),
            )
        })
        .collect();
    assert_eq!(table(&index), expected);
    let columns = index.columns(FILE, &[]).unwrap();
    assert_eq!(columns.inputs.len(), 1, "the method is the same in all");
    assert_eq!(index.result_names(FILE).unwrap(), ["max"]);
    assert_eq!(synced(&mut index), SyncProgress::default());
}

#[test]
fn the_index_follows_runs_that_are_deleted_copied_in_and_changed() {
    let place = Place::new();
    let mut index = place.open();
    synced(&mut index);
    let before = index.rows(&[FILE.to_owned()], 0).unwrap();
    fs::remove_dir_all(place.root().join("a-1")).unwrap();
    stored(&place.root(), "b-copied", 7.0, 3);
    let notes = RunNotes {
        name: "base".to_owned(),
        ..RunNotes::default()
    };
    notes.write(&place.root().join("a-3")).unwrap();
    assert_eq!(synced(&mut index).all, 3);
    let after = index.rows(&[FILE.to_owned()], before.state).unwrap();
    let changed: Vec<_> = after.changed.iter().map(|run| run.name.as_str()).collect();
    assert_eq!(changed, ["a-3", "b-copied"]);
    assert_eq!(after.changed[0].notes.name, "base");
    assert_eq!(after.all.len(), 5);
    assert!(!names(&index).contains(&"a-1".to_owned()));
    let copied = &table(&index)[4];
    assert_eq!((copied.1.as_deref(), copied.2), (Some("7"), Some(70.0)));
}

#[test]
fn changes_are_told_also_after_the_newest_run_was_deleted() {
    let place = Place::new();
    let mut index = place.open();
    synced(&mut index);
    stored(&place.root(), "c", 8.0, 3);
    synced(&mut index);
    let before = index.rows(&[FILE.to_owned()], 0).unwrap();
    fs::remove_dir_all(place.root().join("c")).unwrap();
    synced(&mut index);
    stored(&place.root(), "d", 9.0, 3);
    synced(&mut index);
    let after = index.rows(&[FILE.to_owned()], before.state).unwrap();
    assert_eq!(after.changed.len(), 1);
}

#[test]
fn a_damaged_database_is_made_anew() {
    let place = Place::new();
    let mut index = place.open();
    synced(&mut index);
    let file = index.file.clone().unwrap();
    drop(index);
    let whole = fs::read(&file).unwrap();
    let mut broken = whole.clone();
    let length = broken.len();
    broken[100..length].fill(0x5a);
    for bytes in [b"no database".to_vec(), whole[..2000].to_vec(), broken] {
        fs::write(&file, bytes).unwrap();
        let mut index = place.open();
        let stop = AtomicBool::new(false);
        if let Err(error) = index.sync(&stop, &mut |_| {}) {
            index.mend(error).unwrap();
            synced(&mut index);
        }
        assert_eq!(table(&index).len(), 5);
        assert!(index.file.is_some());
    }
}

#[test]
fn a_stopped_reading_keeps_what_it_has_and_goes_on_later() {
    let place = Place::new();
    for number in 0..450 {
        let dir = place.root().join(format!("z-{number}"));
        fs::create_dir(&dir).unwrap();
        let text = fs::read_to_string(place.root().join("a-0/run.toml")).unwrap();
        fs::write(dir.join("run.toml"), text).unwrap();
    }
    let mut index = place.open();
    let stop = AtomicBool::new(false);
    let told = &mut |_| stop.store(true, std::sync::atomic::Ordering::Relaxed);
    let first = index.sync(&stop, told).unwrap();
    assert_eq!((first.done, first.all), (200, 455));
    // As after a kill: another program finds what was taken, and takes the rest.
    let mut other = place.open();
    assert_eq!(names(&other).len(), 200);
    assert_eq!(synced(&mut other).all, 255);
    assert_eq!(names(&index).len(), 455);
}

#[test]
fn two_programs_at_once_agree() {
    let place = Place::new();
    std::thread::scope(|scope| {
        for number in 0..4 {
            let place = &place;
            scope.spawn(move || {
                let mut index = place.open();
                for round in 0..5 {
                    stored(&place.root(), &format!("t-{number}-{round}"), 1.0, 1);
                    synced(&mut index);
                }
            });
        }
    });
    let mut index = place.open();
    synced(&mut index);
    assert_eq!(names(&index).len(), 25);
    assert_eq!(table(&index).len(), 25);
}

#[test]
fn without_a_folder_to_write_the_index_is_in_memory() {
    let place = Place::new();
    let taken = place.dir.path().join("file");
    fs::write(&taken, "").unwrap();
    let mut index = RunIndex::open(&place.root(), Some(&taken)).unwrap();
    assert!(index.file.is_none());
    synced(&mut index);
    assert_eq!(names(&index).len(), 5);
    let nowhere = RunIndex::open(&place.dir.path().join("none"), None).unwrap();
    assert!(names(&nowhere).is_empty());
}

#[test]
fn a_run_that_cannot_be_read_is_not_listed_and_holds_nothing_up() {
    let place = Place::new();
    fs::write(place.root().join("a-2/run.toml"), "state = [").unwrap();
    let mut index = place.open();
    synced(&mut index);
    assert_eq!(names(&index), ["a-0", "a-1", "a-3", "a-4"]);
}
