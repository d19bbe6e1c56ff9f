//! Sweeps: read and judged by a thread of their own, computed by one for each, at lower priority than the screen.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::ordered_worker::OrderedWorker;
use super::outbox::Outbox;
use crate::background::lower_priority;
use crate::jobs::{SweepEvent, compute_sweep, on_all_cores_but_one};
use crate::msg::Msg;
use crate::run::store;
use crate::state::JobNumber;
use crate::state::sweep_request::{SweepEffect, SweepMsg, SweepRequest};
use crate::state::sweep_verdict::SweepVerdict;
use crate::state::sweeps::SweepRead;
use crate::study::sweep::{SweepSnapshot, stored_sweeps};

/// Why there is no answer after a panic.
const FAULT: &str = "This failed by a fault of seacable.";

/// The threads.
#[derive(Debug)]
pub(super) struct SweepWorker {
    reader: OrderedWorker,
    /// Records take longer to read than results, which do not wait for them.
    judge: OrderedWorker,
    out: Outbox,
    /// The flags that stop what is computed.
    jobs: HashMap<JobNumber, Arc<AtomicBool>>,
}

impl SweepWorker {
    pub(super) fn new(out: Outbox) -> Self {
        Self {
            reader: OrderedWorker::start("sweeps", out.clone()),
            judge: OrderedWorker::start("verdicts", out.clone()),
            out,
            jobs: HashMap::new(),
        }
    }

    /// Does what is asked for; answers come as messages.
    pub(super) fn perform(&mut self, effect: SweepEffect) -> Vec<Msg> {
        match effect {
            SweepEffect::Start(ticket, request) => self.start(ticket, *request),
            effect @ (SweepEffect::Check(_) | SweepEffect::Compare(..)) => {
                self.judge.perform(|| answered(effect))
            }
            effect => self.reader.perform(|| answered(effect)),
        }
    }

    /// Stops a sweep; what is done of it stays.
    pub(super) fn cancel(&self, ticket: JobNumber) {
        if let Some(cancel) = self.jobs.get(&ticket) {
            cancel.store(true, Ordering::Relaxed);
        }
    }

    /// A sweep has ended.
    pub(super) fn forget(&mut self, ticket: JobNumber) {
        self.jobs.remove(&ticket);
    }

    fn start(&mut self, ticket: JobNumber, request: SweepRequest) -> Vec<Msg> {
        let (cancel, out) = (Arc::new(AtomicBool::new(false)), self.out.clone());
        self.jobs.insert(ticket, Arc::clone(&cancel));
        let started = std::thread::Builder::new()
            .name(format!("sweep-{ticket}"))
            .spawn(move || {
                lower_priority();
                let compute = || compute(ticket, &request, &cancel, &out);
                // It always answers; the panic hook reports a fault of it.
                let ended = catch_unwind(AssertUnwindSafe(compute));
                let ended = ended.unwrap_or_else(|_| Err(FAULT.to_owned()));
                out.send(Msg::Sweep(SweepMsg::Ended(ticket, ended)));
            });
        match started {
            Ok(_) => Vec::new(),
            Err(error) => {
                let why = format!("The system gives no thread for the load cases: {error}.");
                vec![Msg::Sweep(SweepMsg::Ended(ticket, Err(why)))]
            }
        }
    }
}

/// Reads or judges, at lower priority than the screen.
fn answered(effect: SweepEffect) -> Vec<Msg> {
    lower_priority();
    let answer = on_all_cores_but_one(|| answer(effect));
    answer.into_iter().map(Msg::Sweep).collect()
}

/// Reads or judges.
fn answer(effect: SweepEffect) -> Option<SweepMsg> {
    Some(match effect {
        SweepEffect::List(file) => {
            let stored = stored_sweeps(Path::new(store::DEFAULT_ROOT), &file);
            SweepMsg::Listed(file, stored)
        }
        SweepEffect::Read { dir, known } => {
            let read = || match known {
                Some(known) => known.newer(),
                None => SweepSnapshot::read(&dir, &AtomicBool::new(false)),
            };
            let read = catch_unwind(AssertUnwindSafe(|| read().map(SweepRead::new)));
            SweepMsg::Read(dir, read.unwrap_or_else(|_| Err(FAULT.to_owned())))
        }
        SweepEffect::Check(snapshot) => {
            let verdict = catch_unwind(AssertUnwindSafe(|| SweepVerdict::of_snapshot(&snapshot)));
            let verdict = verdict.unwrap_or_else(|_| SweepVerdict {
                done: snapshot.done(),
                ..SweepVerdict::default()
            });
            SweepMsg::Checked(snapshot.dir.clone(), Arc::new(verdict))
        }
        SweepEffect::Compare(snapshot, request) => {
            let same = catch_unwind(AssertUnwindSafe(|| request.is_of(&snapshot)));
            SweepMsg::Compared(snapshot.dir.clone(), request.text, same.unwrap_or(false))
        }
        SweepEffect::Start(..) => return None,
    })
}

/// Computes the load cases of a text, and passes on what is said of them.
fn compute(
    ticket: JobNumber,
    request: &SweepRequest,
    cancel: &AtomicBool,
    out: &Outbox,
) -> Result<(SweepRead, bool), String> {
    let ended = compute_sweep(request, cancel, &|event| {
        out.send(Msg::Sweep(match event {
            SweepEvent::Begun(dir) => SweepMsg::Begun(ticket, dir),
            SweepEvent::Progress(progress, seconds) => {
                SweepMsg::Progress(ticket, progress, seconds)
            }
        }));
    })?;
    Ok((SweepRead::new(ended.snapshot), ended.is_cancelled))
}
