//! `seacable ropeway`: a ropeway between a platform and a ship.

use std::process::ExitCode;

use super::{
    Failure,
    args::RopewayWords,
    cases,
    output::{self, OutputFile},
};
use crate::{
    report::{self, chart::Glyphs},
    ropeway::{self, ModelResults, SolvedRopeway, edit, elastic::Carrier, line},
};

pub(super) fn ropeway(words: &RopewayWords) -> Result<ExitCode, Failure> {
    let inputs = [words.file.clone()];
    let file = OutputFile::check_option("--line", words.line.as_deref(), words.force, &inputs)?;
    let loaded = cases::load_ropeway(&words.file)?;
    let edits = cases::edits(&words.set)?;
    let text = edit::set_all(&loaded.text, &edits).map_err(|diagnostics| Failure::Case {
        text: loaded.text.clone(),
        diagnostics,
    })?;
    let worked =
        ropeway::parse(&text, &words.file.display().to_string()).map_err(|diagnostics| {
            Failure::Case {
                text: text.clone(),
                diagnostics,
            }
        })?;
    let results = worked
        .results(worked.ropeway.cargo.position)
        .map_err(|error| Failure::Usage(format!("The ropeway has no solution: {error}.")))?;
    if let Some(file) = file {
        write(&file, &worked, &results)?;
    }
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    let text = report::ropeway::report(&worked, &results, &text, glyphs);
    output::results(&text, words.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// Writes the rope with the cargo on it as a line case.
fn write(
    file: &OutputFile<'_>,
    worked: &SolvedRopeway,
    results: &ModelResults,
) -> Result<(), Failure> {
    if results.exact.carrier != Carrier::Rope {
        return Err(Failure::Usage(
            "The cargo hangs on a support, so there is no line with a cargo to write; set cargo.position between 0 and 1."
                .to_owned(),
        ));
    }
    let text = line::static_case_file(&worked.ropeway, results.length_m, results.exact.arc_m);
    file.write(text.as_bytes())
}
