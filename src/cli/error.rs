//! Errors of the command line, their messages and exit status.

use std::{
    io::{self, IsTerminal},
    process::ExitCode,
};

use super::{BAD_INPUT, BAD_RESULT, output};
use seacable_base::files::WriteError;
use seacable_model::case::Diagnostic;
use seacable_runs::run::store::StoreError;
use seacable_tui::OpenError;

/// Why a command failed.
#[derive(Debug)]
pub(super) enum CommandError {
    /// A file is not valid.
    Invalid(Vec<Diagnostic>),
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
    /// Prints the message and returns the exit status.
    pub(super) fn report(self) -> ExitCode {
        match self {
            Self::Invalid(diagnostics) => {
                let color = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
                for diagnostic in &diagnostics {
                    let [plain, coloured] = [false, color].map(|color| diagnostic.render(color));
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
