//! Over SSH: the workbench in a terminal, the commands without one, and a client that is killed.

use std::path::Path;
use std::process::Output;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use seacable::run::RunState;

use crate::pty::{Pty, Start};
use crate::sshd::Sshd;
use crate::work::{
    ENDLESS, LIST, SETTINGS, any_colour, at_work, installed, only_run, place, recovered, report,
    rows, until,
};

/// A program whose user is gone ends within this time.
const SECONDS: Duration = Duration::from_secs(10);

/// A client on a terminal of this size that runs these words at the other end.
fn terminal(server: &Sshd, dir: tempfile::TempDir, size: (u16, u16), words: &str) -> Pty {
    let script = format!(
        r#"(echo $BASHPID > client; exec "{}" -F "{}" -tt there '{words}')
        echo "[ended $?]"; read -r line"#,
        installed("ssh").display(),
        server.client.display(),
    );
    Start {
        size,
        script: &script,
        ..Start::default()
    }
    .go_in(dir)
}

/// Kills the client without a chance to say goodbye, and sees the program end soon.
fn kill_client(dir: &Path) {
    let text = std::fs::read_to_string(dir.join("client")).unwrap();
    let client = Pid::from_raw(text.trim().parse().unwrap()).unwrap();
    kill_process(client, Signal::KILL).unwrap();
    let killed = Instant::now();
    until("the end of the program", || at_work(dir).is_empty());
    let took = killed.elapsed();
    assert!(took < SECONDS, "the program went on for {took:?}");
}

fn words(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn output(server: &Sshd, said: &str) -> (Option<i32>, String, String) {
    let Output {
        status,
        stdout,
        stderr,
    } = server.ssh(said).output().unwrap();
    (status.code(), words(&stdout), words(&stderr))
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn locale_terminal_and_no_color_decide_what_is_sent_at_every_size() {
    let mut dir = place();
    let server = Sshd::start(dir.path());
    for setting in SETTINGS {
        for size in [(80, 24), (200, 60), (60, 20)] {
            let words = format!("cd && env {} seacable --fresh", setting.words);
            let mut pty = terminal(&server, dir, size, &words);
            pty.wait_for(LIST);
            pty.send("\r");
            pty.wait_for("solver alpha");
            pty.send("3");
            pty.wait_for("in memory");
            pty.send("5");
            pty.wait_for("`w` saves it");
            pty.send("2");
            pty.wait_for("time [s]");
            pty.send("q");
            pty.ended(0);
            let bytes = pty.bytes();
            assert_eq!(bytes.is_ascii(), setting.ascii, "{words} {size:?}");
            assert_eq!(any_colour(&bytes), setting.colour, "{words} {size:?}");
            dir = std::mem::replace(&mut pty.dir, tempfile::tempdir().unwrap());
        }
    }
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn on_a_dumb_terminal_the_commands_to_use_instead_are_named() {
    let dir = place();
    let server = Sshd::start(dir.path());
    let pty = terminal(&server, dir, (80, 24), "cd && env TERM=dumb seacable");
    pty.ended(2);
    for said in ["TERM=dumb", "seacable run CASE", "seacable report RUN_DIR"] {
        assert!(pty.text().contains(said), "{}", pty.text());
    }
    assert!(!pty.bytes().contains(&0x1b), "{}", pty.text());
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn the_workbench_in_a_terminal_from_the_list_to_a_saved_report() {
    let dir = place();
    let server = Sshd::start(dir.path());
    let mut pty = terminal(&server, dir, (200, 60), "cd && seacable --fresh");
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    pty.send("R");
    pty.wait_for("is done");
    pty.send("2");
    pty.wait_for("Tension along the line");
    pty.resize(80, 24);
    pty.wait("one chart on the small terminal", |screen| {
        let text = screen.contents();
        text.contains("Tension at the joints") && !text.contains("Tension along the line")
    });
    pty.send("V");
    pty.wait_for("PASS");
    pty.send("5");
    pty.wait_for("`w` saves it");
    pty.send("w");
    pty.wait_for("The report is in runs/manifold-");
    assert!(report(pty.dir.path()).contains(LIST));
    pty.send("q");
    pty.ended(0);
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn without_a_terminal_the_results_come_out_and_the_status_with_them() {
    let dir = place();
    let server = Sshd::start(dir.path());
    let (status, results, messages) = output(
        &server,
        "cd && seacable run cases/basics/mooring_static.toml",
    );
    assert_eq!(status, Some(0), "{messages}");
    assert!(results.starts_with("runs/mooring_static-"), "{results}");
    assert!(results.contains("tension"), "{results}");
    assert!(
        !results.contains('\x1b') && !messages.contains('\x1b'),
        "{messages}"
    );

    let (status, results, messages) = output(
        &server,
        "cd && seacable run cases/basics/mooring_static.toml --set line.rope.length=3",
    );
    assert_eq!((status, results.as_str()), (Some(2), ""), "{messages}");
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn the_workbench_without_a_terminal_says_what_to_do_instead() {
    let dir = place();
    let server = Sshd::start(dir.path());
    let (status, results, messages) = output(&server, "seacable");
    assert_eq!((status, results.as_str()), (Some(2), ""), "{messages}");
    for said in [
        "needs a terminal",
        "seacable run CASE",
        "seacable report RUN_DIR",
    ] {
        assert!(messages.contains(said), "{messages}");
    }
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn a_killed_client_ends_the_workbench_and_the_work_is_kept() {
    let dir = place();
    let server = Sshd::start(dir.path());
    let words = format!("cd && seacable --in-process {ENDLESS}");
    let mut pty = terminal(&server, dir, (80, 24), &words);
    let dir = pty.dir.path().to_owned();
    pty.wait_for("solver alpha");
    pty.send("R");
    until("rows of the history", || rows(&dir) > 3);
    pty.send("M");
    pty.wait_for("*unsaved");
    until("the edit to be kept", || recovered(&dir).len() == 1);
    assert_eq!(at_work(&dir).len(), 1);

    kill_client(&dir);
    let kept = recovered(&dir);
    assert!(kept[0].contains("method = \"static\""), "{}", kept[0]);
    let run = only_run(&dir).unwrap();
    assert_eq!(run.info.state, RunState::Partial);
    assert!(run.history.time.len() > 3);

    // The next session is offered what was not saved.
    let dir = std::mem::replace(&mut pty.dir, tempfile::tempdir().unwrap());
    let mut again = terminal(&server, dir, (80, 24), &format!("cd && seacable {ENDLESS}"));
    again.wait_for("bring them back");
    again.send("r");
    again.wait_for("*unsaved");
    kill_client(again.dir.path());
}

#[test]
#[ignore = "left out: needs an SSH server; .ci/run runs it"]
fn a_killed_client_stops_a_run_in_its_terminal_which_can_be_resumed() {
    let dir = place();
    let server = Sshd::start(dir.path());
    let words = format!("cd && seacable run {ENDLESS}");
    let pty = terminal(&server, dir, (80, 24), &words);
    let dir = pty.dir.path();
    until("rows of the history", || rows(dir) > 3);
    kill_client(dir);
    let run = only_run(dir).unwrap();
    // The hang-up stops it at its last step, with a checkpoint.
    assert_eq!(run.info.state, RunState::Cancelled);
    assert!(run.history.time.len() > 3);
}
