//! `seacable study vary`: a case or a system of lines over ranges of its keys.

use std::{path::Path, process::ExitCode, sync::Mutex};

use super::{
    BAD_RESULT, CommandError, cases,
    output::{self, OutputFile},
    progress,
    signals::StopFlag,
    study_args::VaryArgs,
    study_page::{base_case, print, results},
};
use crate::case::kind;
use crate::kinds::FileType;
use crate::report::table::Table;
use crate::report::variation::VariationView;
use crate::run::store;
use crate::study::points::{self, BaseCase, PointOutcome, PointRequest};
use crate::study::vary::{self, Variation};
use crate::system::{SystemFile, quantities};

pub(super) fn vary(args: &VaryArgs) -> Result<ExitCode, CommandError> {
    cases::allow_values(&args.vary);
    if FileType::of(&args.case.file) == FileType::System {
        return system(args);
    }
    let inputs = [args.case.file.clone()];
    let file = OutputFile::check(
        args.page.table.output.as_deref(),
        args.page.table.force,
        &inputs,
    )?;
    let (base, case) = base_case(&args.case.file, &args.case.set)?;
    let results = results(&case, &args.result)?;
    let variation = Variation::grid(base, &args.vary);
    let variation = variation.map_err(|error| CommandError::Usage(error.to_string()))?;
    let stop = StopFlag::listen()?;
    let root = (!args.no_store).then(|| Path::new(store::DEFAULT_ROOT));
    let outcomes = compute(variation.requests(), root, &stop);
    let view = VariationView::of_case(&variation, &outcomes, &results);
    let mut tables = view.tables(output::page_width(args.page.width));
    let stored = outcomes
        .iter()
        .flatten()
        .flatten()
        .filter(|run| run.dir.is_some())
        .count();
    if let Some(last) = tables.last_mut().filter(|_| stored > 0) {
        let root = store::DEFAULT_ROOT;
        last.notes
            .push(format!("{stored} runs are stored below {root}."));
    }
    shown(args, file.as_ref(), (&view, &tables), &stop)
}

/// `seacable study vary` on a system of lines, whose equilibria are not stored.
fn system(args: &VaryArgs) -> Result<ExitCode, CommandError> {
    let path = &args.case.file;
    let inputs = [path.clone()];
    let table = &args.page.table;
    let file = OutputFile::check(table.output.as_deref(), table.force, &inputs)?;
    let loaded = kind::load_as::<SystemFile>(path, &args.case.import.options())
        .map_err(CommandError::Invalid)?;
    let edits = cases::edits(&args.case.set)?;
    let (text, solved) = cases::set_and_compute::<SystemFile>(&loaded.whole_text, &edits, path)?;
    let results = match args.result.is_empty() {
        true => quantities::main_results(&solved),
        false => args.result.clone(),
    };
    if let Some(why) = results
        .iter()
        .find_map(|name| quantities::value(&solved, name).err())
    {
        return Err(CommandError::Usage(format!("--result: {why}")));
    }
    let base = BaseCase {
        text,
        path: path.display().to_string(),
        overrides: args.case.set.clone(),
    };
    let variation = Variation::of_system(base, &args.vary)
        .map_err(|error| CommandError::Usage(error.to_string()))?;
    let stop = StopFlag::listen()?;
    let line = Mutex::new(progress::ProgressLine::new());
    let outcomes = vary::system::compute(&variation, &results, stop.cancel(), &|done, of| {
        if let Ok(mut line) = line.lock() {
            line.show(&format!("{done} of {of} points computed"));
        }
    });
    drop(line);
    let view = VariationView::of_system(&variation, &outcomes, &results);
    let tables = view.tables(output::page_width(args.page.width));
    shown(args, file.as_ref(), (&view, &tables), &stop)
}

/// Prints a variation; the exit status says whether all of it was computed.
fn shown(
    args: &VaryArgs,
    file: Option<&OutputFile<'_>>,
    (view, tables): (&VariationView<'_>, &[Table]),
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let tables_and_csv = (tables, &view.csv_table());
    print("vary", &args.page, file, tables_and_csv, &view.charts())?;
    if let Some(status) = stop.status() {
        output::message("Stopped before all points were computed.");
        return Ok(status);
    }
    Ok(if view.is_complete() {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    })
}

/// Computes points with a line of progress.
fn compute(
    requests: Vec<PointRequest>,
    store: Option<&Path>,
    stop: &StopFlag,
) -> Vec<Option<PointOutcome>> {
    let line = Mutex::new(progress::ProgressLine::new());
    points::compute(requests, store, stop.cancel(), &|progress| {
        if let Ok(mut line) = line.lock() {
            line.show(&format!(
                "{} of {} points computed",
                progress.done, progress.of
            ));
        }
    })
}
