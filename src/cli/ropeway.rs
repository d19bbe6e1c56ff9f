//! `seacable ropeway`: a ropeway between a platform and a ship.

use std::process::ExitCode;

use super::{
    Failure,
    args::RopewayWords,
    cases,
    output::{self, OutputFile},
};
use crate::{
    report::chart::Glyphs,
    ropeway::{self, Readings, Worked, edit, exact::Carrier, line},
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
    let readings = worked
        .readings(worked.ropeway.cargo.position)
        .map_err(|trouble| Failure::Usage(format!("The ropeway has no answer: {trouble}.")))?;
    if let Some(file) = file {
        write(&file, &worked, &readings)?;
    }
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    let report = ropeway::text::text(&worked, &readings, &text, glyphs);
    output::results(&report, words.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// Writes the rope with the cargo on it as a line case.
fn write(file: &OutputFile<'_>, worked: &Worked, readings: &Readings) -> Result<(), Failure> {
    if readings.exact.carrier != Carrier::Rope {
        return Err(Failure::Usage(
            "The cargo hangs on a support, so there is no line with a cargo to write; set cargo.position between 0 and 1."
                .to_owned(),
        ));
    }
    let text = line::case_text(&worked.ropeway, readings.length_m, readings.exact.arc_m);
    file.write(text.as_bytes())
}
