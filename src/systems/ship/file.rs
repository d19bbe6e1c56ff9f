//! The ship as a kind of file.

use std::sync::LazyLock;

use super::check::check;
use super::model::{Ship, ShipKeys};
use super::static_analysis::StaticAnalysis;
use crate::case::fields::Schema;
use crate::case::file_kind::{FileContent, FileKind};
use crate::case::schema::schema_of;
use crate::case::{FieldLister, FieldRow, Finding};

/// The ship file.
pub static SHIP: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a ship has at least [ship] with a title, length_m and draft_m, and one of [wind], [current], [drift]";
    schema_of::<Ship>("ship", least).with_parameters()
});

impl FileContent for Ship {
    type Computed = StaticAnalysis;
}

impl FileKind for Ship {
    fn schema() -> &'static Schema {
        &SHIP
    }

    fn check(keys: &ShipKeys<'_>) -> Vec<Finding> {
        check(keys)
    }

    /// The static analysis; the [`DynamicAnalysis`](super::DynamicAnalysis) takes longer.
    fn compute(self, _: &ShipKeys<'_>) -> Result<StaticAnalysis, Finding> {
        Ok(StaticAnalysis::new(self))
    }

    fn list(lister: &FieldLister<'_>) -> Vec<FieldRow> {
        let tables = lister.schema.tables.iter().map(|table| table.path.as_str());
        let listed = tables.filter(|table| !matches!(*table, "ship" | "marks" | "published"));
        let mut rows = lister.always("ship");
        rows.extend(listed.flat_map(|table| lister.if_given(&[table], table)));
        rows
    }
}
