//! The load cases of a sweep computed on threads, with a line of progress.

use std::sync::Mutex;
use std::time::Instant;

use super::{CommandError, progress::ProgressLine, signals::StopFlag, sweep_args::SweepArgs};
use seacable_base::number::duration;
use seacable_studies::study::seas::SeaQuestion;
use seacable_studies::study::sweep::{
    FinerRound, Sweep, SweepFolder, SweepOutcomes, SweepProgress,
};

/// Computes with a line of progress, on as many threads as asked for.
pub(super) fn compute(
    args: &SweepArgs,
    (sweep, question): (&Sweep, &SeaQuestion),
    folder: Option<&SweepFolder>,
    stop: &StopFlag,
) -> Result<(SweepOutcomes, Vec<FinerRound>), CommandError> {
    let pool = pool(args)?;
    let (line, begun) = (Mutex::new(ProgressLine::new()), Instant::now());
    let computed = pool.install(|| {
        let told = |progress: SweepProgress| {
            if let Ok(mut line) = line.lock() {
                line.show(&words(progress, begun.elapsed().as_secs_f64()));
            }
        };
        sweep.compute_asked(folder, question, stop.cancel(), &told)
    });
    computed.map_err(|error| CommandError::Usage(error.to_string()))
}

/// As many threads as asked for.
pub(super) fn pool(args: &SweepArgs) -> Result<rayon::ThreadPool, CommandError> {
    let jobs = args.jobs.map_or(0, usize::from);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    pool.map_err(|error| CommandError::Usage(format!("--jobs {jobs}: {error}.")))
}

/// How many load cases are done, and how long the others will take.
pub(super) fn words(progress: SweepProgress, seconds: f64) -> String {
    let SweepProgress { done, stored, of } = progress;
    let left = match done - stored {
        0 => String::new(),
        computed => {
            let left = seconds / computed as f64 * (of - done) as f64;
            format!(", {} left", duration(left))
        }
    };
    format!("{done} of {of} load cases computed{left}")
}
