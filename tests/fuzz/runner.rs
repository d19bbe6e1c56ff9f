//! Reads many inputs on all cores, and tells which ones panic, take long or take much memory.

use std::any::Any;
use std::cell::RefCell;
use std::fs;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, Once, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use allocation_counter::measure;
use rustix::time::{ClockId, clock_gettime};

use crate::corpus;
use crate::mutator::Mutator;
use crate::targets::{self, Target};

/// An input may take its thread so much CPU time: other programs do not count.
const LONGEST_TIME: Duration = Duration::from_secs(10);
/// An input may keep its thread waiting so long.
const LONGEST_WAIT: Duration = Duration::from_secs(100);
/// An input that takes longer is kept to be looked at.
const LONG: Duration = Duration::from_secs(1);
/// An input may hold so many bytes at once.
const MOST_BYTES: u64 = 1 << 30;
/// Inputs that a thread takes at once, from one stream of random numbers.
const BATCH: u64 = 50;
/// Inputs kept of each fault.
const KEPT: usize = 3;

/// What is read.
pub(crate) struct Plan {
    /// Inputs of each target.
    pub(crate) inputs: fn(&Target, u64) -> u64,
    /// Inputs of all, where they are shared out.
    pub(crate) total: u64,
    /// Begins no inputs after so long.
    pub(crate) time: Duration,
    /// Of the random numbers.
    pub(crate) seed: u64,
    /// Where faulty inputs are written.
    pub(crate) folder: PathBuf,
    /// The only target, where one is named.
    pub(crate) only: Option<String>,
}

/// What came of the inputs of a target.
#[derive(Default)]
pub(crate) struct Tally {
    pub(crate) name: &'static str,
    pub(crate) inputs: u64,
    pub(crate) read: u64,
    pub(crate) busy: Duration,
    pub(crate) slowest: Duration,
    pub(crate) most_bytes: u64,
    /// What went wrong, in words, and how often.
    pub(crate) faults: Vec<(String, usize)>,
}

struct Batch {
    target: usize,
    stream: u64,
    inputs: u64,
}

/// Reads the inputs of a plan.
pub(crate) fn run(plan: &Plan) -> Vec<Tally> {
    targets::enter();
    let all: Vec<&Target> = targets::all()
        .filter(|target| plan.only.as_deref().is_none_or(|only| only == target.name))
        .collect();
    let corpora: Vec<Vec<Vec<u8>>> = all.iter().map(|target| corpus::of(target)).collect();
    let tallies: Vec<Mutex<Tally>> = all
        .iter()
        .map(|target| {
            Mutex::new(Tally {
                name: target.name,
                ..Tally::default()
            })
        })
        .collect();
    let batches = batches(plan, &all);
    let (next, start) = (AtomicUsize::new(0), Instant::now());
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for number in 0..threads {
            let (all, corpora, tallies, batches, next) =
                (&all, &corpora, &tallies, &batches, &next);
            scope.spawn(move || {
                let taken = || batches.get(next.fetch_add(1, Ordering::Relaxed));
                while let Some(batch) = taken().filter(|_| start.elapsed() < plan.time) {
                    let target = all[batch.target];
                    note(&plan.folder, number, target, batch);
                    let mut tally = Tally::default();
                    let mut mutator = Mutator::new(&corpora[batch.target], plan.seed, batch.stream);
                    for _ in 0..batch.inputs {
                        one(target, &mutator.input(), &mut tally, &plan.folder);
                    }
                    let mut whole = tallies[batch.target]
                        .lock()
                        .unwrap_or_else(PoisonError::into_inner);
                    whole.add(tally);
                }
                let _ = fs::remove_file(note_file(&plan.folder, number));
            });
        }
    });
    let whole = tallies.into_iter();
    whole
        .map(|tally| tally.into_inner().unwrap_or_else(PoisonError::into_inner))
        .collect()
}

/// The inputs of all targets in batches, so ordered that all targets advance together.
fn batches(plan: &Plan, all: &[&Target]) -> Vec<Batch> {
    let mut batches = Vec::new();
    let shares: u64 = all.iter().map(|target| target.share).sum();
    for (number, target) in all.iter().enumerate() {
        let inputs = (plan.inputs)(target, plan.total / shares.max(1));
        let count = inputs.div_ceil(BATCH);
        for stream in 0..count {
            let at = (stream as f64 + 0.5) / count as f64;
            let inputs = BATCH.min(inputs - stream * BATCH);
            batches.push((
                at,
                Batch {
                    target: number,
                    stream,
                    inputs,
                },
            ));
        }
    }
    batches.sort_by(|a, b| a.0.total_cmp(&b.0));
    batches.into_iter().map(|(_, batch)| batch).collect()
}

fn note_file(folder: &Path, thread: usize) -> PathBuf {
    folder.join(format!("thread-{thread}"))
}

/// What a thread reads at the moment, for the case that it takes the process with it.
fn note(folder: &Path, thread: usize, target: &Target, batch: &Batch) {
    let _ = fs::write(
        note_file(folder, thread),
        format!("{} {}\n", target.name, batch.stream),
    );
}

