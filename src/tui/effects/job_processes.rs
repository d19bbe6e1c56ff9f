//! Jobs that are processes of their own: started, followed, cancelled, and those found that others have started.

mod ended;
mod found;
mod fresh;
mod reader;
mod watcher;

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use crossbeam_channel::{Sender, unbounded};

use self::fresh::Fresh;
use self::watcher::{Input, Watcher};
use super::ordered_worker::OrderedWorker;
use super::outbox::Outbox;
use crate::background::lower_priority;
use crate::jobs::{JobFolder, JobSubmission, JobsDir, Launcher, client};
use crate::msg::Msg;
use crate::state::job_process::{NewProcess, ProcessEffect, ProcessMsg, ProcessWork};
use crate::state::{JobNumber, Severity};

/// The folders of the jobs of this screen, by their numbers here.
type Folders = Arc<Mutex<BTreeMap<JobNumber, JobFolder>>>;

/// The threads behind the screen that deal with processes.
#[derive(Debug)]
pub(super) struct JobProcesses {
    jobs: JobsDir,
    launcher: Arc<Mutex<Launcher>>,
    folders: Folders,
    fresh: Fresh,
    /// Jobs are kept and cancelled in the order in which that is asked for.
    requests: OrderedWorker,
    watcher: Sender<Input>,
}

impl JobProcesses {
    /// Starts the threads.
    ///
    /// # Errors
    /// Jobs cannot be kept, or the system gives no thread, in words.
    pub(super) fn start(out: &Outbox) -> Result<Self, String> {
        let jobs = JobsDir::open().map_err(|error| error.to_string())?;
        let launcher: Arc<Mutex<Launcher>> = Arc::default();
        let (watcher, inputs) = unbounded();
        let (folders, fresh) = (Folders::default(), Fresh::default());
        let watching = Watcher::new(
            jobs.clone(),
            Arc::clone(&launcher),
            fresh.clone(),
            (watcher.clone(), inputs),
            out.clone(),
        );
        let thread = std::thread::Builder::new().name("jobs".to_owned());
        let started = thread.spawn(move || {
            lower_priority();
            watching.watch();
        });
        started.map_err(|error| format!("the system gives no thread: {error}"))?;
        Ok(Self {
            jobs,
            launcher,
            folders,
            fresh,
            requests: OrderedWorker::start("job requests", out.clone()),
            watcher,
        })
    }

    /// What jobs have recorded since the last call.
    pub(super) fn recorded(&self) -> Vec<Msg> {
        self.fresh.take()
    }

    /// Waits until all jobs are kept and cancelled of which that was asked, or the time is up.
    pub(super) fn finish(&self, limit: Duration) {
        self.requests.finish(limit);
    }

    /// Does what is asked for; answers come as messages.
    pub(super) fn perform(&self, effect: ProcessEffect) -> Vec<Msg> {
        match effect {
            ProcessEffect::Submit(ticket, new) => self.submit(ticket, *new),
            ProcessEffect::Adopt(ticket, number) => {
                if let Some(folder) = self.jobs.job(number) {
                    folders(&self.folders).insert(ticket, folder.clone());
                    self.tell(Input::Follow(ticket, folder, false));
                }
                Vec::new()
            }
            ProcessEffect::Show(ticket, shown) => {
                self.tell(Input::Show(ticket, shown));
                Vec::new()
            }
        }
    }

    fn tell(&self, input: Input) {
        // The thread ends with the program only.
        let _ = self.watcher.send(input);
    }

    /// Keeps a job and starts its process.
    fn submit(&self, ticket: JobNumber, new: NewProcess) -> Vec<Msg> {
        let (jobs, launcher) = (self.jobs.clone(), Arc::clone(&self.launcher));
        let (known, watcher) = (Arc::clone(&self.folders), self.watcher.clone());
        self.requests.perform(move || {
            let submitted = submission(&new).and_then(|submission| {
                let mut launcher = launcher.lock().unwrap_or_else(PoisonError::into_inner);
                launcher.submit(&jobs, &submission)
            });
            match submitted {
                Ok(folder) => {
                    let number = folder.number;
                    folders(&known).insert(ticket, folder.clone());
                    let _ = watcher.send(Input::Follow(ticket, folder, true));
                    vec![Msg::Process(ProcessMsg::Numbered(ticket, number))]
                }
                Err(why) => {
                    let new = Box::new(new);
                    vec![Msg::Process(ProcessMsg::NotSubmitted(ticket, new, why))]
                }
            }
        })
    }

    /// Asks a job to stop, if it is one of these.
    pub(super) fn cancel(&self, ticket: JobNumber) -> Vec<Msg> {
        let (known, watcher) = (Arc::clone(&self.folders), self.watcher.clone());
        self.requests.perform(move || {
            let Some(folder) = folders(&known).get(&ticket).cloned() else {
                return Vec::new();
            };
            let cancelled = client::cancel(&folder);
            let _ = watcher.send(Input::Look);
            let refused = cancelled.err().filter(|_| folder.exists());
            let words = refused.map(|why| {
                let number = folder.number;
                Msg::Say(
                    Severity::Warning,
                    format!("Job {number} is not cancelled: {why}."),
                )
            });
            words.into_iter().collect()
        })
    }
}

fn folders(folders: &Folders) -> std::sync::MutexGuard<'_, BTreeMap<JobNumber, JobFolder>> {
    folders.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The request as it is kept.
fn submission(new: &NewProcess) -> Result<JobSubmission, String> {
    let mut submission = match &new.work {
        ProcessWork::Run(request) => JobSubmission::of_run(request, &new.name, &new.case)?,
        ProcessWork::Sweep(request) => JobSubmission::of_sweep(request, &new.name)?,
    };
    submission.spec.label.clone_from(&new.label);
    Ok(submission)
}
