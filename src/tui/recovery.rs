//! What outlives a session without being the user's files: unsaved changes, and answers given.
//!
//! Changes are kept at every edit and not only when the program ends badly: so they also survive a
//! kill that leaves no time for anything.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use rustix::process::{Pid, test_kill_process};

use super::case_library::state_dir;
use crate::chart::Glyphs;
use crate::strays;
use seacable_base::files::{WriteTarget, disk, read};

/// What a session left of a case.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RecoveredEdits {
    /// The text.
    pub text: String,
    /// Ranges kept for a grid, as `KEY=VALUES`.
    pub kept: Vec<String>,
}

/// Ranges kept for a grid stand before the text, each in a comment that begins so.
const RANGE: &str = "# range kept for a grid: ";

impl RecoveredEdits {
    /// What a file says that a session left.
    #[must_use]
    pub fn read(file: &str) -> Self {
        let mut kept = Vec::new();
        let mut text = file;
        while let Some(rest) = text.strip_prefix(RANGE) {
            let (range, below) = rest.split_once('\n').unwrap_or((rest, ""));
            kept.push(range.to_owned());
            text = below;
        }
        Self {
            text: text.to_owned(),
            kept,
        }
    }

    fn written(&self) -> String {
        let ranges = self.kept.iter().map(|range| format!("{RANGE}{range}\n"));
        ranges.chain([self.text.clone()]).collect()
    }
}

/// Keeps what is unsaved of a case, or drops it when there is nothing any more.
///
/// # Errors
/// When the state directory cannot be written.
pub fn store(case: &Path, edits: Option<&RecoveredEdits>) -> io::Result<()> {
    let dir = state_dir()?.join("recovery");
    let path = dir.join(format!("{}{}.toml", prefix(case), std::process::id()));
    match edits {
        Some(edits) => {
            disk::create_dir_all(&dir)?;
            Ok(WriteTarget::replacing(&path).write(edits.written().as_bytes())?)
        }
        None => remove_if_present(&path),
    }
}

/// What a session which is no longer there left of this case, beyond its text in the file; the newest of several. What is in the file
/// goes: a session that was killed between saving and dropping left it.
#[must_use]
pub fn find(case: &Path, saved: &str) -> Option<RecoveredEdits> {
    let left = recovery_files(case).into_iter().filter_map(|path| {
        let edits = RecoveredEdits::read(&read::text(&path).ok()?);
        if edits.text == saved && edits.kept.is_empty() {
            // Best effort: what stays is looked at again.
            let _ = remove_if_present(&path);
            return None;
        }
        let changed = fs::metadata(&path).and_then(|found| found.modified()).ok();
        Some((changed, edits))
    });
    left.max_by_key(|(changed, _)| *changed)
        .map(|(_, edits)| edits)
}

/// Removes what killed sessions left half written: beside a case, among what is kept for recovery, and beside that.
pub fn tidy(case: &Path) {
    let state = state_dir().ok();
    let kept = state.as_ref().map(|dir| dir.join("recovery"));
    let beside = case.parent().map(|dir| match dir.as_os_str().is_empty() {
        true => PathBuf::from("."),
        false => dir.to_owned(),
    });
    for dir in [beside, state, kept].into_iter().flatten() {
        strays::remove(&dir, &[]);
    }
}

/// Keeps what is unsaved of a case, and then drops what sessions that are no longer there left of it: at no moment is there neither.
///
/// # Errors
/// When the state directory cannot be written; what they left is then still there.
pub fn take_over(case: &Path, edits: Option<&RecoveredEdits>) -> io::Result<()> {
    store(case, edits)?;
    discard(case)
}

/// Drops what sessions that are no longer there left of this case.
///
/// # Errors
/// When a file cannot be removed.
pub fn discard(case: &Path) -> io::Result<()> {
    recovery_files(case)
        .iter()
        .try_for_each(|path| remove_if_present(path))
}

