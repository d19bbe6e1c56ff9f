//! The loop of the workbench: terminal, signals and jobs in; frames out; and every way to end.

use crate::visible;
use std::any::Any;
use std::collections::VecDeque;
use std::io::{self, Write};
use std::os::fd::AsFd;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crossterm::clipboard::CopyToClipboard;
use crossterm::{Command, style};
use rustix::io::Errno;
use rustix::process::{
    Signal as Sig, getpgrp, getpid, getsid, kill_current_process_group, kill_process,
};

use super::effects::EffectRunner;
use super::effects::outbox::Outbox;
use super::key::KeyPress;
use super::memory_keeper::MemoryKeeper;
use super::msg::{Effect, Msg};
use super::screen_memory::file;
use super::settings::UserSettings;
use super::state::sweep_request::SweepMsg;
use super::state::{AppState, Severity};
use super::terminal::capabilities::{self, Capabilities};
use super::terminal::decode::{Decoder, TerminalInput};
use super::terminal::screen::{Screen, restore};
use super::terminal::signals::{Signal, Signals};
use super::terminal::wait::{read, wait};
use super::update::edit_check;
use super::view::last_screen;
use super::{case_library, draw, external_editor, recovery, settings, update};
use crate::background::lower_priority;
use crate::chart::Glyphs;
use crate::crash_log;
use crate::run::job::JobEvent;
use seacable_base::files::{WriteTarget, disk, root};

/// How the workbench is opened.
#[derive(Debug, Clone, Default)]
pub struct WorkbenchOptions {
    /// A case file to open, or a directory of cases to list; absent: the shipped cases.
    pub path: Option<PathBuf>,
    /// Characters for the charts; absent: chosen from the environment.
    pub glyphs: Option<Glyphs>,
    /// Fewer frames, and more patience with cut escape sequences.
    pub slow_link: bool,
    /// Open as for the first time, whatever the last session showed.
    pub fresh: bool,
    /// Begin with the tutorial.
    pub tutorial: bool,
    /// Leave the last screen in the shell.
    pub keep_screen: bool,
    /// Compute stored runs and load cases inside the program, and not by processes that outlive it.
    pub in_process: bool,
}

/// Why the workbench cannot be opened, or ended.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// There is no terminal to draw on.
    #[error(
        "The workbench needs a terminal, and {0}. Without one, use:\n  \
         seacable run CASE          compute a case and store the run under runs/\n  \
         seacable validate CASE     hold a case against its published values\n  \
         seacable report RUN_DIR    print the report of a stored run"
    )]
    NoTerminal(&'static str),
    /// The path named is not there.
    #[error("There is no file or directory {}. Name a case file (*.toml) or a directory of cases.", visible::path(.0))]
    NotFound(PathBuf),
    /// The shipped cases cannot be written where the user's data are kept.
    #[error("The shipped cases cannot be written: {0}. Name a directory of cases: seacable DIR")]
    NoCases(io::Error),
    /// The terminal failed.
    #[error("The terminal failed: {0}.")]
    Terminal(#[from] io::Error),
}

/// How the workbench ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ExitReason {
    Quit,
    Signal(i32),
    HangUp,
}

/// Time between frames, those that show what was asked for and those that show what jobs record; and the longest wait for the
/// rest of an escape sequence.
#[derive(Debug, Clone, Copy)]
struct Timing {
    answer: Duration,
    frame: Duration,
    escape: Duration,
}

impl Timing {
    const fn of_link(is_slow: bool) -> Self {
        if is_slow {
            Self {
                answer: Duration::from_millis(100),
                frame: Duration::from_millis(250),
                escape: Duration::from_millis(400),
            }
        } else {
            Self {
                answer: Duration::ZERO,
                frame: Duration::from_millis(100),
                escape: Duration::from_millis(80),
            }
        }
    }
}

