//! Inputs that ended in a panic, an overflow of the stack or a long silence: long tables, chains and circles of parameters, long tokens,
//! expressions that hide what is no number, signals that nothing looked at.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use seacable::case::{self, Diagnostic, kind};
use seacable::import::{self, ImportOptions};
use seacable::system::SystemFile;

use crate::many_lines::many_lines;

const MOORDYN: &str = include_str!("files/loud_moordyn.txt");
const CHAIN_60: &str = include_str!("files/loud_chain_60.toml");
const CHAIN_210: &str = include_str!("files/loud_chain_210.toml");
const MIN_NAN: &str = include_str!("files/loud_min_nan.toml");

/// A line whose length is given.
fn line(parameters: &str, length: &str) -> String {
    format!(
        "[case]\ntitle = \"A line\"\n[parameters]\n{parameters}\n[materials.rope]\ndiameter_m = 0.1\nmass_kg_per_m = 10.0\nea_n = 1e6\n\
         [[line]]\nname = \"rope\"\nmaterial = \"rope\"\nlength_m = {length}\nsegments = 3\n\
         [ends.a]\nname = \"top\"\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -1.0]\n[ends.b]\nname = \"low\"\nkind = \"payload\"\n\
         [payload]\ndry_mass_kg = 1000.0\nwet_mass_kg = 900.0\ndrag_area_m2 = 1.0\nadded_mass_kg = 10.0\n\
         [current]\nspeed_m_per_s = 0.5\n[solver]\nduration_s = 3.0\n"
    )
}

fn length(text: &str) -> Result<f64, Vec<Diagnostic>> {
    case::parse(text, "x.toml").map(|case| case.line[0].length_m)
}

/// On a stack as small as threads have anywhere.
fn on_a_small_stack<T: Send + 'static>(does: impl FnOnce() -> T + Send + 'static) -> T {
    let thread = thread::Builder::new().stack_size(512 << 10);
    thread.spawn(does).unwrap().join().unwrap()
}

/// A chain of parameters, the last of which is a number; written from either end.
fn chain(links: usize, backwards: bool) -> String {
    let mut rows: Vec<String> = (0..links)
        .map(|i| format!("p{i} = \"p{} + 1\"", i + 1))
        .collect();
    rows.push(format!("p{links} = 1.0"));
    if backwards {
        rows.reverse();
    }
    rows.join("\n")
}

/// 9,539 rows of the motion of a coupled body were a line of over 65,535 characters, which a format of the standard library panicked on.
#[test]
fn a_motion_of_any_length_is_read() {
    let dir = tempfile::tempdir().unwrap();
    for rows in [9_539, 40_000] {
        let table = dir.path().join(format!("motion_{rows}.txt"));
        let mut text = String::new();
        for i in 0..rows {
            let t = 0.1 * f64::from(i);
            let (surge, heave, pitch) = ((0.5 * t).sin(), (0.7 * t).cos(), 0.01 * t.sin());
            writeln!(text, "{t:.1} {surge:.4} 0 {heave:.4} 0 {pitch:.5} 0").unwrap();
        }
        fs::write(&table, text).unwrap();
        let options = ImportOptions {
            motion: Some(table),
            ..ImportOptions::default()
        };
        let case = import::read(MOORDYN, "case.txt", &options).unwrap().text;
        let list = case.lines().find(|line| line.starts_with("table_x_m"));
        let list = list.unwrap();
        assert!(list.len() > 65_535);
        assert_eq!(
            list.matches(',').count() + 1,
            usize::try_from(rows).unwrap()
        );
    }
}

/// 30,000 rows of `wave_elevation.txt`, for the same reason; also a record whose length has a great prime factor.
#[test]
fn an_elevation_of_any_length_is_read() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("case.txt");
    let text = MOORDYN.replace("50 WtrDpth", "50 WtrDpth\n3 WaveKin\n0.2 dtWave");
    for rows in [30_000, 2 * 24_989 + 1] {
        let mut table = String::new();
        for i in 0..rows {
            let t = 0.2 * f64::from(i);
            let height = (0.6 * t).sin() + 0.4 * (0.83 * t + 1.0).sin();
            writeln!(table, "{t:.1} {height:.5}").unwrap();
        }
        fs::write(dir.path().join("wave_elevation.txt"), table).unwrap();
        let name = file.display().to_string();
        let case = import::read(&text, &name, &ImportOptions::default()).unwrap();
        assert!(case.text.lines().any(|line| line.len() > 65_535));
    }
}

