//! What the doctor looks at and finds.

use std::path::{Path, PathBuf};

/// How much something matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Health {
    /// As it should be.
    Fine,
    /// Worth knowing.
    Note,
    /// In the way of work.
    Problem,
}

impl Health {
    /// Its word.
    #[must_use]
    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Fine => "ok",
            Self::Note => "note",
            Self::Problem => "PROBLEM",
        }
    }
}

/// Something that was looked at.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DoctorFinding {
    /// What it belongs to.
    pub topic: &'static str,
    /// What was looked at.
    pub name: String,
    /// What was found.
    pub value: String,
    /// How much it matters.
    pub health: Health,
    /// What to do about it; empty where nothing need be done.
    pub remedy: String,
}

impl DoctorFinding {
    pub(super) fn fine(topic: &'static str, name: &str, value: impl Into<String>) -> Self {
        Self {
            topic,
            name: name.to_owned(),
            value: value.into(),
            health: Health::Fine,
            remedy: String::new(),
        }
    }

    pub(super) fn note(self, remedy: impl Into<String>) -> Self {
        self.with_health(Health::Note, remedy)
    }

    pub(super) fn problem(self, remedy: impl Into<String>) -> Self {
        self.with_health(Health::Problem, remedy)
    }

    fn with_health(self, health: Health, remedy: impl Into<String>) -> Self {
        Self {
            health,
            remedy: remedy.into(),
            ..self
        }
    }
}

/// Where the program runs.
pub(crate) struct Surroundings<'a> {
    /// Looks up a variable of the environment.
    pub var: &'a dyn Fn(&str) -> Option<String>,
    /// Columns and rows of the terminal; nothing without one.
    pub size: Option<(u16, u16)>,
    /// The directory in which it runs.
    pub directory: PathBuf,
}

impl std::fmt::Debug for Surroundings<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Surroundings")
            .field("size", &self.size)
            .field("directory", &self.directory)
            .finish_non_exhaustive()
    }
}

impl Surroundings<'_> {
    /// A variable that is set to something.
    pub(super) fn set(&self, name: &str) -> Option<String> {
        (self.var)(name).filter(|value| !value.is_empty())
    }

    /// The file of a program in the search path.
    pub(super) fn program(&self, name: &str) -> Option<PathBuf> {
        if name.contains('/') {
            return Some(PathBuf::from(name)).filter(|path| path.is_file());
        }
        let path = self.set("PATH")?;
        let mut files = path.split(':').map(|dir| Path::new(dir).join(name));
        files.find(|file| file.is_file())
    }
}
