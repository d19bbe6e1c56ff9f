//! Files of trials, read and computed.

use std::sync::atomic::AtomicBool;

use seacable::case::kind;
use seacable::import::{ImportOptions, read};
use seacable::system::motion::run::{MotionRun, run};
use seacable::system::{SolvedSystem, SystemFile};

/// The path of a file of trials.
pub(crate) fn path(name: &str) -> String {
    format!("{}/tests/trials/files/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Its text.
pub(crate) fn text(name: &str) -> String {
    std::fs::read_to_string(path(name)).unwrap()
}

/// The text of the case of a file of another program.
pub(crate) fn imported(name: &str) -> String {
    imported_with(name, &ImportOptions::default())
}

/// The same with options.
pub(crate) fn imported_with(name: &str, options: &ImportOptions) -> String {
    let read = read(&text(name), &path(name), options);
    read.unwrap_or_else(|all| panic!("{all:#?}")).text
}

/// The system of a text, at rest.
pub(crate) fn solved(text: &str) -> SolvedSystem {
    let read = kind::parse::<SystemFile>(text, "system.toml");
    read.unwrap_or_else(|all| panic!("{all:#?}\n{text}"))
}

/// Tension at end B of a line \[N\].
pub(crate) fn tension_at_b(system: &SolvedSystem, line: &str) -> f64 {
    let index = system.network.line(line).unwrap();
    system.rest.balance.lines[index].tensions()[1]
}

/// A system in motion, as its `[solver]` has it.
pub(crate) fn moved(system: &SolvedSystem) -> MotionRun {
    let given = system.file.solver.clone().unwrap();
    let run = run(system, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
    assert_eq!(run.failure, None);
    run
}

/// The values of a channel over the output times.
pub(crate) fn channel<'a>(run: &'a MotionRun, name: &str) -> &'a [f64] {
    &run.history.channel(name).unwrap().values
}
