//! What is asked of an import, and what it gives.

use super::{beside::ReferencedFile, fault::Fault};
use crate::case::Diagnostic;
use std::{
    collections::BTreeMap,
    ops::Range,
    path::{Path, PathBuf},
};

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
    pub beside: Option<ReferencedFile>,
    /// Of a file with keys, their paths by the bytes where their values begin.
    pub keys: BTreeMap<usize, String>,
}

impl Imported {
    /// A diagnostic of the case at the row of the file that it comes from.
    #[must_use]
    pub fn at_its_row(&self, found: &Diagnostic, file: &str, source: &str) -> Diagnostic {
        let line = found.line.max(1) as usize;
        let here = self.from.iter().take(line).rev();
        let span = here.flatten().next().cloned().unwrap_or(0..0);
        let key = self.keys.get(&span.start).unwrap_or(&found.key);
        let fault = Fault::new(span, key, &found.problem, &*found.remedy);
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
