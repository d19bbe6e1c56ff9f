//! `seacable sweep`: a case or a system of lines at all of its load cases.

use std::process::ExitCode;

use super::{
    BAD_RESULT, CommandError,
    output::{self, OutputFile},
    signals::StopFlag,
    slurm_refusals,
    study_page::print_with_checks,
    sweep_args::SweepArgs,
    sweep_compute::compute,
    sweep_part,
    sweep_plan::{OpenedSweep, planned, resumed},
    sweep_quick,
    sweep_slurm::{self, WatchEnd},
    sweep_window,
};
use seacable_base::visible;
use seacable_model::checks::utilisation::UtilisationVerdict;
use seacable_report::sweep::{SweepPage, SweepReport};
use seacable_studies::study::seas::SeaQuestion;
use seacable_studies::study::sweep::{
    FinerRound, Sweep, SweepError, SweepFolder, SweepOutcomes, SweepPlan, SweepResults,
};

/// Why a cluster does not compute in rounds.
const IN_ROUNDS: &str = "A job array computes all load cases at once, and --until-settled, --finer-runs and --window compute them in rounds; leave out --slurm, or them.";

/// What writes Parquet files.
const NO_PARQUET: &str = "This program is built without Parquet; build it with `cargo install --path . --features parquet`.";

/// Why a sweep with checks stores its runs.
const READ_FROM_RUNS: &str = "The checks of the file, and `statistics.until_settled`, are read from stored runs; leave out --no-store, or them.";

/// The study that JSON names.
const fn study(page: SweepPage) -> &'static str {
    match page {
        SweepPage::Sweep => "sweep",
        SweepPage::Variation => "vary",
    }
}

/// The command that goes on with a sweep.
const fn command(page: SweepPage) -> &'static str {
    match page {
        SweepPage::Sweep => "seacable sweep",
        SweepPage::Variation => "seacable study vary",
    }
}

pub(super) fn sweep(args: &SweepArgs, page: SweepPage) -> Result<ExitCode, CommandError> {
    if let Some(part) = args.slurm.part {
        return sweep_part::compute(args, part);
    }
    let stop = StopFlag::listen()?;
    let inputs: Vec<_> = args.case.iter().chain(&args.load_cases).cloned().collect();
    let table = &args.page.table;
    let file = OutputFile::check(table.output.as_deref(), table.force, &inputs)?;
    if args.parquet && !cfg!(feature = "parquet") {
        return Err(CommandError::Usage(NO_PARQUET.to_owned()));
    }
    if args.quick {
        return sweep_quick::quick(args, &planned(args)?, file.as_ref(), &stop);
    }
    if args.no_store {
        return unstored(args, page, file.as_ref(), &stop);
    }
    let (sweep, folder, question, sought) = match &args.resume {
        Some(dir) => resumed(SweepFolder::open(dir))?,
        None => begun(args)?,
    };
    stop.say_at_the_end(&stopped(Some(&folder), page));
    if args.slurm.slurm && (sought.is_some() || question.statistics.is_in_rounds()) {
        return Err(CommandError::Usage(IN_ROUNDS.to_owned()));
    }
    if let Some(word) = sought {
        let of = (&sweep, &folder, &question);
        return sweep_window::window(args, &word, of, file.as_ref(), &stop);
    }
    let outcomes = if args.slurm.slurm {
        match sweep_slurm::compute(args, &sweep, &folder, &stop)? {
            WatchEnd::Gathered(outcomes) => (outcomes, Vec::new()),
            WatchEnd::Left(status) => return Ok(status),
        }
    } else {
        slurm_refusals::refuse_while_queued(&sweep, &folder)?;
        compute(args, (&sweep, &question), Some(&folder), &stop)?
    };
    told(
        (args, page),
        (&sweep, Some(&folder), &question),
        &outcomes,
        file.as_ref(),
        &stop,
    )
}

