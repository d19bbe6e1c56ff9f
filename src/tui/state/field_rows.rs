//! The fields of a text, by its kind of file.

use crate::facade::FieldRow;
use crate::{
    case::{Case, file_kind::FileKind, judging_rows::judging_rows, kind},
    kinds::FileType,
    ropeway::Ropeway,
    section::CrossSection,
    ship::Ship,
    system::SystemFile,
};

/// The fields of a text; none where it is not TOML.
#[must_use]
pub(super) fn rows(kind: FileType, text: &str) -> Vec<FieldRow> {
    match kind {
        FileType::Line => with_judging::<Case>(text),
        FileType::Section => kind::rows::<CrossSection>(text),
        FileType::Ropeway => kind::rows::<Ropeway>(text),
        FileType::Ship => kind::rows::<Ship>(text),
        FileType::System => with_judging::<SystemFile>(text),
    }
}

/// The inputs of a text, then what is asked of its runs together.
fn with_judging<K: FileKind>(text: &str) -> Vec<FieldRow> {
    let mut rows = kind::rows::<K>(text);
    rows.extend(judging_rows::<K>(text));
    rows
}
