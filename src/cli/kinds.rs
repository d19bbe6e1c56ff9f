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
    SYSTEM, SystemFile,
    validated::{NotValidated, validated},
    validation::set_edited_aside,
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
            let (text, solved) = cases::set_and_compute::<SystemFile>(text, set, path)?;
            let (_, edited) = kind::edited_rows::<SystemFile>(&text, before);
            let file = solved.file.clone();
            let mut rows = validated(solved, &text, name, cancel).map_err(not_validated)?;
            set_edited_aside(&mut rows, &file, &edited);
            (file.about.title, rows)
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

fn not_validated(why: NotValidated) -> CommandError {
    match why {
        NotValidated::Invalid(found) => CommandError::Invalid(found),
        NotValidated::Unsolved(why) => {
            CommandError::Usage(format!("{}; {}.", why.problem, why.remedy))
        }
    }
}
