//! Directories of the user that hold what is not the user's own work.

use std::io;
use std::path::PathBuf;

use etcetera::base_strategy::{BaseStrategy, Xdg};

/// Where the program keeps what is not the user's: recovery, answers given.
///
/// # Errors
/// When the user has no home directory.
pub fn state_dir() -> io::Result<PathBuf> {
    let base = Xdg::new().map_err(io::Error::other)?;
    let dir = base.state_dir().unwrap_or_else(|| base.data_dir());
    Ok(dir.join("seacable"))
}
