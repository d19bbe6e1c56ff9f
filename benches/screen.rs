//! What the screen makes its user wait for: the real program on a pseudo-terminal with many stored runs. Prints the time to
//! the first full frame, from a key to its paint (idle, and with every core computing), frames a second while a key is held,
//! the CPU time of a frame, and from a key to the coarse and to the full answer of the solver. Run with `cargo bench --bench screen`; after `--`: `runs=10000`, `size=200x60`,
//! `case=cases/pendulous/module.toml`, `program=PATH` for another build of the program.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

#[path = "screen/answers.rs"]
mod answers;
#[expect(dead_code, reason = "the tests use the rest")]
#[path = "../tests/common/pty.rs"]
mod pty;
#[path = "screen/stored_runs.rs"]
mod stored_runs;
#[path = "screen/times.rs"]
mod times;

use std::time::{Duration, Instant};

use pty::{Pty, Start};
use times::{Times, cpu_time};

/// What is asked for after `--`.
struct Asked {
    runs: usize,
    size: (u16, u16),
    case: String,
    program: String,
}

impl Asked {
    fn read() -> Self {
        let words: Vec<String> = std::env::args().skip(1).collect();
        let value = |name: &str, otherwise: &str| {
            let mut found = words
                .iter()
                .filter_map(|w| w.strip_prefix(name)?.strip_prefix('='));
            found.next_back().unwrap_or(otherwise).to_owned()
        };
        let size = value("size", "200x60");
        let (columns, rows) = size.split_once('x').unwrap();
        Self {
            runs: value("runs", "10000").parse().unwrap(),
            size: (columns.parse().unwrap(), rows.parse().unwrap()),
            case: value("case", "cases/pendulous/module.toml"),
            program: value("program", env!("CARGO_BIN_EXE_seacable")),
        }
    }
}

fn main() {
    let asked = Asked::read();
    let (columns, rows) = asked.size;
    println!(
        "{} with {} stored runs, {columns}x{rows}",
        asked.case, asked.runs
    );
    let dir = pty::place();
    stored_runs::make(dir.path(), &asked.case, asked.runs, &asked.program);

    let (first, began) = (start(&asked, dir), Instant::now());
    println!(
        "{:44}{:>9.0} ms",
        "start to full frame, no index yet",
        waited(&first, began)
    );
    let answered = first_key(first, began);
    println!("{:44}{:>9.0} ms", "  first key painted after", answered.1);
    let mut screen = answered.0;
    unfiltered(&mut screen);
    screen.send("3");
    screen.wait_for(&format!("run ({})", asked.runs));
    println!(
        "{:44}{:>9.0} ms",
        "all runs read and in the table after",
        elapsed(began)
    );
    screen.send("1");
    settle(&screen);
    keys("key to paint, idle", &mut screen);
    unfiltered(&mut screen);
    screen.send("q");
    screen.ended(0);

    let dir = std::mem::replace(&mut screen.dir, tempfile::tempdir().unwrap());
    let (again, began) = (start(&asked, dir), Instant::now());
    println!(
        "{:44}{:>9.0} ms",
        "start to full frame, again",
        waited(&again, began)
    );
    let (mut screen, after) = first_key(again, began);
    println!("{:44}{:>9.0} ms", "  first key painted after", after);
    unfiltered(&mut screen);
    let all = format!("run ({})", asked.runs);
    let began = Instant::now();
    screen.send("3");
    screen.wait_for(&all);
    println!(
        "{:44}{:>9.0} ms",
        "table of all runs after its key",
        elapsed(began)
    );
    // Without the solve of the start, which is not what a key costs.
    settle(&screen);
    keys("key to paint, filter of the table", &mut screen);
    unfiltered(&mut screen);
    screen.send("1");
    // The published values of the case need many runs: all cores compute from now on.
    screen.send("V");
    screen.send("1");
    keys("key to paint, cores computing", &mut screen);
    held("frames a second while a key is held", &mut screen);
    drop(screen);

    let mut screen = start(&asked, pty::place());
    waited(&screen, Instant::now());
    answers::print(&mut screen);
}

