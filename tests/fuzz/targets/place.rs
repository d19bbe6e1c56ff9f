//! Where inputs are read: an empty folder for the whole process and one of each thread, so that no input reaches other files.

use std::cell::OnceCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use tempfile::TempDir;

/// Files beside every input, as shipped cases name them.
const BESIDE: [(&str, &[u8]); 5] = [
    (
        "volturnus_data/semi.1",
        include_bytes!("../../../cases/systems/volturnus_data/semi.1"),
    ),
    (
        "volturnus_data/semi.3",
        include_bytes!("../../../cases/systems/volturnus_data/semi.3"),
    ),
    (
        "volturnus_data/semi.12d",
        include_bytes!("../../../cases/systems/volturnus_data/semi.12d"),
    ),
    (
        "landing_craft.csv",
        include_bytes!("../../../cases/ship/landing_craft.csv"),
    ),
    (
        "section.toml",
        include_bytes!("../../../cases/umbilical/section.toml"),
    ),
];

thread_local! {
    static PLACE: OnceCell<TempDir> = const { OnceCell::new() };
}

/// Goes to an empty folder: names that an input gives relative to here lead to nothing.
pub(crate) fn enter() {
    static HERE: OnceLock<TempDir> = OnceLock::new();
    HERE.get_or_init(|| {
        let dir = tempfile::tempdir().unwrap();
        std::env::set_current_dir(dir.path()).unwrap();
        dir
    });
}

/// A path in the folder of this thread.
pub(super) fn path(name: &str) -> PathBuf {
    PLACE.with(|place| place.get_or_init(new_place).path().join(name))
}

/// The same as text.
pub(super) fn file(name: &str) -> String {
    path(name).display().to_string()
}

fn new_place() -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    for (name, bytes) in BESIDE {
        put(&dir.path().join(name), bytes);
    }
    dir
}

/// Writes a file and the folders that it needs.
pub(super) fn put(path: &Path, bytes: &[u8]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, bytes).unwrap();
}

/// An input as text whose file names stay in the folder: a slash follows a letter or a digit, so that no name begins with one and none
/// goes up.
pub(super) fn contained(data: &[u8]) -> String {
    let text = String::from_utf8_lossy(data);
    let mut before = ' ';
    let text: String = text
        .chars()
        .map(|c| {
            let leads_out = c == '/' && !before.is_ascii_alphanumeric();
            before = c;
            if leads_out { '_' } else { c }
        })
        .collect();
    // The same slash escaped.
    let escaped = ["002f", "002F", "\\x2f", "\\x2F"];
    escaped
        .iter()
        .fold(text, |text, slash| text.replace(slash, "002e"))
}