/// Opens the workbench, and returns when the user quits.
///
/// Ends the process itself, with the terminal restored, on SIGTERM, SIGHUP, a hang-up and a panic.
///
/// # Errors
/// When there is no terminal, the path is not there, or the terminal fails.
pub fn open(options: &WorkbenchOptions) -> Result<(), OpenError> {
    look_for_terminal()?;
    let (dir, file) = whereto(options)?;
    let named = options.path.as_ref();
    let place = std::path::absolute(named.map_or(Path::new("."), |_| dir.as_path()))?;
    let mut earlier = file::recall(&place);
    if options.fresh || options.tutorial {
        earlier.screen = None;
    }
    let var = |name: &str| std::env::var(name).ok();
    let settings = UserSettings::load();
    let remembered = settings.config.glyphs.or_else(recovery::remembered_glyphs);
    let capabilities = capabilities::decide(options.glyphs, remembered, &var);
    if !capabilities.colour {
        // The theme has no colours then; the library's own handling of NO_COLOR would take the
        // selection away as well.
        style::force_color_output(true);
    }
    let mut effects = EffectRunner::new(dir)?;
    guard_panics(effects.outbox());
    lower_priority_of_pool();
    let signals = Signals::register()?;
    let mut screen = Screen::enter(capabilities::synchronizes(&var))?;
    let mut state = AppState::new(screen.size()?, capabilities);
    let flag = options.glyphs;
    let keeps_screen = options.keep_screen || settings.config.keep_screen;
    update::earlier::begin(&mut state, &mut earlier, file.is_none());
    update::settings::begin(&mut state, settings);
    if options.tutorial {
        update::tutorial::begin(&mut state);
    }
    state.capabilities.glyphs = flag.unwrap_or(state.capabilities.glyphs);
    if !options.in_process {
        use_processes(&mut state, &mut effects);
    }
    let mut app = App {
        state,
        screen: &mut screen,
        signals,
        effects: &mut effects,
        pace: Timing::of_link(options.slow_link),
        capabilities,
        typed: VecDeque::new(),
        awaited: None,
        may_panic: std::env::var_os("SEACABLE_MAY_PANIC").is_some(),
        memory: MemoryKeeper::new(place, earlier.screen, earlier.session),
    };
    let ended = panic::catch_unwind(AssertUnwindSafe(|| app.run(file)));
    let last = (keeps_screen && matches!(ended, Ok(Ok(ExitReason::Quit))))
        .then(|| last_screen(&app.state));
    let kept = app.memory.changes(&app.state);
    app.perform(kept).ok();
    effects.finish(LAST_FILES);
    finish(ended)?;
    match last {
        Some(text) => Ok(io::stdout().write_all(text.as_bytes())?),
        None => Ok(()),
    }
}

/// What solvers share their work with goes behind the screen as they do; a pool that exists already stays as it is.
fn lower_priority_of_pool() {
    let pool = rayon::ThreadPoolBuilder::new().start_handler(|_| lower_priority());
    drop(pool.build_global());
}

/// Lets jobs be processes that outlive the program, where there is a place to keep them.
fn use_processes(state: &mut AppState, effects: &mut EffectRunner) {
    let directory = std::env::current_dir().map_err(|error| error.to_string());
    match directory.and_then(|dir| effects.use_processes().map(|()| dir)) {
        Ok(dir) => state.jobs.processes = Some(dir),
        Err(why) => state.say(
            Severity::Warning,
            format!("Runs are computed inside this screen, and end with it: {why}."),
        ),
    }
}

/// Every way to end meets here.
fn finish(ended: Result<io::Result<ExitReason>, Box<dyn Any + Send>>) -> Result<(), OpenError> {
    match ended {
        Ok(Ok(ExitReason::HangUp)) => {
            // Nothing can be reported; drops would try to write to the dead terminal.
            std::process::exit(129);
        }
        Ok(Ok(ExitReason::Signal(number))) => {
            restore();
            std::process::exit(128 + number);
        }
        Ok(Ok(ExitReason::Quit)) => {
            restore();
            Ok(())
        }
        Ok(Err(error)) if gone(&error) => std::process::exit(129),
        Ok(Err(error)) => {
            restore();
            Err(error.into())
        }
        Err(_) => {
            restore();
            std::process::exit(101);
        }
    }
}

fn gone(error: &io::Error) -> bool {
    matches!(
        Errno::from_io_error(error),
        Some(Errno::IO | Errno::PIPE | Errno::NXIO | Errno::BADF)
    )
}

fn look_for_terminal() -> Result<(), OpenError> {
    let (input, output) = (io::stdin(), io::stdout());
    if !rustix::termios::isatty(input.as_fd()) {
        return Err(OpenError::NoTerminal("standard input is none"));
    }
    if !rustix::termios::isatty(output.as_fd()) {
        return Err(OpenError::NoTerminal("standard output is none"));
    }
    if std::env::var("TERM").is_ok_and(|t| t == "dumb") {
        return Err(OpenError::NoTerminal(
            "TERM=dumb says that this one can only print lines",
        ));
    }
    Ok(())
}

