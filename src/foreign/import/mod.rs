//! Files of other programs, read as they are: MoorDyn of both versions, MoorPy, MAP++, designs of RAFT and of the IEA ontology.
//!
//! A reader makes a [`mooring::Mooring`] of a file, in which each value knows where it stands; [`to_case`] makes the text of a case of
//! it, with a comment for each row that values come from. Computing a file is computing that text, so that both give the same bits.

pub mod beside;
pub mod cable_dyn;
pub mod fault;
mod imported;
pub mod index;
pub mod line_case;
pub mod listing;
pub mod map_plus_plus;
pub mod moordyn;
pub mod mooring;
pub mod size;
pub mod to_case;
pub mod words;
pub mod yaml;

use std::path::{Path, PathBuf};

use self::mooring::Mooring;
use crate::case::Diagnostic;
use crate::kinds::FileBytes;
use crate::kinds::foreign::{is_design, is_named_yaml};
pub use crate::kinds::foreign::{is_foreign, is_foreign_file};
pub use imported::{ImportOptions, Imported};

/// Whether a file is a design in YAML rather than a file with rows of dashes.
fn is_yaml(path: &Path, text: &str) -> bool {
    let has_sections = || {
        let sections = moordyn::sections::Sections::of_text(text, 0);
        !sections.blocks.is_empty()
    };
    is_named_yaml(path) || is_design(text) && !has_sections()
}

/// Where the case of a file is saved: a case onto itself, one of another program beside its file.
#[must_use]
pub fn case_path(path: &Path) -> PathBuf {
    case_path_of(&FileBytes::read(path))
}

/// The same of a file that was read.
#[must_use]
pub fn case_path_of(file: &FileBytes) -> PathBuf {
    match file.is_foreign() {
        true => file.path().with_extension("toml"),
        false => file.path().to_owned(),
    }
}

/// The mooring of a file of another program with this text.
///
/// # Errors
/// All that is wrong with it, each at its row and column.
pub fn mooring(text: &str, file: &str) -> Result<Mooring, Vec<Diagnostic>> {
    let path = Path::new(file);
    let folder = path.parent().unwrap_or(Path::new(""));
    let read = match is_yaml(path, text) {
        true => yaml::read(text, folder),
        false => moordyn::read(text, folder),
    };
    read.map_err(|faults| fault::diagnostics(faults, file, text))
}

/// The case of a file of another program with this text.
///
/// # Errors
/// All that is wrong with it or not modelled, each at its row and column.
pub fn read(text: &str, file: &str, options: &ImportOptions) -> Result<Imported, Vec<Diagnostic>> {
    let mooring = mooring(text, file)?;
    let path = Path::new(file);
    let name = path
        .file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy();
    let case = to_case::case_of(&mooring, text, &name, options);
    case.map_err(|faults| fault::diagnostics(faults, file, text))
}
