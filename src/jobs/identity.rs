//! Which process computes a job: known again although numbers of processes are given anew, and on which host.

use std::path::Path;

use rustix::process::{Pid, Signal, getpid, kill_process, test_kill_process};
use serde::{Deserialize, Serialize};

use crate::files::read;

/// A process of a host.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProcessIdentity {
    /// Name of the host.
    pub host: String,
    /// Identity of its boot; empty where the system gives none.
    pub boot: String,
    /// Number of the process.
    pub process: i32,
    /// When the process began, in ticks of the system since its boot; 0 where the system gives none.
    pub began: u64,
}

impl ProcessIdentity {
    /// This process.
    #[must_use]
    pub fn own() -> Self {
        let process = getpid();
        Self {
            host: host(),
            boot: boot(),
            process: process.as_raw_nonzero().get(),
            began: began(process).unwrap_or(0),
        }
    }

    /// Whether it is still there; as of another host nothing is known, it is not.
    #[must_use]
    pub fn is_alive(&self) -> bool {
        let Some(process) = Pid::from_raw(self.process) else {
            return false;
        };
        let is_same = || began(process).is_none_or(|began| began == self.began);
        let is_here = self.host == host() && self.boot == boot();
        is_here && test_kill_process(process).is_ok() && is_same()
    }

    /// Asks it to end; whether it was there.
    pub(super) fn terminate(&self) -> bool {
        let process = Pid::from_raw(self.process).filter(|_| self.is_alive());
        process.is_some_and(|process| kill_process(process, Signal::TERM).is_ok())
    }
}

/// The name of this host, with characters only that file names may have.
#[must_use]
pub fn host() -> String {
    let system = rustix::system::uname();
    let name = system.nodename().to_string_lossy();
    let clean = name.chars().map(|c| match c {
        c if c.is_ascii_alphanumeric() || "-_.".contains(c) => c,
        _ => '-',
    });
    let clean: String = clean.collect();
    match clean.trim_start_matches('.') {
        "" => "localhost".to_owned(),
        name => name.to_owned(),
    }
}

fn boot() -> String {
    let text = read::text(Path::new("/proc/sys/kernel/random/boot_id"));
    text.map_or_else(|_| String::new(), |text| text.trim().to_owned())
}

/// When a process began, in ticks since the boot.
fn began(process: Pid) -> Option<u64> {
    let path = format!("/proc/{}/stat", process.as_raw_nonzero());
    let stat = read::text_lossy(Path::new(&path)).ok()?;
    // pid (name) state parent …: the name may hold blanks and brackets; the beginning is the 22nd field.
    let (_, after) = stat.rsplit_once(')')?;
    after.split_whitespace().nth(19)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn this_process_is_alive_and_another_of_its_number_is_not() {
        let own = ProcessIdentity::own();
        assert!(own.is_alive());
        let later = ProcessIdentity {
            began: own.began + 1,
            ..own.clone()
        };
        assert!(own.began == 0 || !later.is_alive());
        let elsewhere = ProcessIdentity {
            host: "elsewhere".to_owned(),
            ..own
        };
        assert!(!elsewhere.is_alive() && !elsewhere.terminate());
    }
}
