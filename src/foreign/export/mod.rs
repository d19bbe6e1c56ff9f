//! Systems as files of other programs: MoorDyn 2 and MAP++.
//!
//! A system at rest becomes the rows of a [`sheet::Sheet`]; a writer of a program makes its text of them. What the program cannot say and
//! would change results is refused, all at once; what it cannot say and changes none is named beside the text. Numbers have twelve
//! significant digits, so that a file that was written, read and written again is the same text.

pub mod lines;
pub mod map_plus_plus;
pub mod materials;
pub mod moordyn;
pub mod number;
pub mod parts;
pub mod refusals;
pub mod sea;
pub mod sheet;

use crate::system::SolvedSystem;

/// The programs whose files are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// MoorDyn, version 2.
    MoorDyn,
    /// MAP++.
    MapPlusPlus,
}

impl Target {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::MoorDyn => "MoorDyn",
            Self::MapPlusPlus => "MAP++",
        }
    }
}

/// What is said about an export.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ExportOptions {
    /// Free points and bodies are written where they rest, not where the search for it begins.
    pub at_rest: bool,
}

/// A file of another program.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Exported {
    /// Its text.
    pub text: String,
    /// Files that it names, which belong beside it: name and text.
    pub files: Vec<(String, String)>,
    /// What it does not say, or says in another way.
    pub remarks: Vec<String>,
}

/// Something of a system that a file cannot say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unsayable {
    /// The key, such as `lines.a.release_a_s`.
    pub key: String,
    /// Why.
    pub what: String,
}

/// The file of a system.
///
/// # Errors
/// All that the file cannot say and that changes results.
pub fn export(
    solved: &SolvedSystem,
    target: Target,
    options: ExportOptions,
) -> Result<Exported, Vec<Unsayable>> {
    let mut refused = refusals::of(solved, target);
    let sheet = parts::sheet(solved, target, options, &mut refused);
    if !refused.is_empty() {
        return Err(refused);
    }
    let text = match target {
        Target::MoorDyn => moordyn::text(&sheet),
        Target::MapPlusPlus => map_plus_plus::text(&sheet),
    };
    Ok(Exported {
        text,
        files: sheet.files,
        remarks: sheet.remarks,
    })
}
