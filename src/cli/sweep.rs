//! `seacable sweep`: a case or a system of lines at all of its load cases.

use std::path::Path;
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::Instant;

use super::{
    BAD_RESULT, CommandError, cases,
    output::{self, OutputFile},
    progress::ProgressLine,
    signals::StopFlag,
    slurm_refusals,
    study_page::print,
    sweep_args::SweepArgs,
    sweep_part, sweep_seas,
    sweep_slurm::{self, Watched},
    sweep_window,
};
use crate::case::load_cases::{LoadCaseError, LoadCases};
use crate::case::{self, Case, kind};
use crate::checks::utilisation::Verdict;
use crate::files::read;
use crate::kinds::FileType;
use crate::report::number::duration;
use crate::report::plain;
use crate::report::seas::SeasView;
use crate::report::table::Table;
use crate::report::variation::VariationView;
use crate::study::points::BaseCase;
use crate::study::seas::SeaQuestion;
use crate::study::sweep::{
    StoredSweep, Sweep, SweepError, SweepFolder, SweepKind, SweepOutcomes, SweepProgress,
    SweepResults, load_cases, without_load_cases,
};
use crate::study::vary::Variation;
use crate::system::SystemFile;
use crate::visible;

/// Load cases of a table that is printed; of more those that failed are, and all stand in results.csv.
const MOST_ROWS: usize = 100;

/// Why a cluster does not compute in rounds.
const IN_ROUNDS: &str = "A job array computes all load cases at once, and --until-settled and --window compute them in rounds; leave out --slurm, or them.";

/// Why a sweep with checks stores its runs.
const READ_FROM_RUNS: &str = "The checks of the file, and `statistics.until_settled`, are read from stored runs; leave out --no-store, or them.";

/// Columns of the report in the folder.
const REPORT_WIDTH: usize = 80;

/// What a sweep prints: the whole of its load cases, or, as `seacable study vary` does, all of its rows and what is varied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SweepPage {
    /// What the load cases say together, their extremes, and the rows of short tables.
    Sweep,
    /// A row for each point, whatever their number; what they say together only where it is asked for.
    Variation,
}

