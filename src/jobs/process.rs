//! The process of a job: it takes the job, waits for its turn, computes, and says how it ended.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use signal_hook::low_level::exit;

use super::JobRequest;
use super::board::Board;
use super::folder::JobFolder;
use super::jobs_dir::JobsDir;
use super::launch::Launcher;
use super::server::Server;
use super::spec::{JobComputation, JobSpec};
use super::status::{JobPhase, JobStatus, LoadCaseProgress};
use super::sweep::{SweepEvent, SweepRequest, compute_sweep};
use super::{socket, turn};
use crate::background::lower_priority;
use crate::files::lock::LockFile;
use crate::grace;
use crate::run::store::StoringRecorder;

/// How often the status file is written, where nothing but the progress changes.
const WRITE: Duration = Duration::from_secs(1);

/// Between two looks whether the job is cancelled.
const LOOK: Duration = Duration::from_millis(50);

/// How long the end waits for those who follow to hear of it.
const LAST_WORDS: Duration = Duration::from_secs(2);

/// Leaves the session of the terminal, so that the job goes on when that ends.
pub fn leave_session() {
    // It may lead a session already, started by hand.
    let _ = rustix::process::setsid();
    lower_priority();
}

/// Computes the job in a folder, unless another process does; `cancel` stops it with a checkpoint.
///
/// # Errors
/// The folder cannot be used, in words.
pub fn compute(path: &Path, cancel: &Arc<AtomicBool>) -> Result<(), String> {
    let folder = JobFolder::open(path).map_err(|error| error.to_string())?;
    let lock = folder.take();
    let lock = lock.map_err(|error| format!("the job cannot be taken: {error}"))?;
    // Another process has it.
    let Some(lock) = lock else { return Ok(()) };
    let known = folder.status();
    if known.is_some_and(|status| status.phase.has_ended() || status.results.is_some()) {
        return Ok(());
    }
    let board = Arc::new(Board::default());
    let end = Reporter::start(&folder, &board, cancel)
        .map(|reporter| Arc::new(Mutex::new(Some(reporter))))
        .and_then(|end| obey(&folder, &end, &board, cancel).map(|()| end))
        .map_err(|error| format!("the system gives no thread: {error}"))?;
    serve(&folder, &board, cancel);
    let computed = catch_unwind(AssertUnwindSafe(|| work(&folder, &board, cancel)));
    let status = computed.unwrap_or_else(|_| {
        let log = crate::visible::path(&folder.log());
        failed(format!("a fault of seacable; {log} says more"))
    });
    if !say_the_end(&end, &board, status) {
        // The thread that ends the process has said it.
        loop {
            std::thread::park();
        }
    }
    drop(lock);
    begin_others(&folder);
    Ok(())
}

/// Those that wait see the free core themselves; there may be others that no process has begun.
fn begin_others(folder: &JobFolder) {
    let _ = Launcher::default().begin_waiting(&JobsDir::around(folder));
}

/// Who says how the job ended: whoever takes it first.
type End = Mutex<Option<Reporter>>;

/// Says how the job ended, unless that was said; whether it was not.
fn say_the_end(end: &End, board: &Board, status: JobStatus) -> bool {
    let reporter = end.lock().unwrap_or_else(PoisonError::into_inner).take();
    let Some(reporter) = reporter else {
        return false;
    };
    // The file first: who hears of the end may remove the folder.
    reporter.stop(&JobStatus {
        results: status.results.or_else(|| board.status().results),
        ..status
    });
    board.wait_for_followers(LAST_WORDS);
    true
}

/// Ends the process of a job that is cancelled while it searches an equilibrium, or does something else that does not look whether it is. What is
/// on disk is whole or marked partial then, as after a kill.
fn obey(
    folder: &JobFolder,
    end: &Arc<End>,
    board: &Arc<Board>,
    cancel: &Arc<AtomicBool>,
) -> io::Result<()> {
    let folder = folder.clone();
    let (end, board, cancel) = (Arc::clone(end), Arc::clone(board), Arc::clone(cancel));
    let obey = move || {
        while !cancel.load(Ordering::SeqCst) {
            std::thread::sleep(LOOK);
        }
        grace::wait();
        let status = board.status();
        let cancelled = JobStatus {
            phase: JobPhase::Cancelled,
            ..status
        };
        if say_the_end(&end, &board, cancelled) {
            begin_others(&folder);
            // The lock of the folder and the place in the queue go with the process.
            exit(0);
        }
    };
    let named = std::thread::Builder::new().name("cancel".to_owned());
    named.spawn(obey).map(drop)
}

/// Lets others follow. Where the system gives no socket, they follow the files.
fn serve(folder: &JobFolder, board: &Arc<Board>, cancel: &Arc<AtomicBool>) {
    let server = Server {
        job: folder.number,
        board: Arc::clone(board),
        cancel: Arc::clone(cancel),
        count: Arc::default(),
    };
    let started = socket::listen(folder).and_then(|listener| server.start(listener));
    if let Err(error) = started {
        tell(&format!("no socket to follow the job by: {error}"));
    }
}

/// Writes to the log of the job, which standard error is.
fn tell(words: &str) {
    use io::Write;
    // Without a log there is nobody to tell.
    let _ = writeln!(io::stderr(), "{}", crate::visible::line(words));
}

fn failed(why: String) -> JobStatus {
    tell(&why);
    JobStatus {
        message: Some(why),
        ..JobStatus::new(JobPhase::Failed)
    }
}

