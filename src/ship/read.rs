//! From a ship file to a ship at rest.

use std::collections::BTreeMap;
use std::path::Path;

use super::check::misfits;
use super::fields::SHIP;
use super::model::Ship;
use super::rest::Rest;
use crate::case::fields::{FieldRow, Lister, Schema};
use crate::case::kind::{self, FileKind};
use crate::case::{Diagnostic, Mark, Misfit, Node, Opened};

/// A ship at rest with the text and the file it came from.
pub type Loaded = Opened<Rest>;

/// The ship file as a kind.
pub(crate) enum ShipFile {}

impl FileKind for ShipFile {
    type Words = Ship;
    type Worked = Rest;

    fn schema() -> &'static Schema {
        &SHIP
    }

    fn work(words: Ship, tree: &Node) -> Result<Rest, Vec<Misfit>> {
        let wrong = misfits(&words, tree);
        if wrong.is_empty() {
            Ok(Rest::new(words))
        } else {
            Err(wrong)
        }
    }

    fn marks(words: &Ship) -> BTreeMap<String, Mark> {
        words.marks.clone()
    }

    fn list(lister: &Lister<'_>) -> Vec<FieldRow> {
        super::edit::list(lister)
    }
}

/// Whether a file is a ship rather than a line case; the two may share a folder. A ropeway has a ship too, and is none.
#[must_use]
pub(crate) fn is_ship(path: &Path) -> bool {
    kind::begins::<ShipFile>(path, &["ropeway"])
}

/// Reads, checks and works out a ship file, at rest: what takes its time is [`AtSea`](super::AtSea)'s.
///
/// # Errors
///
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary or empty, faults of the
/// TOML syntax, every fault of keys and values, or everything that cannot be as the file says.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    kind::load::<ShipFile>(path)
}

/// Checks the text of a ship and works it out, at rest. `file` is the name the diagnostics carry.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Rest, Vec<Diagnostic>> {
    kind::parse::<ShipFile>(text, file)
}
