//! `seacable study`: hard cases held against what must come out.

use std::{
    fs, io,
    process::ExitCode,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
};

use rayon::prelude::*;

use super::{
    Failure, NOT_GOOD,
    args::{HardWords, StudyWords},
    cases::{self, Loaded},
    output, progress,
    signals::Stop,
};
use crate::study::{
    hard::{self, Computed, Hard},
    tally,
};

/// Columns of the page.
const WIDTH: usize = 160;

pub(super) fn study(words: &StudyWords) -> Result<ExitCode, Failure> {
    match words {
        StudyWords::HardCases(words) => hard_cases(words),
    }
}

fn hard_cases(words: &HardWords) -> Result<ExitCode, Failure> {
    let loaded = cases::with_trials(&words.cases)?;
    let cases: Vec<Hard> = loaded.into_iter().map(hard_case).collect();
    let stop =
        Stop::listen().map_err(|e| Failure::Usage(format!("Signals cannot be caught: {e}")))?;
    let computed = compute(&cases, &stop);
    if let Some(status) = stop.status() {
        output::message("Stopped before all trials were computed; nothing was judged.");
        return Ok(status);
    }
    let findings = hard::findings(&cases, &computed);
    let table = hard::table(&findings);
    if let Some(path) = &words.output {
        let file = fs::File::create(path).map_err(io::Error::other);
        let written = file.and_then(|file| table.write_csv(file).map_err(io::Error::other));
        written.map_err(|source| Failure::Write {
            path: path.clone(),
            source,
        })?;
    }
    let tally = tally(&findings);
    output::results(&format!("{}\n{tally}\n", table.to_text(WIDTH)), words.ascii)?;
    Ok(if tally.holds() {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(NOT_GOOD)
    })
}

fn hard_case(loaded: Loaded) -> Hard {
    Hard {
        file: loaded.file,
        text: loaded.text,
        case: loaded.case,
    }
}

/// Every trial on its own core.
fn compute(cases: &[Hard], stop: &Stop) -> Vec<Option<Computed>> {
    let tasks = hard::tasks(cases);
    let line = Mutex::new(progress::Line::new());
    let done = AtomicUsize::new(0);
    let one = |task: &hard::Task| {
        let case = &cases[task.case];
        let computed = hard::compute(case, &case.case.trial[task.trial], stop.cancel());
        if let Ok(mut line) = line.lock() {
            let count = done.fetch_add(1, Ordering::Relaxed) + 1;
            line.words(&format!("{count} of {} trials computed", tasks.len()));
        }
        Some(computed)
    };
    tasks.par_iter().map(one).collect()
}
