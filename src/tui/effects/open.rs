//! Opening a file.

use std::path::Path;

use crate::import::case_path;
use crate::msg::{FileRead, Msg};
use crate::state::reading::read_file;
use crate::{case_library, recovery};

/// A file, with what an earlier session left of it.
pub(super) fn read_case(path: &Path) -> Msg {
    match read_file(path) {
        Ok((text, content)) => {
            // The case of a file of another program is saved beside it, never onto it.
            let path = &case_path(path);
            recovery::tidy(path);
            let recovered = recovery::find(path, &text);
            let read = FileRead::new(path.to_owned(), text, content, recovered);
            Msg::FileRead(Box::new(read))
        }
        Err(all) => Msg::CaseRejected(path.to_owned(), case_library::story(&all)),
    }
}
