//! Writing the user's files: never half of one, never over one that the user did not mean.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::msg::Msg;
use super::state::Level;

/// Writes beside the file and renames, so that no kill leaves half a case.
pub(super) fn save_case(path: PathBuf, text: String, expected: Option<&str>, new: bool) -> Msg {
    if new && path.symlink_metadata().is_ok() {
        return Msg::NotSaved(format!("{} exists already.", path.display()));
    }
    if let Some(expected) = expected
        && fs::read_to_string(&path).is_ok_and(|now| now != expected)
    {
        return Msg::ChangedOnDisk;
    }
    match replace(&path, &text, new) {
        Ok(()) => Msg::Saved(path, text),
        Err(error) => Msg::NotSaved(format!("{} cannot be written: {error}.", path.display())),
    }
}

fn replace(path: &Path, text: &str, new: bool) -> io::Result<()> {
    let target = if new {
        path.to_owned()
    } else {
        path.canonicalize()?
    };
    let permissions = if new {
        None
    } else {
        // A file that may not be written is not replaced either, though its directory would allow it.
        let file = fs::OpenOptions::new().write(true).open(&target)?;
        let permissions = file.metadata()?.permissions();
        if permissions.readonly() {
            return Err(io::Error::new(
                io::ErrorKind::PermissionDenied,
                "it is read-only",
            ));
        }
        Some(permissions)
    };
    let mut name = target.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.tmp", std::process::id()));
    let beside = target.with_file_name(name);
    let written = write_synced(&beside, text)
        .and_then(|()| permissions.map_or(Ok(()), |p| fs::set_permissions(&beside, p)))
        .and_then(|()| fs::rename(&beside, &target));
    if written.is_err() {
        drop(fs::remove_file(&beside));
    }
    written
}

fn write_synced(path: &Path, text: &str) -> io::Result<()> {
    let mut file = fs::File::create(path)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()
}

/// Writes to the name asked for, or the first free one of `name-2`, `name-3` and so on.
pub(super) fn write_text(path: &Path, text: &str, what: &str) -> Msg {
    let stem = path
        .file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    for n in 1..10_000_u32 {
        let target = if n == 1 {
            path.to_owned()
        } else {
            path.with_file_name(format!("{stem}-{n}.txt"))
        };
        let file = fs::OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(&target);
        let written = file.and_then(|mut file| file.write_all(text.as_bytes()));
        match written {
            Ok(()) => {
                return Msg::Say(Level::Info, format!("{what} is in {}.", target.display()));
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => {
                let words = format!("{what} cannot be written to {}: {error}.", target.display());
                return Msg::Say(Level::Error, words);
            }
        }
    }
    Msg::Say(
        Level::Error,
        format!("{what} finds no free name beside {}.", path.display()),
    )
}

#[cfg(test)]
mod tests {
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
