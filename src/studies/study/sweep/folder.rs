//! The folder of a sweep: what is computed, and the table of results. The runs stand beside it, so that they are listed among all others:
//! the run of load case 7 of `runs/spar-sweep-20261125-101500` is `runs/spar-sweep-20261125-101500-0007`.
//!
//! | file | holds |
//! |---|---|
//! | `case.toml` | the exact input, without its load cases |
//! | `load_cases.csv` | the load cases, a column for each key |
//! | `sweep.toml` | [`SweepInfo`]: results that are shown, digests of both files |
//! | `results.csv` | the table of results, when the sweep has ended |
//! | `seas.csv` | what the seeds of each sea say together |
//! | `checks.csv` | the share that each check leaves at each place in each sea |
//! | `window.csv` | of a search: the limiting value of each sea |
//! | `report.txt` | the page that is printed, in ASCII at 80 columns |
//! | `slurm.toml`, `array.sh`, `tasks` | of a sweep on a cluster: see [`slurm`](super::slurm) and [`Part`](super::SweepPart) |
//!
//! The runs are the record of what is done: a sweep that goes on reads those that came to their end. The folder appears in one step.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};

use crate::case::StudyValue;
use crate::files::shallow::shallow;
use crate::files::{WriteError, WriteTarget, disk, read};
use crate::run::VERSION;
use crate::run::store::{self, DirectoryLock, StoreError, lock_directory};
use crate::seal::{Digest, SealedPart};
use crate::strays::{self, Hidden};
use crate::study::vary::Variation;
use crate::visible;

const CASE: &str = "case.toml";
const LOAD_CASES: &str = "load_cases.csv";
pub(super) const SWEEP: &str = "sweep.toml";
const RESULTS: &str = "results.csv";
const SEAS: &str = "seas.csv";
const CHECKS: &str = "checks.csv";
const WINDOW: &str = "window.csv";
const REPORT: &str = "report.txt";
const FILES: [&str; 8] = [
    CASE, LOAD_CASES, SWEEP, RESULTS, SEAS, CHECKS, WINDOW, REPORT,
];

/// What a sweep is, as `sweep.toml` says it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SweepInfo {
    /// Version of the program that began it.
    pub version: String,
    /// File name of the case.
    pub case_file: String,
    /// Number of load cases.
    pub load_cases: usize,
    /// Keys set on top of the file, as `key=value`.
    pub overrides: Vec<String>,
    /// Names of the results that are shown.
    pub results: Vec<String>,
    /// The key whose limiting value is sought, with its values; absent where the load cases themselves are computed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub window: Option<String>,
    case: SealedPart,
    table: SealedPart,
}

impl SweepInfo {
    /// Whether it is of exactly this case at these load cases, with these results.
    #[must_use]
    pub fn is_of(&self, variation: &Variation, results: &[String]) -> bool {
        let base = &variation.base;
        self.case.is(&base.text)
            && self.table.is(&table(variation))
            && self.case_file == base.file()
            && self.overrides == base.overrides
            && self.results == results
            && self.window.is_none()
    }
}

/// Why a sweep cannot be kept or resumed.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// Load cases that cannot be computed finer, and why.
    #[error("Load cases cannot be computed finer: {0}.")]
    Finer(String),
    /// Nothing that is a sweep.
    #[error("{} holds no sweep: it has no sweep.toml. Name the folder that `seacable sweep` printed.", visible::path(.0))]
    NotASweep(PathBuf),
    /// A file that was changed or cannot be understood.
    #[error("{} cannot be used: {reason}", visible::path(file))]
    Damaged {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// Another program computes it.
    #[error("{} is being computed by another program.", visible::path(.0))]
    Busy(PathBuf),
    /// The folder exists.
    #[error("{} exists already. Name a folder that does not exist yet, or give it to --resume.", visible::path(.0))]
    Taken(PathBuf),
    /// A part that has no load cases.
    #[error("There is no load case {0}: the sweep has {1}. Give --part numbers of these.")]
    Beyond(usize, usize),
    /// A sweep that stores no runs.
    #[error(
        "The system is computed at rest: its sweep stores no runs and takes no time worth a cluster. Leave out --slurm and --part."
    )]
    AtRest,
    /// A name that cannot stand in the script of an array.
    #[error("{0}")]
    Script(super::slurm::Unfit),
    /// A run that cannot be put aside.
    #[error("{0}")]
    Run(StoreError),
    /// The system refuses.
    #[error("{} failed: {source}", visible::path(file))]
    Io {
        /// The file.
        file: PathBuf,
        /// What the system reported.
        source: io::Error,
    },
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// The folder of a sweep that this program computes.
#[derive(Debug)]
pub struct SweepFolder {
    dir: PathBuf,
    /// Digits of the numbers of the load cases.
    pub(super) digits: usize,
    _lock: Option<DirectoryLock>,
}

