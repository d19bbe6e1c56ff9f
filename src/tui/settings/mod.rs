//! What the user sets in files: keys in `keys.toml`, the look of the screen in `config.toml`, both in the folder of XDG for settings.

pub mod config;
mod files;

use std::path::PathBuf;

pub use self::config::Config;
use super::bindings::KeyTable;
use crate::case::Diagnostic;
use crate::places;
pub use files::{is_file, made_keys_file};

/// What the files of the user set, and what is wrong with them.
#[derive(Debug, Clone, Default)]
pub struct UserSettings {
    /// The keys.
    pub keys: KeyTable,
    /// The look of the screen.
    pub config: Config,
    /// All that is wrong, file by file.
    pub faults: Vec<Diagnostic>,
}

/// The file of keys.
///
/// # Errors
/// When the user has no home directory.
pub fn keys_file() -> std::io::Result<PathBuf> {
    Ok(places::config_dir()?.join("keys.toml"))
}

/// The file of the look of the screen.
///
/// # Errors
/// When the user has no home directory.
pub fn config_file() -> std::io::Result<PathBuf> {
    Ok(places::config_dir()?.join("config.toml"))
}
