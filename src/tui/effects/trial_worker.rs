//! Trials of hard cases, on threads of their own.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::outbox::Outbox;
use crate::background::lower_priority;
use crate::case::Case;
use crate::kinds::FileType;
use crate::msg::Msg;
use crate::state::JobNumber;
use crate::state::trials::{TrialProgress, TrialsOf};
use crate::study::hard_cases::{self, HardCase, TrialRun};
use crate::system::SystemFile;

/// Computes trials, on all cores but the one of the screen; reports each, and the end.
pub(super) fn compute_trials(
    ticket: JobNumber,
    of: TrialsOf,
    cancel: &AtomicBool,
    out: &Outbox,
) -> Msg {
    let cases: Vec<HardCase> = match of {
        TrialsOf::Case { file, text } => HardCase::read(&text, &file).into_iter().collect(),
        TrialsOf::Files(paths) => paths.iter().filter_map(|path| hard_case(path)).collect(),
    };
    let tell = |all: &[Option<TrialRun>], done: usize, over: bool| {
        let progress = TrialProgress {
            findings: hard_cases::verdicts(&cases, all),
            done,
            all: all.len(),
            over,
        };
        Msg::TrialProgress(ticket, Box::new(progress))
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(cores.saturating_sub(1).max(1))
        .start_handler(|_| lower_priority())
        .build();
    let compute = || {
        hard_cases::compute_all(&cases, cancel, &|all, done| {
            out.send(tell(all, done, false));
        })
    };
    let computed = match pool {
        Ok(pool) => pool.install(compute),
        Err(_) => compute(),
    };
    let done = computed.iter().flatten().count();
    tell(&computed, done, true)
}

/// A file with trials.
fn hard_case(path: &Path) -> Option<HardCase> {
    let hard = match FileType::of_path(path) {
        FileType::Line => HardCase::load::<Case>(path),
        FileType::System => HardCase::load::<SystemFile>(path),
        _ => return None,
    };
    hard.ok().filter(|hard| !hard.trials.is_empty())
}
