//! Why a command could not do its work, and how the user is told.

use std::{
    io::{self, IsTerminal},
    process::ExitCode,
};

use super::{BAD_INPUT, NOT_GOOD, output};
use crate::{case::Diagnostic, files::WriteError, run::store::StoreError, tui::OpenError};

/// Why a command could not do its work.
#[derive(Debug)]
pub(super) enum Failure {
    /// The case is not right; its text, where there is one, lets every complaint show its place.
    Case {
        text: String,
        diagnostics: Vec<Diagnostic>,
    },
    /// Words that cannot be followed.
    Usage(String),
    /// A run cannot be written or read.
    Store(StoreError),
    /// The file that an option names cannot be written.
    Write {
        option: &'static str,
        source: WriteError,
    },
    /// Standard output cannot be written.
    Output(io::Error),
    /// The screen gave up.
    Screen(OpenError),
}

impl From<StoreError> for Failure {
    fn from(error: StoreError) -> Self {
        Self::Store(error)
    }
}

impl Failure {
    /// Tells the user, and gives the exit status.
    pub(super) fn tell(self) -> ExitCode {
        match self {
            Self::Case { text, diagnostics } => {
                let color = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
                for diagnostic in &diagnostics {
                    output::message(diagnostic.render(&text, color).trim_end());
                }
                ExitCode::from(BAD_INPUT)
            }
            Self::Usage(text) => say(&text, BAD_INPUT),
            Self::Store(error) => say(&error.to_string(), BAD_INPUT),
            Self::Write { option, source } => say(&not_written(option, &source), BAD_INPUT),
            Self::Output(source) => say(
                &format!("Writing standard output failed: {source}"),
                BAD_INPUT,
            ),
            Self::Screen(error @ OpenError::Terminal(_)) => say(&error.to_string(), NOT_GOOD),
            Self::Screen(error) => say(&error.to_string(), BAD_INPUT),
        }
    }
}

/// What to do about a file that was not written.
fn not_written(option: &str, source: &WriteError) -> String {
    let remedy = match source {
        WriteError::Exists(_) => " and is left as it is; give --force to replace it",
        _ => "",
    };
    format!("{option}: {source}{remedy}.")
}

fn say(text: &str, status: u8) -> ExitCode {
    output::message(&format!("error: {text}"));
    ExitCode::from(status)
}
