//! From a ship file to a ship at rest.

use std::collections::BTreeMap;
use std::path::Path;

use super::check::misfits;
use super::fields::SHIP;
use super::model::Ship;
use super::static_analysis::StaticAnalysis;
use crate::case::fields::{FieldRow, Lister, Schema};
use crate::case::kind::{self, FileKind};
use crate::case::{Diagnostic, Mark, Misfit, Node, Opened};

/// A ship at rest with the text and the file it came from.
pub type Loaded = Opened<StaticAnalysis>;

/// The ship file as a kind.
pub(crate) enum ShipFile {}

impl FileKind for ShipFile {
    type Words = Ship;
    type Worked = StaticAnalysis;

    fn schema() -> &'static Schema {
        &SHIP
    }

    fn work(settings: Ship, tree: &Node) -> Result<StaticAnalysis, Vec<Misfit>> {
        let wrong = misfits(&settings, tree);
        if wrong.is_empty() {
            Ok(StaticAnalysis::new(settings))
        } else {
            Err(wrong)
        }
    }

    fn marks(settings: &Ship) -> BTreeMap<String, Mark> {
        settings.marks.clone()
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

/// Reads, checks and works out a ship file, at rest: what takes its time is [`DynamicAnalysis`](super::DynamicAnalysis)'s.
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
pub fn parse(text: &str, file: &str) -> Result<StaticAnalysis, Vec<Diagnostic>> {
    kind::parse::<ShipFile>(text, file)
}
