//! A file open in the parameter editor: its text, its fields, and the edits that can be undone.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use tui_input::Input;

use super::case_list::Filter;
use super::inputs_before::InputsBefore;
use super::model_list::ModelList;
use super::pending::PendingEdits;
use super::reading::SavedRows;
use crate::facade::FieldRow;
use crate::fuzzy::{FuzzyFilter, Looking};
use seacable_model::case::edited::EditedKey;
use seacable_model::case::judging_rows::is_judging;

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

/// A range of a field that waits for a range in a further field, to a grid.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeptRange {
    /// Key path of the field.
    pub path: String,
    /// The values as typed: `0.2..0.8/4`.
    pub values: String,
}

impl KeptRange {
    /// Reads `KEY=VALUES`.
    #[must_use]
    pub fn read(word: &str) -> Option<Self> {
        let (path, values) = word.split_once('=')?;
        Some(Self {
            path: path.trim().to_owned(),
            values: values.trim().to_owned(),
        })
    }

    /// `KEY=VALUES`.
    #[must_use]
    pub fn word(&self) -> String {
        format!("{}={}", self.path, self.values)
    }
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
    /// The text of a save that is not answered yet.
    pub saving: Option<String>,
    /// The text now.
    pub text: String,
    /// The fields of the editor.
    pub rows: Vec<FieldRow>,
    /// The fields of the file as it is on disk; absent until the text is read.
    pub saved_rows: Option<Arc<SavedRows>>,
    /// What the inputs were before the user's edits; absent until the text is read.
    pub before: Option<Arc<InputsBefore>>,
    /// The inputs that are the user's.
    pub edited: Vec<EditedKey>,
    /// Texts before each edit, oldest first.
    pub undo: Vec<String>,
    /// Texts undone, to be redone.
    pub redo: Vec<String>,
    /// What follows the next save.
    pub after_save: AfterSave,
    /// Whether only the fields are shown that the file gives.
    pub folded: bool,
    /// Cursor among the fields that pass the filter.
    pub field: usize,
    /// Filter of the fields.
    pub filter: Filter,
    /// A value being typed.
    pub editing: Option<Editing>,
    /// Ranges that wait for one in a further field.
    pub kept: Vec<KeptRange>,
    /// Edits that are not checked yet.
    pub pending: PendingEdits,
    /// What the file is made of.
    pub model: ModelList,
    /// What the text still lacks, as full sentences, where it is not complete: what is shown of it is older then.
    pub draft: Option<String>,
}

/// What a filter is looked for in.
fn parts(row: &FieldRow) -> [&str; 3] {
    [&row.path, &row.group, &row.label]
}

impl ParameterEditor {
    /// The name of a file.
    #[must_use]
    pub fn name_of(path: &Path) -> String {
        path.file_name().map_or_else(
            || "case.toml".to_owned(),
            |name| name.to_string_lossy().into_owned(),
        )
    }

    /// A file as read, with its fields still to be listed.
    #[must_use]
    pub fn new(path: PathBuf, text: String) -> Self {
        Self {
            file: Self::name_of(&path),
            path,
            saved: text.clone(),
            text,
            rows: Vec::new(),
            saved_rows: None,
            before: None,
            edited: Vec::new(),
            undo: Vec::new(),
            redo: Vec::new(),
            saving: None,
            after_save: AfterSave::Stay,
            folded: false,
            field: 0,
            filter: Filter::default(),
            editing: None,
            kept: Vec::new(),
            pending: PendingEdits::default(),
            model: ModelList::default(),
            draft: None,
        }
    }

    /// The name of the file without its ending.
    #[must_use]
    pub fn stem(&self) -> &str {
        self.file.trim_end_matches(".toml")
    }

    /// The value of a field, with the edits that are not checked yet.
    #[must_use]
    pub fn value<'a>(&'a self, row: &'a FieldRow) -> &'a str {
        self.pending.value(&row.path).unwrap_or(&row.value)
    }

    /// A field of the file as it is on disk.
    #[must_use]
    pub fn saved_field(&self, path: &str) -> Option<&FieldRow> {
        let saved = self.saved_rows.as_ref()?;
        saved.rows.iter().find(|row| row.path == path)
    }

    /// The inputs in which these fields differ from the file, as `key=value`.
    #[must_use]
    pub fn overrides(&self, rows: &[FieldRow]) -> Vec<String> {
        let differs = |row: &&FieldRow| {
            let saved = self.saved_field(&row.path);
            saved.is_none_or(|saved| saved.value != row.value)
        };
        let words = |row: &FieldRow| format!("{}={}", row.path, row.value);
        let inputs = rows.iter().filter(|row| !is_judging(&row.path));
        inputs.filter(differs).map(words).collect()
    }

    /// True when the text differs from the file.
    #[must_use]
    pub fn unsaved(&self) -> bool {
        self.text != self.saved
    }

    /// The fields that pass the filter.
    pub fn fields(&self) -> impl Iterator<Item = &FieldRow> {
        let filter = FuzzyFilter::new(self.filter.input.value());
        // Who looks for a field finds it.
        let folded = self.folded && filter.is_empty();
        let shown = self
            .rows
            .iter()
            .filter(move |row| row.is_shown() && (!folded || row.given || row.replaced.is_some()));
        let has_words = |row: &FieldRow| filter.passes(&parts(row), Looking::Words);
        let looking = match filter.is_empty() || shown.clone().any(has_words) {
            true => Looking::Words,
            false => Looking::Letters,
        };
        shown.filter(move |row| filter.is_empty() || filter.passes(&parts(row), looking))
    }

    /// How many fields are folded, and how many of all fields are marked as assumed.
    #[must_use]
    pub fn folded_away(&self) -> (usize, usize) {
        let shown = self.rows.iter().filter(|row| row.is_shown()).count();
        let assumed = |row: &&FieldRow| {
            row.standing
                .as_ref()
                .is_some_and(|mark| mark.status.name() == "assumed")
        };
        (
            shown - self.fields().count().min(shown),
            self.rows.iter().filter(assumed).count(),
        )
    }

    /// The range of a field that waits for one in a further field, as typed.
    #[must_use]
    pub fn kept_range(&self, path: &str) -> Option<&str> {
        let kept = self.kept.iter().find(|kept| kept.path == path)?;
        Some(&kept.values)
    }

    /// The field under the cursor.
    #[must_use]
    pub fn current_field(&self) -> Option<&FieldRow> {
        self.fields().nth(self.field)
    }
}
