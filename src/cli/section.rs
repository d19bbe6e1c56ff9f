//! `seacable section`: a cable's cross-section.

use std::process::ExitCode;

use super::{
    CommandError,
    args::SectionArgs,
    output::{self, Format, OutputFile},
};
use crate::{
    report::{self, plain},
    section,
};

/// Columns of the page.
const WIDTH: usize = 100;

pub(super) fn section(args: &SectionArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.file.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let loaded = section::load(&args.file).map_err(CommandError::invalid_file(&args.file))?;
    let glyphs = output::glyphs(args.ascii);
    if let Some(file) = file {
        let text = section::material_table(&loaded.worked);
        let text = if args.ascii {
            plain::ascii(&text).into_owned()
        } else {
            text
        };
        file.write(text.as_bytes(), Format::Toml)?;
    }
    let text = report::section::report(&loaded.worked, WIDTH, glyphs, args.tension_n);
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}
