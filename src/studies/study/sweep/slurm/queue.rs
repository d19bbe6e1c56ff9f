//! The queue: what is asked of `squeue` and `sbatch`, and what they answer.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsString;
use std::path::Path;

use super::command::{CommandFailed, SlurmCommand};
use super::{SCRIPT, SlurmRecord};

/// States of tasks that have ended; all others are waiting, running or about to.
const ENDED: [&str; 10] = [
    "BOOT_FAIL",
    "CANCELLED",
    "COMPLETED",
    "DEADLINE",
    "FAILED",
    "NODE_FAIL",
    "OUT_OF_MEMORY",
    "PREEMPTED",
    "REVOKED",
    "TIMEOUT",
];

/// What is asked of `squeue` for each task: job of the array, number in it, state, name.
const FORMAT: &str = "--format=%F %K %T %j";

/// The tasks of a sweep in the queue.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Queue {
    /// Tasks that wait.
    pub waiting: usize,
    /// Tasks that run, or are about to begin or to end.
    pub running: usize,
    /// Jobs that have such tasks.
    pub jobs: BTreeSet<u64>,
    /// How many tasks of a job have ended in a state, as far as Slurm still knows.
    pub ended: BTreeMap<(u64, String), usize>,
}

impl Queue {
    /// Asks for the tasks of the arrays in a record, and of others with the same name of the job, of this user.
    ///
    /// # Errors
    /// `squeue` cannot be run, fails, or answers what cannot be understood.
    pub fn look(record: &SlurmRecord) -> Result<Self, CommandFailed> {
        // One that has left long ago would be an error if it were asked for by its number.
        let user = format!("--user={}", rustix::process::getuid().as_raw());
        let words = ["--noheader", "--array", "--states=all", &user, FORMAT];
        let command = SlurmCommand::new("squeue", &words);
        let remedy = "See whether Slurm answers at all (`sinfo`); nothing is lost, and --resume DIR --slurm goes on.";
        let answer = command.answer(remedy)?;
        let jobs: BTreeSet<u64> = record.submissions.iter().map(|one| one.job).collect();
        Self::of_answer(&answer, &jobs, &record.job_name)
            .ok_or_else(|| command.unclear(&answer, "a line `JOB TASK STATE NAME` a task"))
    }

    /// Reads an answer; nothing where it cannot be understood.
    fn of_answer(answer: &str, jobs: &BTreeSet<u64>, name: &str) -> Option<Self> {
        let mut queue = Self::default();
        for line in answer.lines().filter(|line| !line.trim().is_empty()) {
            let mut words = line.trim().splitn(4, ' ');
            let job: u64 = words.next()?.parse().ok()?;
            let (_task, state) = (words.next()?, words.next()?);
            if !state.bytes().all(|b| b.is_ascii_uppercase() || b == b'_') {
                return None;
            }
            if jobs.contains(&job) || words.next() == Some(name) {
                queue.add(job, state);
            }
        }
        Some(queue)
    }

    fn add(&mut self, job: u64, state: &str) {
        if ENDED.contains(&state) {
            *self.ended.entry((job, state.to_owned())).or_default() += 1;
            return;
        }
        self.jobs.insert(job);
        match state {
            "PENDING" => self.waiting += 1,
            _ => self.running += 1,
        }
    }

    /// Whether any task waits or runs.
    #[must_use]
    pub fn is_active(&self) -> bool {
        !self.jobs.is_empty()
    }

    /// The tasks that wait and run, in words.
    #[must_use]
    pub fn words(&self) -> String {
        let (running, waiting) = (self.running, self.waiting);
        format!(
            "{running} task{} running, {waiting} waiting",
            plural(running)
        )
    }

    /// The jobs in words: `job 12` or `jobs 12, 15`.
    #[must_use]
    pub fn job_words(&self) -> String {
        let numbers: Vec<String> = self.jobs.iter().map(u64::to_string).collect();
        format!("job{} {}", plural(numbers.len()), numbers.join(", "))
    }

