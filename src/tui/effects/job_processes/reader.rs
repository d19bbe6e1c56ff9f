//! Hears what a job says, and passes it on to the screen.

use crossbeam_channel::Sender;

use super::ended::state_of;
use super::fresh::Fresh;
use super::watcher::Input;
use crate::effects::outbox::Outbox;
use crate::jobs::client::{Connection, Said};
use crate::jobs::list::results_from_here;
use crate::jobs::protocol::FromJob;
use crate::jobs::{JobSpec, JobStatus};
use crate::msg::Msg;
use crate::run::Progress;
use crate::run::job::JobEvent;
use crate::state::JobNumber;
use crate::state::job_process::ProcessMsg;
use crate::state::sweep_request::SweepMsg;

/// Hears what a job says, and passes it on.
pub(super) struct Reader {
    pub(super) ticket: JobNumber,
    pub(super) spec: JobSpec,
    pub(super) fresh: Fresh,
    pub(super) out: Outbox,
    /// What the screen was sent of it last.
    pub(super) told: Option<JobStatus>,
}

impl Reader {
    /// Starts a thread that hears; whether there is one.
    pub(super) fn start(
        self,
        connection: &Connection,
        is_shown: bool,
        sender: &Sender<Input>,
    ) -> bool {
        let Ok(said) = connection.said() else {
            return false;
        };
        let asked = connection.follow(is_shown);
        let sender = sender.clone();
        let thread = std::thread::Builder::new().name("job".to_owned());
        asked.is_ok() && thread.spawn(move || self.hear(said, &sender)).is_ok()
    }

    fn hear(mut self, said: Said, sender: &Sender<Input>) {
        crate::background::lower_priority();
        let mut ended = None;
        for message in said {
            match message {
                FromJob::Status(status) => self.status(status),
                FromJob::Channels(names) => {
                    let parsed = names.iter().map(|name| name.parse());
                    let Ok(channels) = parsed.collect::<Result<Vec<_>, _>>() else {
                        break;
                    };
                    self.fresh.begin(self.ticket, channels.clone());
                    self.event(JobEvent::Started {
                        channels,
                        lines: Vec::new(),
                    });
                }
                FromJob::Rows(rows) => {
                    self.fresh.rows(self.ticket, rows);
                    self.out.wake();
                }
                FromJob::Ended(status) => {
                    ended = Some(status);
                    break;
                }
                FromJob::Hello(_) | FromJob::OtherVersion(_) => {}
            }
        }
        // The thread ends with the program only.
        let _ = sender.send(match ended {
            Some(status) => Input::Ended(self.ticket, status),
            None => Input::Left(self.ticket, self.told),
        });
    }

    fn event(&self, event: JobEvent) {
        self.out.send(Msg::Job(self.ticket, Box::new(event)));
    }

    /// Passes on what has changed since the job said so last.
    pub(super) fn status(&mut self, status: JobStatus) {
        let told = self.told.take();
        let told = told.as_ref();
        let ticket = self.ticket;
        if told.map(|told| told.phase) != Some(status.phase) && !status.phase.has_ended() {
            self.out
                .send(Msg::Process(ProcessMsg::Is(ticket, state_of(&status))));
        }
        let results = status.results.as_ref();
        if let Some(dir) = results.filter(|_| told.is_none_or(|told| told.results.is_none())) {
            let dir = results_from_here(&self.spec, dir);
            self.out.send(match self.spec.is_sweep() {
                true => Msg::Sweep(SweepMsg::Begun(ticket, dir)),
                false => Msg::Stored(ticket, dir),
            });
        }
        if let Some(progress) = status.progress {
            let before = told.and_then(|told| told.progress);
            self.progress(progress, before);
        }
        if let Some(progress) = status.load_cases {
            let (count, seconds) = (progress.count, progress.wall_s);
            self.out
                .send(Msg::Sweep(SweepMsg::Progress(ticket, count, seconds)));
        }
        self.told = Some(status);
    }

    fn progress(&self, progress: Progress, before: Option<Progress>) {
        if progress.estimating && !before.is_some_and(|before| before.estimating) {
            self.event(JobEvent::Estimating);
        }
        if before != Some(progress) {
            self.fresh.progress(self.ticket, progress);
            self.out.wake();
        }
    }
}
