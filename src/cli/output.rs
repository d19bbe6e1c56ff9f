//! Standard output and standard error.

use std::{
    io::{self, Write},
    path::{Path, PathBuf},
};

use super::{Failure, inputs};
use crate::{
    files::{Existing, Target},
    report::plain,
};

/// Prints results.
pub(super) fn results(text: &str, ascii: bool) -> Result<(), Failure> {
    let text = if ascii {
        plain::ascii(text)
    } else {
        text.into()
    };
    bytes(text.as_bytes())
}

/// Prints results as they are. A reader that has left, as `head` does, is no trouble.
pub(super) fn bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Output(source)),
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
    ) -> Result<Option<Self>, Failure> {
        Self::check_option("--output", path, force, inputs)
    }

    /// The file of an option, if it is given.
    pub(super) fn check_option(
        option: &'static str,
        path: Option<&'a Path>,
        force: bool,
        inputs: &[PathBuf],
    ) -> Result<Option<Self>, Failure> {
        let Some(path) = path else { return Ok(None) };
        let file = Self {
            option,
            path,
            force,
            inputs: inputs::inputs(inputs),
        };
        let checked = file.target().check();
        checked.map_err(|source| Failure::Write { option, source })?;
        Ok(Some(file))
    }

    /// Writes the file.
    pub(super) fn write(&self, contents: &[u8]) -> Result<(), Failure> {
        let written = self.target().write(contents);
        written.map_err(|source| Failure::Write {
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

/// Tells the user something; when nobody can hear it, nothing is lost.
pub(super) fn message(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
