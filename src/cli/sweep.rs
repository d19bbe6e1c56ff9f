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
    sweep_part,
    sweep_slurm::{self, Watched},
};
use crate::case::load_cases::{LoadCaseError, LoadCases};
use crate::case::{self, Case, kind};
use crate::files::read;
use crate::kinds::FileType;
use crate::report::number::duration;
use crate::report::table::Table;
use crate::report::variation::VariationView;
use crate::study::points::BaseCase;
use crate::study::sweep::{
    StoredSweep, Sweep, SweepError, SweepFolder, SweepKind, SweepOutcomes, SweepProgress,
    SweepResults, load_cases, without_load_cases,
};
use crate::study::vary::Variation;
use crate::system::SystemFile;
use crate::visible;

/// Load cases of a table that is printed; of more those that failed are, and all stand in results.csv.
const MOST_ROWS: usize = 100;

pub(super) fn sweep(args: &SweepArgs) -> Result<ExitCode, CommandError> {
    if let Some(part) = args.slurm.part {
        return sweep_part::compute(args, part);
    }
    let stop = StopFlag::listen()?;
    let inputs: Vec<_> = args.case.iter().chain(&args.load_cases).cloned().collect();
    let table = &args.page.table;
    let file = OutputFile::check(table.output.as_deref(), table.force, &inputs)?;
    let (sweep, folder) = match &args.resume {
        Some(dir) => resumed(SweepFolder::open(dir))?,
        None => begun(args)?,
    };
    let outcomes = if args.slurm.slurm {
        match sweep_slurm::compute(args, &sweep, &folder, &stop)? {
            Watched::Gathered(outcomes) => outcomes,
            Watched::Left(status) => return Ok(status),
        }
    } else {
        slurm_refusals::refuse_while_queued(&sweep, &folder)?;
        compute(args, &sweep, &folder, &stop)?
    };
    let view = match &outcomes {
        SweepOutcomes::Runs(outcomes, ids) => {
            VariationView::of_case(&sweep.variation, outcomes, ids)
        }
        SweepOutcomes::AtRest(outcomes, names) => {
            VariationView::of_system(&sweep.variation, outcomes, names)
        }
    };
    let mut csv = Vec::new();
    let results = view.results_table();
    let written = results.write_csv(&mut csv).map_err(std::io::Error::other);
    written.map_err(CommandError::Output)?;
    if stop.status().is_none() {
        let dir = folder.write_results(&csv);
        dir.map_err(|error| CommandError::Usage(error.to_string()))?;
    }
    show(args, file.as_ref(), &view, &folder)?;
    if let Some(status) = stop.status() {
        let dir = visible::path(folder.dir());
        output::message(&format!(
            "Stopped before all load cases were computed; `seacable sweep --resume {dir}` goes on."
        ));
        return Ok(status);
    }
    Ok(match view.is_complete() {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(BAD_RESULT),
    })
}

/// Prints the table of load cases, the extremes and the charts.
fn show(
    args: &SweepArgs,
    file: Option<&OutputFile<'_>>,
    view: &VariationView<'_>,
    folder: &SweepFolder,
) -> Result<(), CommandError> {
    let mut tables: Vec<Table> = match view.points() {
        0..=MOST_ROWS => view.tables(output::page_width(args.page.width)),
        _ => Vec::from_iter(view.failures()),
    };
    tables.push(view.extremes());
    if let Some(last) = tables.last_mut() {
        let dir = visible::path(folder.dir());
        last.notes
            .push(format!("The sweep is {dir}; its runs stand beside it."));
    }
    print(
        "sweep",
        &args.page,
        file,
        (&tables, &view.csv_table()),
        &view.charts(),
    )
}

