//! Slurm's commands: run without a shell, and their failures in words.

use std::ffi::{OsStr, OsString};
use std::io;
use std::process::{Command, Stdio};

use crate::visible::{self, quoted};

/// Why a command of Slurm gave no answer that is of use.
#[derive(Debug, thiserror::Error)]
pub enum CommandFailed {
    /// It could not be started.
    #[error(
        "`{command}` cannot be run: {source}. --slurm needs Slurm's commands in the search path (PATH): log in to a machine of the cluster, or \
         load the module that has them."
    )]
    NotRun {
        /// What was run, as a shell would take it.
        command: String,
        /// What the system reported.
        source: io::Error,
    },
    /// It failed.
    #[error("`{command}` failed ({status}): {said}. {remedy}")]
    Failed {
        /// What was run, as a shell would take it.
        command: String,
        /// How it ended.
        status: String,
        /// What it printed.
        said: String,
        /// What would be right.
        remedy: &'static str,
    },
    /// It answered what cannot be understood.
    #[error("`{command}` answered `{said}`, where {expected} was expected.")]
    Unclear {
        /// What was run, as a shell would take it.
        command: String,
        /// What it printed.
        said: String,
        /// What would be right.
        expected: &'static str,
    },
}

/// A command with its words.
#[derive(Debug)]
pub(super) struct SlurmCommand {
    program: &'static str,
    words: Vec<OsString>,
}

impl SlurmCommand {
    pub(super) fn new<S: AsRef<OsStr>>(program: &'static str, words: &[S]) -> Self {
        let words = words.iter().map(|word| word.as_ref().to_owned());
        Self {
            program,
            words: words.collect(),
        }
    }

    /// Runs it to its end, and gives what it printed.
    pub(super) fn answer(&self, remedy: &'static str) -> Result<String, CommandFailed> {
        let mut command = Command::new(self.program);
        command.args(&self.words).stdin(Stdio::null());
        let output = command.output().map_err(|source| CommandFailed::NotRun {
            command: self.text(),
            source,
        })?;
        let [answer, said] = [output.stdout, output.stderr]
            .map(|bytes| String::from_utf8_lossy(&bytes).trim().to_owned());
        if output.status.success() {
            return Ok(answer);
        }
        Err(CommandFailed::Failed {
            command: self.text(),
            status: output.status.to_string(),
            said: shown(if said.is_empty() { &answer } else { &said }),
            remedy,
        })
    }

    /// That an answer is not what it should be.
    pub(super) fn unclear(&self, answer: &str, expected: &'static str) -> CommandFailed {
        CommandFailed::Unclear {
            command: self.text(),
            said: shown(answer),
            expected,
        }
    }

    /// As a shell would take it.
    fn text(&self) -> String {
        let words = self
            .words
            .iter()
            .map(|word| quoted(&word.to_string_lossy()));
        let all: Vec<String> = [self.program.to_owned()].into_iter().chain(words).collect();
        all.join(" ")
    }
}

/// What a command printed, on one line that does not fill the screen.
fn shown(said: &str) -> String {
    let lines: Vec<&str> = said.lines().map(str::trim).collect();
    let said = lines.join("; ");
    let said = said.trim_end_matches(['.', ';', ' ']);
    match said.is_empty() {
        true => "it said nothing".to_owned(),
        false => visible::shortened(said.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_that_is_missing_or_fails_is_said_with_all_that_was_run() {
        let missing = SlurmCommand::new("sbatch-that-is-not-there", &["--array=0-3", "a b"]);
        let error = missing.answer("").unwrap_err().to_string();
        assert!(
            error.contains("`sbatch-that-is-not-there --array=0-3 'a b'` cannot be run"),
            "{error}"
        );
        assert!(error.contains("PATH"), "{error}");
        let failing = SlurmCommand::new("sh", &["-c", "echo no such partition. >&2; exit 3"]);
        let error = failing.answer("Give another.").unwrap_err().to_string();
        assert!(
            error.contains("(exit status: 3): no such partition. Give another."),
            "{error}"
        );
        let silent = SlurmCommand::new("false", &[] as &[&str]);
        let error = silent.answer("x").unwrap_err().to_string();
        assert!(error.contains("it said nothing"), "{error}");
    }
}
