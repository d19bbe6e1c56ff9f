//! The document that is open: its text and edits, the result of its text, and what its panes show. Everything that
//! differs between the kinds of file is behind [`DocumentKind`].

use std::path::PathBuf;

use super::line::LineView;
use super::parameter_editor::ParameterEditor;
use super::ropeway::RopewayView;
use super::section::SectionView;
use super::ship::ShipView;
use crate::case::Diagnostic;
use crate::reference::ValidationRow;
use crate::report::chart::{Chart, Glyphs};
use crate::report::table::Table;
use crate::tui::command::{Command, Id, MODEL};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;
use crate::tui::table_pane::TablePane;

/// What the screen needs of a kind of file. A `source` gives path and name of the file of a text.
pub trait DocumentKind {
    /// Name of the kind, or for a line case its solver, for the first line of the screen.
    fn word(&self) -> String;

    /// The title of this file.
    fn title(&self) -> &str;

    /// Its panes, in the order of their numbers.
    fn panes(&self) -> &'static [PaneId];

    /// The pane that has the focus at first.
    fn first_pane(&self) -> PaneId {
        self.panes().get(1).copied().unwrap_or(PaneId::Inputs)
    }

    /// The names of the tabs of its tables pane.
    fn tabs(&self) -> &'static [&'static str] {
        &[]
    }

    /// A tab: its chart, where it has one, and its table.
    fn tab(&self, _tab: usize) -> (Option<Chart>, Table) {
        (None, Table::default())
    }

    /// The fields of a text of this kind; none where it is invalid.
    fn rows(&self, text: &str, source: &ParameterEditor) -> Vec<FieldRow>;

    /// A text of this kind with one key set.
    ///
    /// # Errors
    /// What is wrong with that value, and what would be right.
    fn set(&self, text: &str, key: &str, value: &str) -> Result<String, String>;

    /// A text of this kind without an optional key; nothing where keys of this kind cannot be left out.
    ///
    /// # Errors
    /// Why the key cannot be left out.
    fn unset(&self, _text: &str, _key: &str) -> Option<Result<String, String>> {
        None
    }

    /// Replaces the result by that of the text of the editor.
    ///
    /// # Errors
    /// All that is wrong; the result is then unchanged.
    fn read(&mut self, source: &ParameterEditor) -> Result<(), Vec<Diagnostic>>;

    /// Updates the validation table.
    fn validate(&mut self, _source: &ParameterEditor) {}

    /// The validation table.
    fn checks(&self) -> &[ValidationRow] {
        &[]
    }

    /// What it computes in the background, in a few words.
    fn busy(&self) -> Option<&'static str> {
        None
    }

    /// Stops what it computes in the background.
    fn stop(&mut self) {}

    /// End of the file name of its report, and the name of the report in a message.
    fn report_name(&self) -> (&'static str, &'static str) {
        ("report", "The report")
    }

    /// The text report; absent where there is no result.
    fn report(&self, _text: &str, _glyphs: Glyphs) -> Option<String> {
        None
    }

    /// Its own commands, whatever pane has the focus.
    fn commands(&self) -> &'static [Command] {
        MODEL
    }

    /// Why one of them cannot be done now.
    fn reason(&self, id: Id) -> Option<&'static str> {
        (id == Id::Copy && self.copy().is_none())
            .then_some("Only the material of a cross-section is copied; `M` writes it to a file.")
    }

    /// The text for the clipboard.
    fn copy(&self) -> Option<String> {
        None
    }

    /// Input for a line case: the name of a file beside `stem`, its text, and what it is.
    fn line_input(&self, _stem: &str) -> (PathBuf, Option<String>, &'static str) {
        (PathBuf::new(), None, "")
    }
}

/// The kinds of file, with the result of the text.
#[derive(Debug, Clone)]
pub enum Content {
    /// A line case.
    Line(Box<LineView>),
    /// A cross-section.
    Section(Box<SectionView>),
    /// A ropeway.
    Ropeway(Box<RopewayView>),
    /// A ship.
    Ship(Box<ShipView>),
}

impl Content {
    /// What the screen needs of it.
    #[must_use]
    pub fn kind(&self) -> &dyn DocumentKind {
        match self {
            Self::Line(line) => line.as_ref(),
            Self::Section(section) => section.as_ref(),
            Self::Ropeway(ropeway) => ropeway.as_ref(),
            Self::Ship(ship) => ship.as_ref(),
        }
    }

    /// The same, to be changed.
    pub fn kind_mut(&mut self) -> &mut dyn DocumentKind {
        match self {
            Self::Line(line) => line.as_mut(),
            Self::Section(section) => section.as_mut(),
            Self::Ropeway(ropeway) => ropeway.as_mut(),
            Self::Ship(ship) => ship.as_mut(),
        }
    }
}

/// The document that is open.
#[derive(Debug, Clone)]
pub struct Document {
    /// Its text, fields and edits.
    pub editor: ParameterEditor,
    /// The result of its text.
    pub content: Content,
    /// The pane that has the focus.
    pub pane: PaneId,
    /// The tab of the tables that is shown.
    pub tab: usize,
    /// Selection, sorting and scrolling of each tab.
    pub tables: Vec<TablePane>,
    /// Selection, sorting and scrolling of the validation table.
    pub checks_pane: TablePane,
}

impl Document {
    /// A file as read, with its fields still to be listed.
    #[must_use]
    pub fn new(editor: ParameterEditor, content: Content) -> Self {
        let kind = content.kind();
        Self {
            pane: kind.first_pane(),
            tab: 0,
            tables: vec![TablePane::default(); kind.tabs().len()],
            checks_pane: TablePane::default(),
            editor,
            content,
        }
    }

    /// What the screen needs of its kind.
    #[must_use]
    pub fn kind(&self) -> &dyn DocumentKind {
        self.content.kind()
    }

    /// The line case, where it is one.
    #[must_use]
    pub fn line(&self) -> Option<&LineView> {
        match &self.content {
            Content::Line(line) => Some(line),
            _ => None,
        }
    }

    /// The line case, to be changed.
    pub fn line_mut(&mut self) -> Option<&mut LineView> {
        match &mut self.content {
            Content::Line(line) => Some(line),
            _ => None,
        }
    }

    /// The line case, to be changed, and its text.
    pub fn line_and_editor(&mut self) -> Option<(&mut LineView, &ParameterEditor)> {
        match &mut self.content {
            Content::Line(line) => Some((line, &self.editor)),
            _ => None,
        }
    }

    /// The tab shown: its chart, where it has one, and its table.
    #[must_use]
    pub fn shown(&self) -> (Option<Chart>, Table) {
        self.kind().tab(self.tab)
    }

    /// Reads fields, result and validation from the text again.
    ///
    /// # Errors
    /// All that is wrong; everything is then unchanged.
    pub fn refresh(&mut self) -> Result<(), Vec<Diagnostic>> {
        self.content.kind_mut().read(&self.editor)?;
        self.editor.rows = self.kind().rows(&self.editor.text, &self.editor);
        self.content.kind_mut().validate(&self.editor);
        Ok(())
    }
}

/// A table of a title alone, in the place of one that there is no result for.
#[must_use]
pub fn message_table(words: &str) -> Table {
    Table {
        title: words.to_owned(),
        ..Table::default()
    }
}
