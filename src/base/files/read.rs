//! Reads files that come from outside: regular files only, up to a size that is stated.
//!
//! A file is opened without waiting for it, as a pipe that nothing writes into would be waited for without end; what was opened is
//! looked at, not what its name leads to by then; and no more is read than the limit, as a file may grow or have no end.

use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::os::unix::fs::{FileTypeExt, OpenOptionsExt};
use std::path::Path;
use std::sync::OnceLock;

use rustix::fs::OFlags;

use crate::work_log::{self, Task};

/// Greatest size of a case, a table or a file of another program \[bytes\], where the user gives none.
pub const LIMIT: u64 = 64 << 20;

/// Greatest size of a file that runs write \[bytes\], where the user gives none: a history may be long.
pub const RUN_LIMIT: u64 = 1 << 30;

/// The option that lifts the limits.
const OPTION: &str = "--limit-file-size";

/// The greatest size that the user gave \[bytes\].
static GIVEN: OnceLock<u64> = OnceLock::new();

/// Sets the greatest size of every file that is read \[bytes\]; the first call holds.
pub fn limit(bytes: u64) {
    // A second call would come from the program itself, not from its user.
    let _ = GIVEN.set(bytes);
}

/// The greatest size of every file that the user gave \[bytes\], if any.
#[must_use]
pub fn given_limit() -> Option<u64> {
    GIVEN.get().copied()
}

/// The contents of a file.
///
/// # Errors
/// It is no regular file, is too large, or the system refuses.
pub fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    Opened::at(path, OFlags::empty(), LIMIT)?.bytes()
}

/// The text of a file.
///
/// # Errors
/// As [`bytes`], or it is not UTF-8.
pub fn text(path: &Path) -> io::Result<String> {
    utf8(bytes(path)?)
}

/// The text of a file; what is not UTF-8 is replaced, as in remarks of old files.
///
/// # Errors
/// As [`bytes`].
pub fn text_lossy(path: &Path) -> io::Result<String> {
    bytes(path).map(lossy)
}

/// The text of a file of a stored run, which is never a symbolic link: a link would show what lies elsewhere.
///
/// # Errors
/// As [`text`], or it is a link.
pub fn run_text(path: &Path) -> io::Result<String> {
    utf8(of_run(path)?.bytes()?)
}

/// A table of a stored run, to be read row by row; it is no larger than its limit.
///
/// # Errors
/// As [`run_text`].
pub fn run_table(path: &Path) -> io::Result<File> {
    of_run(path).map(|opened| opened.file)
}

fn of_run(path: &Path) -> io::Result<Opened> {
    Opened::at(path, OFlags::NOFOLLOW, RUN_LIMIT)
}

/// The contents of a file whose place is known without links.
pub(super) fn lossy_at(real: &Path) -> io::Result<String> {
    let opened = Opened::at(real, OFlags::NOFOLLOW, LIMIT)?;
    opened.bytes().map(lossy)
}

/// The text of a file whose place is known without links.
pub(super) fn text_at(real: &Path) -> io::Result<String> {
    utf8(Opened::at(real, OFlags::NOFOLLOW, LIMIT)?.bytes()?)
}

/// A regular file, not larger than its limit when it was opened.
struct Opened {
    file: File,
    size: u64,
    limit: u64,
}

impl Opened {
    fn at(path: &Path, flags: OFlags, limit: u64) -> io::Result<Self> {
        work_log::log(Task::Read, path.display());
        let limit = GIVEN.get().copied().unwrap_or(limit);
        let flags = (flags | OFlags::NONBLOCK | OFlags::NOCTTY).bits();
        let file = OpenOptions::new()
            .read(true)
            .custom_flags(i32::try_from(flags).unwrap_or_default())
            .open(path)
            .map_err(|error| in_words(error, path))?;
        let found = file.metadata()?;
        if !found.is_file() {
            return Err(not_regular(found.file_type()));
        }
        match found.len() {
            size if size > limit => Err(too_large(size, limit)),
            size => Ok(Self { file, size, limit }),
        }
    }

    fn bytes(self) -> io::Result<Vec<u8>> {
        let mut contents = Vec::with_capacity(usize::try_from(self.size).unwrap_or_default());
        let mut reader = self.file.take(self.limit.saturating_add(1));
        reader.read_to_end(&mut contents)?;
        match contents.len() as u64 {
            size if size > self.limit => Err(too_large(size, self.limit)),
            _ => Ok(contents),
        }
    }
}

/// The system's reason, in words where its own lead astray.
fn in_words(error: io::Error, path: &Path) -> io::Error {
    use rustix::io::Errno;
    let is_link = || {
        path.symlink_metadata()
            .is_ok_and(|found| found.is_symlink())
    };
    match error.raw_os_error().map(Errno::from_raw_os_error) {
        Some(Errno::LOOP) if is_link() => refused(
            "it is a symbolic link, and not followed: it may show what lies elsewhere".to_owned(),
        ),
        // A socket, or a device without a driver.
        Some(Errno::NXIO) => refused("it is not a regular file".to_owned()),
        _ => error,
    }
}

fn not_regular(kind: std::fs::FileType) -> io::Error {
    let what = match kind {
        kind if kind.is_dir() => "a directory",
        kind if kind.is_fifo() => "a named pipe",
        kind if kind.is_socket() => "a socket",
        _ => "a device",
    };
    refused(format!("it is {what}, which is not a regular file"))
}

