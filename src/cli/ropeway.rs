//! `seacable ropeway`: a ropeway between a platform and a ship.

use std::process::ExitCode;

use super::{
    CommandError, cases,
    model_args::RopewayArgs,
    output::{self, FileFormat, OutputFile},
};
use seacable_foreign::import::ImportOptions;
use seacable_model::kinds::FileBytes;
use seacable_report::{self as report, text::WIDTH};
use seacable_systems::ropeway::{ModelResults, Ropeway, SolvedRopeway, elastic::Carrier, line};

pub(super) fn ropeway(args: &RopewayArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.file.clone()];
    let file = OutputFile::check_option("--line", args.line.as_deref(), args.force, &inputs)?;
    let (fields, worked) = cases::load_with::<Ropeway>(
        FileBytes::read(&args.file),
        &args.set,
        &ImportOptions::default(),
    )?;
    let results = worked
        .results(worked.ropeway.cargo.position)
        .map_err(|error| CommandError::Usage(format!("The ropeway has no solution: {error}.")))?;
    if let Some(file) = file {
        write(&file, &worked, &results)?;
    }
    let glyphs = output::glyphs(args.ascii);
    let report = report::ropeway::report(&worked, &results, &fields);
    let text = report.to_text(WIDTH, glyphs);
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// Writes the rope with the cargo on it as a line case.
fn write(
    file: &OutputFile<'_>,
    worked: &SolvedRopeway,
    results: &ModelResults,
) -> Result<(), CommandError> {
    if results.exact.carrier != Carrier::Rope {
        return Err(CommandError::Usage(
            "The cargo hangs on a support, so there is no line with a cargo to write; set cargo.position between 0 and 1."
                .to_owned(),
        ));
    }
    let text = line::static_case_file(&worked.ropeway, results.length_m, results.exact.arc_m);
    file.write(text.as_bytes(), FileFormat::Toml)
}
