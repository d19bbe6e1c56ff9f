//! Files of stored runs, checkpoints, the index of runs, and what a session left.

use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case::Case;
use seacable::case::{self, shipped};
use seacable::chart::Glyphs;
use seacable::reference;
use seacable::report::text;
use seacable::run::index::RunIndex;
use seacable::run::store::{self, RunNotes};
use seacable::run::{RunState, job, resume_request};
use seacable::system::motion::system_in_time::SystemInTime;
use seacable::tui::recovery::RecoveredEdits;

use super::Target;
use super::cases::shown;
use super::place::{contained, file};
use super::runs::{Of, one, with};

/// A target for each file of a run that is read with the run.
macro_rules! run_files {
    ($(($target:literal, $name:literal)),*) => {
        &[$(Target {
            name: $target,
            run: |data| with(Of::Line, $name, contained(data).as_bytes(), opened),
            seeds: || one(Of::Line, $name),
            share: 2,
        }),*]
    };
}

const FILES: &[Target] = run_files![
    ("run_info", "run.toml"),
    ("run_case", "case.toml"),
    ("run_history", "history.csv"),
    ("run_shapes", "shapes.csv"),
    ("run_profile", "profile.csv"),
    ("run_ropes", "ropes.csv"),
    ("run_summary", "summary.csv"),
    ("run_errors", "errors.csv"),
    ("run_channels", "channels.csv")
];

pub(super) const ALL: &[&[Target]] = &[FILES, OTHERS];

const OTHERS: &[Target] = &[
    Target {
        name: "run_notes",
        run: |data| {
            with(Of::Line, "notes.toml", data, |dir| {
                RunNotes::read(dir) != RunNotes::default()
            })
        },
        seeds: || one(Of::Line, "notes.toml"),
        share: 5,
    },
    Target {
        name: "checkpoint",
        run: |data| with(Of::Line, "checkpoint.toml", data, resumed),
        seeds: || one(Of::Line, "checkpoint.toml"),
        share: 3,
    },
    Target {
        name: "checkpoint_system",
        run: |data| with(Of::System, "checkpoint.toml", data, resumed_system),
        seeds: || one(Of::System, "checkpoint.toml"),
        share: 3,
    },
    Target {
        name: "warm_start",
        run: warm_start,
        seeds: || one(Of::Line, "checkpoint.toml"),
        share: 4,
    },
    Target {
        name: "run_index",
        run: |data| with(Of::Line, "run.toml", data, indexed),
        seeds: || one(Of::Line, "run.toml"),
        share: 1,
    },
    Target {
        name: "index_database",
        run: database,
        seeds: || vec![index_of_run()],
        share: 1,
    },
    Target {
        name: "recovered_edits",
        run: |data| {
            RecoveredEdits::read(&String::from_utf8_lossy(data)) != RecoveredEdits::default()
        },
        seeds: || {
            let text = shipped::text("basics/pendulum.toml").unwrap_or_default();
            vec![format!("# range kept for a grid: solver.time_step_s=1,2\n{text}").into_bytes()]
        },
        share: 2000,
    },
];

/// Reads a run, and reports one in four: that takes the longest.
fn opened(dir: &Path) -> bool {
    drop(store::list(dir.parent().unwrap()));
    let Ok(run) = store::read(dir) else {
        return false;
    };
    let values = run.summary.iter().map(|quantity| quantity.value.to_bits());
    let texts = run.info.warnings.iter().map(|warning| warning.len() as u64);
    let times = run.history.time.iter().map(|time| time.to_bits());
    if values
        .chain(texts)
        .chain(times)
        .fold(0, |sum, bits| sum ^ bits ^ (bits >> 32))
        % 4
        != 0
    {
        return true;
    }
    let case = match case::parse(&run.case_text, &file("line.toml")) {
        Ok(case) => case,
        Err(faults) => return shown(&faults),
    };
    let rows = reference::rows_of_run(&run, &case);
    let report = text::of_run(&run, &case, &rows);
    let written = [
        report.to_text(text::WIDTH, Glyphs::Ascii),
        report.to_markdown(Glyphs::Ascii),
        report.to_html(),
    ];
    written.iter().all(|text| !text.is_empty())
}

/// Goes on from a checkpoint: everything up to the first step, and a step or two where it belongs to the run.
fn resumed(dir: &Path) -> bool {
    let Ok((request, from)) = resume_request::<Case>(dir, Some(4.25)) else {
        return false;
    };
    let stop = AtomicBool::new(true);
    let run = job::execute_from(&request, from.as_ref(), &stop, &mut |_| ());
    run.info.state != RunState::Failed
}

fn resumed_system(dir: &Path) -> bool {
    let Ok((request, from)) = resume_request::<SystemInTime>(dir, Some(2.1)) else {
        return false;
    };
    let stop = AtomicBool::new(true);
    let run = job::execute_from(&request, from.as_ref(), &stop, &mut |_| ());
    run.info.state != RunState::Failed
}

/// A case that starts from a run whose checkpoint it carries.
fn warm_start(data: &[u8]) -> bool {
    // Its end begins where the run leaves it.
    let place = ["[0.0, 0.0, 10.5]", "[-0.001897, 0.0, 10.499051]"];
    let mut text = include_str!("../../data/run-0.1.0/case.toml").replace(place[0], place[1]);
    let checkpoint = toml::Value::String(contained(data));
    text.push_str("\n[start]\nfrom_run = \"before\"\n\n[files.before]\n");
    text.push_str(&format!("text = {checkpoint}\n"));
    let case = match case::parse(&text, &file("line.toml")) {
        Ok(case) => case,
        Err(faults) => return shown(&faults),
    };
    let request = job::Request {
        case,
        text,
        file: "line.toml".to_owned(),
        overrides: Vec::new(),
        id: String::new(),
    };
    let run = job::execute(&request, &AtomicBool::new(true), &mut |_| ());
    run.info.state != RunState::Failed
}

/// The index of the folder that holds the run.
fn indexed(dir: &Path) -> bool {
    let opened = RunIndex::open(dir.parent().unwrap(), None);
    opened.is_ok_and(|mut index| index.sync(&AtomicBool::new(false), &mut |_| ()).is_ok())
}

/// Where the index keeps its database.
fn cache() -> std::path::PathBuf {
    super::place::path("cache")
}

/// Opens the index with its database in the cache, makes that anew where it is damaged, and lists.
fn listed() -> bool {
    let dir = super::runs::copy(Of::Line);
    let Ok(mut index) = RunIndex::open(dir.parent().unwrap(), Some(&cache())) else {
        return false;
    };
    let never = AtomicBool::new(false);
    let whole = match index.sync(&never, &mut |_| ()) {
        Ok(_) => true,
        Err(error) => {
            drop(index.mend(error));
            false
        }
    };
    whole && index.rows(&["line.toml".to_owned()], 0).is_ok()
}

/// The database of the index of the run, as it is written.
fn index_of_run() -> Vec<u8> {
    fs::create_dir_all(cache()).unwrap();
    listed();
    database_file().map_or_else(Vec::new, |file| fs::read(file).unwrap())
}

fn database_file() -> Option<std::path::PathBuf> {
    let inside = fs::read_dir(cache()).unwrap();
    inside
        .map(|item| item.unwrap().path())
        .find(|path| path.is_file())
}

/// A damaged database is made anew, and never more than an index.
fn database(data: &[u8]) -> bool {
    if !cache().exists() {
        index_of_run();
    }
    let Some(file) = database_file() else {
        return false;
    };
    fs::write(file, data).unwrap();
    listed()
}
