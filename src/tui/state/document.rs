//! The document that is open: its text and edits, the result of its text, and what its panes show. What
//! differs between the kinds of file is behind [`DocumentKind`].

use std::path::Path;

use super::document_kind::DocumentKind;
use super::line::LineView;
use super::parameter_editor::ParameterEditor;
use super::ropeway::RopewayView;
use super::section::SectionView;
use super::ship::ShipView;
use super::system::SystemView;
use crate::case::{self, Diagnostic, kind};
use crate::kinds::FileType;
use crate::report::chart::Chart;
use crate::report::table::Table;
use crate::ropeway::Ropeway;
use crate::section::CrossSection;
use crate::ship::Ship;
use crate::system::SystemFile;
use crate::tui::pane::PaneId;
use crate::tui::table_pane::TablePane;

/// The kinds of file, with the result of the text.
#[derive(Debug, Clone)]
pub enum DocumentContent {
    /// A line case.
    Line(Box<LineView>),
    /// A cross-section.
    Section(Box<SectionView>),
    /// A ropeway.
    Ropeway(Box<RopewayView>),
    /// A ship.
    Ship(Box<ShipView>),
    /// A system of lines.
    System(Box<SystemView>),
}

impl DocumentContent {
    /// The text of a file and its content, by the kind of the file.
    ///
    /// # Errors
    /// Everything that is wrong with the file.
    pub fn read(path: &Path) -> Result<(String, Self), Vec<Diagnostic>> {
        Ok(match FileType::of(path) {
            FileType::Line => {
                let file = case::load(path)?;
                (file.text, Self::Line(Box::new(LineView::new(file.case))))
            }
            FileType::Section => {
                let file = kind::load::<CrossSection>(path)?;
                let view = SectionView::new(file.computed);
                (file.text, Self::Section(Box::new(view)))
            }
            FileType::Ropeway => {
                let file = kind::load::<Ropeway>(path)?;
                let view = RopewayView::new(file.computed);
                (file.text, Self::Ropeway(Box::new(view)))
            }
            FileType::Ship => {
                let file = kind::load::<Ship>(path)?;
                let view = ShipView::new(file.computed);
                (file.text, Self::Ship(Box::new(view)))
            }
            FileType::System => {
                let file = kind::load::<SystemFile>(path)?;
                let view = SystemView::new(file.computed);
                (file.text, Self::System(Box::new(view)))
            }
        })
    }

    /// What the screen needs of it.
    #[must_use]
    pub fn kind(&self) -> &dyn DocumentKind {
        match self {
            Self::Line(line) => line.as_ref(),
            Self::Section(section) => section.as_ref(),
            Self::Ropeway(ropeway) => ropeway.as_ref(),
            Self::Ship(ship) => ship.as_ref(),
            Self::System(system) => system.as_ref(),
        }
    }

    /// The same, to be changed.
    pub fn kind_mut(&mut self) -> &mut dyn DocumentKind {
        match self {
            Self::Line(line) => line.as_mut(),
            Self::Section(section) => section.as_mut(),
            Self::Ropeway(ropeway) => ropeway.as_mut(),
            Self::Ship(ship) => ship.as_mut(),
            Self::System(system) => system.as_mut(),
        }
    }
}

/// The document that is open.
#[derive(Debug, Clone)]
pub struct Document {
    /// Its text, fields and edits.
    pub editor: ParameterEditor,
    /// The result of its text.
    pub content: DocumentContent,
    /// The pane that has the focus.
    pub pane: PaneId,
    /// True while the pane with the focus has the whole screen where it would share it.
    pub zoomed: bool,
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
    pub fn new(editor: ParameterEditor, content: DocumentContent) -> Self {
        let kind = content.kind().info();
        Self {
            pane: kind.first,
            zoomed: false,
            tab: 0,
            tables: vec![TablePane::default(); kind.tabs.len()],
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
            DocumentContent::Line(line) => Some(line),
            _ => None,
        }
    }

    /// The line case, to be changed.
    pub fn line_mut(&mut self) -> Option<&mut LineView> {
        match &mut self.content {
            DocumentContent::Line(line) => Some(line),
            _ => None,
        }
    }

    /// The line case, to be changed, and its text.
    pub fn line_and_editor(&mut self) -> Option<(&mut LineView, &ParameterEditor)> {
        match &mut self.content {
            DocumentContent::Line(line) => Some((line, &self.editor)),
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
        let kind = self.content.kind();
        self.editor.list_fields(|text| kind.rows(text));
        self.content.kind_mut().validate(&self.editor);
        Ok(())
    }
}
