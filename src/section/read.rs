//! From a section file to a design.

use std::path::{Path, PathBuf};

use super::design::{Design, design};
use super::fields::SECTION;
use super::model::Section;
use crate::case::{self, Diagnostic, Finding};

/// A design with the text and the file it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The text of the file.
    pub text: String,
    /// The design.
    pub design: Design,
    /// The file.
    pub path: PathBuf,
}

/// Whether a file is a section rather than a line case; the two may share a folder.
#[must_use]
pub fn is_section(path: &Path) -> bool {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    text.lines()
        .any(|line| line.trim_start().starts_with("[section]"))
}

/// Reads, checks and works out a section file.
///
/// # Errors
///
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary
/// or empty, faults of the TOML syntax, every fault of keys and values, or everything that cannot
/// lie as the section says.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    let text = case::text_of(path, &SECTION).map_err(|diagnostic| vec![diagnostic])?;
    let design = parse(&text, &path.display().to_string())?;
    Ok(Loaded {
        text,
        design,
        path: path.to_owned(),
    })
}

/// Checks the text of a section and works it out. `file` is the name the diagnostics carry.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Design, Vec<Diagnostic>> {
    let tree = case::said(text, file, &SECTION)?;
    let mut found = case::check_keys(&SECTION, &tree);
    if !found.is_empty() {
        found.sort_by_key(|finding| finding.span.start);
        return Err(case::diagnose(found, text, file));
    }
    let section: Section =
        case::words_of(text).map_err(|finding| case::diagnose(vec![finding], text, file))?;
    design(&section).map_err(|misfits| {
        let placed = misfits.iter().map(|misfit| misfit.found(&tree));
        let mut found: Vec<Finding> = placed.collect();
        found.sort_by_key(|finding| finding.span.start);
        case::diagnose(found, text, file)
    })
}
