//! The options of every command that lift limits, and say which files may be read.

use std::path::PathBuf;

use seacable_base::limits;

/// Limits on the work that a file may ask for.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Limits")]
pub(super) struct LimitArgs {
    /// Allow more entries of one table or list of tables in a file.
    #[arg(long, global = true, value_name = "N", value_parser = allowed)]
    limit_tables: Option<f64>,

    /// Allow more segments of all lines of a scene.
    #[arg(long, global = true, value_name = "N", value_parser = allowed)]
    limit_segments: Option<f64>,

    /// Allow more time steps of a run.
    #[arg(long, global = true, value_name = "N", value_parser = allowed)]
    limit_steps: Option<f64>,

    /// Allow more rows of a history.
    #[arg(long, global = true, value_name = "N", value_parser = allowed)]
    limit_rows: Option<f64>,

    /// Allow more points of a variation, or load cases.
    #[arg(long, global = true, value_name = "N", value_parser = allowed)]
    limit_points: Option<f64>,

    /// Allow more lines of a table of lines at rest.
    #[arg(long, global = true, value_name = "N", value_parser = allowed)]
    limit_lines: Option<f64>,
}

impl LimitArgs {
    /// Lifts the limits that are given.
    pub(super) fn apply(&self) {
        let given = [
            (&limits::TABLES, self.limit_tables),
            (&limits::SEGMENTS, self.limit_segments),
            (&limits::STEPS, self.limit_steps),
            (&limits::ROWS, self.limit_rows),
            (&limits::POINTS, self.limit_points),
            (&limits::LINES, self.limit_lines),
            (&limits::LINES_IN_CURRENT, self.limit_lines),
        ];
        for (limit, greatest) in given {
            if let Some(greatest) = greatest {
                limit.lift(greatest);
            }
        }
    }
}

/// A count of at least 1, such as 5000 or 1e9.
fn allowed(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    number
        .filter(|number| (1.0..=1e18).contains(number))
        .ok_or_else(|| "give a number from 1 to 1e18".to_owned())
}

/// What every command reads files by.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Limits")]
pub(super) struct ReadingArgs {
    /// Files that a case names must lie below this directory; by default below the directory opened, `cases`, or the case's folder.
    #[arg(long, value_name = "DIR", global = true)]
    pub(super) root: Option<PathBuf>,

    /// Read no file larger than this; by default 67108864 bytes, 1073741824 for files of stored runs.
    #[arg(long, value_name = "BYTES", global = true, value_parser = clap::value_parser!(u64).range(1..))]
    pub(super) limit_file_size: Option<u64>,
}
