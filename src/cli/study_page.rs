//! What studies of one case have in common: their case, the results they show, the page they print.

use std::{io, path::Path, sync::Mutex};

use super::{
    CommandError,
    cases::{self, NamedCase},
    common_args::StudyPageArgs,
    output::{self, FileFormat, OutputFile},
    progress::ProgressLine,
};
use seacable_display::chart::{Chart, draw};
use seacable_display::plain;
use seacable_display::table::Table;
use seacable_model::case::{self, Case, QuantityId};
use seacable_model::kinds::FileBytes;
use seacable_report::run_json;
use seacable_report::seas::SeasView;
use seacable_studies::study::points::{BaseCase, PointProgress};
use seacable_studies::study::results::{main_results, named_result};

/// Rows of a chart, and its columns at most.
const CHART: (usize, usize) = (18, 100);

/// A case with keys set on top of its file, and what points are set on.
pub(super) fn base_case(file: &Path, set: &[String]) -> Result<(BaseCase, Case), CommandError> {
    let NamedCase {
        name, text, case, ..
    } = cases::load_set(FileBytes::read(file), set)?;
    let base = BaseCase {
        text: case::stand_alone(&text, &case).into_owned(),
        path: name,
        overrides: set.to_vec(),
        files: case.files.clone(),
    };
    Ok((base, case))
}

/// The results that are named, or the main ones.
pub(super) fn results(case: &Case, names: &[String]) -> Result<Vec<QuantityId>, CommandError> {
    if names.is_empty() {
        return Ok(main_results(case));
    }
    let named = names.iter().map(|name| named_result(case, name));
    let named: Result<Vec<QuantityId>, _> = named.collect();
    named.map_err(|error| CommandError::Usage(format!("--result: {error}.")))
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
