//! From a ship file to a ship with all that follows from it.

use std::path::{Path, PathBuf};

use super::check::misfits;
use super::fields::SHIP;
use super::model::Ship;
use super::rest::Rest;
use super::rope::RopeAtSea;
use crate::case::{self, Diagnostic, Finding};

/// A ship with the text and the file it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The text of the file.
    pub text: String,
    /// The ship at rest.
    pub rest: Rest,
    /// The rope while the ship moves, or why it cannot be followed; absent where the file names none.
    pub rope: Option<Result<RopeAtSea, String>>,
    /// The file.
    pub path: PathBuf,
}

/// Whether a file is a ship rather than a line case; the two may share a folder. A ropeway has a ship too, and is none.
#[must_use]
pub fn is_ship(path: &Path) -> bool {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let has = |header: &str| {
        text.lines()
            .any(|line| line.trim_start().starts_with(header))
    };
    has("[ship]") && !has("[ropeway]")
}

/// Reads, checks and works out a ship file.
///
/// # Errors
///
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary or empty, faults of the
/// TOML syntax, every fault of keys and values, or everything that cannot be as the file says.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    read(text_of(path)?, path)
}

/// The text of a ship file.
///
/// # Errors
///
/// That there is no such file, or none that is text.
pub fn text_of(path: &Path) -> Result<String, Vec<Diagnostic>> {
    case::text_of(path, &SHIP).map_err(|diagnostic| vec![diagnostic])
}

/// The same for a text that stands for a file's, as when its keys were set.
///
/// # Errors
///
/// As [`load`].
pub fn read(text: String, path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    let rest = parse(&text, &path.display().to_string())?;
    let rope = followed(&rest, path);
    Ok(Loaded {
        text,
        rest,
        rope,
        path: path.to_owned(),
    })
}

/// The rope that the file names, at the ship as it moves.
fn followed(rest: &Rest, path: &Path) -> Option<Result<RopeAtSea, String>> {
    let rope = rest.ship.rope.as_ref()?;
    let motion = rest.ship.motion.as_ref()?;
    let voyage = rest.voyage.as_ref()?.as_ref().ok()?;
    let folder = path.parent().unwrap_or(Path::new(""));
    Some(RopeAtSea::new(rope, motion, voyage, folder))
}

/// Checks the text of a ship and works it out. `file` is the name the diagnostics carry.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Rest, Vec<Diagnostic>> {
    let tree = case::said(text, file, &SHIP)?;
    let mut found = case::check_keys(&SHIP, &tree);
    if !found.is_empty() {
        found.sort_by_key(|finding| finding.span.start);
        return Err(case::diagnose(found, text, file));
    }
    let ship: Ship =
        case::words_of(text).map_err(|finding| case::diagnose(vec![finding], text, file))?;
    let wrong = misfits(&ship, &tree);
    if wrong.is_empty() {
        return Ok(Rest::new(ship));
    }
    let mut found: Vec<Finding> = wrong.iter().map(|misfit| misfit.found(&tree)).collect();
    found.sort_by_key(|finding| finding.span.start);
    Err(case::diagnose(found, text, file))
}
