//! `seacable section`: a cable's cross-section.

use std::process::ExitCode;

use super::{
    CommandError, cases,
    model_args::SectionArgs,
    output::{self, FileFormat, OutputFile},
};
use seacable_display::plain;
use seacable_foreign::import::ImportOptions;
use seacable_model::kinds::FileBytes;
use seacable_model::section::{self, CrossSection};
use seacable_report::{self as report, text::WIDTH};

pub(super) fn section(args: &SectionArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.file.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let (fields, design) = cases::load_with::<CrossSection>(
        FileBytes::read(&args.file),
        &[],
        &ImportOptions::default(),
    )?;
    let glyphs = output::glyphs(args.ascii);
    if let Some(file) = file {
        let text = section::material_table(&design);
        let text = if args.ascii {
            plain::ascii(&text).into_owned()
        } else {
            text
        };
        file.write(text.as_bytes(), FileFormat::Toml)?;
    }
    let text = report::section::report(&design, &fields, args.tension_n).to_text(WIDTH, glyphs);
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}
