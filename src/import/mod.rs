//! Files of other programs, read as they are: MoorDyn of both versions, MoorPy, MAP++.
//!
//! A reader makes a [`mooring::Mooring`] of a file, in which each value knows where it stands; [`to_case`] makes the text of a case of
//! it, with a comment for each row that values come from. Computing a file is computing that text, so that both give the same bits.

pub mod fault;
pub mod map_plus_plus;
pub mod moordyn;
pub mod mooring;
pub mod to_case;
pub mod words;

use std::ops::Range;
use std::path::{Path, PathBuf};

use self::fault::Fault;
use crate::case::Diagnostic;
use crate::files;
use crate::kinds::FileType;

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
}

impl Imported {
    /// A diagnostic of the case at the row of the file that it comes from.
    #[must_use]
    pub fn at_its_row(&self, found: &Diagnostic, source: &str) -> Diagnostic {
        let line = found.line.max(1) as usize;
        let here = self.from.iter().take(line).rev();
        let span = here.flatten().next().cloned().unwrap_or(0..0);
        Fault::new(span, &found.key, &found.problem, &found.remedy).diagnostic(&found.file, source)
    }
}

/// Whether a text is a file of another program rather than a case: rows of dashes, and no table that cases begin with.
#[must_use]
pub fn is_foreign(text: &str) -> bool {
    let lines = || text.lines().map(str::trim_start);
    let is_case = |line: &str| {
        let is_of = |kind: FileType| line.starts_with(&format!("[{}]", kind.table()));
        FileType::ALL.into_iter().any(is_of)
    };
    lines().any(|line| line.starts_with("---")) && !lines().any(is_case)
}

/// Where the case of a file is saved: a case onto itself, one of another program beside its file.
#[must_use]
pub fn case_path(path: &Path) -> PathBuf {
    let is_foreign = files::read_lossy(path).is_ok_and(|text| is_foreign(&text));
    match is_foreign {
        true => path.with_extension("toml"),
        false => path.to_owned(),
    }
}

/// The case of a file of another program with this text.
///
/// # Errors
/// All that is wrong with it or not modelled, each at its row and column.
pub fn read(text: &str, file: &str, options: &ImportOptions) -> Result<Imported, Vec<Diagnostic>> {
    let diagnostics = |faults: Vec<Fault>| {
        let all = faults.iter().map(|fault| fault.diagnostic(file, text));
        all.collect::<Vec<_>>()
    };
    let path = Path::new(file);
    let folder = path.parent().unwrap_or(Path::new(""));
    let mooring = moordyn::read(text, folder).map_err(diagnostics)?;
    let name = path
        .file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy();
    to_case::case_of(&mooring, text, &name, options).map_err(diagnostics)
}
