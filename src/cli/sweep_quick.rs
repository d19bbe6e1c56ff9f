//! `seacable sweep --quick`: looks at the seas in the frequency domain, and runs in time of those that are sampled.

use std::process::ExitCode;
use std::sync::Mutex;

use super::{
    BAD_RESULT, CommandError,
    output::{self, OutputFile},
    progress::ProgressLine,
    signals::StopFlag,
    study_page::print_with_checks,
    sweep_args::SweepArgs,
    sweep_compute::{pool, words},
};
use seacable_base::visible;
use seacable_model::checks::utilisation::UtilisationVerdict;
use seacable_report::quick_look::QuickView;
use seacable_studies::study::points::PointOutcome;
use seacable_studies::study::seas::{Difference, QuickSeas, StoredLoadCase, look_at_seas};
use seacable_studies::study::sweep::{SweepFolder, SweepPlan, SweepProgress, SweepResults};

/// What has no quick looks.
const AT_REST: &str =
    "Quick looks in the frequency domain are of what moves; this system has no [solver].";

/// What of quick looks is written.
const NOTHING_STORED: &str = "Quick looks alone store nothing, so that --out has no folder to write: `--output FILE.csv` writes their table, `--sampled N` runs N seas in time and stores these.";

/// Looks at the seas of a plan, and prints what they say.
pub(super) fn quick(
    args: &SweepArgs,
    plan: &SweepPlan,
    file: Option<&OutputFile<'_>>,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let SweepPlan { sweep, question } = plan;
    if matches!(sweep.results, SweepResults::AtRest(_)) {
        return Err(CommandError::Usage(AT_REST.to_owned()));
    }
    if args.out.is_some() && args.sampled.unwrap_or(0) == 0 {
        return Err(CommandError::Usage(NOTHING_STORED.to_owned()));
    }
    let pool = pool(args)?;
    let looks = pool.install(|| {
        let line = Mutex::new(ProgressLine::new());
        let told = |done: usize, of: usize| {
            if let Ok(mut line) = line.lock() {
                line.show(&format!("{done} of {of} seas looked at"));
            }
        };
        look_at_seas(&sweep.variation, question, stop.cancel(), &told)
    });
    let found = QuickSeas::of_looks(&sweep.variation, &looks, question);
    let sampled = found.sampled(usize::from(args.sampled.unwrap_or(0)));
    let runs = match sampled.is_empty() || stop.status().is_some() {
        true => SampledRuns::default(),
        false => in_time(args, plan, (&found, &sampled), stop)?,
    };
    let view = QuickView {
        looks: &found,
        statistics: &question.statistics,
        differences: &runs.differences,
        runs_cost_s: runs.cost_s,
    };
    let mut tables = view.tables();
    if let (Some(last), Some(dir)) = (tables.last_mut(), &runs.dir) {
        last.notes.push(format!("The runs stand beside {dir}; `seacable sweep --resume {dir}` runs the other load cases in time as well."));
    }
    print_with_checks(
        "quick",
        &args.page,
        file,
        (&tables, &view.seas().seas_table()),
        &[],
        Some(view.seas()),
    )?;
    if let Some(status) = stop.status() {
        output::message("Stopped before all seas were looked at.");
        return Ok(status);
    }
    let passes = view.seas().worst();
    let passes = passes.is_none_or(|worst| worst == UtilisationVerdict::Passes);
    Ok(match passes && found.without.is_empty() {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(BAD_RESULT),
    })
}

/// The runs in time of the seas that were sampled.
#[derive(Default)]
struct SampledRuns {
    differences: Vec<Difference>,
    cost_s: f64,
    dir: Option<String>,
}

/// Runs all load cases of some seas in time, in a folder of the whole sweep.
fn in_time(
    args: &SweepArgs,
    plan: &SweepPlan,
    (found, sampled): (&QuickSeas, &[usize]),
    stop: &StopFlag,
) -> Result<SampledRuns, CommandError> {
    let SweepPlan { sweep, question } = plan;
    let shown = (sweep.results.names(), None);
    let folder = SweepFolder::create(args.out.as_deref(), &sweep.variation, shown);
    let folder = folder.map_err(|error| CommandError::Usage(error.to_string()))?;
    let seas = sampled.iter().map(|sea| &found.results.seas[*sea]);
    let wanted: Vec<usize> = seas.flat_map(|sea| sea.load_cases.clone()).collect();
    let begun = std::time::Instant::now();
    let computed = pool(args)?.install(|| {
        let line = Mutex::new(ProgressLine::new());
        let told = |progress: SweepProgress| {
            if let Ok(mut line) = line.lock() {
                line.show(&words(progress, begun.elapsed().as_secs_f64()));
            }
        };
        sweep.compute_some(Some(&folder), &wanted, stop.cancel(), &told)
    });
    let mut runs: Vec<Option<StoredLoadCase>> = vec![None; sweep.variation.points.len()];
    let mut cost_s = 0.0;
    for (index, outcome) in &computed {
        let run = outcome
            .as_ref()
            .and_then(|outcome: &PointOutcome| outcome.as_ref().ok());
        cost_s += run.map_or(0.0, |run| run.info.cost.cpu_s);
        runs[*index] = outcome.as_ref().and_then(StoredLoadCase::of_outcome);
    }
    let differences = sampled.iter();
    let differences = differences.flat_map(|sea| found.differences(*sea, &runs, question));
    Ok(SampledRuns {
        differences: differences.collect(),
        cost_s,
        dir: Some(visible::argument(folder.dir())),
    })
}
