//! The kinds of file of which studies compute variants: cases of lines, and systems in time or at rest.

use std::sync::Arc;

use super::points::{BaseCase, Setting, reasons};
use super::study_job::StudyJob;
use crate::case::file_kind::FileKind;
use crate::case::{Case, ReadFile, kind};
use crate::run::job::Request;
use crate::system::at_rest::SystemAtRest;
use crate::system::motion::job;
use crate::system::solved::solve;
use crate::system::{SolvedSystem, SystemFile};

/// A kind of file of which studies compute variants.
pub trait Studied: FileKind + Clone {
    /// The run of a file with error bars, whether it asks for them or not.
    ///
    /// # Errors
    /// What is wrong with the file.
    fn with_errors(base: &BaseCase) -> Result<StudyJob, String>;

    /// The run of a file with some keys set.
    ///
    /// # Errors
    /// Why it refuses them.
    fn variant(base: &BaseCase, settings: &[Setting]) -> Result<StudyJob, String>;

    /// The run of what a file says, changed; `how` says in which way.
    ///
    /// # Errors
    /// Why it contradicts itself or, of a system, does not come to rest.
    fn of_content(self, base: &BaseCase, how: &str) -> Result<StudyJob, String>;
}

/// The text of a file with error bars.
fn asking_for_errors<K: FileKind>(base: &BaseCase) -> Result<String, String> {
    let text = kind::put::<K>(&base.text, "solver.error_estimate", "true");
    text.map_err(|all| reasons(&all))
}

impl Studied for Case {
    fn with_errors(base: &BaseCase) -> Result<StudyJob, String> {
        let text = asking_for_errors::<Self>(base)?;
        let request = base.request_of(text, base.overrides.clone());
        request.map(StudyJob::from)
    }

    fn variant(base: &BaseCase, settings: &[Setting]) -> Result<StudyJob, String> {
        base.request(settings).map(StudyJob::from)
    }

    fn of_content(self, base: &BaseCase, how: &str) -> Result<StudyJob, String> {
        let request = base.request_of(crate::case::write(&self), vec![how.to_owned()]);
        request.map(StudyJob::from)
    }
}

impl Studied for SystemFile {
    fn with_errors(base: &BaseCase) -> Result<StudyJob, String> {
        let own = read(base, &[])?;
        if own.content.as_run().is_none() {
            return Ok(at_rest(base, own.content, base.overrides.clone(), true));
        }
        let text = asking_for_errors::<Self>(base)?;
        let read = kind::read_variant(&text, &[], &base.files).map_err(|all| reasons(&all))?;
        of_read(base, read, base.overrides.clone())
    }

    fn variant(base: &BaseCase, settings: &[Setting]) -> Result<StudyJob, String> {
        let set = settings.iter().map(Setting::as_override);
        let overrides = base.overrides.iter().cloned().chain(set).collect();
        of_read(base, read(base, settings)?, overrides)
    }

    fn of_content(self, base: &BaseCase, how: &str) -> Result<StudyJob, String> {
        let how = vec![how.to_owned()];
        if self.as_run().is_none() {
            return Ok(at_rest(base, self, how, false));
        }
        let solved = solve(self).map_err(|why| why.problem)?;
        of_solved(base, solved, &base.text, how)
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
) -> Result<StudyJob, String> {
    if read.content.as_run().is_none() {
        return Ok(at_rest(base, read.content, overrides, false));
    }
    let text = read.text.clone();
    let solved = read.compute().map_err(|all| reasons(&all))?;
    of_solved(base, solved, &text, overrides)
}

/// A system at rest, with companions or without.
fn at_rest(
    base: &BaseCase,
    file: SystemFile,
    overrides: Vec<String>,
    has_companions: bool,
) -> StudyJob {
    StudyJob::from(Request {
        case: SystemAtRest::new(file).asking(None, has_companions),
        text: base.text.clone(),
        file: base.file(),
        overrides,
        id: String::new(),
    })
}

fn of_solved(
    base: &BaseCase,
    solved: SolvedSystem,
    text: &str,
    overrides: Vec<String>,
) -> Result<StudyJob, String> {
    let request = job::request(Arc::new(solved), text, base.file(), overrides);
    let request = request.ok_or_else(|| "it has no table [solver]".to_owned())?;
    Ok(request.into())
}
