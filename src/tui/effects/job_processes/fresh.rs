//! What jobs have recorded since the screen last asked. However long it takes, that stays within bounds.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::case::ChannelId;
use crate::jobs::protocol::Rows;
use crate::msg::Msg;
use crate::run::{LineShape, OutputFrame, Progress};
use crate::state::{JobNumber, RunCurves};

/// What is recorded by the jobs that are followed.
#[derive(Debug, Clone, Default)]
pub(super) struct Fresh {
    jobs: Arc<Mutex<BTreeMap<JobNumber, FreshCurves>>>,
}

#[derive(Debug, Default)]
struct FreshCurves {
    curves: RunCurves,
    progress: Progress,
    is_changed: bool,
}

impl Fresh {
    fn jobs(&self) -> MutexGuard<'_, BTreeMap<JobNumber, FreshCurves>> {
        self.jobs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The record of a job begins, or begins anew.
    pub(super) fn begin(&self, ticket: JobNumber, channels: Vec<ChannelId>) {
        self.jobs()
            .entry(ticket)
            .or_default()
            .curves
            .begin(channels);
    }

    /// A job is so far.
    pub(super) fn progress(&self, ticket: JobNumber, progress: Progress) {
        let mut jobs = self.jobs();
        let fresh = jobs.entry(ticket).or_default();
        fresh.progress = progress;
        fresh.is_changed = true;
    }

    /// A job has recorded these rows.
    pub(super) fn rows(&self, ticket: JobNumber, rows: Rows) {
        let mut jobs = self.jobs();
        let fresh = jobs.entry(ticket).or_default();
        for (row, time) in rows.time.iter().enumerate() {
            let values = rows.values.iter().filter_map(|v| v.0.get(row));
            fresh.curves.push(&OutputFrame {
                time: *time,
                values: values.copied().collect(),
                shapes: Vec::new(),
                progress: fresh.progress,
            });
        }
        let shapes: Vec<LineShape> = rows.shapes.into_iter().map(LineShape::from).collect();
        for at_once in shapes.chunk_by(|one, other| one.time == other.time) {
            fresh.curves.push_shapes(at_once);
        }
        fresh.is_changed = true;
    }

    /// Nothing more comes of a job.
    pub(super) fn forget(&self, ticket: JobNumber) {
        self.jobs().remove(&ticket);
    }

    /// What has changed since the last call.
    pub(super) fn take(&self) -> Vec<Msg> {
        let mut jobs = self.jobs();
        let changed = jobs.iter_mut().filter(|(_, fresh)| fresh.is_changed);
        let messages = changed.map(|(ticket, fresh)| {
            fresh.is_changed = false;
            let mut curves = fresh.curves.take().unwrap_or_default();
            curves.progress = fresh.progress;
            Msg::Recorded(*ticket, Box::new(curves))
        });
        messages.collect()
    }
}
