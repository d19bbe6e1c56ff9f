//! The files below a directory: each directory once, however links lead to it.

use std::collections::HashSet;
use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use super::root::leads_outside;

/// What is looked for.
#[derive(Debug, Clone, Copy)]
pub struct FileSearch<'a> {
    /// How the names end, without the dot.
    pub extension: &'a str,
    /// A directory with a file of this name is left out, with all below it.
    pub except_with: &'a str,
    /// So many directories deep.
    pub depth: usize,
}

/// What is found, in the order of the names.
#[derive(Debug, Default)]
pub struct FoundFiles {
    /// The files.
    pub files: Vec<PathBuf>,
    /// Links of such names that lead outside the directory.
    pub outside: Vec<PathBuf>,
    /// Directories that could not be looked into, with the reason.
    pub faults: Vec<(PathBuf, io::Error)>,
}

impl FileSearch<'_> {
    /// Looks below a directory. Hidden files and directories are passed over, and links to directories outside.
    #[must_use]
    pub fn below(&self, top: &Path) -> FoundFiles {
        let mut walk = Walk {
            search: self,
            top,
            seen: HashSet::new(),
            links: vec![(top.to_owned(), self.depth)],
            found: FoundFiles::default(),
        };
        // Directories themselves come before links to them, so that files have their own names.
        while let Some((dir, depth)) = walk.links.pop() {
            walk.enter(&dir, depth);
        }
        let mut found = walk.found;
        found.files.sort();
        found.outside.sort();
        found
    }
}

struct Walk<'a> {
    search: &'a FileSearch<'a>,
    top: &'a Path,
    /// Device and inode of the directories looked into.
    seen: HashSet<(u64, u64)>,
    /// Links to directories, to be followed, and how deep below them is looked.
    links: Vec<(PathBuf, usize)>,
    found: FoundFiles,
}

impl Walk<'_> {
    fn enter(&mut self, dir: &Path, depth: usize) {
        if let Err(error) = self.try_enter(dir, depth) {
            self.found.faults.push((dir.to_owned(), error));
        }
    }

    fn try_enter(&mut self, dir: &Path, depth: usize) -> io::Result<()> {
        let itself = fs::metadata(dir)?;
        let is_new = self.seen.insert((itself.dev(), itself.ino()));
        if !is_new || dir.join(self.search.except_with).is_file() {
            return Ok(());
        }
        for item in fs::read_dir(dir)? {
            let item = item?;
            let (path, kind) = (item.path(), item.file_type()?);
            if item.file_name().as_encoded_bytes().starts_with(b".") {
                continue;
            }
            let is_wanted = path
                .extension()
                .is_some_and(|end| end == self.search.extension);
            let leads_to_directory = kind.is_symlink() && path.is_dir();
            match depth {
                1.. if leads_to_directory && !leads_outside(self.top, &path) => {
                    self.links.insert(0, (path, depth - 1));
                }
                _ if leads_to_directory => {}
                0 if kind.is_dir() => {
                    let reason = "directories are nested too deeply to look further";
                    self.found.faults.push((path, io::Error::other(reason)));
                }
                _ if kind.is_dir() => self.enter(&path, depth - 1),
                _ if is_wanted && kind.is_symlink() && leads_outside(self.top, &path) => {
                    self.found.outside.push(path);
                }
                _ if is_wanted => self.found.files.push(path),
                _ => {}
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    const SEARCH: FileSearch<'_> = FileSearch {
        extension: "toml",
        except_with: "run.toml",
        depth: 8,
    };

    fn names(top: &Path, paths: &[PathBuf]) -> Vec<String> {
        let name = |path: &PathBuf| path.strip_prefix(top).unwrap().display().to_string();
        paths.iter().map(name).collect()
    }

    #[test]
    fn each_directory_is_looked_into_once_and_none_outside() {
        let dir = tempfile::tempdir().unwrap();
        let top = dir.path().join("top");
        let put = |name: &str| {
            let path = dir.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "").unwrap();
        };
        for name in ["top/z.toml", "top/m/a.toml", "top/n.txt", "out/b.toml"] {
            put(name);
        }
        put("top/.hidden/c.toml");
        put("top/runs/r/run.toml");
        put("top/runs/r/case.toml");
        for (to, from) in [
            (".", "top/loop"),
            (".", "top/m/loop"),
            ("..", "top/m/up"),
            ("m", "top/also"),
            ("../out", "top/outside"),
            ("../out/b.toml", "top/b.toml"),
        ] {
            symlink(to, dir.path().join(from)).unwrap();
        }
        let found = SEARCH.below(&top);
        assert_eq!(names(&top, &found.files), ["m/a.toml", "z.toml"]);
        assert_eq!(names(&top, &found.outside), ["b.toml"]);
        assert!(found.faults.is_empty(), "{:?}", found.faults);
    }

    #[test]
    fn what_lies_too_deep_or_is_no_directory_is_a_fault() {
        let dir = tempfile::tempdir().unwrap();
        let deep = dir.path().join("1/2/3/4/5/6/7/8/9");
        fs::create_dir_all(&deep).unwrap();
        assert_eq!(SEARCH.below(dir.path()).faults.len(), 1);
        let absent = dir.path().join("absent");
        assert_eq!(SEARCH.below(&absent).faults.len(), 1);
    }
}
