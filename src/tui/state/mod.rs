//! Everything the screen knows, as plain data. Only [`update`](super::update()) changes it.

pub mod case_list;
pub mod curves;
pub mod jobs;
pub mod modes;
pub mod open_case;
pub mod open_file;
pub mod overlay;
pub mod parameter_editor;
pub mod ropeway;
pub mod section;
pub mod ship;
pub mod trials;

pub use case_list::{CaseEntry, CaseList};
pub use curves::{Curves, RunEntry, RunOrigin, RunStatus};
pub use jobs::{JobLine, JobState, Jobs, Purpose, Ticket, Waiting};
pub use open_case::{ChartKind, OpenCase};
pub use open_file::{Content, FileView, OpenFile};
pub use overlay::{Choice, Overlay, Question};
pub use parameter_editor::{Editing, ParameterEditor};
pub use ropeway::RopewayView;
pub use section::SectionView;
pub use ship::ShipView;

use super::pane::PaneId;
use super::terminal::capabilities::Capabilities;

/// The whole state of the workbench.
#[derive(Debug, Clone)]
pub struct AppState {
    /// Columns and rows of the terminal.
    pub size: (u16, u16),
    /// Glyphs and colour.
    pub capabilities: Capabilities,
    /// The list of cases.
    pub cases: CaseList,
    /// The case that is open.
    pub open: Option<OpenCase>,
    /// The file of another kind that is open; then no case is.
    pub file: Option<OpenFile>,
    /// Trials of hard cases, over whatever else is open.
    pub trials: Option<trials::Trials>,
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

impl AppState {
    /// An empty workbench.
    #[must_use]
    pub fn new(size: (u16, u16), capabilities: Capabilities) -> Self {
        Self {
            size,
            capabilities,
            cases: CaseList::default(),
            open: None,
            file: None,
            trials: None,
            jobs: Jobs::default(),
            overlay: None,
            note: None,
            log: Vec::new(),
            interrupted: false,
        }
    }

    /// Where the keys go.
    #[must_use]
    pub fn focus(&self) -> PaneId {
        if self.trials.as_ref().is_some_and(|t| t.shown) {
            return PaneId::Trials;
        }
        match (&self.file, &self.open) {
            (Some(file), _) => file.pane,
            (None, Some(open)) => open.pane,
            (None, None) => PaneId::Cases,
        }
    }

    /// Whether the natural modes are seen beside the inputs.
    #[must_use]
    pub fn modes_beside(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.modes.beside)
    }

    /// The panes of what is open, in the order of their numbers; those of a line case where nothing is.
    #[must_use]
    pub fn panes(&self) -> &'static [PaneId] {
        match &self.file {
            Some(file) => file.content.view().panes(),
            None => &PaneId::PANES,
        }
    }

    /// The file in the parameter editor, of whatever kind.
    #[must_use]
    pub fn editor(&self) -> Option<&ParameterEditor> {
        match (&self.file, &self.open) {
            (Some(file), _) => Some(&file.editor),
            (None, Some(open)) => Some(&open.editor),
            (None, None) => None,
        }
    }

    /// The file in the parameter editor, to be changed.
    pub fn editor_mut(&mut self) -> Option<&mut ParameterEditor> {
        match (&mut self.file, &mut self.open) {
            (Some(file), _) => Some(&mut file.editor),
            (None, Some(open)) => Some(&mut open.editor),
            (None, None) => None,
        }
    }

    /// Leaves what is open, and stops what it does in the background.
    pub fn close(&mut self) {
        self.open = None;
        if let Some(OpenFile {
            content: Content::Ship(ship),
            ..
        }) = &mut self.file
        {
            ship.stop();
        }
        self.file = None;
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
