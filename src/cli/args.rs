//! The arguments of the command line.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use super::about_args::{BindingsArgs, CompletionsArgs, DoctorArgs, InstallManualArgs, ManArgs};
use super::audit::AuditArgs;
use super::export::ExportArgs;
use super::import::{ImportArgs, ImportCommandArgs};
use super::job::JobArgs;
use super::jobs::JobsArgs;
use super::laboratory::args::LaboratoryArgs;
use super::limit_args::{LimitArgs, ReadingArgs};
use super::model_args::{LinesArgs, ModesArgs, RopewayArgs, SectionArgs, ShipArgs};
use super::rules::RulesArgs;
use super::statistics::StatisticsArgs;
use super::study_args::{CompareArgs, StudyArgs};
use super::sweep_args::SweepArgs;
use seacable_display::chart::Glyphs;
use seacable_model::case::Method;
use seacable_model::kinds::FileType;
use seacable_report::document::ReportFormat;

/// A terminal workbench for marine cables.
///
/// Without a command it opens the workbench: on a case file, on the cases below a directory, or on
/// the cases that come with the program.
#[derive(Debug, Parser)]
#[command(
    name = "seacable",
    version,
    max_term_width = 100,
    args_conflicts_with_subcommands = true
)]
#[command(
    after_help = "Exit status: 0 success; 1 a row is outside its tolerance or the solver \
    failed; 2 bad input; 130 and 143 stopped by a signal."
)]
pub(super) struct Args {
    /// A case file, or a directory with case files, to open in the workbench.
    #[arg(value_name = "CASE|DIR")]
    pub(super) path: Option<PathBuf>,

    /// Draw with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,

    /// Character set to draw with; by default chosen from the locale and the terminal.
    #[arg(long, value_name = "SET", conflicts_with = "ascii")]
    pub(super) glyphs: Option<Glyphs>,

    /// Compute runs inside the workbench, not as jobs that go on without it; they end with it.
    #[arg(long)]
    pub(super) in_process: bool,

    /// For slow links: fewer frames, and a longer wait for key sequences that arrive in pieces.
    #[arg(long)]
    pub(super) slow_link: bool,

    /// Open as for the first time: the last session's case, pane, cursor, filters and sorting are ignored.
    #[arg(long)]
    pub(super) fresh: bool,

    /// Begin with the tutorial: five minutes on the screen, with a case that comes with the program.
    #[arg(long)]
    pub(super) tutorial: bool,

    /// Leave the last screen in the shell on quitting.
    #[arg(long)]
    pub(super) keep_screen: bool,

    #[command(flatten)]
    pub(super) limits: LimitArgs,

    #[command(flatten)]
    pub(super) reading: ReadingArgs,

    #[command(subcommand)]
    pub(super) command: Option<CliCommand>,
}