fn remove_if_present(path: &Path) -> io::Result<()> {
    match disk::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

fn recovery_files(case: &Path) -> Vec<PathBuf> {
    let inside = state_dir().and_then(|dir| fs::read_dir(dir.join("recovery")));
    let prefix = prefix(case);
    inside
        .into_iter()
        .flatten()
        .flatten()
        .map(|item| item.path())
        .filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let process = name
                .strip_prefix(&prefix)
                .and_then(|rest| rest.strip_suffix(".toml"))
                .and_then(|n| n.parse::<i32>().ok());
            process.is_some_and(|n| !alive(n))
        })
        .collect()
}

/// Whether a session of this process number is still there, this one included.
///
/// The number alone proves little: another program may have it by now, and a session whose end
/// no process has asked about yet still answers to it. Where the system reports more, that is used.
fn alive(process: i32) -> bool {
    let answers = Pid::from_raw(process).is_some_and(|pid| test_kill_process(pid).is_ok());
    let own = i32::try_from(std::process::id()).ok().and_then(about);
    answers
        && match (about(process), own) {
            (Some((name, state)), Some((own, _))) => name == own && !matches!(state, 'Z' | 'X'),
            _ => true,
        }
}

/// Name and state of a process, from Linux's `/proc`; the state is `Z` or `X` once it has ended.
fn about(process: i32) -> Option<(String, char)> {
    let stat = read::text(Path::new(&format!("/proc/{process}/stat"))).ok()?;
    // pid (name) state ..., and the name may hold blanks and brackets.
    let (head, tail) = stat.rsplit_once(')')?;
    let (_, name) = head.split_once('(')?;
    Some((name.to_owned(), tail.trim_start().chars().next()?))
}

/// Name of the case and a fingerprint of its whole path.
fn prefix(case: &Path) -> String {
    let whole = case.canonicalize().unwrap_or_else(|_| case.to_owned());
    let stem = case.file_stem().unwrap_or_default().to_string_lossy();
    format!("{stem}-{:016x}-", fingerprint(&whole))
}

/// A fingerprint of a whole path: FNV-1a, which unlike the standard hasher will be the same in every later version.
#[must_use]
pub fn fingerprint(path: &Path) -> u64 {
    let bytes = path.as_os_str().as_encoded_bytes().iter();
    bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// The glyphs the user chose in an earlier session.
#[must_use]
pub fn remembered_glyphs() -> Option<Glyphs> {
    let text = read::text(&state_dir().ok()?.join("glyphs")).ok()?;
    match text.trim() {
        "braille" => Some(Glyphs::Braille),
        "ascii" => Some(Glyphs::Ascii),
        _ => None,
    }
}

/// Remembers the glyphs the user chose.
///
/// # Errors
/// When the state directory cannot be written.
pub fn remember_glyphs(glyphs: Glyphs) -> io::Result<()> {
    let dir = state_dir()?;
    disk::create_dir_all(&dir)?;
    let word = match glyphs {
        Glyphs::Braille => "braille\n",
        Glyphs::Ascii => "ascii\n",
    };
    Ok(WriteTarget::replacing(&dir.join("glyphs")).write(word.as_bytes())?)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_kept_before_the_text() {
        let edits = RecoveredEdits {
            text: "# a comment\n[case]\n".to_owned(),
            kept: vec!["current.speed_m_per_s=0.2..0.8/4".to_owned()],
        };
        assert_eq!(RecoveredEdits::read(&edits.written()), edits);
        let plain = RecoveredEdits::read("# a comment\n");
        assert_eq!(plain.text, "# a comment\n");
        assert!(plain.kept.is_empty());
    }

    #[test]
    fn only_a_running_session_of_this_program_is_alive() {
        let own = i32::try_from(std::process::id()).unwrap();
        assert!(alive(own));
        assert!(!alive(1), "another program");
        // The same program, ended, while no process has asked about its end.
        let mut child = std::process::Command::new(std::env::current_exe().unwrap())
            .arg("--list")
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let number = i32::try_from(child.id()).unwrap();
        let until = std::time::Instant::now() + std::time::Duration::from_secs(60);
        while about(number).is_some_and(|(_, state)| state != 'Z') {
            assert!(std::time::Instant::now() < until, "it never ends");
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        assert!(!alive(number), "ended");
        child.wait().unwrap();
        assert!(!alive(number), "gone");
    }
}
