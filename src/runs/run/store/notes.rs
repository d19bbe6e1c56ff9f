//! What the user says of a stored run: a name, tags, a note. Kept in the run's own directory, so that it goes where the run goes.

use std::{io, path::Path};

use serde::{Deserialize, Serialize};

use super::{NOTES, StoreError, create::replace, read_info};
use crate::files::shallow::shallow;
use crate::files::{disk, read::run_text};
use crate::visible;

/// What the user says of a stored run.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct RunNotes {
    /// A name, beside that of the directory; empty for none.
    pub name: String,
    /// Tags, each once, in the order of the alphabet.
    pub tags: Vec<String>,
    /// A note; empty for none.
    pub note: String,
}

impl RunNotes {
    /// What is said of the run in a directory; nothing where nothing can be read.
    #[must_use]
    pub fn read(dir: &Path) -> Self {
        let text = run_text(&dir.join(NOTES)).unwrap_or_default();
        let mut notes: Self = toml::from_str(shallow(&text)).unwrap_or_default();
        notes.order();
        notes
    }

    /// Keeps it in the directory of a run; a file that would say nothing is removed.
    ///
    /// # Errors
    /// The directory holds no run, or cannot be written.
    pub fn write(&self, dir: &Path) -> Result<(), StoreError> {
        read_info(dir)?;
        let file = dir.join(NOTES);
        if *self == Self::default() {
            return match disk::remove_file(&file) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    Err(StoreError::io("Removing", &file)(error))
                }
                _ => Ok(()),
            };
        }
        let text = toml::to_string(self).map_err(|error| StoreError::Damaged {
            file,
            reason: error.to_string(),
        })?;
        replace(dir, NOTES, visible::toml(&text).as_bytes())
    }

    /// Sets the tags from words apart by blanks or commas.
    pub fn set_tags(&mut self, words: &str) {
        let words = words.split([',', ' ']).filter(|word| !word.is_empty());
        self.tags = words.map(str::to_owned).collect();
        self.order();
    }

    fn order(&mut self) {
        self.tags.sort();
        self.tags.dedup();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_are_words_each_once() {
        let mut notes = RunNotes::default();
        notes.set_tags("wet, base  wet");
        assert_eq!(notes.tags, ["base", "wet"]);
        notes.set_tags(" ");
        assert_eq!(notes, RunNotes::default());
    }
}