#[derive(Debug, Subcommand)]
pub(super) enum CliCommand {
    /// Compute a case and store the run in a directory.
    ///
    /// Prints the run directory and the table of results.
    Run(RunArgs),
    /// Compare cases with the published values they state.
    ///
    /// Computes every case and every variant that its published rows ask for, and prints the
    /// validation tables. The exit status is 1 when a row is outside its tolerance.
    Validate(ValidateArgs),
    /// Print the text report of a stored run.
    Report(ReportArgs),
    /// Compare stored runs: inputs and settings that differ, every result with its error bar, channels, published values, cost.
    ///
    /// Differences are from the first run. Two results differ where their error bars do not overlap.
    Compare(CompareArgs),
    /// Solve a table of lines at rest, in still water or in a current.
    ///
    /// CSV, a single line a row, hanging between end A and end B, seen from A: columns x_m, z_m, length_m,
    /// ea_n, weight_n_per_m and, optionally, friction, bed_below_a_m (empty: no bed),
    /// bed_slope_deg (positive uphill from A to B), surface_above_a_m (holds floating lines down).
    /// The output has the same columns and h_b_n, v_b_n, h_a_n, v_a_n, on_bed_m, status and shape: h the
    /// horizontal part of the tension, v_b pulling B down and v_a pulling A up when positive.
    ///
    /// CSV of single lines in a uniform current: a_x_m, a_y_m, a_z_m, b_x_m, b_y_m, b_z_m, length_m,
    /// weight_n_per_m, ea_n, diameter_m, drag_normal, drag_tangential, water_density_kg_per_m3,
    /// current_x_m_per_s, current_y_m_per_s (or, in short, Ax ... Bz, L, w_Npm, EA_N, d_m, Cd, CdAx, rho, Ux, Uy).
    /// The output has the line's pull on its ends (pull_a_x_n ... pull_b_z_n), tension_a_n, tension_b_n,
    /// error_n estimated from two meshes, segments and status.
    ///
    /// JSON lines, an object a line, for several sections: "sections" (or "segs") lists from A to B
    /// [length_m, weight_n_per_m, ea_n] or, with the weight of a body at its end, [..., body_n]; with "x_m", "z_m",
    /// "bed_below_a_m", "friction", "bed_slope_deg", "surface_above_a_m" as above ("radius" and "depth" in the
    /// place of x_m and z_m put a level bed through A), or in a current with "a_m", "b_m", "diameter_m",
    /// "drag_normal", "drag_tangential", "water_density_kg_per_m3" and "current", a list of
    /// [depth_m, x_m_per_s, y_m_per_s]. Answers are added as keys of the same names.
    ///
    /// A row without a solution gives the reason in its status; the exit status is then 1.
    Catenary(CatenaryArgs),
    /// Compute a cable's cross-section: layout, stiffness, weight, strength.
    ///
    /// Prints the section drawn to scale and its tables, stiffness with a rigid and an incompressible
    /// core side by side; `--output` writes the material for a line case. An impossible layout is refused with the reason.
    Section(SectionArgs),
    /// List line types, or compute the properties of one by its nominal diameter: chain, wire rope, fibre rope.
    ///
    /// Mass, stiffness, loads, drag and added mass with their formulas and sources; `--toml` prints the material of a case. Coefficients
    /// are converted to the outer diameter, by which drag, buoyancy and added mass of a material act.
    Lines(LinesArgs),
    /// List the sets of rules of standards that `[[checks]]` may name, or the rules of one, with clauses and sources.
    Rules(RulesArgs),
    /// Compute a ship at single-point mooring: equilibrium headings, motion in its sea, its anchor line in time, the rope
    /// that follows it.
    ///
    /// Prints the moment about the mooring against the heading, all equilibrium headings with their
    /// stability, the loads there and the reach of the mooring line.
    Ship(ShipArgs),
    /// Compute the natural frequencies and mode shapes of a line about its static shape.
    ///
    /// Prints the lowest modes, their direction of motion and their mesh error, and draws some of their
    /// shapes. Added mass is included, drag is not.
    Modes(ModesArgs),
    /// Compute a ropeway between a platform and a ship: tensions, sag, clearance, winch, cargo.
    ///
    /// Prints a drawing of the ropeway and its tables: the inextensible model of the paper, parabola theory, the exact
    /// elastic rope with the cargo on it and the discretised line side by side.
    Ropeway(RopewayArgs),
    /// Write the case that a file of another program is: MoorDyn (both versions), MoorPy, MAP++, CableDyn, designs of RAFT and the IEA ontology.
    ///
    /// Each value says from which line of the file it comes, and conventions that the file does not speak of are put down as assumed.
    /// `seacable run`, `modes`, `study` and the workbench take such files as they are. What is not modelled is refused, all at once, with line
    /// and column; `--without NAME` leaves it out. Of a case of a line it writes the system of that line, which `export` and `study seek` take
    /// as it is too; what a system cannot state is refused with its key.
    Import(ImportCommandArgs),
    /// Write a system as a file of another program: MoorDyn 2 or MAP++. A case of a line is written as the system of it.
    ///
    /// What that program cannot say and would change results is refused, all at once. A file that was written, read and written again is the
    /// same text.
    Export(ExportArgs),
    /// Audit a file of another program: a second opinion on its start, time step, segments, conventions and settings.
    ///
    /// The file is computed to a known error, and what the program would get wrong with it is listed with figures and remedies, on a page of
    /// text and, with `--csv`, as a table.
    Audit(AuditArgs),
    /// List the keys of a kind of file: range, unit, default, condition and help.
    ///
    /// With `--schema` it prints a JSON Schema, by which editors complete and check files.
    Keys(KeysArgs),
    /// List the commands of the workbench with your keys, by the names that your file of keys binds.
    ///
    /// The file is keys.toml in the folder seacable of $XDG_CONFIG_HOME (~/.config). Faults of it are reported with line and column, and the
    /// exit status is then 1; in the workbench what is wrong keeps the program's own key.
    Bindings(BindingsArgs),
    /// Look at what the program finds where it runs: terminal, folders, editor, settings, the last fault.
    ///
    /// Needs no terminal. The exit status is 1 where something is in the way of work; each such line says what to do.
    Doctor(DoctorArgs),
    /// Print the completions of a shell.
    Completions(CompletionsArgs),
    /// Print the manual page of the program or of a command, in the language of `man`.
    Man(ManArgs),
    /// Put manual pages and shell completions where your shells find them, below $XDG_DATA_HOME (~/.local/share).
    ///
    /// `cargo install` places the program alone. Files that are not of this program stay, unless --force replaces them; the exit status is
    /// then 1. Completions are written for bash, zsh and fish, as far as they are installed.
    InstallManual(InstallManualArgs),
    /// Studies over many runs.
    #[command(subcommand)]
    Study(StudyArgs),
    /// Measure the program rather than a mooring: random systems, error bars and accuracies held against the truth.
    #[command(subcommand)]
    Laboratory(LaboratoryArgs),
    /// Compute a case or a system of lines at all of its load cases.
    ///
    /// Load cases are the combinations of the tables `[[load_cases]]` of the file, of --load-cases and of --vary. Each is a run of its own,
    /// stored beside the folder of the sweep; the table of results does not depend on --jobs. A sweep that was stopped or killed goes on
    /// with --resume. The exit status is 1 when a load case failed.
    Sweep(SweepArgs),
    /// Compute statistics of stored runs: moments, the greatest value of some hours by three methods, fatigue.
    ///
    /// Several runs are taken together as records of one sea with other seeds. Two errors are stated and never added: the interval of the
    /// sample, and the numerical error of the runs.
    Statistics(StatisticsArgs),
    /// List the jobs that go on without a screen, and cancel or wait for one: runs of the workbench and of `seacable run --detach`.
    ///
    /// They are listed with their state, for a week after their end, or until the workbench has shown it; those on other hosts with the
    /// same home are listed too.
    Jobs(JobsArgs),
    /// The process of a job.
    #[command(hide = true)]
    Job(JobArgs),
}

