//! The arguments of comparisons and of studies of one case.

use std::path::PathBuf;

use super::args::{CaseArgs, TableArgs};

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
pub(super) struct EffectsArgs {
    #[command(flatten)]
    pub(super) case: CaseArgs,

    /// A result to look at, by its name in the summary of a run, such as tension_n.max; may be repeated. By default the main ones.
    #[arg(long, value_name = "NAME")]
    pub(super) result: Vec<String>,

    #[command(flatten)]
    pub(super) page: StudyPageArgs,
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
