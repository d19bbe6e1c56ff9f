//! Inside tmux: sizes, detach and attach, and a session that is killed.

use std::process::{Command, Output};

use seacable::run::RunState;

use crate::pty::{Pty, Start};
use crate::work::{
    ENDLESS, LIST, SETTINGS, any_colour, at_work, installed, only_run, place, recovered, report,
    rows, search_path, until,
};

const NEW: &str = "new-session -s work";
const ATTACH: &str = "attach-session -t work";

/// A tmux server of its own, without the user's settings; it ends with the test.
struct Tmux {
    pty: Pty,
}

impl Tmux {
    /// A terminal of this size with a session on it, and in the session a shell.
    fn start(size: (u16, u16)) -> Self {
        let dir = place();
        // Without the status line the program has the whole terminal.
        let words = "set -g status off\n\
             set -g default-command \"PS1='$ ' exec bash --norc --noprofile\"\n";
        std::fs::write(dir.path().join("tmux.conf"), words).unwrap();
        let pty = client(size, NEW, dir);
        pty.wait_for("$ ");
        Self { pty }
    }

    /// Another terminal on the same session, after the first one has left it.
    fn attach(&mut self, size: (u16, u16)) {
        let dir = std::mem::replace(&mut self.pty.dir, tempfile::tempdir().unwrap());
        self.pty = client(size, ATTACH, dir);
    }

    fn tell(&self, words: &[&str]) -> Output {
        let dir = self.pty.dir.path();
        Command::new(installed("tmux"))
            .arg("-S")
            .arg(dir.join("socket"))
            .args(words)
            .output()
            .unwrap()
    }
}

impl Drop for Tmux {
    fn drop(&mut self) {
        self.tell(&["kill-server"]);
    }
}

fn client(size: (u16, u16), words: &str, dir: tempfile::TempDir) -> Pty {
    let tmux = installed("tmux").display().to_string();
    let script = format!(
        r#""{tmux}" -S "$HOME/socket" -f "$HOME/tmux.conf" {words}; echo "[ended $?]"; read -r line"#
    );
    let path = search_path();
    Start {
        size,
        vars: &[("LANG", "C.UTF-8"), ("PATH", &path)],
        args: &[],
        script: &script,
    }
    .go_in(dir)
}

fn from_the_list_to_a_saved_report(size: (u16, u16)) {
    let mut tmux = Tmux::start(size);
    let pty = &mut tmux.pty;
    pty.send("seacable --fresh\r");
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    pty.send("R");
    pty.wait_for("is done");
    pty.send("2");
    pty.wait_for("Tension at the joints");
    pty.wait_for("time [s]");
    pty.send("V");
    pty.wait("the validation table", |screen| {
        let text = screen.contents();
        text.contains("outcome") && text.contains("PASS")
    });
    pty.send("5");
    pty.wait_for("`w` saves it");
    pty.send("w");
    pty.wait_for("The report is in runs/manifold-");
    let text = report(pty.dir.path());
    assert!(
        text.contains(LIST) && text.lines().any(|l| l.contains("PASS")),
        "{text}"
    );
    pty.send("q");
    pty.wait("the shell, and nothing left above it", |screen| {
        let text = screen.contents();
        text.trim_end().ends_with('$') && !text.contains("quit")
    });
    pty.send("exit\r");
    pty.ended(0);
    assert!(at_work(pty.dir.path()).is_empty());
}

#[test]
#[ignore = "left out: needs tmux; .ci/run runs it"]
fn from_the_list_to_a_saved_report_at_80x24() {
    from_the_list_to_a_saved_report((80, 24));
}

#[test]
#[ignore = "left out: needs tmux; .ci/run runs it"]
fn from_the_list_to_a_saved_report_at_200x60() {
    from_the_list_to_a_saved_report((200, 60));
}

#[test]
#[ignore = "left out: needs tmux; .ci/run runs it"]
fn from_the_list_to_a_saved_report_at_60x20() {
    from_the_list_to_a_saved_report((60, 20));
}

