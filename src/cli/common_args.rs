//! The arguments that commands share.

use std::path::PathBuf;

use super::import::ImportArgs;

// Doc comments of these types would replace the help of the commands.

#[derive(Debug, Clone, clap::Args)]
pub(super) struct CaseArgs {
    /// The case file.
    #[arg(value_name = "CASE")]
    pub(super) file: PathBuf,

    /// Set a key on top of the file, for example solver.duration_s=60 or ends.b.position_m.x=850; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) set: Vec<String>,

    #[command(flatten)]
    pub(super) import: ImportArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct TableArgs {
    /// Write the table as CSV to this file as well.
    #[arg(short, long = "output", value_name = "TABLE.csv")]
    pub(super) output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub(super) force: bool,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,

    /// Print one JSON object: the rows of the table, keys by the heads of its columns.
    #[arg(long, conflicts_with = "ascii")]
    pub(super) json: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct HardArgs {
    /// Cases and systems with trials, or directories of them; by default those that come with the program.
    #[arg(value_name = "CASE")]
    pub(super) cases: Vec<PathBuf>,

    #[command(flatten)]
    pub(super) table: TableArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct StudyPageArgs {
    /// Print CSV with every digit instead of tables and charts.
    #[arg(long, conflicts_with = "json")]
    pub(super) csv: bool,

    /// Columns of the page; by default those of the terminal, 80 at least.
    #[arg(long, value_name = "COLUMNS", value_parser = width)]
    pub(super) width: Option<usize>,

    #[command(flatten)]
    pub(super) table: TableArgs,
}

/// A number of modes.
pub(super) fn count(word: &str) -> Result<usize, String> {
    match word.parse::<usize>() {
        Ok(value) if (1..=1000).contains(&value) => Ok(value),
        _ => Err("give a whole number from 1 to 1000".to_owned()),
    }
}

/// Columns of a page.
fn width(word: &str) -> Result<usize, String> {
    match word.parse::<usize>() {
        Ok(value) if (40..=1000).contains(&value) => Ok(value),
        _ => Err("give a whole number from 40 to 1000".to_owned()),
    }
}
