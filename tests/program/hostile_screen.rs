//! The workbench on a pseudo-terminal, on a project whose names and texts would steer the terminal: every byte that it sends is text or
//! one of the sequences that it uses itself.

#![cfg(target_os = "linux")]

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::process::Command;

use seacable::visible::is_invisible;
use tempfile::TempDir;

use crate::hostile_text::{HOSTILE, toml_string, with_value};
use crate::pty::{Pty, Start, place};
use crate::small::SMALL;

/// What is seen of a hostile text.
const SEEN: &str = "\\u{202e}";

fn run(dir: &Path, words: &[&OsStr]) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    let done = command.args(words).current_dir(dir).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{words:?}: {said}");
}

/// A project by mail: cases and folders with hostile names, cases that are broken, runs whose files were edited.
fn project() -> TempDir {
    let dir = place();
    let title = |text: &str| with_value(text, "title", &toml_string(HOSTILE));
    let shipped = |name: &str| fs::read_to_string(dir.path().join("cases").join(name)).unwrap();
    let texts = [
        ("line", title(SMALL)),
        ("section", title(&shipped("umbilical/section.toml"))),
        ("ropeway", title(&shipped("ropeway/span_60.toml"))),
        ("system", title(&shipped("systems/crows_foot.toml"))),
        (
            "broken",
            format!("{}\n[{}]\n", title(SMALL), toml_string(HOSTILE)),
        ),
        ("raw", format!("{HOSTILE} = 1\n{SMALL}")),
        ("name", with_value(SMALL, "name", &toml_string(HOSTILE))),
    ];
    let project = dir.path().join("project");
    let below = project.join(HOSTILE);
    fs::create_dir_all(&below).unwrap();
    for (name, text) in &texts {
        fs::write(below.join(format!("{name}-{HOSTILE}.toml")), text).unwrap();
    }
    fs::write(
        below.join(OsStr::from_bytes(b"bytes\xe9\x9b2J.toml")),
        &texts[0].1,
    )
    .unwrap();
    fs::write(project.join("a.toml"), &texts[0].1).unwrap();
    for out in ["runs/one", "runs/two", "runs/broken"] {
        let words = ["run", "project/a.toml", "--out", out].map(OsStr::new);
        run(dir.path(), &words);
    }
    let file = |name: &str| dir.path().join("runs").join(name);
    let info = fs::read_to_string(file("two/run.toml")).unwrap();
    let mut spoilt = info.clone();
    for key in ["version", "started", "method", "error_method"] {
        spoilt = with_value(&spoilt, key, &toml_string(HOSTILE));
    }
    let said = format!("[{}]", toml_string(HOSTILE));
    spoilt = with_value(&spoilt, "warnings", &said);
    spoilt = with_value(&spoilt, "overrides", &said);
    fs::write(file("two/run.toml"), spoilt).unwrap();
    let said = toml_string(HOSTILE);
    let notes = format!("name = {said}\ntags = [{said}]\nnote = {said}\n");
    fs::write(file("one/notes.toml"), notes).unwrap();
    fs::write(file("broken/run.toml"), format!("{HOSTILE}\n{info}")).unwrap();
    fs::rename(file("two"), file(HOSTILE)).unwrap();
    dir
}

/// A session, and the function keys that have told that it is at rest.
struct Session {
    pty: Pty,
    told: usize,
}

impl Session {
    fn open(dir: TempDir, args: &[&str]) -> Self {
        let args = [&["--fresh"], args].concat();
        let pty = Start {
            size: (160, 50),
            args: &args,
            vars: &[("LANG", "C.UTF-8"), ("EDITOR", "true")],
            ..Start::default()
        };
        let pty = pty.go_in(dir);
        pty.wait_for("? help");
        Self { pty, told: 0 }
    }

    /// Presses keys, and waits until they are answered: the key behind them does nothing, and is named.
    fn keys(&mut self, keys: &str) {
        let sequences = ["\x1bOQ", "\x1bOR", "\x1bOS", "\x1b[15~", "\x1b[17~"];
        let at = self.told % sequences.len();
        self.told += 1;
        self.pty.send(keys);
        self.pty.send(sequences[at]);
        self.pty
            .wait_for(&format!("`f{}` does nothing here", at + 2));
    }

    /// Opens something that takes the keys, waits for its title, and closes it.
    fn over(&mut self, keys: &str, title: &str) {
        self.pty.send(keys);
        self.pty.wait_for(title);
        self.pty.send("\x1b");
        self.keys("");
    }

    /// The panes, with all that lies over them.
    fn panes(&mut self, count: usize) {
        for pane in 1..=count {
            self.keys(&pane.to_string());
            for keys in ["j", "G", "]", "]", "g"] {
                self.keys(keys);
            }
        }
        self.over("?", "Keys: ");
        self.over(":", "Commands (");
        self.over("!", "Messages, newest first");
    }