fn work(folder: &JobFolder, board: &Board, cancel: &AtomicBool) -> JobStatus {
    let spec = match folder.spec() {
        Ok(spec) => spec,
        Err(error) => return failed(error.to_string()),
    };
    if let Err(why) = spec.check_version() {
        return failed(why);
    }
    match turn_of(folder, &spec, cancel) {
        Ok(Some(_turn)) => {
            board.change(|status| status.phase = JobPhase::Running);
            match spec.work(folder.text()) {
                Ok(JobComputation::Run(request)) => run(&request, &spec, board, cancel),
                Ok(JobComputation::Sweep(request)) => sweep(&request, board, cancel),
                Err(why) => failed(why),
            }
        }
        Ok(None) => JobStatus::new(JobPhase::Cancelled),
        Err(why) => failed(why),
    }
}

/// Waits for a core, and then lets the next job wait for one; load cases share cores with all others and do not wait.
fn turn_of(
    folder: &JobFolder,
    spec: &JobSpec,
    cancel: &AtomicBool,
) -> Result<Option<Option<LockFile>>, String> {
    if spec.is_sweep() {
        return Ok((!cancel.load(Ordering::Relaxed)).then_some(None));
    }
    let jobs = JobsDir::around(folder);
    let turn = turn::wait(&jobs, folder, cancel).map_err(|error| error.to_string())?;
    // A queue that cannot go on now does when the next job ends.
    let _ = Launcher::default().begin_waiting(&jobs);
    Ok(turn.map(Some))
}

/// Computes and stores a run, as `seacable run` does.
fn run(request: &JobRequest, spec: &JobSpec, board: &Board, cancel: &AtomicBool) -> JobStatus {
    let begun = StoringRecorder::begin(
        &spec.place(),
        request.initial_info(),
        &request.stored_text(),
    );
    let mut recorder = match begun {
        Ok(recorder) => recorder,
        Err(error) => return failed(error.to_string()),
    };
    let dir = recorder.dir().to_owned();
    board.change(|status| status.results = Some(dir.clone()));
    let mut is_refused = false;
    let mut run = request.execute(cancel, &mut |event| {
        if !recorder.event(&event) {
            is_refused = true;
            cancel.store(true, Ordering::SeqCst);
        }
        board.event(&event);
    });
    let stopped = cancel.load(Ordering::SeqCst) && !is_refused;
    let stored = recorder.finish(&mut run, stopped);
    let progress = board.status().progress;
    let status = match stored {
        Ok(_) => JobStatus {
            message: run.info.failure,
            ..JobStatus::new(JobPhase::of_run(run.info.state))
        },
        Err(error) => failed(format!("The run cannot be stored: {error}")),
    };
    JobStatus {
        results: Some(dir),
        progress,
        ..status
    }
}

/// Computes load cases, as `seacable sweep` does.
fn sweep(request: &SweepRequest, board: &Board, cancel: &AtomicBool) -> JobStatus {
    let ended = compute_sweep(request, cancel, &|event| match event {
        SweepEvent::Begun(dir) => board.change(|status| status.results = Some(dir)),
        SweepEvent::Progress(count, wall_s) => board.progress(|status| {
            status.load_cases = Some(LoadCaseProgress { count, wall_s });
        }),
    });
    let load_cases = board.status().load_cases;
    let status = match ended {
        Ok(ended) if ended.is_cancelled => JobStatus::new(JobPhase::Cancelled),
        Ok(_) => JobStatus::new(JobPhase::Done),
        Err(why) => failed(why),
    };
    JobStatus {
        load_cases,
        ..status
    }
}

/// The thread that writes the status file.
struct Reporter {
    folder: JobFolder,
    board: Arc<Board>,
    stop: Arc<AtomicBool>,
    thread: std::thread::JoinHandle<()>,
}

impl Reporter {
    fn start(folder: &JobFolder, board: &Arc<Board>, cancel: &Arc<AtomicBool>) -> io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let thread = std::thread::Builder::new().name("status".to_owned());
        let thread = {
            let (folder, board) = (folder.clone(), Arc::clone(board));
            let (stop, cancel) = (Arc::clone(&stop), Arc::clone(cancel));
            thread.spawn(move || report(&folder, &board, &stop, &cancel))?
        };
        Ok(Self {
            folder: folder.clone(),
            board: Arc::clone(board),
            stop,
            thread,
        })
    }

    /// Says the last, to the file and then to those who follow.
    fn stop(self, last: &JobStatus) {
        self.stop.store(true, Ordering::SeqCst);
        // Wakes the thread.
        self.board.change(|_| {});
        // A thread that panicked has written nothing later.
        let _ = self.thread.join();
        let last = last.clone().dated();
        if let Err(error) = self.folder.write_status(&last) {
            tell(&format!("the status cannot be written: {error}"));
        }
        self.board.end(last);
    }
}

/// Writes the status whenever it changes. A folder that was removed takes its job with it.
fn report(folder: &JobFolder, board: &Board, stop: &AtomicBool, cancel: &AtomicBool) {
    let mut known = (0, 0);
    while !stop.load(Ordering::SeqCst) {
        if board.wait_for_phase(&mut known, WRITE) && !stop.load(Ordering::SeqCst) {
            // A disk that is full now may have room later.
            let _ = folder.write_status(&board.status().dated());
        }
        if folder
            .path
            .symlink_metadata()
            .is_err_and(|error| error.kind() == io::ErrorKind::NotFound)
        {
            cancel.store(true, Ordering::SeqCst);
        }
    }
}
