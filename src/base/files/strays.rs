//! What programs leave that are killed while they write: hidden files and directories with the number of the process in their name.
//! Whoever writes in a directory next removes those of processes that are gone, once they are a minute old.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io;
use std::path::Path;
use std::process;
use std::time::Duration;

use super::disk;

use rustix::io::Errno;
use rustix::process::{Pid, test_kill_process};

/// The age from which on they are removed: a process of another machine with the same directory is not known here.
const OLD: Duration = Duration::from_secs(60);

/// What is written under a hidden name before it takes its own, or on its way out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hidden {
    /// A file before it takes its name.
    File,
    /// A run before it takes its name.
    NewRun,
    /// A run that is being deleted.
    DeletedRun,
}

impl Hidden {
    /// How their names end.
    pub const fn suffix(self) -> &'static str {
        match self {
            Self::File => ".tmp",
            Self::NewRun => ".new",
            Self::DeletedRun => ".gone",
        }
    }
}

/// How hidden names begin that this process gives for this name: something of its own and the suffix follow.
pub fn prefix(name: &OsStr) -> OsString {
    let mut prefix = OsString::from(".");
    prefix.push(name);
    prefix.push(format!(".{}-", process::id()));
    prefix
}

/// Removes what killed processes left in a directory. What holds anything else than `files` is left.
pub fn remove(directory: &Path, files: &[&str]) {
    remove_older(directory, files, OLD);
}

/// The same, however young it is: for directories that no other machine writes in.
pub fn remove_of_this_host(directory: &Path, files: &[&str]) {
    remove_older(directory, files, Duration::ZERO);
}

fn remove_older(directory: &Path, files: &[&str], age: Duration) {
    let Ok(inside) = fs::read_dir(directory) else {
        return;
    };
    for item in inside.flatten() {
        let Some(hidden) = left_behind(&item.file_name()).filter(|_| is_old(&item, age)) else {
            continue;
        };
        // Best effort: what stays is hidden, and tried again.
        let _ = match hidden {
            Hidden::File => disk::remove_file(&item.path()),
            Hidden::NewRun | Hidden::DeletedRun => remove_run(&item.path(), files),
        };
    }
}

/// What a name says that was left by a process that is gone.
fn left_behind(name: &OsStr) -> Option<Hidden> {
    let name = name.to_str()?.strip_prefix('.')?;
    let all = [Hidden::File, Hidden::NewRun, Hidden::DeletedRun];
    let found = |hidden: &Hidden| name.ends_with(hidden.suffix());
    let hidden = all.into_iter().find(found)?;
    let name = name.strip_suffix(hidden.suffix())?;
    let (_, owner) = name.rsplit_once('.')?;
    let (process, _) = owner.split_once('-')?;
    let process = Pid::from_raw(process.parse().ok().filter(|process| *process > 0)?)?;
    (test_kill_process(process) == Err(Errno::SRCH)).then_some(hidden)
}

fn is_old(item: &fs::DirEntry, least: Duration) -> bool {
    let changed = item.metadata().and_then(|found| found.modified());
    changed.is_ok_and(|changed| least.is_zero() || changed.elapsed().is_ok_and(|age| age > least))
}

fn remove_run(dir: &Path, files: &[&str]) -> io::Result<()> {
    // A link to a directory is none.
    if !dir.symlink_metadata()?.is_dir() {
        return Ok(());
    }
    let items = fs::read_dir(dir)?.collect::<io::Result<Vec<_>>>()?;
    let is_known = |item: &fs::DirEntry| {
        let name = item.file_name();
        let known = files.iter().any(|file| name == OsStr::new(file));
        known || left_behind(&name) == Some(Hidden::File)
    };
    // A folder of another kind is left whole: a part taken would make it look new.
    if !items.iter().all(is_known) {
        return Ok(());
    }
    for item in items {
        disk::remove_file(&item.path())?;
    }
    disk::remove_dir(dir)
}

#[cfg(test)]
mod tests {
    use std::time::SystemTime;

    use super::*;

    /// The number of a process that is gone.
    fn gone() -> u32 {
        let mut child = process::Command::new("true").spawn().unwrap();
        child.wait().unwrap();
        child.id()
    }

    fn names(dir: &Path) -> Vec<String> {
        let names = fs::read_dir(dir).unwrap();
        let mut names: Vec<String> = names
            .map(|item| item.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn what_the_dead_left_goes_once_it_is_old_and_nothing_else() {
        let dir = tempfile::tempdir().unwrap();
        let (gone, here) = (gone(), process::id());
        let make = |name: &str, inside: &[&str], old: bool| {
            let path = dir.path().join(name);
            if inside.is_empty() {
                fs::write(&path, "x").unwrap();
            } else {
                fs::create_dir(&path).unwrap();
            }
            for file in inside {
                fs::write(path.join(file), "x").unwrap();
            }
            if old {
                let then = SystemTime::now() - 2 * OLD;
                fs::File::open(&path).unwrap().set_modified(then).unwrap();
            }
        };
        for (suffix, inside) in [
            (".tmp", &[][..]),
            (".new", &["case.toml"][..]),
            (".gone", &["case.toml"][..]),
        ] {
            make(&format!(".a.{gone}-0{suffix}"), inside, true);
            make(&format!(".young.{gone}-0{suffix}"), inside, false);
            make(&format!(".mine.{here}-0{suffix}"), inside, true);
            make(&format!("seen.{gone}-0{suffix}"), inside, true);
            make(&format!(".b{suffix}"), inside, true);
        }
        let other = format!(".other.{gone}-0.new");
        make(&other, &["case.toml", "letter.txt"], true);
        let mut expected = names(dir.path());
        expected.retain(|name| !name.starts_with(".a."));
        remove(dir.path(), &["case.toml"]);
        assert_eq!(names(dir.path()), expected);
        assert_eq!(expected.len(), 13);
        assert_eq!(names(&dir.path().join(other)), ["case.toml", "letter.txt"]);
    }
}
