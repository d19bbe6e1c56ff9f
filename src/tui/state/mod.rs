//! Everything the screen knows, as plain data. Only [`update`](super::update()) changes it.

pub mod case_list;
pub mod curves;
pub mod jobs;
pub mod open_case;
pub mod overlay;
pub mod ropeway;
pub mod section;
pub mod sheet;

pub use case_list::{CaseEntry, CaseList};
pub use curves::{Curves, RunSlot, SlotKind, SlotState};
pub use jobs::{JobLine, JobState, Jobs, Purpose, Ticket};
pub use open_case::{ChartKind, OpenCase};
pub use overlay::{Choice, Overlay, Question};
pub use ropeway::OpenRopeway;
pub use section::OpenSection;
pub use sheet::{Editing, Sheet};

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
    /// The cross-section that is open; then no case is.
    pub section: Option<OpenSection>,
    /// The ropeway that is open; then neither a case nor a cross-section is.
    pub ropeway: Option<Box<OpenRopeway>>,
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

/// The kinds of file that can be open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A line case.
    Case,
    /// A cross-section.
    Section,
    /// A ropeway.
    Ropeway,
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
            section: None,
            ropeway: None,
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
        match (&self.ropeway, &self.section, &self.open) {
            (Some(ropeway), ..) => ropeway.pane,
            (None, Some(section), _) => section.pane,
            (None, None, Some(open)) => open.pane,
            (None, None, None) => Place::Cases,
        }
    }

    /// What kind of file is open; a line case where none is.
    #[must_use]
    pub fn kind(&self) -> FileKind {
        match (&self.ropeway, &self.section) {
            (Some(_), _) => FileKind::Ropeway,
            (None, Some(_)) => FileKind::Section,
            (None, None) => FileKind::Case,
        }
    }

    /// The file in the parameter editor, of whatever kind.
    #[must_use]
    pub fn sheet(&self) -> Option<&Sheet> {
        match (&self.ropeway, &self.section, &self.open) {
            (Some(ropeway), ..) => Some(&ropeway.sheet),
            (None, Some(section), _) => Some(&section.sheet),
            (None, None, Some(open)) => Some(&open.sheet),
            (None, None, None) => None,
        }
    }

    /// The file in the parameter editor, to be changed.
    pub fn sheet_mut(&mut self) -> Option<&mut Sheet> {
        match (&mut self.ropeway, &mut self.section, &mut self.open) {
            (Some(ropeway), ..) => Some(&mut ropeway.sheet),
            (None, Some(section), _) => Some(&mut section.sheet),
            (None, None, Some(open)) => Some(&mut open.sheet),
            (None, None, None) => None,
        }
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
