//! The curves of one run: streamed while it computes, whole when it is done.

use std::path::PathBuf;
use std::sync::Arc;

use super::jobs::{JobNumber, JobState};
use crate::case::{ChannelId, StudyPoint, TextDigest};
use crate::run::index::IndexedRun;
use crate::run::store::RunNotes;
use crate::run::{DecimatedRecord, History, LineShape, OutputFrame, Progress, Run, RunState};

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
    pub fn push(&mut self, frame: &OutputFrame) {
        self.progress = frame.progress;
        self.streamed.row(frame.time, &frame.values);
        self.streamed.add_shapes(&frame.shapes);
    }

    /// Adds the shapes of the lines at an instant.
    pub fn push_shapes(&mut self, shapes: &[LineShape]) {
        self.streamed.add_shapes(shapes);
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
    /// Its number in the index of runs, once it is there.
    pub number: Option<i64>,
    /// The case text it computes, to decide whether it is of the edited case.
    pub text: TextDigest,
    /// When it began, RFC 3339 in UTC; empty before.
    pub started: String,
    /// Simulated time asked for \[s\].
    pub duration_s: f64,
    /// What the user says of it.
    pub notes: RunNotes,
    /// Chosen for what is done to several runs.
    pub marked: bool,
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
    /// A run of this session that waits for its turn.
    #[must_use]
    pub fn session(text: TextDigest, method: String) -> Self {
        Self {
            ticket: None,
            id: String::new(),
            label: String::new(),
            at: None,
            number: None,
            text,
            started: String::new(),
            duration_s: 0.0,
            notes: RunNotes::default(),
            marked: false,
            kind: RunOrigin::Session,
            state: RunStatus::Job(JobState::Queued),
            method,
            dir: None,
            cost: None,
            shown: false,
            curves: RunCurves::default(),
        }
    }

    /// A stored run, without its curves; `held` while a program computes it.
    #[must_use]
    pub fn stored(run: IndexedRun, dir: PathBuf, held: bool) -> Self {
        let failure = run.failure.unwrap_or_default();
        Self {
            ticket: None,
            id: run.name,
            label: run.overrides.join(", "),
            at: None,
            number: Some(run.id),
            text: run.text,
            started: run.started,
            duration_s: run.duration_s,
            notes: run.notes,
            marked: false,
            kind: RunOrigin::Stored,
            state: match run.state {
                RunState::Done => RunStatus::Job(JobState::Done),
                RunState::Partial if held => RunStatus::Elsewhere,
                RunState::Partial => RunStatus::Partial,
                RunState::Cancelled => RunStatus::Job(JobState::Cancelled),
                RunState::Failed => RunStatus::Job(JobState::Failed(failure)),
            },
            method: run.method,
            dir: Some(dir),
            cost: Some((run.steps, run.cpu_s)),
            shown: false,
            curves: RunCurves::default(),
        }
    }

    /// What the index says anew of a run that is in the list.
    pub fn renew(&mut self, new: Self) {
        self.number = new.number;
        self.notes = new.notes;
        self.started = new.started;
        // What this session computes it knows better.
        if self.kind == RunOrigin::Stored {
            let changed = self.state != new.state || self.text != new.text;
            self.state = new.state;
            self.text = new.text;
            self.cost = new.cost;
            self.method = new.method;
            if changed {
                self.curves = RunCurves::default();
            }
        }
    }

    /// How the run is called: by the name that the user gave it, or by that of its directory.
    #[must_use]
    pub fn title(&self) -> String {
        if self.notes.name.is_empty() {
            self.id.clone()
        } else {
            self.notes.name.clone()
        }
    }
}
