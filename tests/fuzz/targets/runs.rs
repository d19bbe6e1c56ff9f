//! Two stored runs, of a line and of a system, whose files are replaced one at a time.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, kind};
use seacable::run::job::execute_from;
use seacable::run::job::{self, JobEvent};
use seacable::run::store::{RunLocation, RunWriter};
use seacable::run::{Run, RunInfo};
use seacable::system::SystemFile;
use seacable::system::motion::job as system_job;
use tempfile::TempDir;

/// A line with every kind of table.
const LINE: &str = include_str!("../../data/run-0.1.0/case.toml");
const SYSTEM: &str = include_str!("../../../cases/systems/bridle_in_heave.toml");

/// Which of the two runs.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    Line,
    System,
}

type Files = BTreeMap<String, Vec<u8>>;

/// The files of a run as they were stored, computed once.
pub(super) fn files(of: Of) -> &'static Files {
    static LINE_RUN: OnceLock<Files> = OnceLock::new();
    static SYSTEM_RUN: OnceLock<Files> = OnceLock::new();
    match of {
        Of::Line => LINE_RUN.get_or_init(line_run),
        Of::System => SYSTEM_RUN.get_or_init(system_run),
    }
}

/// One file of a run.
pub(super) fn one(of: Of, name: &str) -> Vec<Vec<u8>> {
    vec![files(of)[name].clone()]
}

thread_local! {
    static COPIES: RefCell<[Option<TempDir>; 2]> = const { RefCell::new([None, None]) };
}

/// The folder of this thread's copy of a run, below one that holds nothing else.
pub(super) fn copy(of: Of) -> PathBuf {
    COPIES.with_borrow_mut(|copies| {
        let copy = copies[usize::from(of == Of::System)].get_or_insert_with(|| {
            let dir = tempfile::tempdir().unwrap();
            for (name, bytes) in files(of) {
                super::place::put(&dir.path().join("run").join(name), bytes);
            }
            dir
        });
        copy.path().join("run")
    })
}

/// Puts bytes in the place of a file of a copy while something looks at it.
pub(super) fn with(of: Of, name: &str, data: &[u8], look: impl FnOnce(&Path) -> bool) -> bool {
    let dir = copy(of);
    let _whole = Restored(dir.join(name), &files(of)[name]);
    fs::write(dir.join(name), data).unwrap();
    look(&dir)
}

/// Gives a file its bytes back, also after a panic.
struct Restored(PathBuf, &'static [u8]);

impl Drop for Restored {
    fn drop(&mut self) {
        let _ = fs::write(&self.0, self.1);
    }
}

fn line_run() -> Files {
    let request = job::Request {
        case: case::parse(LINE, "line.toml").unwrap(),
        text: LINE.to_owned(),
        file: "line.toml".to_owned(),
        overrides: Vec::new(),
        id: "line".to_owned(),
    };
    stored(request.initial_info(), LINE, |events| {
        job::execute(&request, &AtomicBool::new(false), events)
    })
}

fn system_run() -> Files {
    let text = SYSTEM
        .replace("segments = 40", "segments = 8")
        .replace("duration_s = 60.0", "duration_s = 2.0");
    let solved = kind::parse::<SystemFile>(&text, "system.toml").unwrap();
    let name = "system.toml".to_owned();
    let request = system_job::request(solved.into(), &text, name, Vec::new()).unwrap();
    stored(request.initial_info(), &text, |events| {
        execute_from(&request, None, &AtomicBool::new(false), events)
    })
}

fn stored(
    info: RunInfo,
    text: &str,
    compute: impl FnOnce(&mut dyn FnMut(JobEvent)) -> Run,
) -> Files {
    let dir = tempfile::tempdir().unwrap();
    let place = RunLocation::Exactly(dir.path().join("run"));
    let mut writer = RunWriter::begin(&place, info, text).unwrap();
    let run = compute(&mut |event| writer.event(&event).unwrap());
    let stored = writer.finish(&run).unwrap();
    let mut files = Files::new();
    for item in fs::read_dir(stored).unwrap() {
        let item = item.unwrap();
        let name = item.file_name().into_string().unwrap();
        files.insert(name, fs::read(item.path()).unwrap());
    }
    files.entry("notes.toml".to_owned()).or_insert_with(|| {
        b"name = \"base\"\ntags = [\"wet\", \"dry\"]\nnote = \"a note\"\n".to_vec()
    });
    files
}
