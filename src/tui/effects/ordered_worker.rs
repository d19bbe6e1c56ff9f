//! A thread that does what is asked for in its order, so that the screen waits neither for a disk nor for a check.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use crossbeam_channel::{Sender, unbounded};

use super::outbox::Outbox;
use crate::msg::Msg;

type OrderedTask = Box<dyn FnOnce() -> Vec<Msg> + Send>;

/// The thread.
#[derive(Debug)]
pub(super) struct OrderedWorker {
    queue: Option<Sender<OrderedTask>>,
    open: Arc<(Mutex<Open>, Condvar)>,
}

/// What is asked for and not done.
#[derive(Debug, Default)]
struct Open {
    count: usize,
    /// When the first of it was asked for.
    since: Option<Instant>,
}

impl Open {
    fn add(&mut self) {
        self.count += 1;
        self.since.get_or_insert_with(Instant::now);
    }

    fn remove(&mut self) {
        self.count = self.count.saturating_sub(1);
        if self.count == 0 {
            self.since = None;
        }
    }
}

impl OrderedWorker {
    /// Starts the thread; where the system gives none, everything is done at once.
    pub(super) fn start(name: &str, out: Outbox) -> Self {
        let (queue, work) = unbounded::<OrderedTask>();
        let open: Arc<(Mutex<Open>, Condvar)> = Arc::default();
        let done = Arc::clone(&open);
        let started = std::thread::Builder::new()
            .name(name.to_owned())
            .spawn(move || {
                for work in work {
                    // The panic hook reports a fault; what comes after it is still done.
                    let answers = catch_unwind(AssertUnwindSafe(work)).unwrap_or_default();
                    answers.into_iter().for_each(|msg| out.send(msg));
                    lock(&done.0).remove();
                    done.1.notify_all();
                    out.wake();
                }
            });
        Self {
            queue: started.ok().map(|_| queue),
            open,
        }
    }

    /// Does something after all that was asked for before; answers come as messages.
    pub(super) fn perform(&self, work: impl FnOnce() -> Vec<Msg> + Send + 'static) -> Vec<Msg> {
        let Some(queue) = &self.queue else {
            return work();
        };
        lock(&self.open.0).add();
        match queue.send(Box::new(work)) {
            Ok(()) => Vec::new(),
            Err(back) => {
                lock(&self.open.0).remove();
                back.into_inner()()
            }
        }
    }

    /// Waits until everything is done, or the time is up: a disk that hangs must not keep the program.
    pub(super) fn finish(&self, limit: Duration) {
        let open = lock(&self.open.0);
        drop(
            self.open
                .1
                .wait_timeout_while(open, limit, |open| open.count > 0),
        );
    }

    /// For how long it has been at work without a pause; nothing when all is done.
    pub(super) fn busy_for(&self) -> Option<Duration> {
        lock(&self.open.0).since.map(|since| since.elapsed())
    }
}

fn lock(open: &Mutex<Open>) -> MutexGuard<'_, Open> {
    open.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::super::outbox::Inbox;
    use super::*;

    #[test]
    fn files_are_written_in_order_and_all_of_them_before_the_end() {
        let (out, mut inbox) = Inbox::new().unwrap();
        let worker = OrderedWorker::start("files", out);
        let seen: Arc<Mutex<Vec<usize>>> = Arc::default();
        for number in 0..100 {
            let seen = Arc::clone(&seen);
            worker.perform(move || {
                std::thread::sleep(Duration::from_micros(50));
                seen.lock().unwrap().push(number);
                vec![Msg::ChangedOnDisk]
            });
        }
        worker.finish(Duration::from_secs(60));
        assert_eq!(*seen.lock().unwrap(), (0..100).collect::<Vec<_>>());
        assert_eq!(inbox.take().len(), 100);
    }

    #[test]
    fn a_disk_that_hangs_does_not_keep_the_program() {
        let (out, _inbox) = Inbox::new().unwrap();
        let worker = OrderedWorker::start("files", out);
        let (held, hold) = crossbeam_channel::bounded::<()>(0);
        worker.perform(move || {
            let _ = hold.recv();
            Vec::new()
        });
        worker.finish(Duration::from_millis(20));
        drop(held);
    }
}
