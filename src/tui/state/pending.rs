//! Edits that are asked for and not yet checked. One check is under way at a time; edits asked for meanwhile are checked
//! together after it, so that the newest value is there soon however long a check takes.

use crate::case::structure::StructureEdit;

/// A change of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Change {
    /// A key set to a value as typed.
    Set(String, String),
    /// An optional key left out.
    Unset(String),
    /// Tables added, removed, renamed, put in order.
    Structure(Box<StructureEdit>),
    /// A whole text in its place.
    Text(String),
    /// No change: the text is read again.
    Reread,
}

/// Where an edit comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditSource {
    /// Typed into its field, which stays open until the value is accepted.
    Typed,
    /// Filled into a form, which stays open until it is accepted.
    Form,
    /// A command: a step, a solver, a reset, another text.
    Command,
    /// The last edit undone.
    Undo,
    /// The edit undone last.
    Redo,
    /// The text that an earlier session left.
    Recovered,
}

/// An edit that is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PendingEdit {
    /// What it changes.
    pub change: Change,
    /// Where it comes from.
    pub source: EditSource,
    /// What is said once it is accepted.
    pub said: Option<String>,
}

impl PendingEdit {
    /// A change by a command.
    #[must_use]
    pub const fn command(change: Change) -> Self {
        Self {
            change,
            source: EditSource::Command,
            said: None,
        }
    }

    /// The key that it sets, and its value.
    fn set(&self) -> Option<(&str, &str)> {
        match &self.change {
            Change::Set(path, value) => Some((path, value)),
            _ => None,
        }
    }
}

/// The edits of a text that are asked for and not yet checked.
#[derive(Debug, Clone, Default)]
pub struct PendingEdits {
    /// Those that are being checked, and the number of that check.
    checking: Option<(u64, Vec<PendingEdit>)>,
    /// Those that wait for it.
    waiting: Vec<PendingEdit>,
}

impl PendingEdits {
    /// Whether all edits are checked.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.checking.is_none() && self.waiting.is_empty()
    }

    /// Adds an edit.
    pub fn push(&mut self, edit: PendingEdit) {
        self.waiting.push(edit);
    }

    /// Begins the check of this number, of all edits that wait; nothing where none does, or another check is under way.
    pub fn begin(&mut self, number: u64) -> Option<Vec<PendingEdit>> {
        if self.checking.is_some() || self.waiting.is_empty() {
            return None;
        }
        let edits = std::mem::take(&mut self.waiting);
        self.checking = Some((number, edits.clone()));
        Some(edits)
    }

    /// Ends the check of this number, and returns its edits; nothing where another one is under way.
    pub fn end(&mut self, number: u64) -> Option<Vec<PendingEdit>> {
        let checking = self.checking.take_if(|(known, _)| *known == number);
        checking.map(|(_, edits)| edits)
    }

    /// The newest value that a key is to have.
    #[must_use]
    pub fn value(&self, path: &str) -> Option<&str> {
        let checking = self.checking.iter().flat_map(|(_, edits)| edits);
        let mut newest = checking.chain(&self.waiting).rev();
        newest.find_map(|edit| edit.set().filter(|(key, _)| *key == path).map(|set| set.1))
    }
}
