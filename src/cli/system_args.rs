//! The arguments of the analyses of systems of lines.

use super::common_args::CaseArgs;

// Arguments that commands share; doc comments here would replace the help of the commands.

#[derive(Debug, clap::Args)]
pub(super) struct SystemArgs {
    #[command(flatten)]
    pub(super) case: CaseArgs,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,

    /// Print one JSON object.
    #[arg(long, conflicts_with = "ascii")]
    pub(super) json: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct OffsetsArgs {
    #[command(flatten)]
    pub(super) system: SystemArgs,

    /// The body; may be left out where there is only one.
    #[arg(long)]
    pub(super) body: Option<String>,

    /// Direction of the offset from +x towards +y, in degrees.
    #[arg(
        long,
        value_name = "DEG",
        default_value = "0",
        allow_negative_numbers = true
    )]
    pub(super) heading: f64,

    /// Greatest offset, in m.
    #[arg(long, value_name = "M")]
    pub(super) to: f64,

    /// Steps to it.
    #[arg(long, default_value = "20", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(super) steps: u32,
}

#[derive(Debug, clap::Args)]
pub(super) struct WatchArgs {
    #[command(flatten)]
    pub(super) system: SystemArgs,

    /// The body; may be left out where there is only one.
    #[arg(long)]
    pub(super) body: Option<String>,

    /// The steady horizontal load, in N.
    #[arg(long, value_name = "N")]
    pub(super) load: f64,

    /// Headings, evenly around.
    #[arg(long, value_name = "N", default_value = "24", value_parser = clap::value_parser!(u32).range(1..=3600))]
    pub(super) headings: u32,
}

#[derive(Debug, clap::Args)]
pub(super) struct SeekArgs {
    #[command(flatten)]
    pub(super) system: SystemArgs,

    /// The key to vary, for example lines.mooring.length_m.
    #[arg(long, value_name = "KEY")]
    pub(super) vary: String,

    /// The values to search between, in the unit of the key: 880..930.
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    pub(super) between: String,

    /// The result wanted, for example "tension_n[mooring|b]=9.5e5".
    #[arg(long, value_name = "RESULT=VALUE")]
    pub(super) want: String,
}
