//! Where the program keeps files of the user: the folders of XDG, on every Unix.

use std::io;
use std::path::PathBuf;

use etcetera::base_strategy::{BaseStrategy, Xdg};

/// The folder of the program in each of them.
const OWN: &str = "seacable";

fn base() -> io::Result<Xdg> {
    Xdg::new().map_err(io::Error::other)
}

/// What the user sets: keys, theme.
///
/// # Errors
/// When the user has no home directory.
pub fn config_dir() -> io::Result<PathBuf> {
    Ok(base()?.config_dir().join(OWN))
}

/// The shipped cases.
///
/// # Errors
/// When the user has no home directory.
pub fn data_dir() -> io::Result<PathBuf> {
    Ok(data_home()?.join(OWN))
}

/// The folder in which programs keep data of the user, manual pages and shell completions among them.
///
/// # Errors
/// When the user has no home directory.
pub fn data_home() -> io::Result<PathBuf> {
    Ok(base()?.data_dir())
}

/// What is not the user's: unsaved changes, the state of the screen, answers given.
///
/// # Errors
/// When the user has no home directory.
pub fn state_dir() -> io::Result<PathBuf> {
    let base = base()?;
    let dir = base.state_dir().unwrap_or_else(|| base.data_dir());
    Ok(dir.join(OWN))
}

/// What can be made anew: the index of runs.
///
/// # Errors
/// When the user has no home directory.
pub fn cache_dir() -> io::Result<PathBuf> {
    Ok(base()?.cache_dir().join(OWN))
}