impl SweepPage {
    /// The study that JSON names.
    const fn study(self) -> &'static str {
        match self {
            Self::Sweep => "sweep",
            Self::Variation => "vary",
        }
    }

    /// The command that goes on with it.
    const fn command(self) -> &'static str {
        match self {
            Self::Sweep => "seacable sweep",
            Self::Variation => "seacable study vary",
        }
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
    if args.no_store {
        return unstored(args, page, file.as_ref(), &stop);
    }
    let (sweep, folder, question, sought) = match &args.resume {
        Some(dir) => resumed(SweepFolder::open(dir))?,
        None => begun(args)?,
    };
    if args.slurm.slurm && (sought.is_some() || question.statistics.until_settled) {
        return Err(CommandError::Usage(IN_ROUNDS.to_owned()));
    }
    if let Some(word) = sought {
        let of = (&sweep, &folder, &question);
        return sweep_window::window(args, &word, of, file.as_ref(), &stop);
    }
    let outcomes = if args.slurm.slurm {
        match sweep_slurm::compute(args, &sweep, &folder, &stop)? {
            Watched::Gathered(outcomes) => outcomes,
            Watched::Left(status) => return Ok(status),
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
    let (variation, results, question) = planned(args)?;
    let is_stored = !matches!(results, SweepResults::AtRest(_));
    if is_stored && (!question.checks.is_empty() || question.statistics.until_settled) {
        return Err(CommandError::Usage(READ_FROM_RUNS.to_owned()));
    }
    let sweep = sweep_seas::sweep(variation, results, &question);
    let outcomes = compute(args, (&sweep, &question), None, stop)?;
    let of = (&sweep, None, &question);
    told((args, page), of, &outcomes, file, stop)
}

/// Writes and prints what became of the load cases, and what they say together.
fn told(
    (args, page): (&SweepArgs, SweepPage),
    (sweep, folder, question): (&Sweep, Option<&SweepFolder>, &SeaQuestion),
    outcomes: &SweepOutcomes,
    file: Option<&OutputFile<'_>>,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let cost = sweep_seas::cost(outcomes);
    let results = match (folder, outcomes) {
        (None, SweepOutcomes::Runs(..)) => None,
        _ => sweep_seas::answers(sweep, outcomes, question),
    };
    let seas = results.as_ref().map(|results| SeasView {
        results,
        statistics: &question.statistics,
    });
    let view = match outcomes {
        SweepOutcomes::Runs(outcomes, ids) => {
            let view = VariationView::of_case(&sweep.variation, outcomes, ids);
            match question.statistics.until_settled && stop.status().is_none() {
                true => view.with_unneeded(outcomes),
                false => view,
            }
        }
        SweepOutcomes::AtRest(outcomes, names) => {
            VariationView::of_system(&sweep.variation, outcomes, names)
        }
    };
    let mut csv = Vec::new();
    let results = view.results_table();
    let written = results.write_csv(&mut csv).map_err(std::io::Error::other);
    written.map_err(CommandError::Output)?;
    if let Some(folder) = folder.filter(|_| stop.status().is_none()) {
        let failed = |error: SweepError| CommandError::Usage(error.to_string());
        folder.write_results(&csv).map_err(failed)?;
        if let Some(seas) = &seas {
            written_down(folder, (&view, seas))?.map_err(failed)?;
        }
    }
    show((args, page), file, (&view, seas.as_ref(), cost), folder)?;
    if let Some(status) = stop.status() {
        let goes_on = folder.map_or_else(String::new, |folder| {
            let (command, dir) = (page.command(), visible::path(folder.dir()));
            format!("; `{command} --resume {dir}` goes on")
        });
        output::message(&format!(
            "Stopped before all load cases were computed{goes_on}."
        ));
        return Ok(status);
    }
    let passes = seas
        .and_then(|seas| seas.worst())
        .is_none_or(|worst| worst == Verdict::Passes);
    Ok(match view.is_complete() && passes {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(BAD_RESULT),
    })
}

/// Writes what the runs say together beside the table of results.
fn written_down(
    folder: &SweepFolder,
    (view, seas): (&VariationView<'_>, &SeasView<'_>),
) -> Result<Result<(), SweepError>, CommandError> {
    let csv = |table: &Table| {
        let mut text = Vec::new();
        let written = table.write_csv(&mut text).map_err(std::io::Error::other);
        written.map_err(CommandError::Output).map(|()| text)
    };
    let tables = tables(
        SweepPage::Sweep,
        (view, Some(seas), None),
        REPORT_WIDTH,
        Some(folder),
    );
    let texts = tables
        .iter()
        .map(|table| plain::ascii_table(table).to_text(REPORT_WIDTH));
    let report = texts.collect::<Vec<_>>().join("\n");
    Ok(folder.write_verdict(
        &csv(&seas.seas_table())?,
        &csv(&seas.checks_table())?,
        &report,
    ))
}

/// What a sweep found: its load cases, what they say together, what they cost.
type Found<'a> = (
    &'a VariationView<'a>,
    Option<&'a SeasView<'a>>,
    Option<String>,
);

/// The tables of the page: what the runs say together, the extremes, the load cases.
fn tables(
    page: SweepPage,
    (view, seas, cost): Found<'_>,
    width: usize,
    folder: Option<&SweepFolder>,
) -> Vec<Table> {
    let all_rows = page == SweepPage::Variation;
    let seas = seas.filter(|seas| !all_rows || seas.is_asked_for());
    let mut tables: Vec<Table> = seas.map(SeasView::tables).unwrap_or_default();
    if !all_rows {
        tables.push(view.extremes());
    }
    // Of seeds the sea is what is asked for; each run stands in results.csv.
    let of_seeds = seas.is_some_and(SeasView::has_seeds);
    match view.points() {
        _ if all_rows => tables.extend(view.tables(width)),
        0..=MOST_ROWS if !of_seeds => tables.extend(view.tables(width)),
        _ => tables.extend(view.failures()),
    }
    if let Some(last) = tables.last_mut() {
        last.notes.extend(cost);
        last.notes.extend(folder.map(|folder| stored(view, folder)));
    }
    tables
}

