//! Standard output that cannot be written is an error of every command, help and version included.

use std::fs::{self, File};
use std::process::{Command, Output, Stdio};

use crate::small::SMALL;

const COMMANDS: [&[&str]; 6] = [
    &["run", "small.toml", "--out", "run"],
    &["keys", "--all"],
    &["lines"],
    &["--help"],
    &["--version"],
    &["run", "--help"],
];

fn seacable(words: &[&str], out: Stdio) -> Output {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("small.toml"), SMALL).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.args(words).current_dir(dir.path());
    command.stdout(out).stderr(Stdio::piped()).output().unwrap()
}

fn assert_told(words: &[&str], output: &Output) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{words:?}: {said}");
    let told = said.contains("Writing standard output failed");
    assert!(told && !said.contains("fault"), "{words:?}: {said}");
}

#[test]
fn a_full_device_is_an_error() {
    for words in COMMANDS {
        let full = File::options().write(true).open("/dev/full").unwrap();
        assert_told(words, &seacable(words, full.into()));
    }
}

#[test]
fn a_closed_pipe_is_an_error() {
    for words in COMMANDS {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        assert_told(words, &seacable(words, writer.into()));
    }
}