/// A sweep read back: what it is, its case and its table of load cases.
#[derive(Debug)]
pub struct StoredSweep {
    /// What it is.
    pub info: SweepInfo,
    /// The text of the case.
    pub case: String,
    /// Its load cases as CSV.
    pub load_cases: String,
}

impl SweepFolder {
    /// Makes the folder of a sweep: `dir`, or one below the default directory of runs named after the case and the time.
    ///
    /// # Errors
    /// It exists already, or cannot be written.
    pub fn create(
        dir: Option<&Path>,
        variation: &Variation,
        (results, window): (Vec<String>, Option<&str>),
    ) -> Result<Self, SweepError> {
        let base = &variation.base;
        let table = table(variation);
        let digest = |text: &str| Digest::of_bytes(text.as_bytes()).part();
        let info = SweepInfo {
            version: VERSION.to_owned(),
            case_file: base.file(),
            load_cases: variation.points.len(),
            overrides: base.overrides.clone(),
            results,
            window: window.map(str::to_owned),
            case: digest(&base.text),
            table: digest(&table),
        };
        let text = toml::to_string(&info)
            .map_err(|error| damaged(Path::new(""), SWEEP, error.to_string()))?;
        let text = visible::toml(&text).into_owned();
        let files = [(CASE, &*base.text), (LOAD_CASES, &table), (SWEEP, &text)];
        let (dir, lock) = match dir {
            Some(dir) => (dir.to_owned(), appear(dir, &files)?),
            None => below(Path::new(store::DEFAULT_ROOT), &base.file(), &files)?,
        };
        Ok(Self::of_folder(dir, info.load_cases, lock))
    }

    fn of_folder(dir: PathBuf, count: usize, lock: Option<DirectoryLock>) -> Self {
        Self {
            dir,
            digits: count.to_string().len().max(4),
            _lock: lock,
        }
    }

    /// Whether a directory is the folder of a sweep.
    #[must_use]
    pub fn is_one(dir: &Path) -> bool {
        dir.join(SWEEP).is_file()
    }

    /// Opens the folder of a sweep that was stopped, and reads what it is.
    ///
    /// # Errors
    /// It is no sweep, was changed, or another program computes it.
    pub fn open(dir: &Path) -> Result<(Self, StoredSweep), SweepError> {
        Self::opened(dir, true)
    }

    /// The same to compute a [`Part`](super::SweepPart) of it, while others compute theirs and a program watches them: nobody is excluded.
    ///
    /// # Errors
    /// It is no sweep, or was changed.
    pub fn open_part(dir: &Path) -> Result<(Self, StoredSweep), SweepError> {
        Self::opened(dir, false)
    }

