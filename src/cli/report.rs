//! `seacable report`: the text report of a stored run.

use std::process::ExitCode;

use super::{
    CommandError,
    args::ReportArgs,
    output::{self, FileFormat, OutputFile},
};
use crate::{
    case,
    comparison::Comparison,
    kinds::FileType,
    reference,
    report::{
        chart::Glyphs,
        comparison,
        document::Report,
        system::motion,
        text::{self, WIDTH},
    },
    run::{Run, store},
};

pub(super) fn report(args: &ReportArgs) -> Result<ExitCode, CommandError> {
    let inputs: Vec<_> = [Some(args.dir.clone()), args.against.clone()]
        .into_iter()
        .flatten()
        .collect();
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let run = store::read(&args.dir)?;
    // A file is the same whatever the terminal shows.
    let glyphs = match (&file, args.ascii) {
        (Some(_), false) => Glyphs::Braille,
        (_, ascii) => output::glyphs(ascii),
    };
    let mut report = of_run(&run)?;
    if let Some(dir) = &args.against {
        let other = store::read(dir)?;
        let runs = [&other, &run];
        comparison::add(&mut report, &Comparison::of(&runs), &runs, WIDTH);
    }
    let text = report.to_text(WIDTH, glyphs);
    match file {
        None => output::results(&text, args.ascii)?,
        Some(file) => {
            let page = output::page(&text, args.ascii);
            file.write(page.as_bytes(), FileFormat::Text)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// The report of a run of a line case or of a system of lines.
fn of_run(run: &Run) -> Result<Report, CommandError> {
    let (text, file) = (&run.case_text, &run.info.case_file);
    if FileType::of_text(text) == FileType::System {
        return motion::stored_report(run).map_err(CommandError::Invalid);
    }
    let case = case::parse_stored(text, file).map_err(CommandError::Invalid)?;
    let rows = reference::rows_of_run(run, &case);
    Ok(text::of_run(run, &case, &rows))
}
