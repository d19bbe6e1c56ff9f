//! What takes time and is done once: files read, tables parsed, systems built and brought to rest.
//!
//! In a program built with debug assertions `SEACABLE_WORK_LOG=FILE` names each in a file, a line each, so that tests see what was done
//! twice. A program built without them writes nothing.

use std::fmt::Display;

/// What is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// A file is read.
    Read,
    /// A table of coefficients is parsed from its text.
    Parse,
    /// A system is built from its file.
    Build,
    /// An equilibrium of a system is searched for.
    Rest,
    /// The answer of a file is computed.
    Solve,
}

impl Task {
    #[cfg(debug_assertions)]
    const fn name(self) -> &'static str {
        match self {
            Self::Read => "read",
            Self::Parse => "parse",
            Self::Build => "build",
            Self::Rest => "rest",
            Self::Solve => "solve",
        }
    }
}

/// Names a task in the log that a test asked for.
#[cfg(debug_assertions)]
pub fn log(task: Task, of: impl Display) {
    use std::fs::OpenOptions;
    use std::io::Write;

    let Some(log) = std::env::var_os("SEACABLE_WORK_LOG") else {
        return;
    };
    let file = OpenOptions::new().append(true).create(true).open(log);
    // A test that finds no line says so.
    let line = format!("{} {of}\n", task.name());
    let _ = file.and_then(|mut file| file.write_all(line.as_bytes()));
}

/// Nobody asks for a log.
#[cfg(not(debug_assertions))]
pub fn log(_: Task, _: impl Display) {}
