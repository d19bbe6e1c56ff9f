//! `seacable section`: a cable's cross-section.

use std::{fs, process::ExitCode};

use super::{
    Failure,
    args::SectionWords,
    output::{self, OutputFile},
};
use crate::{
    report::{self, chart::Glyphs, plain},
    section,
};

/// Columns of the page.
const WIDTH: usize = 100;

pub(super) fn section(words: &SectionWords) -> Result<ExitCode, Failure> {
    let inputs = [words.file.clone()];
    let file = OutputFile::check(words.output.as_deref(), words.force, &inputs)?;
    let loaded = section::load(&words.file).map_err(|diagnostics| Failure::Case {
        text: fs::read_to_string(&words.file).unwrap_or_default(),
        diagnostics,
    })?;
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    if let Some(file) = file {
        let text = section::fragment(&loaded.worked);
        let text = if words.ascii {
            plain::ascii(&text).into_owned()
        } else {
            text
        };
        file.write(text.as_bytes())?;
    }
    let text = report::section::report(&loaded.worked, WIDTH, glyphs, words.tension_n);
    output::results(&text, words.ascii)?;
    Ok(ExitCode::SUCCESS)
}
