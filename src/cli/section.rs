//! `seacable section`: a cable's cross-section.

use std::{fs, path::Path, process::ExitCode};

use super::{Failure, args::SectionWords, output};
use crate::{
    report::{self, chart::Glyphs, plain},
    section::{self, FRAGMENT_HEAD},
};

/// Columns of the page.
const WIDTH: usize = 100;

pub(super) fn section(words: &SectionWords) -> Result<ExitCode, Failure> {
    let loaded = section::load(&words.file).map_err(|diagnostics| Failure::Case {
        text: fs::read_to_string(&words.file).unwrap_or_default(),
        diagnostics,
    })?;
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    if let Some(path) = &words.output {
        let text = section::fragment(&loaded.worked);
        let text = if words.ascii {
            plain::ascii(&text).into_owned()
        } else {
            text
        };
        write(path, &text)?;
    }
    let text = report::section::report(&loaded.worked, WIDTH, glyphs, words.tension_n);
    output::results(&text, words.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// Writes a material; a file that was there is replaced only if it is itself one.
fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let there = fs::read(path).unwrap_or_default();
    if !there.is_empty() && !there.starts_with(FRAGMENT_HEAD.as_bytes()) {
        return Err(Failure::Usage(format!(
            "{} is not a material written by this command, and is left as it is; name another file, and paste its table into the line case.",
            path.display()
        )));
    }
    fs::write(path, text).map_err(|source| Failure::Write {
        path: path.to_owned(),
        source,
    })
}
