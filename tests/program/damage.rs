//! Damaged checkpoints and run folders: refused in words, or of no consequence. None panics, runs without end, or gives a result that is not
//! finite with success.
//!
//! `SEACABLE_DAMAGES=10000 cargo test --test program damage -- --nocapture` makes that many, `SEACABLE_SEED` sets others.

use std::collections::BTreeMap;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use assert_cmd::Command;
use seacable::case::{self, Case, edit, kind};
use seacable::chart::Glyphs;
use seacable::kinds::FileType;
use seacable::reference;
use seacable::report::text;
use seacable::run::job::{self, JobEvent};
use seacable::run::store::{self, RunLocation, RunWriter};
use seacable::run::{Run, RunInfo, RunState};
use seacable::system::SystemFile;
use seacable::system::motion::job as system_job;
use seacable::system::motion::system_in_time::SystemInTime;

use crate::chance::{Chance, asked, seed};
use crate::reseal::{reseal, unsealed};
use crate::small::SMALL;

/// A case, the keys set in it, and the time at which its run is stopped.
type StoppedCase = (&'static str, &'static [(&'static str, &'static str)], f64);

const CASES: [StoppedCase; 7] = [
    (SMALL, &[("solver.duration_s", "4")], 2.0),
    (
        include_str!("../../cases/basics/steep_wave.toml"),
        &[("solver.duration_s", "6")],
        3.0,
    ),
    (include_str!("../../cases/hard/release.toml"), &[], 0.4),
    (include_str!("../../cases/hard/stick_slip.toml"), &[], 1.0),
    (include_str!("../../cases/hard/body_on_bed.toml"), &[], 0.3),
    (
        include_str!("../../cases/systems/line_breaks.toml"),
        &[("solver.duration_s", "3")],
        1.5,
    ),
    (
        include_str!("../../cases/systems/winch_lowering.toml"),
        &[("solver.duration_s", "4")],
        2.0,
    ),
];

/// A stopped run, what resuming it gives, and its files.
struct Base {
    whole: Run,
    files: BTreeMap<String, String>,
}

/// What is computed of a run folder.
type Compute<'a> = &'a mut dyn FnMut(&AtomicBool, &mut dyn FnMut(JobEvent)) -> Run;

/// Stores a run while it is computed, and stops it at a time.
fn stored(dir: &Path, info: RunInfo, text: &str, stop: f64, compute: Compute<'_>) {
    let place = RunLocation::Exactly(dir.to_owned());
    let mut writer = RunWriter::begin(&place, info, text).unwrap();
    let cancel = AtomicBool::new(false);
    let run = compute(&cancel, &mut |event| {
        if matches!(&event, JobEvent::Frame(frame) if frame.time >= stop) {
            cancel.store(true, Ordering::Relaxed);
        }
        writer.event(&event).unwrap();
    });
    assert_eq!(
        run.info.state,
        RunState::Cancelled,
        "{} at {:?} {:?}",
        run.info.title,
        run.history.time.last(),
        run.info.failure
    );
    writer.finish(&run).unwrap();
}

fn base(dir: &Path, text: &str, keys: &[(&str, &str)], stop: f64) -> Base {
    if FileType::of_text(text) == FileType::System {
        let set = |text: String, (key, value): &(&str, &str)| {
            kind::set::<SystemFile>(&text, key, value).unwrap()
        };
        let text = keys.iter().fold(text.to_owned(), set);
        let solved = kind::parse::<SystemFile>(&text, "x.toml").unwrap();
        let file = "x.toml".to_owned();
        let request = system_job::request(Arc::new(solved), &text, file, Vec::new()).unwrap();
        let (info, text) = (request.initial_info(), request.text.clone());
        stored(dir, info, &text, stop, &mut |cancel, events| {
            job::execute_from(&request, None, cancel, events)
        });
    } else {
        let text = edit::set_all(text, keys).unwrap();
        let case = case::parse(&text, "x.toml").unwrap();
        let text = case::stand_alone(&text, &case).into_owned();
        let request = job::Request {
            case,
            text: text.clone(),
            file: "x.toml".to_owned(),
            overrides: Vec::new(),
            id: String::new(),
        };
        stored(
            dir,
            request.initial_info(),
            &text,
            stop,
            &mut |cancel, events| job::execute(&request, cancel, events),
        );
    }
    // A program that another test starts at this moment holds the lock until it is loaded.
    while store::is_locked(dir) {
        thread::sleep(Duration::from_millis(5));
    }
    let (whole, _) = resumed(dir).unwrap();
    assert_eq!(whole.info.state, RunState::Done, "{:?}", whole.info.failure);
    let read = |item: fs::DirEntry| {
        let name = item.file_name().into_string().unwrap();
        let text = fs::read_to_string(item.path()).unwrap();
        (name, text)
    };
    let files = fs::read_dir(dir).unwrap().map(|item| read(item.unwrap()));
    Base {
        whole,
        files: files.collect(),
    }
}

