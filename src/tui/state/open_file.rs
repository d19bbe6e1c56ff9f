//! A file other than a line case that is open: its text and edits, what it comes to, and what its panes show. What a kind of
//! file is to the screen stands in [`FileView`]; everything else is the same for all of them.

use std::path::PathBuf;

use super::parameter_editor::ParameterEditor;
use super::ropeway::RopewayView;
use super::section::SectionView;
use super::ship::ShipView;
use crate::case::Diagnostic;
use crate::reference::ValidationRow;
use crate::report::chart::{Chart, Glyphs};
use crate::report::table::Table;
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;
use crate::tui::table_pane::TablePane;

/// What the screen asks of a kind of file.
pub trait FileView {
    /// What a file of this kind is called.
    fn word(&self) -> &'static str;

    /// The title of this one.
    fn title(&self) -> &str;

    /// Its panes, in the order of their numbers: inputs, drawing, tables, and validation where it has one.
    fn panes(&self) -> &'static [PaneId];

    /// The names of the tabs of its tables pane.
    fn tabs(&self) -> &'static [&'static str];

    /// A tab: its chart, where it has one, and its table.
    fn tab(&self, tab: usize) -> (Option<Chart>, Table);

    /// The fields of a text of this kind.
    fn rows(&self, text: &str) -> Vec<FieldRow>;

    /// A text of this kind with one key set.
    ///
    /// # Errors
    /// All that cannot be with that value.
    fn set(&self, text: &str, key: &str, value: &str) -> Result<String, Vec<Diagnostic>>;

    /// Whether a text passes as one of this kind.
    ///
    /// # Errors
    /// All that is wrong.
    fn passes(&self, text: &str, file: &str) -> Result<(), Vec<Diagnostic>>;

    /// Takes over what a text comes to.
    ///
    /// # Errors
    /// All that is wrong; it is then as it was.
    fn take(&mut self, text: &str, file: &str) -> Result<(), Vec<Diagnostic>>;

    /// The validation table.
    fn checks(&self, _text: &str) -> Vec<ValidationRow> {
        Vec::new()
    }

    /// What it is doing in the background, in a few words.
    fn busy(&self) -> Option<&'static str> {
        None
    }

    /// What its report is called: behind the name of the file, and in a message.
    fn paper(&self) -> (&'static str, &'static str) {
        ("report", "The report")
    }

    /// The text report; absent where there is no answer.
    fn report(&self, text: &str, glyphs: Glyphs) -> Option<String>;

    /// What a line case takes over from it: the name of a file beside `stem`, its text, and what it is.
    fn hand_over(&self, stem: &str) -> (PathBuf, Option<String>, &'static str);
}

/// The kinds of file, with what they come to.
#[derive(Debug, Clone)]
pub enum Content {
    /// A cross-section.
    Section(Box<SectionView>),
    /// A ropeway.
    Ropeway(Box<RopewayView>),
    /// A ship.
    Ship(Box<ShipView>),
}

impl Content {
    /// What the screen asks of it.
    #[must_use]
    pub fn view(&self) -> &dyn FileView {
        match self {
            Self::Section(section) => section.as_ref(),
            Self::Ropeway(ropeway) => ropeway.as_ref(),
            Self::Ship(ship) => ship.as_ref(),
        }
    }

    /// The same, to be changed.
    pub fn view_mut(&mut self) -> &mut dyn FileView {
        match self {
            Self::Section(section) => section.as_mut(),
            Self::Ropeway(ropeway) => ropeway.as_mut(),
            Self::Ship(ship) => ship.as_mut(),
        }
    }
}

/// A file other than a line case that is open.
#[derive(Debug, Clone)]
pub struct OpenFile {
    /// Its text and fields.
    pub editor: ParameterEditor,
    /// What it comes to.
    pub content: Content,
    /// Where the keys go.
    pub pane: PaneId,
    /// The tab of the tables shown.
    pub tab: usize,
    /// Selection, sorting and scrolling of each tab.
    pub panes: Vec<TablePane>,
    /// The validation table.
    pub checks: Vec<ValidationRow>,
    /// Selection, sorting and scrolling of it.
    pub checks_pane: TablePane,
}

impl OpenFile {
    /// A file as read, with its fields still to be listed.
    #[must_use]
    pub fn new(editor: ParameterEditor, content: Content) -> Self {
        let view = content.view();
        let pane = match content {
            Content::Section(_) => PaneId::Keys,
            _ => view.panes().get(1).copied().unwrap_or(PaneId::Keys),
        };
        Self {
            pane,
            tab: 0,
            panes: vec![TablePane::default(); view.tabs().len()],
            checks: Vec::new(),
            checks_pane: TablePane::default(),
            editor,
            content,
        }
    }

    /// The tab shown: its chart, where it has one, and its table.
    #[must_use]
    pub fn shown(&self) -> (Option<Chart>, Table) {
        self.content.view().tab(self.tab)
    }

    /// Reads fields, meaning and validation from the text again.
    ///
    /// # Errors
    /// All that is wrong; everything is then as it was.
    pub fn refresh(&mut self) -> Result<(), Vec<Diagnostic>> {
        let text = self.editor.text.clone();
        self.content.view_mut().take(&text, &self.editor.file)?;
        let view = self.content.view();
        self.editor.rows = view.rows(&text);
        self.checks = view.checks(&text);
        Ok(())
    }
}

/// A table that only says something.
#[must_use]
pub fn message_table(words: &str) -> Table {
    Table {
        title: words.to_owned(),
        ..Table::default()
    }
}