/// Where a sweep is stored, in words.
fn stored(view: &VariationView<'_>, folder: &SweepFolder) -> String {
    let dir = visible::path(folder.dir());
    match view.has_runs() {
        true => {
            format!("The sweep is {dir}; its table is results.csv, and its runs stand beside it.")
        }
        false => format!("The sweep is {dir}; its table is results.csv."),
    }
}

/// Prints the verdict, the seas, the extremes, the load cases and the charts.
fn show(
    (args, page): (&SweepArgs, SweepPage),
    file: Option<&OutputFile<'_>>,
    (view, seas, cost): Found<'_>,
    folder: Option<&SweepFolder>,
) -> Result<(), CommandError> {
    let width = output::page_width(args.page.width);
    let tables = tables(page, (view, seas, cost), width, folder);
    // A result against seeds is no curve.
    let charts = match seas.is_some_and(SeasView::has_seeds) {
        true => Vec::new(),
        false => view.charts(),
    };
    print(
        page.study(),
        &args.page,
        file,
        (&tables, &view.csv_table()),
        &charts,
    )
}

/// A sweep with its folder, what is asked of its seas, and the key whose limiting value is sought.
pub(super) type Opened = (Sweep, SweepFolder, SeaQuestion, Option<String>);

/// A new sweep in its folder.
fn begun(args: &SweepArgs) -> Result<Opened, CommandError> {
    let (variation, results, question) = planned(args)?;
    slurm_refusals::check(args, &results)?;
    if args.slurm.slurm && (args.window.is_some() || question.statistics.until_settled) {
        return Err(CommandError::Usage(IN_ROUNDS.to_owned()));
    }
    if let Some(word) = &args.window {
        sweep_window::begun(word, &variation, &question)?;
    }
    let shown = (results.names(), args.window.as_deref());
    let folder = SweepFolder::create(args.out.as_deref(), &variation, shown);
    let folder = folder.map_err(|error| CommandError::Usage(error.to_string()))?;
    let sweep = sweep_seas::sweep(variation, results, &question);
    Ok((sweep, folder, question, args.window.clone()))
}

/// What a sweep computes and shows, and what is asked of all its load cases together.
type Planned = (Variation, SweepResults, SeaQuestion);

/// The load cases of a file and of the options.
fn planned(args: &SweepArgs) -> Result<Planned, CommandError> {
    let path = args.case.as_deref().unwrap_or(Path::new(""));
    cases::allow_values(&args.vary);
    let mut csv = Vec::with_capacity(args.load_cases.len());
    for file in &args.load_cases {
        let text = read::text(file).map_err(|error| {
            CommandError::Usage(format!("--load-cases {}: {error}.", visible::path(file)))
        })?;
        csv.push((visible::path(file), text));
    }
    let (base, load_cases, results, question) = match FileType::of(path) {
        FileType::System => system(args, path, &csv)?,
        FileType::Line => line(args, path, &csv)?,
        other => {
            return Err(CommandError::Usage(format!(
                "A sweep takes cases of lines and systems of lines; {} is {}.",
                visible::path(path),
                other.description().0
            )));
        }
    };
    if load_cases.keys.is_empty() {
        let what = "There are no load cases: add [[load_cases]] to the file, or --vary KEY=VALUES, or --load-cases FILE.csv.";
        return Err(CommandError::Usage(what.to_owned()));
    }
    let variation = Variation::of_load_cases(base, load_cases);
    Ok((variation, results, question))
}

/// What is computed at the load cases, these, the results shown, and what is asked of all together.
type Begun = (BaseCase, LoadCases, SweepResults, SeaQuestion);

fn line(args: &SweepArgs, path: &Path, csv: &[(String, String)]) -> Result<Begun, CommandError> {
    let loaded = cases::load(path)?;
    let set = args.overrides();
    let text = cases::set(&loaded.text, &set)?;
    let case = cases::parse(&text, &loaded.name)?;
    let of = SweepKind {
        text: &text,
        tables: &case.load_cases,
        files: &case.files,
    };
    let load_cases = load_cases::<Case>(of, csv, &args.vary).map_err(refused)?;
    let text = without_load_cases(&text);
    let case = cases::parse(&text, &loaded.name)?;
    let results = SweepResults::of_line(&case, &args.result).map_err(|why| no_result(&why))?;
    let question = sweep_seas::of_line(&case)?;
    let text = case::stand_alone(&text, &case).into_owned();
    let base = base(text, &loaded.name, &set);
    Ok((base, load_cases, results, question))
}