    /// Ends it, and looks at all that the terminal was sent.
    fn end(mut self) {
        self.pty.send("q");
        self.pty.ended(0);
        let bytes = self.pty.bytes();
        only_own_sequences(std::str::from_utf8(&bytes).unwrap());
    }
}

/// That a stream holds text and the sequences of the workbench only: places, colours, erasing, modes, and the clipboard in base64.
fn only_own_sequences(stream: &str) {
    let mut rest = stream;
    while let Some(at) = rest.find(is_invisible) {
        let found = &rest[at..];
        let length = own_sequence(found);
        let shown: String = found.chars().take(40).collect();
        let before: String = rest[..at].chars().rev().take(40).collect();
        let before: String = before.chars().rev().collect();
        rest = length.map_or("", |length| &found[length..]);
        assert!(length.is_some(), "{shown:?} behind {before:?}");
    }
}

/// How long the sequence is that a text begins with, where it is one of the workbench.
fn own_sequence(text: &str) -> Option<usize> {
    if text.starts_with("\r\n") {
        return Some(2);
    }
    if let Some(clip) = text.strip_prefix("\x1b]52;c;") {
        let is_base64 = |c: char| c.is_ascii_alphanumeric() || matches!(c, '+' | '/' | '=');
        let end = clip.find(|c| !is_base64(c))?;
        let closed = ["\x1b\\", "\x07"]
            .into_iter()
            .find(|close| clip[end..].starts_with(close))?;
        return Some(text.len() - clip.len() + end + closed.len());
    }
    let body = text.strip_prefix("\x1b[")?;
    let end = body.find(|c: char| !matches!(c, '0'..='9' | ';' | '?'))?;
    let (parameters, last) = (&body[..end], body[end..].chars().next()?);
    let modes = ["?25", "?1049", "?2004", "?2026"];
    let known = match last {
        'H' | 'm' | 'J' | 'K' => !parameters.contains('?'),
        'h' | 'l' => modes.contains(&parameters),
        _ => false,
    };
    known.then_some(text.len() - body.len() + end + 1)
}

#[test]
fn the_list_and_all_panes_send_text_and_own_sequences_only() {
    let dir = project();
    let mut session = Session::open(dir, &["project"]);
    session.pty.wait_for(SEEN);
    for _ in 0..10 {
        session.keys("j");
    }
    session.over("?", "Keys: ");
    // What cannot be opened says why.
    session.pty.send("/broken\r\r");
    session.pty.wait_for("(! shows all)");
    session.pty.send("\x1b");
    session.keys("");
    // What is typed is shown as escapes too.
    session.pty.send("/\u{9b}\u{202e}\u{2028}");
    session.pty.wait_for("\\u{9b}\\u{202e}");
    session.pty.send("\x1b");
    session.keys("");
    session.end();
}

#[test]
fn files_of_every_kind_send_text_and_own_sequences_only() {
    let mut dir = project();
    let moordyn = format!("project/{HOSTILE}.txt");
    let words = [
        "export",
        "cases/systems/tripod.toml",
        "--moordyn",
        "-o",
        "plain.txt",
    ];
    run(dir.path(), &words.map(OsStr::new));
    let plain = fs::read_to_string(dir.path().join("plain.txt")).unwrap();
    let spoilt = format!("{}\n{plain}", HOSTILE.replace(['\r', '\n'], ""));
    fs::write(dir.path().join(&moordyn), spoilt).unwrap();
    let kinds = ["section", "ropeway", "system"];
    let mut files = kinds
        .map(|kind| format!("project/{HOSTILE}/{kind}-{HOSTILE}.toml"))
        .to_vec();
    files.push(moordyn);
    for file in &files {
        let mut session = Session::open(dir, &[file]);
        session.panes(4);
        assert!(session.pty.text().contains(SEEN), "{}", session.pty.text());
        // The material of a section goes to the clipboard and to a file.
        session.keys("y");
        dir = std::mem::replace(&mut session.pty.dir, tempfile::tempdir().unwrap());
        session.end();
    }
    let copied = dir.path().join(".local/state/seacable/copied.txt");
    let copied = fs::read_to_string(copied).unwrap();
    assert!(copied.contains("\\u202e"), "{copied}");
    assert!(
        !copied.contains(|c| is_invisible(c) && c != '\n'),
        "{copied:?}"
    );
}

#[test]
fn runs_that_came_by_mail_send_text_and_own_sequences_only() {
    let mut session = Session::open(project(), &["project/a.toml"]);
    session.panes(8);
    session.keys("3");
    session.pty.wait_for(SEEN);
    // Its row comes before the others, and the cursor stays at its place.
    session.pty.wait_for("live, in memory");
    for keys in ["g", "j", " ", "j", " ", "j", " "] {
        session.keys(keys);
    }
    // With names of runs in the legend, and at the cursor, which is copied.
    for keys in ["2", "l", "l", "y", "]", "5", "6", "w"] {
        session.keys(keys);
    }
    session.keys("3");
    for (keys, title) in [("d", "Question"), ("c", "Until [s]"), ("n", "Name")] {
        session.over(keys, title);
    }
    session.end();
}
