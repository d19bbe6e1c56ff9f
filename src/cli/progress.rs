//! How far a run is, on one line of the terminal that is written over and wiped at the end.

use std::{
    io::{self, IsTerminal},
    time::{Duration, Instant},
};

use super::output;
use seacable_base::number::duration;
use seacable_runs::run::Progress;

/// How often the line changes.
const EVERY: Duration = Duration::from_millis(100);

/// The progress line; silent when standard error is no terminal.
#[derive(Debug)]
pub(super) struct ProgressLine {
    terminal: bool,
    shown: Option<Instant>,
}

impl ProgressLine {
    /// Nothing is shown yet.
    pub(super) fn new() -> Self {
        Self {
            terminal: io::stderr().is_terminal(),
            shown: None,
        }
    }

    /// Shows how far a run is.
    pub(super) fn run(&mut self, progress: &Progress) {
        if self.due() {
            let left = progress
                .remaining_s()
                .map_or_else(String::new, |s| format!(", {} left", duration(s)));
            self.put(&format!(
                "{:3.0} %  step {}  {:.1} s of {} s{left}",
                100.0 * progress.fraction(),
                progress.steps,
                progress.time,
                progress.duration,
            ));
        }
    }

    /// Shows a text at once.
    pub(super) fn show(&mut self, text: &str) {
        if self.terminal {
            self.put(text);
        }
    }

    fn due(&self) -> bool {
        self.terminal && self.shown.is_none_or(|at| at.elapsed() >= EVERY)
    }

    fn put(&mut self, text: &str) {
        self.shown = Some(Instant::now());
        output::progress(text);
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        if self.terminal && self.shown.is_some() {
            output::progress("");
        }
    }
}
