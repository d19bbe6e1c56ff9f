//! The kinds of file of which studies compute variants in time: cases of lines, and systems.

use std::sync::Arc;

use super::points::{BaseCase, Setting, reasons};
use crate::case::file_kind::FileKind;
use crate::case::{Case, ReadFile, kind};
use crate::system::motion::job;
use crate::system::motion::job_request::JobRequest;
use crate::system::solved::solve;
use crate::system::{SolvedSystem, SystemFile};

/// A kind of file of which studies compute variants.
pub trait Studied: FileKind + Clone {
    /// The run of a file with some keys set.
    ///
    /// # Errors
    /// Why it refuses them.
    fn variant(base: &BaseCase, settings: &[Setting]) -> Result<JobRequest, String>;

    /// The run of another text of a file, with these overrides.
    ///
    /// # Errors
    /// What is wrong with the text.
    fn of_text(base: &BaseCase, text: String, overrides: Vec<String>)
    -> Result<JobRequest, String>;

    /// The run of what a file says, changed; `how` says in which way.
    ///
    /// # Errors
    /// Why it contradicts itself or, of a system, does not come to rest.
    fn of_content(self, base: &BaseCase, how: &str) -> Result<JobRequest, String>;
}

impl Studied for Case {
    fn variant(base: &BaseCase, settings: &[Setting]) -> Result<JobRequest, String> {
        base.request(settings).map(JobRequest::from)
    }

    fn of_text(
        base: &BaseCase,
        text: String,
        overrides: Vec<String>,
    ) -> Result<JobRequest, String> {
        base.request_of(text, overrides).map(JobRequest::from)
    }

    fn of_content(self, base: &BaseCase, how: &str) -> Result<JobRequest, String> {
        Self::of_text(base, crate::case::write(&self), vec![how.to_owned()])
    }
}

impl Studied for SystemFile {
    fn variant(base: &BaseCase, settings: &[Setting]) -> Result<JobRequest, String> {
        let set = settings.iter().map(Setting::as_override);
        let overrides = base.overrides.iter().cloned().chain(set).collect();
        of_read(base, read(base, settings)?, overrides)
    }

    fn of_text(
        base: &BaseCase,
        text: String,
        overrides: Vec<String>,
    ) -> Result<JobRequest, String> {
        let read = kind::read_variant(&text, &[], &base.files).map_err(|all| reasons(&all))?;
        of_read(base, read, overrides)
    }

    fn of_content(self, base: &BaseCase, how: &str) -> Result<JobRequest, String> {
        let solved = solve(self).map_err(|why| why.problem)?;
        of_solved(base, solved, &base.text, vec![how.to_owned()])
    }
}

/// A system with some keys set.
///
/// # Errors
/// What is wrong with it then, in words.
pub fn read(base: &BaseCase, settings: &[Setting]) -> Result<ReadFile<SystemFile>, String> {
    let written: Vec<String> = settings.iter().map(Setting::written).collect();
    let keys = settings.iter().map(|setting| setting.key.as_str());
    let edits: Vec<(&str, &str)> = keys.zip(written.iter().map(String::as_str)).collect();
    kind::read_variant(&base.text, &edits, &base.files).map_err(|all| reasons(&all))
}

fn of_read(
    base: &BaseCase,
    read: ReadFile<SystemFile>,
    overrides: Vec<String>,
) -> Result<JobRequest, String> {
    let text = read.text.clone();
    let solved = read.compute().map_err(|all| reasons(&all))?;
    of_solved(base, solved, &text, overrides)
}

fn of_solved(
    base: &BaseCase,
    solved: SolvedSystem,
    text: &str,
    overrides: Vec<String>,
) -> Result<JobRequest, String> {
    let request = job::request(Arc::new(solved), text, base.file(), overrides);
    let request = request.ok_or_else(|| "it has no table [solver]".to_owned())?;
    Ok(request.into())
}
