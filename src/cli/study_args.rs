//! The arguments of comparisons and of studies of one case.

use std::path::PathBuf;

use clap::Subcommand;

use super::common_args::{CaseArgs, HardArgs, StudyPageArgs, TableArgs, count};
use super::laboratory::args::{AccuracyArgs, BarsArgs, IntervalsArgs, SystemsArgs};
use super::sweep_args::SweepArgs;
use super::system_args::{OffsetsArgs, SeekArgs, WatchArgs};

#[derive(Debug, clap::Args)]
pub(super) struct CompareArgs {
    /// The run directories, two or more; differences are from the first.
    #[arg(value_name = "RUN_DIR", required = true)]
    pub(super) runs: Vec<PathBuf>,

    #[command(flatten)]
    pub(super) page: StudyPageArgs,
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

#[derive(Debug, Subcommand)]
pub(super) enum StudyArgs {
    /// Compute the hard cases by every method that applies, and compare them with closed forms.
    ///
    /// Of lines, and of systems at rest and in time. Every trial is OK, REFUSED (with the reason) or WRONG. The exit status is 1 if one is not as expected.
    HardCases(HardArgs),
    /// Measure every method at several settings on one case: work against error.
    ///
    /// Errors are those of the time step, against a reference by another method in much finer steps, whose
    /// own error is given; the mesh has a table of its own. Takes as long as the reference: up to some minutes. At rest the ways are the closed
    /// form and lines in segments: their errors are those of mesh and form against a much finer mesh, with the setting that each accuracy needs.
    Speed(SpeedArgs),
    /// Compare error-controlled steps with the constant step of equal error.
    ///
    /// For every tolerance and spectral radius: the work, the errors, and the work of constant steps at the same error.
    /// Takes as long as the references, one for each variant: up to some minutes.
    Steps(StepsArgs),
    /// Compute a case over ranges of its keys, and show results against them.
    ///
    /// `--vary KEY=A..B/N` takes N values from A to B in even steps, `A..B/Nlog` in even ratios, `KEY=a,b,c` the values listed; each with a
    /// unit where it is not that of the key (`line.wire.length_m=0.1..0.5 km/3`). Given twice, all combinations are computed. It is
    /// `seacable sweep` with a row for every point on its page: the same load cases, folder, table, runs and options, --jobs and --resume
    /// among them. A point that fails says why and stops no other; the exit status is then 1.
    Vary(Box<SweepArgs>),
    /// Rank the inputs of a case by their effect on a result: each varied alone by its tolerance, up and down.
    ///
    /// The tolerance is that of the input's mark (`tolerance_rel`, `tolerance_abs`), 10 % of its value where it states none. Draws a tornado
    /// chart; changes within the error bar of the result are marked. Variants are computed side by side, without companion runs.
    Effects(EffectsArgs),
    /// Leave every effect of a case out in turn: what changes against the error bars, and what it saves.
    ///
    /// Effects are drag, added mass, bending, damping, elasticity, bed friction, current, waves, motion of the ends, rotation of the payload,
    /// inertia and the mesh, as far as the case has them.
    Physics(EffectsArgs),
    /// Push a body of a system of lines aside: restoring force and tensions against its offset.
    Offsets(OffsetsArgs),
    /// Watch circle of a body of a system under a steady load from all sides, with all lines and with each lost in turn.
    ///
    /// The body keeps its height and its angles. The exit status is 1 where the intact lines do not hold the load.
    WatchCircle(WatchArgs),
    /// Find the input of a system with which a result is as wanted: a length for a tension, a radius for a clearance.
    ///
    /// A case of a line is taken as the system of it, whose keys `seacable import` prints. The exit status is 1, with the reason, where no value between the bounds gives it.
    Seek(SeekArgs),
    /// The same as `seacable laboratory systems`.
    #[command(hide = true)]
    Systems(SystemsArgs),
    /// The same as `seacable laboratory intervals`.
    #[command(hide = true)]
    Intervals(IntervalsArgs),
    /// The same as `seacable laboratory bars`.
    #[command(hide = true)]
    Bars(BarsArgs),
    /// The same as `seacable laboratory accuracy`.
    #[command(hide = true)]
    Accuracy(AccuracyArgs),
}

#[derive(Debug, clap::Args)]
pub(super) struct StepsArgs {
    #[command(flatten)]
    pub(super) case: CaseArgs,

    /// Variants of the case, each with slightly different gravity; the table holds their medians.
    #[arg(long, value_name = "N", default_value = "5", value_parser = count)]
    pub(super) variants: usize,

    #[command(flatten)]
    pub(super) table: TableArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct SpeedArgs {
    #[command(flatten)]
    pub(super) case: CaseArgs,

    /// Runs of every point; the table holds the cheapest.
    #[arg(long, value_name = "N", default_value = "3", value_parser = count)]
    pub(super) repeats: usize,

    /// Measure the equilibrium of a scene in time.
    #[arg(long)]
    pub(super) at_rest: bool,

    /// At rest, accuracies for which a setting is recommended, as shares of the range.
    #[arg(long, value_name = "SHARE", value_delimiter = ',', default_values_t = [1e-2, 1e-3, 1e-4])]
    pub(super) accuracy: Vec<f64>,

    #[command(flatten)]
    pub(super) table: TableArgs,
}
