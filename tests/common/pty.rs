//! The program on a pseudo-terminal, with a terminal emulator that says what is on the screen.
//!
//! Nothing here waits for time to pass: [`Pty::wait`] waits for a condition and, should it never
//! come, shows the last screen.

use std::fs::File;
use std::io::{Read, Write};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};
use rustix::process::{Pid, Signal, kill_process};
use rustix::termios::{LocalModes, tcgetattr};
use vt100::{Parser, Screen};

/// Far beyond what anything takes, also on a machine that is busy with other tests.
const PATIENCE: Duration = Duration::from_secs(60);

/// Between two looks at what sends no word when it changes, such as the list of processes.
const POLL: Duration = Duration::from_millis(5);

/// What the terminal has received so far.
struct Seen {
    parser: Parser,
    bytes: Vec<u8>,
    closed: bool,
    /// The listener lets go of the terminal at the next byte.
    let_go: bool,
}

/// A pseudo-terminal with a shell on it that runs the program and afterwards prints `[ended N]`.
pub(crate) struct Pty {
    master: Option<Box<dyn MasterPty + Send>>,
    writer: Option<Box<dyn Write + Send>>,
    shell: Box<dyn Child + Send + Sync>,
    seen: Arc<(Mutex<Seen>, Condvar)>,
    tty: PathBuf,
    /// The directory the program works in, with the shipped cases in it.
    pub(crate) dir: tempfile::TempDir,
}

/// How the program is started.
pub(crate) struct Start<'a> {
    pub(crate) size: (u16, u16),
    pub(crate) vars: &'a [(&'a str, &'a str)],
    pub(crate) args: &'a [&'a str],
    /// The words of the shell; `"$0" "$@"` runs the program.
    pub(crate) script: &'a str,
}

impl Default for Start<'_> {
    fn default() -> Self {
        Self {
            size: (80, 24),
            vars: &[("LANG", "C.UTF-8")],
            args: &[],
            script: r#""$0" "$@"; echo "[ended $?]"; read -r line"#,
        }
    }
}

impl Start<'_> {
    /// Starts the shell in a directory of its own, with copies of the shipped cases.
    pub(crate) fn go(self) -> Pty {
        self.go_in(place())
    }

    /// Starts the shell in this directory.
    pub(crate) fn go_in(self, dir: tempfile::TempDir) -> Pty {
        let (columns, rows) = self.size;
        let pair = native_pty_system().openpty(size(columns, rows)).unwrap();
        let mut command = CommandBuilder::new("/bin/bash");
        command.args(["--norc", "--noprofile", "-c", self.script]);
        command.arg(env!("CARGO_BIN_EXE_seacable"));
        command.args(self.args);
        command.env_clear();
        for name in ["PATH", "LLVM_PROFILE_FILE"] {
            if let Some(value) = std::env::var_os(name) {
                command.env(name, value);
            }
        }
        command.env("HOME", dir.path());
        command.env("TERM", "xterm-256color");
        for (name, value) in self.vars {
            command.env(name, value);
        }
        command.cwd(dir.path());
        let shell = pair.slave.spawn_command(command).unwrap();
        let tty = pair.master.tty_name().unwrap();
        let reader = pair.master.try_clone_reader().unwrap();
        let writer = pair.master.take_writer().unwrap();
        let seen = Arc::new((
            Mutex::new(Seen {
                parser: Parser::new(some(rows), some(columns), 0),
                bytes: Vec::new(),
                closed: false,
                let_go: false,
            }),
            Condvar::new(),
        ));
        listen(reader, Arc::clone(&seen));
        Pty {
            master: Some(pair.master),
            writer: Some(writer),
            shell,
            seen,
            tty,
            dir,
        }
    }
}

/// A directory to work in, with copies of the shipped cases.
pub(crate) fn place() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    copy(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("cases"),
        &dir.path().join("cases"),
    );
    dir
}

fn size(columns: u16, rows: u16) -> PtySize {
    PtySize {
        rows,
        cols: columns,
        pixel_width: 0,
        pixel_height: 0,
    }
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for item in std::fs::read_dir(from).unwrap() {
        let item = item.unwrap();
        let target = to.join(item.file_name());
        if item.path().is_dir() {
            copy(&item.path(), &target);
        } else {
            std::fs::copy(item.path(), target).unwrap();
        }
    }
}

fn listen(mut reader: Box<dyn Read + Send>, seen: Arc<(Mutex<Seen>, Condvar)>) {
    std::thread::spawn(move || {
        let mut buffer = [0_u8; 8192];
        loop {
            let count = reader.read(&mut buffer).unwrap_or(0);
            let mut now = seen.0.lock().unwrap();
            now.parser.process(&buffer[..count]);
            now.bytes.extend_from_slice(&buffer[..count]);
            now.closed = count == 0;
            seen.1.notify_all();
            if count == 0 || now.let_go {
                return;
            }
        }
    });
}

impl Pty {
    /// Waits until the screen is as wanted.
    pub(crate) fn wait(&self, what: &str, wanted: impl Fn(&Screen) -> bool) {
        let until = Instant::now() + PATIENCE;
        let mut now = self.seen.0.lock().unwrap();
        while !wanted(now.parser.screen()) {
            let left = until.saturating_duration_since(Instant::now());
            assert!(
                !left.is_zero() && !now.closed,
                "timed out waiting for: {what}\nlast screen:\n{}",
                now.parser.screen().contents()
            );
            now = self.seen.1.wait_timeout(now, left).unwrap().0;
        }
    }

