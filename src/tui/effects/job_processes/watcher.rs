//! The thread that follows the jobs of this screen, and looks for those of others.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crossbeam_channel::{Receiver, RecvTimeoutError, Sender};

use super::ended::{EndedJob, killed, shown_elsewhere};
use super::found::{found_job, found_state};
use super::fresh::Fresh;
use super::reader::Reader;
use crate::effects::ordered_worker::OrderedWorker;
use crate::effects::outbox::Outbox;
use crate::jobs::client::Connection;
use crate::jobs::identity::ProcessIdentity;
use crate::jobs::list::JobEntry;
use crate::jobs::{
    JobFolder, JobFolderState as FolderState, JobPhase, JobSpec, JobStatus, JobsDir, Launcher,
    survival,
};
use crate::msg::Msg;
use crate::state::job_process::ProcessMsg;
use crate::state::{JobNumber, JobState};

/// How often jobs are looked for that others have started.
const DISCOVER: Duration = Duration::from_secs(2);

/// How often jobs are looked at that do not speak for themselves: those about to begin or to end, and others.
const EAGER: Duration = Duration::from_millis(15);
const PATIENT: Duration = Duration::from_millis(500);

/// How long a job counts as about to begin.
const SOON: Duration = Duration::from_secs(2);

/// How many of those that wait are looked at eagerly: the others wait for these.
const FIRST: usize = 8;

/// After so many refusals a job is followed by its file.
const MOST_REFUSALS: u32 = 3;

/// What the thread is told.
#[derive(Debug)]
pub(super) enum Input {
    /// Follow the job in this folder; and whether what it records is shown.
    Follow(JobNumber, JobFolder, bool),
    /// Whether what a job records is shown.
    Show(JobNumber, bool),
    /// A job has ended so.
    Ended(JobNumber, JobStatus),
    /// A connection has ended, after the job said this of itself.
    Left(JobNumber, Option<JobStatus>),
    /// Something has changed.
    Look,
}

/// A job that is followed.
#[derive(Debug)]
struct Followed {
    folder: JobFolder,
    spec: JobSpec,
    is_shown: bool,
    connection: Option<Connection>,
    /// What the screen was sent of it last.
    told: Option<JobStatus>,
    /// Connections that ended before anything was said: it is of another version, or serves too many.
    refusals: u32,
}

impl Followed {
    /// Who passes on what the job says.
    fn reader(&self, ticket: JobNumber, fresh: &Fresh, out: &Outbox) -> Reader {
        Reader {
            ticket,
            spec: self.spec.clone(),
            fresh: fresh.clone(),
            out: out.clone(),
            told: self.told.clone(),
        }
    }
}

/// The thread.
#[derive(Debug)]
pub(super) struct Watcher {
    jobs: JobsDir,
    launcher: Arc<Mutex<Launcher>>,
    fresh: Fresh,
    sender: Sender<Input>,
    inputs: Receiver<Input>,
    out: Outbox,
    /// Reads results.
    reader: OrderedWorker,
    followed: BTreeMap<JobNumber, Followed>,
    /// Numbers of jobs that the screen knows.
    known: BTreeSet<u64>,
    /// Jobs of other hosts, and what was said of them.
    elsewhere: BTreeMap<(String, u64), String>,
    /// This program, which knows its own jobs.
    own: ProcessIdentity,
    discovered: Option<Instant>,
    changed: Instant,
}

impl Watcher {
    pub(super) fn new(
        jobs: JobsDir,
        launcher: Arc<Mutex<Launcher>>,
        fresh: Fresh,
        (sender, inputs): (Sender<Input>, Receiver<Input>),
        out: Outbox,
    ) -> Self {
        Self {
            jobs,
            launcher,
            fresh,
            sender,
            inputs,
            reader: OrderedWorker::start("job results", out.clone()),
            out,
            followed: BTreeMap::new(),
            known: BTreeSet::new(),
            elsewhere: BTreeMap::new(),
            own: ProcessIdentity::own(),
            discovered: None,
            changed: Instant::now(),
        }
    }

    /// Follows and looks, until the program ends.
    pub(super) fn watch(mut self) {
        self.jobs.tidy();
        if let Some(why) = survival::ended_by_logout() {
            self.tell(ProcessMsg::EndedByLogout(why));
        }
        loop {
            if self.discovered.is_none_or(|at| at.elapsed() >= DISCOVER) {
                self.discover();
                self.discovered = Some(Instant::now());
            }
            let is_soon = self.changed.elapsed() < SOON;
            self.look(if is_soon { FIRST } else { usize::MAX });
            match self.inputs.recv_timeout(self.pause()) {
                Ok(input) => self.take(input),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return,
            }
            let more: Vec<Input> = self.inputs.try_iter().collect();
            more.into_iter().for_each(|input| self.take(input));
        }
    }

    fn tell(&self, msg: ProcessMsg) {
        self.out.send(Msg::Process(msg));
    }

    fn pause(&self) -> Duration {
        let mut followed = self.followed.values();
        match followed.any(|job| job.connection.is_none()) {
            true if self.changed.elapsed() < SOON => EAGER,
            true => PATIENT,
            false => DISCOVER,
        }
    }

