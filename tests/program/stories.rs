//! Whole stories on a terminal of 80 by 24: what someone does with the workbench from beginning to end.

#![cfg(target_os = "linux")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use rustix::process::{Pid, Signal, kill_process};
use vt100::Screen;

use crate::pty::{Pty, Start, place, wait_until};

const LIST: &str = "Manifold, 300 t";
const HANGING: &str = "cases/basics/hanging_line.toml";
const RIGHT: &str = "\x1b[C";
const LEFT: &str = "\x1b[D";
const HELD: &str = "against the file's";

/// The line of the screen that contains a text.
fn line_with(screen: &Screen, text: &str) -> Option<String> {
    let all = screen.contents();
    all.lines().find(|l| l.contains(text)).map(str::to_owned)
}

/// The value of the current speed is on the screen, marked or not.
fn speed(value: &'static str, yours: bool) -> impl Fn(&Screen) -> bool {
    move |screen| {
        let text = screen.contents();
        let mut lines = text.lines().filter(|l| l.starts_with(" current speed "));
        lines.any(|l| l.contains(&format!(" {value} m/s")) && l.contains("yours") == yours)
    }
}

/// The results are those of the inputs on the screen, and the first of them is so against the file's.
fn first_result(screen: &Screen, so: impl Fn(&str) -> bool) -> bool {
    line_with(screen, "── results").is_some_and(|head| head.contains(HELD))
        && line_with(screen, "(0..200)").is_some_and(|line| so(&line))
}

/// The run directories, in the order of their names.
fn stored(dir: &Path) -> Vec<PathBuf> {
    let runs = fs::read_dir(dir.join("runs")).unwrap();
    let mut all: Vec<_> = runs.map(|run| run.unwrap().path()).collect();
    all.sort();
    all
}

fn speed_of(run: &Path) -> String {
    let case: toml::Table = fs::read_to_string(run.join("case.toml"))
        .unwrap()
        .parse()
        .unwrap();
    case["current"]["speed_m_per_s"].to_string()
}

fn run_with_speed(runs: &[PathBuf], speed: &str) -> PathBuf {
    let found = runs.iter().find(|run| speed_of(run) == speed);
    found.unwrap().clone()
}

