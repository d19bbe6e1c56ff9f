//! The programs that a system is written for, and what they cannot say.

/// The programs whose files are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// MoorDyn, version 2.
    MoorDyn,
    /// MAP++.
    MapPlusPlus,
}

impl Target {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::MoorDyn => "MoorDyn",
            Self::MapPlusPlus => "MAP++",
        }
    }
}

/// What is said about an export.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ExportOptions {
    /// Free points and bodies are written where they rest, not where the search for it begins.
    pub at_rest: bool,
}

/// Something of a system that a file cannot say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unsayable {
    /// The key, such as `lines.a.release_a_s`.
    pub key: String,
    /// Why.
    pub what: String,
}
