//! `seacable study physics`: which effects a case needs.

use seacable_base::visible;
use std::process::ExitCode;

use super::{
    CommandError,
    output::{self, OutputFile},
    signals::StopFlag,
    study_args::EffectsArgs,
    study_page::{StudiedFile, print, studied_file, variants_told},
};
use seacable_model::case::Case;
use seacable_report::physics as report;
use seacable_studies::study::physics;
use seacable_systems::system::SystemFile;

pub(super) fn physics(args: &EffectsArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.case.file.clone()];
    let table = &args.page.table;
    let file = OutputFile::check(table.output.as_deref(), table.force, &inputs)?;
    let studied = studied_file(&args.case, &args.result)?;
    let stop = StopFlag::listen()?;
    let (study, ids) = variants_told(|told| match studied {
        StudiedFile::Line(base, ids) => (physics::compute::<Case>(&base, stop.cancel(), told), ids),
        StudiedFile::System(base, ids) => (
            physics::compute::<SystemFile>(&base, stop.cancel(), told),
            ids,
        ),
    });
    if let Some(status) = stop.status() {
        output::message("Stopped before all variants were computed.");
        return Ok(status);
    }
    let study = study
        .map_err(|why| CommandError::Usage(format!("{}: {why}", visible::path(&args.case.file))))?;
    let tables = [report::table(&study, &ids)];
    print(
        "physics",
        &args.page,
        file.as_ref(),
        (&tables, &report::csv_table(&study, &ids)),
        &[],
    )?;
    Ok(ExitCode::SUCCESS)
}
