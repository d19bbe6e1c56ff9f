//! A file open in the parameter editor: its text, its fields, and the edits that can be undone.

use std::path::PathBuf;

use tui_input::Input;

use super::case_list::Filter;
use crate::tui::facade::FieldRow;

/// What follows a save that was asked for on the way out.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum AfterSave {
    /// Nothing.
    #[default]
    Stay,
    /// The case is left.
    Close,
    /// The program is left.
    Quit,
}

/// A value being typed.
#[derive(Debug, Clone)]
pub struct Editing {
    /// Key path of the field.
    pub path: String,
    /// What is typed.
    pub input: Input,
    /// Why what was typed is refused.
    pub problem: Option<String>,
}

/// A file open in the parameter editor.
#[derive(Debug, Clone)]
pub struct ParameterEditor {
    /// Where its file is.
    pub path: PathBuf,
    /// Name of the file.
    pub file: String,
    /// Text of the file as read or saved last.
    pub saved: String,
    /// The text now.
    pub text: String,
    /// The fields of the editor.
    pub rows: Vec<FieldRow>,
    /// Texts before each edit, oldest first.
    pub undo: Vec<String>,
    /// Texts undone, to be redone.
    pub redo: Vec<String>,
    /// What follows the next save.
    pub after_save: AfterSave,
    /// Cursor among the fields that pass the filter.
    pub field: usize,
    /// Filter of the fields.
    pub filter: Filter,
    /// A value being typed.
    pub editing: Option<Editing>,
}

impl ParameterEditor {
    /// A file as read, with its fields still to be listed.
    #[must_use]
    pub fn new(path: PathBuf, text: String) -> Self {
        let file = path.file_name().map_or_else(
            || "case.toml".to_owned(),
            |name| name.to_string_lossy().into_owned(),
        );
        Self {
            path,
            file,
            saved: text.clone(),
            text,
            rows: Vec::new(),
            undo: Vec::new(),
            redo: Vec::new(),
            after_save: AfterSave::Stay,
            field: 0,
            filter: Filter::default(),
            editing: None,
        }
    }

    /// The name of the file without its ending.
    #[must_use]
    pub fn stem(&self) -> &str {
        self.file.trim_end_matches(".toml")
    }

    /// True when the text differs from the file.
    #[must_use]
    pub fn unsaved(&self) -> bool {
        self.text != self.saved
    }

    /// The fields that pass the filter.
    pub fn fields(&self) -> impl Iterator<Item = &FieldRow> {
        let filter = self.filter.input.value().to_lowercase();
        let shown = self.rows.iter().filter(|row| row.is_shown());
        shown.filter(move |row| {
            super::case_list::passes(
                &format!("{} {} {}", row.path, row.group, row.label),
                &filter,
            )
        })
    }

    /// The field under the cursor.
    #[must_use]
    pub fn current_field(&self) -> Option<&FieldRow> {
        self.fields().nth(self.field)
    }
}