/// What tmux shows of the program; tmux itself has the terminal outside.
#[test]
#[ignore = "left out: needs tmux; .ci/run runs it"]
fn locale_terminal_and_no_color_decide_what_is_shown_at_every_size() {
    for size in [(80, 24), (200, 60), (60, 20)] {
        let mut tmux = Tmux::start(size);
        for setting in SETTINGS {
            tmux.pty
                .send(&format!("clear; env {} seacable --fresh\r", setting.words));
            tmux.pty.wait_for(LIST);
            tmux.pty.send("\r");
            tmux.pty.wait_for("solver alpha");
            tmux.pty.send("2");
            tmux.pty.wait_for("time [s]");
            let shown = tmux
                .tell(&["capture-pane", "-e", "-p", "-t", "work"])
                .stdout;
            assert_eq!(shown.is_ascii(), setting.ascii, "{}", setting.words);
            if !setting.colour {
                assert!(!any_colour(&shown), "{}", setting.words);
            }
            tmux.pty.send("q");
            tmux.pty
                .wait("the shell", |screen| !screen.contents().contains("q quit"));
        }
        tmux.pty.send("clear; TERM=dumb seacable\r");
        tmux.pty.wait_for("seacable run CASE");
        tmux.pty.wait("the shell", |screen| {
            screen.contents().trim_end().ends_with('$')
        });
    }
}

#[test]
#[ignore = "left out: needs tmux; .ci/run runs it"]
fn a_run_continues_through_resizes_and_while_nobody_is_attached() {
    let mut tmux = Tmux::start((80, 24));
    tmux.pty.send(&format!("seacable --in-process {ENDLESS}\r"));
    tmux.pty.wait_for("solver alpha");
    tmux.pty.send("R2");
    tmux.pty.wait_for("time [s]");
    let dir = tmux.pty.dir.path().to_owned();
    until("rows of the history", || rows(&dir) > 3);
    tmux.pty.resize(200, 60);
    tmux.pty.wait_for("Tension along the line");
    tmux.pty.resize(39, 9);
    tmux.pty.wait_for("need 40x10");
    tmux.pty.resize(80, 24);
    tmux.pty.wait_for("time [s]");
    assert_eq!(at_work(&dir).len(), 1);

    tmux.pty.send("\x02d");
    tmux.pty.ended(0);
    let before = rows(&dir);
    until("more rows, with nobody attached", || rows(&dir) > before);

    tmux.attach((120, 30));
    tmux.pty.wait("two panes", |screen| {
        let text = screen.contents();
        text.contains("1 Inputs") && text.contains("time [s]")
    });
    tmux.pty.send("\x03");
    tmux.pty.wait_for("Ctrl-C again quits");
    tmux.pty.send("\x03");
    until("the end of the program", || at_work(&dir).is_empty());
    tmux.pty.wait_for("$ ");
    let run = only_run(&dir).unwrap();
    assert_ne!(run.info.state, RunState::Done);
    assert!(run.history.time.len() > before);
}

#[test]
#[ignore = "left out: needs tmux; .ci/run runs it"]
fn a_killed_session_leaves_no_process_and_keeps_the_work() {
    let mut tmux = Tmux::start((80, 24));
    let dir = tmux.pty.dir.path().to_owned();
    tmux.pty.send(&format!("seacable --in-process {ENDLESS}\r"));
    tmux.pty.wait_for("solver alpha");
    tmux.pty.send("R");
    until("rows of the history", || rows(&dir) > 3);
    tmux.pty.send("M");
    tmux.pty.wait_for("*unsaved");
    until("the edit to be kept", || recovered(&dir).len() == 1);
    assert_eq!(at_work(&dir).len(), 1);

    let said = tmux.tell(&["kill-session", "-t", "work"]);
    assert!(said.status.success(), "{said:?}");
    until("the end of the program", || at_work(&dir).is_empty());
    tmux.pty.wait_for("[ended");

    let kept = recovered(&dir);
    assert!(kept[0].contains("method = \"static\""), "{}", kept[0]);
    let run = only_run(&dir).unwrap();
    assert_eq!(run.info.state, RunState::Partial);
    assert!(run.history.time.len() > 3);
}