/// The time after which a run counts as one without end.
const ENDLESS: Duration = Duration::from_secs(10);

/// Resumes the run in a folder, and whether it was stopped because it took too long.
fn resumed(dir: &Path) -> Result<(Run, bool), String> {
    let text = fs::read_to_string(dir.join("case.toml")).unwrap_or_default();
    let cancel = Arc::new(AtomicBool::new(false));
    let (over, watched) = (Arc::new(AtomicBool::new(false)), Arc::clone(&cancel));
    let ended = Arc::clone(&over);
    let watch = thread::spawn(move || {
        let begun = Instant::now();
        while !ended.load(Ordering::Relaxed) && begun.elapsed() < ENDLESS {
            thread::park_timeout(Duration::from_millis(100));
        }
        if !ended.load(Ordering::Relaxed) {
            watched.store(true, Ordering::Relaxed);
        }
    });
    let ignore = &mut |_| {};
    let run = catch_unwind(AssertUnwindSafe(|| {
        if FileType::of_text(&text) == FileType::System {
            let (request, from) = seacable::run::resume_request::<SystemInTime>(dir, None)?;
            Ok(job::execute_from(&request, from.as_ref(), &cancel, ignore))
        } else {
            let (request, from) = seacable::run::resume_request::<Case>(dir, None)?;
            Ok(job::execute_from(&request, from.as_ref(), &cancel, ignore))
        }
    }));
    over.store(true, Ordering::Relaxed);
    watch.thread().unpark();
    watch.join().unwrap();
    let long = cancel.load(Ordering::Relaxed);
    match run {
        Ok(run) => run.map(|run| (run, long)),
        Err(_) => panic!("{} panics", dir.display()),
    }
}

const WILD: [&str; 12] = [
    "inf",
    "-inf",
    "nan",
    "1e300",
    "-1e300",
    "-1.0",
    "0.0",
    "1e-300",
    "9223372036854775807",
    "4294967296",
    "0",
    "-1",
];

/// Where the numbers of a text are.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let is = |c: char| c.is_ascii_digit() || ".+-e".contains(c);
    let mut found = Vec::new();
    let mut from = 0;
    for piece in text.split_inclusive(|c| !is(c)) {
        let word = piece.trim_end_matches(|c| !is(c));
        if word.parse::<f64>().is_ok() {
            found.push((from, from + word.len()));
        }
        from += piece.len();
    }
    found
}

/// A text with something in it changed, and what.
fn damaged(text: &str, chance: &mut Chance) -> (Vec<u8>, String) {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    match chance.below(10) {
        0..=3 => {
            let found = numbers(text);
            if found.is_empty() {
                return (Vec::new(), "emptied".to_owned());
            }
            let &(from, to) = chance.one(&found);
            let old = &text[from..to];
            let by = *chance.one(&[1.0001, 2.0, -1.0, 10.0, 1e-3]);
            let new = match (chance.below(3), old.parse::<f64>()) {
                (0, Ok(number)) => format!("{:?}", number * by),
                _ => (*chance.one(&WILD)).to_owned(),
            };
            let changed = format!("{}{new}{}", &text[..from], &text[to..]);
            (changed.into_bytes(), format!("{old} -> {new}"))
        }
        4 => {
            let gone = chance.below(lines.len());
            let kept = lines.iter().enumerate().filter(|(at, _)| *at != gone);
            let kept: String = kept.map(|(_, line)| *line).collect();
            (kept.into_bytes(), format!("line {gone} gone"))
        }
        5 => {
            let twice = chance.below(lines.len());
            let mut more = lines.clone();
            more.insert(twice, lines[twice]);
            (more.concat().into_bytes(), format!("line {twice} twice"))
        }
        6 => {
            // A column of a table, or an entry of every list.
            let at = chance.below(6);
            let without = |line: &&str| {
                let fields = line.trim_end().split(',').enumerate();
                let kept = fields.filter(|(field, _)| *field != at);
                kept.map(|(_, field)| field).collect::<Vec<_>>().join(",") + "\n"
            };
            let kept: String = lines.iter().map(without).collect();
            (kept.into_bytes(), format!("field {at} of every line gone"))
        }
        7 => {
            let cut = chance.below(text.len());
            (text.as_bytes()[..cut].to_vec(), format!("cut at {cut}"))
        }
        8 => {
            let (from, to) = (chance.below(lines.len()), chance.below(lines.len()));
            let mut moved = lines.clone();
            moved.swap(from, to);
            (moved.concat().into_bytes(), format!("lines {from}, {to}"))
        }
        _ => {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=chance.below(3) {
                let at = chance.below(bytes.len());
                bytes[at] ^= 1 << chance.below(8);
            }
            (bytes, "bits flipped".to_owned())
        }
    }
}