/// Computes and prints a sweep of which nothing is stored.
fn unstored(
    args: &SweepArgs,
    page: SweepPage,
    file: Option<&OutputFile<'_>>,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let SweepPlan { sweep, question } = planned(args)?;
    let is_stored = !matches!(sweep.results, SweepResults::AtRest(_));
    if is_stored && (!question.checks.is_empty() || question.statistics.until_settled) {
        return Err(CommandError::Usage(READ_FROM_RUNS.to_owned()));
    }
    let outcomes = compute(args, (&sweep, &question), None, stop)?;
    let of = (&sweep, None, &question);
    told((args, page), of, &outcomes, file, stop)
}

/// Writes and prints what became of the load cases, and what they say together.
fn told(
    (args, page): (&SweepArgs, SweepPage),
    (sweep, folder, question): (&Sweep, Option<&SweepFolder>, &SeaQuestion),
    (outcomes, finer): &(SweepOutcomes, Vec<FinerRound>),
    file: Option<&OutputFile<'_>>,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let answers = match (folder, outcomes) {
        (None, SweepOutcomes::Runs(..)) => None,
        _ => sweep.answers(outcomes, question),
    };
    let found = (outcomes, answers.as_ref());
    let has_ended = stop.status().is_none();
    let dir = folder.map(SweepFolder::dir);
    let report = SweepReport::new((sweep, question), found, has_ended, dir)
        .with_finer(finer)
        .on_page(page);
    if let Some(folder) = folder.filter(|_| has_ended) {
        let failed = |error: SweepError| CommandError::Usage(error.to_string());
        report.store(folder).map_err(failed)?;
        #[cfg(feature = "parquet")]
        if args.parquet {
            report.store_parquet(folder).map_err(failed)?;
        }
    }
    show((args, page), file, &report)?;
    if let Some(status) = stop.status() {
        output::message(&stopped(folder, page));
        return Ok(status);
    }
    let worst = report.seas.and_then(|seas| seas.worst());
    let passes = worst.is_none_or(|worst| worst == UtilisationVerdict::Passes);
    Ok(match report.view.is_complete() && passes {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(BAD_RESULT),
    })
}

/// That the sweep was stopped, and how it goes on.
fn stopped(folder: Option<&SweepFolder>, page: SweepPage) -> String {
    let goes_on = folder.map_or_else(String::new, |folder| {
        let (command, dir) = (command(page), visible::argument(folder.dir()));
        format!("; `{command} --resume {dir}` goes on")
    });
    format!("Stopped before all load cases were computed{goes_on}.")
}

/// Prints the verdict, the seas, the extremes, the load cases and the charts.
fn show(
    (args, page): (&SweepArgs, SweepPage),
    file: Option<&OutputFile<'_>>,
    report: &SweepReport<'_>,
) -> Result<(), CommandError> {
    let width = output::page_width(args.page.width);
    let tables = report.tables(width);
    // A result against seeds is no curve.
    let charts = match report.has_seeds() {
        true => Vec::new(),
        false => report.view.charts(),
    };
    print_with_checks(
        study(page),
        &args.page,
        file,
        (&tables, &report.view.csv_table()),
        &charts,
        report.seas,
    )
}

/// A new sweep in its folder.
fn begun(args: &SweepArgs) -> Result<OpenedSweep, CommandError> {
    let SweepPlan { sweep, question } = planned(args)?;
    let (variation, results) = (&sweep.variation, &sweep.results);
    slurm_refusals::check(args, results)?;
    if args.slurm.slurm && (args.window.is_some() || question.statistics.is_in_rounds()) {
        return Err(CommandError::Usage(IN_ROUNDS.to_owned()));
    }
    if let Some(word) = &args.window {
        sweep_window::begun(word, variation, &question)?;
    }
    let shown = (results.names(), args.window.as_deref());
    let folder = SweepFolder::create(args.out.as_deref(), variation, shown);
    let folder = folder.map_err(|error| CommandError::Usage(error.to_string()))?;
    Ok((sweep, folder, question, args.window.clone()))
}
