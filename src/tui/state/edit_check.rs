//! Edits applied to a text, and the text read with them: away from the drawing thread.

use super::pending::{Change, PendingEdit};
use super::reading::{Draft, FileOfText, Reading};
use crate::facade;
use crate::kinds::FileType;

/// Edits to be applied to a text.
#[derive(Debug, Clone)]
pub struct EditCheck {
    /// Its number; an answer to one that is not waited for any more is dropped.
    pub number: u64,
    /// The file of the text.
    pub file: FileOfText,
    /// The text.
    pub text: String,
    /// The edits, one after the other.
    pub edits: Vec<PendingEdit>,
}

/// The text with the edits, as read, or as a draft where it is to be kept although it is not complete.
pub type EditedReading = Result<Box<Reading>, Box<Draft>>;

/// What became of edits.
#[derive(Debug, Clone)]
pub struct EditAnswer {
    /// The number of the check.
    pub number: u64,
    /// The edits that are accepted, by their place among those asked for, each with the text after it.
    pub accepted: Vec<(usize, String)>,
    /// The last of these texts as read; absent where no edit is accepted.
    pub read: Option<EditedReading>,
    /// The last edit that is refused, by its place, and why.
    pub refused: Option<(usize, String)>,
}

impl EditAnswer {
    /// The answer of a check that failed by a fault of the program.
    #[must_use]
    pub fn of_fault(number: u64) -> Self {
        Self {
            number,
            accepted: Vec::new(),
            read: None,
            refused: Some((0, "The check failed by a fault of seacable.".to_owned())),
        }
    }
}

impl EditCheck {
    /// Applies the edits, and reads the text with all of them. Where the file with them is refused, the last edits are given up
    /// until it is not.
    #[must_use]
    pub fn answer(self) -> EditAnswer {
        let mut accepted: Vec<(usize, String)> = Vec::new();
        let mut refused = None;
        for (i, edit) in self.edits.iter().enumerate() {
            let before = accepted.last().map_or(&self.text, |(_, text)| text);
            match self.apply(&edit.change, before) {
                Ok(text) => accepted.push((i, text)),
                Err(why) => refused = Some((i, why)),
            }
        }
        let mut read = None;
        while let Some((i, text)) = accepted.pop() {
            let before = accepted.last().map_or(&self.text, |(_, text)| text);
            match self.read(&self.edits[i], before, &text) {
                Ok(found) => {
                    accepted.push((i, text));
                    read = Some(found);
                    break;
                }
                Err(why) => refused = Some((i, why)),
            }
        }
        EditAnswer {
            number: self.number,
            accepted,
            read,
            refused,
        }
    }

    /// A text with a change; key and value are checked, the file with them is not.
    fn apply(&self, change: &Change, text: &str) -> Result<String, String> {
        match change {
            Change::Set(key, value) => facade::put(self.file.kind, text, key, value),
            Change::Unset(key) => facade::unset(text, key),
            Change::Structure(edit) => facade::restructure(self.file.kind, text, edit),
            Change::Text(text) => Ok(text.clone()),
            Change::Reread => Ok(text.to_owned()),
        }
    }

    /// Reads a text with an edit, or returns why the edit is refused. A line case that was faulty before may stay so.
    fn read(&self, edit: &PendingEdit, before: &str, text: &str) -> Result<EditedReading, String> {
        let all = match Reading::new(&self.file, text.to_owned()) {
            Ok(read) => return Ok(Ok(Box::new(read))),
            Err(all) => all,
        };
        let draft = || Box::new(Draft::new(self.file.kind, text, &all));
        match (&edit.change, self.file.kind) {
            (Change::Set(key, value), FileType::Line) => {
                facade::set(before, key, value).map(|_| Err(draft()))
            }
            (Change::Set(..), _) if self.was_draft(before) => Ok(Err(draft())),
            (Change::Set(key, _), _) => Err(facade::refusal(key, &all)),
            _ => Ok(Err(draft())),
        }
    }

    /// Whether a text was not complete before an edit.
    fn was_draft(&self, before: &str) -> bool {
        Reading::new(&self.file, before.to_owned()).is_err()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::case::shipped::SHIPPED;
    use crate::state::ParameterEditor;

    const KEY: &str = "current.speed_m_per_s";

    fn check(values: &[&str]) -> EditAnswer {
        let (path, text) = SHIPPED
            .iter()
            .find(|(path, _)| path.ends_with("pendulous/manifold.toml"))
            .unwrap();
        let change = |value: &&str| Change::Set(KEY.to_owned(), (*value).to_owned());
        let edits = values.iter().map(change).map(PendingEdit::command);
        let file = FileOfText {
            kind: FileType::Line,
            path: path.into(),
            name: ParameterEditor::name_of(path.as_ref()),
            saved: (*text).to_owned(),
            saved_rows: None,
            before: None,
            files: BTreeMap::new(),
        };
        let text = (*text).to_owned();
        let edits = edits.collect();
        EditCheck {
            number: 1,
            file,
            text,
            edits,
        }
        .answer()
    }

    #[test]
    fn every_step_is_there_and_the_last_is_read() {
        let answer = check(&["0.46", "0.47", "0.48"]);
        assert!(answer.refused.is_none());
        let places: Vec<usize> = answer.accepted.iter().map(|(i, _)| *i).collect();
        assert_eq!(places, [0, 1, 2]);
        let read = answer.read.unwrap().unwrap();
        assert_eq!(read.text, answer.accepted[2].1);
        let row = read.rows.iter().find(|row| row.path == KEY).unwrap();
        assert_eq!(row.value, "0.48");
    }

    #[test]
    fn a_refused_value_leaves_those_before_it() {
        let answer = check(&["0.46", "99"]);
        assert_eq!(answer.accepted.len(), 1);
        let (at, why) = answer.refused.unwrap();
        assert!(at == 1 && why.contains("speed_m_per_s"), "{why}");
        assert!(answer.read.unwrap().unwrap().text.contains("= 0.46"));
    }
}
