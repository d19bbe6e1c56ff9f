//! Systems as files of other programs: MoorDyn 2 and MAP++.
//!
//! A system at rest becomes the rows of a [`sheet::Sheet`]; a writer of a program makes its text of them. What the program cannot say and
//! would change results is refused, all at once; what it cannot say and changes none is named beside the text. Numbers have twelve
//! significant digits, so that a file that was written, read and written again is the same text.

mod attachments;
pub mod lines;
pub mod map_plus_plus;
pub mod materials;
pub mod moordyn;
pub mod number;
pub mod parts;
pub mod refusals;
pub mod sea;
pub mod sheet;
mod target;

use crate::system::SolvedSystem;
pub use target::{ExportOptions, Target, Unsayable};

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

/// The file of a system.
///
/// # Errors
/// All that the file cannot say and that changes results.
pub fn export(
    solved: &SolvedSystem,
    target: Target,
    options: ExportOptions,
) -> Result<Exported, Vec<Unsayable>> {
    let written_out = attachments::written_out(solved).map_err(|found| {
        let name = target.name();
        let in_words = |one: Unsayable| Unsayable {
            what: format!("a file of {name} has no {}", one.what),
            ..one
        };
        found.into_iter().map(in_words).collect::<Vec<_>>()
    })?;
    let solved = written_out.as_ref();
    let mut refused = refusals::refusals(solved, target);
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
