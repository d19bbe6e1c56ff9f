//! `seacable run`: a case computed and kept.

use seacable_base::visible;
use std::{
    path::{Path, PathBuf},
    process::ExitCode,
    sync::atomic::AtomicBool,
};

use super::{
    BAD_RESULT, CommandError, args::RunArgs, cases, jobs, output, progress, signals::StopFlag,
    system, verdict,
};
use seacable_base::strays;
use seacable_jobs::JobRequest;
use seacable_model::case;
use seacable_model::kinds::{FileBytes, FileType};
use seacable_report::{limits, run_json, text, verdict::RunVerdict};
use seacable_runs::run::{
    Run, RunInfo, RunState,
    job::{self, JobEvent, Request},
    resume_request,
    store::{self, RunLocation, StoringRecorder},
};
use seacable_studies::study::seas::SeaQuestion;
use serde_json::json;

pub(super) fn run(args: &RunArgs) -> Result<ExitCode, CommandError> {
    // Before anything is read: a signal that comes meanwhile stops the run at its start, and leaves it as one that can be resumed.
    let stop = StopFlag::listen()?;
    let mut file = args.case.as_deref().map(FileBytes::read);
    if let Some(file) = file.take_if(|file| file.kind() == FileType::System) {
        return system::system(args, file, &stop);
    }
    if let Some(dir) = &args.resume
        && FileType::of_path(&dir.join(store::CASE)) == FileType::System
    {
        return system::resume(args, dir, &stop);
    }
    let (request, from) = match &args.resume {
        Some(dir) => resume_request(dir, args.until).map_err(CommandError::Usage)?,
        None => {
            let file = file.unwrap_or_else(|| FileBytes::read(Path::new("")));
            (request(args, file)?, None)
        }
    };
    if args.detach {
        let request = JobRequest::Line(Box::new(request), from.map(Box::new));
        return jobs::detach(&request, case_of(args), args.out.as_deref(), args.json);
    }
    let question = verdict::checks(SeaQuestion::of_line(&request.case))?;
    let info = request.initial_info();
    let text = case::stand_alone(&request.text, &request.case).into_owned();
    let stored = stored(args, &info, &text, &stop, &mut |cancel, events| {
        job::execute_from(&request, from.as_ref(), cancel, events)
    })?;
    let RunWithFolder { run, dir } = stored;
    let found = verdict::of_run(&question, &run, &dir);
    let found = found.as_ref();
    if args.json {
        let mut object = run_json::run(&run, &dir);
        object["checks"] = json!(found.map(RunVerdict::to_json));
        output::object(&object)?;
        return Ok(verdict::status(found, status(&run, &stop)));
    }
    let mut text = format!("{}\n\n{}", visible::path(&dir), text::summary(&run));
    if let Some(limits) = limits::of_run(&request.case, run.profile()) {
        text.push_str(&format!("\n{}", limits.to_text(text::WIDTH)));
    }
    text.push_str(&accuracy(&run));
    if let Some(damping) = text::numerical_damping(&run.info.settings) {
        text.push_str(&format!("\nNumerical damping: {damping}\n"));
    }
    text.push_str(&verdict::text(found));
    output::results(&text, args.ascii)?;
    Ok(verdict::status(found, status(&run, &stop)))
}

/// What a search for an accuracy came to, if there was one.
pub(super) fn accuracy(run: &Run) -> String {
    let accuracy = run.info.settings.accuracy.as_ref();
    accuracy.map_or_else(String::new, |words| format!("\nAccuracy: {words}\n"))
}

/// What --accuracy and --budget set.
pub(super) fn search(args: &RunArgs) -> Vec<String> {
    let accuracy = args.accuracy.map(|a| format!("solver.accuracy={a:?}"));
    let budget = args.budget.map(|b| format!("solver.budget_s={b:?}"));
    accuracy.into_iter().chain(budget).collect()
}

/// The file that a run is of: the case, or that of the run resumed.
pub(super) fn case_of(args: &RunArgs) -> &Path {
    let resumed = args.resume.as_deref();
    args.case.as_deref().or(resumed).unwrap_or(Path::new(""))
}

/// The case with every `--set` and `--solver` applied, in their order.
fn request(args: &RunArgs, file: FileBytes) -> Result<Request, CommandError> {
    let mut overrides = args.set.clone();
    overrides.extend(args.solver.map(|s| format!("solver.method={}", s.name())));
    overrides.extend(search(args));
    let loaded = cases::load_set(file, &overrides)?;
    Ok(Request {
        case: loaded.case,
        text: loaded.text,
        file: loaded.file,
        overrides,
        id: String::new(),
    })
}

/// A run, and the directory that holds it.
pub(super) struct RunWithFolder {
    pub(super) run: Run,
    pub(super) dir: PathBuf,
}

/// What computes a run until it is cancelled, and says what it records.
type Compute<'a> = &'a mut dyn FnMut(&AtomicBool, &mut dyn FnMut(JobEvent)) -> Run;

/// Computes, and writes every result to disk as it comes, to `--out` or below the default directory. The run is cancelled if
/// writing fails.
pub(super) fn stored(
    args: &RunArgs,
    info: &RunInfo,
    case_text: &str,
    stop: &StopFlag,
    compute: Compute<'_>,
) -> Result<RunWithFolder, CommandError> {
    let place = match &args.out {
        Some(dir) => RunLocation::Exactly(dir.clone()),
        None => RunLocation::Below(store::DEFAULT_ROOT.into()),
    };
    let mut recorder = StoringRecorder::begin(&place, info.clone(), case_text)?;
    if let Some(dir) = &args.resume {
        strays::remove(dir, &[]);
    }
    let mut line = progress::ProgressLine::new();
    let mut run = compute(stop.cancel(), &mut |event: JobEvent| {
        match &event {
            JobEvent::Searching(search) => line.show(&search.to_string()),
            JobEvent::Frame(frame) => line.run(&frame.progress),
            JobEvent::Estimating => line.show("Estimating the numerical errors"),
            JobEvent::Started { .. }
            | JobEvent::Case(_)
            | JobEvent::Checkpoint(_)
            | JobEvent::Finished(_) => {}
        }
        if !recorder.event(&event) {
            stop.request();
        }
    });
    drop(line);
    let dir = recorder.finish(&mut run, stop.status().is_some())?;
    Ok(RunWithFolder { run, dir })
}

/// Greatest number of warnings that are printed.
const MOST_WARNINGS: usize = 20;

/// Warnings, how the run ended, and the exit status.
pub(super) fn status(run: &Run, stop: &StopFlag) -> ExitCode {
    let warnings = &run.info.warnings;
    for warning in warnings.iter().take(MOST_WARNINGS) {
        output::message(&format!("warning: {warning}"));
    }
    if let more @ 1.. = warnings.len().saturating_sub(MOST_WARNINGS) {
        output::message(&format!("{more} more warnings are in run.toml."));
    }
    match run.info.state {
        RunState::Done => ExitCode::SUCCESS,
        RunState::Cancelled | RunState::Partial => {
            output::message("The run was stopped before its end; its results so far are kept.");
            stop.status().unwrap_or(ExitCode::from(BAD_RESULT))
        }
        RunState::Failed => {
            let why = run.info.failure.as_deref().unwrap_or("no reason was given");
            output::message(&format!("error: The run failed: {why}"));
            ExitCode::from(BAD_RESULT)
        }
    }
}
