//! The thread that keeps the index of the runs, so that the screen never waits for a directory of ten thousand.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant, SystemTime};

use crossbeam_channel::{Receiver, RecvTimeoutError, Sender, unbounded};

use super::outbox::Outbox;
use crate::background::lower_priority;
use crate::msg::{Msg, RunsFound};
use crate::places::cache_dir;
use crate::run::RunState;
use crate::run::index::{IndexError, IndexedRun, RunIndex, SyncProgress};
use crate::run::store::{self, is_locked};
use crate::state::{RunEntry, RunStatus, Severity};

/// What the screen asks of the index.
#[derive(Debug)]
pub(super) enum IndexQuestion {
    /// The runs of these case files, with these results, from the beginning.
    List {
        files: Vec<String>,
        results: Vec<String>,
    },
    /// What has changed since.
    Refresh,
}

/// The thread that keeps the index; it begins with the first question.
#[derive(Debug, Default)]
pub(super) struct IndexWorker {
    questions: Option<Sender<IndexQuestion>>,
}

/// How often the directory of the runs is looked at for runs of other programs.
const LOOK: Duration = Duration::from_secs(2);

/// How long each run is looked at after runs came or went: the files of one that is copied in come one after another, which
/// changes its own directory only. The pauses between the looks grow, as each reads the state of all runs.
const SETTLING: Duration = Duration::from_secs(60);

/// Fewer runs are read before anyone could look at their progress.
const WORTH_TELLING: usize = 100;

impl IndexWorker {
    /// Asks; answers come as messages.
    pub(super) fn ask(&mut self, question: IndexQuestion, out: &Outbox) -> Vec<Msg> {
        if self.questions.is_none() {
            let (sender, receiver) = unbounded();
            let out = out.clone();
            let started = std::thread::Builder::new()
                .name("run index".to_owned())
                .spawn(move || keep(&receiver, &out));
            if let Err(error) = started {
                let words = format!("The system gives no thread for the list of runs: {error}.");
                return vec![Msg::Say(Severity::Error, words)];
            }
            self.questions = Some(sender);
        }
        if let Some(questions) = &self.questions {
            // The thread ends with the program only.
            let _ = questions.send(question);
        }
        Vec::new()
    }
}

fn keep(questions: &Receiver<IndexQuestion>, out: &Outbox) {
    lower_priority();
    let root = Path::new(store::DEFAULT_ROOT);
    let index = match RunIndex::open(root, cache_dir().ok().as_deref()) {
        Ok(index) => index,
        Err(error) => return complain(out, &error),
    };
    let mut keeper = Keeper {
        index,
        files: Vec::new(),
        results: Vec::new(),
        since: 0,
        partial: false,
        changed: None,
        noticed: Instant::now(),
        looked: Instant::now(),
        out: out.clone(),
    };
    loop {
        match questions.recv_timeout(LOOK) {
            Ok(IndexQuestion::List { files, results }) => {
                (keeper.files, keeper.results, keeper.since) = (files, results, 0);
                keeper.work(true);
            }
            Ok(IndexQuestion::Refresh) => keeper.work(false),
            Err(RecvTimeoutError::Timeout) if keeper.may_have_changed() => keeper.work(false),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}

fn complain(out: &Outbox, error: &IndexError) {
    let words = format!("The runs cannot be listed: {error}.");
    out.send(Msg::Say(Severity::Error, words));
}

struct Keeper {
    index: RunIndex,
    files: Vec<String>,
    results: Vec<String>,
    /// The state of the index that the screen knows.
    since: i64,
    /// Whether another program may be computing one of the runs.
    partial: bool,
    /// When the directory of the runs changed, as seen last.
    changed: Option<SystemTime>,
    /// When that was noticed.
    noticed: Instant,
    /// When each run was looked at.
    looked: Instant,
    out: Outbox,
}

impl Keeper {
    /// Tells what is known at once where that is asked for, brings the index in step, and tells what has changed. An index that
    /// turns out to be damaged is made anew.
    fn work(&mut self, at_once: bool) {
        let mut done = self.step(at_once);
        if let Err(error) = done {
            self.since = 0;
            done = self.index.mend(error).and_then(|()| self.step(true));
        }
        if let Err(error) = done {
            complain(&self.out, &error);
        }
    }

    fn step(&mut self, at_once: bool) -> Result<(), IndexError> {
        if at_once {
            self.tell(false, true)?;
        }
        let now = changed(self.index.root());
        if now != self.changed {
            // Runs that came long before the program began are there in full.
            let since = now.and_then(|at| at.elapsed().ok()).unwrap_or_default();
            let noticed = Instant::now().checked_sub(since);
            (self.changed, self.noticed) = (now, noticed.unwrap_or_else(Instant::now));
        }
        let out = self.out.clone();
        let mut told = |progress: SyncProgress| {
            if progress.all >= WORTH_TELLING {
                out.send(Msg::Indexing(progress));
            }
        };
        let progress = self.index.sync(&AtomicBool::new(false), &mut told)?;
        self.looked = Instant::now();
        if at_once || progress.all > 0 || self.partial {
            self.tell(true, at_once || progress.all > 0)?;
        }
        Ok(())
    }

    /// Sends the runs that have changed since they were sent last.
    fn tell(&mut self, whole: bool, columns: bool) -> Result<(), IndexError> {
        let Some(first) = self.files.first() else {
            return Ok(());
        };
        let rows = self.index.rows(&self.files, self.since)?;
        self.since = rows.state;
        let columns = columns.then(|| self.index.columns(first, &self.results));
        let columns = columns.transpose()?;
        let root = self.index.root();
        let entry = |run: IndexedRun| entry(root, run, first);
        let changed: Vec<RunEntry> = rows.changed.into_iter().map(entry).collect();
        self.partial = changed.iter().any(|run| run.state == RunStatus::Elsewhere);
        let found = RunsFound {
            changed,
            all: rows.all,
            columns,
            whole,
        };
        self.out.send(Msg::RunsListed(Box::new(found)));
        Ok(())
    }

    /// Whether runs may have come, gone or ended. A run that ends changes only its own directory.
    fn may_have_changed(&self) -> bool {
        let since = self.looked.saturating_duration_since(self.noticed);
        let settling = self.changed.is_some()
            && self.noticed.elapsed() < SETTLING
            && self.looked.elapsed() >= since.min(SETTLING / 4);
        self.partial || settling || changed(self.index.root()) != self.changed
    }
}

fn changed(root: &Path) -> Option<SystemTime> {
    std::fs::metadata(root).ok()?.modified().ok()
}

/// A run for the list; one of another case than the first says which.
fn entry(root: &Path, run: IndexedRun, first: &str) -> RunEntry {
    let dir = root.join(&run.name);
    let held = run.state == RunState::Partial && is_locked(&dir);
    let stem = run.case_file.trim_end_matches(".toml").to_owned();
    let other = run.case_file != first;
    let mut entry = RunEntry::stored(run, dir, held);
    if other {
        entry.label = format!("{stem} {}", entry.label).trim_end().to_owned();
    }
    entry
}
