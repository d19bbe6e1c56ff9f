//! Whatever bytes an input holds, it is read or refused: no panic, no 10 s, no 1 GiB.
//!
//! `cargo test` reads the corpus and a sample. Any number of inputs, on all cores, the same for the same seed:
//!
//! ```text
//! SEACABLE_FUZZ_INPUTS=1000000 SEACABLE_FUZZ_SEED=7 cargo test --release --test fuzz -- --ignored --nocapture
//! ```
//!
//! `SEACABLE_FUZZ_TARGET=system` reads those of one target, `SEACABLE_FUZZ_SECONDS=60` those that a minute is enough for. Faulty inputs are written below `target/fuzz`, or `SEACABLE_FUZZ_FOLDER`. One
//! that failed is made small and kept in `tests/data/corpus/TARGET`. The package in `fuzz` looks for inputs by coverage.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod corpus;
mod mutator;
mod runner;
mod targets;

use std::env;
use std::path::{Path, PathBuf};
use std::time::Duration;

use runner::{Plan, Tally, one, run, table};

/// Inputs of each target that `cargo test` makes.
const SAMPLE: u64 = 200;

/// Where faulty inputs go; a relative name is one below the repository.
fn folder() -> PathBuf {
    let given = env::var("SEACABLE_FUZZ_FOLDER").unwrap_or_else(|_| "target/fuzz".to_owned());
    Path::new(env!("CARGO_MANIFEST_DIR")).join(given)
}

fn number(name: &str, default: u64) -> u64 {
    env::var(name).map_or(default, |text| text.parse().unwrap())
}

fn assert_no_fault(tallies: &[Tally]) {
    let folder = folder();
    let faults = tallies.iter().any(|tally| !tally.faults.is_empty());
    assert!(
        !faults,
        "inputs are in {}\n{}",
        folder.display(),
        table(tallies)
    );
}

#[test]
fn what_is_shipped_is_read_by_every_target() {
    targets::enter();
    for target in targets::all() {
        for (number, seed) in (target.seeds)().iter().enumerate() {
            assert!(target.read(seed), "seed {number} of {}", target.name);
        }
    }
}

#[test]
fn inputs_that_once_failed_do_not() {
    targets::enter();
    let names: Vec<&str> = targets::all().map(|target| target.name).collect();
    for name in corpus::folders() {
        assert!(names.contains(&name.as_str()), "{name} is no target");
    }
    let tallies: Vec<Tally> = targets::all()
        .map(|target| {
            let mut tally = Tally {
                name: target.name,
                ..Tally::default()
            };
            for (_, data) in corpus::kept(target.name) {
                one(target, &data, &mut tally, &folder());
            }
            tally
        })
        .collect();
    assert_no_fault(&tallies);
}

#[test]
fn a_sample_of_changed_inputs_is_read_or_refused() {
    let tallies = run(&Plan {
        inputs: |_, _| SAMPLE,
        total: 0,
        time: Duration::MAX,
        seed: 2026,
        folder: folder(),
        only: None,
    });
    println!("{}", table(&tallies));
    assert_no_fault(&tallies);
}

#[test]
#[ignore = "reads SEACABLE_FUZZ_INPUTS inputs of the seed SEACABLE_FUZZ_SEED"]
fn as_many_inputs_as_asked_for() {
    let (total, seed) = (
        number("SEACABLE_FUZZ_INPUTS", 100_000),
        number("SEACABLE_FUZZ_SEED", 1),
    );
    println!("{total} inputs, seed {seed}");
    let tallies = run(&Plan {
        inputs: |target, each| (target.share * each).max(1),
        total,
        time: Duration::from_secs(number("SEACABLE_FUZZ_SECONDS", u64::MAX)),
        seed,
        folder: folder(),
        only: env::var("SEACABLE_FUZZ_TARGET").ok(),
    });
    println!("{}", table(&tallies));
    assert_no_fault(&tallies);
}
