//! What a job is to compute, as it is kept in its folder: `request.toml`, and the text of its case beside it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::JobRequest;
use super::identity::ProcessIdentity;
use super::status::VERSION;
use super::sweep::SweepRequest;
use crate::case::{self, Diagnostic, kind};
use crate::files::read;
use crate::files::root::GivenRoots;
use crate::kinds::FileType;
use crate::limits;
use crate::run::VERSION as PROGRAM;
use crate::run::computation::Computation;
use crate::run::job::Request;
use crate::run::store::{RunLocation, now, rfc3339};
use crate::system::SystemFile;
use crate::system::motion;

/// What is to be computed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum JobWork {
    /// A run of the text beside the request.
    Run {
        /// Whether it is of a system of lines.
        system: bool,
        /// File name of its case.
        file: String,
        /// Keys set on top of the file, as `key=value`.
        overrides: Vec<String>,
    },
    /// A stored run resumed.
    Resume {
        /// Its directory.
        run: PathBuf,
        /// Up to this time \[s\]; absent: to the end of its case.
        until: Option<f64>,
    },
    /// The load cases of the text beside the request.
    Sweep {
        /// Whether they are of a system of lines.
        system: bool,
        /// Keys in which the text differs from the file, as `key=value`.
        overrides: Vec<String>,
    },
}

/// What a job is to compute. Written as `request.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JobSpec {
    /// Version of this description.
    pub version: u32,
    /// Version of the program that wrote it.
    pub program: String,
    /// What it computes, in words.
    pub name: String,
    /// What is special about its run ("current.speed_m_per_s = 0.2"), or empty.
    pub label: String,
    /// When it was asked for, RFC 3339 in UTC.
    pub submitted: String,
    /// The directory that it works in; its results are below.
    pub directory: PathBuf,
    /// The file of its case.
    pub case: PathBuf,
    /// The directory of its run, where one is named.
    pub out: Option<PathBuf>,
    /// Options that lift limits.
    pub options: Vec<String>,
    /// What is computed.
    pub work: JobWork,
    /// Where files may lie that a case names.
    pub roots: GivenRoots,
    /// The process that asked for it.
    pub by: ProcessIdentity,
}

/// A request with the text of its case; a resumed run has its own.
#[derive(Debug, Clone)]
pub struct JobSubmission {
    /// The request.
    pub spec: JobSpec,
    /// The text.
    pub text: Option<String>,
}

/// What a job computes.
#[derive(Debug, Clone)]
pub enum JobComputation {
    /// A run.
    Run(JobRequest),
    /// Load cases.
    Sweep(SweepRequest),
}

impl JobSubmission {
    /// A run that begins or is resumed, of the case in this file.
    ///
    /// # Errors
    /// The directory of the process is not known, in words.
    pub fn of_run(request: &JobRequest, name: &str, case: &Path) -> Result<Self, String> {
        let work = match request {
            JobRequest::Line(line, Some(from)) => JobWork::Resume {
                run: from.dir.clone(),
                until: Some(line.case.duration_s()),
            },
            JobRequest::System(system, Some(from)) => JobWork::Resume {
                run: from.dir.clone(),
                until: Some(system.case.duration_s()),
            },
            JobRequest::Line(line, None) => JobWork::Run {
                system: false,
                file: line.file.clone(),
                overrides: line.overrides.clone(),
            },
            JobRequest::System(system, None) => JobWork::Run {
                system: true,
                file: system.file.clone(),
                overrides: system.overrides.clone(),
            },
        };
        let is_resumed = matches!(work, JobWork::Resume { .. });
        Ok(Self {
            spec: JobSpec::new(work, name, case)?,
            text: (!is_resumed).then(|| request.stored_text().into_owned()),
        })
    }

    /// The load cases of a text.
    ///
    /// # Errors
    /// The directory of the process is not known, in words.
    pub fn of_sweep(request: &SweepRequest, name: &str) -> Result<Self, String> {
        let work = JobWork::Sweep {
            system: request.kind == FileType::System,
            overrides: request.overrides.clone(),
        };
        Ok(Self {
            spec: JobSpec::new(work, name, &request.path)?,
            text: Some(request.text.clone()),
        })
    }
}

