//! Jobs that are processes of their own: begun on the screen or from the shell, cut from their screens, killed, found again.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process};
use seacable::jobs::{JobFolder, JobFolderState};
use seacable::run::{RunState, store};

use crate::chance::Chance;
use crate::pty::{Pty, Start, wait_until};
use crate::small::SMALL;

/// A case that computes for some seconds.
pub(crate) const SLOW: &str = "slow.toml";

/// Where its run is that was computed without a job.
pub(crate) const WHOLE: &str = "whole";

/// The files of a run whose bytes do not depend on who computed it, and when it was stopped.
const RESULTS: [&str; 7] = [
    "case.toml",
    "summary.csv",
    "errors.csv",
    "channels.csv",
    "history.csv",
    "profile.csv",
    "shapes.csv",
];

/// A directory with a case that computes so long \[s of simulated time\], and the run of it.
pub(crate) fn place(duration_s: u32) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let text = SMALL
        .replace(
            "duration_s = 5.0",
            &format!("duration_s = {duration_s}.0\ntime_step_s = 0.01"),
        )
        .replace("interval_s = 0.5", "interval_s = 5.0")
        .replace("shape_interval_s = 1.0", "shape_interval_s = 100.0");
    fs::write(dir.path().join(SLOW), text).unwrap();
    let whole = command(dir.path(), &["run", SLOW, "--out", WHOLE]).output();
    assert!(whole.unwrap().status.success());
    dir
}

/// The program with these words, with its files below a directory.
pub(crate) fn command(dir: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.args(words).current_dir(dir).env("HOME", dir);
    for name in ["STATE", "CACHE", "DATA", "CONFIG"] {
        command.env_remove(format!("XDG_{name}_HOME"));
    }
    command.stdin(Stdio::null());
    command
}

/// What the program says to these words, where it succeeds.
pub(crate) fn said(dir: &Path, words: &[&str]) -> String {
    let Output {
        status,
        stdout,
        stderr,
    } = command(dir, words).output().unwrap();
    let errors = String::from_utf8_lossy(&stderr);
    assert!(status.success(), "{words:?}: {errors}");
    String::from_utf8(stdout).unwrap()
}

/// The screen in a directory, in the place of its shell.
pub(crate) fn login(dir: tempfile::TempDir, args: &[&str]) -> Pty {
    let start = Start {
        args,
        script: r#"exec "$0" "$@""#,
        ..Start::default()
    };
    start.go_in(dir)
}

/// Cuts a screen off: by a kill, or with its terminal.
pub(crate) fn cut(mut pty: Pty, chance: &mut Chance) -> tempfile::TempDir {
    if chance.below(2) == 0 {
        return pty.kill();
    }
    let process = pty.process_itself();
    let dir = std::mem::replace(&mut pty.dir, tempfile::tempdir().unwrap());
    pty.hang_up();
    // The other end of the terminal is let go of at the next byte.
    let _ = kill_process(process, Signal::WINCH);
    drop(pty);
    dir
}

/// Waits for a part of a second, by chance.
pub(crate) fn a_moment(chance: &mut Chance, longest: Duration) {
    std::thread::sleep(longest.mul_f64(chance.share()));
}

/// The directory of the jobs of this host, once there is one.
fn jobs_dir(dir: &Path) -> Option<PathBuf> {
    let hosts = fs::read_dir(dir.join(".local/state/seacable/jobs")).ok()?;
    let hosts: Vec<_> = hosts.flatten().map(|item| item.path()).collect();
    assert!(hosts.len() < 2, "{hosts:?}");
    hosts.into_iter().next()
}

/// Everything in the directory of the jobs but the locks of the host.
pub(crate) fn left_in_jobs(dir: &Path) -> BTreeSet<String> {
    let inside = jobs_dir(dir).map(|dir| fs::read_dir(dir).unwrap());
    let names = inside.into_iter().flatten().flatten();
    let names = names.map(|item| item.file_name().into_string().unwrap());
    names
        .filter(|name| !["numbers", "slots"].contains(&name.as_str()))
        .collect()
}

