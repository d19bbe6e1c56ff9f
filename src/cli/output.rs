//! Standard output and standard error.

use std::{
    io::{self, Write},
    path::{Path, PathBuf},
};

use super::{CommandError, inputs};
use crate::{
    files::{Existing, Target},
    report::{chart::Glyphs, plain},
};

/// Prints results.
pub(super) fn results(text: &str, ascii: bool) -> Result<(), CommandError> {
    let text = if ascii {
        plain::ascii(text)
    } else {
        text.into()
    };
    bytes(text.as_bytes())
}

/// Prints results as they are. A reader that leaves early, as `head` does, is not an error.
pub(super) fn bytes(bytes: &[u8]) -> Result<(), CommandError> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(CommandError::Output(source))
        }
        _ => Ok(()),
    }
}

/// The file that an option names.
#[derive(Debug)]
pub(super) struct OutputFile<'a> {
    option: &'static str,
    path: &'a Path,
    force: bool,
    inputs: Vec<PathBuf>,
}

impl<'a> OutputFile<'a> {
    /// The file of `--output`, if it is given. Fails before anything is computed where it cannot be written.
    pub(super) fn check(
        path: Option<&'a Path>,
        force: bool,
        inputs: &[PathBuf],
    ) -> Result<Option<Self>, CommandError> {
        Self::check_option("--output", path, force, inputs)
    }

    /// The file of an option, if it is given.
    pub(super) fn check_option(
        option: &'static str,
        path: Option<&'a Path>,
        force: bool,
        inputs: &[PathBuf],
    ) -> Result<Option<Self>, CommandError> {
        let Some(path) = path else { return Ok(None) };
        let file = Self {
            option,
            path,
            force,
            inputs: inputs::inputs(inputs),
        };
        let checked = file.target().check();
        checked.map_err(|source| CommandError::Write { option, source })?;
        Ok(Some(file))
    }

    /// Writes the file.
    pub(super) fn write(&self, contents: &[u8]) -> Result<(), CommandError> {
        let written = self.target().write(contents);
        written.map_err(|source| CommandError::Write {
            option: self.option,
            source,
        })
    }

    fn target(&self) -> Target<'_> {
        Target {
            path: self.path,
            inputs: &self.inputs,
            existing: if self.force {
                Existing::Replace
            } else {
                Existing::Keep
            },
        }
    }
}

/// Prints a message on standard error. A closed standard error is not an error.
pub(super) fn message(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// The characters to draw with.
pub(super) fn glyphs(ascii: bool) -> Glyphs {
    if ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    }
}
