//! What it costs that runs are processes of their own: from the key to the running and to the finished run, beside the same inside the
//! program, and bytes a second on the socket of a job. Run with `cargo bench --bench jobs`; after `--`: `repeats=15`,
//! `case=cases/pendulous/manifold.toml`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

#[expect(dead_code, reason = "the tests use the rest")]
#[path = "../tests/common/pty.rs"]
mod pty;
#[path = "../tests/common/small.rs"]
mod small;

use std::io::Read;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use pty::{Pty, Start, wait_until};
use seacable::jobs::client::Connection;
use seacable::jobs::{JobFolder, JobFolderState};
use small::SMALL;

/// Runs inside the program, and as processes.
const MODES: [(&str, &[&str]); 2] = [("inside the program", &["--in-process"]), ("as a job", &[])];

/// A case whose run does not end by itself.
const ENDLESS: &str = "endless.toml";

/// How long bytes are counted.
const COUNTED: Duration = Duration::from_secs(5);

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let value = |name: &str, otherwise: &str| {
        let mut found = words
            .iter()
            .filter_map(|w| w.strip_prefix(name)?.strip_prefix('='));
        found.next_back().unwrap_or(otherwise).to_owned()
    };
    let repeats: usize = value("repeats", "15").parse().unwrap();
    let case = value("case", "cases/pendulous/manifold.toml");
    println!("{case}, medians of {repeats}");
    for (name, args) in MODES {
        let times = (0..repeats).map(|_| until_running(args)).collect();
        println!(
            "{:44}{:>9.1} ms",
            format!("`R` to running, {name}"),
            median(times)
        );
    }
    for (name, args) in MODES {
        println!(
            "{:44}{:>9.1} ms",
            format!("`R` to done, {name}"),
            median(until_done(args, &case, repeats))
        );
    }
    bytes();
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn endless() -> tempfile::TempDir {
    let dir = pty::place();
    let endless = SMALL.replace(
        "duration_s = 5.0",
        "duration_s = 500000.0\ntime_step_s = 0.01",
    );
    std::fs::write(dir.path().join(ENDLESS), endless).unwrap();
    dir
}

fn start(args: &[&str], case: &str, dir: tempfile::TempDir) -> Pty {
    let args: Vec<&str> = args.iter().copied().chain([case]).collect();
    let start = Start {
        size: (120, 40),
        args: &args,
        script: r#"exec "$0" "$@""#,
        ..Start::default()
    };
    let screen = start.go_in(dir);
    screen.wait_for("solver alpha");
    screen
}

/// From the key until the list of jobs shows that the run computes \[ms\].
fn until_running(args: &[&str]) -> f64 {
    let mut screen = start(args, ENDLESS, endless());
    screen.send("6");
    screen.wait_for("live: endless");
    let begun = Instant::now();
    screen.send("R");
    screen.wait("a job that computes", |screen| {
        let text = screen.contents();
        let mut lines = text.lines().filter(|line| line.contains("endless, alpha"));
        lines.any(|line| line.contains("step ") || line.contains("starting"))
    });
    let took = begun.elapsed();
    end(screen);
    took.as_secs_f64() * 1e3
}

/// Kills a screen; a job ends as its folder is gone.
fn end(screen: Pty) {
    let dir = screen.kill();
    for folder in folders(&dir) {
        folder.remove().unwrap();
        wait_until("the job has ended", || {
            folder.state() != JobFolderState::Held
        });
    }
}

fn folders(dir: &tempfile::TempDir) -> Vec<JobFolder> {
    let jobs = dir.path().join(".local/state/seacable/jobs");
    let hosts = std::fs::read_dir(jobs).into_iter().flatten().flatten();
    let inside = hosts.flat_map(|host| {
        std::fs::read_dir(host.path())
            .into_iter()
            .flatten()
            .flatten()
    });
    inside
        .filter_map(|item| JobFolder::open(&item.path()).ok())
        .collect()
}

/// From the key until the run is done and shown, one after the other \[ms\].
fn until_done(args: &[&str], case: &str, repeats: usize) -> Vec<f64> {
    let mut screen = start(args, case, pty::place());
    // The live solve is over when the table of runs says so.
    screen.send("3");
    screen.wait("the live run", |screen| {
        let text = screen.contents();
        text.contains("in memory") && text.contains(" done ")
    });
    let times = (0..repeats).map(|_| {
        let begun = Instant::now();
        screen.send("R");
        screen.wait_for("is done");
        let took = begun.elapsed();
        screen.send("j");
        screen.wait("no message", |screen| {
            !screen.contents().contains("is done")
        });
        took.as_secs_f64() * 1e3
    });
    times.collect()
}

/// Bytes a second on the socket of a job that records 200 rows a second and more, with and without its rows.
fn bytes() {
    let dir = endless();
    let begun = Command::new(env!("CARGO_BIN_EXE_seacable"))
        .args(["run", "--detach", ENDLESS])
        .current_dir(dir.path())
        .env("HOME", dir.path())
        .stdout(Stdio::null())
        .status();
    assert!(begun.unwrap().success());
    let folder = folders(&dir).remove(0);
    for (name, rows) in [("with rows", true), ("without", false)] {
        wait_until("the job listens", || Connection::open(&folder).is_ok());
        let connection = Connection::open(&folder).unwrap();
        connection.follow(rows).unwrap();
        let mut stream = connection.bytes().unwrap();
        let (begun, mut count, mut first) = (Instant::now(), 0, 0);
        let mut buffer = vec![0_u8; 1 << 16];
        while begun.elapsed() < COUNTED {
            let read = stream.read(&mut buffer).unwrap();
            // The record so far comes at once.
            match begun.elapsed() < COUNTED / 5 {
                true => first += read,
                false => count += read,
            }
        }
        let rate = count as f64 / COUNTED.mul_f64(0.8).as_secs_f64();
        println!(
            "{:44}{:>9.1} kB/s, {:.1} kB at first",
            format!("socket, {name}"),
            rate / 1e3,
            first as f64 / 1e3
        );
    }
    folder.remove().unwrap();
    wait_until("the job has ended", || {
        folder.state() != JobFolderState::Held
    });
}
