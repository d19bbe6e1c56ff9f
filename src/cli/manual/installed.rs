//! Files put in place and taken away: those of others are never touched.

use std::io;
use std::path::Path;

use clap_complete::Shell;

use super::files::{self, MARK};
use seacable_base::files::{WriteTarget, disk, read};

/// What became of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Written {
    /// It is new.
    New,
    /// It was there in another form.
    Replaced,
    /// It was there as it is.
    Same,
    /// It is not of this program, and was left alone.
    Kept,
    /// It was taken away.
    Removed,
    /// There was none to take away.
    Absent,
}

impl Written {
    /// A line on the file; nothing where nothing became of it.
    pub(crate) fn words(self, path: &str) -> Option<String> {
        match self {
            Self::New => Some(format!("written   {path}")),
            Self::Replaced => Some(format!("replaced  {path}")),
            Self::Same => Some(format!("unchanged {path}")),
            Self::Kept => Some(format!(
                "KEPT      {path} is not of this program; --force replaces it"
            )),
            Self::Removed => Some(format!("removed   {path}")),
            Self::Absent => None,
        }
    }
}

/// Writes a file; one of others stays unless it is to be replaced all the same.
///
/// # Errors
/// The system refuses.
pub(crate) fn write(path: &Path, text: &str, force: bool) -> io::Result<Written> {
    let now = text_of(path)?;
    match &now {
        Some(now) if now == text => return Ok(Written::Same),
        Some(now) if !now.contains(MARK) && !force => return Ok(Written::Kept),
        _ => {}
    }
    if let Some(dir) = path.parent() {
        disk::create_dir_all(dir)?;
    }
    WriteTarget::replacing(path).write(text.as_bytes())?;
    Ok(match now {
        Some(_) => Written::Replaced,
        None => Written::New,
    })
}

/// Takes a file of this program away.
///
/// # Errors
/// The system refuses.
pub(crate) fn remove(path: &Path) -> io::Result<Written> {
    match text_of(path)? {
        None => Ok(Written::Absent),
        Some(text) if !text.contains(MARK) => Ok(Written::Kept),
        Some(_) => disk::remove_file(path).map(|()| Written::Removed),
    }
}

/// The text of a file; nothing where there is none.
fn text_of(path: &Path) -> io::Result<Option<String>> {
    match read::text_lossy(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// How many of the files are in place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Installed {
    None,
    Some,
    All,
}

/// How many files are in place as this program writes them, and how many there are.
pub(crate) fn state(shells: &[Shell]) -> (usize, usize) {
    let all = files::all(shells);
    let home = seacable_base::places::data_home();
    let is_there = |file: &&files::ManualFile| {
        let path = home.as_ref().map(|home| home.join(&file.path));
        let text = path.ok().and_then(|path| text_of(&path).ok()?);
        text.as_ref() == Some(&file.text)
    };
    (all.iter().filter(is_there).count(), all.len())
}

/// The same in a word.
pub(crate) const fn verdict(there: usize, all: usize) -> Installed {
    match there {
        0 => Installed::None,
        there if there == all => Installed::All,
        _ => Installed::Some,
    }
}

/// The shells that are installed, of those with a folder for completions.
pub(crate) fn shells(is_there: &dyn Fn(&str) -> bool) -> Vec<Shell> {
    let shells = files::SHELLS.into_iter();
    shells
        .filter(|shell| is_there(&shell.to_string()))
        .collect()
}

/// Whether a program is in the search path.
pub(crate) fn is_in_path(name: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|dir| dir.join(name).is_file())
}
