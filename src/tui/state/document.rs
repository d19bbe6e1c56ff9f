//! The document that is open: its text and edits, the result of its text, and what its panes show. What
//! differs between the kinds of file is behind [`DocumentKind`].

use super::document_kind::DocumentKind;
use super::line::LineView;
use super::parameter_editor::ParameterEditor;
use super::ropeway::RopewayView;
use super::section::SectionView;
use super::ship::ShipView;
use crate::case::Diagnostic;
use crate::report::chart::Chart;
use crate::report::table::Table;
use crate::tui::pane::PaneId;
use crate::tui::table_pane::TablePane;

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
