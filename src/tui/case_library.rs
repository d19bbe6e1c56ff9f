//! The shipped cases, and listing a directory of cases.

use std::io;
use std::path::{Path, PathBuf};

use super::state::CaseEntry;
use super::state::reading::{FileTitle, read_title};
use crate::case::{self, render_all};
use crate::kinds::FileType;
use crate::run::store::RUN;
use seacable_base::files::walk::{FileSearch, FoundFiles};
use seacable_base::files::{WriteTarget, disk};

use crate::case::shipped::{BESIDE, BY_KIND};
use crate::places::data_dir;
pub use crate::places::state_dir;

/// The case on which the list opens.
pub const FIRST: &str = "pendulous/manifold.toml";

/// Directories deeper than this below the listed one are not looked into.
const DEPTH: usize = 4;

/// The directory that is listed when the user names none: `cases/` here, else the shipped cases
/// written to the user's data directory. Files that are there already are left alone.
///
/// # Errors
/// When the shipped cases cannot be written.
pub fn default_dir() -> io::Result<PathBuf> {
    let here = PathBuf::from("cases");
    if !files_below(&here).files.is_empty() {
        return Ok(here);
    }
    let dir = data_dir()?.join("cases");
    let by_kind = BY_KIND.iter().flat_map(|(_, files)| *files);
    for (name, text) in by_kind.chain(BESIDE) {
        let path = dir.join(name);
        if !path.exists() {
            if let Some(parent) = path.parent() {
                disk::create_dir_all(parent)?;
            }
            WriteTarget::new(&path).write(text.as_bytes())?;
        }
    }
    Ok(dir)
}

/// The cases of a directory, by path; those that do not pass say why.
#[must_use]
pub fn list(dir: &Path) -> Vec<CaseEntry> {
    let found = files_below(dir);
    let inside = found.files.into_iter().map(|path| {
        let about = about(&path);
        entry(dir, path, about)
    });
    let outside = found.outside.into_iter().map(|path| {
        let line = "a symbolic link that leads outside this directory".to_owned();
        let whole = format!("{line}; --root DIR names a directory in which both lie");
        entry(dir, path, Err((line, whole)))
    });
    let mut all: Vec<CaseEntry> = inside.chain(outside).collect();
    all.sort_by(|one, other| one.path.cmp(&other.path));
    all
}

fn entry(dir: &Path, path: PathBuf, about: About) -> CaseEntry {
    let name = path
        .strip_prefix(dir)
        .unwrap_or(&path)
        .display()
        .to_string();
    CaseEntry { path, name, about }
}

/// Title and source, or what is wrong, in a line and as a whole.
type About = Result<(String, String), (String, String)>;

fn about(path: &Path) -> About {
    match read_title(path) {
        Ok(FileTitle {
            kind,
            title,
            source,
        }) => {
            let name = kind.description().0.trim_start_matches("a ");
            let title = match kind {
                FileType::Line => title,
                _ => format!("{name}: {title}"),
            };
            Ok((title, source))
        }
        Err(all) => {
            let line = all.first().map_or_else(String::new, |d| {
                format!("line {}, column {}: {}", d.line, d.column, d.problem)
            });
            Err((line, story(&all)))
        }
    }
}

/// All that is wrong with a file, with the lines meant.
#[must_use]
pub fn story(all: &[case::Diagnostic]) -> String {
    render_all(all, false)
}

/// The files that may be cases: those of stored runs are none.
fn files_below(dir: &Path) -> FoundFiles {
    let search = FileSearch {
        extension: "toml",
        except_with: RUN,
        depth: DEPTH,
    };
    search.below(dir)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn the_list_opens_on_a_case_that_is_there() {
        assert!(
            case::shipped::SHIPPED
                .iter()
                .any(|(name, _)| *name == FIRST)
        );
    }

    #[test]
    fn a_cross_section_is_listed_as_one() {
        let dir = tempfile::tempdir().unwrap();
        let (name, text) = case::shipped::SECTIONS[0];
        let path = dir.path().join("cable.toml");
        fs::write(&path, text).unwrap();
        let (title, source) = list(dir.path())[0].about.clone().unwrap();
        assert!(title.starts_with("cross-section: "), "{name}: {title}");
        assert!(!source.is_empty());
    }

    #[test]
    fn a_broken_case_is_listed_with_place_and_remedy() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("broken.toml"), "[case]\ntitle = 3\n").unwrap();
        let entries = list(dir.path());
        let (line, whole) = entries[0].about.clone().unwrap_err();
        assert!(line.starts_with("line "), "{line}");
        assert!(whole.contains("broken.toml:"), "{whole}");
    }
}