    /// How the tasks of a job ended other than by coming to their end, in words; empty where none did, or Slurm does not know any more.
    #[must_use]
    pub fn endings(&self, job: u64) -> String {
        let of_job = self
            .ended
            .iter()
            .filter(|((of, state), _)| *of == job && state != "COMPLETED");
        let words: Vec<String> = of_job
            .map(|((_, state), count)| format!("{count} {state}"))
            .collect();
        words.join(", ")
    }
}

fn plural(count: usize) -> &'static str {
    match count {
        1 => "",
        _ => "s",
    }
}

/// Submits tasks of the script in the folder of a sweep, and gives the number of the job.
///
/// # Errors
/// `sbatch` cannot be run, fails, or answers no number.
pub fn submit(dir: &Path, record: &SlurmRecord, tasks: &str) -> Result<u64, CommandFailed> {
    let mut words: Vec<OsString> = record.options.iter().map(OsString::from).collect();
    let mut chdir = OsString::from("--chdir=");
    chdir.push(dir);
    // Of options that are given twice the last one holds.
    words.extend([
        "--parsable".into(),
        format!("--job-name={}", record.job_name).into(),
        format!("--array={tasks}").into(),
        chdir,
        dir.join(SCRIPT).into_os_string(),
    ]);
    let command = SlurmCommand::new("sbatch", &words);
    let remedy = "Nothing is lost: --resume DIR --slurm goes on, with other --slurm-option, --jobs or --cases-per-task where these are at fault.";
    let answer = command.answer(remedy)?;
    job_of(&answer).ok_or_else(|| command.unclear(&answer, "the number of a job"))
}

/// The number of the job that `sbatch --parsable` prints, on its last line: `12` or `12;cluster`.
fn job_of(answer: &str) -> Option<u64> {
    let line = answer.lines().next_back()?;
    line.split(';').next()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn queue(answer: &str) -> Option<Queue> {
        Queue::of_answer(answer, &BTreeSet::from([12]), "seacable-s-01234567")
    }

    #[test]
    fn tasks_are_counted_by_state_and_those_of_others_passed_over() {
        let answer = "12 0 COMPLETED seacable-s-01234567\n12 1 RUNNING renamed by the site\n12 2 PENDING seacable-s-01234567\n\
                      12 3 NODE_FAIL seacable-s-01234567\n12 4 COMPLETING seacable-s-01234567\n15 0 PENDING seacable-s-01234567\n\
                      16 N/A RUNNING other\n12 5 TIMEOUT seacable-s-01234567\n12 6 TIMEOUT seacable-s-01234567\n";
        let queue = queue(answer).unwrap();
        assert_eq!((queue.running, queue.waiting), (2, 2));
        assert_eq!(queue.job_words(), "jobs 12, 15");
        assert_eq!(queue.words(), "2 tasks running, 2 waiting");
        assert_eq!(queue.endings(12), "1 NODE_FAIL, 2 TIMEOUT");
        assert_eq!(queue.endings(15), "");
    }

    #[test]
    fn an_array_has_left_when_no_task_waits_or_runs() {
        for (answer, active) in [
            ("", false),
            ("\n", false),
            ("12 0 COMPLETED x", false),
            ("12 0 CANCELLED x\n12 1 OUT_OF_MEMORY x", false),
            ("12 0 SUSPENDED x", true),
            ("12 0 CONFIGURING x", true),
            ("12 0 REQUEUED x", true),
            ("13 0 RUNNING seacable-s-01234567", true),
            ("13 0 RUNNING seacable-s-0123456", false),
        ] {
            assert_eq!(queue(answer).unwrap().is_active(), active, "{answer}");
        }
    }

    #[test]
    fn an_answer_that_is_none_is_no_empty_queue() {
        for answer in [
            "slurm_load_jobs error: Unable to contact slurm controller",
            "12",
            "12 0",
            "12 0 running x",
        ] {
            assert_eq!(queue(answer), None, "{answer}");
        }
    }

    #[test]
    fn the_number_of_the_job_is_on_the_last_line() {
        for (answer, job) in [
            ("12", Some(12)),
            ("12;north", Some(12)),
            ("sbatch: welcome\n13", Some(13)),
            ("Submitted batch job 12", None),
            ("", None),
        ] {
            assert_eq!(job_of(answer), job, "{answer}");
        }
    }
}