/// The folders of the jobs.
pub(crate) fn folders(dir: &Path) -> Vec<JobFolder> {
    let jobs = jobs_dir(dir);
    let names = left_in_jobs(dir).into_iter();
    let numbered = names.filter(|name| name.parse::<u64>().is_ok());
    let paths = numbered.filter_map(|name| Some(jobs.as_ref()?.join(name)));
    paths
        .filter_map(|path| JobFolder::open(&path).ok())
        .collect()
}

/// Kills a process of a job, if one computes.
pub(crate) fn kill_a_job(dir: &Path, chance: &mut Chance) -> bool {
    let held = folders(dir).into_iter();
    let held = held.filter(|folder| folder.state() == JobFolderState::Held);
    let processes: Vec<_> = held.filter_map(|folder| folder.process()).collect();
    if processes.is_empty() {
        return false;
    }
    let process = chance.one(&processes).process;
    kill_process(Pid::from_raw(process).unwrap(), Signal::KILL).is_ok()
}

/// The processes of the program that work in a directory.
pub(crate) fn processes_in(dir: &Path) -> Vec<String> {
    let program = Path::new(env!("CARGO_BIN_EXE_seacable"));
    let program = program.canonicalize().unwrap();
    let dir = dir.canonicalize().unwrap();
    let points = |link: PathBuf, to: &Path| fs::read_link(link).is_ok_and(|path| path == to);
    let all = fs::read_dir("/proc").unwrap().flatten();
    let ours = all.filter(|item| {
        let about = item.path();
        points(about.join("exe"), &program) && points(about.join("cwd"), &dir)
    });
    ours.map(|item| {
        let words = fs::read(item.path().join("cmdline")).unwrap_or_default();
        String::from_utf8_lossy(&words).replace('\0', " ")
    })
    .collect()
}

/// A screen that nobody cuts off: it shows what has ended and lets the others end, until there are no jobs.
pub(crate) fn settle(dir: tempfile::TempDir) -> tempfile::TempDir {
    let pty = login(dir, &[]);
    pty.wait_for("q quit");
    let path = pty.dir.path().to_owned();
    // A queue takes as long as it is: the time counts anew for each job.
    let mut left = usize::MAX;
    while left > 0 {
        let before = left;
        wait_until("the next job is over and shown", || {
            left_in_jobs(&path).len() < before
        });
        left = left_in_jobs(&path).len();
    }
    let dir = pty.kill();
    wait_until("no process is left", || processes_in(dir.path()).is_empty());
    dir
}

/// The runs of a directory: each can be read, and is done or can be finished, to the bytes of the run that was computed without a job. How
/// many had to be finished.
pub(crate) fn finish_and_compare(dir: &Path, at_least: usize) -> usize {
    let listed = store::list(&dir.join("runs")).unwrap_or_default();
    assert!(
        listed.len() >= at_least,
        "{} of {at_least} runs",
        listed.len()
    );
    let mut resumed = 0;
    for (number, run) in listed.into_iter().enumerate() {
        let state = run.info.unwrap().state;
        store::read(&run.dir).unwrap();
        let mut at = run.dir;
        if state != RunState::Done {
            resumed += 1;
            let from = at.to_str().unwrap().to_owned();
            at = dir.join(format!("finished-{number}"));
            said(
                dir,
                &["run", "--resume", &from, "--out", at.to_str().unwrap()],
            );
        }
        for name in RESULTS {
            let found = fs::read(at.join(name)).ok();
            let expected = fs::read(dir.join(WHOLE).join(name)).ok();
            assert!(found == expected, "{}: {name} differs", at.display());
        }
    }
    let hidden = fs::read_dir(dir.join("runs"));
    let hidden = hidden.into_iter().flatten().flatten();
    let hidden: Vec<_> = hidden
        .map(|item| item.file_name().into_string().unwrap())
        .collect();
    let stray = hidden.iter().filter(|name| name.ends_with(".tmp"));
    assert_eq!(stray.count(), 0, "{hidden:?}");
    resumed
}

