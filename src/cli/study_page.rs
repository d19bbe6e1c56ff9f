//! What studies of one case have in common: their case, the results they show, the page they print.

use std::{io, sync::Mutex};

use super::{
    CommandError,
    cases::{self, EditedFile, NamedCase},
    common_args::{CaseArgs, StudyPageArgs},
    output::{self, FileFormat, OutputFile},
    progress::ProgressLine,
};
use seacable_display::chart::{Chart, draw};
use seacable_display::plain;
use seacable_display::table::Table;
use seacable_model::case::{self, QuantityId};
use seacable_model::kinds::{FileBytes, FileType};
use seacable_report::run_json;
use seacable_report::seas::SeasView;
use seacable_studies::study::points::{BaseCase, PointProgress};
use seacable_studies::study::sweep::SweepResults;
use seacable_systems::system::{SolvedSystem, SystemFile, at_rest};

/// Rows of a chart, and its columns at most.
const CHART: (usize, usize) = (18, 100);

/// A file that a study varies: what points are set on, and the results that are named, or the main ones.
pub(super) enum StudiedFile {
    /// A case of a line.
    Line(BaseCase, Vec<QuantityId>),
    /// A system of lines, in time or at rest.
    System(BaseCase, Vec<QuantityId>),
}

/// A case or a system with keys set on top of its file.
pub(super) fn studied_file(args: &CaseArgs, names: &[String]) -> Result<StudiedFile, CommandError> {
    let file = FileBytes::read(&args.file);
    match file.kind() {
        FileType::System => of_system(args, file, names),
        _ => of_line(args, file, names),
    }
}

fn of_line(
    args: &CaseArgs,
    file: FileBytes,
    names: &[String],
) -> Result<StudiedFile, CommandError> {
    let NamedCase {
        name, text, case, ..
    } = cases::load_set(file, &args.set)?;
    let ids = SweepResults::of_line(&case, names).map_err(|why| no_result(&why))?;
    let base = BaseCase {
        text: case::stand_alone(&text, &case).into_owned(),
        path: name,
        overrides: args.set.clone(),
        files: case.files,
    };
    Ok(StudiedFile::Line(base, ids.ids()))
}

fn of_system(
    args: &CaseArgs,
    file: FileBytes,
    names: &[String],
) -> Result<StudiedFile, CommandError> {
    let path = file.path().display().to_string();
    let file = EditedFile::<SystemFile>::read(file, &args.set, &args.import.options())?;
    let text = file.whole_text();
    let solved = file.compute()?.computed;
    let ids = results_of_system(&solved, names).map_err(|why| no_result(&why))?;
    let base = BaseCase {
        text,
        path,
        overrides: args.set.clone(),
        files: solved.file.files,
    };
    Ok(StudiedFile::System(base, ids))
}

/// The results of a system that are named, or the main ones.
fn results_of_system(solved: &SolvedSystem, names: &[String]) -> Result<Vec<QuantityId>, String> {
    if solved.file.as_run().is_some() {
        return Ok(SweepResults::of_system(solved, names)?.ids());
    }
    if names.is_empty() {
        return Ok(at_rest::main_results(solved));
    }
    let named = names.iter().map(|name| at_rest::named_result(solved, name));
    named.collect()
}

fn no_result(why: &str) -> CommandError {
    CommandError::Usage(format!("--result: {why}."))
}

/// Tells on a line of progress how many variants of a case are computed.
pub(super) fn variants_told<T>(
    compute: impl FnOnce(&(dyn Fn(PointProgress<'_>) + Sync)) -> T,
) -> T {
    let line = Mutex::new(ProgressLine::new());
    compute(&|progress| {
        if let Ok(mut line) = line.lock() {
            line.show(&format!(
                "{} of {} variants computed",
                progress.done, progress.of
            ));
        }
    })
}

/// Prints tables with charts below, or CSV, or JSON, and writes the CSV to the file asked for.
pub(super) fn print(
    study: &str,
    page: &StudyPageArgs,
    file: Option<&OutputFile<'_>>,
    tables: (&[Table], &Table),
    charts: &[Chart],
) -> Result<(), CommandError> {
    print_with_checks(study, page, file, tables, charts, None)
}

/// The same; JSON has the verdicts of the checks, where there are any.
pub(super) fn print_with_checks(
    study: &str,
    page: &StudyPageArgs,
    file: Option<&OutputFile<'_>>,
    (tables, csv): (&[Table], &Table),
    charts: &[Chart],
    seas: Option<SeasView<'_>>,
) -> Result<(), CommandError> {
    let mut text = Vec::new();
    let written = csv.write_csv(&mut text).map_err(io::Error::other);
    written.map_err(CommandError::Output)?;
    if let Some(file) = file {
        file.write(&text, FileFormat::Text)?;
    }
    if page.table.json {
        let mut object = run_json::study(study, csv);
        if let Some(seas) = seas.filter(|seas| !seas.results.checks.is_empty()) {
            object["checks"] = seas.checks_json();
        }
        return output::object(&object);
    }
    if page.csv {
        return output::document(&text, FileFormat::Text);
    }
    let (width, ascii) = (output::page_width(page.width), page.table.ascii);
    let text = |table: &Table| match ascii {
        true => plain::ascii_table(table).to_text(width),
        false => table.to_text(width),
    };
    let texts: Vec<String> = tables.iter().map(text).collect();
    let mut words = texts.join("\n");
    for chart in charts {
        let picture = draw(chart, width.min(CHART.1), CHART.0, output::glyphs(ascii));
        words.push_str(&format!("\n{}", picture.to_text()));
    }
    output::results(&words, ascii)
}
