//! The files of what outlives a session: a file for each directory that sessions ran in, and one of what holds in all of them.
//!
//! Each is written whole beside and renamed, so that several sessions at once leave one of theirs and never half of it.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::ScreenMemory;
use crate::places::state_dir;
use crate::visible;
use seacable_base::files::shallow::shallow;
use seacable_base::files::{WriteTarget, disk, read};

/// Screens of more directories are not kept.
const MOST: usize = 50;

/// What holds wherever the program is started.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SessionMemory {
    /// The theme, where the user chose one on the screen.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theme: Option<String>,
    /// Whether the tutorial was offered.
    pub tutorial_offered: bool,
    /// The step at which the tutorial was left.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tutorial_step: Option<usize>,
    /// Lines of commands, the oldest first.
    pub commands: Vec<String>,
}

/// Both files as read, with what is wrong with them.
#[derive(Debug, Clone, Default)]
pub struct Remembered {
    /// The screen of this directory.
    pub screen: Option<ScreenMemory>,
    /// What holds everywhere.
    pub session: SessionMemory,
    /// What is wrong with the files.
    pub faults: Vec<String>,
}

/// Reads what sessions before this one left; `directory` is where this one runs.
#[must_use]
pub fn recall(directory: &Path) -> Remembered {
    let mut remembered = Remembered::default();
    match screen_file(directory).and_then(|path| of_file(&path)) {
        Ok(screen) => remembered.screen = screen,
        Err(fault) => remembered.faults.push(fault.to_string()),
    }
    match session_file().and_then(|path| of_file(&path)) {
        Ok(session) => remembered.session = session.unwrap_or_default(),
        Err(fault) => remembered.faults.push(fault.to_string()),
    }
    remembered
}

/// The content of a file; nothing where there is none.
fn of_file<T: DeserializeOwned>(path: &Path) -> io::Result<Option<T>> {
    let text = match read::text(path) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(fault(path, &error.to_string())),
    };
    of_text(&text).map(Some).map_err(|why| fault(path, &why))
}

/// The content of a text: a [`ScreenMemory`] or a [`SessionMemory`].
///
/// # Errors
/// Why it is none.
pub fn of_text<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    toml::from_str(shallow(text)).map_err(|error| error.message().to_owned())
}

fn fault(path: &Path, why: &str) -> io::Error {
    let path = visible::path(path);
    io::Error::other(format!(
        "What the last session left is damaged and is not used: {path}: {}",
        why.replace('\n', " ")
    ))
}

/// Keeps what the screen shows of a directory.
///
/// # Errors
/// When the state directory cannot be written.
pub fn keep_screen(directory: &Path, memory: &ScreenMemory) -> io::Result<()> {
    let path = screen_file(directory)?;
    keep(&path, memory)?;
    if let Some(dir) = path.parent() {
        forget_oldest(dir);
    }
    Ok(())
}

/// Keeps what holds everywhere.
///
/// # Errors
/// When the state directory cannot be written.
pub fn keep_session(memory: &SessionMemory) -> io::Result<()> {
    keep(&session_file()?, memory)
}

fn keep<T: Serialize>(path: &Path, content: &T) -> io::Result<()> {
    let text = toml::to_string(content).map_err(io::Error::other)?;
    if let Some(dir) = path.parent() {
        disk::create_dir_all(dir)?;
    }
    Ok(WriteTarget::replacing(path).write(text.as_bytes())?)
}

/// Removes the screens of the directories that no session was in for longest.
fn forget_oldest(dir: &Path) {
    let files = fs::read_dir(dir).into_iter().flatten().flatten();
    let mut files: Vec<(SystemTime, PathBuf)> = files
        .filter_map(|file| Some((file.metadata().ok()?.modified().ok()?, file.path())))
        .filter(|(_, path)| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort_unstable();
    for (_, path) in files.iter().take(files.len().saturating_sub(MOST)) {
        // Best effort: what stays is looked at again.
        let _ = disk::remove_file(path);
    }
}

fn session_file() -> io::Result<PathBuf> {
    Ok(state_dir()?.join("session.toml"))
}

/// The file of a directory: its name, and a fingerprint of its whole path.
fn screen_file(directory: &Path) -> io::Result<PathBuf> {
    let name = directory.file_name().unwrap_or_default().to_string_lossy();
    let print = crate::recovery::fingerprint(directory);
    Ok(state_dir()?
        .join("screen")
        .join(format!("{name}-{print:016x}.toml")))
}
