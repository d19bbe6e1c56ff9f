//! Everything the screen knows, as plain data. Only [`update`](super::update()) changes it.

pub mod case_list;
pub mod command_line;
pub mod curves;
pub mod document;
mod document_content;
pub mod document_kind;
pub mod edit_check;
mod field_rows;
mod focused_table;
pub mod form;
mod inputs_before;
pub mod job_process;
pub mod jobs;
pub mod line;
pub mod model_list;
pub mod modes;
pub mod overlay;
pub mod parameter_editor;
pub mod part_request;
pub mod parts;
pub mod pending;
pub mod picker;
pub mod reading;
pub mod report;
pub mod ropeway;
pub mod run_list;
pub mod runs_view;
pub mod section;
pub mod ship;
mod status;
pub mod study_of;
pub mod study_request;
pub mod sweep_request;
pub mod sweep_verdict;
pub mod sweeps;
pub mod system;
pub mod text_request;
pub mod trials;
pub mod value_check;
pub mod variants;

pub use case_list::{CaseEntry, CaseList, Filter};
pub use command_line::{CommandLine, LineHistory};
pub use curves::{RunCurves, RunEntry, RunOrigin, RunStatus};
pub use document::Document;
pub use document_content::DocumentContent;
pub use document_kind::DocumentKind;
pub use jobs::{JobLine, JobNumber, JobPurpose, JobRequest, JobState, Jobs, QueuedRequest};
pub use line::LineView;
pub use overlay::{Overlay, PromptPurpose, Question};
pub use parameter_editor::{Editing, KeptRange, ParameterEditor};
pub use reading::{FileOfText, Reading};
pub use ropeway::RopewayView;
pub use run_list::{RunColumn, RunList};
pub use runs_view::{Charted, RunsView};
pub use section::SectionView;
pub use ship::ShipView;
pub use system::SystemView;
pub use variants::{CaseVariant, VariantPlan, VariedRuns};

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;

use self::modes::ModesView;
use self::sweeps::SweepsView;
use super::bindings::KeyTable;
use super::msg::Msg;
use super::pane::PaneId;
use super::screen_memory::ScreenMemory;
use super::terminal::capabilities::Capabilities;
use super::theme::Palette;
use super::tutorial::Tutorial;
pub use status::{Severity, StatusMessage};

/// The whole state of the workbench.
#[derive(Debug, Clone)]
pub struct AppState {
    /// Columns and rows of the terminal.
    pub size: (u16, u16),
    /// Glyphs and colour.
    pub capabilities: Capabilities,
    /// The keys that the user binds.
    pub keys: Arc<KeyTable>,
    /// The list of cases.
    pub cases: CaseList,
    /// The document that is open.
    pub document: Option<Document>,
    /// Trials of hard cases, over whatever else is open.
    pub trials: Option<trials::Trials>,
    /// Jobs that run, wait or have ended.
    pub jobs: Jobs,
    /// What lies over the screen and takes the keys.
    pub overlay: Option<Overlay>,
    /// The latest message.
    pub note: Option<StatusMessage>,
    /// All messages, oldest first.
    pub log: Vec<StatusMessage>,
    /// True after a Ctrl-C: the next one quits.
    pub interrupted: bool,
    /// Keys and pastes that wait for the answer to an edit before them.
    pub held: VecDeque<Msg>,
    /// How many checks of edits were asked for.
    pub checks: u64,
    /// The file or directory that is watched for changes by other programs.
    pub watched: Option<PathBuf>,
    /// Lines of commands of before.
    pub history: LineHistory,
    /// The theme that the user chose on the screen.
    pub theme: Option<Palette>,
    /// The tutorial, while it runs.
    pub tutorial: Option<Tutorial>,
    /// The step at which it was left.
    pub tutorial_left: Option<usize>,
    /// What the screen of an earlier session showed, until its file is open.
    pub earlier: Option<Box<ScreenMemory>>,
}

impl AppState {
    /// An empty workbench.
    #[must_use]
    pub fn new(size: (u16, u16), capabilities: Capabilities) -> Self {
        Self {
            size,
            capabilities,
            keys: Arc::default(),
            cases: CaseList::default(),
            document: None,
            trials: None,
            jobs: Jobs::default(),
            overlay: None,
            note: None,
            log: Vec::new(),
            interrupted: false,
            held: VecDeque::new(),
            checks: 0,
            watched: None,
            history: LineHistory::default(),
            theme: None,
            tutorial: None,
            tutorial_left: None,
            earlier: None,
        }
    }

