//! From a section file to a design.

use std::path::Path;

use super::design::{Design, design};
use super::model::{SECTION, Section};
use crate::case::fields::Schema;
use crate::case::kind::{self, FileKind};
use crate::case::{Diagnostic, InvalidValue, Node};
use crate::case::{FieldRow, Lister};

/// A design with the text and the file it came from.
pub type Loaded = crate::case::Opened<Design>;

/// The section file as a kind.
pub(crate) enum SectionFile {}

impl FileKind for SectionFile {
    type Words = Section;
    type Worked = Design;

    fn schema() -> &'static Schema {
        &SECTION
    }

    fn work(words: Section, _tree: &Node) -> Result<Design, Vec<InvalidValue>> {
        design(&words)
    }

    fn list(lister: &Lister<'_>) -> Vec<FieldRow> {
        super::edit::list(lister)
    }
}

/// Whether a file is a section rather than a line case; the two may share a folder.
#[must_use]
pub(crate) fn is_section(path: &Path) -> bool {
    kind::begins::<SectionFile>(path, &[])
}

/// Reads, checks and works out a section file.
///
/// # Errors
///
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary
/// or empty, faults of the TOML syntax, every fault of keys and values, or everything that cannot
/// lie as the section says.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    kind::load::<SectionFile>(path)
}

/// Checks the text of a section and works it out. `file` is the name the diagnostics carry.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Design, Vec<Diagnostic>> {
    kind::parse::<SectionFile>(text, file)
}
