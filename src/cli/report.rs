//! `seacable report`: the text report of a stored run.

use std::process::ExitCode;

use super::{
    Failure,
    args::ReportWords,
    cases,
    output::{self, OutputFile},
};
use crate::{
    reference,
    report::{chart::Glyphs, plain, text},
    run::store,
};

pub(super) fn report(words: &ReportWords) -> Result<ExitCode, Failure> {
    let inputs = [words.dir.clone()];
    let file = OutputFile::check(words.output.as_deref(), words.force, &inputs)?;
    let run = store::read(&words.dir)?;
    let case = cases::parse(&run.case_text, &run.info.case_file)?;
    let rows = reference::rows_of_run(&run, &case);
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    let text = text::report(&run, &case, &rows, glyphs);
    match file {
        None => output::results(&text, words.ascii)?,
        Some(file) => {
            let text = if words.ascii {
                plain::ascii(&text)
            } else {
                text.into()
            };
            file.write(text.as_bytes())?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