impl JobSpec {
    fn new(work: JobWork, name: &str, case: &Path) -> Result<Self, String> {
        let directory = std::env::current_dir();
        let directory = directory.map_err(|error| {
            format!("the directory that the program works in is not known: {error}")
        })?;
        let limit = read::given_limit().map(|bytes| format!("--limit-file-size={bytes}"));
        Ok(Self {
            version: VERSION,
            program: PROGRAM.to_owned(),
            name: name.to_owned(),
            label: String::new(),
            submitted: rfc3339(now()),
            case: plain(&directory, case),
            directory,
            out: None,
            options: limits::lifted().into_iter().chain(limit).collect(),
            work,
            roots: GivenRoots::of_this_process(),
            by: ProcessIdentity::own(),
        })
    }

    /// Whether it computes load cases.
    #[must_use]
    pub const fn is_sweep(&self) -> bool {
        matches!(self.work, JobWork::Sweep { .. })
    }

    /// Where its run goes.
    #[must_use]
    pub fn place(&self) -> RunLocation {
        match &self.out {
            Some(dir) => RunLocation::Exactly(dir.clone()),
            None => RunLocation::Below(crate::run::store::DEFAULT_ROOT.into()),
        }
    }

    /// Checks that this program knows the request.
    ///
    /// # Errors
    /// It is of another version, in words.
    pub fn check_version(&self) -> Result<(), String> {
        match self.version {
            VERSION => Ok(()),
            other => Err(format!(
                "the request is of version {other}, written by seacable {}; this is seacable {PROGRAM}, which knows version {VERSION}",
                self.program
            )),
        }
    }

    /// What it computes, with the text beside it. Takes the time to read a case.
    ///
    /// # Errors
    /// The text is not valid or missing, or the run cannot be resumed, in words.
    pub fn work(&self, text: Option<String>) -> Result<JobComputation, String> {
        self.roots.clone().adopt();
        let text = || text.ok_or_else(|| "the text of its case is missing".to_owned());
        Ok(match &self.work {
            JobWork::Resume { run, until } => {
                JobComputation::Run(JobRequest::resumed_until(run, *until)?)
            }
            JobWork::Run {
                system,
                file,
                overrides,
            } => JobComputation::Run(run_request(*system, text()?, file, overrides)?),
            JobWork::Sweep { system, overrides } => JobComputation::Sweep(SweepRequest {
                kind: match system {
                    true => FileType::System,
                    false => FileType::Line,
                },
                text: text()?,
                path: self.seen_from_here(&self.case),
                overrides: overrides.clone(),
            }),
        })
    }

    /// A path as it was named by who works in the same directory.
    fn seen_from_here(&self, path: &Path) -> PathBuf {
        let below = path.strip_prefix(&self.directory);
        below.map_or_else(|_| path.to_owned(), Path::to_owned)
    }
}

/// The run of a text that holds the files that it names.
fn run_request(
    is_system: bool,
    text: String,
    file: &str,
    overrides: &[String],
) -> Result<JobRequest, String> {
    let first = |all: Vec<Diagnostic>| all.first().map(ToString::to_string).unwrap_or_default();
    if is_system {
        let solved = kind::parse_stored::<SystemFile>(&text, file).map_err(first)?;
        let (file, overrides) = (file.to_owned(), overrides.to_vec());
        let request = motion::job::request(Arc::new(solved), &text, file, overrides);
        let request = request.ok_or("its text has no table `[solver]`")?;
        return Ok(JobRequest::System(Box::new(request), None));
    }
    let request = Request {
        case: case::parse_stored(&text, file).map_err(first)?,
        text,
        file: file.to_owned(),
        overrides: overrides.to_vec(),
        id: String::new(),
    };
    Ok(JobRequest::Line(Box::new(request), None))
}

/// A path from a directory, without `.` and doubled separators.
#[must_use]
pub fn plain(directory: &Path, path: &Path) -> PathBuf {
    directory.join(path).components().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_request_is_read_back_as_it_was_written() {
        let work = JobWork::Resume {
            run: "runs/small-1".into(),
            until: Some(1.0 / 3.0),
        };
        let spec = JobSpec::new(work, "small \"to\" 0.3 s", Path::new("./small.toml")).unwrap();
        assert!(spec.case.is_absolute() && spec.case.ends_with("small.toml"));
        let text = toml::to_string(&spec).unwrap();
        assert_eq!(toml::from_str::<JobSpec>(&text).unwrap(), spec);
        assert!(spec.check_version().is_ok());
        let newer = JobSpec { version: 2, ..spec };
        assert!(newer.check_version().unwrap_err().contains("version 2"));
    }
}