    fn opened(dir: &Path, alone: bool) -> Result<(Self, StoredSweep), SweepError> {
        // The runs stand beside it, under its name.
        let named = dir.file_name().is_some().then(|| Ok(dir.to_owned()));
        let named = named.unwrap_or_else(|| dir.canonicalize());
        let dir = &named.map_err(|source| SweepError::Io {
            file: dir.to_owned(),
            source,
        })?;
        let text = |name: &str| {
            let file = dir.join(name);
            read::run_text(&file).map_err(|source| SweepError::Io { file, source })
        };
        if !Self::is_one(dir) {
            return Err(SweepError::NotASweep(dir.to_owned()));
        }
        if alone && store::is_locked(dir) {
            return Err(SweepError::Busy(dir.to_owned()));
        }
        let lock = alone.then(|| lock_directory(dir)).flatten();
        let info: SweepInfo = toml::from_str(shallow(&text(SWEEP)?))
            .map_err(|error| damaged(dir, SWEEP, error.to_string()))?;
        let (case, load_cases) = (text(CASE)?, text(LOAD_CASES)?);
        for (name, part, text) in [
            (CASE, &info.case, &case),
            (LOAD_CASES, &info.table, &load_cases),
        ] {
            if !part.is(text) {
                let reason =
                    "it was changed since the sweep began; undo the change, or begin a new sweep";
                return Err(damaged(dir, name, reason.to_owned()));
            }
        }
        let folder = Self::of_folder(dir.to_owned(), info.load_cases, lock);
        Ok((
            folder,
            StoredSweep {
                info,
                case,
                load_cases,
            },
        ))
    }

    /// The folder of a round of a search, beside this one: opened where it is there, else made.
    ///
    /// # Errors
    /// It is no sweep of these load cases, or cannot be written.
    pub fn round(
        &self,
        number: usize,
        variation: &Variation,
        results: Vec<String>,
    ) -> Result<Self, SweepError> {
        self.beside(&format!("round-{number}"), variation, results)
    }

    /// The directory beside this one whose name goes on so.
    pub(super) fn dir_beside(&self, name: &str) -> PathBuf {
        let mut whole = self.dir.file_name().unwrap_or_default().to_owned();
        whole.push(format!("-{name}"));
        self.dir.with_file_name(whole)
    }

    /// The folder of further load cases, beside this one: opened where it is there, else made.
    ///
    /// # Errors
    /// It is no sweep of these load cases, or cannot be written.
    pub(super) fn beside(
        &self,
        name: &str,
        variation: &Variation,
        results: Vec<String>,
    ) -> Result<Self, SweepError> {
        let dir = self.dir_beside(name);
        if dir.symlink_metadata().is_err() {
            return Self::create(Some(&dir), variation, (results, None));
        }
        let (folder, stored) = Self::open(&dir)?;
        if stored.load_cases != table(variation) || stored.case != variation.base.text {
            let reason = "it has other load cases than this round; move it away";
            return Err(damaged(&dir, LOAD_CASES, reason.to_owned()));
        }
        Ok(folder)
    }

    /// Writes what a search has found, and the report as text.
    ///
    /// # Errors
    /// The system refuses.
    pub fn write_window(&self, table: &[u8], report: &str) -> Result<(), SweepError> {
        self.write(WINDOW, table)?;
        self.write(REPORT, report.as_bytes())
    }

    /// Where it is.
    #[must_use]
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Whether its table of results was written: the sweep has ended once.
    #[must_use]
    pub fn has_ended(&self) -> bool {
        self.dir.join(RESULTS).is_file()
    }

    /// Writes the table of results.
    ///
    /// # Errors
    /// The system refuses.
    pub fn write_results(&self, csv: &[u8]) -> Result<(), SweepError> {
        self.write(RESULTS, csv)
    }

    /// Writes one of the tables as a Parquet file: `results`, `seas` or `checks`.
    ///
    /// # Errors
    /// The system refuses.
    pub fn write_parquet(&self, table: &str, content: &[u8]) -> Result<(), SweepError> {
        self.write(&format!("{table}.parquet"), content)
    }

    /// Writes what the runs say together: the table of the seas, that of the checks, and the report as text.
    ///
    /// # Errors
    /// The system refuses.
    pub fn write_verdict(
        &self,
        seas: &[u8],
        checks: &[u8],
        report: &str,
    ) -> Result<(), SweepError> {
        self.write(SEAS, seas)?;
        self.write(CHECKS, checks)?;
        self.write(REPORT, report.as_bytes())
    }

