//! `seacable jobs`: the jobs that go on without a screen; `seacable run --detach` begins one.

use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

use serde_json::{Value, json};

use super::progress::ProgressLine;
use super::{BAD_RESULT, CommandError, output};
use seacable_base::visible;
use seacable_display::table::{Cell, Column, Table};
use seacable_jobs::list::JobEntry;
use seacable_jobs::{
    JobFolderState, JobPhase, JobRequest, JobSubmission, JobsDir, Launcher, client, identity,
    survival,
};
use seacable_report::text::WIDTH;

#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true)]
pub(super) struct JobsArgs {
    #[command(subcommand)]
    pub(super) command: Option<JobsCommand>,

    /// Print one JSON object.
    #[arg(long, conflicts_with = "ascii")]
    pub(super) json: bool,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Subcommand)]
pub(super) enum JobsCommand {
    /// Stop a job of this host with a checkpoint; what it has computed is kept, and can be resumed.
    Cancel(JobArg),
    /// Wait until a job of this host has ended, and print its directory.
    ///
    /// The exit status is 1 unless it is done. Its folder is removed then; its results stay.
    Wait(JobArg),
    /// The same, with its progress on standard error.
    Follow(JobArg),
    /// Begin the jobs that wait, where the processes of all before them were killed.
    Begin,
}

#[derive(Debug, clap::Args)]
pub(super) struct JobArg {
    /// The number of the job, as `seacable jobs` lists it.
    #[arg(value_name = "JOB")]
    pub(super) number: u64,
}

/// How long the process of a job may take to take it.
const STARTING: Duration = Duration::from_secs(10);

/// Between two looks at the files of a job.
const LOOK: Duration = Duration::from_millis(100);

pub(super) fn jobs(args: &JobsArgs) -> Result<ExitCode, CommandError> {
    let jobs = open()?;
    match &args.command {
        None => list(&jobs, args),
        Some(JobsCommand::Cancel(job)) => cancel(&jobs, job.number),
        Some(JobsCommand::Begin) => begin(&jobs),
        Some(JobsCommand::Wait(job)) => wait(&jobs, job.number, false),
        Some(JobsCommand::Follow(job)) => wait(&jobs, job.number, true),
    }
}

fn open() -> Result<JobsDir, CommandError> {
    let jobs = JobsDir::open();
    jobs.map_err(|error| CommandError::Usage(format!("Jobs cannot be kept: {error}.")))
}

