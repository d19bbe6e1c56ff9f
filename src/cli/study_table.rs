//! The table of a study: on the page, as JSON, and as CSV in a file.

use std::io;

use super::{
    CommandError,
    common_args::TableArgs,
    output::{self, FileFormat, OutputFile},
};
use seacable_display::table::Table;
use seacable_report::run_json as study_json;

/// Columns of the page.
pub(super) const WIDTH: usize = 160;

/// Prints a table and what stands below it, or its rows as JSON.
pub(super) fn print(
    table: &Table,
    below: &str,
    study: &str,
    args: &TableArgs,
) -> Result<(), CommandError> {
    if args.json {
        return output::object(&study_json::study(study, table));
    }
    let text = format!("{}{below}", table.to_text(WIDTH));
    output::results(&text, args.ascii)
}

/// Writes a table to a file, where one is asked for.
pub(super) fn write_csv(table: &Table, file: Option<&OutputFile<'_>>) -> Result<(), CommandError> {
    let Some(file) = file else { return Ok(()) };
    let mut text = Vec::new();
    let written = table.write_csv(&mut text).map_err(io::Error::other);
    written.map_err(CommandError::Output)?;
    file.write(&text, FileFormat::Text)
}
