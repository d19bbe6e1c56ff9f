//! The cases that come with the program are free of faults.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::path::{Path, PathBuf};

use seacable::case::{self, Loaded};

fn case_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(case_files(&path));
        } else if path.extension().is_some_and(|ending| ending == "toml") {
            files.push(path);
        }
    }
    files.sort();
    files
}

fn shipped() -> Vec<Loaded> {
    let files = case_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("cases"));
    assert!(!files.is_empty());
    files
        .iter()
        .map(|path| match case::load(path) {
            Ok(loaded) => loaded,
            Err(faults) => {
                let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
                panic!("{}", told.join("\n"))
            }
        })
        .collect()
}

#[test]
fn shipped_cases_have_no_faults() {
    shipped();
}
