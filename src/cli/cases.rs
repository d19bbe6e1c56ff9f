//! Cases as the command line names them.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use super::CommandError;
use crate::{
    case::{self, Case, edit, shipped},
    kinds::Kind,
    ropeway, ship,
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
pub(super) fn load(path: &Path) -> Result<Loaded, CommandError> {
    let name = path.display().to_string();
    let loaded = case::load(path).map_err(CommandError::invalid_file(path))?;
    Ok(Loaded {
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

/// What may state published values: line cases, and ropeways with the name that the user knows them by.
#[derive(Debug, Default)]
pub(super) struct Named {
    /// Line cases.
    pub(super) lines: Vec<Loaded>,
    /// Ropeways.
    pub(super) ropeways: Vec<(String, ropeway::Loaded)>,
    /// Ships, by name.
    pub(super) ships: Vec<(String, ship::StaticAnalysis)>,
}

/// The cases named; without names, those below `cases` here, or else those that come with the
/// program, as far as they state published values.
pub(super) fn named_or_shipped(paths: &[PathBuf]) -> Result<Named, CommandError> {
    if !paths.is_empty() {
        return below(paths);
    }
    let folder = Path::new(FOLDER);
    let mut named = if folder.is_dir() {
        below(&[folder.to_owned()])?
    } else {
        shipped()?
    };
    named.lines.retain(|loaded| {
        let case = &loaded.case;
        !(case.published.is_empty() && case.published_curve.is_empty() && case.trend.is_empty())
    });
    named.ropeways.retain(|(_, loaded)| {
        let ropeway = &loaded.worked.ropeway;
        !(ropeway.published.is_empty() && ropeway.trend.is_empty())
    });
    named
        .ships
        .retain(|(_, rest)| !rest.ship.published.is_empty());
    Ok(named)
}

/// The cases with trials among those named; without names, among those below `cases` here, or else among those that
/// come with the program.
pub(super) fn with_trials(paths: &[PathBuf]) -> Result<Vec<Loaded>, CommandError> {
    let folder = Path::new(FOLDER);
    let named = if !paths.is_empty() {
        below(paths)?
    } else if folder.is_dir() {
        below(&[folder.to_owned()])?
    } else {
        shipped()?
    };
    let mut cases = named.lines;
    cases.retain(|loaded| !loaded.case.trial.is_empty());
    if cases.is_empty() {
        let what = "There is no case with trials; a hard case has at least one table [[trial]].";
        return Err(CommandError::Usage(what.to_owned()));
    }
    Ok(cases)
}

fn shipped() -> Result<Named, CommandError> {
    let line = |(path, text): &(&str, &str)| {
        let case = parse(text, path)?;
        Ok::<_, CommandError>(Loaded {
            file: file_name(path),
            name: format!("{FOLDER}/{path}"),
            text: (*text).to_owned(),
            case,
        })
    };
    let ropeway = |(path, text): &(&str, &str)| {
        let wrong = CommandError::invalid(text);
        let name = format!("{FOLDER}/{path}");
        let loaded = ropeway::Loaded {
            worked: ropeway::parse(text, path).map_err(wrong)?,
            text: (*text).to_owned(),
            path: PathBuf::from(&name),
        };
        Ok::<_, CommandError>((name, loaded))
    };
    let ship = |(path, text): &(&str, &str)| {
        let wrong = CommandError::invalid(text);
        let rest = ship::parse(text, path).map_err(wrong)?;
        Ok::<_, CommandError>((format!("{FOLDER}/{path}"), rest))
    };
    Ok(Named {
        ships: shipped::SHIPS.iter().map(ship).collect::<Result<_, _>>()?,
        lines: shipped::SHIPPED
            .iter()
            .map(line)
            .collect::<Result<_, _>>()?,
        ropeways: shipped::ROPEWAYS
            .iter()
            .map(ropeway)
            .collect::<Result<_, _>>()?,
    })
}

/// Every file named, and every case file below every directory named.
fn below(paths: &[PathBuf]) -> Result<Named, CommandError> {
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
    let mut named = Named::default();
    for file in &files {
        let name = file.display().to_string();
        match Kind::of(file) {
            Kind::Ropeway => named.ropeways.push((name, load_ropeway(file)?)),
            Kind::Ship => named.ships.push((name, load_ship(file)?)),
            Kind::Line | Kind::Section => named.lines.push(load(file)?),
        }
    }
    Ok(named)
}

/// Loads a ropeway file.
pub(super) fn load_ropeway(path: &Path) -> Result<ropeway::Loaded, CommandError> {
    ropeway::load(path).map_err(CommandError::invalid_file(path))
}

/// Loads a ship file, without the rope that it may name.
fn load_ship(path: &Path) -> Result<ship::StaticAnalysis, CommandError> {
    let loaded = ship::load(path).map_err(CommandError::invalid_file(path))?;
    Ok(loaded.worked)
}

fn collect(dir: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let mut inside: Vec<PathBuf> = fs::read_dir(dir)?
        .map(|item| item.map(|i| i.path()))
        .collect::<io::Result<_>>()?;
    inside.sort();
    for path in inside {
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|e| e == "toml") && Kind::of(&path) != Kind::Section
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