fn too_large(size: u64, limit: u64) -> io::Error {
    let reason = format!(
        "it has {size} bytes or more, above the limit of {limit}; {OPTION} BYTES sets another limit"
    );
    io::Error::new(io::ErrorKind::FileTooLarge, reason)
}

fn refused(reason: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, reason)
}

fn lossy(bytes: Vec<u8>) -> String {
    match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => String::from_utf8_lossy(error.as_bytes()).into_owned(),
    }
}

/// The text of the contents of a file.
///
/// # Errors
/// It is not UTF-8.
pub fn utf8(bytes: Vec<u8>) -> io::Result<String> {
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to() + 1;
        let reason = format!("it is not text in UTF-8 at byte {at}");
        io::Error::new(io::ErrorKind::InvalidData, reason)
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use std::fs;
    use std::os::unix::fs::symlink;
    use std::os::unix::net::UnixListener;

    use rustix::fs::{CWD, Mode, mkfifoat};

    use super::*;

    #[test]
    fn special_files_are_refused_by_their_kind_without_waiting() {
        let dir = tempfile::tempdir().unwrap();
        let [pipe, socket] = ["pipe", "socket"].map(|name| dir.path().join(name));
        mkfifoat(CWD, &pipe, Mode::RUSR).unwrap();
        let _listening = UnixListener::bind(&socket).unwrap();
        let zero = dir.path().join("zero");
        symlink("/dev/zero", &zero).unwrap();
        for (path, kind) in [
            (pipe.as_path(), "a named pipe"),
            (socket.as_path(), ""),
            (zero.as_path(), "a device"),
            (dir.path(), "a directory"),
        ] {
            let reason = bytes(path).unwrap_err().to_string();
            assert!(reason.contains("not a regular file"), "{reason}");
            assert!(reason.contains(kind), "{reason}");
        }
    }

    #[test]
    fn a_file_above_the_limit_is_refused_before_it_is_read() {
        let dir = tempfile::tempdir().unwrap();
        let large = dir.path().join("large");
        File::create(&large).unwrap().set_len(8 << 30).unwrap();
        for error in [bytes(&large).err(), run_table(&large).err()] {
            let reason = error.unwrap().to_string();
            assert!(reason.contains("8589934592 bytes"), "{reason}");
            assert!(reason.contains(OPTION), "{reason}");
        }
    }

    #[test]
    fn files_of_runs_are_no_links() {
        let dir = tempfile::tempdir().unwrap();
        let [file, link] = ["file", "link"].map(|name| dir.path().join(name));
        fs::write(&file, "text").unwrap();
        symlink(&file, &link).unwrap();
        assert_eq!(run_text(&file).unwrap(), "text");
        assert_eq!(text(&link).unwrap(), "text");
        let reason = run_text(&link).unwrap_err().to_string();
        assert!(reason.contains("symbolic link"), "{reason}");
    }

    /// Sources below a directory, without their tests.
    pub(crate) fn sources(dir: &Path, found: &mut Vec<(String, String)>) {
        for item in fs::read_dir(dir).unwrap() {
            let path = item.unwrap().path();
            if path.is_dir() {
                sources(&path, found);
            } else if path.file_name().is_some_and(|name| name != "tests.rs") {
                let text = fs::read_to_string(&path).unwrap();
                let tests = [
                    "mod tests {",
                    "pub(super) mod tests {",
                    "pub(crate) mod tests {",
                ];
                let tests = tests.map(|begin| text.find(&format!("\n#[cfg(test)]\n{begin}")));
                let tests = tests.into_iter().flatten().next();
                let text = text[..tests.unwrap_or(text.len())].to_owned();
                found.push((path.display().to_string(), text));
            }
        }
    }

    #[test]
    fn a_disk_is_changed_in_one_place_only() {
        let mut all = Vec::new();
        sources(
            Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap(),
            &mut all,
        );
        let ways = [
            "fs::write(",
            "fs::rename(",
            "fs::remove",
            "fs::create",
            "fs::copy(",
            "fs::hard_link(",
            "fs::set_permissions(",
            "File::create",
            "File::options(",
            "tempfile::",
        ];
        for (file, text) in all {
            let is_place = file.ends_with("src/base/files/disk.rs");
            // Our own types are made through that place.
            let ours = ["NewFile::", "GrowingFile::", "TemporaryFile::"];
            let text = ours.iter().fold(text, |text, name| text.replace(name, ""));
            for way in ways {
                assert!(is_place || !text.contains(way), "{file} uses {way}");
            }
        }
    }

    #[test]
    fn files_are_read_here_only() {
        let mut all = Vec::new();
        sources(
            Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap(),
            &mut all,
        );
        // Directories are opened to be locked and synced.
        let opened = ["src/runs/run/store/lock.rs", "src/base/files/disk.rs"];
        for (file, text) in all {
            let ways = ["fs::read(", "read_to_string(", "from_path(", "File::open("];
            for way in ways {
                let is_known = opened.iter().any(|known| file.ends_with(known));
                let is_allowed = is_known && way == "File::open(";
                assert!(is_allowed || !text.contains(way), "{file} uses {way}");
            }
        }
    }

    #[test]
    fn text_is_utf8() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("file");
        fs::write(&file, b"ab\xffc").unwrap();
        let error = text(&file).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::InvalidData);
        assert!(error.to_string().contains("byte 3"));
        assert_eq!(text_lossy(&file).unwrap(), "ab\u{fffd}c");
    }
}
