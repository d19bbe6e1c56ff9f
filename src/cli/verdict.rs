//! The verdict of the checks of a file, below what a run prints.

use std::path::Path;
use std::process::ExitCode;

use super::{BAD_RESULT, CommandError, output};
use seacable_model::checks::utilisation::UtilisationVerdict;
use seacable_report::{text::WIDTH, verdict::RunVerdict};
use seacable_runs::run::{Run, RunState};
use seacable_studies::study::seas::SeaQuestion;

/// The checks of a file, or why they cannot be used: said before anything is computed.
pub(super) fn checks(question: Result<SeaQuestion, String>) -> Result<SeaQuestion, CommandError> {
    question.map_err(CommandError::Usage)
}

/// The verdict on a run that came to its end.
pub(super) fn of_run(question: &SeaQuestion, run: &Run, dir: &Path) -> Option<RunVerdict> {
    let done = run.info.state == RunState::Done;
    done.then(|| RunVerdict::of_run(question, dir, &run.summary))?
}

/// Below the results of a run.
pub(crate) fn text(verdict: Option<&RunVerdict>) -> String {
    let table = verdict.map(|found| found.table().to_text(output::page_width(Some(WIDTH))));
    table.map_or_else(String::new, |table| format!("\n{table}"))
}

/// The exit status: that of the run, and where that is well, of checks that fail.
pub(super) fn status(verdict: Option<&RunVerdict>, run: ExitCode) -> ExitCode {
    let fails = verdict.and_then(RunVerdict::worst) == Some(UtilisationVerdict::Fails);
    match fails && run == ExitCode::SUCCESS {
        true => ExitCode::from(BAD_RESULT),
        false => run,
    }
}
