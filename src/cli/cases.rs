//! Cases as the command line names them.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use super::CommandError;
use crate::{
    case::{self, Case, FieldRow, edit, file_kind::FileKind, kind, shipped},
    import::ImportOptions,
    kinds::FileType,
};

/// Where the cases that come with the program lie in its source.
pub(super) const FOLDER: &str = "cases";

/// A case with its text.
#[derive(Debug)]
pub(super) struct NamedCase {
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
pub(super) fn load(path: &Path) -> Result<NamedCase, CommandError> {
    let name = path.display().to_string();
    let loaded = case::load(path).map_err(CommandError::invalid_file(path))?;
    Ok(NamedCase {
        file: file_name(&name),
        name,
        text: loaded.text,
        case: loaded.case,
    })
}

/// Reads a case from its text.
pub(super) fn parse(text: &str, file: &str) -> Result<Case, CommandError> {
    let wrong = CommandError::invalid(text);
    case::parse(text, file).map_err(wrong)
}

/// Every `KEY=VALUE` as its two parts.
pub(super) fn edits(words: &[String]) -> Result<Vec<(&str, &str)>, CommandError> {
    let mut edits = Vec::with_capacity(words.len());
    for word in words {
        let Some((key, value)) = word.split_once('=') else {
            let what = format!(
                "`--set {word}` gives no value; write KEY=VALUE, for example current.speed_m_per_s=0.4."
            );
            return Err(CommandError::Usage(what));
        };
        edits.push((key.trim(), value.trim()));
    }
    Ok(edits)
}

/// Applies every `KEY=VALUE` to the text of a case.
pub(super) fn set(text: &str, words: &[String]) -> Result<String, CommandError> {
    let edits = edits(words)?;
    let wrong = CommandError::invalid(text);
    edit::set_all(text, &edits).map_err(wrong)
}

/// The text of a file of a kind with keys set.
pub(super) fn edited_text<K: FileKind>(
    path: &Path,
    words: &[String],
    options: &ImportOptions,
) -> Result<String, CommandError> {
    let loaded = kind::load_as::<K>(path, options).map_err(CommandError::invalid_file(path))?;
    let text = &loaded.whole_text;
    kind::set_all::<K>(text, &edits(words)?).map_err(CommandError::invalid(text))
}

/// The fields of a file of a kind that is read with keys set, and its result.
pub(super) fn load_with<K: FileKind>(
    path: &Path,
    words: &[String],
    options: &ImportOptions,
) -> Result<(Vec<FieldRow>, K::Computed), CommandError> {
    let loaded = kind::load_as::<K>(path, options).map_err(CommandError::invalid_file(path))?;
    let fields = |text: &str| kind::edited_rows::<K>(text, &loaded.text).0;
    if words.is_empty() {
        return Ok((fields(&loaded.text), loaded.computed));
    }
    let text = kind::set_all::<K>(&loaded.whole_text, &edits(words)?)
        .map_err(CommandError::invalid(&loaded.whole_text))?;
    let computed = kind::parse::<K>(&text, &path.display().to_string())
        .map_err(CommandError::invalid(&text))?;
    Ok((fields(&text), computed))
}

/// What may state published values.
#[derive(Debug, Default)]
pub(super) struct ValidationFiles {
    /// Line cases.
    pub(super) lines: Vec<NamedCase>,
    /// Files of the other kinds.
    pub(super) others: Vec<OtherFile>,
}

/// A file of another kind than a line case.
#[derive(Debug)]
pub(super) struct OtherFile {
    pub(super) kind: FileType,
    /// How the user knows it.
    pub(super) name: String,
    pub(super) text: String,
}

/// The cases named; without names, those below `cases` here, or else those that come with the
/// program, as far as they state published values.
pub(super) fn named_or_shipped(paths: &[PathBuf]) -> Result<ValidationFiles, CommandError> {
    let mut named = named(paths)?;
    if paths.is_empty() {
        named.lines.retain(|loaded| {
            let case = &loaded.case;
            !(case.published.is_empty() && case.published_curve.is_empty() && case.trend.is_empty())
        });
    }
    Ok(named)
}

/// The files named; without names, those below `cases` here, or else those that come with the program.
fn named(paths: &[PathBuf]) -> Result<ValidationFiles, CommandError> {
    let folder = Path::new(FOLDER);
    if !paths.is_empty() {
        below(paths)
    } else if folder.is_dir() {
        below(&[folder.to_owned()])
    } else {
        shipped()
    }
}

/// The cases with trials among those named; without names, among those below `cases` here, or else among those that
/// come with the program.
pub(super) fn with_trials(paths: &[PathBuf]) -> Result<Vec<NamedCase>, CommandError> {
    let mut cases = named(paths)?.lines;
    cases.retain(|loaded| !loaded.case.trial.is_empty());
    if cases.is_empty() {
        let what = "There is no case with trials; a hard case has at least one table [[trial]].";
        return Err(CommandError::Usage(what.to_owned()));
    }
    Ok(cases)
}

/// The line cases named; without names, those below `cases` here, or else those that come with the program. Of these the hard
/// ones are left out, whose answers converge only where their trials say so.
pub(super) fn of_lines(paths: &[PathBuf]) -> Result<Vec<NamedCase>, CommandError> {
    let mut cases = named(paths)?.lines;
    if paths.is_empty() {
        cases.retain(|loaded| loaded.case.trial.is_empty());
    }
    Ok(cases)
}

fn shipped() -> Result<ValidationFiles, CommandError> {
    let mut named = ValidationFiles::default();
    for (kind, files) in shipped::BY_KIND {
        for (path, text) in files {
            named.add(kind, format!("{FOLDER}/{path}"), (*text).to_owned())?;
        }
    }
    Ok(named)
}

impl ValidationFiles {
    /// Adds a file; cross-sections state no published values.
    fn add(&mut self, kind: FileType, name: String, text: String) -> Result<(), CommandError> {
        match kind {
            FileType::Line => self.lines.push(NamedCase {
                file: file_name(&name),
                case: parse(&text, &name)?,
                name,
                text,
            }),
            FileType::Section => {}
            _ => self.others.push(OtherFile { kind, name, text }),
        }
        Ok(())
    }
}

/// Every file named, and every case file below every directory named.
fn below(paths: &[PathBuf]) -> Result<ValidationFiles, CommandError> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            let before = files.len();
            collect(path, &mut files).map_err(|error| {
                CommandError::Usage(format!("Listing {} failed: {error}", path.display()))
            })?;
            if files.len() == before {
                let what = format!("There is no case file (*.toml) below {}.", path.display());
                return Err(CommandError::Usage(what));
            }
        } else {
            files.push(path.clone());
        }
    }
    let mut named = ValidationFiles::default();
    for file in &files {
        let unreadable =
            |error| CommandError::Usage(format!("Reading {} failed: {error}", file.display()));
        match FileType::of(file) {
            FileType::Line | FileType::Section => named.lines.push(load(file)?),
            kind => {
                let text = fs::read_to_string(file).map_err(unreadable)?;
                named.add(kind, file.display().to_string(), text)?;
            }
        }
    }
    Ok(named)
}

fn collect(dir: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let mut inside: Vec<PathBuf> = fs::read_dir(dir)?
        .map(|item| item.map(|i| i.path()))
        .collect::<io::Result<_>>()?;
    inside.sort();
    for path in inside {
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|e| e == "toml")
            && FileType::of(&path) != FileType::Section
        {
            files.push(path);
        }
    }
    Ok(())
}

fn file_name(path: &str) -> String {
    let name = Path::new(path).file_name();
    name.map_or_else(|| path.to_owned(), |n| n.to_string_lossy().into_owned())
}