/// Starts the program with the case, in a directory with its runs.
fn start(asked: &Asked, dir: tempfile::TempDir) -> Pty {
    let script = format!(
        r#""{}" "$@"; echo "[ended $?]"; read -r line"#,
        asked.program
    );
    let start = Start {
        size: asked.size,
        args: &[&asked.case],
        script: &script,
        ..Start::default()
    };
    start.go_in(dir)
}

/// Since then \[ms\].
fn elapsed(began: Instant) -> f64 {
    began.elapsed().as_secs_f64() * 1e3
}

/// Until the whole screen is there \[ms\].
fn waited(screen: &Pty, began: Instant) -> f64 {
    screen.wait("the full frame", |screen| {
        let text = screen.contents();
        text.contains("Inputs") && text.contains("q quit")
    });
    elapsed(began)
}

/// Until a key pressed at once is painted \[ms\].
fn first_key(mut screen: Pty, began: Instant) -> (Pty, f64) {
    screen.send("/");
    screen.wait_for("filter: ");
    (screen, elapsed(began))
}

/// Drops the filter.
fn unfiltered(screen: &mut Pty) {
    screen.send("\x1b");
    screen.wait("no filter", |screen| {
        !screen.contents().contains("filter: ")
    });
}

/// Until the program is quiet: no new bytes for a while.
fn settle(screen: &Pty) {
    let mut seen = 0;
    loop {
        std::thread::sleep(Duration::from_millis(500));
        let now = screen.bytes().len();
        if now == seen {
            return;
        }
        seen = now;
    }
}

/// Types into the filter of the inputs, and waits for each letter.
fn keys(what: &str, screen: &mut Pty) {
    if !screen.text().contains("filter: ") {
        screen.send("/");
        screen.wait_for("filter: ");
    }
    let (process, mut times) = (screen.process(), Times::default());
    let cpu = cpu_time(process);
    for round in 0..100 {
        for (key, text) in [("a", "filter: a"), ("\x7f", "filter: ")] {
            // Not in step with anything that the program does at fixed intervals.
            std::thread::sleep(Duration::from_millis(23 + (round * 7) % 31));
            let began = Instant::now();
            screen.send(key);
            screen.wait(text, |screen| {
                let line = screen.contents();
                let at = line.find("filter: ").map(|at| &line[at..]);
                at.is_some_and(|at| at.starts_with("filter: a") == (key == "a"))
            });
            times.add(began.elapsed());
        }
    }
    println!("{what:44}{}", times.words());
    let each = (cpu_time(process) - cpu).as_secs_f64() * 1e3 / 200.0;
    println!("{:44}{each:>9.1} ms", "  CPU time of the process a key");
}

/// The left part of the screen with its colours: the inputs and their cursor, not the charts.
fn inputs(screen: &Pty) -> String {
    let found = std::cell::RefCell::default();
    screen.wait("a look at it", |screen| {
        let rows = screen.rows_formatted(0, 60).take(40);
        found.replace(rows.collect());
        true
    });
    found.into_inner()
}

/// Holds a key for three seconds at 30 a second, and counts the screens that differ.
fn held(what: &str, screen: &mut Pty) {
    unfiltered(screen);
    let (began, mut last, mut frames) = (Instant::now(), inputs(screen), 0_u32);
    let mut sent = 0_u32;
    while began.elapsed() < Duration::from_secs(3) {
        if began.elapsed() > Duration::from_millis(33) * sent {
            screen.send(if sent % 60 < 30 { "j" } else { "k" });
            sent += 1;
        }
        std::thread::sleep(Duration::from_millis(2));
        let now = inputs(screen);
        if now != last {
            frames += 1;
            last = now;
        }
    }
    println!("{what:44}{:>9.1}", f64::from(frames) / 3.0);
}
