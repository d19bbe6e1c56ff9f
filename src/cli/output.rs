//! Standard output and standard error.

use std::{
    backtrace::{Backtrace, BacktraceStatus},
    borrow::Cow,
    ffi::OsString,
    io::{self, IsTerminal, Write},
    panic::PanicHookInfo,
    path::{Path, PathBuf},
    process::ExitCode,
};

use super::{BAD_INPUT, CommandError, inputs};
use seacable_base::files::{Existing, WriteError, WriteTarget};
use seacable_base::visible;
use seacable_display::{chart::Glyphs, plain};
use seacable_runs::run::store;
use seacable_tui::terminal::capabilities;

/// Prints results.
pub(super) fn results(text: &str, ascii: bool) -> Result<(), CommandError> {
    print(&page(text, ascii || plain_terminal(&io::stdout())))
}

/// Whether output goes to a terminal of which no locale says that it knows more than ASCII.
fn plain_terminal(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && !capabilities::knows_utf8(&|name| std::env::var(name).ok())
}

/// A page as it is printed or written to a file: nothing invisible in it, and only ASCII where wanted.
pub(super) fn page(text: &str, ascii: bool) -> String {
    let text = visible::text(text);
    if ascii {
        plain::ascii(&text).into_owned()
    } else {
        text.into_owned()
    }
}

/// Prints a table in a format that other programs read.
pub(super) fn document(text: &[u8], format: FileFormat) -> Result<(), CommandError> {
    print(&format.visible(text))
}

/// Prints a JSON object.
pub(super) fn object(object: &serde_json::Value) -> Result<(), CommandError> {
    print(&visible::json(&format!("{object:#}\n")))
}

/// Prints text without invisible characters. A reader that leaves before it has all, as `head` does, is an error: what was asked for did
/// not arrive. A descriptor 1 that was closed (`>&-`) is not seen: Rust's runtime opens `/dev/null` in its place before `main`, just
/// as parents do that want no output, and without `unsafe` nothing of the program runs earlier.
fn print(text: &str) -> Result<(), CommandError> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.map_err(CommandError::Output)
}

/// The file that an option names.
#[derive(Debug)]
pub(super) struct OutputFile<'a> {
    option: &'static str,
    path: &'a Path,
    force: bool,
    inputs: Vec<PathBuf>,
}

impl<'a> OutputFile<'a> {
    /// The file of `--output`, if it is given. Fails before anything is computed where it cannot be written.
    pub(super) fn check(
        path: Option<&'a Path>,
        force: bool,
        inputs: &[PathBuf],
    ) -> Result<Option<Self>, CommandError> {
        Self::check_option("--output", path, force, inputs)
    }

    /// The file of an option, if it is given.
    pub(super) fn check_option(
        option: &'static str,
        path: Option<&'a Path>,
        force: bool,
        inputs: &[PathBuf],
    ) -> Result<Option<Self>, CommandError> {
        let Some(path) = path else { return Ok(None) };
        let file = Self {
            option,
            path,
            force,
            inputs: inputs::inputs(inputs),
        };
        let checked = match file.target().check() {
            Err(input @ WriteError::IsInput(_)) => Err(input),
            checked => outside_a_run(path).and(checked),
        };
        checked.map_err(|source| CommandError::Write { option, source })?;
        Ok(Some(file))
    }

    /// Writes the file.
    pub(crate) fn write(&self, text: &[u8], format: FileFormat) -> Result<(), CommandError> {
        let written = self.target().write(format.visible(text).as_bytes());
        written.map_err(|source| CommandError::Write {
            option: self.option,
            source,
        })
    }

    fn target(&self) -> WriteTarget<'_> {
        WriteTarget {
            path: self.path,
            inputs: &self.inputs,
            existing: if self.force {
                Existing::Replace
            } else {
                Existing::Keep
            },
        }
    }
}

