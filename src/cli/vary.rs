//! `seacable study vary`: a case over ranges of its keys.

use std::{path::Path, process::ExitCode, sync::Mutex};

use super::{
    BAD_RESULT, CommandError,
    output::{self, OutputFile},
    progress,
    signals::StopFlag,
    study_args::VaryArgs,
    study_page::{base_case, print, results},
};
use crate::report::variation::VariationView;
use crate::run::store;
use crate::study::points::{self, PointOutcome, PointRequest};
use crate::study::vary::Variation;

pub(super) fn vary(args: &VaryArgs) -> Result<ExitCode, CommandError> {
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
    print(
        "vary",
        &args.page,
        file.as_ref(),
        (&tables, &view.csv_table()),
        &view.charts(),
    )?;
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
