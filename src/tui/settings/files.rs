//! The files of the settings, read.

use super::{UserSettings, config, config_file, keys_file};
use crate::bindings;
use crate::{
    case::{Diagnostic, render_all},
    visible,
};
use seacable_base::files::{WriteTarget, disk, read};
use std::{
    io::ErrorKind,
    path::{Path, PathBuf},
};

/// Whether this is one of the files.
#[must_use]
pub fn is_file(path: &Path) -> bool {
    [keys_file(), config_file()]
        .into_iter()
        .flatten()
        .any(|own| own == path)
}

/// The file of keys; one that is not there is made, with every key in a comment.
///
/// # Errors
/// When it cannot be written.
pub fn made_keys_file() -> std::io::Result<PathBuf> {
    let path = keys_file()?;
    if !path.exists() {
        if let Some(dir) = path.parent() {
            disk::create_dir_all(dir)?;
        }
        WriteTarget::new(&path).write(bindings::listing::default_file().as_bytes())?;
    }
    Ok(path)
}

impl UserSettings {
    /// Reads both files; one that is not there sets nothing.
    #[must_use]
    pub fn load() -> Self {
        let mut settings = Self::default();
        let mut faults = Vec::new();
        if let Some((text, name)) = keys_file()
            .ok()
            .and_then(|path| text_of(&path, &mut faults))
        {
            let (keys, found) = bindings::file::read(&text, &name);
            settings.keys = keys;
            faults.extend(found);
        }
        if let Some((text, name)) = config_file()
            .ok()
            .and_then(|path| text_of(&path, &mut faults))
        {
            let (config, found) = config::read(&text, &name);
            settings.config = config;
            faults.extend(found);
        }
        settings.faults = faults;
        settings
    }

    /// All that is wrong as a page; nothing where nothing is.
    #[must_use]
    pub fn story(&self) -> Option<String> {
        (!self.faults.is_empty()).then(|| render_all(&self.faults, false))
    }
}

/// The text of a file and its name; nothing where there is no such file, or it cannot be read.
fn text_of(path: &Path, faults: &mut Vec<Diagnostic>) -> Option<(String, String)> {
    let name = visible::path(path);
    match read::text(path) {
        Ok(text) => Some((text, name)),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => {
            let problem = format!("the file cannot be read: {error}");
            let remedy = "mend the file, or remove it; the program's own settings hold meanwhile";
            faults.push(Diagnostic::whole_file(&name, problem, remedy));
            None
        }
    }
}
