//! The same files and motions in MoorDyn and here.
//!
//! Needs Python with the package `moordyn`, named by `MOORDYN_PYTHON`, so a plain `cargo test` lists these tests as ignored;
//! `.ci/run` installs it and runs them with `cargo test --test with_moordyn -- --ignored --nocapture`, which prints the table.
//!
//! MoorDyn gives the tension in the middle of the last segment, which differs from that at the end by half a segment's weight, drag and
//! inertia: of the first order in its length. Its results with N and 2 N segments are extrapolated, `2 T(2N) - T(N)`, and compared after the ramp of the motion, a fifth of the run.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod systems;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::atomic::AtomicBool;

use seacable::case::kind;
use seacable::import::{self, ImportOptions};
use seacable::system::SystemFile;
use seacable::system::motion::run::{MotionRun, run};

use systems::{SYSTEMS, System};

/// Length of the runs and of the ramp of their motions \[s\].
const DURATION: f64 = 40.0;
const RAMP: f64 = 8.0;
/// Steps of the table of motion here \[s\].
const STEP: f64 = 0.01;
/// Steps of the table for MoorDyn, in which coupled points move at a constant velocity and that changes at once between them: in steps of
/// 10 ms the waves that this sends along a chain are 1 % of its tension.
const COUPLING: f64 = 0.001;
/// Interval of the tensions that are compared \[s\].
const PRINTED: f64 = 0.1;
/// Difference by the peak that counts as the same.
const SAME: f64 = 0.005;

/// The motion at a time: amplitude times a sine that grows over the ramp, twice continuously differentiable.
fn moved(system: &System, time: f64) -> Vec<f64> {
    let s = (time / RAMP).min(1.0);
    let ramp = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
    let sine = (std::f64::consts::TAU * time / system.period).sin();
    let all = system.coupled.iter();
    all.flat_map(|(place, amplitude)| {
        let one = |axis: usize| place[axis] + amplitude[axis] * ramp * sine;
        [one(0), one(1), one(2)]
    })
    .collect()
}

fn table(system: &System, interval: f64) -> String {
    let mut text = String::new();
    let mut step = 0;
    while f64::from(step) * interval <= DURATION + 1e-9 {
        let time = f64::from(step) * interval;
        write!(text, "{time}").unwrap();
        for coordinate in moved(system, time) {
            write!(text, " {coordinate}").unwrap();
        }
        text.push('\n');
        step += 1;
    }
    text
}

/// FairTen of each line at the printed times \[N\], by MoorDyn.
fn by_moordyn(file: &Path, table: &Path) -> Vec<Vec<f64>> {
    let python = std::env::var("MOORDYN_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/with_moordyn/march.py");
    let done = Command::new(&python)
        .arg(&script)
        .args([file, table])
        .arg((PRINTED / COUPLING).round().to_string())
        .output()
        .unwrap();
    let messages = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{python}: {messages}");
    let text = String::from_utf8(done.stdout).unwrap();
    let numbers = |row: &str| {
        let words = row.split_whitespace();
        words.skip(1).map(|word| word.parse().unwrap()).collect()
    };
    text.lines().map(numbers).collect()
}

/// The same here, from the same file and table.
fn here(file: &Path, table: &Path) -> MotionRun {
    let text = fs::read_to_string(file).unwrap();
    let options = ImportOptions {
        motion: Some(table.to_owned()),
        ..ImportOptions::default()
    };
    let name = file.display().to_string();
    let imported = import::read(&text, &name, &options).unwrap();
    let text = format!("{}\n[output]\ninterval_s = {PRINTED:?}\n", imported.text);
    let solved = kind::parse::<SystemFile>(&text, &name).unwrap();
    let mut given = solved.file.solver.clone().unwrap();
    given.error_estimate = false;
    given.step_tolerance = 2e-6;
    let run = run(&solved, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
    assert_eq!(run.failure, None, "{name}");
    run
}

#[test]
#[ignore = "needs Python with the package moordyn"]
fn eight_systems_move_as_in_moordyn() {
    let folder = std::env::temp_dir().join(format!("seacable-moordyn-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let mut page =
        "system               line  peak, kN  rms, % of peak  greatest, %  mean, %\n".to_owned();
    let mut worst: f64 = 0.0;
    for system in SYSTEMS {
        let [motion, coupling] =
            [("motion.txt", STEP), ("coupling.txt", COUPLING)].map(|(name, interval)| {
                let path = folder.join(name);
                fs::write(&path, table(system, interval)).unwrap();
                path
            });
        let write = |finer: usize| {
            let path = folder.join(format!("{}-{finer}.dat", system.name));
            fs::write(&path, system.text(finer)).unwrap();
            path
        };
        let (coarse, fine) = (write(1), write(2));
        let [one, two] = [&coarse, &fine].map(|file| by_moordyn(file, &coupling));
        let run = here(&fine, &motion);
        for line in 0..system.lines {
            let name = format!("tension_n[line{}|b]", line + 1);
            let ours = &run.history.channel(&name).unwrap().values;
            let known: Vec<f64> = one
                .iter()
                .zip(&two)
                .map(|(one, two)| 2.0 * two[line] - one[line])
                .collect();
            let peak = known.iter().copied().fold(0.0, f64::max);
            // MoorDyn begins next to rest, where its relaxation stops: what is left of that has gone when the ramp ends.
            let first = known.len() / 5;
            let pairs = known.iter().zip(ours).skip(first);
            let off: Vec<f64> = pairs.map(|(a, b)| (b - a) / peak).collect();
            let mean = off.iter().sum::<f64>() / off.len() as f64;
            let rms = (off.iter().map(|d| d * d).sum::<f64>() / off.len() as f64).sqrt();
            let greatest = off.iter().map(|d| d.abs()).fold(0.0, f64::max);
            writeln!(
                page,
                "{:20} {:5} {:9.2} {:14.3} {:12.3} {:8.3}",
                system.name,
                line + 1,
                peak / 1e3,
                1e2 * rms,
                1e2 * greatest,
                1e2 * mean
            )
            .unwrap();
            worst = worst.max(rms);
        }
    }
    println!("{page}");
    fs::remove_dir_all(&folder).unwrap();
    assert!(worst < SAME, "{page}");
}
