//! Everything the screen knows, as plain data. Only [`update`](super::update()) changes it.

pub mod case_list;
pub mod curves;
pub mod jobs;
pub mod open_case;
pub mod overlay;

pub use case_list::{CaseEntry, CaseList};
pub use curves::{Curves, RunSlot, SlotKind, SlotState};
pub use jobs::{JobLine, JobState, Jobs, Purpose, Ticket};
pub use open_case::{ChartKind, Editing, OpenCase};
pub use overlay::{Choice, Overlay, Question};

use super::command::Place;
use super::terminal::looks::Looks;

/// The whole state of the workbench.
#[derive(Debug, Clone)]
pub struct State {
    /// Columns and rows of the terminal.
    pub size: (u16, u16),
    /// Glyphs and colour.
    pub looks: Looks,
    /// The list of cases.
    pub cases: CaseList,
    /// The case that is open.
    pub open: Option<OpenCase>,
    /// Jobs that run, wait or have ended.
    pub jobs: Jobs,
    /// What lies over the screen and takes the keys.
    pub overlay: Option<Overlay>,
    /// The latest message.
    pub note: Option<Note>,
    /// All messages, oldest first.
    pub log: Vec<Note>,
    /// True after a Ctrl-C: the next one quits.
    pub interrupted: bool,
}

/// A message to the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// How much it matters.
    pub level: Level,
    /// Full sentences.
    pub text: String,
}

/// How much a message matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// Goes away with the next key.
    Info,
    /// Stays until the next message.
    Warning,
    /// Stays, and is an obstacle.
    Error,
}

impl State {
    /// An empty workbench.
    #[must_use]
    pub fn new(size: (u16, u16), looks: Looks) -> Self {
        Self {
            size,
            looks,
            cases: CaseList::default(),
            open: None,
            jobs: Jobs::default(),
            overlay: None,
            note: None,
            log: Vec::new(),
            interrupted: false,
        }
    }

    /// Where the keys go.
    #[must_use]
    pub fn place(&self) -> Place {
        self.open.as_ref().map_or(Place::Cases, |open| open.pane)
    }

    /// Says something and keeps it in the log.
    pub fn say(&mut self, level: Level, text: impl Into<String>) {
        let note = Note {
            level,
            text: text.into(),
        };
        self.log.push(note.clone());
        self.note = Some(note);
    }
}