thread_local! {
    /// Where this thread panicked, while it reads an input.
    static PANIC: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Panics of inputs are kept instead of printed; all others are printed as ever.
fn silence() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            let expected = PANIC.with_borrow_mut(|place| {
                let place = place.as_mut()?;
                *place = info
                    .location()
                    .map_or_else(String::new, ToString::to_string);
                Some(())
            });
            if expected.is_none() {
                before(info);
            }
        }));
    });
}

/// CPU time of this thread.
fn cpu_time() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.try_into().unwrap_or_default()
}

/// Reads one input.
pub(crate) fn one(target: &Target, data: &[u8], tally: &mut Tally, folder: &Path) {
    silence();
    PANIC.set(Some(String::new()));
    let mut read = Ok(false);
    let (start, began) = (cpu_time(), Instant::now());
    let memory = measure(|| read = panic::catch_unwind(AssertUnwindSafe(|| target.read(data))));
    let took = cpu_time().saturating_sub(start);
    let place = PANIC.take().unwrap_or_default();
    tally.inputs += 1;
    tally.busy += took;
    tally.slowest = tally.slowest.max(took);
    tally.most_bytes = tally.most_bytes.max(memory.bytes_max);
    match read {
        Ok(read) => tally.read += u64::from(read),
        Err(why) => tally.fault(
            &format!("panic at {place}: {}", words(why.as_ref())),
            data,
            target,
            folder,
        ),
    }
    if took > LONGEST_TIME || began.elapsed() > LONGEST_WAIT {
        tally.fault("time above 10 s", data, target, folder);
    } else if took > LONG {
        keep(folder, target, "slow", data);
    }
    if memory.bytes_max > MOST_BYTES {
        tally.fault("memory above 1 GiB", data, target, folder);
    }
}

fn words(why: &(dyn Any + Send)) -> String {
    let text = why.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| why.downcast_ref::<&str>().copied());
    text.unwrap_or_default().chars().take(200).collect()
}

impl Tally {
    fn fault(&mut self, what: &str, data: &[u8], target: &Target, folder: &Path) {
        // Faults of one place are one fault, whatever number its message has.
        let place = what.split(": ").next().unwrap_or(what).to_owned();
        let known = self
            .faults
            .iter()
            .position(|(known, _)| known.starts_with(&place));
        let at = known.unwrap_or_else(|| {
            self.faults.push((what.to_owned(), 0));
            self.faults.len() - 1
        });
        self.faults[at].1 += 1;
        if self.faults[at].1 == 1 {
            eprintln!("{}: {what}", target.name);
        }
        if self.faults[at].1 <= KEPT {
            keep(
                folder,
                target,
                what.split(' ').next().unwrap_or_default(),
                data,
            );
        }
    }

    fn add(&mut self, other: Self) {
        self.inputs += other.inputs;
        self.read += other.read;
        self.busy += other.busy;
        self.slowest = self.slowest.max(other.slowest);
        self.most_bytes = self.most_bytes.max(other.most_bytes);
        for (what, times) in other.faults {
            let place = what.split(": ").next().unwrap_or(&what).to_owned();
            match self
                .faults
                .iter_mut()
                .find(|(known, _)| known.starts_with(&place))
            {
                Some(known) => known.1 += times,
                None => self.faults.push((what, times)),
            }
        }
    }
}

/// Writes an input below the folder of its target, named by what it holds.
fn keep(folder: &Path, target: &Target, what: &str, data: &[u8]) {
    let print = data.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    });
    let place = folder.join(target.name);
    let written = fs::create_dir_all(&place)
        .and_then(|()| fs::write(place.join(format!("{what}-{print:016x}")), data));
    if let Err(error) = written {
        eprintln!("{}: {error}", place.display());
    }
}

/// The tallies as a table, and the faults below it.
pub(crate) fn table(tallies: &[Tally]) -> String {
    let mut text = format!(
        "{:20} {:>10} {:>7} {:>10} {:>10} {:>9} {:>6}\n",
        "target", "inputs", "read %", "per CPU s", "slowest ms", "most MB", "faults"
    );
    let row = |tally: &Tally| {
        let faults: usize = tally.faults.iter().map(|(_, times)| times).sum();
        format!(
            "{:20} {:>10} {:>7.1} {:>10.0} {:>10.1} {:>9.1} {:>6}\n",
            tally.name,
            tally.inputs,
            100.0 * tally.read as f64 / tally.inputs.max(1) as f64,
            tally.inputs as f64 / tally.busy.as_secs_f64().max(1e-9),
            1e3 * tally.slowest.as_secs_f64(),
            tally.most_bytes as f64 / 1e6,
            faults
        )
    };
    text.extend(tallies.iter().map(row));
    let mut all = Tally {
        name: "all",
        ..Tally::default()
    };
    for tally in tallies {
        all.inputs += tally.inputs;
        all.read += tally.read;
        all.busy += tally.busy;
        all.slowest = all.slowest.max(tally.slowest);
        all.most_bytes = all.most_bytes.max(tally.most_bytes);
        all.faults.extend(tally.faults.iter().cloned());
    }
    text.push_str(&row(&all));
    for tally in tallies {
        for (what, times) in &tally.faults {
            text.push_str(&format!("{}: {times} times {what}\n", tally.name));
        }
    }
    text
}