/// The directory to list, and the case to open at once.
fn whereto(options: &WorkbenchOptions) -> Result<(PathBuf, Option<PathBuf>), OpenError> {
    let Some(path) = &options.path else {
        let dir = case_library::default_dir().map_err(OpenError::NoCases)?;
        root::open(&dir);
        return Ok((dir, None));
    };
    if path.is_dir() {
        root::open(path);
        return Ok((path.clone(), None));
    }
    if !path.exists() {
        return Err(OpenError::NotFound(path.clone()));
    }
    let parent = path.parent().filter(|p| !p.as_os_str().is_empty());
    let dir = parent.map_or_else(|| PathBuf::from("."), PathBuf::from);
    Ok((dir, Some(path.clone())))
}

/// A panic of the screen restores the terminal before it is reported; a panic of a job is reported on the
/// screen, which keeps running.
fn guard_panics(out: Outbox) {
    let screen_thread = std::thread::current().id();
    let tell = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        crash_log::keep(info);
        if std::thread::current().id() == screen_thread {
            restore();
            tell(info);
        } else {
            let words = format!("A fault in seacable: {info}");
            out.send(Msg::Say(Severity::Error, words));
        }
    }));
}

/// How long keys wait for a file; those typed later than that after it was asked for go to what is there.
const KEY_HOLD: Duration = Duration::from_millis(400);

fn is_typed(message: &Msg) -> bool {
    matches!(message, Msg::Key(_) | Msg::Paste(_))
}

/// How long the first frame waits for the files that it shows.
const FIRST_FRAME: Duration = Duration::from_millis(300);

/// How long a frame waits for files and the answer to an edit: what it shows is then nearly always checked, and kept for recovery.
const ANSWER_FIRST: Duration = Duration::from_millis(8);

/// How long the end of the program waits for files that are still to be written.
const LAST_FILES: Duration = Duration::from_secs(5);

/// When a frame is due.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Due {
    /// At once: a key was pressed, or something that was asked for is there.
    Now,
    /// Not more often than needed to see that jobs go on.
    Sometime,
}

impl Due {
    /// When what a message says is to be seen.
    fn of_message(message: &Msg) -> Self {
        match message {
            Msg::Recorded(..) | Msg::TrialProgress(..) | Msg::Sweep(SweepMsg::Progress(..)) => {
                Self::Sometime
            }
            Msg::Job(_, event) if !matches!(**event, JobEvent::Finished(_)) => Self::Sometime,
            _ => Self::Now,
        }
    }
}

struct App<'a> {
    state: AppState,
    screen: &'a mut Screen,
    signals: Signals,
    effects: &'a mut EffectRunner,
    pace: Timing,
    capabilities: Capabilities,
    /// Keys and pastes that wait for a file.
    typed: VecDeque<Msg>,
    /// Since when answers have been on their way without a pause.
    awaited: Option<Instant>,
    /// Lets the tests see that a panic gives the terminal back.
    may_panic: bool,
    /// What the next session is to find.
    memory: MemoryKeeper,
}

