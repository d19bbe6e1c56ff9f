//! `seacable ropeway`: a ropeway between a platform and a ship.

use std::{fs, path::Path, process::ExitCode};

use super::{Failure, args::RopewayWords, cases, output};
use crate::{
    report::{self, chart::Glyphs},
    ropeway::{self, ModelResults, SolvedRopeway, edit, elastic::Carrier, line},
};

pub(super) fn ropeway(words: &RopewayWords) -> Result<ExitCode, Failure> {
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
    if let Some(path) = &words.line {
        write(path, &worked, &results)?;
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

/// Writes the line case to a new file; one that is there is left as it is.
fn write(path: &Path, worked: &SolvedRopeway, results: &ModelResults) -> Result<(), Failure> {
    if results.exact.carrier != Carrier::Rope {
        return Err(Failure::Usage(
            "The cargo hangs on a support, so there is no line with a cargo to write; set cargo.position between 0 and 1."
                .to_owned(),
        ));
    }
    if path.symlink_metadata().is_ok() {
        return Err(Failure::Usage(format!(
            "{} is there already, and is left as it is; name another file.",
            path.display()
        )));
    }
    let text = line::static_case_file(&worked.ropeway, results.length_m, results.exact.arc_m);
    fs::write(path, text).map_err(|source| Failure::Write {
        path: path.to_owned(),
        source,
    })
}
