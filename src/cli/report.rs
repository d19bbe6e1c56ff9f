//! `seacable report`: the report of a run, a sweep or a file that is computed at once, in every format.

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
    sync::atomic::AtomicBool,
};

use super::{
    CommandError,
    args::ReportArgs,
    cases,
    output::{self, FileFormat, OutputFile},
};
use seacable_base::files::read;
use seacable_base::visible;
use seacable_display::chart::Glyphs;
use seacable_foreign::import::ImportOptions;
use seacable_model::case::{Diagnostic, FieldRow, file_kind::FileKind};
use seacable_model::kinds::{FileBytes, FileType};
use seacable_model::section::CrossSection;
use seacable_report::{
    document::ReportFormat,
    subject::{ReportSubject, RunSubject, StudyTable},
    sweep::SweepReport,
};
use seacable_runs::run::store;
use seacable_studies::study::sweep::{SweepFolder, SweepPlan, SweepResults};
use seacable_systems::ropeway::Ropeway;
use seacable_systems::ship::{DynamicAnalysis, MotionError, Ship};
use seacable_systems::system::{SystemFile, analysis::analyses::Analyses, validation};

pub(super) fn report(args: &ReportArgs) -> Result<ExitCode, CommandError> {
    let mut inputs: Vec<PathBuf> = vec![args.dir.clone()];
    inputs.extend(args.against.iter().chain(&args.study).cloned());
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let order = ReportOrder {
        format: format(args)?,
        // A file is the same whatever the terminal shows.
        glyphs: match (&file, args.ascii) {
            (Some(_), false) => Glyphs::Braille,
            (_, ascii) => output::glyphs(ascii),
        },
        studies: studies(&args.study)?,
    };
    let text = if SweepFolder::is_one(&args.dir) {
        no_other_run(args)?;
        of_sweep(&args.dir, &order)?
    } else if args.dir.is_file() {
        no_other_run(args)?;
        of_file_at_rest(&args.dir, &order)?
    } else {
        of_run(args, &order)?
    };
    match file {
        None => print(&text, order.format, args.ascii)?,
        Some(file) => {
            let (text, format) = ready(&text, order.format, args.ascii);
            file.write(text.as_bytes(), format)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// The format of a report: as asked for, or by the ending of its file; text where that has none.
fn format(args: &ReportArgs) -> Result<ReportFormat, CommandError> {
    let file = args.output.as_deref();
    let of_file = file.and_then(ReportFormat::of_file);
    if let Some(format) = args.format.or(of_file) {
        return Ok(format);
    }
    match file.filter(|file| file.extension().is_some()) {
        None => Ok(ReportFormat::default()),
        Some(file) => {
            let endings = ReportFormat::ALL.map(|format| format!(".{}", format.ending()));
            Err(CommandError::Usage(format!(
                "--output {}: no report is written in the format of this ending; the endings are {}, and --format gives a file with another one its format.",
                visible::path(file),
                endings.join(", ")
            )))
        }
    }
}

/// How a report is written.
struct ReportOrder {
    format: ReportFormat,
    glyphs: Glyphs,
    studies: Vec<StudyTable>,
}

impl ReportOrder {
    fn written(&self, subject: &ReportSubject<'_>) -> Result<String, CommandError> {
        let written = subject.write(self.format, self.glyphs, &self.studies);
        written.map_err(CommandError::Invalid)
    }
}

/// The text as it is written, and how invisible characters are escaped in it.
fn ready(text: &str, format: ReportFormat, ascii: bool) -> (String, FileFormat) {
    match format {
        ReportFormat::Json => (text.to_owned(), FileFormat::Json),
        _ => (output::page(text, ascii), FileFormat::Text),
    }
}

fn print(text: &str, format: ReportFormat, ascii: bool) -> Result<(), CommandError> {
    match format {
        ReportFormat::Json => output::document(text.as_bytes(), FileFormat::Json),
        ReportFormat::Csv => output::document(text.as_bytes(), FileFormat::Text),
        _ => output::results(text, ascii),
    }
}

/// The tables of studies.
fn studies(files: &[PathBuf]) -> Result<Vec<StudyTable>, CommandError> {
    let table = |file: &PathBuf| {
        let name = visible::path(file);
        let text = read::text(file)
            .map_err(|error| CommandError::Usage(format!("--study {name}: {error}.")))?;
        StudyTable::of_csv(&name, &text).map_err(|why| {
            CommandError::Usage(format!("--study {name}: no table of a study: {why}."))
        })
    };
    files.iter().map(table).collect()
}

fn no_other_run(args: &ReportArgs) -> Result<(), CommandError> {
    match &args.against {
        None => Ok(()),
        Some(_) => Err(CommandError::Usage(format!(
            "--against compares runs; {} is no directory of a run.",
            visible::path(&args.dir)
        ))),
    }
}

/// The report of a stored run.
fn of_run(args: &ReportArgs, order: &ReportOrder) -> Result<String, CommandError> {
    let run = store::read(&args.dir)?;
    let other = args.against.as_deref().map(store::read).transpose()?;
    order.written(&ReportSubject::Run(RunSubject {
        run: &run,
        dir: &args.dir,
        rows: None,
        against: other.as_ref(),
    }))
}

/// The report of a sweep from its stored runs.
fn of_sweep(dir: &Path, order: &ReportOrder) -> Result<String, CommandError> {
    let failed = |error: &dyn std::fmt::Display| CommandError::Usage(error.to_string());
    let (folder, stored) = SweepFolder::open_part(dir).map_err(|error| failed(&error))?;
    if stored.info.window.is_some() {
        let dir = visible::path(dir);
        return Err(CommandError::Usage(format!(
            "{dir} is a search for a limiting value, which has no runs of its own; its report is {dir}/report.txt."
        )));
    }
    let SweepPlan { sweep, question } =
        SweepPlan::of_stored(stored).map_err(|error| failed(&error))?;
    let outcomes = match &sweep.results {
        SweepResults::AtRest(_) => sweep.compute(Some(&folder), &AtomicBool::new(false), &|_| {}),
        _ => sweep.gather(&folder).map_err(|error| failed(&error))?,
    };
    let answers = sweep.answers(&outcomes, &question);
    let found = (&outcomes, answers.as_ref());
    let report = SweepReport::new((&sweep, &question), found, folder.has_ended(), Some(dir));
    order.written(&ReportSubject::Sweep(Box::new(report)))
}

/// The report of a file that is computed without a run.
fn of_file_at_rest(path: &Path, order: &ReportOrder) -> Result<String, CommandError> {
    let file = FileBytes::read(path);
    match file.kind() {
        FileType::Line => Err(runs_first(path)),
        FileType::Section => {
            let (fields, design) = loaded::<CrossSection>(file)?;
            order.written(&ReportSubject::Section(&design, &fields, None))
        }
        FileType::Ropeway => {
            let (fields, solved) = loaded::<Ropeway>(file)?;
            let results = solved.results(solved.ropeway.cargo.position);
            let results = results.map_err(|error| {
                CommandError::Usage(format!("The ropeway has no solution: {error}."))
            })?;
            order.written(&ReportSubject::Ropeway(&solved, Box::new(results), &fields))
        }
        FileType::Ship => {
            let (fields, statics) = loaded::<Ship>(file)?;
            let folder = path.parent().unwrap_or(Path::new(""));
            let dynamic = DynamicAnalysis::new(&statics, folder, &AtomicBool::new(false));
            if let Some(Some(Err(MotionError::File(fault)))) = dynamic.as_ref().map(|d| &d.motion) {
                return Err(CommandError::Invalid(vec![Diagnostic::clone(fault)]));
            }
            order.written(&ReportSubject::Ship(&statics, dynamic.as_ref(), &fields))
        }
        FileType::System => {
            let (fields, solved) = loaded::<SystemFile>(file)?;
            if solved.file.as_run().is_some() {
                return Err(runs_first(path));
            }
            let analyses = Analyses::of_system(&solved);
            let rows = validation::rows(&solved, None);
            order.written(&ReportSubject::System(&solved, &analyses, &rows, &fields))
        }
    }
}

fn loaded<K: FileKind>(file: FileBytes) -> Result<(Vec<FieldRow>, K::Computed), CommandError> {
    cases::load_with::<K>(file, &[], &ImportOptions::default())
}

/// What a file that is computed in time needs.
fn runs_first(path: &Path) -> CommandError {
    let (shown, path) = (visible::path(path), visible::argument(path));
    CommandError::Usage(format!(
        "{shown} is computed in a run of its own; `seacable run {path}` stores one, and `seacable report` takes its directory."
    ))
}
