//! The curves of one run: streamed while it computes, whole when it is done.

use std::path::PathBuf;
use std::sync::Arc;

use super::jobs::{JobNumber, JobState};
use crate::case::{ChannelId, StudyPoint};
use crate::run::{
    DecimatedRecord, History, LineShape, OutputFrame, Progress, Run, RunInfo, RunState,
};

/// What is known of a run so far.
#[derive(Debug, Clone, Default)]
pub struct RunCurves {
    streamed: DecimatedRecord,
    /// The run, once it is complete.
    pub run: Option<Arc<Run>>,
    /// How far it is.
    pub progress: Progress,
}

impl RunCurves {
    /// The curves of a complete run.
    #[must_use]
    pub fn whole(run: Arc<Run>) -> Self {
        Self {
            run: Some(run),
            ..Self::default()
        }
    }

    /// Names the channels that frames will fill.
    pub fn begin(&mut self, channels: Vec<ChannelId>) {
        self.streamed = DecimatedRecord::new(channels);
    }

    /// Adds an output instant.
    pub fn push(&mut self, frame: OutputFrame) {
        self.progress = frame.progress;
        self.streamed.row(frame.time, &frame.values);
        if let Some(shape) = frame.shape {
            self.streamed.shape(shape);
        }
    }

    /// Adds what was streamed to other curves of the same run since.
    pub fn append(&mut self, later: &Self) {
        self.progress = later.progress;
        self.streamed.append(&later.streamed);
    }

    /// Takes what was streamed so far, if anything, and leaves the channels.
    pub fn take(&mut self) -> Option<Self> {
        let channels = &self.streamed.history().channels;
        if self.streamed.history().time.is_empty() {
            return None;
        }
        let channels: Vec<_> = channels.iter().map(|c| c.id.clone()).collect();
        let empty = Self {
            streamed: DecimatedRecord::new(channels),
            ..Self::default()
        };
        Some(std::mem::replace(self, empty))
    }

    /// The complete run takes the place of what was streamed.
    pub fn finish(&mut self, run: Arc<Run>) {
        self.streamed = DecimatedRecord::default();
        self.run = Some(run);
    }

    /// Channels against time.
    #[must_use]
    pub fn history(&self) -> &History {
        let streamed = self.streamed.history();
        self.run.as_ref().map_or(streamed, |run| &run.history)
    }

    /// Shapes of the line, oldest first.
    #[must_use]
    pub fn shapes(&self) -> &[LineShape] {
        let streamed = self.streamed.shapes();
        self.run.as_ref().map_or(streamed, |run| &run.shapes)
    }
}

/// Where a run of the list comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunOrigin {
    /// Asked for in this session.
    Session,
    /// Found on disk.
    Stored,
}

/// State of a run of the list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RunStatus {
    /// That of its job, in this session or an earlier one.
    Job(JobState),
    /// Another program computes it.
    Elsewhere,
    /// Found incomplete: the program that wrote it was killed.
    Partial,
    /// Cannot be read, for this reason.
    Unreadable(String),
}

impl RunStatus {
    /// Its word on screen.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Job(state) => state.word(),
            Self::Elsewhere => "elsewhere",
            Self::Partial => "killed",
            Self::Unreadable(_) => "unreadable",
        }
    }
}

/// A run of the list.
#[derive(Debug, Clone)]
pub struct RunEntry {
    /// Number of its job, in this session.
    pub ticket: Option<JobNumber>,
    /// Name, as of its directory once it has one.
    pub id: String,
    /// What is special about it ("current.speed_m_per_s = 0.2"), or empty.
    pub label: String,
    /// The point of a study it belongs to; absent: the edited case.
    pub at: Option<StudyPoint>,
    /// The case text it computes, to decide whether it is of the edited case.
    pub text: String,
    /// Where it comes from.
    pub kind: RunOrigin,
    /// Its state.
    pub state: RunStatus,
    /// Method, for the list.
    pub method: String,
    /// Its directory, once there is one.
    pub dir: Option<PathBuf>,
    /// Steps and CPU time, for the list, once known.
    pub cost: Option<(u64, f64)>,
    /// Whether the charts show it.
    pub shown: bool,
    /// Its curves; a stored run has none before it is first shown.
    pub curves: RunCurves,
}

impl RunEntry {
    /// A stored run, without its curves.
    #[must_use]
    pub fn stored(info: &RunInfo, text: String) -> Self {
        Self {
            ticket: None,
            id: info.id.clone(),
            label: String::new(),
            at: None,
            text,
            kind: RunOrigin::Stored,
            state: match info.state {
                RunState::Done => RunStatus::Job(JobState::Done),
                RunState::Partial => RunStatus::Partial,
                RunState::Cancelled => RunStatus::Job(JobState::Cancelled),
                RunState::Failed => {
                    RunStatus::Job(JobState::Failed(info.failure.clone().unwrap_or_default()))
                }
            },
            method: info.settings.method.clone(),
            dir: None,
            cost: Some((info.work.steps, info.cost.cpu_s)),
            shown: false,
            curves: RunCurves::default(),
        }
    }
}