    /// Where the keys go.
    #[must_use]
    pub fn focus(&self) -> PaneId {
        if self.trials.as_ref().is_some_and(|t| t.shown) {
            return PaneId::Trials;
        }
        let document = self.document.as_ref();
        document.map_or(PaneId::Cases, |document| document.pane)
    }

    /// The line case that is open.
    #[must_use]
    pub fn line(&self) -> Option<&LineView> {
        self.document.as_ref()?.line()
    }

    /// The line case that is open, to be changed.
    pub fn line_mut(&mut self) -> Option<&mut LineView> {
        self.document.as_mut()?.line_mut()
    }

    /// The natural modes of what is open.
    #[must_use]
    pub fn modes(&self) -> Option<&ModesView> {
        self.document.as_ref()?.content.modes()
    }

    /// The same, to be changed.
    pub fn modes_mut(&mut self) -> Option<&mut ModesView> {
        self.document.as_mut()?.content.modes_mut()
    }

    /// The runs of what is open.
    #[must_use]
    pub fn runs_view(&self) -> Option<&RunsView> {
        self.document.as_ref()?.runs_view()
    }

    /// The sweeps of what is open, to be changed.
    pub fn sweeps_mut(&mut self) -> Option<&mut SweepsView> {
        self.document.as_mut()?.sweeps_mut()
    }

    /// The runs of what is open, to be changed.
    pub fn runs_view_mut(&mut self) -> Option<&mut RunsView> {
        self.document.as_mut()?.runs_view_mut()
    }

    /// What the charts of what is open are drawn from.
    #[must_use]
    pub fn charted(&self) -> Option<Charted<'_>> {
        self.document.as_ref()?.charted()
    }

    /// The panes of what is open, in the order of their numbers.
    #[must_use]
    pub fn panes(&self) -> &'static [PaneId] {
        let document = self.document.as_ref();
        document.map_or(&[], |document| document.kind().info().panes)
    }

    /// The key of a pane of what is open.
    #[must_use]
    pub fn number_of(&self, pane: PaneId) -> usize {
        let place = self.panes().iter().position(|other| *other == pane);
        place.map_or(0, |place| place + 1)
    }

    /// The text and fields of what is open.
    #[must_use]
    pub fn editor(&self) -> Option<&ParameterEditor> {
        self.document.as_ref().map(|document| &document.editor)
    }

    /// The text and fields of what is open, to be changed.
    pub fn editor_mut(&mut self) -> Option<&mut ParameterEditor> {
        self.document.as_mut().map(|document| &mut document.editor)
    }

    /// The filter of the list that has the focus, its cursor, and how many lines pass; nothing where no list has it.
    pub fn filter_mut(&mut self) -> Option<(&mut Filter, &mut usize, usize)> {
        let focus = self.focus();
        let rows = self.focused_table().map(|table| {
            let pane = self.table_pane();
            pane.map_or(0, |pane| pane.count(&table))
        });
        if let Some(rows) = rows {
            let pane = self.table_pane_mut()?;
            return Some((&mut pane.filter, &mut pane.selected, rows));
        }
        match focus {
            PaneId::Cases => {
                let lines = self.cases.shown().len();
                Some((&mut self.cases.filter, &mut self.cases.cursor, lines))
            }
            PaneId::Jobs => {
                let lines = self.jobs.shown().len();
                Some((&mut self.jobs.filter, &mut self.jobs.cursor, lines))
            }
            _ => self.document.as_mut()?.filter_mut(),
        }
    }

    /// Closes what is open, and stops what it computes in the background.
    pub fn close(&mut self) {
        if let Some(document) = &mut self.document {
            document.content.kind_mut().stop();
        }
        self.document = None;
    }

    /// A text with the names of commands in it, such as `` `:undo` ``, replaced by the keys that the user has for them.
    #[must_use]
    pub fn worded(&self, text: &str) -> String {
        self.keys.worded(self.focus(), text).into_owned()
    }

    /// Says something and keeps it in the log. A command is named in it as `` `:undo` ``, and shown by its key.
    pub fn say(&mut self, level: Severity, text: impl Into<String>) {
        let note = StatusMessage {
            level,
            text: self.worded(&text.into()),
        };
        self.log.push(note.clone());
        self.note = Some(note);
    }
}