#[test]
fn parameters_in_a_chain_of_any_length_have_their_values_on_any_stack() {
    for (links, backwards) in [(60, false), (210, false), (1_900, false), (1_900, true)] {
        let text = line(&chain(links, backwards), "\"p0\"");
        let found = on_a_small_stack(move || length(&text));
        let expected = 1.0 + f64::from(u32::try_from(links).unwrap());
        assert_eq!(found.unwrap(), expected);
    }
    // The files themselves have no line.
    for text in [CHAIN_60, CHAIN_210] {
        let faults = on_a_small_stack(move || kind::parse::<SystemFile>(text, "x.toml").map(drop));
        let faults = faults.unwrap_err();
        assert!(
            faults
                .iter()
                .all(|fault| !fault.key.starts_with("parameters")),
            "{faults:?}"
        );
    }
}

#[test]
fn ten_thousand_parameters_in_a_chain_are_refused_by_their_number_or_computed() {
    let dir = tempfile::tempdir().unwrap();
    let text = line(&chain(10_000, false), "\"p0\"");
    fs::write(dir.path().join("chain.toml"), text).unwrap();
    let run = |words: &[&str]| program(dir.path(), words).output().unwrap();
    let refused = run(&["run", "chain.toml"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        stderr(&refused).contains("10001 entries"),
        "{}",
        stderr(&refused)
    );
    let words = [
        "run",
        "chain.toml",
        "--limit-tables",
        "20000",
        "--set",
        "line.rope.length_m=0.002 * p0",
    ];
    let done = run(&words);
    assert!(done.status.success(), "{}", stderr(&done));
}

#[test]
fn parameters_in_a_circle_are_an_error_with_its_place() {
    for count in [1_usize, 2, 60, 1_900] {
        let rows: Vec<String> = (0..count)
            .map(|i| format!("p{i} = \"p{}\"", (i + 1) % count))
            .collect();
        let text = line(&rows.join("\n"), "\"p0\"");
        let faults = on_a_small_stack(move || length(&text)).unwrap_err();
        let fault = &faults[0];
        assert_eq!((fault.line, fault.key.as_str()), (4, "parameters.p0"));
        assert!(
            fault.problem.starts_with("depends on itself (p0"),
            "{fault}"
        );
        assert!(fault.problem.len() < 300, "{fault}");
    }
}

/// 1,900 names that are no parameters were compared with 1,900 that are.
#[test]
fn unknown_names_are_compared_with_others_as_often_as_they_are_shown() {
    let rows: Vec<String> = (0..1_900).map(|i| format!("p{i} = \"q{i}\"")).collect();
    let text = line(&rows.join("\n"), "5.0");
    let begun = Instant::now();
    let faults = length(&text).unwrap_err();
    assert!(
        begun.elapsed() < Duration::from_secs(5),
        "{:?}",
        begun.elapsed()
    );
    assert_eq!(faults.len(), 51);
    assert!(
        faults[50].problem.contains("1850 more faults"),
        "{}",
        faults[50]
    );
}

#[test]
fn what_is_nested_deeply_is_refused_at_its_place() {
    for (length_m, why) in [
        (format!("\"{}p{}\"", "(".repeat(90), ")".repeat(90)), ""),
        (
            format!("\"{}p{}\"", "(".repeat(5_000), ")".repeat(5_000)),
            "is longer than 200 characters",
        ),
        (format!("\"{}p\"", "-".repeat(150)), ""),
        (format!("\"{}p{}\"", "abs(".repeat(39), ")".repeat(39)), ""),
        (format!("{}1{}", "[".repeat(200), "]".repeat(200)), "recurs"),
        (
            format!("{}1{}", "[".repeat(100_000), "]".repeat(100_000)),
            "recurs",
        ),
        (
            format!("{}1{}", "{a=".repeat(100_000), "}".repeat(100_000)),
            "recurs",
        ),
    ] {
        let text = line("p = 7.0", &length_m);
        match on_a_small_stack(move || length(&text)) {
            Ok(found) => assert!(why.is_empty() && found == 7.0, "{found}"),
            Err(faults) => {
                let fault = faults[0].to_string();
                assert!(!why.is_empty() && fault.contains(why), "{fault}");
                assert_eq!(faults[0].line, 12, "{fault}");
            }
        }
    }
    for keys in [
        "a.".repeat(100_000) + "b = 1",
        format!("[{}b]", "a.".repeat(100_000)),
    ] {
        let text = line("p = 7.0", "5.0") + &keys;
        let faults = on_a_small_stack(move || length(&text)).unwrap_err();
        assert!(
            faults[0].problem.contains("recursion limit"),
            "{}",
            faults[0]
        );
    }
}

/// The least of NaN and a number is the number: `min(sqrt(z - 1), p)` with z = 0 was p.
#[test]
fn an_expression_does_not_hide_that_a_part_of_it_is_no_number() {
    let faults = kind::parse::<SystemFile>(MIN_NAN, "min_nan.toml")
        .map(drop)
        .unwrap_err();
    let fault = &faults[0];
    assert_eq!(
        (faults.len(), fault.line, fault.key.as_str()),
        (1, 37, "lines.chain.length_m")
    );
    assert!(fault.problem.contains("`sqrt(z - 1)` is NaN"), "{fault}");
    for (length_m, why) in [
        ("max(p, sqrt(z - 1))", "`sqrt(z - 1)` is NaN"),
        ("p + atan(1 / z)", "`1 / z` is inf"),
        ("p * exp(-(1 / z))", "`1 / z` is inf"),
        ("p + 0 * ln(z)", "`ln(z)` is -inf"),
        ("min(p, 1e400)", "`1e400` is inf"),
        ("{p", "`{` is not closed by `}`"),
    ] {
        let found = length(&line("z = 0.0\np = 900.0", &format!("\"{length_m}\"")));
        let fault = found.unwrap_err()[0].to_string();
        assert!(
            fault.contains(why) && fault.starts_with("x.toml:13:"),
            "{length_m}: {fault}"
        );
    }
    // In a parameter, on the command line and in load cases as well.
    let faults = length(&line("z = 0.0\np = \"max(9, ln(z - 1))\"", "\"p\"")).unwrap_err();
    assert_eq!(
        (faults[0].line, faults[0].key.as_str()),
        (5, "parameters.p")
    );
    let text = line("z = 0.0", "5.0");
    let set = case::edit::set(&text, "line.rope.length_m", "min(sqrt(z - 1), 3)");
    assert!(set.unwrap_err().problem.contains("`sqrt(z - 1)` is NaN"));
}

/// A load case, a typed value and a number of a file of 100,000 digits: by the square of them 3.8 s.
#[test]
fn a_number_of_many_digits_is_answered_at_once() {
    let dir = tempfile::tempdir().unwrap();
    let digits = format!("0.{}", "1".repeat(100_000));
    let text = line("p = 1.0", "5.0");
    fs::write(dir.path().join("case.toml"), &text).unwrap();
    let table = format!("current.speed_m_per_s\n{digits}\n{digits}x\n");
    fs::write(dir.path().join("cells.csv"), table).unwrap();
    let begun = Instant::now();
    let done = program(
        dir.path(),
        &["sweep", "case.toml", "--load-cases", "cells.csv"],
    )
    .output();
    let said = stderr(&done.unwrap());
    assert!(
        begun.elapsed() < Duration::from_secs(3),
        "{:?}",
        begun.elapsed()
    );
    assert!(
        said.contains("cells.csv:3:1") && said.contains("characters left out"),
        "{said}"
    );
    assert!(said.len() < 10_000, "{}", said.len());
    let begun = Instant::now();
    let faults = length(&line("p = 1.0", &digits)).unwrap_err();
    assert!(
        faults[0].problem.contains("a number is 100002 bytes long"),
        "{}",
        faults[0]
    );
    for value in [
        digits.clone(),
        format!("{digits} m"),
        format!("\"{digits}\""),
    ] {
        drop(case::edit::set(&text, "line.rope.length_m", &value));
    }
    assert!(
        begun.elapsed() < Duration::from_secs(2),
        "{:?}",
        begun.elapsed()
    );
}

#[test]
fn a_byte_order_mark_before_load_cases_says_nothing() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("case.toml"), line("p = 1.0", "5.0")).unwrap();
    fs::write(
        dir.path().join("cells.csv"),
        "\u{feff}current.speed_m_per_s\r\n0.1\r\n0.2\r\n",
    )
    .unwrap();
    let words = [
        "sweep",
        "case.toml",
        "--load-cases",
        "cells.csv",
        "--no-store",
    ];
    let done = program(dir.path(), &words).output().unwrap();
    assert!(done.status.success(), "{}", stderr(&done));
}

