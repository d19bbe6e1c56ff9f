//! Cases as the command line names them.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use super::Failure;
use crate::{
    case::{self, Case, edit, shipped::SHIPPED},
    section::is_section,
};

/// Where the cases that come with the program lie in its source.
const FOLDER: &str = "cases";

/// A case with its text.
#[derive(Debug)]
pub(super) struct Loaded {
    /// How the user knows it.
    pub(super) name: String,
    /// File name without directories.
    pub(super) file: String,
    /// The exact text.
    pub(super) text: String,
    /// What it says.
    pub(super) case: Case,
}

/// Loads a case file.
pub(super) fn load(path: &Path) -> Result<Loaded, Failure> {
    let name = path.display().to_string();
    let loaded = case::load(path).map_err(|diagnostics| Failure::Case {
        text: fs::read_to_string(path).unwrap_or_default(),
        diagnostics,
    })?;
    Ok(Loaded {
        file: file_name(&name),
        name,
        text: loaded.text,
        case: loaded.case,
    })
}

/// Reads a case from its text.
pub(super) fn parse(text: &str, file: &str) -> Result<Case, Failure> {
    let wrong = |diagnostics| Failure::Case {
        text: text.to_owned(),
        diagnostics,
    };
    case::parse(text, file).map_err(wrong)
}

/// Applies every `KEY=VALUE` to the text of a case.
pub(super) fn set(text: &str, words: &[String]) -> Result<String, Failure> {
    let mut edits = Vec::with_capacity(words.len());
    for word in words {
        let Some((key, value)) = word.split_once('=') else {
            let what = format!(
                "`--set {word}` gives no value; write KEY=VALUE, for example current.speed_m_per_s=0.4."
            );
            return Err(Failure::Usage(what));
        };
        edits.push((key.trim(), value.trim()));
    }
    let wrong = |diagnostics| Failure::Case {
        text: text.to_owned(),
        diagnostics,
    };
    edit::set_all(text, &edits).map_err(wrong)
}

/// The cases named; without names, those below `cases` here, or else those that come with the
/// program, as far as they state published values.
pub(super) fn named_or_shipped(paths: &[PathBuf]) -> Result<Vec<Loaded>, Failure> {
    if !paths.is_empty() {
        return below(paths);
    }
    let folder = Path::new(FOLDER);
    let mut cases = if folder.is_dir() {
        below(&[folder.to_owned()])?
    } else {
        shipped()?
    };
    cases.retain(|loaded| !(loaded.case.published.is_empty() && loaded.case.trend.is_empty()));
    Ok(cases)
}

fn shipped() -> Result<Vec<Loaded>, Failure> {
    let each = SHIPPED.iter().map(|(path, text)| {
        let case = parse(text, path)?;
        let name = format!("{FOLDER}/{path}");
        Ok(Loaded {
            file: file_name(path),
            name,
            text: (*text).to_owned(),
            case,
        })
    });
    each.collect()
}

/// Every file named, and every case file below every directory named.
fn below(paths: &[PathBuf]) -> Result<Vec<Loaded>, Failure> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            let before = files.len();
            collect(path, &mut files).map_err(|error| {
                Failure::Usage(format!("Listing {} failed: {error}", path.display()))
            })?;
            if files.len() == before {
                let what = format!("There is no case file (*.toml) below {}.", path.display());
                return Err(Failure::Usage(what));
            }
        } else {
            files.push(path.clone());
        }
    }
    files.iter().map(|file| load(file)).collect()
}

fn collect(dir: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let mut inside: Vec<PathBuf> = fs::read_dir(dir)?
        .map(|item| item.map(|i| i.path()))
        .collect::<io::Result<_>>()?;
    inside.sort();
    for path in inside {
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|e| e == "toml") && !is_section(&path) {
            files.push(path);
        }
    }
    Ok(())
}

fn file_name(path: &str) -> String {
    let name = Path::new(path).file_name();
    name.map_or_else(|| path.to_owned(), |n| n.to_string_lossy().into_owned())
}
