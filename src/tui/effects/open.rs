//! Opening a file.

use std::path::Path;

use crate::import::case_path_of;
use crate::kinds::FileBytes;
use crate::msg::{FileRead, Msg};
use crate::state::reading::read_bytes;
use crate::{case_library, recovery};

/// A file, with what an earlier session left of it.
pub(super) fn read_case(path: &Path) -> Msg {
    let bytes = FileBytes::read(path);
    // The case of a file of another program is saved beside it, never onto it.
    let saved = case_path_of(&bytes);
    match read_bytes(bytes) {
        Ok((text, content)) => {
            let path = &saved;
            recovery::tidy(path);
            let recovered = recovery::find(path, &text);
            let read = FileRead::new(path.to_owned(), text, content, recovered);
            Msg::FileRead(Box::new(read))
        }
        Err(all) => Msg::CaseRejected(path.to_owned(), case_library::story(&all)),
    }
}