    fn write(&self, name: &str, content: &[u8]) -> Result<(), SweepError> {
        WriteTarget::replacing(&self.dir.join(name)).write(content)?;
        Ok(())
    }
}

fn damaged(dir: &Path, name: &str, reason: String) -> SweepError {
    SweepError::Damaged {
        file: dir.join(name),
        reason,
    }
}

/// A new folder below a directory, of a name that nobody else has.
fn below(
    root: &Path,
    case_file: &str,
    files: &[(&str, &str)],
) -> Result<(PathBuf, Option<DirectoryLock>), SweepError> {
    let time = store::stamp(store::now());
    let base = format!("{}-sweep-{time}", store::stem(case_file));
    let mut count = 1_u64;
    loop {
        let name = match count {
            1 => base.clone(),
            _ => format!("{base}-{count}"),
        };
        let dir = root.join(name);
        match appear(&dir, files) {
            Err(SweepError::Taken(_)) => count += 1,
            other => return other.map(|lock| (dir, lock)),
        }
    }
}

/// A number for each hidden directory of this process.
static COUNTER: AtomicU64 = AtomicU64::new(0);

/// Makes a folder with its files, held, in one step: nobody ever sees it without them.
fn appear(dir: &Path, files: &[(&str, &str)]) -> Result<Option<DirectoryLock>, SweepError> {
    let io = |file: &Path| {
        let file = file.to_owned();
        move |source| SweepError::Io { file, source }
    };
    if dir.symlink_metadata().is_ok() {
        return Err(SweepError::Taken(dir.to_owned()));
    }
    let parent = dir.parent().filter(|parent| !parent.as_os_str().is_empty());
    let parent = parent.unwrap_or(Path::new("."));
    disk::create_dir_all(parent).map_err(io(parent))?;
    strays::remove(parent, &FILES);
    let number = COUNTER.fetch_add(1, Ordering::Relaxed);
    let mut name = strays::prefix(dir.file_name().unwrap_or_default());
    name.push(format!("{number}{}", Hidden::NewRun.suffix()));
    let hidden = parent.join(name);
    let filled = fill(&hidden, files).and_then(|()| {
        let lock = lock_directory(&hidden);
        let renamed = disk::rename(&hidden, dir);
        renamed.map(|()| lock).map_err(|error| match error.kind() {
            io::ErrorKind::DirectoryNotEmpty | io::ErrorKind::AlreadyExists => {
                SweepError::Taken(dir.to_owned())
            }
            _ => io(dir)(error),
        })
    });
    if filled.is_err() {
        // Best effort: the error that matters is the one already in hand.
        let _ = disk::remove_dir_all(&hidden);
    }
    let lock = filled?;
    disk::sync_directory(parent);
    Ok(lock)
}

fn fill(dir: &Path, files: &[(&str, &str)]) -> Result<(), SweepError> {
    disk::create_dir(dir).map_err(|source| SweepError::Io {
        file: dir.to_owned(),
        source,
    })?;
    for (name, text) in files {
        WriteTarget::new(&dir.join(name)).write(text.as_bytes())?;
    }
    Ok(())
}

/// The load cases as CSV, in the units of their keys.
fn table(variation: &Variation) -> String {
    let mut head: Vec<&str> = variation.keys.iter().map(|key| key.path.as_str()).collect();
    if variation.probability.is_some() {
        head.push("probability");
    }
    let mut text = head.join(",") + "\n";
    for (index, point) in variation.points.iter().enumerate() {
        let values = point.settings.iter().map(|setting| match &setting.value {
            StudyValue::Number(number) => number.to_string(),
            StudyValue::Word(word) => word.clone(),
        });
        let weight = variation.probability.as_ref().map(|p| p[index].to_string());
        let row: Vec<String> = values.chain(weight).collect();
        text.push_str(&(row.join(",") + "\n"));
    }
    text
}