/// Keeps a run as a job, and prints its number and folder.
pub(super) fn detach(
    request: &JobRequest,
    case: &Path,
    out: Option<&Path>,
    as_json: bool,
) -> Result<ExitCode, CommandError> {
    let info = request.initial_info();
    let stem = request.file().trim_end_matches(".toml");
    let name = format!("{stem}, {}", info.settings.method);
    let mut submission =
        JobSubmission::of_run(request, &name, case).map_err(CommandError::Usage)?;
    submission.spec.out = out.map(Path::to_owned);
    let submitted = Launcher::default().submit(&open()?, &submission);
    let folder = submitted
        .map_err(|why| CommandError::Usage(format!("The job cannot be started: {why}.")))?;
    if let Some(warning) = survival::ended_by_logout() {
        output::message(&format!("warning: {warning}"));
    }
    let (number, host) = (folder.number, identity::host());
    match as_json {
        true => output::object(&json!({"job": number, "host": host, "folder": folder.path}))?,
        false => {
            let path = visible::path(&folder.path);
            output::results(&format!("Job {number} on {host}\n{path}\n"), false)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn list(jobs: &JobsDir, args: &JobsArgs) -> Result<ExitCode, CommandError> {
    jobs.tidy();
    let (old, entries): (Vec<_>, Vec<_>) = JobEntry::all(jobs)
        .into_iter()
        .partition(JobEntry::is_forgotten);
    for entry in old {
        // What stays is found again.
        let _ = entry.folder.remove();
    }
    if args.json {
        let rows: Vec<Value> = entries.iter().map(object).collect();
        output::object(&json!({ "host": identity::host(), "jobs": rows }))?;
        return Ok(ExitCode::SUCCESS);
    }
    if entries.is_empty() {
        output::results("There are no jobs.\n", args.ascii)?;
        return Ok(ExitCode::SUCCESS);
    }
    output::results(&table(&entries).to_text(WIDTH), args.ascii)?;
    if is_stranded(&entries) {
        output::message(
            "No process is left that would begin the jobs that wait; `seacable jobs begin` does.",
        );
    }
    Ok(ExitCode::SUCCESS)
}

/// Begins the jobs that wait.
fn begin(jobs: &JobsDir) -> Result<ExitCode, CommandError> {
    let refused = Launcher::default().begin_waiting(jobs).into_iter().next();
    match refused {
        None => Ok(ExitCode::SUCCESS),
        Some((number, error)) => Err(CommandError::Usage(format!(
            "Job {number} cannot be started: {error}."
        ))),
    }
}

/// Whether a job of this host waits where no process is left to begin it.
fn is_stranded(entries: &[JobEntry]) -> bool {
    let mut here = entries.iter().filter(|entry| entry.host.is_none());
    let is_alive = here
        .clone()
        .any(|entry| entry.state == JobFolderState::Held);
    // A process takes a moment to take its job.
    let is_old = |entry: &JobEntry| {
        let made = entry
            .folder
            .path
            .metadata()
            .and_then(|found| found.modified());
        made.is_ok_and(|made| made.elapsed().is_ok_and(|age| age > STARTING))
    };
    !is_alive && here.any(|entry| entry.state == JobFolderState::NotBegun && is_old(entry))
}

fn table(entries: &[JobEntry]) -> Table {
    let heads = ["name", "state", "details", "results"];
    let row = |entry: &JobEntry| {
        let results = entry.results().map(|dir| visible::path(&dir));
        let cells = [
            entry.folder.number.to_string(),
            entry.name().to_owned(),
            entry.word().to_owned(),
            entry.details(),
            results.unwrap_or_default(),
        ];
        cells.map(Cell::plain).to_vec()
    };
    Table {
        columns: [Column::right("job")]
            .into_iter()
            .chain(heads.map(Column::left))
            .collect(),
        rows: entries.iter().map(row).collect(),
        ..Table::default()
    }
}

fn object(entry: &JobEntry) -> Value {
    let progress = entry.status.as_ref().and_then(|status| status.progress);
    let load_cases = entry.status.as_ref().and_then(|status| status.load_cases);
    json!({
        "job": entry.folder.number,
        "host": entry.host.clone().unwrap_or_else(identity::host),
        "name": entry.name(),
        "state": entry.word(),
        "details": entry.details(),
        "results": entry.results(),
        "folder": entry.folder.path,
        "progress": progress,
        "load_cases": load_cases,
    })
}

/// The job of a number.
fn found(jobs: &JobsDir, number: u64) -> Result<JobEntry, CommandError> {
    let folder = jobs.job(number);
    folder.map(JobEntry::here).ok_or_else(|| {
        let others = jobs.of_other_hosts();
        let other = others.iter().find(|(_, job)| job.number == number);
        let elsewhere = other.map_or_else(String::new, |(host, _)| {
            format!(" There is one on {host}; log in there.")
        });
        CommandError::Usage(format!(
            "There is no job {number} on this host; `seacable jobs` lists them.{elsewhere}"
        ))
    })
}

fn cancel(jobs: &JobsDir, number: u64) -> Result<ExitCode, CommandError> {
    let entry = found(jobs, number)?;
    client::cancel(&entry.folder)
        .map_err(|why| CommandError::Usage(format!("Job {number} cannot be cancelled: {why}.")))?;
    output::message(&format!("Job {number} stops with a checkpoint."));
    Ok(ExitCode::SUCCESS)
}

fn wait(jobs: &JobsDir, number: u64, shows: bool) -> Result<ExitCode, CommandError> {
    let mut entry = found(jobs, number)?;
    // A queue whose processes were all killed goes on.
    let _ = Launcher::default().begin_waiting(jobs);
    let mut line = ProgressLine::new();
    while matches!(entry.state, JobFolderState::Held | JobFolderState::NotBegun) {
        if !entry.folder.exists() {
            return Err(CommandError::Usage(format!(
                "Job {number} has ended, and a screen has shown it; `seacable` lists its run."
            )));
        }
        if shows {
            match entry.status.as_ref().and_then(|status| status.progress) {
                Some(progress) if progress.steps > 0 => line.run(&progress),
                _ => line.show(&format!("{} {}", entry.word(), entry.details())),
            }
        }
        std::thread::sleep(LOOK);
        entry = JobEntry::here(entry.folder);
    }
    drop(line);
    let is_done = entry.word() == JobPhase::Done.word();
    if !is_done {
        let words = format!(
            "Job {number}, {}: {} {}",
            entry.name(),
            entry.word(),
            entry.details()
        );
        output::message(words.trim_end());
    }
    let results = entry.results();
    // What stays is listed as ended.
    let _ = entry.folder.remove();
    if let Some(dir) = results {
        output::results(&format!("{}\n", visible::path(&dir)), false)?;
    }
    Ok(match is_done {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(BAD_RESULT),
    })
}
