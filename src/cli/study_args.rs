//! The arguments of comparisons.

use std::path::PathBuf;

use super::args::TableArgs;

#[derive(Debug, clap::Args)]
pub(super) struct CompareArgs {
    /// The run directories, two or more; differences are from the first.
    #[arg(value_name = "RUN_DIR", required = true)]
    pub(super) runs: Vec<PathBuf>,

    #[command(flatten)]
    pub(super) page: StudyPageArgs,
}

/// Columns of a page.
fn width(word: &str) -> Result<usize, String> {
    match word.parse::<usize>() {
        Ok(value) if (40..=1000).contains(&value) => Ok(value),
        _ => Err("give a whole number from 40 to 1000".to_owned()),
    }
}

#[derive(Debug, clap::Args)]
pub(super) struct StudyPageArgs {
    /// Print CSV with every digit instead of tables and charts.
    #[arg(long)]
    pub(super) csv: bool,

    /// Columns of the page; by default those of the terminal, 80 at least.
    #[arg(long, value_name = "COLUMNS", value_parser = width)]
    pub(super) width: Option<usize>,

    #[command(flatten)]
    pub(super) table: TableArgs,
}
