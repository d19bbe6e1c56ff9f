//! Where the files lie that a case names: below the root of its project.
//!
//! The root is the directory of `--root`; without it the directory that the user opened, if the case lies below it; else the nearest
//! folder named `cases` that the case lies below; else the folder of the case. Where a name leads is asked of the system, links and `..`
//! resolved. Names that the user types, as in `--set`, may lead anywhere, but what stands outside is never quoted.

use crate::visible;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{PoisonError, RwLock};

use serde::{Deserialize, Serialize};

use super::read;

/// A folder of this name is the root of the cases below it.
const CASES: &str = "cases";

/// The folder of the case of a stored run: it holds no files, as runs carry what they need.
pub const NOWHERE: &str = "\0";

/// What the user said.
struct UserPaths {
    root: Option<PathBuf>,
    opened: Vec<PathBuf>,
    names: Vec<String>,
}

static GIVEN: RwLock<UserPaths> = RwLock::new(UserPaths {
    root: None,
    opened: Vec::new(),
    names: Vec::new(),
});

fn say(what: impl FnOnce(&mut UserPaths)) {
    what(&mut GIVEN.write().unwrap_or_else(PoisonError::into_inner));
}

fn said<T>(what: impl FnOnce(&UserPaths) -> T) -> T {
    what(&GIVEN.read().unwrap_or_else(PoisonError::into_inner))
}

/// Sets the root of all cases.
///
/// # Errors
/// There is no such directory.
pub fn set(dir: &Path) -> io::Result<()> {
    let dir = dir.canonicalize()?;
    if !dir.is_dir() {
        return Err(io::ErrorKind::NotADirectory.into());
    }
    say(|given| given.root = Some(dir));
    Ok(())
}

/// Makes a directory that the user names the root of the cases below it. One that is not there is none.
pub fn open(dir: &Path) {
    if let Ok(dir) = dir.canonicalize() {
        say(|given| given.opened.push(dir));
    }
}

/// Allows a name of a file, or the value of a key that may be one, that the user types.
pub fn allow(name: &str) {
    let name = name.trim_matches(['"', '\'']).to_owned();
    say(|given| given.names.push(name));
}

/// What the user said of where files may lie, for another process that is to read the same.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct GivenRoots {
    /// The root of all cases.
    pub root: Option<PathBuf>,
    /// Directories that the user opened.
    #[serde(default)]
    pub opened: Vec<PathBuf>,
    /// Names that the user typed.
    #[serde(default)]
    pub names: Vec<String>,
}

impl GivenRoots {
    /// What was said to this process so far.
    #[must_use]
    pub fn of_this_process() -> Self {
        said(|given| Self {
            root: given.root.clone(),
            opened: given.opened.clone(),
            names: given.names.clone(),
        })
    }

    /// Says it to this process.
    pub fn adopt(self) {
        say(|given| {
            given.root = self.root.or(given.root.take());
            given.opened.extend(self.opened);
            given.names.extend(self.names);
        });
    }
}

/// A file that a case names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReferencedPath {
    /// Where it is, without links.
    pub path: PathBuf,
    /// Whether it lies outside the root, where the user himself named it: its contents are not quoted.
    pub is_outside: bool,
}

impl ReferencedPath {
    /// Its text.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn text(&self) -> io::Result<String> {
        read::text_at(&self.path)
    }

    /// Its text; what is not UTF-8 is replaced.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn text_lossy(&self) -> io::Result<String> {
        read::lossy_at(&self.path)
    }
}

/// Where a file lies that a case in a folder names.
///
/// # Errors
/// It lies outside the root of the case, or the system refuses.
pub fn place(folder: &Path, name: &str) -> io::Result<ReferencedPath> {
    place_below(folder, &folder.join(name), name, None)
}

/// Where the directory of a run lies that a case in a folder names, here beside the case or below the current directory, where runs are kept.
///
/// # Errors
/// As [`place`].
pub fn place_of_run(folder: &Path, dir: &Path, name: &str) -> io::Result<ReferencedPath> {
    place_below(folder, dir, name, Some(&real(Path::new("."))?))
}

/// What a file that a case in a folder names is called.
#[must_use]
pub fn shown(folder: &Path, name: &str) -> String {
    match folder == Path::new(NOWHERE) {
        true => name.to_owned(),
        false => visible::path(&folder.join(name)),
    }
}

/// Where a file lies that is named in a file of another program, at its path.
///
/// # Errors
/// As [`place`].
pub fn place_at(folder: &Path, path: &Path) -> io::Result<ReferencedPath> {
    place_below(folder, path, "", None)
}

/// Whether there is a file of this name, beside a case in a folder or by itself, that lies outside the root of the case.
pub fn is_outside(folder: &Path, file: &str) -> bool {
    let Ok(root) = root_of(folder) else {
        return true;
    };
    let leads_out = |path: &Path| {
        path.canonicalize()
            .is_ok_and(|path| !path.starts_with(&root))
    };
    leads_out(&folder.join(file)) || leads_out(Path::new(file))
}

