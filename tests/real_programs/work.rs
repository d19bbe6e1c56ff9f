//! Where the program works, what it leaves there, and which processes are still at it.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use seacable::run::store;

use crate::pty;
use crate::small::SMALL;

/// Far beyond what anything takes, also on a machine that is busy with other tests.
const PATIENCE: Duration = Duration::from_secs(60);

/// Between two looks at files and processes, which send no word when they change.
const POLL: Duration = Duration::from_millis(5);

/// The case list is on the screen.
pub(crate) const LIST: &str = "Manifold, 300 t";

/// A case that would compute for minutes.
pub(crate) const ENDLESS: &str = "endless.toml";

/// A directory to work in, with the shipped cases and an endless one.
pub(crate) fn place() -> tempfile::TempDir {
    let dir = pty::place();
    let text = SMALL
        .replace(
            "duration_s = 5.0",
            "duration_s = 500000.0\ntime_step_s = 0.01",
        )
        .replace("interval_s = 0.5", "interval_s = 0.5 # coarse");
    std::fs::write(dir.path().join(ENDLESS), text).unwrap();
    dir
}

/// The search path with the program's own directory first.
pub(crate) fn search_path() -> String {
    let program = Path::new(env!("CARGO_BIN_EXE_seacable"));
    let own = program.parent().unwrap().display();
    let others = std::env::var("PATH").unwrap_or_default();
    format!("{own}:{others}")
}

/// A program of the system; where it is missing, the test fails.
pub(crate) fn installed(name: &str) -> PathBuf {
    let path = std::env::var("PATH").unwrap_or_default();
    // Servers often stand outside a user's search path.
    std::env::split_paths(&format!("{path}:/usr/sbin:/usr/local/sbin"))
        .map(|dir| dir.join(name))
        .find(|file| file.is_file())
        .unwrap_or_else(|| {
            panic!("{name} is not installed; `.ci/run` installs what these tests need")
        })
}

/// Waits until something holds that sends no word of its own.
pub(crate) fn until(what: &str, holds: impl Fn() -> bool) {
    let end = Instant::now() + PATIENCE;
    while !holds() {
        assert!(Instant::now() < end, "timed out waiting for: {what}");
        std::thread::sleep(POLL);
    }
}

/// The processes of the program that work in this directory.
pub(crate) fn at_work(dir: &Path) -> Vec<i32> {
    let program = Path::new(env!("CARGO_BIN_EXE_seacable"))
        .canonicalize()
        .unwrap();
    let dir = dir.canonicalize().unwrap();
    let points = |link: PathBuf, to: &Path| std::fs::read_link(link).is_ok_and(|path| path == to);
    std::fs::read_dir("/proc")
        .unwrap()
        .flatten()
        .filter_map(|item| item.file_name().to_str()?.parse().ok())
        .filter(|process: &i32| {
            let about = PathBuf::from(format!("/proc/{process}"));
            points(about.join("exe"), &program) && points(about.join("cwd"), &dir)
        })
        .collect()
}

/// The only run stored in this directory, as its files stand now, with the rows of its history;
/// zero rows before there is one.
pub(crate) fn rows(dir: &Path) -> usize {
    only_run(dir).map_or(0, |run| run.history.time.len())
}

/// The only run stored in this directory.
pub(crate) fn only_run(dir: &Path) -> Option<seacable::run::Run> {
    let entries = store::list(&dir.join("runs")).ok()?;
    assert!(entries.len() < 2, "{} runs are stored", entries.len());
    store::read(&entries.first()?.dir).ok()
}

/// The unsaved texts that are kept for a later session.
pub(crate) fn recovered(dir: &Path) -> Vec<String> {
    let kept = std::fs::read_dir(dir.join(".local/state/seacable/recovery"));
    kept.into_iter()
        .flatten()
        .flatten()
        .filter(|item| item.path().extension().is_some_and(|e| e == "toml"))
        .map(|item| std::fs::read_to_string(item.path()).unwrap_or_default())
        .collect()
}

/// The report of the only run, once it is written.
pub(crate) fn report(dir: &Path) -> String {
    let run = std::fs::read_dir(dir.join("runs")).unwrap().next();
    std::fs::read_to_string(run.unwrap().unwrap().path().join("report.txt")).unwrap()
}

/// What is set for the program on top of what is there, and what its terminal may then get.
pub(crate) struct Setting {
    pub(crate) words: &'static str,
    pub(crate) ascii: bool,
    pub(crate) colour: bool,
}

const fn setting(words: &'static str, ascii: bool, colour: bool) -> Setting {
    Setting {
        words,
        ascii,
        colour,
    }
}

/// Locales, terminals and `NO_COLOR`, as the words after `env`.
pub(crate) const SETTINGS: [Setting; 7] = [
    setting("LANG=C.UTF-8", false, true),
    setting("LANG=C", true, true),
    setting("-u LANG", true, true),
    setting("NO_COLOR=1", false, false),
    setting("TERM=vt100", true, true),
    setting("TERM=screen-256color", false, true),
    setting("LANG=C NO_COLOR=1 TERM=vt100", true, false),
];

/// Whether a terminal got a colour.
pub(crate) fn any_colour(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    let mut sequences = text.split("\x1b[").skip(1).filter_map(|sequence| {
        let end = sequence.find(|c: char| c.is_ascii_alphabetic())?;
        sequence[end..].starts_with('m').then(|| &sequence[..end])
    });
    sequences.any(|parameters| {
        let colour = |p: &str| matches!(p.parse::<u8>(), Ok(30..=38 | 40..=48 | 90..=107));
        parameters.split([';', ':']).any(colour)
    })
}
