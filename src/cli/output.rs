//! Standard output and standard error.

use std::io::{self, Write};

use super::Failure;
use crate::report::plain;

/// Prints results.
pub(super) fn results(text: &str, ascii: bool) -> Result<(), Failure> {
    let text = if ascii {
        plain::ascii(text)
    } else {
        text.into()
    };
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(Failure::stdout)
}

/// Tells the user something; when nobody can hear it, nothing is lost.
pub(super) fn message(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
