//! The document that is open: its text and edits, the result of its text, and what its panes show. What
//! differs between the kinds of file is behind [`DocumentKind`].

use std::path::PathBuf;

use super::case_list::Filter;
use super::document_content::DocumentContent;
use super::document_kind::DocumentKind;
use super::line::LineView;
use super::modes::ModesView;
use super::parameter_editor::ParameterEditor;
use super::part_request::PartRequest;
use super::parts::{PartKey, PartOf, Parts, ScreenPart};
use super::reading::{Draft, FileOfText, Reading};
use super::runs_view::{Charted, RunsView};
use super::study_of::RunningStudy;
use super::sweeps::SweepsView;
use crate::pane::PaneId;
use crate::table_pane::TablePane;

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
    /// Cursor among all results.
    pub result: usize,
    /// A study of one of them that computes.
    pub study: Option<RunningStudy>,
    /// What takes more than drawing.
    pub parts: Parts,
}

impl Document {
    /// A file as read.
    #[must_use]
    pub fn new(path: PathBuf, read: Reading) -> Self {
        let mut editor = ParameterEditor::new(path, read.text);
        editor.rows = read.rows;
        editor.model.renew(read.outline);
        editor.saved_rows = Some(read.saved_rows);
        editor.before = Some(read.before);
        editor.edited = read.edited;
        let content = read.content;
        let kind = content.kind().info();
        Self {
            pane: kind.first,
            zoomed: false,
            tab: 0,
            tables: vec![TablePane::default(); kind.tabs.len()],
            checks_pane: TablePane::default(),
            result: 0,
            study: None,
            parts: Parts::default(),
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

    /// Its runs, where it has any.
    #[must_use]
    pub fn runs_view(&self) -> Option<&RunsView> {
        match &self.content {
            DocumentContent::Line(line) => Some(&line.runs_view),
            DocumentContent::System(system) if system.has_runs() => Some(&system.runs_view),
            _ => None,
        }
    }

    /// Its runs, to be changed.
    pub fn runs_view_mut(&mut self) -> Option<&mut RunsView> {
        self.content.runs_view_mut()
    }

    /// The sweeps of its load cases, where its kind has any.
    #[must_use]
    pub const fn sweeps(&self) -> Option<&SweepsView> {
        self.content.sweeps()
    }

    /// The same, to be changed.
    pub const fn sweeps_mut(&mut self) -> Option<&mut SweepsView> {
        self.content.sweeps_mut()
    }

    /// Its runs, to be changed, and its text.
    pub fn runs_and_editor(&mut self) -> Option<(&mut RunsView, &ParameterEditor)> {
        Some((self.content.runs_view_mut()?, &self.editor))
    }

    /// What its charts are drawn from.
    #[must_use]
    pub fn charted(&self) -> Option<Charted<'_>> {
        match &self.content {
            DocumentContent::Line(line) => Some(Charted {
                view: &line.runs_view,
                case: Some(&line.case),
                checks: &line.checks.rows,
            }),
            _ => self.runs_view().map(|view| Charted {
                view,
                case: None,
                checks: &[],
            }),
        }
    }

    /// Its natural modes, to be changed, and its text.
    pub fn modes_and_editor(&mut self) -> Option<(&mut ModesView, &ParameterEditor)> {
        Some((self.content.modes_mut()?, &self.editor))
    }

    /// The line case, to be changed, and its text.
    pub fn line_and_editor(&mut self) -> Option<(&mut LineView, &ParameterEditor)> {
        match &mut self.content {
            DocumentContent::Line(line) => Some((line, &self.editor)),
            _ => None,
        }
    }

    /// The filter of the list that its pane shows, fields, runs or load cases; its cursor; and how many lines pass.
    pub fn filter_mut(&mut self) -> Option<(&mut Filter, &mut usize, usize)> {
        match self.pane {
            PaneId::Inputs => {
                let editor = &mut self.editor;
                let lines = editor.fields().count();
                Some((&mut editor.filter, &mut editor.field, lines))
            }
            PaneId::Runs => {
                let runs = &mut self.content.runs_view_mut()?.runs;
                let lines = runs.lines();
                Some((&mut runs.filter, &mut runs.cursor, lines))
            }
            PaneId::Model => {
                let model = &mut self.editor.model;
                let lines = model.shown().len();
                Some((&mut model.filter, &mut model.cursor, lines))
            }
            PaneId::Sweep => self.content.sweeps_mut()?.filter_mut(),
            _ => None,
        }
    }

    /// What a part of the screen is of now; nothing where there is no such part.
    #[must_use]
    pub fn part_key(&self, part: ScreenPart) -> Option<PartKey> {
        let of = match (&self.content, part) {
            (DocumentContent::Line(line), ScreenPart::Line(_)) => {
                let (name, run, _) = line.runs_view.reported()?;
                PartOf::Run(name, run)
            }
            (DocumentContent::Line(_), _) | (_, ScreenPart::Line(_)) => return None,
            _ => self.parts.of_inputs(self.kind().choice(part)),
        };
        Some(PartKey { part, of })
    }

    /// Whether a part is shown as it is now.
    #[must_use]
    pub fn is_shown(&self, part: ScreenPart) -> bool {
        let key = self.part_key(part);
        key.is_none_or(|key| self.parts.is_known(&key))
    }

    /// The request for a part that is not known as it is now, and is not being worked out.
    pub fn ask_part(&mut self, part: ScreenPart) -> Option<PartRequest> {
        let key = self.part_key(part)?;
        let begun = self.parts.begin(&key);
        let model = matches!(key.of, PartOf::Inputs(..)).then(|| self.content.clone());
        begun.then_some(PartRequest { key, model })
    }

    /// The file of its text.
    #[must_use]
    pub fn file(&self) -> FileOfText {
        let editor = &self.editor;
        FileOfText {
            kind: self.content.file_type(),
            path: editor.path.clone(),
            name: editor.file.clone(),
            saved: editor.saved.clone(),
            saved_rows: editor.saved_rows.clone(),
            before: editor.before.clone(),
            files: self.content.files(),
        }
    }

    /// Takes a newer text with all that was read from it.
    pub fn take(&mut self, read: Reading) {
        self.content.renew(read.content);
        let info = self.kind().info();
        if !info.panes.contains(&self.pane) && self.pane != PaneId::Model {
            self.pane = info.first;
        }
        self.parts.outdate();
        self.editor.draft = None;
        self.editor.text = read.text;
        self.editor.rows = read.rows;
        self.editor.model.renew(read.outline);
        self.editor.saved_rows = Some(read.saved_rows);
        self.editor.before = Some(read.before);
        self.editor.edited = read.edited;
        self.outdate_checks();
    }

    /// Takes what can be read of a text that is not complete; all that is computed of it stays as it was.
    pub fn take_draft(&mut self, draft: Draft) {
        self.editor.rows = draft.rows;
        self.editor.model.renew(draft.outline);
        self.editor.draft = Some(draft.fault);
    }

    /// The validation table of a line case is older than its runs or its text.
    pub fn outdate_checks(&mut self) {
        if let Some(line) = self.line_mut() {
            line.checking.is_due = true;
        }
    }
}