/// Whether all results of a run are finite.
fn is_finite(run: &Run) -> bool {
    let values = run.summary.iter().map(|q| q.value);
    let mut rows = run.history.channels.iter().flat_map(|c| c.values.iter());
    let mut extremes = run
        .history
        .channels
        .iter()
        .flat_map(|c| [c.peak.0, c.trough.0]);
    values
        .chain(run.history.time.iter().copied())
        .all(f64::is_finite)
        && rows.all(|value| value.is_finite())
        && (run.history.time.is_empty() || extremes.all(f64::is_finite))
}

/// The report of a run folder, as far as it opens.
fn report(dir: &Path) -> Option<(Run, String)> {
    let run = store::read(dir).ok()?;
    let text = if FileType::of_text(&run.case_text) == FileType::System {
        seacable::report::system::motion::summary(&run)
    } else {
        let case = case::parse(&run.case_text, "x.toml").ok()?;
        text::report(
            &run,
            &case,
            &reference::rows_of_run(&run, &case),
            Glyphs::Ascii,
        )
    };
    Some((run, text))
}

/// Words of a page that are numbers and not finite.
fn wild_words(page: &str) -> Option<&str> {
    let mut words = page.split(|c: char| c.is_whitespace() || ",;()[]".contains(c));
    words.find(|word| ["NaN", "nan", "inf", "-inf", "+inf"].contains(word))
}

fn fill(dir: &Path, files: &BTreeMap<String, String>) {
    let _ = fs::remove_dir_all(dir);
    fs::create_dir(dir).unwrap();
    for (name, text) in files {
        fs::write(dir.join(name), text).unwrap();
    }
}

fn bases(root: &Path) -> Vec<Base> {
    let made = CASES
        .iter()
        .enumerate()
        .map(|(number, (text, keys, stop))| {
            base(&root.join(format!("base-{number}")), text, keys, *stop)
        });
    made.collect()
}

/// What a run that is resumed from a checkpoint must not differ from where it belongs to another.
const BEFORE: [&str; 4] = ["checkpoint.toml", "case.toml", "history.csv", "shapes.csv"];

#[test]
fn no_damage_of_a_run_folder_is_let_in() {
    let place = tempfile::tempdir().unwrap();
    let bases = bases(place.path());
    let dir = place.path().join("damaged");
    let mut chance = Chance::new(seed());
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for number in 0..asked("SEACABLE_DAMAGES", 80) {
        let base = chance.one(&bases);
        fill(&dir, &base.files);
        let name = match chance.below(20) {
            0..=9 => "checkpoint.toml",
            10..=13 => "history.csv",
            14 => "shapes.csv",
            15 | 16 => "case.toml",
            17 => "run.toml",
            18 => "foreign",
            _ => *chance.one(&["summary.csv", "errors.csv", "channels.csv", "profile.csv"]),
        };
        let what = if name == "foreign" {
            let other = &chance.one(&bases).files;
            fs::write(dir.join("checkpoint.toml"), &other["checkpoint.toml"]).unwrap();
            name.to_owned()
        } else if base.files[name].is_empty() {
            continue;
        } else {
            let (bytes, what) = damaged(&base.files[name], &mut chance);
            fs::write(dir.join(name), bytes).unwrap();
            format!("{name}: {what}")
        };
        let what = format!("damage {number} of {}, {what}", base.whole.info.title);
        let count = match resumed(&dir) {
            Err(reason) => {
                assert!(!reason.is_empty(), "{what}");
                "refused"
            }
            Ok((run, long)) => {
                assert!(!long, "{what}: takes too long");
                assert!(is_finite(&run), "{what}: not finite");
                let same = run.summary == base.whole.summary && run.history == base.whole.history;
                let done = run.info.state == RunState::Done;
                // Without a whole `run.toml` that says so nothing is known of a run that was not yet under way.
                assert!(!done || same || !BEFORE.contains(&name), "{what}: let in");
                if same {
                    "the same results"
                } else {
                    "other results"
                }
            }
        };
        *counts.entry(count).or_default() += 1;
        let reported = catch_unwind(|| report(&dir));
        let reported = reported.unwrap_or_else(|_| panic!("{what}: the report panics"));
        if let Some((run, page)) = reported {
            assert!(is_finite(&run), "{what}: read as not finite");
            // What is wrong with a damaged case is reported in its own words, and texts of a run are shown as they are.
            if !["case.toml", "run.toml"].contains(&name) {
                assert_eq!(wild_words(&page), None, "{what}: reported");
            }
        }
    }
    eprintln!("{counts:?}");
    assert!(counts["refused"] > 20, "{counts:?}");
}

