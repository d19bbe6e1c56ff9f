//! The command line: the same core as the screen, no terminal needed.
//!
//! Results go to standard output, progress and messages to standard error. Exit status: 0 when all
//! is well, 1 when a result is not good (a row outside its tolerance, a solver that gave up), 2 when
//! the work could not be done (bad input, a file that cannot be read or written), 130 and 143 when
//! stopped by SIGINT and SIGTERM.

mod args;
mod cases;
mod catenary;
mod failure;
mod inputs;
mod modes;
mod output;
mod progress;
mod report;
mod ropeway;
mod run;
mod section;
mod ship;
mod signals;
mod study;
mod validate;
mod workbench;

use std::process::ExitCode;

use clap::Parser;

use args::{Args, Command};
use failure::Failure;

/// A result is not good: a row outside its tolerance, a solver that gave up.
const NOT_GOOD: u8 = 1;
/// The work could not be done.
const BAD_INPUT: u8 = 2;

/// Parses the command line, does what it says and gives the exit status.
#[must_use]
pub fn main() -> ExitCode {
    let args = Args::parse();
    let done = match &args.command {
        None => workbench::open(args),
        Some(Command::Run(words)) => run::run(words),
        Some(Command::Validate(words)) => validate::validate(words),
        Some(Command::Report(words)) => report::report(words),
        Some(Command::Catenary(words)) => catenary::catenary(words),
        Some(Command::Section(words)) => section::section(words),
        Some(Command::Ship(words)) => ship::ship(words),
        Some(Command::Modes(words)) => modes::modes(words),
        Some(Command::Ropeway(words)) => ropeway::ropeway(words),
        Some(Command::Study(words)) => study::study(words),
    };
    done.unwrap_or_else(Failure::tell)
}
