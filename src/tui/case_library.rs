//! The shipped cases, and listing a directory of cases.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use etcetera::base_strategy::{BaseStrategy, Xdg};

use super::state::reading::read_file;
use super::state::{CaseEntry, DocumentContent};
use crate::case::{self, render_all};
use crate::files::{Target, read};

use crate::case::shipped::{BESIDE, BY_KIND};

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
    if !files_below(&here, DEPTH).is_empty() {
        return Ok(here);
    }
    let dir = data_dir()?.join("cases");
    let by_kind = BY_KIND.iter().flat_map(|(_, files)| *files);
    for (name, text) in by_kind.chain(BESIDE) {
        let path = dir.join(name);
        if !path.exists() {
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent)?;
            }
            Target::new(&path).write(text.as_bytes())?;
        }
    }
    Ok(dir)
}

fn data_dir() -> io::Result<PathBuf> {
    let base = Xdg::new().map_err(io::Error::other)?;
    Ok(base.data_dir().join("seacable"))
}

/// Where the program keeps what is not the user's: recovery, answers given.
///
/// # Errors
/// When the user has no home directory.
pub fn state_dir() -> io::Result<PathBuf> {
    let base = Xdg::new().map_err(io::Error::other)?;
    let dir = base.state_dir().unwrap_or_else(|| base.data_dir());
    Ok(dir.join("seacable"))
}

/// The cases of a directory, by path; those that do not pass say why.
#[must_use]
pub fn list(dir: &Path) -> Vec<CaseEntry> {
    let mut files = files_below(dir, DEPTH);
    files.sort();
    files.into_iter().map(|path| entry(dir, path)).collect()
}

fn entry(dir: &Path, path: PathBuf) -> CaseEntry {
    let name = path
        .strip_prefix(dir)
        .unwrap_or(&path)
        .display()
        .to_string();
    let about = match read_file(&path) {
        Ok((_, content)) => {
            let kind = content.kind().info();
            let title = match &content {
                DocumentContent::Line(_) => kind.title.to_owned(),
                _ => format!("{}: {}", kind.name, kind.title),
            };
            Ok((title, kind.source.to_owned()))
        }
        Err(all) => {
            let line = all.first().map_or_else(String::new, |d| {
                format!("line {}, column {}: {}", d.line, d.column, d.problem)
            });
            Err((line, story(&path, &all)))
        }
    };
    CaseEntry { path, name, about }
}

/// All that is wrong with a file, with the lines meant.
#[must_use]
pub fn story(path: &Path, all: &[case::Diagnostic]) -> String {
    let text = read::text_lossy(path).unwrap_or_default();
    render_all(all, &text, false)
}

fn files_below(dir: &Path, depth: usize) -> Vec<PathBuf> {
    let Ok(inside) = fs::read_dir(dir) else {
        return Vec::new();
    };
    let mut files = Vec::new();
    for item in inside.flatten() {
        let path = item.path();
        let hidden = item.file_name().to_string_lossy().starts_with('.');
        if hidden {
            continue;
        }
        if path.is_dir() {
            if depth > 0 {
                files.extend(files_below(&path, depth - 1));
            }
        } else if path.extension().is_some_and(|e| e == "toml") {
            files.push(path);
        }
    }
    files
}

#[cfg(test)]
mod tests {
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