fn system(args: &SweepArgs, path: &Path, csv: &[(String, String)]) -> Result<Begun, CommandError> {
    let name = path.display().to_string();
    let loaded = kind::load_as::<SystemFile>(path, &args.import.options());
    let loaded = loaded.map_err(CommandError::Invalid)?;
    let set = args.overrides();
    let edits = cases::edits(&set)?;
    let (text, solved) = cases::set_and_compute::<SystemFile>(&loaded.whole_text, &edits, path)?;
    let of = SweepKind {
        text: &text,
        tables: &solved.file.load_cases,
        files: &solved.file.files,
    };
    let load_cases = load_cases::<SystemFile>(of, csv, &args.vary).map_err(refused)?;
    let results = SweepResults::of_system(&solved, &args.result).map_err(|why| no_result(&why))?;
    let question = sweep_seas::of_system(&solved)?;
    let base = base(without_load_cases(&text), &name, &set);
    Ok((base, load_cases, results, question))
}

/// A sweep that was stopped, as its folder has it.
pub(super) fn resumed(
    opened: Result<(SweepFolder, StoredSweep), SweepError>,
) -> Result<Opened, CommandError> {
    let (folder, stored) = opened.map_err(|error| CommandError::Usage(error.to_string()))?;
    let (text, info) = (stored.case, stored.info);
    let csv = [("load_cases.csv".to_owned(), stored.load_cases)];
    let (tables, files) = (&[], &std::collections::BTreeMap::new());
    let of = SweepKind {
        text: &text,
        tables,
        files,
    };
    let (cases, results, question) = match FileType::of_text(&text) {
        FileType::System => {
            let solved = kind::parse_stored::<SystemFile>(&text, &info.case_file);
            let solved = solved.map_err(CommandError::Invalid)?;
            let results =
                SweepResults::of_system(&solved, &info.results).map_err(|why| no_result(&why))?;
            let cases = load_cases::<SystemFile>(of, &csv, &[]).map_err(refused)?;
            (cases, results, sweep_seas::of_system(&solved)?)
        }
        _ => {
            let case = case::parse_stored(&text, &info.case_file).map_err(CommandError::Invalid)?;
            let results =
                SweepResults::of_line(&case, &info.results).map_err(|why| no_result(&why))?;
            let cases = load_cases::<Case>(of, &csv, &[]).map_err(refused)?;
            (cases, results, sweep_seas::of_line(&case)?)
        }
    };
    let variation = Variation::of_load_cases(base(text, &info.case_file, &info.overrides), cases);
    let sweep = sweep_seas::sweep(variation, results, &question);
    Ok((sweep, folder, question, info.window))
}

fn base(text: String, path: &str, overrides: &[String]) -> BaseCase {
    BaseCase {
        text,
        path: path.to_owned(),
        overrides: overrides.to_vec(),
    }
}

fn refused(error: LoadCaseError) -> CommandError {
    match error {
        LoadCaseError::Table(fault) => CommandError::Invalid(vec![*fault]),
        error => CommandError::Usage(error.to_string()),
    }
}

fn no_result(why: &str) -> CommandError {
    CommandError::Usage(format!("--result: {why}."))
}

/// Computes with a line of progress, on as many threads as asked for.
pub(super) fn compute(
    args: &SweepArgs,
    (sweep, question): (&Sweep, &SeaQuestion),
    folder: Option<&SweepFolder>,
    stop: &StopFlag,
) -> Result<SweepOutcomes, CommandError> {
    let pool = pool(args)?;
    let (line, begun) = (Mutex::new(ProgressLine::new()), Instant::now());
    Ok(pool.install(|| {
        let told = |progress: SweepProgress| {
            if let Ok(mut line) = line.lock() {
                line.show(&words(progress, begun.elapsed().as_secs_f64()));
            }
        };
        match folder.filter(|_| question.statistics.until_settled) {
            Some(folder) => sweep.compute_until_settled(folder, question, stop.cancel(), &told),
            None => sweep.compute(folder, stop.cancel(), &told),
        }
    }))
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
