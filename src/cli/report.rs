//! `seacable report`: the text report of a stored run.

use std::process::ExitCode;

use super::{
    CommandError,
    args::ReportArgs,
    cases,
    output::{self, FileFormat, OutputFile},
};
use crate::{
    comparison::Comparison,
    reference,
    report::{chart::Glyphs, comparison, text},
    run::store,
};

pub(super) fn report(args: &ReportArgs) -> Result<ExitCode, CommandError> {
    let inputs: Vec<_> = [Some(args.dir.clone()), args.against.clone()]
        .into_iter()
        .flatten()
        .collect();
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let run = store::read(&args.dir)?;
    let case = cases::parse(&run.case_text, &run.info.case_file)?;
    let rows = reference::rows_of_run(&run, &case);
    // A file is the same whatever the terminal shows.
    let glyphs = match (&file, args.ascii) {
        (Some(_), false) => Glyphs::Braille,
        (_, ascii) => output::glyphs(ascii),
    };
    let mut text = text::report(&run, &case, &rows, glyphs);
    if let Some(dir) = &args.against {
        let other = store::read(dir)?;
        let compared = Comparison::of(&[&other, &run]);
        text.push_str(&format!("\n{}", comparison::report_section(&compared)));
        let curves = comparison::charts(&[&other, &run], text::WIDTH, glyphs);
        text.push_str(&curves);
    }
    match file {
        None => output::results(&text, args.ascii)?,
        Some(file) => {
            let page = output::page(&text, args.ascii);
            file.write(page.as_bytes(), FileFormat::Text)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
