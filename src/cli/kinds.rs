//! What each kind of file gives the command line: its keys, and its comparison with published values.

use std::{path::Path, sync::atomic::AtomicBool};

use super::{
    CommandError,
    cases::{self, OtherFile},
};
use seacable_model::case::{CASE, fields::Schema, kind};
use seacable_model::kinds::FileType;
use seacable_model::section::{self, CrossSection, SECTION};
use seacable_runs::reference::{self, ValidationRow};
use seacable_systems::ropeway::{self, ROPEWAY, Ropeway};
use seacable_systems::ship::{self, MotionAnalysis, SHIP, Ship};
use seacable_systems::system::{
    self, SYSTEM, SolvedSystem, SystemFile,
    motion::{self, run::MotionRun},
    results_in_time::has_published_in_time,
};

/// The tables and keys of a kind.
pub(super) fn schema(kind: FileType) -> &'static Schema {
    match kind {
        FileType::Line => &CASE,
        FileType::Section => &SECTION,
        FileType::Ropeway => &ROPEWAY,
        FileType::Ship => &SHIP,
        FileType::System => &SYSTEM,
    }
}

/// Title and validation of a file that is computed without a run.
pub(super) fn validation(
    file: &OtherFile,
    set: &[(&str, &str)],
    cancel: &AtomicBool,
) -> Result<(String, Vec<ValidationRow>), CommandError> {
    let OtherFile { kind, name, text } = file;
    let before = text;
    let path = Path::new(name);
    Ok(match kind {
        FileType::Ropeway => {
            let (text, solved) = &cases::set_and_compute::<Ropeway>(text, set, path)?;
            let mut rows = ropeway::validation::rows(solved, text);
            let (_, edited) = kind::edited_rows::<Ropeway>(text, before);
            reference::set_edited_aside(&mut rows, &edited);
            (solved.ropeway.about.title.clone(), rows)
        }
        FileType::Ship => {
            let (text, statics) = &cases::set_and_compute::<Ship>(text, set, path)?;
            let folder = path.parent().unwrap_or(Path::new(""));
            let motion = MotionAnalysis::of_statics(statics, folder);
            let mut rows = ship::validation::rows(&statics.ship, motion.as_ref());
            let (_, edited) = kind::edited_rows::<Ship>(text, before);
            reference::set_edited_aside(&mut rows, &edited);
            (statics.ship.ship.title.clone(), rows)
        }
        FileType::System => {
            let (text, solved) = &cases::set_and_compute::<SystemFile>(text, set, path)?;
            let run = in_time(solved, cancel)?;
            let mut rows = system::validation::rows(solved, run.as_ref());
            let (_, edited) = kind::edited_rows::<SystemFile>(text, before);
            reference::set_edited_aside(&mut rows, &edited);
            (solved.file.about.title.clone(), rows)
        }
        FileType::Section => {
            let (text, design) = &cases::set_and_compute::<CrossSection>(text, set, path)?;
            let mut rows = section::validation::rows(design);
            let (_, edited) = kind::edited_rows::<CrossSection>(text, before);
            reference::set_edited_aside(&mut rows, &edited);
            (design.section.about.title.clone(), rows)
        }
        FileType::Line => (String::new(), Vec::new()),
    })
}

/// The run in time of a system that has values or curves to be held against it.
fn in_time(solved: &SolvedSystem, cancel: &AtomicBool) -> Result<Option<MotionRun>, CommandError> {
    let given = solved.file.in_time();
    let Some(given) = given.filter(|_| has_published_in_time(&solved.file)) else {
        return Ok(None);
    };
    let run = motion::run::run(solved, given, cancel, &mut |_| {});
    run.map(Some)
        .map_err(|why| CommandError::Usage(format!("{}; {}.", why.problem, why.remedy)))
}
