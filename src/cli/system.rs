//! `seacable run` on a system of lines: at rest, or in time; as a report or as JSON.

use seacable_base::visible;
use seacable_display::chart::Glyphs;
use serde_json::json;
use std::{path::Path, process::ExitCode, sync::Arc};

use super::{
    CommandError,
    args::RunArgs,
    cases::EditedFile,
    jobs, output,
    progress::ProgressLine,
    run::{RunWithFolder, accuracy, case_of, search, status, stored},
    signals::StopFlag,
    verdict,
};
use seacable_jobs::JobRequest;
use seacable_model::case::kind;
use seacable_model::kinds::FileBytes;
use seacable_report::{
    system::{self as views, json, motion},
    text::WIDTH,
    verdict::RunVerdict,
};
use seacable_runs::run::accuracy::searchable::Asked;
use seacable_runs::run::job::{JobEvent, Request, execute, execute_from};
use seacable_runs::run::{Run, RunState, resume_request};
use seacable_studies::study::seas::SeaQuestion;
use seacable_systems::system::{
    SystemFile,
    analysis::analyses::Analyses,
    at_rest::SystemAtRest,
    motion::checkpoint::ResumedSystem,
    motion::job::{self, SystemRequest},
    validation,
};

pub(super) fn system(
    args: &RunArgs,
    file: FileBytes,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let set = overrides(args);
    let file = EditedFile::<SystemFile>::read(file, &set, &args.import.options())?;
    if file.content().as_run().is_some() {
        let search = search(args);
        let file = file.with(&search)?;
        return computed_run(args, file, [&set[..], &search].concat(), stop);
    }
    if args.detach {
        return Err(CommandError::Usage(
            "Systems of lines at rest do not take --detach: they are printed, not kept; a table `[solver]` makes a run, with `method = \"static\"` of their rest.".to_owned(),
        ));
    }
    if args.out.is_some() {
        return Err(CommandError::Usage(
            "Systems of lines do not take --out without a table `[solver]`: they are printed, not kept; add it with `method = \"static\"`, or redirect the output.".to_owned(),
        ));
    }
    let searched = searched(args, &file, stop);
    let found = searched.as_ref().map(|run| run.info.overrides.as_slice());
    let file = file.with(found.unwrap_or_default())?.compute()?;
    let solved = &file.computed;
    let analyses = match args.json {
        true => Analyses::of_object(solved),
        false => Analyses::of_system(solved),
    };
    if let Some(stopped) = stop.status() {
        return Ok(stopped);
    }
    let reached = searched.as_ref();
    if args.json {
        let mut object = json::object(solved, &analyses);
        if let Some(run) = reached {
            object["accuracy"] = json!(run.info.settings.accuracy);
        }
        output::object(&object)?;
        return Ok(reached.map_or(ExitCode::SUCCESS, |run| status(run, stop)));
    }
    let question = verdict::checks(SeaQuestion::of_system(solved))?;
    let found = RunVerdict::of_equilibrium(&question, solved);
    let rows = validation::rows(solved, None);
    let report = views::report(solved, &analyses, &rows, &file.fields());
    let text = report.to_text(WIDTH, output::glyphs(args.ascii));
    let text = format!("{text}{}", reached.map_or_else(String::new, accuracy));
    output::results(&text, args.ascii)?;
    let status = reached.map_or(ExitCode::SUCCESS, |run| status(run, stop));
    Ok(verdict::status(found.as_ref(), status))
}

/// The search for the accuracy that is asked of a system at rest, whose overrides are the segments that it found; none where none is asked, or
/// where nothing comes to rest, which the file says better.
fn searched(args: &RunArgs, file: &EditedFile<'_, SystemFile>, stop: &StopFlag) -> Option<Run> {
    let asked = Asked {
        accuracy: args.accuracy?,
        budget_s: args.budget,
    };
    let case = SystemAtRest::new(file.content().clone()).asking(Some(asked), true);
    let request = Request {
        case,
        text: file.whole_text(),
        file: String::new(),
        overrides: Vec::new(),
        id: String::new(),
    };
    let mut line = ProgressLine::new();
    let run = execute(&request, stop.cancel(), &mut |event| {
        if let JobEvent::Searching(search) = event {
            line.show(&search.to_string());
        }
    });
    (run.info.state == RunState::Done).then_some(run)
}

