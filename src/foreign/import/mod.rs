//! Files of other programs, read as they are: MoorDyn of both versions, MoorPy, MAP++, designs of RAFT and of the IEA ontology.
//!
//! A reader makes a [`mooring::Mooring`] of a file, in which each value knows where it stands; [`to_case`] makes the text of a case of
//! it, with a comment for each row that values come from. Computing a file is computing that text, so that both give the same bits.

pub mod beside;
pub mod cable_dyn;
pub mod fault;
pub mod index;
pub mod listing;
pub mod map_plus_plus;
pub mod moordyn;
pub mod mooring;
pub mod size;
pub mod to_case;
pub mod words;
pub mod yaml;

use std::ops::Range;
use std::path::{Path, PathBuf};

use self::beside::Beside;
use self::fault::Fault;
use self::mooring::Mooring;
use crate::case::Diagnostic;
use crate::files;
use crate::kinds::foreign::{is_design, is_named_yaml};
pub use crate::kinds::foreign::{is_foreign, is_foreign_file};

/// What is said about a file besides its text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ImportOptions {
    /// Names of what is left out that is not modelled.
    pub without: Vec<String>,
    /// Depth of the bed \[m\] in the place of the file's.
    pub depth: Option<f64>,
    /// Density of the water \[kg/m³\] in the place of the file's.
    pub density: Option<f64>,
    /// Gravity \[m/s²\] in the place of the file's.
    pub gravity: Option<f64>,
    /// A table of the motion of coupled parts.
    pub motion: Option<PathBuf>,
}

impl ImportOptions {
    /// Whether nothing is said.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// The case of a file of another program.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The text of the case.
    pub text: String,
    /// Of each of its lines, the bytes of the file that it comes from.
    pub from: Vec<Option<Range<usize>>>,
    /// A file beside it that its lines are in.
    pub beside: Option<Beside>,
}

impl Imported {
    /// A diagnostic of the case at the row of the file that it comes from.
    #[must_use]
    pub fn at_its_row(&self, found: &Diagnostic, file: &str, source: &str) -> Diagnostic {
        let line = found.line.max(1) as usize;
        let here = self.from.iter().take(line).rev();
        let span = here.flatten().next().cloned().unwrap_or(0..0);
        let fault = Fault::new(span, &found.key, &found.problem, &*found.remedy);
        if let Some(named) = self.named(found) {
            return named.diagnostic(file, source);
        }
        let beside = self.beside.as_ref();
        let fault = match beside.filter(|beside| beside.holds(&fault.span)) {
            Some(beside) => beside.at_its_name(&fault, &fault.key),
            None => fault,
        };
        fault.diagnostic(file, source)
    }

    /// The fault of a file that the case carries with it, such as depths over a grid, where the source names that file.
    fn named(&self, found: &Diagnostic) -> Option<Fault> {
        let name = Path::new(&found.file).file_name()?.to_str()?;
        let mut rows = self.text.lines().zip(&self.from);
        let (_, from) = rows.find(|(row, _)| row.contains("depth_file") && row.contains(name))?;
        let at = match found.line {
            0 => String::new(),
            line => format!(", line {line}, column {}", found.column),
        };
        Some(Fault::new(
            from.clone()?,
            "OPTIONS, SeafloorFile",
            format!("in `{name}`{at}: {}", found.problem),
            &*found.remedy,
        ))
    }
}

/// Whether a file is a design in YAML rather than a file with rows of dashes.
fn is_yaml(path: &Path, text: &str) -> bool {
    let has_sections = || {
        let sections = moordyn::sections::Sections::of(text, 0);
        !sections.blocks.is_empty()
    };
    is_named_yaml(path) || is_design(text) && !has_sections()
}

/// Where the case of a file is saved: a case onto itself, one of another program beside its file.
#[must_use]
pub fn case_path(path: &Path) -> PathBuf {
    let is_foreign = files::read::text_lossy(path).is_ok_and(|text| is_foreign_file(path, &text));
    match is_foreign {
        true => path.with_extension("toml"),
        false => path.to_owned(),
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
