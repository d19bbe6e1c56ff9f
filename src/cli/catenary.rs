//! `seacable catenary`: a table of lines at rest.

use seacable_base::visible;
use std::process::ExitCode;

use super::{
    BAD_RESULT, CommandError,
    args::CatenaryArgs,
    output::{self, FileFormat, OutputFile},
};
use seacable_base::files::read;
use seacable_studies::study::lines;

pub(super) fn catenary(args: &CatenaryArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.input.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let input = visible::path(&args.input);
    let bytes = read::bytes(&args.input)
        .map_err(|e| CommandError::Usage(format!("Reading {input} failed: {e}")))?;
    let table = lines::solve(&bytes).map_err(|e| CommandError::Usage(format!("{input}: {e}")))?;
    let format = match table.text.trim_ascii_start().first() {
        Some(b'{') => FileFormat::Json,
        _ => FileFormat::Text,
    };
    match file {
        None => output::document(&table.text, format)?,
        Some(file) => file.write(&table.text, format)?,
    }
    if table.refused == 0 {
        return Ok(ExitCode::SUCCESS);
    }
    output::message(&format!(
        "{} of {} lines have no answer; the column status says why.",
        table.refused, table.rows
    ));
    Ok(ExitCode::from(BAD_RESULT))
}
