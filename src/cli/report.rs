//! `seacable report`: the text report of a stored run.

use std::{fs, process::ExitCode};

use super::{Failure, args::ReportWords, cases, output};
use crate::{
    reference,
    report::{chart::Glyphs, plain, text},
    run::store,
};

pub(super) fn report(words: &ReportWords) -> Result<ExitCode, Failure> {
    let run = store::read(&words.dir)?;
    let case = cases::parse(&run.case_text, &run.info.case_file)?;
    let rows = reference::rows_of_run(&run, &case);
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    let text = text::report(&run, &case, &rows, glyphs);
    match &words.output {
        None => output::results(&text, words.ascii)?,
        Some(path) => {
            let text = if words.ascii {
                plain::ascii(&text)
            } else {
                text.into()
            };
            fs::write(path, text.as_bytes()).map_err(|source| Failure::Write {
                path: path.clone(),
                source,
            })?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
