//! Writing the user's files: never half of one, never over one that the user did not mean.

use std::path::{Path, PathBuf};

use super::msg::Msg;
use super::state::Severity;
use crate::visible;
use seacable_base::files::{Existing, WriteError, WriteTarget};

/// Saves a case: to a new file, or over the file that links lead to, which should still hold `expected`.
pub(super) fn save_case(path: PathBuf, text: String, expected: Option<&str>, new: bool) -> Msg {
    let existing = match expected {
        _ if new => Existing::Keep,
        Some(expected) => Existing::ReplaceIfUnchanged(expected),
        None => Existing::Replace,
    };
    let linked = path.canonicalize().ok().filter(|_| !new);
    let target = WriteTarget {
        existing,
        ..WriteTarget::new(linked.as_deref().unwrap_or(&path))
    };
    match target.write(text.as_bytes()) {
        Ok(()) => Msg::Saved(path, text),
        Err(WriteError::Changed(_)) => Msg::ChangedOnDisk,
        Err(error) => Msg::NotSaved(format!("{error}.")),
    }
}

/// Writes a new file.
pub(super) fn write_new(path: &Path, text: &str) -> Result<(), String> {
    let written = WriteTarget::new(path).write(visible::toml(text).as_bytes());
    written.map_err(|error| format!("The file is not made: {error}."))
}

/// Writes to the name asked for, or the first free one of `name-2`, `name-3` and so on.
pub(super) fn write_text(path: &Path, text: &str, what: &str) -> Msg {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let numbered = (2..10_000_u32).map(|n| path.with_file_name(format!("{stem}-{n}.txt")));
    let text = match path.extension() {
        Some(extension) if extension == "toml" => visible::toml(text),
        _ => visible::text(text),
    };
    for target in std::iter::once(path.to_owned()).chain(numbered) {
        match WriteTarget::new(&target).write(text.as_bytes()) {
            Ok(()) => {
                return Msg::Say(
                    Severity::Info,
                    format!("{what} is in {}.", visible::path(&target)),
                );
            }
            Err(WriteError::Exists(_) | WriteError::IsLink(_) | WriteError::NotRegular(_)) => {}
            Err(error) => {
                return Msg::Say(
                    Severity::Error,
                    format!("{what} cannot be written: {error}."),
                );
            }
        }
    }
    let words = format!("{what} finds no free name beside {}.", visible::path(path));
    Msg::Say(Severity::Error, words)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn saved(path: &Path, expected: Option<&str>, new: bool) -> Msg {
        save_case(path.to_owned(), "new".to_owned(), expected, new)
    }

    #[test]
    fn a_file_is_replaced_through_links_with_its_permissions() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let dir = tempfile::tempdir().unwrap();
        let (file, link) = (dir.path().join("a.toml"), dir.path().join("link.toml"));
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&file, &link).unwrap();
        assert!(matches!(saved(&link, Some("old"), false), Msg::Saved(..)));
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert_eq!(
            fs::metadata(&file).unwrap().permissions().mode() & 0o777,
            0o640
        );
        assert!(link.symlink_metadata().unwrap().is_symlink());
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 2);
    }

    #[test]
    fn a_file_that_is_read_only_or_changed_or_there_already_is_left_alone() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("a.toml");
        fs::write(&file, "other").unwrap();
        assert!(matches!(
            saved(&file, Some("old"), false),
            Msg::ChangedOnDisk
        ));
        assert!(matches!(saved(&file, None, true), Msg::NotSaved(_)));
        let mut permissions = fs::metadata(&file).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&file, permissions).unwrap();
        assert!(matches!(
            saved(&file, Some("other"), false),
            Msg::NotSaved(_)
        ));
        assert_eq!(fs::read_to_string(&file).unwrap(), "other");
    }

    #[test]
    fn texts_take_the_next_free_name() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("report.txt");
        write_text(&file, "one", "The report");
        write_text(&file, "two", "The report");
        assert_eq!(fs::read_to_string(&file).unwrap(), "one");
        assert_eq!(
            fs::read_to_string(dir.path().join("report-2.txt")).unwrap(),
            "two"
        );
    }
}