/// A file of a stored run is never overwritten, nor made in its place.
fn outside_a_run(path: &Path) -> Result<(), WriteError> {
    let own = path
        .file_name()
        .is_some_and(|name| store::FILES.iter().any(|own| name == *own));
    let parent = path.parent().filter(|parent| *parent != Path::new(""));
    let dir = parent.unwrap_or(Path::new("."));
    if own && dir.join(store::RUN).is_file() {
        return Err(WriteError::OfRun(path.to_owned()));
    }
    Ok(())
}

/// The formats of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FileFormat {
    /// Text to read, and CSV.
    Text,
    /// TOML.
    Toml,
    /// JSON lines.
    Json,
}

impl FileFormat {
    /// The text with its invisible characters escaped as the format escapes them.
    fn visible(self, text: &[u8]) -> String {
        let text = String::from_utf8_lossy(text);
        match self {
            Self::Text => visible::text(&text),
            Self::Toml => visible::toml(&text),
            Self::Json => visible::json(&text),
        }
        .into_owned()
    }
}

/// Prints a message on standard error. A closed standard error is not an error.
pub(super) fn message(text: &str) {
    let text = visible::text(text);
    let text = match plain_terminal(&io::stderr()) {
        true => plain::ascii(&text),
        false => text,
    };
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Prints a message with the program's own colours, `plain` without. If invisible characters came into it, the colours
/// are left out, since escapes of the text and of the program are the same bytes.
pub(super) fn coloured_message(plain: &str, coloured: &str) {
    let plain_only = plain_terminal(&io::stderr()) && !plain.is_ascii();
    match visible::text(plain) {
        Cow::Borrowed(text) if plain_only => message(text),
        Cow::Borrowed(_) => {
            let _ = writeln!(io::stderr().lock(), "{coloured}");
        }
        Cow::Owned(text) => message(&text),
    }
}

/// Shows one line of progress over the previous one; an empty one removes it.
pub(super) fn progress(text: &str) {
    let mut err = io::stderr().lock();
    let _ = write!(err, "\r\x1b[K{}", visible::line(text)).and_then(|()| err.flush());
}

/// Prints what clap has to report: help, the version, or what is wrong with the arguments. Gives the exit status.
/// `words` are those of the command line, which it may repeat.
pub(super) fn usage(error: &clap::Error, words: &[OsString]) -> ExitCode {
    let said = error.render().to_string();
    // A line feed in an argument begins no line of its own.
    let shown = words.iter().filter_map(|word| word.to_str());
    let shown = shown.fold(said.clone(), |said, word| match visible::line(word) {
        Cow::Borrowed(_) => said,
        Cow::Owned(escaped) => said.replace(word, &escaped),
    });
    match visible::text(&shown) {
        Cow::Borrowed(_) if shown == said => {
            let printed = error.print().and_then(|()| io::stdout().flush());
            // Help and version are results; a closed standard error is not an error.
            if let (Err(source), false) = (printed, error.use_stderr()) {
                return CommandError::Output(source).report();
            }
        }
        // The error repeats an argument with invisible characters.
        text => message(text.trim_end()),
    }
    ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(BAD_INPUT))
}

/// Prints where and why the program panicked.
pub(super) fn report_panic(info: &PanicHookInfo<'_>) {
    message(&format!("seacable has a fault: {info}"));
    let trace = Backtrace::capture();
    if trace.status() == BacktraceStatus::Captured {
        message(&trace.to_string());
    }
}

/// Columns of a page: as asked for, or those of the terminal, 80 at least.
pub(super) fn page_width(asked: Option<usize>) -> usize {
    const LEAST: usize = 80;
    let terminal = || {
        let size = io::stdout().is_terminal().then(crossterm::terminal::size);
        size.and_then(Result::ok)
            .map(|(columns, _)| usize::from(columns))
    };
    asked.unwrap_or_else(|| terminal().unwrap_or(LEAST).max(LEAST))
}

/// The characters to draw with on standard output.
pub(super) fn glyphs(ascii: bool) -> Glyphs {
    if ascii || plain_terminal(&io::stdout()) {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    }
}
