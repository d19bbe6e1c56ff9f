//! What a cluster has to do with sweeps that are not computed there: those that cannot be, and those that are already.

use super::{CommandError, slurm_words, sweep_args::SweepArgs};
use seacable_studies::study::sweep::slurm::{CommandFailed, Queue, SlurmFile};
use seacable_studies::study::sweep::{Sweep, SweepError, SweepFolder, SweepResults};

/// That a system at rest has no use of a cluster.
pub(super) fn at_rest() -> CommandError {
    usage(SweepError::AtRest)
}

/// Refuses, before a folder is made, what cannot be computed on a cluster.
pub(super) fn check(args: &SweepArgs, results: &SweepResults) -> Result<(), CommandError> {
    match results {
        SweepResults::AtRest(_) if args.slurm.slurm => Err(at_rest()),
        _ => Ok(()),
    }
}

/// Refuses to compute a sweep here while an array of it is in the queue, and removes what ended tasks left.
pub(super) fn refuse_while_queued(sweep: &Sweep, folder: &SweepFolder) -> Result<(), CommandError> {
    let of = sweep.variation.points.len();
    let (_, record) = SlurmFile::of_folder(folder.dir(), of).map_err(usage)?;
    let Some(record) = record.filter(|record| !record.gathered) else {
        return folder.remove_parts(false).map_err(usage);
    };
    let queue = match Queue::look(&record) {
        Ok(queue) => queue,
        // Where there is no Slurm nothing was submitted.
        Err(CommandFailed::NotRun { .. }) if record.submissions.is_empty() => Queue::default(),
        Err(error) => {
            return Err(CommandError::Usage(slurm_words::unknown(
                &error,
                folder.dir(),
            )));
        }
    };
    if queue.is_active() {
        return Err(CommandError::Usage(slurm_words::busy(&queue, folder.dir())));
    }
    folder.remove_parts(false).map_err(usage)
}

/// What is wrong with the folder of a sweep.
#[expect(clippy::needless_pass_by_value, reason = "for map_err")]
pub(super) fn usage(error: SweepError) -> CommandError {
    CommandError::Usage(error.to_string())
}

/// Why a command of Slurm gave no answer.
pub(super) fn failed(error: &CommandFailed) -> CommandError {
    CommandError::Usage(error.to_string())
}
