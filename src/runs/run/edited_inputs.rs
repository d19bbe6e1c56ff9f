//! The inputs of a run that are the user's.

use super::Run;
use crate::case::file_kind::FileKind;
use crate::case::{EditedKey, Origin, edited, kind, shipped};

/// The inputs of a run that are not those of its file: keys that were set on top of it, or the differences from the file of
/// its title that comes with the program.
///
/// A run of another version may be of another edition of that file, so only what was set counts.
pub fn edited_inputs<K: FileKind>(run: &Run) -> Vec<EditedKey> {
    let before =
        shipped::of_title(&run.case_text).filter(|_| run.info.version == env!("CARGO_PKG_VERSION"));
    let rows = kind::rows::<K>(&run.case_text);
    let sourced = edited::is_sourced(&run.case_text);
    if let Some(before) = before {
        let before = kind::rows::<K>(before);
        return edited::edited(&rows, &before, Origin::Shipped, sourced);
    }
    let mut keys = edited::edited(&rows, &rows, Origin::File, sourced);
    for word in &run.info.overrides {
        let set = EditedKey::set(word);
        if keys.iter().all(|key| key.path != set.path) {
            keys.push(set);
        }
    }
    keys
}
