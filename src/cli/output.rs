//! Standard output and standard error.

use std::{
    io::{self, Write},
    path::PathBuf,
};

use super::Failure;
use crate::report::plain;

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
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Write {
            path: PathBuf::from("standard output"),
            source,
        }),
        _ => Ok(()),
    }
}

/// Tells the user something; when nobody can hear it, nothing is lost.
pub(super) fn message(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