#[derive(Debug, clap::Args)]
pub(super) struct KeysArgs {
    /// Keys that begin with this path, such as payload or `materials.<name>.ea_n`.
    #[arg(value_name = "PREFIX", conflicts_with = "schema")]
    pub(super) prefix: Option<String>,

    /// Every key of all tables.
    #[arg(long, conflicts_with_all = ["prefix", "schema"])]
    pub(super) all: bool,

    /// The kind of file.
    #[arg(long, value_name = "KIND", default_value = "case")]
    pub(super) kind: FileType,

    /// Print a JSON Schema (draft 2020-12) of the file converted to JSON.
    #[arg(long)]
    pub(super) schema: bool,

    /// Print with ASCII characters only.
    #[arg(long, conflicts_with = "schema")]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct RunArgs {
    /// The case file.
    #[arg(value_name = "CASE", required_unless_present = "resume")]
    pub(super) case: Option<PathBuf>,

    /// Resume a stored run from its checkpoint, in a new run directory: it may be killed, stopped or complete.
    #[arg(long, value_name = "RUN_DIR", conflicts_with_all = ["case", "set", "solver"])]
    pub(super) resume: Option<PathBuf>,

    /// Resume up to this time of the run, such as 600 or 10min; by default to the end of the case.
    #[arg(long, value_name = "TIME", value_parser = super::duration::seconds, requires = "resume")]
    pub(super) until: Option<f64>,

