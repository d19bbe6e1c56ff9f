//! `seacable ship`: a ship at single-point mooring.

use std::process::ExitCode;

use super::{Failure, args::ShipWords, cases, output};
use crate::{
    report::chart::Glyphs,
    ship::{self, edit},
};

/// Columns of the page.
const WIDTH: usize = 100;

pub(super) fn ship(words: &ShipWords) -> Result<ExitCode, Failure> {
    let mut text = ship::text_of(&words.file).map_err(|diagnostics| Failure::Case {
        text: String::new(),
        diagnostics,
    })?;
    for (key, value) in cases::edits(&words.set)? {
        text = edit::set(&text, key, value).map_err(|diagnostics| Failure::Case {
            text: String::new(),
            diagnostics,
        })?;
    }
    let loaded = ship::read(text.clone(), &words.file)
        .map_err(|diagnostics| Failure::Case { text, diagnostics })?;
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    let page = ship::text::text(&loaded.rest, loaded.rope.as_ref(), WIDTH, glyphs);
    output::results(&page, words.ascii)?;
    Ok(ExitCode::SUCCESS)
}