/// Checkpoints that were edited on purpose, and sealed anew: any result may follow, but for panics, runs without end and results that are
/// not finite.
#[test]
fn no_edited_checkpoint_gives_a_result_that_is_not_finite() {
    let place = tempfile::tempdir().unwrap();
    let bases = bases(place.path());
    let dir = place.path().join("edited");
    let mut chance = Chance::new(seed() ^ 0x5ea1);
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for number in 0..asked("SEACABLE_DAMAGES", 80) / 4 {
        let base = chance.one(&bases);
        fill(&dir, &base.files);
        let body = unsealed(&base.files["checkpoint.toml"]);
        let (body, what) = if chance.below(4) > 0 {
            damaged(body, &mut chance)
        } else {
            let (bytes, what) = damaged(&base.files["history.csv"], &mut chance);
            fs::write(dir.join("history.csv"), bytes).unwrap();
            (body.as_bytes().to_vec(), format!("history.csv: {what}"))
        };
        let Ok(body) = String::from_utf8(body) else {
            continue;
        };
        reseal(&dir, &body);
        let what = format!("edit {number} of {}, {what}", base.whole.info.title);
        let count = match resumed(&dir) {
            Err(_) => "refused",
            Ok((_, true)) => "slow",
            Ok((run, false)) => {
                let done = run.info.state == RunState::Done;
                assert!(!done || is_finite(&run), "{what}: not finite");
                if done { "computed" } else { "failed" }
            }
        };
        *counts.entry(count).or_default() += 1;
    }
    eprintln!("{counts:?}");
}

/// The program says why, ends with status 2, makes nothing and changes nothing.
#[test]
fn the_program_refuses_damaged_folders_in_words() {
    let place = tempfile::tempdir().unwrap();
    let (text, keys, stop) = CASES[0];
    let (system, system_keys, system_stop) = CASES[5];
    let bases = [
        base(&place.path().join("line"), text, keys, stop),
        base(
            &place.path().join("system"),
            system,
            system_keys,
            system_stop,
        ),
    ];
    type Change = fn(&mut BTreeMap<String, String>);
    let column: Change = |files| {
        let history = files.get_mut("history.csv").unwrap();
        let cut = history.lines().map(|l| l.rsplit_once(',').unwrap().0);
        *history = cut.map(|line| format!("{line}\n")).collect();
    };
    let infinite: Change = |files| {
        let history = files.get_mut("history.csv").unwrap();
        let third = history.lines().nth(2).unwrap().to_owned();
        let (first, _) = third.rsplit_once(',').unwrap();
        *history = history.replacen(&third, &format!("{first},inf"), 1);
    };
    let number: Change = |files| {
        let text = files.get_mut("checkpoint.toml").unwrap();
        let at = numbers(text)[8];
        text.replace_range(at.0..at.1, "7.0");
    };
    let duration: Change = |files| {
        let text = files.get_mut("case.toml").unwrap();
        *text = text.replace("duration_s = ", "duration_s = 1");
    };
    let seal: Change = |files| {
        let text = files.get_mut("checkpoint.toml").unwrap();
        *text = unsealed(text).to_owned();
    };
    let changes: [(Change, &str); 5] = [
        (column, "history.csv cannot be read: it was changed or cut"),
        (
            infinite,
            "history.csv cannot be read: it was changed or cut",
        ),
        (
            number,
            "checkpoint.toml cannot be read: it was changed since",
        ),
        (duration, "--until"),
        (seal, "checkpoint.toml cannot be read: it has no seal"),
    ];
    let dir = place.path().join("damaged");
    for base in &bases {
        for (change, reason) in &changes {
            let mut files = base.files.clone();
            change(&mut files);
            fill(&dir, &files);
            let mut command = Command::cargo_bin("seacable").unwrap();
            command.current_dir(place.path());
            command.args(["run", "--resume", "damaged", "--out", "new"]);
            command.timeout(Duration::from_secs(60));
            let output = command.assert().code(2).get_output().clone();
            let said = String::from_utf8(output.stderr).unwrap();
            assert!(said.contains(reason), "{said}");
            assert!(!place.path().join("new").exists());
            let after: Vec<PathBuf> = fs::read_dir(&dir)
                .unwrap()
                .map(|i| i.unwrap().path())
                .collect();
            assert_eq!(after.len(), files.len());
            for (name, text) in &files {
                assert_eq!(&fs::read_to_string(dir.join(name)).unwrap(), text);
            }
        }
    }
}