/// The run, stored as it is computed: its results or JSON on standard output.
fn computed_run(
    args: &RunArgs,
    file: EditedFile<'_, SystemFile>,
    overrides: Vec<String>,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let request = request(args, file, overrides)?;
    if args.detach {
        return detach(args, request, None);
    }
    stored_run(args, &request, None, stop)
}

/// Continues a stored run.
pub(super) fn resume(
    args: &RunArgs,
    dir: &Path,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let (request, from) = resume_request(dir, args.until).map_err(CommandError::Usage)?;
    if args.detach {
        return detach(args, request, from);
    }
    stored_run(args, &request, from.as_ref(), stop)
}

/// Keeps the run as a job.
fn detach(
    args: &RunArgs,
    request: SystemRequest,
    from: Option<ResumedSystem>,
) -> Result<ExitCode, CommandError> {
    let request = JobRequest::System(Box::new(request), from.map(Box::new));
    jobs::detach(&request, case_of(args), args.out.as_deref(), args.json)
}

/// Computes a run, stores it as it is computed, and prints its results.
fn stored_run(
    args: &RunArgs,
    request: &SystemRequest,
    from: Option<&ResumedSystem>,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let question = verdict::checks(SeaQuestion::of_system(&request.case.solved))?;
    let info = request.initial_info();
    let stored = stored(args, &info, &request.text, stop, &mut |cancel, events| {
        execute_from(request, from, cancel, events)
    })?;
    let RunWithFolder { run, dir } = &stored;
    let found = verdict::of_run(&question, run, dir);
    let found = found.as_ref();
    if args.json {
        let solved = &request.case.solved;
        let mut object = json::object(solved, &Analyses::of_object(solved));
        object["motion"] = motion::object(run, dir);
        object["checks"] = json!(found.map(RunVerdict::to_json));
        output::object(&object)?;
    } else {
        let checks = verdict::text(found);
        let path = visible::path(dir);
        let text = format!(
            "{path}\n\n{}{}{}{checks}",
            at_rest(request, run, output::glyphs(args.ascii)),
            motion::summary(run),
            accuracy(run)
        );
        output::results(&text, args.ascii)?;
    }
    Ok(verdict::status(found, status(run, stop)))
}

/// The report of where the system rests, of a run of that alone.
fn at_rest(request: &SystemRequest, run: &Run, glyphs: Glyphs) -> String {
    if request.case.motion.is_in_time() {
        return String::new();
    }
    let solved = &request.case.solved;
    let analyses = Analyses::of_system(solved);
    let rows = validation::rows_of_run(solved, run);
    let fields = kind::rows::<SystemFile>(&request.text);
    let report = views::report(solved, &analyses, &rows, &fields);
    report.to_text(WIDTH, glyphs)
}

/// All `--set`, then `--solver`.
fn overrides(args: &RunArgs) -> Vec<String> {
    let solver = args.solver.map(|s| format!("solver.method={}", s.name()));
    args.set.iter().cloned().chain(solver).collect()
}

/// The run that the file with all `--set` asks for.
fn request(
    args: &RunArgs,
    file: EditedFile<'_, SystemFile>,
    overrides: Vec<String>,
) -> Result<SystemRequest, CommandError> {
    let path = args.case.as_deref().unwrap_or(Path::new(""));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let text = file.whole_text();
    let request = job::request(
        Arc::new(file.compute()?.computed),
        &text,
        name.into_owned(),
        overrides,
    );
    request.ok_or_else(|| CommandError::Usage("A run in time needs a table `[solver]`.".to_owned()))
}
