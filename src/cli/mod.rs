//! The command line: the same core as the screen, no terminal needed.
//!
//! Results go to standard output, progress and messages to standard error. Exit status: 0 when all
//! is well, 1 when a result is not good (a row outside its tolerance, a solver that gave up), 2 when
//! the work could not be done (bad input, a file that cannot be read or written), 130 and 143 when
//! stopped by SIGINT and SIGTERM.

mod args;
mod cases;
mod catenary;
mod error;
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
use error::CommandError;

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
        Some(Command::Run(args)) => run::run(args),
        Some(Command::Validate(args)) => validate::validate(args),
        Some(Command::Report(args)) => report::report(args),
        Some(Command::Catenary(args)) => catenary::catenary(args),
        Some(Command::Section(args)) => section::section(args),
        Some(Command::Ship(args)) => ship::ship(args),
        Some(Command::Modes(args)) => modes::modes(args),
        Some(Command::Ropeway(args)) => ropeway::ropeway(args),
        Some(Command::Study(args)) => study::study(args),
    };
    done.unwrap_or_else(CommandError::report)
}