    fn take(&mut self, input: Input) {
        self.changed = Instant::now();
        match input {
            Input::Follow(ticket, folder, is_shown) => self.follow(ticket, folder, is_shown),
            Input::Show(ticket, is_shown) => {
                if let Some(job) = self.followed.get_mut(&ticket) {
                    job.is_shown = is_shown;
                    let connection = job.connection.as_ref();
                    // One that has gone is noticed by who reads from it.
                    let _ = connection.map(|connection| connection.follow(is_shown));
                }
            }
            Input::Ended(ticket, status) => self.end(ticket, status),
            Input::Left(ticket, told) => {
                if let Some(job) = self.followed.get_mut(&ticket) {
                    job.connection = None;
                    job.refusals += u32::from(told.is_none());
                    job.told = told;
                }
            }
            Input::Look => {}
        }
    }

    fn follow(&mut self, ticket: JobNumber, folder: JobFolder, is_shown: bool) {
        self.known.insert(folder.number);
        // A folder that is gone already was shown by another screen.
        let Ok(spec) = folder.spec() else {
            let words = JobState::Killed("another screen has shown how it ended".to_owned());
            self.tell(ProcessMsg::Is(ticket, words));
            return;
        };
        let job = Followed {
            folder,
            spec,
            is_shown,
            connection: None,
            told: None,
            refusals: 0,
        };
        self.followed.insert(ticket, job);
    }

    /// Looks for jobs of other screens, of other hosts, and for those that no process has begun.
    fn discover(&mut self) {
        {
            let mut launcher = self.launcher.lock().unwrap_or_else(PoisonError::into_inner);
            // The reason is said when a job of this screen cannot be started.
            let _ = launcher.begin_waiting(&self.jobs);
        }
        for folder in self.jobs.jobs() {
            if self.known.contains(&folder.number) {
                continue;
            }
            let entry = JobEntry::here(folder);
            let phase = entry.status.as_ref().map(|status| status.phase);
            let is_ending =
                entry.state == FolderState::Held && phase.is_some_and(JobPhase::has_ended);
            if is_ending {
                continue;
            }
            // A job of this screen is about to be followed.
            if entry.spec.as_ref().is_ok_and(|spec| spec.by == self.own) || !entry.folder.exists() {
                continue;
            }
            self.known.insert(entry.folder.number);
            self.found(&entry);
        }
        self.discover_elsewhere();
    }

    fn found(&self, entry: &JobEntry) {
        let state = found_state(entry);
        let has_ended = !state.is_open();
        self.tell(ProcessMsg::Found(Box::new(found_job(entry, state))));
        if has_ended {
            // What stays is shown once more.
            let _ = entry.folder.remove();
        }
    }

    fn discover_elsewhere(&mut self) {
        let all = JobEntry::all_elsewhere(&self.jobs);
        let mut gone: BTreeSet<(String, u64)> = self.elsewhere.keys().cloned().collect();
        for entry in all {
            let Some(host) = entry.host.clone() else {
                continue;
            };
            let key = (host, entry.folder.number);
            gone.remove(&key);
            let words = [entry.word().to_owned(), entry.details()];
            let words = words.join(" ");
            if self.elsewhere.get(&key) != Some(&words) {
                let state = JobState::Elsewhere(words.clone());
                self.tell(ProcessMsg::Found(Box::new(found_job(&entry, state))));
                self.elsewhere.insert(key, words);
            }
        }
        for key in gone {
            self.elsewhere.remove(&key);
            self.tell(ProcessMsg::Gone(key.0, key.1));
        }
    }

    /// Looks at the first jobs that do not speak for themselves.
    fn look(&mut self, most: usize) {
        let silent = self.followed.iter();
        let silent = silent.filter(|(_, job)| job.connection.is_none());
        let silent: Vec<JobNumber> = silent.map(|(ticket, _)| *ticket).take(most).collect();
        for ticket in silent {
            self.look_at(ticket);
        }
    }

    fn look_at(&mut self, ticket: JobNumber) {
        let Some(job) = self.followed.get_mut(&ticket) else {
            return;
        };
        if !job.folder.exists() {
            let status = shown_elsewhere(&job.spec, job.told.as_ref());
            self.end(ticket, status);
            return;
        }
        match job.folder.state() {
            FolderState::NotBegun => {}
            FolderState::Ended(status) => self.end(ticket, status),
            FolderState::Killed(_) => {
                if let Some(job) = self.followed.remove(&ticket) {
                    self.fresh.forget(ticket);
                    self.reader
                        .perform(move || vec![killed(ticket, &job.folder)]);
                }
            }
            FolderState::Held => self.attach(ticket),
        }
    }

    /// Connects with a job that computes. One that does not listen yet, or never will, is followed by its file.
    fn attach(&mut self, ticket: JobNumber) {
        let Some(job) = self.followed.get_mut(&ticket) else {
            return;
        };
        let mut reader = job.reader(ticket, &self.fresh, &self.out);
        let may_listen = job.refusals < MOST_REFUSALS;
        let connection = may_listen.then(|| Connection::open(&job.folder).ok());
        if let Some(connection) = connection.flatten() {
            if reader.start(&connection, job.is_shown, &self.sender) {
                job.connection = Some(connection);
            }
        } else if let Some(status) = job.folder.status() {
            reader.status(status);
            job.told = reader.told;
        }
    }

    fn end(&mut self, ticket: JobNumber, status: JobStatus) {
        let Some(job) = self.followed.remove(&ticket) else {
            return;
        };
        self.fresh.forget(ticket);
        let ended = EndedJob {
            ticket,
            folder: job.folder,
            spec: job.spec,
            status,
            is_shown: job.is_shown,
        };
        self.reader.perform(move || ended.messages());
    }
}
