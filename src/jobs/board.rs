//! What a job has to say, for its status file and for everyone who follows it. The solver writes it and never waits: what a follower
//! has not taken yet is decimated to a bounded size.

use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use super::status::{JobPhase, JobStatus};
use crate::case::ChannelId;
use crate::run::event::JobEvent;
use crate::run::{DecimatedRecord, OutputFrame, Progress};

/// Time between two messages to a follower.
const TICK: Duration = Duration::from_millis(100);

/// About how many numbers a message to a follower has.
const NUMBERS: usize = 1 << 13;

/// The board.
#[derive(Debug)]
pub(super) struct Board {
    content: Mutex<Content>,
    changed: Condvar,
}

#[derive(Debug)]
struct Content {
    status: JobStatus,
    /// Grows with each change of the phase, of what is said or where results are.
    phase_changes: u64,
    /// Grows with each change of the progress.
    progress_changes: u64,
    channels: Vec<ChannelId>,
    /// Everything recorded, for those who follow later.
    record: DecimatedRecord,
    followers: BTreeMap<u64, BoardFollower>,
    next: u64,
    has_ended: bool,
}

#[derive(Debug, Default)]
struct BoardFollower {
    wants_rows: bool,
    channels_due: bool,
    fresh: DecimatedRecord,
    phase_changes: u64,
    progress_changes: u64,
}

/// What a follower has not heard yet.
#[derive(Debug, Default)]
pub(super) struct News {
    pub(super) status: Option<JobStatus>,
    pub(super) channels: Option<Vec<String>>,
    pub(super) rows: Option<DecimatedRecord>,
    pub(super) has_ended: bool,
}

impl Board {
    pub(super) fn new(status: JobStatus) -> Self {
        Self {
            content: Mutex::new(Content {
                status,
                phase_changes: 1,
                progress_changes: 1,
                channels: Vec::new(),
                record: DecimatedRecord::default(),
                followers: BTreeMap::new(),
                next: 0,
                has_ended: false,
            }),
            changed: Condvar::new(),
        }
    }

    fn content(&self) -> MutexGuard<'_, Content> {
        self.content.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What the job says of itself.
    pub(super) fn status(&self) -> JobStatus {
        self.content().status.clone()
    }

    /// Changes the phase, or what is said with it.
    pub(super) fn change(&self, change: impl FnOnce(&mut JobStatus)) {
        let mut content = self.content();
        change(&mut content.status);
        content.phase_changes += 1;
        drop(content);
        self.changed.notify_all();
    }

    /// Changes how far the job is.
    pub(super) fn progress(&self, change: impl FnOnce(&mut JobStatus)) {
        let mut content = self.content();
        change(&mut content.status);
        content.progress_changes += 1;
    }

    /// Takes in what a run reports.
    pub(super) fn event(&self, event: &JobEvent) {
        match event {
            JobEvent::Searching(search) => {
                self.progress_of_run(|progress| progress.search = Some(*search));
            }
            JobEvent::Started { channels, .. } => {
                self.progress_of_run(|progress| progress.search = None);
                self.content().begin(channels);
            }
            JobEvent::Frame(frame) => {
                let mut content = self.content();
                content.frame(frame);
                content.status.progress = Some(frame.progress);
                content.progress_changes += 1;
            }
            JobEvent::Estimating => self.progress_of_run(|progress| progress.estimating = true),
            JobEvent::Case(_) | JobEvent::Checkpoint(_) | JobEvent::Finished(_) => {}
        }
    }

    fn progress_of_run(&self, change: impl FnOnce(&mut Progress)) {
        self.progress(|status| change(status.progress.get_or_insert_default()));
    }

    /// The job has ended so; nothing is changed any more.
    pub(super) fn end(&self, status: JobStatus) {
        let mut content = self.content();
        content.status = status;
        content.has_ended = true;
        content.phase_changes += 1;
        drop(content);
        self.changed.notify_all();
    }

    /// Waits until everyone who follows has left, or the time is up.
    pub(super) fn wait_for_followers(&self, limit: Duration) {
        let content = self.content();
        let are_there = |content: &mut Content| !content.followers.is_empty();
        drop(self.changed.wait_timeout_while(content, limit, are_there));
    }

    /// Waits for a change of the phase, at most so long; whether anything changed since these changes, which are renewed.
    pub(super) fn wait_for_phase(&self, known: &mut (u64, u64), limit: Duration) -> bool {
        let content = self.content();
        let as_known = |content: &mut Content| content.phase_changes == known.0;
        let waited = self.changed.wait_timeout_while(content, limit, as_known);
        let (content, _) = waited.unwrap_or_else(PoisonError::into_inner);
        let changes = (content.phase_changes, content.progress_changes);
        let has_changed = changes != *known;
        *known = changes;
        has_changed
    }

    /// Someone follows from now on; the number is for the calls below.
    pub(super) fn join(&self) -> u64 {
        let mut content = self.content();
        content.next += 1;
        let number = content.next;
        content.followers.insert(number, BoardFollower::default());
        number
    }

    /// A follower wants what is recorded, from the beginning, or no more.
    pub(super) fn want_rows(&self, follower: u64, rows: bool) {
        let mut content = self.content();
        let has_begun = !content.record.history().time.is_empty();
        let record = match rows && has_begun {
            true => content.record.clone(),
            false => content.no_rows(),
        };
        if let Some(follower) = content.followers.get_mut(&follower) {
            follower.wants_rows = rows;
            follower.channels_due = rows;
            follower.fresh = record;
        }
        drop(content);
        self.changed.notify_all();
    }

