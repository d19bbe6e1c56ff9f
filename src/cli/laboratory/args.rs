//! The arguments of the laboratory.

use std::path::PathBuf;

use clap::Subcommand;

use crate::common_args::{HardArgs, StudyPageArgs, TableArgs, count};

#[derive(Debug, Subcommand)]
pub(crate) enum LaboratoryArgs {
    /// Solve random systems of lines at rest, nearly singular ones among them: each solved exactly, or refused with a reason.
    ///
    /// The exit status is 1 if one is solved with a residual above rounding.
    Systems(SystemsArgs),
    /// Measure how often intervals of extremes hold the truth, and how often a verdict over seeds is false.
    ///
    /// Samples are drawn from Gumbel's and Weibull's law, and the default intervals made of each. Takes a minute.
    Intervals(IntervalsArgs),
    /// Hold every estimated error against the true one, from a converged run: cases by every method at two tolerances.
    ///
    /// The converged run has a mesh three times as fine and a time error ten times as small. Takes some minutes for all cases.
    Bars(BarsArgs),
    /// Hold an accuracy asked against the true one, and its cost against the cheapest setting that is as accurate.
    ///
    /// The truth is a run on twice the mesh found, with a time error four times as small. Takes some minutes for all cases.
    Accuracy(AccuracyArgs),
}

// `--show` prints the files of the systems that are written as files.
#[derive(Debug, clap::Args)]
#[command(group(clap::ArgGroup::new("written").args(["in_motion", "invariants"]).multiple(true)))]
pub(crate) struct SystemsArgs {
    /// Number of systems.
    #[arg(long, value_name = "N", default_value = "10000", value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(crate) count: u32,

    /// The same seed, the same systems.
    #[arg(long, default_value = "1")]
    pub(crate) seed: u64,

    /// Let other systems move for some seconds: by harmonics and tables, let go, broken, lowered.
    #[arg(long)]
    pub(crate) in_motion: bool,

    /// Hold systems of all kinds of input against themselves: lines reversed, all renamed and reordered, turned, mirrored, moved, a line
    /// divided, twice the segments, steps half as long.
    #[arg(long)]
    pub(crate) invariants: bool,

    /// Of these, the system of this number alone, counted from 0.
    #[arg(long, value_name = "NUMBER", requires = "invariants")]
    pub(crate) only: Option<u32>,

    /// Write the files of each system that answers otherwise into this folder: as it is, and as it was asked for.
    #[arg(long, value_name = "FOLDER", requires = "invariants")]
    pub(crate) write: Option<PathBuf>,

    /// Hold the errors stated of other systems, with divided lines, against so many times the segments.
    #[arg(long, value_name = "TIMES", conflicts_with_all = ["in_motion", "show", "invariants"], value_parser = clap::value_parser!(u32).range(2..=64))]
    pub(crate) refined: Option<u32>,

    /// Print the file of the system of this number, counted from 0.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "written",
        conflicts_with_all = ["json", "only", "write"]
    )]
    pub(crate) show: Option<usize>,

    /// List every system that is refused, with its number.
    #[arg(long)]
    pub(crate) list: bool,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(crate) ascii: bool,

    /// Print one JSON object.
    #[arg(long, conflicts_with_all = ["ascii", "list"])]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct BarsArgs {
    #[command(flatten)]
    pub(crate) cases: HardArgs,

    /// Take so many variants of each case in its place, with other meshes, periods, sizes and masses, drawn at random.
    #[arg(long, value_name = "N", value_parser = count)]
    pub(crate) varied: Option<usize>,

    /// Of the random numbers: the same seed, the same variants.
    #[arg(long, value_name = "SEED", default_value_t = 1, requires = "varied")]
    pub(crate) seed: u64,

    /// A row for every result, in the place of one for every setting.
    #[arg(long)]
    pub(crate) results: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct AccuracyArgs {
    /// Case files, or directories of them; by default those that come with the program.
    #[arg(value_name = "CASE")]
    pub(crate) cases: Vec<PathBuf>,

    /// Accuracies asked, as shares of what each result is a part of.
    #[arg(long, value_name = "SHARE", value_delimiter = ',', default_values_t = [1e-2, 1e-3])]
    pub(crate) accuracy: Vec<f64>,

    /// Wall time that each search may take: 10s, 2min.
    #[arg(long, value_name = "TIME", value_parser = crate::duration::seconds, default_value = "10s")]
    pub(crate) budget: f64,

    #[command(flatten)]
    pub(crate) table: TableArgs,
}

#[derive(Debug, clap::Args)]
pub(crate) struct IntervalsArgs {
    /// Samples drawn of each law and size, and streams of seeds of each rule.
    #[arg(long, value_name = "N", default_value = "2000", value_parser = clap::value_parser!(u32).range(10..=1_000_000))]
    pub(crate) draws: u32,

    /// Seed of the samples.
    #[arg(long, value_name = "N", default_value = "1")]
    pub(crate) seed: u64,

    /// Values of a sample; may be repeated. By default 5, 10, 20, 30, 50 and 100.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=10_000))]
    pub(crate) values: Vec<u16>,

    #[command(flatten)]
    pub(crate) page: StudyPageArgs,
}
