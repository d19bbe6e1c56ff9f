//! From a ship file to its static analysis.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use super::check::invalid_values;
use super::model::Ship;
use super::static_analysis::StaticAnalysis;
use crate::case::fields::Schema;
use crate::case::kind::{self, FileKind};
use crate::case::schema::schema_of;
use crate::case::{Diagnostic, InvalidValue, Mark, Node, Opened};
use crate::case::{FieldRow, Lister};

/// The ship file.
pub static SHIP: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a ship has at least [ship] with a title, length_m and draft_m, and one of [wind], [current], [drift]";
    schema_of::<Ship>("ship", least)
});

/// A static analysis with the text and the file it came from.
pub type Loaded = Opened<StaticAnalysis>;

/// The ship file as a kind of file.
pub(crate) enum ShipFile {}

impl FileKind for ShipFile {
    type Words = Ship;
    type Worked = StaticAnalysis;

    fn schema() -> &'static Schema {
        &SHIP
    }

    fn work(ship: Ship, tree: &Node) -> Result<StaticAnalysis, Vec<InvalidValue>> {
        let wrong = invalid_values(&ship, tree);
        if wrong.is_empty() {
            Ok(StaticAnalysis::new(ship))
        } else {
            Err(wrong)
        }
    }

    fn marks(ship: &Ship) -> BTreeMap<String, Mark> {
        ship.marks.clone()
    }

    fn list(lister: &Lister<'_>) -> Vec<FieldRow> {
        let given = lister.schema.tables.iter().filter(|table| {
            let listed = !matches!(&*table.path, "marks" | "published");
            listed && (table.path == "ship" || lister.root.get(&table.path).is_some())
        });
        given
            .flat_map(|table| lister.table(&table.path, &[&table.path], &table.path))
            .collect()
    }
}

/// Whether a file is a ship rather than a line case; the two may share a folder. A ropeway file has `[ship]` too.
#[must_use]
pub(crate) fn is_ship(path: &Path) -> bool {
    kind::begins::<ShipFile>(path, &["ropeway"])
}

/// Reads, checks and statically analyses a ship file; the [`DynamicAnalysis`](super::DynamicAnalysis) takes longer.
///
/// # Errors
///
/// Everything that is wrong, at once: a missing file, a directory, a binary or empty file, TOML syntax, or every invalid key and
/// value.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    kind::load::<ShipFile>(path)
}

/// Checks the text of a ship and analyses it statically. `file` is the name in the diagnostics.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<StaticAnalysis, Vec<Diagnostic>> {
    kind::parse::<ShipFile>(text, file)
}
