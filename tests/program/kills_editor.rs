//! SIGKILL of the workbench at random moments while it keeps edits for recovery, saves them, and takes over what a killed session
//! left. The case is wholly the old or wholly a newer text, an edit that once reached the disk is in the file or offered again, and what
//! was half written goes with the next start.
//!
//! `SEACABLE_KILLS=500 cargo test --test program kills -- --nocapture` makes that many, `SEACABLE_SEED` sets others.

#![cfg(target_os = "linux")]

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

use tempfile::TempDir;

use crate::chance::{Chance, asked, seed};
use crate::pty::{Pty, Start, wait_until};
use crate::small::SMALL;

const FILE: &str = "small.toml";

/// The line that is edited: each edit gives the body another mass, one kilogram more than the edit before.
const EDITED: &str = "dry_mass_kg = ";

/// Edits that are typed ahead, each with the key that saves it.
const ROUNDS: u32 = 3;

/// Opens the case, in place of the shell.
fn start(dir: TempDir) -> Pty {
    let pty = Start {
        args: &["--fresh", FILE],
        script: r#"exec "$0" "$@""#,
        ..Start::default()
    };
    let pty = pty.go_in(dir);
    pty.wait("the case", |screen| {
        let text = screen.contents();
        text.contains(FILE) && text.contains("Inputs")
    });
    pty
}

/// The mass that a text gives; its other lines are those of the case as it was at first.
fn mass(text: &str, what: &str) -> u32 {
    let number = |text: &str| {
        let line = text.lines().find(|line| line.starts_with(EDITED));
        line.map(|line| line[EDITED.len()..].to_owned())
    };
    let (now, first) = (number(text), number(SMALL).unwrap());
    let now = now.unwrap_or_else(|| panic!("half of {what}: {text}"));
    let same = text.replace(&format!("{EDITED}{now}\n"), &format!("{EDITED}{first}\n"));
    assert_eq!(same, SMALL, "{what}");
    now.parse::<f64>().unwrap() as u32
}

/// What stands on the disk.
struct Disk {
    file: u32,
    /// What sessions left, the newest last.
    kept: Vec<u32>,
    /// What was being written.
    half: Vec<PathBuf>,
}

impl Disk {
    fn of(place: &Path) -> Self {
        let text = fs::read_to_string(place.join(FILE)).unwrap();
        let mut half = Vec::new();
        for item in fs::read_dir(place).unwrap().flatten() {
            let name = item.file_name().into_string().unwrap();
            match name.as_str() {
                FILE | ".local" | ".cache" => {}
                name if is_half_written(name) => half.push(item.path()),
                name => panic!("a file too many: {name}"),
            }
        }
        let mut kept = Vec::new();
        for item in fs::read_dir(recovery(place))
            .into_iter()
            .flatten()
            .flatten()
        {
            let name = item.file_name().into_string().unwrap();
            if is_half_written(&name) {
                half.push(item.path());
                continue;
            }
            // While a program is alive it may be gone by now.
            let Ok(text) = fs::read_to_string(item.path()) else {
                continue;
            };
            let changed = item.metadata().and_then(|found| found.modified());
            kept.push((changed.ok(), mass(&text, &name)));
        }
        kept.sort_unstable();
        Self {
            file: mass(&text, FILE),
            kept: kept.into_iter().map(|(_, mass)| mass).collect(),
            half,
        }
    }

    /// The newest edit on it.
    fn newest(&self) -> u32 {
        self.kept.iter().copied().fold(self.file, u32::max)
    }

    /// What the next session offers.
    fn offered(&self) -> Option<u32> {
        let unsaved = self.kept.iter().rev();
        unsaved.copied().find(|mass| *mass != self.file)
    }
}

fn is_half_written(name: &str) -> bool {
    name.starts_with('.') && name.ends_with(".tmp")
}

fn recovery(place: &Path) -> PathBuf {
    place.join(".local/state/seacable/recovery")
}

/// Makes what was left half written older than what another machine may be writing.
fn age(half: &[PathBuf]) {
    let then = SystemTime::now() - Duration::from_secs(120);
    for path in half {
        let open = fs::File::open(path).unwrap();
        open.set_modified(then).unwrap();
    }
}

/// When a kill comes.
#[derive(Clone, Copy)]
enum Moment {
    /// So long after the keys.
    After(Duration),
    /// So long after something begins to be written below one of both directories.
    Writing { kept: bool, after: Duration },
}

