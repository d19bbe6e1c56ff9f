//! What the inputs were before the user's edits.

use super::field_rows::rows;
use crate::facade::FieldRow;
use crate::{
    case::{
        Origin,
        edited::{self, EditedKey},
        judging_rows::is_judging,
        shipped,
    },
    kinds::FileType,
};

/// The inputs of a file as it was opened, or as it is shipped: edits are told by them, also once they are saved.
#[derive(Debug, Clone)]
pub struct InputsBefore {
    /// The text that states them.
    pub(super) text: String,
    /// Its fields.
    pub(super) rows: Vec<FieldRow>,
    /// Whether its file comes with the program.
    pub(super) shipped: bool,
    /// Whether what carries no mark there is printed in its source.
    pub(super) sourced: bool,
}

impl InputsBefore {
    /// The inputs of a file with this text.
    #[must_use]
    pub fn new(kind: FileType, opened: &str) -> Self {
        let shipped = shipped::of_title(opened);
        let text = shipped.unwrap_or(opened);
        Self {
            text: text.to_owned(),
            rows: rows(kind, text),
            shipped: shipped.is_some(),
            sourced: edited::is_sourced(text),
        }
    }

    /// Which of these fields are the user's, where the file now has this text.
    #[must_use]
    pub fn edited(&self, rows: &[FieldRow], saved: &str) -> Vec<EditedKey> {
        let origin = match self.shipped {
            true => Origin::Shipped,
            false if saved == self.text => Origin::File,
            false => Origin::Opened,
        };
        // What runs are held to is the user's anyway, and changes no run.
        let inputs = |rows: &[FieldRow]| {
            let inputs = rows.iter().filter(|row| !is_judging(&row.path));
            inputs.cloned().collect::<Vec<_>>()
        };
        edited::edited(&inputs(rows), &inputs(&self.rows), origin, self.sourced)
    }
}