    /// A follower has left.
    pub(super) fn leave(&self, follower: u64) {
        self.content().followers.remove(&follower);
        self.changed.notify_all();
    }

    /// What a follower has not heard, after a moment at most; nothing for one who has left.
    pub(super) fn news(&self, follower: u64) -> Option<News> {
        let content = self.content();
        let waited = self.changed.wait_timeout_while(content, TICK, |content| {
            let changes = content.phase_changes;
            let known = content.followers.get(&follower);
            known.is_some_and(|known| known.phase_changes == changes && !known.channels_due)
        });
        let (mut content, _) = waited.unwrap_or_else(PoisonError::into_inner);
        content.news(follower)
    }
}

impl Content {
    /// A record of what a follower has not heard, before there is anything.
    fn no_rows(&self) -> DecimatedRecord {
        DecimatedRecord::within(self.channels.iter().cloned(), NUMBERS)
    }

    fn begin(&mut self, channels: &[ChannelId]) {
        self.channels = channels.to_vec();
        self.record = DecimatedRecord::new(channels.iter().cloned());
        for follower in self.followers.values_mut() {
            follower.channels_due = follower.wants_rows;
            follower.fresh = DecimatedRecord::within(channels.iter().cloned(), NUMBERS);
        }
    }

    fn frame(&mut self, frame: &OutputFrame) {
        let following = self.followers.values_mut();
        let wanting = following.filter(|follower| follower.wants_rows);
        let fresh = wanting.map(|follower| &mut follower.fresh);
        for record in fresh.chain([&mut self.record]) {
            record.row(frame.time, &frame.values);
            record.add_shapes(&frame.shapes);
        }
    }

    fn news(&mut self, number: u64) -> Option<News> {
        let follower = self.followers.get_mut(&number)?;
        let changes = (self.phase_changes, self.progress_changes);
        let has_changed = changes != (follower.phase_changes, follower.progress_changes);
        (follower.phase_changes, follower.progress_changes) = changes;
        let status = has_changed.then(|| self.status.clone());
        let names = || self.channels.iter().map(ToString::to_string).collect();
        let channels = std::mem::take(&mut follower.channels_due).then(names);
        let is_due = follower.wants_rows && !follower.fresh.history().time.is_empty();
        let rows = is_due.then(|| {
            let none = DecimatedRecord::within(self.channels.iter().cloned(), NUMBERS);
            std::mem::replace(&mut follower.fresh, none)
        });
        Some(News {
            status,
            // Before a run begins there are none.
            channels: channels.filter(|_| !self.channels.is_empty()),
            rows,
            has_ended: self.has_ended,
        })
    }
}

/// A job that waits is as one that has said nothing else.
impl Default for Board {
    fn default() -> Self {
        Self::new(JobStatus::new(JobPhase::Queued))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::ChannelQuantity;

    fn frame(time: f64) -> JobEvent {
        JobEvent::Frame(Box::new(OutputFrame {
            time,
            values: vec![time.sin()],
            shapes: Vec::new(),
            progress: Progress {
                time,
                steps: 1,
                ..Progress::default()
            },
        }))
    }

    fn begun() -> Board {
        let board = Board::default();
        let channels = vec![ChannelQuantity::X.at("a")];
        board.event(&JobEvent::Started {
            channels,
            lines: Vec::new(),
        });
        board
    }

    #[test]
    fn who_follows_later_hears_everything_once() {
        let board = begun();
        (0..10).for_each(|i| board.event(&frame(f64::from(i))));
        let follower = board.join();
        board.want_rows(follower, true);
        let first = board.news(follower).unwrap();
        assert_eq!(first.channels.unwrap(), ["x_m[a]"]);
        assert_eq!(first.rows.unwrap().history().time.len(), 10);
        board.event(&frame(10.0));
        let second = board.news(follower).unwrap();
        assert!(second.channels.is_none());
        assert_eq!(second.rows.unwrap().history().time, [10.0]);
        assert_eq!(second.status.unwrap().progress.unwrap().time, 10.0);
    }

    #[test]
    fn what_nobody_takes_stays_within_bounds() {
        let board = begun();
        let follower = board.join();
        board.want_rows(follower, true);
        board.news(follower).unwrap();
        (0..100_000).for_each(|i| board.event(&frame(f64::from(i))));
        let rows = board.news(follower).unwrap().rows.unwrap();
        let kept = rows.history().time.len();
        assert!(kept <= NUMBERS / 2, "{kept}");
        assert!(rows.history().channels[0].peak.0 > 0.99999);
    }

    #[test]
    fn the_end_is_heard_and_who_has_left_hears_nothing() {
        let board = begun();
        let (stays, leaves) = (board.join(), board.join());
        board.leave(leaves);
        assert!(board.news(leaves).is_none());
        board.end(JobStatus::new(JobPhase::Done));
        let last = board.news(stays).unwrap();
        assert!(last.has_ended && last.status.unwrap().phase == JobPhase::Done);
        board.leave(stays);
        board.wait_for_followers(Duration::from_secs(60));
    }
}
