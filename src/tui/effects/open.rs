//! Opening a file.

use std::path::Path;

use crate::tui::msg::{FileRead, Msg};
use crate::tui::state::DocumentContent;
use crate::tui::{case_library, recovery};

/// A file, with what an earlier session left of it.
pub(super) fn read_case(path: &Path) -> Msg {
    match DocumentContent::read(path) {
        Ok((text, content)) => Msg::FileRead(Box::new(FileRead {
            recovered: recovery::find(path).filter(|recovered| *recovered != text),
            path: path.to_owned(),
            text,
            content,
        })),
        Err(all) => Msg::CaseRejected(path.to_owned(), case_library::story(path, &all)),
    }
}
