//! The command line: the same core as the screen, no terminal needed.
//!
//! Results go to standard output, progress and messages to standard error. Exit status: 0 for
//! success, 1 for a bad result (a row outside its tolerance, a solver that failed), 2 when
//! the command could not be carried out (bad input, a file that cannot be read or written), 130 and 143 when
//! stopped by SIGINT and SIGTERM.

mod about_args;
mod args;
mod audit;
mod bindings;
mod cases;
mod catenary;
mod common_args;
mod compare;
mod doctor;
mod duration;
mod effects;
mod error;
mod exit_status;
mod export;
mod import;
mod inputs;
mod job;
mod jobs;
mod keys;
mod kinds;
mod laboratory;
mod limit_args;
mod lines;
mod manual;
mod model_args;
mod modes;
mod output;
mod physics;
mod progress;
mod report;
mod ropeway;
mod rules;
mod run;
mod section;
mod ship;
mod signals;
mod slurm_args;
mod slurm_refusals;
mod slurm_words;
mod statistics;
mod studied_scene;
mod study;
mod study_args;
mod study_page;
mod study_table;
mod sweep;
mod sweep_args;
mod sweep_compute;
mod sweep_part;
mod sweep_plan;
mod sweep_quick;
mod sweep_slurm;
mod sweep_window;
mod system;
mod system_args;
mod system_study;
mod validate;
mod vary;
mod verdict;
mod words;
mod workbench;

use seacable_base::visible;
use seacable_report::sweep::SweepPage;
use std::{panic, process::ExitCode};

use clap::Parser;

use seacable_base::files::{read, root};

use args::{Args, CliCommand};
use limit_args::ReadingArgs;

use error::CommandError;
use exit_status::{BAD_INPUT, BAD_RESULT};

/// Parses the command line, runs the command and returns the exit status.
#[must_use]
pub fn main() -> ExitCode {
    panic::set_hook(Box::new(output::report_panic));
    let words = words::command_first(std::env::args_os().collect());
    let args = match Args::try_parse_from(&words) {
        Ok(args) => args,
        Err(error) => {
            return words::no_text(&words, &error).unwrap_or_else(|| output::usage(&error, &words));
        }
    };
    args.limits.apply();
    if let Err(error) = reading(&args.reading) {
        return error.report();
    }
    let done = match &args.command {
        None => workbench::open(args),
        Some(CliCommand::Run(args)) => run::run(args),
        Some(CliCommand::Validate(args)) => validate::validate(args),
        Some(CliCommand::Report(args)) => report::report(args),
        Some(CliCommand::Compare(args)) => compare::compare(args),
        Some(CliCommand::Catenary(args)) => catenary::catenary(args),
        Some(CliCommand::Section(args)) => section::section(args),
        Some(CliCommand::Lines(args)) => lines::lines(args),
        Some(CliCommand::Rules(args)) => rules::rules(args),
        Some(CliCommand::Ship(args)) => ship::ship(args),
        Some(CliCommand::Modes(args)) => modes::modes(args),
        Some(CliCommand::Ropeway(args)) => ropeway::ropeway(args),
        Some(CliCommand::Import(args)) => import::import(args),
        Some(CliCommand::Export(args)) => export::export(args),
        Some(CliCommand::Audit(args)) => audit::audit(args),
        Some(CliCommand::Keys(args)) => keys::keys(args),
        Some(CliCommand::Bindings(args)) => bindings::bindings(args),
        Some(CliCommand::Doctor(args)) => doctor::doctor(args),
        Some(CliCommand::Completions(args)) => manual::completions(args),
        Some(CliCommand::Man(args)) => manual::man(args),
        Some(CliCommand::InstallManual(args)) => manual::install(args),
        Some(CliCommand::Study(args)) => study::study(args),
        Some(CliCommand::Laboratory(args)) => laboratory::laboratory(args),
        Some(CliCommand::Sweep(args)) => sweep::sweep(args, SweepPage::Sweep),
        Some(CliCommand::Statistics(args)) => statistics::statistics(args),
        Some(CliCommand::Jobs(args)) => jobs::jobs(args),
        Some(CliCommand::Job(args)) => job::job(args),
    };
    done.unwrap_or_else(CommandError::report)
}

/// Sets what files are read by.
fn reading(args: &ReadingArgs) -> Result<(), CommandError> {
    if let Some(bytes) = args.limit_file_size {
        read::limit(bytes);
    }
    let Some(dir) = &args.root else {
        return Ok(());
    };
    root::set(dir).map_err(|error| {
        CommandError::Usage(format!(
            "--root: {} is no directory to read: {error}.",
            visible::path(dir)
        ))
    })
}
