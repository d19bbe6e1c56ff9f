//! Files that hold no case at all, and how faults are shown.

use std::path::Path;

use seacable::case::{self, Diagnostic};

use super::{GOOD, assert_fault, faults};

fn load(path: &Path) -> Diagnostic {
    let mut found = case::load(path).unwrap_err();
    assert_eq!(found.len(), 1, "{found:#?}");
    found.remove(0)
}

#[test]
fn syntax_that_is_not_toml() {
    let text = "[case]\ntitle = \nsource = ?\n[line\n";
    let found = faults(text);
    assert!(found.len() >= 2, "{found:#?}");
    assert_fault(&found[0], (2, 9), "", "this is not TOML", "key = value");
    let last = found.last().unwrap();
    assert_fault(
        last,
        (4, 6),
        "",
        "this is not TOML: unclosed table",
        "key = value",
    );
    let shown = last.render(false);
    assert!(shown.contains("4 | [line\n  |      ^"), "{shown}");
}

#[test]
fn no_such_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("none.toml");
    let fault = load(&path);
    assert_fault(
        &fault,
        (1, 1),
        "",
        "there is no such file",
        "check the name",
    );
    assert!(fault.file.ends_with("none.toml"));
}

#[test]
fn a_directory() {
    let folder = tempfile::tempdir().unwrap();
    assert_fault(
        &load(folder.path()),
        (1, 1),
        "",
        "is a directory",
        "name a case file",
    );
}

#[test]
fn an_empty_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("empty.toml");
    for text in ["", " \n\n", "# only a comment\n"] {
        std::fs::write(&path, text).unwrap();
        assert_fault(&load(&path), (1, 1), "", "the file is empty", "[case]");
    }
}

#[test]
fn a_binary_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("binary.toml");
    std::fs::write(&path, b"[case]\nt\xff\xfe\x00").unwrap();
    assert_fault(
        &load(&path),
        (2, 2),
        "",
        "this is not text: byte 9",
        "UTF-8",
    );
    std::fs::write(&path, b"[case]\nt\0\0").unwrap();
    let found = case::load(&path).unwrap_err();
    assert!(
        found
            .iter()
            .all(|fault| fault.problem.contains("this is not TOML"))
    );
}

#[test]
fn a_fault_is_shown_under_its_line() {
    let text = GOOD.replace("length_m = 80.0", "length_m = -80.0");
    let shown = case::render_all(&faults(&text), false);
    assert_eq!(
        shown,
        "error: line.upper.length_m: is out of range: -80 m
  --> bad.toml:18:12
   |
18 | length_m = -80.0
   |            ^^^^^
   |
   = help: give greater than 0 m, up to 1e5 m"
    );
    assert!(case::render_all(&faults(&text), true).contains('\u{1b}'));
}

#[test]
fn a_byte_order_mark_is_no_fault_and_moves_no_column() {
    let text = format!("\u{feff}{GOOD}");
    assert!(case::parse(&text, "bom.toml").is_ok());
    let edited = case::edit::set(&text, "case.title", "Other").unwrap();
    assert_eq!(edited, text.replace("\"Test\"", "\"Other\""));
    let found = faults(&text.replace("length_m = 80.0", "length_m = -80.0"));
    assert_fault(
        &found[0],
        (18, 12),
        "line.upper.length_m",
        "out of range",
        "greater than 0 m",
    );
}