    /// Waits until a text is on the screen.
    pub(crate) fn wait_for(&self, text: &str) {
        self.wait(text, |screen| screen.contents().contains(text));
    }

    /// The screen as it is now.
    pub(crate) fn text(&self) -> String {
        self.seen.0.lock().unwrap().parser.screen().contents()
    }

    /// All bytes the terminal has received.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        self.seen.0.lock().unwrap().bytes.clone()
    }

    /// Types.
    pub(crate) fn send(&mut self, keys: &str) {
        let writer = self.writer.as_mut().unwrap();
        writer.write_all(keys.as_bytes()).unwrap();
        writer.flush().unwrap();
    }

    /// Changes the size of the terminal.
    pub(crate) fn resize(&self, columns: u16, rows: u16) {
        let mut now = self.seen.0.lock().unwrap();
        now.parser.screen_mut().set_size(some(rows), some(columns));
        let master = self.master.as_ref().unwrap();
        master.resize(size(columns, rows)).unwrap();
    }

    /// Whether the terminal reads lines and echoes them, as a shell wants it.
    pub(crate) fn cooked(&self) -> bool {
        let tty = File::open(&self.tty).unwrap();
        let modes = tcgetattr(&tty).unwrap().local_modes;
        modes.contains(LocalModes::ICANON | LocalModes::ECHO | LocalModes::ISIG)
    }

    /// Waits for the program to end with this status, and sees that the terminal is as before.
    pub(crate) fn ended(&self, status: i32) {
        self.wait_for(&format!("[ended {status}]"));
        self.given_back();
    }

    /// Sees that the terminal is as before.
    pub(crate) fn given_back(&self) {
        self.wait("the terminal as it was", |screen| {
            !screen.alternate_screen() && !screen.hide_cursor() && !screen.bracketed_paste()
        });
        assert!(self.cooked(), "the terminal is still raw");
    }

    /// The process number of the program, once it runs.
    pub(crate) fn process(&self) -> i32 {
        let shell = self.shell.process_id().unwrap();
        let until = Instant::now() + PATIENCE;
        loop {
            if let Some(found) = program_below(shell) {
                return found;
            }
            assert!(Instant::now() < until, "the program never started");
            std::thread::sleep(POLL);
        }
    }

    /// The process that the shell has become.
    pub(crate) fn process_itself(&self) -> Pid {
        let process = i32::try_from(self.shell.process_id().unwrap()).unwrap();
        Pid::from_raw(process).unwrap()
    }

    /// Kills the program where the shell has become it, and returns its directory.
    pub(crate) fn kill(mut self) -> tempfile::TempDir {
        let process = self.process_itself();
        // It may have ended by itself.
        let _ = kill_process(process, Signal::KILL);
        self.shell.wait().unwrap();
        std::mem::replace(&mut self.dir, tempfile::tempdir().unwrap())
    }

    /// Pulls the plug: the terminal is gone as soon as the program writes the next byte, as the
    /// listener, which has the terminal open as well, only then wakes up.
    pub(crate) fn hang_up(&mut self) {
        self.seen.0.lock().unwrap().let_go = true;
        self.writer = None;
        self.master = None;
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        self.writer = None;
        self.master = None;
        drop(self.shell.kill());
        drop(self.shell.wait());
    }
}

/// The process named seacable among the descendants of a process.
fn program_below(ancestor: u32) -> Option<i32> {
    let mut family = vec![ancestor];
    let mut processes = Vec::new();
    for item in std::fs::read_dir("/proc").ok()?.flatten() {
        let Some(number) = item
            .file_name()
            .to_str()
            .and_then(|n| n.parse::<u32>().ok())
        else {
            continue;
        };
        let Ok(stat) = std::fs::read_to_string(item.path().join("stat")) else {
            continue;
        };
        // pid (name) state parent …, and the name may hold blanks and brackets.
        let (head, tail) = stat.rsplit_once(')')?;
        let name = head.split_once('(').map_or("", |(_, n)| n).to_owned();
        let parent = tail.split_whitespace().nth(1)?.parse::<u32>().ok()?;
        processes.push((number, parent, name));
    }
    processes.sort_unstable();
    loop {
        let before = family.len();
        for (number, parent, name) in &processes {
            if family.contains(parent) && !family.contains(number) {
                if name == "seacable" {
                    return i32::try_from(*number).ok();
                }
                family.push(*number);
            }
        }
        if family.len() == before {
            return None;
        }
    }
}

/// Waits until a process is gone.
pub(crate) fn wait_gone(process: i32) {
    let place = PathBuf::from(format!("/proc/{process}/stat"));
    let there = || std::fs::read_to_string(&place).is_ok_and(|stat| !stat.contains(") Z "));
    wait_until("the process is gone", || !there());
}

/// Waits until something is so that sends no word.
pub(crate) fn wait_until(what: &str, so: impl Fn() -> bool) {
    let until = Instant::now() + PATIENCE;
    while !so() {
        assert!(Instant::now() < until, "timed out waiting until {what}");
        std::thread::sleep(POLL);
    }
}

fn some(n: u16) -> NonZero<u16> {
    NonZero::new(n).unwrap()
}
