//! The run of a file that variants are held against, and what these are made of.

use std::sync::atomic::AtomicBool;

use super::points::{BaseCase, PointRun, reasons};
use super::studied::Studied;
use super::study_job::StudyJob;
use crate::case::{edit, kind};
use crate::run::Run;

/// The run of a case or of a system, with error bars, and the file as its variants are computed: by the same method on the same mesh,
/// without companion runs, since the error of a variant is about that of the case itself.
#[derive(Debug, Clone)]
pub struct BaseRun {
    /// The run.
    pub run: PointRun,
    /// The file that variants are made of.
    pub base: BaseCase,
}

impl BaseRun {
    /// Computes the file with error bars, whether it asks for them or not.
    ///
    /// # Errors
    /// The run did not come to its end, and why.
    pub fn compute<K: Studied>(base: &BaseCase, cancel: &AtomicBool) -> Result<Self, String> {
        let job = K::with_errors(base)?;
        let run = job.execute(cancel);
        let text = match job {
            StudyJob::Run(_) => of_variants::<K>(&run)?,
            // It has neither method nor steps.
            StudyJob::AtRest(_) => base.text.clone(),
        };
        let run = PointRun {
            info: run.info,
            summary: run.summary,
            dir: None,
        };
        match run.failure() {
            Some(why) => Err(format!("the case itself: {why}")),
            None => Ok(Self {
                base: BaseCase {
                    text,
                    ..base.clone()
                },
                run,
            }),
        }
    }

    /// What the file of the variants says.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn content<K: Studied>(&self) -> Result<K, String> {
        let read = kind::read_variant::<K>(&self.base.text, &[], &self.base.files);
        read.map(|read| read.content).map_err(|all| reasons(&all))
    }
}

/// The text of the variants: the mesh and the steps that a search has found, the method that was chosen, no companion runs.
fn of_variants<K: Studied>(run: &Run) -> Result<String, String> {
    let mut text = run.case_text.clone();
    for key in ["solver.accuracy", "solver.budget_s"] {
        text = edit::cut(&text, key).unwrap_or(text);
    }
    let put = |text: &str, key: &str, value: &str| {
        kind::put::<K>(text, key, value).map_err(|all| reasons(&all))
    };
    if run.info.settings.method_reason.is_some() {
        text = put(&text, "solver.method", &run.info.settings.method)?;
    }
    put(&text, "solver.error_estimate", "false")
}
