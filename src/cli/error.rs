//! Errors of the command line, their messages and exit status.

use std::{
    io::{self, IsTerminal},
    path::Path,
    process::ExitCode,
};

use super::{BAD_INPUT, BAD_RESULT, output};
use crate::{
    case::Diagnostic,
    files::{self, WriteError},
    run::store::StoreError,
    tui::OpenError,
};

/// Why a command failed.
#[derive(Debug)]
pub(super) enum CommandError {
    /// A file is not valid. With its text, every diagnostic shows its place.
    Invalid {
        text: String,
        diagnostics: Vec<Diagnostic>,
    },
    /// Arguments that cannot be used.
    Usage(String),
    /// A stored run cannot be written or read.
    Store(StoreError),
    /// The file that an option names cannot be written.
    Write {
        option: &'static str,
        source: WriteError,
    },
    /// Standard output cannot be written.
    Output(io::Error),
    /// The screen failed.
    Screen(OpenError),
}

impl From<StoreError> for CommandError {
    fn from(error: StoreError) -> Self {
        Self::Store(error)
    }
}

impl CommandError {
    /// The error of a file, which is read again for its text.
    pub(super) fn invalid_file(path: &Path) -> impl Fn(Vec<Diagnostic>) -> Self {
        move |diagnostics| Self::Invalid {
            text: files::read::text_lossy(path).unwrap_or_default(),
            diagnostics,
        }
    }

    /// The error of a file with this text.
    pub(super) fn invalid(text: &str) -> impl Fn(Vec<Diagnostic>) -> Self {
        move |diagnostics| Self::Invalid {
            text: text.to_owned(),
            diagnostics,
        }
    }

    /// Prints the message and returns the exit status.
    pub(super) fn report(self) -> ExitCode {
        match self {
            Self::Invalid { text, diagnostics } => {
                let color = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
                for diagnostic in &diagnostics {
                    let [plain, coloured] =
                        [false, color].map(|color| diagnostic.render(&text, color));
                    output::coloured_message(plain.trim_end(), coloured.trim_end());
                }
                ExitCode::from(BAD_INPUT)
            }
            Self::Usage(text) => fail(&text, BAD_INPUT),
            Self::Store(error) => fail(&error.to_string(), BAD_INPUT),
            Self::Write { option, source } => fail(&not_written(option, &source), BAD_INPUT),
            Self::Output(source) => fail(
                &format!("Writing standard output failed: {source}"),
                BAD_INPUT,
            ),
            Self::Screen(error @ OpenError::Terminal(_)) => fail(&error.to_string(), BAD_RESULT),
            Self::Screen(error) => fail(&error.to_string(), BAD_INPUT),
        }
    }
}

/// The message about a file that was not written, with its remedy.
fn not_written(option: &str, source: &WriteError) -> String {
    let remedy = match source {
        WriteError::Exists(_) => " and is left as it is; give --force to replace it",
        _ => "",
    };
    format!("{option}: {source}{remedy}.")
}

fn fail(text: &str, status: u8) -> ExitCode {
    output::message(&format!("error: {text}"));
    ExitCode::from(status)
}
