//! What is known of the last fault of the program: a file beside what else outlives a session, for `seacable doctor` and for reports.

use std::backtrace::Backtrace;
use std::io;
use std::panic::PanicHookInfo;
use std::path::PathBuf;

use crate::VERSION;
use crate::clock::{now, rfc3339};
use crate::files::{WriteTarget, disk, read};
use crate::places::state_dir;

/// The last fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LastCrash {
    /// The file that describes it.
    pub path: PathBuf,
    /// When it was.
    pub time: String,
    /// What happened, and where in the program.
    pub what: String,
}

fn path() -> io::Result<PathBuf> {
    Ok(state_dir()?.join("crash.log"))
}

/// Keeps a fault in place of the one before. A disk that refuses is no further fault.
pub fn keep(info: &PanicHookInfo<'_>) {
    let thread = std::thread::current();
    let var = |name: &str| std::env::var(name).unwrap_or_default();
    let text = format!(
        "time: {}\nversion: {VERSION}\nthread: {}\nTERM: {}\nwhat: {}\n\n{}\n",
        rfc3339(now()),
        thread.name().unwrap_or("unnamed"),
        var("TERM"),
        info.to_string().replace('\n', " "),
        Backtrace::force_capture()
    );
    // Best effort: the fault itself is reported on the screen.
    let _ = write(&text);
}

fn write(text: &str) -> io::Result<()> {
    let path = path()?;
    if let Some(dir) = path.parent() {
        disk::create_dir_all(dir)?;
    }
    Ok(WriteTarget::replacing(&path).write(text.as_bytes())?)
}

/// The last fault, if any is known.
#[must_use]
pub fn last() -> Option<LastCrash> {
    let path = path().ok()?;
    let text = read::text_lossy(&path).ok()?;
    let line = |name: &str| {
        let mut lines = text.lines();
        lines.find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    };
    Some(LastCrash {
        time: line("time").unwrap_or_default().to_owned(),
        what: line("what").unwrap_or_default().to_owned(),
        path,
    })
}