    /// Set a key on top of the file, for example current.speed_m_per_s=0.4; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) set: Vec<String>,

    #[command(flatten)]
    pub(super) import: ImportArgs,

    /// Solver to use in place of the case's.
    #[arg(long)]
    pub(super) solver: Option<Method>,

    /// Search mesh and steps with which 95 % of the results are as accurate as this, as a share of their channel's range: 0.001.
    #[arg(long, value_name = "SHARE", conflicts_with = "resume")]
    pub(super) accuracy: Option<f64>,

    /// Wall time that the search for an accuracy may take: 10s, 2min; 60s by default.
    #[arg(long, value_name = "TIME", value_parser = super::duration::seconds, conflicts_with = "resume")]
    pub(super) budget: Option<f64>,

    /// Directory to write, which must not exist yet; by default runs/CASE-TIME.
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,

    /// Compute it as a job that goes on without this terminal; prints its number and folder. `seacable jobs` lists them.
    #[arg(long)]
    pub(super) detach: bool,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,

    /// Print one JSON object: results with errors; for a system of lines, forces at both ends of every line, places of points, poses of bodies.
    #[arg(long, conflicts_with = "ascii")]
    pub(super) json: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct ValidateArgs {
    /// Case files, or directories of them: their tables, each row with its note; by default the page of all that come with
    /// the program.
    #[arg(value_name = "CASE")]
    pub(super) cases: Vec<PathBuf>,

    /// Set a key on top of every file, for example current.speed_m_per_s=0.45; may be repeated. Published values for another
    /// value of the key then read EDITED, and count neither as passed nor as failed.
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "cases")]
    pub(super) set: Vec<String>,

    /// Print the first screen alone: a line for each paper, and the counts of all rows.
    #[arg(long, conflicts_with_all = ["details", "json"])]
    pub(super) summary: bool,

    /// Print inputs and equations of the papers too, and the whole table of every file, each row with its note.
    #[arg(long, conflicts_with = "json")]
    pub(super) details: bool,

    /// Print Markdown.
    #[arg(long, conflicts_with = "json")]
    pub(super) markdown: bool,

    /// Print an HTML page.
    #[arg(long, conflicts_with_all = ["markdown", "json"])]
    pub(super) html: bool,

    /// Print one JSON object.
    #[arg(long, conflicts_with = "ascii")]
    pub(super) json: bool,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct ReportArgs {
    /// The directory of a run, the folder of a sweep, or a file that is computed at once: section, ropeway, ship, system at rest.
    #[arg(value_name = "DIR")]
    pub(super) dir: PathBuf,

    /// Another run, from which the differences of this one follow the report.
    #[arg(long, value_name = "RUN_DIR")]
    pub(super) against: Option<PathBuf>,

    /// The format; without it that of the ending of --output (.txt, .md, .html, .csv, .json), else text.
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(super) format: Option<ReportFormat>,

    /// Include a table that a study wrote, such as `seacable study hard-cases -o FILE.csv`; may be repeated.
    #[arg(long, value_name = "FILE.csv")]
    pub(super) study: Vec<PathBuf>,

    /// Write the report to this file instead of standard output.
    #[arg(short, long = "output", value_name = "FILE")]
    pub(super) output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub(super) force: bool,

    /// Draw with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct CatenaryArgs {
    /// The table of lines, as CSV or JSON lines.
    #[arg(value_name = "IN")]
    pub(super) input: PathBuf,

    /// Write the table to this file instead of standard output.
    #[arg(short, long = "output", value_name = "OUT")]
    pub(super) output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub(super) force: bool,
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_consistent() {
        super::Args::command().debug_assert();
    }
}
