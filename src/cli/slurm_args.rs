//! The arguments by which a sweep is computed on a cluster.

use seacable_studies::study::sweep::SweepPart;
use seacable_studies::study::sweep::slurm::check_option;

#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Cluster")]
pub(super) struct SlurmArgs {
    /// Compute the load cases as a job array of Slurm, watch it, and submit again what is missing; see docs/CLUSTER.md.
    #[arg(long, conflicts_with = "part")]
    pub(super) slurm: bool,

    /// Load cases of a task of the array; by default as few as make 1000 tasks at most.
    #[arg(long, value_name = "N", requires = "slurm", value_parser = at_least_one)]
    pub(super) cases_per_task: Option<usize>,

    /// An option that sbatch gets as it is, such as --slurm-option=--partition=long; may be repeated.
    #[arg(long, value_name = "TEXT", requires = "slurm", value_parser = option, allow_hyphen_values = true)]
    pub(super) slurm_option: Vec<String>,

    /// Compute only these load cases, as the tasks of an array do: store their runs, and write no results.
    #[arg(long, value_name = "A..B", requires = "resume")]
    pub(super) part: Option<SweepPart>,
}

fn at_least_one(word: &str) -> Result<usize, String> {
    let number = word.parse::<usize>().ok().filter(|number| *number > 0);
    number.ok_or_else(|| "give a whole number of 1 or more".to_owned())
}

fn option(word: &str) -> Result<String, String> {
    match check_option(word) {
        Ok(()) => Ok(word.to_owned()),
        Err(error) => Err(error.to_string()),
    }
}