/// Begins a run on the screen of a case, and waits until it is kept as a job.
pub(crate) fn begin_run(dir: tempfile::TempDir) -> Pty {
    let before = folders(dir.path()).len();
    let mut pty = login(dir, &[SLOW]);
    pty.wait_for("solver alpha");
    pty.send("R");
    let path = pty.dir.path().to_owned();
    wait_until("the job is kept", || folders(&path).len() > before);
    pty
}

/// Runs that are begun on screens which are cut off so often: none is lost, and each is found again by the next screen.
pub(crate) fn cut_links(duration_s: u32, runs: usize, cuts: usize, chance: &mut Chance) {
    let mut dir = place(duration_s);
    let mut done = 0;
    for _ in 0..runs {
        dir = cut(begin_run(dir), chance);
        done += 1;
    }
    while done < cuts {
        let open = folders(dir.path());
        let open: Vec<u64> = open.iter().map(|folder| folder.number).collect();
        if open.is_empty() {
            dir = cut(begin_run(dir), chance);
            done += 1;
            continue;
        }
        let args: &[&str] = if chance.below(2) == 0 { &[SLOW] } else { &[] };
        let mut pty = login(dir, args);
        pty.wait_for("q quit");
        // All of them are on the screen: in its messages, each with its number.
        pty.send("!");
        for number in open {
            pty.wait(&format!("job {number} among the messages"), |screen| {
                screen
                    .contents()
                    .contains(&format!("Job {number}, slow, alpha,"))
            });
        }
        a_moment(chance, Duration::from_millis(300));
        dir = cut(pty, chance);
        done += 1;
    }
    let numbers: usize = numbers_given(dir.path());
    let dir = settle(dir);
    assert_eq!(finish_and_compare(dir.path(), numbers), 0);
}

/// How many jobs there have been.
pub(crate) fn numbers_given(dir: &Path) -> usize {
    let text = jobs_dir(dir).map(|dir| fs::read_to_string(dir.join("numbers")).unwrap());
    text.map_or(0, |text| text.trim().parse().unwrap())
}

/// Screens that are killed so often at any moment of their lives, some of which begin runs.
pub(crate) fn killed_screens(duration_s: u32, kills: usize, chance: &mut Chance) {
    let mut dir = place(duration_s);
    let mut seen = BTreeSet::new();
    for number in 0..kills {
        let begins = number % 4 == 0 || chance.below(4) == 0;
        let mut pty = login(dir, if begins { &[SLOW] } else { &[] });
        if begins {
            pty.wait_for("solver alpha");
            pty.send("R");
        }
        a_moment(chance, Duration::from_millis(250));
        dir = pty.kill();
        seen.extend(folders(dir.path()).iter().map(|folder| folder.number));
    }
    let dir = settle(dir);
    assert_eq!(finish_and_compare(dir.path(), seen.len()), 0);
    eprintln!("{kills} screens killed, {} jobs", seen.len());
}

/// Processes of jobs that are killed so often at any moment of their lives.
pub(crate) fn killed_jobs(duration_s: u32, kills: usize, chance: &mut Chance) {
    let dir = place(duration_s);
    let path = dir.path();
    let (mut killed, mut begun) = (0, 0);
    while killed < kills {
        if folders(path).len() < 3 {
            said(path, &["run", "--detach", SLOW]);
            begun += 1;
        }
        a_moment(chance, Duration::from_millis(300));
        killed += usize::from(kill_a_job(path, chance));
        // What has ended makes room, and what waits goes on.
        for folder in folders(path) {
            if matches!(
                folder.state(),
                JobFolderState::Ended(_) | JobFolderState::Killed(_)
            ) {
                let _ = command(path, &["jobs", "wait", &folder.number.to_string()]).output();
            }
        }
        said(path, &["jobs", "begin"]);
    }
    let dir = settle(dir);
    let resumed = finish_and_compare(dir.path(), begun);
    eprintln!("{killed} processes of {begun} jobs killed, {resumed} runs finished later");
}
