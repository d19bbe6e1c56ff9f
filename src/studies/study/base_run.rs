//! The run of a case that variants are held against, and what these are made of.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::points::{BaseCase, PointRun};
use crate::case::{self, Case, Method, edit};
use crate::run::{Run, job};

/// The run of a case, with error bars, and the case as its variants are computed: by the same method on the same mesh, without companion
/// runs, since the error of a variant is about that of the case itself.
#[derive(Debug, Clone)]
pub struct BaseRun {
    /// The run.
    pub run: PointRun,
    /// The case that variants are made of.
    pub base: BaseCase,
    /// The same as it is read.
    pub case: Case,
}

impl BaseRun {
    /// Computes the case with error bars, whether it asks for them or not.
    ///
    /// # Errors
    /// The run did not come to its end, and why.
    pub fn compute(base: &BaseCase, cancel: &AtomicBool) -> Result<Self, String> {
        let text = edit::set(&base.text, "solver.error_estimate", "true");
        let text = text.map_err(|fault| fault.problem)?;
        let request = base.request_of(text, base.overrides.clone())?;
        let run = job::execute(&request, cancel, &mut |_| {});
        let text = of_variants(&run, &request.case)?;
        let case = case::parse(&text, &base.path).map_err(|faults| {
            let problems = faults.iter().map(|fault| fault.problem.clone());
            problems.collect::<Vec<_>>().join("; ")
        })?;
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
                case,
            }),
        }
    }

    /// The file name of the case.
    #[must_use]
    pub fn file(&self) -> String {
        let name = Path::new(&self.base.path).file_name();
        name.map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    }
}

/// The text of the variants: the mesh and the steps that a search has found, the method that was chosen, no companion runs.
fn of_variants(run: &Run, case: &Case) -> Result<String, String> {
    let mut text = run.case_text.clone();
    for key in ["solver.accuracy", "solver.budget_s"] {
        if edit::get(&text, key).is_some() {
            text = edit::unset(&text, key).map_err(|fault| fault.problem)?;
        }
    }
    let mut edits = vec![("solver.error_estimate", "false")];
    if case.solver.method == Method::Auto {
        edits.push(("solver.method", run.info.settings.method.as_str()));
    }
    edit::set_all(&text, &edits).map_err(|faults| {
        let problems = faults.into_iter().map(|fault| fault.problem);
        problems.collect::<Vec<_>>().join("; ")
    })
}
