//! `seacable compare`: stored runs side by side.

use std::{io, process::ExitCode};

use super::{
    CommandError,
    output::{self, FileFormat, OutputFile},
    study_args::CompareArgs,
};
use seacable_report::comparison;
use seacable_runs::run::{Run, store};
use seacable_studies::comparison::Comparison;

pub(super) fn compare(args: &CompareArgs) -> Result<ExitCode, CommandError> {
    let file = OutputFile::check(
        args.page.table.output.as_deref(),
        args.page.table.force,
        &args.runs,
    )?;
    if args.runs.len() < 2 {
        let what = "A comparison needs two runs or more: seacable compare RUN RUN...";
        return Err(CommandError::Usage(what.to_owned()));
    }
    let runs = args.runs.iter().map(|dir| store::read(dir));
    let runs: Vec<Run> = runs.collect::<Result<_, _>>()?;
    let compared = Comparison::of_runs(&runs.iter().collect::<Vec<&Run>>());
    let csv = comparison::csv(&compared).map_err(io::Error::other);
    let csv = csv.map_err(CommandError::Output)?;
    if let Some(file) = &file {
        file.write(&csv, FileFormat::Text)?;
    }
    if args.page.csv {
        output::document(&csv, FileFormat::Text)?;
    } else {
        let width = output::page_width(args.page.width);
        let runs: Vec<&Run> = runs.iter().collect();
        let glyphs = output::glyphs(args.page.table.ascii);
        let text = comparison::report(&compared, &runs, width).to_text(width, glyphs);
        output::results(&text, args.page.table.ascii)?;
    }
    Ok(ExitCode::SUCCESS)
}