/// A new sweep.
fn begun(args: &SweepArgs) -> Result<(Sweep, SweepFolder), CommandError> {
    let path = args.case.as_deref().unwrap_or(Path::new(""));
    cases::allow_values(&args.vary);
    let mut csv = Vec::with_capacity(args.load_cases.len());
    for file in &args.load_cases {
        let text = read::text(file).map_err(|error| {
            CommandError::Usage(format!("--load-cases {}: {error}.", visible::path(file)))
        })?;
        csv.push((visible::path(file), text));
    }
    let (base, load_cases, results) = match FileType::of(path) {
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
    slurm_refusals::check(args, &results)?;
    let variation = Variation::of_load_cases(base, load_cases);
    let folder = SweepFolder::create(args.out.as_deref(), &variation, results.names());
    let folder = folder.map_err(|error| CommandError::Usage(error.to_string()))?;
    Ok((Sweep { variation, results }, folder))
}

/// What is computed at the load cases, these, and the results shown.
type Begun = (BaseCase, LoadCases, SweepResults);

fn line(args: &SweepArgs, path: &Path, csv: &[(String, String)]) -> Result<Begun, CommandError> {
    let loaded = cases::load(path)?;
    let text = cases::set(&loaded.text, &args.set)?;
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
    let text = case::stand_alone(&text, &case).into_owned();
    Ok((base(text, &loaded.name, &args.set), load_cases, results))
}

fn system(args: &SweepArgs, path: &Path, csv: &[(String, String)]) -> Result<Begun, CommandError> {
    let name = path.display().to_string();
    let loaded = kind::load_as::<SystemFile>(path, &args.import.options());
    let loaded = loaded.map_err(CommandError::Invalid)?;
    let edits = cases::edits(&args.set)?;
    let (text, solved) = cases::set_and_compute::<SystemFile>(&loaded.whole_text, &edits, path)?;
    let of = SweepKind {
        text: &text,
        tables: &solved.file.load_cases,
        files: &solved.file.files,
    };
    let load_cases = load_cases::<SystemFile>(of, csv, &args.vary).map_err(refused)?;
    let results = SweepResults::of_system(&solved, &args.result).map_err(|why| no_result(&why))?;
    let text = without_load_cases(&text);
    Ok((base(text, &name, &args.set), load_cases, results))
}

/// A sweep that was stopped, as its folder has it.
pub(super) fn resumed(
    opened: Result<(SweepFolder, StoredSweep), SweepError>,
) -> Result<(Sweep, SweepFolder), CommandError> {
    let (folder, stored) = opened.map_err(|error| CommandError::Usage(error.to_string()))?;
    let (text, info) = (stored.case, stored.info);
    let csv = [("load_cases.csv".to_owned(), stored.load_cases)];
    let (tables, files) = (&[], &std::collections::BTreeMap::new());
    let of = SweepKind {
        text: &text,
        tables,
        files,
    };
    let (cases, results) = match FileType::of_text(&text) {
        FileType::System => {
            let solved = kind::parse_stored::<SystemFile>(&text, &info.case_file);
            let solved = solved.map_err(CommandError::Invalid)?;
            let results =
                SweepResults::of_system(&solved, &info.results).map_err(|why| no_result(&why))?;
            (
                load_cases::<SystemFile>(of, &csv, &[]).map_err(refused)?,
                results,
            )
        }
        _ => {
            let case = case::parse_stored(&text, &info.case_file).map_err(CommandError::Invalid)?;
            let results =
                SweepResults::of_line(&case, &info.results).map_err(|why| no_result(&why))?;
            (load_cases::<Case>(of, &csv, &[]).map_err(refused)?, results)
        }
    };
    let variation = Variation::of_load_cases(base(text, &info.case_file, &info.overrides), cases);
    Ok((Sweep { variation, results }, folder))
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
fn compute(
    args: &SweepArgs,
    sweep: &Sweep,
    folder: &SweepFolder,
    stop: &StopFlag,
) -> Result<SweepOutcomes, CommandError> {
    let pool = pool(args)?;
    let (line, begun) = (Mutex::new(ProgressLine::new()), Instant::now());
    Ok(pool.install(|| {
        sweep.compute(folder, stop.cancel(), &|progress| {
            if let Ok(mut line) = line.lock() {
                line.show(&words(progress, begun.elapsed().as_secs_f64()));
            }
        })
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
