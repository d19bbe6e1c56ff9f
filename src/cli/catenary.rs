//! `seacable catenary`: a table of lines at rest.

use std::{fs, process::ExitCode};

use super::{
    Failure, NOT_GOOD,
    args::CatenaryWords,
    output::{self, OutputFile},
};
use crate::study::lines;

pub(super) fn catenary(words: &CatenaryWords) -> Result<ExitCode, Failure> {
    let inputs = [words.input.clone()];
    let file = OutputFile::check(words.output.as_deref(), words.force, &inputs)?;
    let input = words.input.display();
    let bytes = fs::read(&words.input)
        .map_err(|e| Failure::Usage(format!("Reading {input} failed: {e}")))?;
    let table = lines::solve(&bytes).map_err(|e| Failure::Usage(format!("{input}: {e}")))?;
    match file {
        None => output::bytes(&table.text)?,
        Some(file) => file.write(&table.text)?,
    }
    if table.refused == 0 {
        return Ok(ExitCode::SUCCESS);
    }
    output::message(&format!(
        "{} of {} lines have no answer; the column status says why.",
        table.refused, table.rows
    ));
    Ok(ExitCode::from(NOT_GOOD))
}
