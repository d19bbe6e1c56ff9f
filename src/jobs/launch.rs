//! Starting the processes of jobs, so many that there is always one that waits for the next core.

use std::collections::BTreeMap;
use std::io;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::folder::{JobFolder, JobFolderState};
use super::jobs_dir::JobsDir;
use super::spec::{JobSpec, JobSubmission};
use super::status::{JobPhase, JobStatus};
use crate::files::disk;
use crate::visible;

/// The command of the program that computes a job.
pub const COMMAND: &str = "job";

/// How many processes wait for their turn: one may be killed, and the queue goes on all the same.
const IN_LINE: usize = 2;

/// How often a process is started for the same job by one program.
const MOST_TRIES: u32 = 3;

/// How long a process may take until it has its job.
const START: Duration = Duration::from_secs(2);

/// What a program has started.
#[derive(Debug, Default)]
pub struct Launcher {
    tries: BTreeMap<u64, Tries>,
}

/// Processes started for a job.
#[derive(Debug, Clone, Copy)]
struct Tries {
    count: u32,
    last: Instant,
}

impl Launcher {
    /// Keeps a request, and starts a process for it or for one that waits before it.
    ///
    /// # Errors
    /// The request cannot be kept, or no process be started for it; nothing is left of it then.
    pub fn submit(
        &mut self,
        jobs: &JobsDir,
        submission: &JobSubmission,
    ) -> Result<JobFolder, String> {
        let folder = jobs.submit(submission).map_err(|error| error.to_string())?;
        let refused = match submission.spec.is_sweep() {
            true => self.start(&folder, &submission.spec).err(),
            false => {
                let refused = self.begin_waiting(jobs).into_iter();
                let mut own = refused.filter(|(number, _)| *number == folder.number);
                own.next().map(|(_, error)| error)
            }
        };
        if let Some(error) = refused {
            // Best effort: the error that matters is the one already in hand.
            let _ = folder.remove();
            return Err(format!("no process can be started: {error}"));
        }
        Ok(folder)
    }

    /// Starts processes for jobs that no process has begun: so many that some wait for a core. Returns those for which the system gives none;
    /// they fail after some tries.
    pub fn begin_waiting(&mut self, jobs: &JobsDir) -> Vec<(u64, io::Error)> {
        let mut in_line = 0;
        let mut refused = Vec::new();
        for folder in jobs.jobs() {
            if in_line >= IN_LINE {
                break;
            }
            if folder.is_waiting() {
                in_line += 1;
                continue;
            }
            if folder.state() != JobFolderState::NotBegun {
                continue;
            }
            let tries = self.tries.get(&folder.number);
            if tries.is_some_and(|tries| tries.last.elapsed() < START) {
                in_line += 1;
                continue;
            }
            if tries.is_some_and(|tries| tries.count >= MOST_TRIES) {
                give_up(&folder);
                continue;
            }
            // One that cannot be read is shown as such by who lists the jobs.
            let Ok(spec) = folder.spec() else { continue };
            match self.start(&folder, &spec) {
                Ok(()) => in_line += usize::from(!spec.is_sweep()),
                Err(error) => refused.push((folder.number, error)),
            }
        }
        refused
    }

    fn start(&mut self, folder: &JobFolder, spec: &JobSpec) -> io::Result<()> {
        let last = Instant::now();
        let tries = self.tries.entry(folder.number);
        let tries = tries.or_insert(Tries { count: 0, last });
        (tries.count, tries.last) = (tries.count + 1, last);
        let log = disk::append_private(&folder.log())?;
        let child = Command::new(std::env::current_exe()?)
            .arg(COMMAND)
            .arg(&folder.path)
            .args(&spec.options)
            .current_dir(&spec.directory)
            .stdin(Stdio::null())
            .stdout(Stdio::from(log.try_clone()?))
            .stderr(Stdio::from(log))
            .spawn()?;
        reap(child);
        Ok(())
    }
}

/// A job for which there is no process after some tries has failed.
fn give_up(folder: &JobFolder) {
    let log = visible::path(&folder.log());
    let why = format!("no process can be started, or it ends as it begins; {log} may say more");
    let status = JobStatus {
        message: Some(why),
        ..JobStatus::new(JobPhase::Failed)
    };
    // A process that has it after all says more.
    if let Ok(Some(_taken)) = folder.take() {
        let _ = folder.write_status(&status);
    }
}

/// Takes the end of a process in, so that it does not stay listed while this program runs.
fn reap(mut child: Child) {
    let started = std::thread::Builder::new()
        .name("job process".to_owned())
        .spawn(move || child.wait());
    // Without a thread it stays listed until this program ends.
    drop(started);
}
