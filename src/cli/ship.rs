//! `seacable ship`: a ship at single-point mooring.

use std::{fs, path::Path, process::ExitCode, sync::atomic::AtomicBool};

use super::{Failure, args::ShipWords, cases, output};
use crate::{
    report::{chart::Glyphs, ship::text},
    ship::{self, DynamicAnalysis, MotionError, edit},
};

pub(super) fn ship(words: &ShipWords) -> Result<ExitCode, Failure> {
    let wrong = |text: &str| {
        let text = text.to_owned();
        move |diagnostics| Failure::Case { text, diagnostics }
    };
    let of_file = fs::read_to_string(&words.file).unwrap_or_default();
    let loaded = ship::load(&words.file).map_err(wrong(&of_file))?;
    let edits = cases::edits(&words.set)?;
    let text = edit::set_all(&loaded.text, &edits).map_err(wrong(&loaded.text))?;
    let rest = ship::parse(&text, &words.file.display().to_string()).map_err(wrong(&text))?;
    let folder = words.file.parent().unwrap_or(Path::new(""));
    let sea = DynamicAnalysis::of(&rest, folder, &AtomicBool::new(false));
    if let Some(Some(Err(MotionError::File(diagnostic)))) = sea.as_ref().map(|sea| &sea.motion) {
        let text = fs::read_to_string(&diagnostic.file).unwrap_or_default();
        return Err(wrong(&text)(vec![diagnostic.clone()]));
    }
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    let page = text::text(&rest, sea.as_ref(), &text, glyphs);
    output::results(&page, words.ascii)?;
    Ok(ExitCode::SUCCESS)
}
