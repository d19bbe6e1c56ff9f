//! What is said of a sweep on a cluster.

use std::path::Path;

use seacable_base::files::read;
use seacable_base::visible::{self, quoted};
use seacable_studies::study::sweep::slurm::{CommandFailed, Queue, SlurmRecord, array_list};

/// Missing load cases that are named, at most.
const MOST_NAMED: usize = 200;

/// That an array computes the sweep, which therefore is not computed here.
pub(super) fn busy(queue: &Queue, dir: &Path) -> String {
    let (shown, dir) = (visible::path(dir), visible::argument(dir));
    let jobs = queue.job_words();
    let numbers: Vec<String> = queue.jobs.iter().map(u64::to_string).collect();
    format!(
        "{shown} is being computed by Slurm's {jobs} ({}). `seacable sweep --resume {dir} --slurm` watches on; `scancel {}` ends it, and the rest can be computed here.",
        queue.words(),
        numbers.join(" ")
    )
}

/// That it is not known whether an array computes the sweep.
pub(super) fn unknown(error: &CommandFailed, dir: &Path) -> String {
    let dir = visible::path(dir);
    format!(
        "Whether an array of Slurm still computes {dir} is not known: {error} Go on where squeue answers; or, where none is left, remove {dir}/slurm.toml."
    )
}

/// That so many load cases were submitted, in so many tasks, as a job; and how the array before ended.
pub(super) fn submitted(
    record: &SlurmRecord,
    queue: &Queue,
    (load_cases, tasks): (usize, usize),
    job: u64,
) -> String {
    let before = record.submissions.last().map(|one| one.job);
    let before = before.map_or_else(String::new, |before| match queue.endings(before) {
        words if words.is_empty() => format!("Job {before} has left the queue. "),
        words => {
            format!("Job {before} has left the queue (tasks that did not complete: {words}). ")
        }
    });
    let (of, by, cores) = (
        record.load_cases,
        record.cases_per_task,
        record.cores_per_task,
    );
    let (cases, each) = (plural(by), plural(usize::from(cores)));
    // Those of slurm.toml may be of another day, or of another hand.
    let options: Vec<String> = record.options.iter().map(|word| quoted(word)).collect();
    let with = match options.is_empty() {
        true => String::new(),
        false => format!(", with {}", options.join(" ")),
    };
    format!(
        "{before}Submitted {load_cases} of {of} load cases as Slurm's job {job}: tasks {tasks}, up to {by} load case{cases} and {cores} core{each} each{with}."
    )
}

/// That the watching ended and the array did not.
pub(super) fn left(queue: &Queue, dir: &Path) -> String {
    let (jobs, dir) = (queue.job_words(), visible::argument(dir));
    format!(
        "Stopped watching; Slurm's {jobs} goes on. `seacable sweep --resume {dir} --slurm` watches on, scancel ends it."
    )
}

/// That load cases are still missing after so many arrays, and how to go on.
pub(super) fn given_up(
    dir: &Path,
    record: &SlurmRecord,
    queue: &Queue,
    missing: &[usize],
    arrays: usize,
) -> String {
    let named = missing.iter().take(MOST_NAMED).map(|index| index + 1);
    let named: Vec<usize> = named.collect();
    let more = match missing.len() - named.len() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let (count, of) = (missing.len(), record.load_cases);
    let job = record.submissions.last().map_or(0, |one| one.job);
    let endings = match queue.endings(job) {
        words if words.is_empty() => String::new(),
        words => format!(" Tasks of job {job} ended as {words}."),
    };
    let task = missing
        .first()
        .map_or(0, |index| index / record.cases_per_task.max(1));
    let (numbers, said) = (array_list(&named), printed(dir, job, task));
    let dir = visible::argument(dir);
    format!(
        "After {arrays} arrays {count} of {of} load cases have no run: {numbers}{more}.{endings}{said} \
         `seacable sweep --resume {dir} --slurm` submits them again: with more time or memory (--slurm-option=--time=...), or with \
         --cases-per-task 1 where one load case ends the task of others. `seacable sweep --resume {dir}` computes them here."
    )
}

/// The last words of a task.
fn printed(dir: &Path, job: u64, task: usize) -> String {
    let file = dir.join(format!("tasks/{job}_{task}.log"));
    let text = read::run_text(&file).unwrap_or_default();
    match text.lines().rfind(|line| !line.trim().is_empty()) {
        Some(line) => {
            let line = visible::shortened(visible::line(line).into_owned());
            format!(" The last line of {} is `{line}`.", visible::path(&file))
        }
        None => String::new(),
    }
}

const fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}
