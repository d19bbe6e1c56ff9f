//! Faults of a disk, made by tests: an operation is refused, a write takes only a part, or the clock is wrong.
//!
//! In a program built with debug assertions, `SEACABLE_FAULT=17:full` lets the seventeenth operation on a disk fail as on a full one,
//! `17+:full` that one and all after it; `SEACABLE_FAULT_LOG=FILE` counts the operations in a file, a line each. `SEACABLE_CLOCK=SECONDS`
//! sets the clock, `SECONDS,STEP` one that steps so at every look. A program built without them knows none of these.

use std::io;
use std::path::Path;
use std::time::SystemTime;

/// What is asked of a disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum DiskOperation {
    /// A file or directory is made.
    Create,
    /// Bytes are written, or room for them is held.
    Write,
    /// Permissions of a file are set.
    Permissions,
    /// What is written is to survive a power cut.
    Sync,
    /// A file or directory takes a name.
    Rename,
    /// A file or directory is removed.
    Remove,
}

/// The fault that an operation meets, if a test made one.
///
/// # Errors
/// That of the fault.
pub(crate) fn met(operation: DiskOperation, path: &Path) -> io::Result<()> {
    match made::next(operation, path) {
        Some(DiskFault::Refused(errno)) => Err(errno.into()),
        Some(DiskFault::Part) | None => Ok(()),
    }
}

/// How many of `bytes` a write takes: a part where a test made that fault.
///
/// # Errors
/// That of the fault.
pub(crate) fn taken(path: &Path, bytes: usize) -> io::Result<usize> {
    match made::next(DiskOperation::Write, path) {
        Some(DiskFault::Refused(errno)) => Err(errno.into()),
        Some(DiskFault::Part) => Ok(bytes.div_ceil(2)),
        None => Ok(bytes),
    }
}

/// What the clock shows, if a test says so.
#[must_use]
pub(crate) fn clock() -> Option<SystemTime> {
    made::clock()
}

/// What a test lets happen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(not(debug_assertions), expect(dead_code, reason = "no fault is made"))]
enum DiskFault {
    Refused(rustix::io::Errno),
    Part,
}

/// Faults as the environment names them.
#[cfg(debug_assertions)]
mod made {
    use std::fs::OpenOptions;
    use std::io::Write;
    use std::path::Path;
    use std::sync::LazyLock;
    use std::sync::atomic::{AtomicI64, AtomicU64, Ordering};
    use std::time::{Duration, SystemTime, UNIX_EPOCH};

    use rustix::io::Errno;

    use super::{DiskFault, DiskOperation};

    /// Which operations fail, and how.
    #[derive(Debug, PartialEq, Eq)]
    pub(super) struct Plan {
        pub(super) first: u64,
        pub(super) goes_on: bool,
        pub(super) fault: DiskFault,
    }

    static PLAN: LazyLock<Option<Plan>> =
        LazyLock::new(|| plan(&std::env::var("SEACABLE_FAULT").ok()?));
    static COUNT: AtomicU64 = AtomicU64::new(0);

    /// `17:full`, `17+:full`.
    pub(super) fn plan(text: &str) -> Option<Plan> {
        let (number, word) = text.split_once(':')?;
        let fault = match word {
            "full" => DiskFault::Refused(Errno::NOSPC),
            "denied" => DiskFault::Refused(Errno::ACCESS),
            "broken" => DiskFault::Refused(Errno::IO),
            "part" => DiskFault::Part,
            _ => return None,
        };
        let goes_on = number.ends_with('+');
        let first = number.trim_end_matches('+').parse().ok()?;
        Some(Plan {
            first,
            goes_on,
            fault,
        })
    }

    pub(super) fn next(operation: DiskOperation, path: &Path) -> Option<DiskFault> {
        let number = COUNT.fetch_add(1, Ordering::Relaxed) + 1;
        if let Some(log) = std::env::var_os("SEACABLE_FAULT_LOG") {
            let file = OpenOptions::new().append(true).create(true).open(log);
            // A test that finds no line says so.
            let line = format!("{number} {operation:?} {}\n", path.display());
            let _ = file.and_then(|mut file| file.write_all(line.as_bytes()));
        }
        let plan = PLAN.as_ref()?;
        let is_due = number == plan.first || (plan.goes_on && number > plan.first);
        is_due.then_some(plan.fault)
    }

    /// Seconds since 1970, and what they grow by at every look.
    pub(super) fn clock() -> Option<SystemTime> {
        static LOOKS: AtomicI64 = AtomicI64::new(0);
        let text = std::env::var("SEACABLE_CLOCK").ok()?;
        let (start, step) = text.split_once(',').unwrap_or((&text, "0"));
        let step: i64 = step.parse().ok()?;
        let looks = LOOKS.fetch_add(1, Ordering::Relaxed);
        let at = start.parse::<i64>().ok()? + looks * step;
        let from_epoch = Duration::from_secs(at.unsigned_abs());
        if at < 0 {
            UNIX_EPOCH.checked_sub(from_epoch)
        } else {
            UNIX_EPOCH.checked_add(from_epoch)
        }
    }
}

/// A program for users meets no faults but the system's.
#[cfg(not(debug_assertions))]
mod made {
    use std::path::Path;
    use std::time::SystemTime;

    use super::{DiskFault, DiskOperation};

    pub(super) const fn next(_: DiskOperation, _: &Path) -> Option<DiskFault> {
        None
    }

    pub(super) const fn clock() -> Option<SystemTime> {
        None
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use rustix::io::Errno;

    use super::DiskFault;
    use super::made::{Plan, plan};

    #[test]
    fn a_plan_names_an_operation_and_its_fault() {
        let full = DiskFault::Refused(Errno::NOSPC);
        let made = |first, goes_on, fault| {
            Some(Plan {
                first,
                goes_on,
                fault,
            })
        };
        assert_eq!(plan("17:full"), made(17, false, full));
        assert_eq!(plan("17+:full"), made(17, true, full));
        assert_eq!(plan("3:part"), made(3, false, DiskFault::Part));
        assert_eq!(plan("3:odd"), None);
        assert_eq!(plan("full"), None);
    }
}