impl App<'_> {
    fn run(&mut self, file: Option<PathBuf>) -> io::Result<ExitReason> {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        self.state.jobs.limit = cores.saturating_sub(1).max(1);
        if self.capabilities.unsure {
            self.state.say(
                Severity::Info,
                "No locale is set, so this is ASCII. `:palette` and `braille` change to dots.",
            );
        }
        let mut end = self.begin(file)?;
        let mut decoder = Decoder::default();
        let mut due = Some(Due::Now);
        let mut drawn: Option<Instant> = None;
        while end.is_none() {
            if due.is_some_and(|due| self.wait_for(due, drawn).is_zero()) {
                self.screen.draw(|frame| draw(&self.state, frame))?;
                drawn = Some(Instant::now());
                due = None;
            }
            let limit = self.limit(due.map(|due| self.wait_for(due, drawn)), decoder.waiting());
            let (messages, ended) = self.listen(&mut decoder, limit)?;
            end = ended;
            let kept = self.memory.at_times(&self.state);
            end = end.or(self.perform(kept)?);
            let (typed, heard): (Vec<Msg>, Vec<Msg>) = messages.into_iter().partition(is_typed);
            self.typed.extend(typed);
            for message in heard {
                due = Some(Due::of_message(&message)).into_iter().chain(due).min();
                end = end.or(self.take(message)?);
            }
            while end.is_none() && !self.typed.is_empty() && self.key_hold().is_none() {
                // A file that is done by now was answered before: its answer comes before the key.
                for message in self.effects.poll() {
                    due = Some(Due::of_message(&message)).into_iter().chain(due).min();
                    end = end.or(self.take(message)?);
                }
                if end.is_some() || self.key_hold().is_some() {
                    break;
                }
                let Some(key) = self.typed.pop_front() else {
                    break;
                };
                due = Some(Due::Now);
                end = self.take(key)?;
            }
        }
        Ok(end.unwrap_or(ExitReason::Quit))
    }

    /// How long keys typed ahead still wait for the file that an earlier one asked for, which they are meant for.
    fn key_hold(&self) -> Option<Duration> {
        let left = KEY_HOLD.checked_sub(self.effects.files_busy_for()?)?;
        (!left.is_zero()).then_some(left)
    }

    /// Asks for what the first frame shows, and waits for it, unless the disk is slow.
    fn begin(&mut self, file: Option<PathBuf>) -> io::Result<Option<ExitReason>> {
        let remembered = self.state.earlier.as_ref();
        let remembered = remembered.and_then(|earlier| earlier.case.clone());
        let file = file.or(remembered);
        self.state.cases.opening.clone_from(&file);
        let (first, later) = match file {
            Some(path) => (Effect::ReadCase(path), Some(Effect::ReadCases)),
            None => (Effect::ReadCases, None),
        };
        let mut end = self.perform(vec![first])?;
        self.effects.finish(FIRST_FRAME);
        for message in self.effects.poll() {
            end = end.or(self.take(message)?);
        }
        Ok(end.or(self.perform(later.into_iter().collect())?))
    }

    /// How long a frame that is due has to wait after the last one.
    fn wait_for(&self, due: Due, drawn: Option<Instant>) -> Duration {
        let pause = match due {
            Due::Now => self.pace.answer,
            Due::Sometime => self.pace.frame,
        };
        let pause = drawn.map_or(Duration::ZERO, |at| pause.saturating_sub(at.elapsed()));
        let awaited = self.awaited.map(|since| since.elapsed());
        let awaited = awaited.max(self.effects.files_busy_for());
        let answer = awaited.map_or(Duration::ZERO, |for_long| {
            ANSWER_FIRST.saturating_sub(for_long)
        });
        pause.max(answer)
    }

    /// How long nothing needs to be done.
    fn limit(&self, frame: Option<Duration>, waiting: bool) -> Option<Duration> {
        let escape = waiting.then_some(self.pace.escape);
        let jobs = self.effects.recording().then_some(self.pace.frame);
        let keys = self.key_hold().filter(|_| !self.typed.is_empty());
        [frame, escape, jobs, keys].into_iter().flatten().min()
    }

    /// Waits, and returns what happened.
    fn listen(
        &mut self,
        decoder: &mut Decoder,
        limit: Option<Duration>,
    ) -> io::Result<(Vec<Msg>, Option<ExitReason>)> {
        let began = Instant::now();
        let terminal = io::stdin();
        let woken = wait(
            terminal.as_fd(),
            self.signals.fd(),
            self.effects.fd(),
            limit,
        )?;
        if woken.hung_up {
            return Ok((Vec::new(), Some(ExitReason::HangUp)));
        }
        let mut messages = Vec::new();
        for signal in self.signals.take() {
            match signal {
                Signal::Terminate(number) => {
                    return Ok((messages, Some(ExitReason::Signal(number))));
                }
                Signal::HangUp => return Ok((messages, Some(ExitReason::Signal(1)))),
                Signal::Stop => self.stop()?,
                Signal::Continue => self.screen.reenter()?,
                Signal::Resize => {}
            }
            let (columns, rows) = self.screen.size()?;
            messages.push(Msg::Resize(columns, rows));
        }
        let mut inputs = Vec::new();
        if woken.input {
            let mut buffer = [0_u8; 4096];
            match read(terminal.as_fd(), &mut buffer)? {
                None => return Ok((messages, Some(ExitReason::HangUp))),
                Some(n) => inputs = decoder.feed(&buffer[..n]),
            }
        } else if decoder.waiting() && began.elapsed() >= self.pace.escape {
            inputs = decoder.give_up();
        }
        messages.extend(inputs.into_iter().map(|input| match input {
            TerminalInput::Key(key) => Msg::Key(key),
            TerminalInput::Paste(text) => Msg::Paste(text),
        }));
        messages.extend(self.effects.poll());
        Ok((messages, None))
    }

    fn take(&mut self, message: Msg) -> io::Result<Option<ExitReason>> {
        if self.may_panic && matches!(message, Msg::Key(KeyPress::F(12))) {
            panic::panic_any("asked for by SEACABLE_MAY_PANIC");
        }
        let effects = update(&mut self.state, message);
        self.awaited = match edit_check::awaits(&self.state) {
            true => self.awaited.or_else(|| Some(Instant::now())),
            false => None,
        };
        self.perform(effects)
    }

    /// Does the effects, and the effects of what they answer.
    fn perform(&mut self, effects: Vec<Effect>) -> io::Result<Option<ExitReason>> {
        for effect in effects {
            match effect {
                Effect::Quit => return Ok(Some(ExitReason::Quit)),
                Effect::Repaint => self.screen.repaint()?,
                Effect::Suspend => self.suspend(),
                Effect::Copy(text) => self.copy(&text)?,
                Effect::EditFile(path) => self.edit(&path)?,
                Effect::EditKeys => self.edit_keys()?,
                other => {
                    for answer in self.effects.perform(other) {
                        if let Some(end) = self.take(answer)? {
                            return Ok(Some(end));
                        }
                    }
                }
            }
        }
        Ok(None)
    }

    /// ^Z: stops the whole job of the shell, which may be more than this process.
    fn suspend(&mut self) {
        let alone = getsid(None).is_ok_and(|session| session == getpgrp());
        if alone {
            // Stopped without a shell above, nothing could ever bring it back.
            self.state.say(
                Severity::Info,
                "There is no shell behind this terminal that `fg` could be typed in.",
            );
        } else if let Err(error) = kill_current_process_group(Sig::TSTP) {
            self.state.say(
                Severity::Warning,
                format!("The program cannot be stopped: {error}."),
            );
        }
    }

    /// SIGTSTP: the terminal is given back, and taken again on SIGCONT.
    fn stop(&mut self) -> io::Result<()> {
        restore();
        kill_process(getpid(), Sig::STOP)?;
        self.screen.reenter()
    }

    /// Gives the terminal to the user's editor, takes it back, and asks for what the editor left. Jobs keep running meanwhile.
    fn edit(&mut self, path: &Path) -> io::Result<()> {
        restore();
        let ended = external_editor::run(path);
        self.signals.forget_interrupt();
        self.screen.reenter()?;
        let read = match settings::is_file(path) {
            true => Effect::ReadSettings,
            false => Effect::ReadEdited(path.to_owned()),
        };
        let answers = match ended {
            Ok(()) => self.effects.perform(read),
            Err(why) => vec![Msg::Say(Severity::Error, why)],
        };
        let out = self.effects.outbox();
        answers.into_iter().for_each(|answer| out.send(answer));
        Ok(())
    }

    /// Opens the file of keys in the user's editor; one that is not there yet has every key in a comment.
    fn edit_keys(&mut self) -> io::Result<()> {
        match settings::made_keys_file() {
            Ok(path) => self.edit(&path),
            Err(error) => {
                let words = format!("The file of keys cannot be made: {error}.");
                self.state.say(Severity::Error, words);
                Ok(())
            }
        }
    }

    fn copy(&mut self, text: &str) -> io::Result<()> {
        let mut sequence = String::new();
        let worded = CopyToClipboard::to_clipboard_from(text).write_ansi(&mut sequence);
        if worded.is_ok() {
            self.screen.write(sequence.as_bytes())?;
        }
        let kept = case_library::state_dir().and_then(|dir| {
            disk::create_dir_all(&dir)?;
            let path = dir.join("copied.txt");
            WriteTarget::replacing(&path).write(text.as_bytes())?;
            Ok(path)
        });
        let words = match kept {
            Ok(path) => format!(
                "Offered to the clipboard of your terminal (not every terminal takes it); also in {}.",
                visible::path(&path)
            ),
            Err(error) => format!("Offered to the clipboard of your terminal; no file: {error}."),
        };
        self.state.say(Severity::Info, words);
        Ok(())
    }
}