/// Waits for a moment, and returns the newest edit that was seen on the disk before.
fn wait(place: &Path, moment: Moment, longest: Duration) -> u32 {
    let begun = Instant::now();
    let mut seen = 0;
    loop {
        // As few calls as can be between what is looked for and the kill.
        let (dir, at) = match moment {
            Moment::After(time) if begun.elapsed() >= time => return seen,
            Moment::Writing { kept: true, after } => (recovery(place), Some(after)),
            Moment::Writing { kept: false, after } => (place.to_owned(), Some(after)),
            Moment::After(_) => (place.to_owned(), None),
        };
        if let Some(after) = at {
            let mut inside = fs::read_dir(dir).into_iter().flatten().flatten();
            if inside.any(|item| item.file_name().to_str().is_some_and(is_half_written)) {
                let found = Instant::now();
                while found.elapsed() < after {}
                return seen;
            }
        }
        if begun.elapsed() > longest {
            return seen;
        }
        seen = seen.max(Disk::of(place).newest());
    }
}

/// Types edits ahead, each saved.
fn edit(pty: &mut Pty, first: u32) {
    let keys = (first..first + ROUNDS).map(|mass| format!("\r\x15{mass}\rs"));
    pty.send(&format!("/dry mass\r{}", keys.collect::<String>()));
}

#[test]
fn a_killed_editor_leaves_the_old_case_or_the_new_one_and_loses_no_edit() {
    let dir = tempfile::tempdir().unwrap();
    let place = dir.path().to_owned();
    fs::write(place.join(FILE), SMALL).unwrap();
    let mut chance = Chance::new(seed());
    let mut next = 1000;
    // How long edits take that nothing stops.
    let mut pty = start(dir);
    let begun = Instant::now();
    edit(&mut pty, next);
    next += ROUNDS;
    wait_until("all is saved", || {
        let disk = Disk::of(&place);
        disk.file == next - 1 && disk.kept.is_empty()
    });
    let whole = begun.elapsed();
    let mut dir = pty.kill();
    let (mut saved, mut offered, mut half, mut taken_over) = (0, 0, 0, 0);
    let kills = asked("SEACABLE_KILLS", 12);
    for number in 0..kills {
        let before = Disk::of(&place);
        age(&before.half);
        let mut pty = start(dir);
        // What was half written is gone by the time that the case is seen.
        let now = Disk::of(&place);
        assert!(now.half.is_empty(), "{number}: {:?}", now.half);
        assert_eq!(now.file, before.file, "{number}");
        let asks = pty.text().contains("bring them back");
        assert_eq!(asks, before.offered().is_some(), "{number}: {}", pty.text());
        let mut least = before.file;
        if let Some(left) = before.offered() {
            if chance.below(4) == 0 {
                pty.send("d");
            } else {
                least = left;
                pty.send("r");
            }
            // Some are killed while they take over what an earlier session left.
            if least == left && chance.below(3) == 0 {
                let after = Duration::from_secs_f64(0.05 * chance.share());
                wait(&place, Moment::After(after), whole);
                dir = pty.kill();
                let found = Disk::of(&place);
                assert_eq!(found.file, before.file, "{number}");
                assert_eq!(found.offered(), Some(left), "{number}: an edit is lost");
                half += found.half.len();
                taken_over += 1;
                continue;
            }
        }
        let first = next;
        edit(&mut pty, first);
        next += ROUNDS;
        let soon = Duration::from_secs_f64(0.003 * chance.share());
        let moment = match chance.below(3) {
            0 => Moment::After(whole.mul_f64(1.1 * chance.share())),
            at => Moment::Writing {
                kept: at == 1,
                after: soon,
            },
        };
        let seen = wait(&place, moment, 3 * whole);
        dir = pty.kill();
        let found = Disk::of(&place);
        assert!(
            found.file >= before.file && found.newest() < next,
            "{number}"
        );
        // What is dropped on request may still be there when it is looked for.
        let least = if seen >= first { seen } else { least };
        let newest = found.newest();
        assert!(newest >= least, "{number}: {least} is lost, {newest} left");
        half += found.half.len();
        match found.offered() {
            Some(_) => offered += 1,
            None => saved += 1,
        }
    }
    let before = Disk::of(&place);
    age(&before.half);
    let pty = start(dir);
    assert!(Disk::of(&place).half.is_empty());
    drop(pty);
    eprintln!(
        "{kills} kills, {whole:.1?} for edits that are not killed: {offered} left edits to be offered, {saved} had saved all, \
         {taken_over} while edits were taken over; {half} files half written, all gone with the next start"
    );
}
