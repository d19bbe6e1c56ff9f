//! The arguments of `seacable sweep`.

use std::path::PathBuf;

use super::common_args::StudyPageArgs;
use super::import::ImportArgs;
use super::slurm_args::SlurmArgs;

#[derive(Debug, clap::Args)]
pub(super) struct SweepArgs {
    /// The case or the system of lines.
    #[arg(value_name = "CASE", required_unless_present = "resume")]
    pub(super) case: Option<PathBuf>,

    /// Go on with a sweep that was stopped or killed: load cases whose runs are done are not computed again.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["case", "set", "vary", "load_cases", "result", "out"])]
    pub(super) resume: Option<PathBuf>,

    /// Set a key on top of the file, for example solver.duration_s=60; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) set: Vec<String>,

    /// Draw the seeds of each sea, of those in the table, only until its checks are settled; the key statistics.until_settled.
    #[arg(long, conflicts_with = "resume")]
    pub(super) until_settled: bool,

    /// Compute load cases again whose verdict by a check lies within their numerical error, in up to so many rounds, each on twice the segments and in half the steps; the key statistics.finer_runs.
    #[arg(long, value_name = "ROUNDS", num_args = 0..=1, default_missing_value = "3", conflicts_with = "resume", value_parser = clap::value_parser!(u8).range(1..=6))]
    pub(super) finer_runs: Option<u8>,

    /// Find for each sea of the table the greatest of these values at which all checks pass, such as waves.height_m=1..9/33.
    #[arg(long, value_name = "KEY=VALUES", conflicts_with = "resume")]
    pub(super) window: Option<String>,

    /// Look at each sea in the frequency domain instead, linear about the mean position: some 200 times cheaper.
    #[arg(long, conflicts_with_all = ["resume", "until_settled", "finer_runs", "window", "slurm", "part"])]
    pub(super) quick: bool,

    /// With --quick: run so many of the seas in time as well, and state how far the looks are from them.
    #[arg(long, value_name = "N", requires = "quick")]
    pub(super) sampled: Option<u8>,

    /// Write the tables in the folder as Apache Parquet files as well; of programs built with the feature `parquet`.
    #[arg(long, conflicts_with_all = ["quick", "no_store", "window", "part"])]
    pub(super) parquet: bool,

    #[command(flatten)]
    pub(super) import: ImportArgs,

    /// Further load cases: a CSV file with a column for each key path, and probability or occurrences where known; may be repeated.
    #[arg(long, value_name = "FILE.csv")]
    pub(super) load_cases: Vec<PathBuf>,

    /// Further load cases: a key and its values, such as waves.height_m=2..8/4; may be repeated.
    #[arg(long, value_name = "KEY=VALUES")]
    pub(super) vary: Vec<String>,

    /// A result to show, by its name in the summary of a run, such as tension_n.max; may be repeated. By default the main results.
    #[arg(long, value_name = "NAME")]
    pub(super) result: Vec<String>,

    /// Load cases computed at a time; by default one for each core. With --slurm the cores of a task, by default one.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=4096))]
    pub(super) jobs: Option<u16>,

    /// Folder of the sweep, which must not exist yet; by default runs/CASE-sweep-TIME. Runs are stored beside it.
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,

    /// Store nothing, neither the folder nor runs; a file with checks is refused, which are read from stored runs.
    #[arg(long, conflicts_with_all = ["resume", "out", "window", "until_settled", "slurm", "part"])]
    pub(super) no_store: bool,

    #[command(flatten)]
    pub(super) slurm: SlurmArgs,

    #[command(flatten)]
    pub(super) page: StudyPageArgs,
}

impl SweepArgs {
    /// Keys that are set on top of the file.
    pub(super) fn overrides(&self) -> Vec<String> {
        let settled = self
            .until_settled
            .then_some("statistics.until_settled=true".to_owned());
        let finer = self.finer_runs;
        let finer = finer.map(|rounds| format!("statistics.finer_runs={rounds}"));
        let own = self.set.iter().cloned();
        own.chain(settled).chain(finer).collect()
    }
}
