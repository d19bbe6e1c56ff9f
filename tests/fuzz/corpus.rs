//! What inputs are made of: what is shipped, and `tests/data/corpus/TARGET`: files of other programs, and inputs that once failed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::targets::Target;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data/corpus")
        .join(name)
}

/// The kept inputs of a target, in the order of their names; none where it has no folder.
pub(crate) fn kept(name: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let mut files: Vec<PathBuf> = fs::read_dir(folder(name))
        .into_iter()
        .flatten()
        .map(|item| item.unwrap().path())
        .collect();
    files.sort();
    files
        .into_iter()
        .map(|path| (path.clone(), fs::read(path).unwrap()))
        .collect()
}

/// The folders of the corpus.
pub(crate) fn folders() -> Vec<String> {
    let all = fs::read_dir(folder("")).unwrap();
    all.map(|item| item.unwrap().file_name().into_string().unwrap())
        .collect()
}

/// All inputs that those of a target are made of.
pub(crate) fn of(target: &Target) -> Vec<Vec<u8>> {
    let kept = kept(target.name).into_iter().map(|(_, data)| data);
    (target.seeds)().into_iter().chain(kept).collect()
}