/// A directory with ten runs of the hanging line at current speeds from 0.1 to 1.0.
fn place_with_ten_runs() -> tempfile::TempDir {
    let dir = place();
    for tenths in 1..=10 {
        let speed = format!("current.speed_m_per_s={}", f64::from(tenths) / 10.0);
        let status = Command::new(env!("CARGO_BIN_EXE_seacable"))
            .args(["run", HANGING, "--set", &speed])
            .current_dir(dir.path())
            .env("HOME", dir.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status()
            .unwrap();
        assert!(status.success());
    }
    assert_eq!(stored(dir.path()).len(), 10);
    dir
}

/// The speeds of the stored runs in the table, from the top.
fn speeds(screen: &Screen) -> Vec<String> {
    let text = screen.contents();
    let runs = text.lines().filter(|line| line.starts_with("[ ]"));
    runs.filter_map(|line| {
        let (_, after) = line.split_once(" done ")?;
        Some(after.split_whitespace().next()?.to_owned())
    })
    .collect()
}

fn table_of_runs(dir: tempfile::TempDir) -> Pty {
    let start = Start {
        args: &["--fresh", HANGING],
        ..Start::default()
    };
    let mut pty = start.go_in(dir);
    pty.wait_for("solver static");
    pty.send("3");
    pty
}

/// The place of a terminal whose program is over.
fn left(mut pty: Pty) -> tempfile::TempDir {
    std::mem::replace(&mut pty.dir, tempfile::tempdir().unwrap())
}

#[test]
fn a_value_is_tweaked_and_the_results_follow() {
    let mut pty = Start::default().go();
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait("the results of the file", |screen| {
        first_result(screen, |line| line.contains(" same "))
    });
    pty.send("/current speed\r");
    pty.wait("the speed of the file", speed("0.3", false));
    pty.send(RIGHT);
    pty.wait("a greater speed", speed("0.31", true));
    pty.wait("a greater tension", |screen| {
        first_result(screen, |line| line.contains(" +"))
    });
    pty.wait_for("*unsaved");
    pty.send(LEFT);
    pty.send(LEFT);
    pty.wait("a lower speed", speed("0.29", true));
    pty.wait("a lower tension", |screen| {
        first_result(screen, |line| line.contains(" -"))
    });
    pty.wait_for("the file as shipped says 0.3 m/s");
    for _ in 0..3 {
        pty.send("u");
    }
    pty.wait("the speed of the file", speed("0.3", false));
    pty.wait("the results of the file", |screen| {
        first_result(screen, |line| line.contains(" same "))
    });
    assert!(!pty.text().contains("*unsaved"), "{}", pty.text());
    pty.send("q");
    pty.ended(0);
}

#[test]
fn a_slow_case_answers_coarsely_first_and_then_in_full() {
    let start = Start {
        args: &["cases/basics/steep_wave.toml"],
        ..Start::default()
    };
    let mut pty = start.go();
    let of_inputs = |screen: &Screen| {
        let head = line_with(screen, "── results");
        head.is_some_and(|head| head.contains(HELD))
    };
    pty.wait("the results of the file", of_inputs);
    pty.send("/duration\r");
    pty.wait_for("duration");
    pty.send(RIGHT);
    pty.wait("a coarse answer, marked", |screen| {
        let text = screen.contents();
        text.contains("coarse: the full solve goes on") && text.contains(" ~")
    });
    pty.wait("the full answer", |screen| {
        of_inputs(screen) && !screen.contents().contains('~')
    });
    pty.send("qd");
    pty.ended(0);
}

#[test]
fn a_value_is_edited_run_compared_and_reported() {
    let mut pty = Start::default().go();
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for(HELD);
    pty.send("R");
    pty.wait_for("is done");
    pty.send("3");
    pty.wait("one run, and no input that differs", |screen| {
        let text = screen.contents();
        text.contains("run (1)") && text.contains("[x] manifold-") && !text.contains("current")
    });
    pty.send("1/current speed\r");
    pty.wait("the speed of the file", speed("0.3", false));
    pty.send("\r\x150.5\r");
    pty.wait("the speed typed", speed("0.5", true));
    pty.send("R3");
    pty.wait("the two runs with their speeds", |screen| {
        let value = |line: &str| {
            let (_, after) = line.split_once(" done ")?;
            after.split_whitespace().next().map(str::to_owned)
        };
        let text = screen.contents();
        let runs = text.lines().filter(|line| line.contains("] manifold-"));
        let runs: Vec<_> = runs.filter_map(value).collect();
        text.contains("current speed [m/s]") && runs == ["0.3", "0.5"]
    });
    // From the live run down to both.
    pty.send("gjmm");
    pty.wait("two marks", |screen| {
        screen.contents().matches("]* manifold-").count() == 2
    });
    pty.send("=");
    pty.wait("what differs", |screen| {
        line_with(screen, "differ").is_some() && screen.contents().contains("speed_m_per_s")
    });
    pty.send("\x1b");
    pty.wait_for("run (2)");
    pty.send("5");
    pty.wait_for("`w` saves it");
    pty.send("w");
    pty.wait_for("The report is in runs/manifold-");
    let run = run_with_speed(&stored(pty.dir.path()), "0.5");
    let report = fs::read_to_string(run.join("report.txt")).unwrap();
    assert!(report.contains("current.speed_m_per_s=0.5"), "{report}");
    pty.send("q");
    pty.wait_for("Question");
    pty.send("d");
    pty.ended(0);
}

#[test]
fn a_broken_case_is_mended_in_the_editor() {
    let dir = place();
    let file = dir.path().join(HANGING);
    let whole = fs::read_to_string(&file).unwrap();
    fs::write(&file, whole.replace("length_m", "lenght_m")).unwrap();
    let editor = dir.path().join("ed.sh");
    fs::write(&editor, "sed -i s/lenght_m/length_m/ \"$1\"\n").unwrap();
    let words = format!("sh {}", editor.display());
    let mut pty = Start {
        vars: &[("LANG", "C.UTF-8"), ("VISUAL", &words)],
        ..Start::default()
    }
    .go_in(dir);
    pty.wait_for(LIST);
    pty.send("/hanging\r");
    pty.wait_for("cannot be read: line");
    pty.send("\r");
    pty.wait_for("did you mean `length_m`?");
    pty.send("\x1b");
    pty.wait("the list again", |screen| {
        !screen.contents().contains("did you mean")
    });
    pty.send("E");
    pty.wait_for("The list is read again; Enter opens the file.");
    pty.wait("a case that can be read", |screen| {
        let text = screen.contents();
        text.contains("Hanging rope with a weight") && !text.contains("cannot be read")
    });
    pty.send("\r");
    pty.wait_for("solver static");
    pty.wait_for(HELD);
    pty.send("q");
    pty.ended(0);
    assert_eq!(fs::read_to_string(&file).unwrap(), whole);
}

#[test]
fn ten_runs_are_sorted_filtered_tagged_named_and_some_deleted() {
    let mut pty = table_of_runs(place_with_ten_runs());
    let runs = stored(pty.dir.path());
    pty.wait("all runs", |screen| {
        screen.contents().contains("run (10)") && speeds(screen).len() == 10
    });

    pty.send("/speed>0.4\r");
    pty.wait("the six faster ones", |screen| {
        screen.contents().contains("6 of 10 runs") && speeds(screen).len() == 6
    });
    // By name, by state, by the first input that differs.
    pty.send("ooo");
    pty.wait_for("current speed [m/s] ^");
    pty.send("O");
    pty.wait("the fastest first", |screen| {
        screen.contents().contains("current speed [m/s] v")
            && speeds(screen) == ["1", "0.9", "0.8", "0.7", "0.6", "0.5"]
    });

    pty.send("jn");
    pty.wait_for("A name of your own");
    pty.send("storm\r");
    pty.wait("the name", |screen| {
        line_with(screen, "[ ] storm")
            .is_some_and(|line| line.contains("done") && line.contains(" 1 "))
    });
    pty.send("mm#");
    pty.wait_for("for all 2 marked runs");
    pty.send("wet high\r");
    let fastest = run_with_speed(&runs, "1");
    let second = run_with_speed(&runs, "0.9");
    let notes = |run: &Path| fs::read_to_string(run.join("notes.toml")).unwrap_or_default();
    wait_until("the tags are on disk", || {
        [&fastest, &second].iter().all(|run| {
            let notes = notes(run);
            notes.contains("\"wet\"") && notes.contains("\"high\"")
        })
    });
    assert!(notes(&fastest).contains("name = \"storm\""));
    assert!(!notes(&second).contains("storm"));

    // No filter, no mark, and from the top again; then a filter by tag.
    pty.send("a/\x1b");
    pty.wait("all runs", |screen| speeds(screen).len() == 10);
    pty.send("/#wet\r");
    pty.wait("the tagged ones", |screen| {
        screen.contents().contains("2 of 10 runs") && speeds(screen) == ["1", "0.9"]
    });
    pty.send("/\x1b");
    pty.wait("all runs", |screen| speeds(screen).len() == 10);

    // The two slowest are at the end.
    pty.send("Gkmm");
    pty.wait("two marks", |screen| {
        screen.contents().matches("[ ]*").count() == 2
    });
    pty.send("d");
    pty.wait_for("2 stored runs");
    assert_eq!(stored(pty.dir.path()).len(), 10);
    pty.send("d");
    pty.wait_for("Deleted 2 runs.");
    pty.wait("the eight others", |screen| {
        screen.contents().contains("run (8)") && speeds(screen).last().is_some_and(|s| s == "0.3")
    });
    let left_over = stored(pty.dir.path());
    assert_eq!(left_over.len(), 8);
    assert!(
        !left_over
            .iter()
            .any(|run| ["0.1", "0.2"].contains(&&*speed_of(run)))
    );

    // Another program takes a run away, and puts another there, one file after the other.
    let away = run_with_speed(&left_over, "0.3");
    let elsewhere = tempfile::tempdir_in(pty.dir.path()).unwrap();
    let kept = elsewhere.path().join("kept");
    fs::rename(&away, &kept).unwrap();
    pty.wait("one run less", |screen| {
        screen.contents().contains("run (7)") && speeds(screen).last().is_some_and(|s| s == "0.4")
    });
    let copied = pty.dir.path().join("runs/copied-in");
    fs::create_dir(&copied).unwrap();
    fs::copy(kept.join("run.toml"), copied.join("run.toml")).unwrap();
    pty.wait("a run without inputs yet", |screen| {
        line_with(screen, "[ ] copied-in").is_some()
    });
    for file in fs::read_dir(&kept).unwrap() {
        let file = file.unwrap();
        fs::copy(file.path(), copied.join(file.file_name())).unwrap();
    }
    pty.wait("the whole run", |screen| {
        line_with(screen, "[ ] copied-in").is_some_and(|line| {
            line.split_whitespace().any(|word| word == "0.3") && line.contains("-502.")
        })
    });
    pty.wait_for("run (8)");
    pty.send("q");
    pty.ended(0);

    // The next session knows it all.
    let mut again = table_of_runs(left(pty));
    again.wait_for("run (8)");
    again.send("/#wet\r");
    again.wait("name and tags", |screen| {
        let text = screen.contents();
        text.contains("2 of 8 runs") && text.contains("[ ] storm")
    });
    again.send("q");
    again.ended(0);
}

/// What must be on the screen where everything is listed as it is on disk.
fn all_listed(pty: &mut Pty, count: usize) {
    pty.wait("all runs", |screen| {
        let text = screen.contents();
        text.contains(&format!("run ({count})")) && !text.contains("reading the runs")
    });
    pty.send("/speed>0.4\r");
    let wanted = format!("{} of {count} runs", count * 6 / 10);
    pty.wait(&wanted, |screen| screen.contents().contains(&wanted));
    pty.send("/\x1b");
}

#[test]
fn a_kill_while_runs_are_read_and_a_damaged_index_change_nothing() {
    const COUNT: usize = 2000;
    let dir = place_with_ten_runs();
    let ten = stored(dir.path());
    for number in 10..COUNT {
        let copy = dir.path().join(format!("runs/copy-{number}"));
        fs::create_dir(&copy).unwrap();
        for file in fs::read_dir(&ten[number % 10]).unwrap() {
            let file = file.unwrap();
            fs::hard_link(file.path(), copy.join(file.file_name())).unwrap();
        }
    }
    let pty = table_of_runs(dir);
    pty.wait_for("reading the runs: ");
    let process = Pid::from_raw(pty.process()).unwrap();
    kill_process(process, Signal::KILL).unwrap();
    pty.wait_for("[ended 137]");

    let mut pty = table_of_runs(left(pty));
    all_listed(&mut pty, COUNT);
    pty.send("q");
    pty.ended(0);

    let cache = pty.dir.path().join(".cache/seacable");
    let index = || {
        let files = fs::read_dir(&cache).unwrap().map(|f| f.unwrap().path());
        let is_index = |path: &PathBuf| path.extension().is_some_and(|end| end == "sqlite");
        files.filter(is_index).collect::<Vec<_>>()
    };
    let [file] = index().try_into().unwrap();
    let good = fs::read(&file).unwrap();
    let mut bad_inside = good.clone();
    bad_inside[4096..].fill(0x5a);
    let damaged = [
        b"no database".to_vec(),
        good[..good.len() / 2].to_vec(),
        bad_inside,
        Vec::new(),
    ];
    for bytes in damaged {
        fs::write(&file, bytes).unwrap();
        let mut again = table_of_runs(left(pty));
        all_listed(&mut again, COUNT);
        again.send("q");
        again.ended(0);
        pty = again;
    }
    assert_eq!(stored(pty.dir.path()).len(), COUNT);
    assert_eq!(index(), [file]);
}
