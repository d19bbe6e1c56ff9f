//! `seacable sweep --resume DIR --part A..B`: some load cases of a sweep, as a task of an array computes them.

use std::process::ExitCode;

use super::{
    BAD_RESULT, CommandError, output, signals::StopFlag, slurm_refusals, sweep_args::SweepArgs,
    sweep_compute::pool, sweep_plan::resumed,
};
use seacable_base::visible;
use seacable_studies::study::sweep::{PartDone, SweepFolder, SweepPart, SweepResults};

/// Computes the part and prints one line.
pub(super) fn compute(args: &SweepArgs, part: SweepPart) -> Result<ExitCode, CommandError> {
    let stop = StopFlag::listen()?;
    // Where a case is given, clap takes what --part requires for left out on purpose.
    let dir = args.resume.as_deref().ok_or_else(|| {
        CommandError::Usage("--part is of a sweep that has begun: name its folder, --resume DIR, in place of a case.".to_owned())
    })?;
    let (sweep, folder, ..) = resumed(SweepFolder::open_part(dir))?;
    if matches!(sweep.results, SweepResults::AtRest(_)) {
        return Err(slurm_refusals::at_rest());
    }
    let done = pool(args)?.install(|| sweep.compute_part(&folder, part, stop.cancel()));
    let done = done.map_err(|error| CommandError::Usage(error.to_string()))?;
    output::results(&line(part, sweep.variation.points.len(), &done), false)?;
    if let Some(status) = stop.status() {
        let dir = visible::argument(folder.dir());
        output::message(&format!(
            "Stopped; `seacable sweep --resume {dir} --part {}..{}` goes on.",
            part.first, part.last
        ));
        return Ok(status);
    }
    if let Some(why) = &done.unstored {
        return Err(CommandError::Usage(format!("{why}.")));
    }
    Ok(match done.is_good() {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(BAD_RESULT),
    })
}

/// What became of the part.
fn line(part: SweepPart, of: usize, done: &PartDone) -> String {
    let counts = [
        (done.computed, "computed"),
        (done.stored_before, "stored before"),
        (done.failed, "failed"),
        (done.refused, "refused"),
        (done.stopped, "not computed"),
    ];
    // How many were computed is said always.
    let counts = counts.iter().enumerate();
    let words = counts.filter(|(place, (count, _))| *place == 0 || *count > 0);
    let words: Vec<String> = words
        .map(|(_, (count, what))| format!("{count} {what}"))
        .collect();
    let last = part.last.min(of);
    format!(
        "Load cases {} to {last} of {of}: {}.\n",
        part.first,
        words.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_names_what_there_is() {
        let part = SweepPart { first: 9, last: 12 };
        let done = PartDone {
            computed: 3,
            failed: 1,
            ..PartDone::default()
        };
        assert_eq!(
            line(part, 11, &done),
            "Load cases 9 to 11 of 11: 3 computed, 1 failed.\n"
        );
        let none = PartDone {
            stored_before: 4,
            ..PartDone::default()
        };
        assert_eq!(
            line(part, 40, &none),
            "Load cases 9 to 12 of 40: 0 computed, 4 stored before.\n"
        );
    }
}
