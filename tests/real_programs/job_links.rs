//! Jobs whose screens are cut off and killed many times, also behind an SSH server.

use crate::chance::{Chance, asked, seed};
use crate::jobs::{
    SLOW, a_moment, cut_links, finish_and_compare, folders, killed_jobs, killed_screens, place,
    settle,
};
use crate::pty::{Pty, Start, wait_until};
use crate::sshd::Sshd;
use crate::work::installed;

use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process};

/// Simulated time of the runs \[s\]: some seconds.
const DURATION: u32 = 6_000;

/// The same of runs of which there are many.
const SHORT: u32 = 1_500;

#[test]
#[ignore = "left out: takes minutes; .ci/run runs it"]
fn fifty_links_are_cut_and_no_run_is_lost() {
    let mut chance = Chance::new(seed());
    cut_links(DURATION, 4, asked("SEACABLE_CUTS", 50), &mut chance);
}

#[test]
#[ignore = "left out: takes minutes; .ci/run runs it"]
fn a_hundred_screens_are_killed() {
    let mut chance = Chance::new(seed());
    killed_screens(SHORT, asked("SEACABLE_KILLS", 100), &mut chance);
}

#[test]
#[ignore = "left out: takes minutes; .ci/run runs it"]
fn a_hundred_jobs_are_killed() {
    let mut chance = Chance::new(seed());
    killed_jobs(SHORT, asked("SEACABLE_KILLS", 100), &mut chance);
}

/// A client on a terminal that runs the program at the other end, and can be killed.
fn client(server: &Sshd, dir: tempfile::TempDir) -> Pty {
    let script = format!(
        r#"echo $BASHPID > client; exec "{}" -F "{}" -tt there 'cd && exec seacable {SLOW}'"#,
        installed("ssh").display(),
        server.client.display(),
    );
    Start {
        script: &script,
        ..Start::default()
    }
    .go_in(dir)
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn a_run_goes_on_while_its_ssh_clients_are_killed() {
    let mut dir = place(DURATION);
    let server = Sshd::start(dir.path());
    let mut chance = Chance::new(seed());
    let mut cuts = 0;
    while cuts < 8 {
        let open = folders(dir.path());
        let mut pty = client(&server, dir);
        pty.wait_for("solver alpha");
        let path = pty.dir.path().to_owned();
        if open.is_empty() {
            pty.send("R");
            wait_until("the job is kept", || !folders(&path).is_empty());
        } else {
            pty.send("!");
            pty.wait_for("slow, alpha,");
        }
        a_moment(&mut chance, Duration::from_millis(400));
        let text = std::fs::read_to_string(path.join("client")).unwrap();
        let process = Pid::from_raw(text.trim().parse().unwrap()).unwrap();
        let _ = kill_process(process, Signal::KILL);
        cuts += 1;
        dir = std::mem::replace(&mut pty.dir, tempfile::tempdir().unwrap());
    }
    let dir = settle(dir);
    assert_eq!(finish_and_compare(dir.path(), 1), 0);
}