fn place_below(
    folder: &Path,
    path: &Path,
    name: &str,
    also: Option<&Path>,
) -> io::Result<ReferencedPath> {
    if folder == Path::new(NOWHERE) {
        let reason = "a stored run carries the files that it needs, and this one is not among them";
        return Err(io::Error::new(io::ErrorKind::NotFound, reason));
    }
    let root = root_of(folder)?;
    let path = real(path)?;
    let is_below = |root: &Path| path.starts_with(root);
    let is_outside = !is_below(&root) && !also.is_some_and(is_below);
    if is_outside && !said(|given| given.names.iter().any(|known| known == name)) {
        let reason = format!(
            "it lies outside {}, where files that a case names must lie; --root DIR names another directory",
            visible::path(&root)
        );
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, reason));
    }
    Ok(ReferencedPath { path, is_outside })
}

/// Whether something found below a directory leads outside it, and outside the root that the user set.
pub fn leads_outside(top: &Path, path: &Path) -> bool {
    let root = said(|given| given.root.clone());
    let is_below = |dir: &Path, path: &Path| path.starts_with(dir);
    match (real(top), real(path)) {
        (Ok(top), Ok(path)) => {
            !is_below(&top, &path) && !root.is_some_and(|root| is_below(&root, &path))
        }
        _ => true,
    }
}

/// The root of the cases in a folder.
fn root_of(folder: &Path) -> io::Result<PathBuf> {
    if let Some(root) = said(|given| given.root.clone()) {
        return Ok(root);
    }
    let folder = real(folder)?;
    let opened = said(|given| {
        let around = given.opened.iter().filter(|dir| folder.starts_with(dir));
        around.min_by_key(|dir| dir.as_os_str().len()).cloned()
    });
    let is_cases = |dir: &&Path| dir.file_name().is_some_and(|name| name == CASES);
    let cases = || folder.ancestors().find(is_cases).map(Path::to_owned);
    Ok(opened.or_else(cases).unwrap_or(folder))
}

/// A path without links and `..`, of which the end need not exist.
fn real(path: &Path) -> io::Result<PathBuf> {
    let path = match path.as_os_str().is_empty() {
        true => Path::new("."),
        false => path,
    };
    match path.canonicalize() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            match (path.parent(), path.file_name()) {
                (Some(parent), Some(name)) => Ok(real(parent)?.join(name)),
                _ => Err(error),
            }
        }
        found => found,
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::os::unix::fs::symlink;

    use super::*;

    /// A project `p` with a table, another file outside it, and a link to that.
    fn project() -> tempfile::TempDir {
        let dir = tempfile::tempdir().unwrap();
        let put = |name: &str| fs::write(dir.path().join(name), name).unwrap();
        fs::create_dir_all(dir.path().join("p/sub")).unwrap();
        put("p/m.csv");
        put("secret");
        symlink("../secret", dir.path().join("p/link")).unwrap();
        symlink("..", dir.path().join("p/up")).unwrap();
        symlink("m.csv", dir.path().join("p/inside")).unwrap();
        dir
    }

    #[test]
    fn a_case_names_files_below_its_folder_alone() {
        let dir = project();
        let folder = dir.path().join("p");
        let text = |name: &str| place(&folder, name).and_then(|place| place.text());
        for name in ["m.csv", "./m.csv", "sub/../m.csv", "inside"] {
            assert_eq!(text(name).unwrap(), "p/m.csv", "{name}");
        }
        let secret = dir.path().join("secret");
        for name in [
            "../secret",
            "link",
            "up/secret",
            "sub/../../secret",
            "../absent",
            secret.to_str().unwrap(),
            "/etc/passwd",
        ] {
            let error = text(name).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::PermissionDenied, "{name}");
            assert!(error.to_string().contains("--root"), "{name}: {error}");
        }
        assert_eq!(text("absent").unwrap_err().kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn a_folder_named_cases_and_a_directory_that_is_opened_are_roots() {
        let dir = tempfile::tempdir().unwrap();
        for folder in ["cases/a", "cases/b", "other/a", "other/b"] {
            fs::create_dir_all(dir.path().join(folder)).unwrap();
            fs::write(dir.path().join(folder).join("t.csv"), "t").unwrap();
        }
        let is_found = |folder: &str| place(&dir.path().join(folder), "../b/t.csv").is_ok();
        assert!(is_found("cases/a"));
        assert!(!is_found("other/a"));
        open(&dir.path().join("other"));
        assert!(is_found("other/a"));
    }

    #[test]
    fn what_the_user_types_is_allowed_and_known_to_lie_outside() {
        let dir = project();
        let secret = dir.path().join("secret");
        allow(&format!("\"{}\"", secret.display()));
        let named = place(&dir.path().join("p"), secret.to_str().unwrap()).unwrap();
        assert!(named.is_outside);
        assert_eq!(named.text().unwrap(), "secret");
    }

    #[test]
    fn links_that_lead_outside_a_directory_are_told() {
        let dir = project();
        let top = dir.path().join("p");
        assert!(leads_outside(&top, &top.join("link")));
        assert!(leads_outside(&top, &top.join("up")));
        assert!(!leads_outside(&top, &top.join("inside")));
    }
}
