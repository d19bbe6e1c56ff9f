//! The arguments of commands on models that need no run: ship, modes, ropeway, lines, section.

use std::path::PathBuf;

use super::common_args::{CaseArgs, StudyPageArgs, count};

#[derive(Debug, clap::Args)]
pub(super) struct ShipArgs {
    /// The ship file, such as cases/ship/anchored.toml.
    #[arg(value_name = "CASE")]
    pub(super) file: PathBuf,

    /// Set a key on top of the file, for example wind.speed_m_per_s=12; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) set: Vec<String>,

    /// Draw with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct ModesArgs {
    #[command(flatten)]
    pub(super) case: CaseArgs,

    /// Number of modes, the lowest first; 10 by default.
    #[arg(long, value_name = "N", value_parser = count)]
    pub(super) count: Option<usize>,

    /// Modes to draw, by number: 9,10,11; by default the first three, of several lines the first.
    #[arg(long, value_name = "N,...", value_delimiter = ',', value_parser = count)]
    pub(super) shape: Vec<usize>,

    /// Write the shapes of all modes, node by node, to this file.
    #[arg(short, long = "output", value_name = "OUT.csv")]
    pub(super) output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub(super) force: bool,

    /// Print one JSON object.
    #[arg(long, conflicts_with = "ascii")]
    pub(super) json: bool,

    /// Draw with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct RopewayArgs {
    /// The ropeway file, such as cases/ropeway/span_80.toml.
    #[arg(value_name = "CASE")]
    pub(super) file: PathBuf,

    /// Set a key on top of the file, for example cargo.position=0.3; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) set: Vec<String>,

    /// Write the rope with the cargo on it as a line case to this file.
    #[arg(long, value_name = "FILE")]
    pub(super) line: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "line")]
    pub(super) force: bool,

    /// Draw with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct LinesArgs {
    /// Take the types of this library, a YAML file of MoorPy with a table lineProps, instead of the program's.
    #[arg(long, value_name = "FILE.yaml")]
    pub(super) library: Option<PathBuf>,

    /// The line type, such as chain-r4-studless; without one all are listed.
    #[arg(value_name = "TYPE")]
    pub(super) line_type: Option<String>,

    /// Its nominal diameter: 120mm, or 0.12 in m.
    #[arg(
        value_name = "DIAMETER",
        requires = "line_type",
        conflicts_with = "diameter"
    )]
    pub(super) size: Option<String>,

    /// Its nominal diameter: 120mm, or 0.12 in m.
    #[arg(long, value_name = "DIAMETER", requires = "line_type")]
    pub(super) diameter: Option<String>,

    /// Print the table [materials.NAME] of a case, with formulas and sources as comments.
    #[arg(long, requires = "line_type", conflicts_with_all = ["json", "csv", "output", "width", "ascii"])]
    pub(super) toml: bool,

    /// Name of that material; by default type and diameter.
    #[arg(long, value_name = "NAME", requires = "toml")]
    pub(super) name: Option<String>,

    #[command(flatten)]
    pub(super) page: StudyPageArgs,
}

#[derive(Debug, clap::Args)]
pub(super) struct SectionArgs {
    /// The section file, such as cases/umbilical/section.toml.
    #[arg(value_name = "CASE")]
    pub(super) file: PathBuf,

    /// Write the material, a table to paste into a line case, to this file.
    #[arg(short, long = "output", value_name = "FILE")]
    pub(super) output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub(super) force: bool,

    /// Tension to distribute over the layers, in N; by default the allowable tension.
    #[arg(long, value_name = "TENSION", value_parser = tension)]
    pub(super) tension_n: Option<f64>,

    /// Draw with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

/// A positive tension.
fn tension(word: &str) -> Result<f64, String> {
    match word.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("give a number of newtons greater than 0, for example 1e5".to_owned()),
    }
}
