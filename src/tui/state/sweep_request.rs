//! A sweep that is asked for on the screen, and what the threads behind it say of sweeps.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::JobNumber;
use super::sweep_verdict::SweepVerdict;
use super::sweeps::SweepRead;
use crate::case::kind;
use crate::kinds::FileType;
use crate::study::sweep::{
    PlanChoices, PlanError, SweepEntry, SweepPlan, SweepProgress, SweepSnapshot,
};
use crate::system::SystemFile;

/// The load cases of an edited text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepRequest {
    /// Its kind.
    pub kind: FileType,
    /// The text.
    pub text: String,
    /// Where its file stands.
    pub path: PathBuf,
    /// Keys in which the text differs from the file, as `key=value`.
    pub overrides: Vec<String>,
}

impl SweepRequest {
    /// What is computed. For the threads behind the screen.
    ///
    /// # Errors
    /// Why nothing can be, in words.
    pub fn plan(&self) -> Result<SweepPlan, String> {
        let path = self.path.display().to_string();
        let choices = PlanChoices::default();
        let plan = match self.kind {
            FileType::System => {
                let folder = self.path.parent().unwrap_or(Path::new(""));
                let solved = kind::parse_beside::<SystemFile>(&self.text, &path, folder);
                let text = kind::whole_text::<SystemFile>(&self.text, &path);
                match (solved, text) {
                    (Ok(solved), Ok(text)) => {
                        SweepPlan::of_system((&text, &solved), &path, &self.overrides, choices)
                    }
                    (Err(faults), _) | (_, Err(faults)) => Err(PlanError::Invalid(faults)),
                }
            }
            _ => SweepPlan::of_line(&self.text, &path, &self.overrides, choices),
        };
        let plan = plan.map_err(|error| error.to_string())?;
        match plan.sweep.variation.keys.is_empty() {
            true => Err("There are no load cases: add [[load_cases]] to the file.".to_owned()),
            false => Ok(plan),
        }
    }
}

impl SweepRequest {
    /// Whether a sweep is of exactly these load cases, inputs and results. For the threads behind the screen.
    #[must_use]
    pub fn is_of(&self, snapshot: &SweepSnapshot) -> bool {
        let known = &snapshot.plan.sweep;
        self.plan().is_ok_and(|SweepPlan { sweep: own, .. }| {
            own.variation.base.text == known.variation.base.text
                && own.variation.points == known.variation.points
                && own.results == known.results
        })
    }
}

/// What the screen asks of sweeps.
#[derive(Debug, Clone)]
pub enum SweepEffect {
    /// List the stored sweeps of a case file.
    List(String),
    /// Read a sweep, or what is new in one that is known.
    Read {
        /// Its folder.
        dir: PathBuf,
        /// What is known of it.
        known: Option<Arc<SweepSnapshot>>,
    },
    /// Work out what its load cases say together.
    Check(Arc<SweepSnapshot>),
    /// Whether a sweep is of these load cases and inputs.
    Compare(Arc<SweepSnapshot>, Box<SweepRequest>),
    /// Compute load cases, as the job of this number: go on where a stored sweep is of exactly these.
    Start(JobNumber, Box<SweepRequest>),
}

/// What is said of sweeps.
#[derive(Debug, Clone)]
pub enum SweepMsg {
    /// The stored sweeps of a case file.
    Listed(String, Vec<SweepEntry>),
    /// A sweep as read, or why it cannot be.
    Read(PathBuf, Result<SweepRead, String>),
    /// What the load cases of the sweep in this folder say together.
    Checked(PathBuf, Arc<SweepVerdict>),
    /// Whether the sweep in this folder is of the load cases and inputs of this text.
    Compared(PathBuf, String, bool),
    /// A job computes the sweep in this folder.
    Begun(JobNumber, PathBuf),
    /// How far it is, after so many seconds.
    Progress(JobNumber, SweepProgress, f64),
    /// It has ended: the sweep as it is then, and whether it was cancelled; or why it failed.
    Ended(JobNumber, Result<(SweepRead, bool), String>),
}
