//! `seacable study effects`: which inputs matter to a result.

use seacable_base::visible;
use std::{process::ExitCode, time::Instant};

use super::{
    CommandError,
    output::{self, OutputFile},
    signals::StopFlag,
    study_args::EffectsArgs,
    study_page::{StudiedFile, print, studied_file, variants_told},
};
use seacable_base::number::duration;
use seacable_display::table::Table;
use seacable_model::case::Case;
use seacable_report::effects::TornadoView;
use seacable_studies::study::effects;
use seacable_systems::system::SystemFile;

pub(super) fn effects(args: &EffectsArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.case.file.clone()];
    let table = &args.page.table;
    let file = OutputFile::check(table.output.as_deref(), table.force, &inputs)?;
    let studied = studied_file(&args.case, &args.result)?;
    let stop = StopFlag::listen()?;
    let begun = Instant::now();
    let (found, mut ids) = variants_told(|told| match studied {
        StudiedFile::Line(base, ids) => (effects::compute::<Case>(&base, stop.cancel(), told), ids),
        StudiedFile::System(base, ids) => (
            effects::compute::<SystemFile>(&base, stop.cancel(), told),
            ids,
        ),
    });
    if args.result.is_empty() {
        ids.truncate(1);
    }
    if let Some(status) = stop.status() {
        output::message("Stopped before all variants were computed.");
        return Ok(status);
    }
    let found = found
        .map_err(|why| CommandError::Usage(format!("{}: {why}", visible::path(&args.case.file))))?;
    let mut tables: Vec<Table> = Vec::new();
    let mut csv = Table::default();
    for id in &ids {
        let Some(view) = TornadoView::of_result(&found, id) else {
            let what = format!("--result: the run of the case does not have `{id}`.");
            return Err(CommandError::Usage(what));
        };
        tables.extend([
            view.chart(output::page_width(args.page.width)),
            view.table(),
        ]);
        let rows = view.csv_table();
        csv.columns.clone_from(&rows.columns);
        csv.rows.extend(rows.rows);
    }
    let cost = format!(
        "Cost: {} variants without companion runs, {} of CPU time together; {} of wall time in all.",
        2 * found.inputs.len(),
        duration(found.cpu_s()),
        duration(begun.elapsed().as_secs_f64())
    );
    if let Some(last) = tables.last_mut() {
        last.notes.push(cost);
    }
    print("effects", &args.page, file.as_ref(), (&tables, &csv), &[])?;
    Ok(ExitCode::SUCCESS)
}