/// The program in a folder.
fn program(dir: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.args(words).current_dir(dir).stdin(Stdio::null());
    command.env("NO_COLOR", "1");
    command
}

fn stderr(done: &Output) -> String {
    String::from_utf8_lossy(&done.stderr).into_owned()
}

/// Whether a program catches a signal.
fn catches(child: &Child, signal: Signal) -> bool {
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal.as_raw() - 1) & 1 == 1)
}

/// How long a command takes to end after a signal that it gets while it is busy, and its exit status; nothing where it was done before.
fn time_to_end(
    dir: &Path,
    words: &[&str],
    wait: Duration,
    signal: Signal,
) -> Option<(Duration, Option<i32>)> {
    let mut child = program(dir, words)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begun = Instant::now();
    while !catches(&child, Signal::TERM) && begun.elapsed() < Duration::from_secs(10) {
        thread::sleep(Duration::from_millis(1));
    }
    thread::sleep(wait);
    let was_busy = child.try_wait().unwrap().is_none();
    let sent = Instant::now();
    let _ = kill_process(
        Pid::from_raw(i32::try_from(child.id()).unwrap()).unwrap(),
        signal,
    );
    let status = child.wait().unwrap();
    was_busy.then(|| (sent.elapsed(), status.code()))
}

/// Commands that did not look at signals while they read, checked or came to rest: each ends in a moment, with the status of the signal.
/// 0.3 s where the program has a core to itself, more where it has not.
#[cfg(target_os = "linux")]
#[test]
fn signals_end_what_has_nothing_to_save() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path();
    let put = |name: &str, text: &str| -> PathBuf {
        let file = path.join(name);
        fs::write(&file, text).unwrap();
        file
    };
    put("many.toml", &many_lines(160));
    let cases = "[[load_cases]]\nkey = \"current.speed_m_per_s\"\nvalues = [0.5, 0.6, 0.7, 0.8]\n";
    put("cases.toml", &(many_lines(160) + cases));
    let row = |i: u32| format!("{},{},0,0\n", f64::from(i) / 1000.0, i % 2);
    let rows: String = (0..1_500_000).map(row).collect();
    put("path.csv", &format!("time_s,x_m,y_m,z_m\n{rows}"));
    let moving = "kind = \"moving\"\nmotion = \"table\"\nmotion_file = \"path.csv\"\nmotion_interpolation = \"linear\"";
    put(
        "moved.toml",
        &line("p = 1.0", "5.0").replacen("kind = \"fixed\"", moving, 1),
    );
    let (soon, later) = (Duration::from_millis(30), Duration::from_millis(500));
    for (words, wait, signal, code) in [
        (&["run", "many.toml"][..], later, Signal::INT, 130),
        (&["run", "many.toml", "--json"], later, Signal::TERM, 143),
        (&["sweep", "cases.toml"], later, Signal::INT, 130),
        (&["validate", "many.toml"], later, Signal::TERM, 143),
        (&["run", "moved.toml"], soon, Signal::INT, 130),
    ] {
        let Some((took, found)) = time_to_end(path, words, wait, signal) else {
            panic!("{words:?} was not busy");
        };
        println!("{words:?}: {:.3} s", took.as_secs_f64());
        assert_eq!(found, Some(code), "{words:?}");
        assert!(took < Duration::from_secs(3), "{words:?}: {took:?}");
    }
}
