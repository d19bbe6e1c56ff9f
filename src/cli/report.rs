//! `seacable report`: the text report of a stored run.

use std::process::ExitCode;

use super::{
    CommandError,
    args::ReportArgs,
    cases,
    output::{self, FileFormat, OutputFile},
};
use crate::{
    reference,
    report::{chart::Glyphs, text},
    run::store,
};

pub(super) fn report(args: &ReportArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.dir.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let run = store::read(&args.dir)?;
    let case = cases::parse(&run.case_text, &run.info.case_file)?;
    let rows = reference::rows_of_run(&run, &case);
    // A file is the same whatever the terminal shows.
    let glyphs = match (&file, args.ascii) {
        (Some(_), false) => Glyphs::Braille,
        (_, ascii) => output::glyphs(ascii),
    };
    let text = text::report(&run, &case, &rows, glyphs);
    match file {
        None => output::results(&text, args.ascii)?,
        Some(file) => {
            let page = output::page(&text, args.ascii);
            file.write(page.as_bytes(), FileFormat::Text)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
