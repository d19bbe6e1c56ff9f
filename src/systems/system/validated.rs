//! A system computed at the points of its studies that its published values need.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::SystemFile;
use super::motion::run::{MotionRun, run};
use super::rest::UnsolvedSystem;
use super::results_in_time::has_published_in_time;
use super::solved::SolvedSystem;
use super::validation::{ComputedSystem, rows_along_studies, stated};
use crate::case::{Diagnostic, StudyPoint, kind};
use crate::published::ValidationRow;
use crate::reference::variant;

/// A system computed at a point of a study, `None` being the file without one.
struct ComputedPoint {
    at: Option<StudyPoint>,
    solved: SolvedSystem,
    run: Option<MotionRun>,
}

/// Why a system has no rows.
#[derive(Debug)]
pub enum NotValidated {
    /// A point that its file does not take.
    Invalid(Vec<Diagnostic>),
    /// No run in time.
    Unsolved(Box<UnsolvedSystem>),
}

/// The rows of a system whose text is that of a file of this name, computed at every point of its studies that its published values
/// need, each in time where it has values of its run in time.
///
/// # Errors
/// A point that the file does not take, or divided lines that do not come to rest.
pub fn validated(
    solved: SolvedSystem,
    text: &str,
    file: &str,
    cancel: &AtomicBool,
) -> Result<Vec<ValidationRow>, NotValidated> {
    let content = solved.file.clone();
    let stated = stated(&content);
    let points: Vec<StudyPoint> = stated.plan().into_iter().flatten().collect();
    let others = points.into_par_iter().map(|at| {
        let variant = variant::<SystemFile>(text, file, stated.studies, &at);
        let text = variant.map_err(NotValidated::Invalid)?.text;
        let solved = kind::parse::<SystemFile>(&text, file).map_err(NotValidated::Invalid)?;
        computed(Some(at), solved, cancel)
    });
    let mut all: Vec<ComputedPoint> = others.collect::<Result<_, NotValidated>>()?;
    all.push(computed(None, solved, cancel)?);
    Ok(rows_along_studies(&content, &|at| {
        let mut points = all.iter();
        let point = points.find(|point| point.at.as_ref() == at)?;
        Some(ComputedSystem::new(&point.solved, point.run.as_ref()))
    }))
}

fn computed(
    at: Option<StudyPoint>,
    solved: SolvedSystem,
    cancel: &AtomicBool,
) -> Result<ComputedPoint, NotValidated> {
    let given = solved.file.as_run();
    let given = given.filter(|_| has_published_in_time(&solved.file));
    let run = given.map(|given| run(&solved, given, cancel, &mut |_| {}));
    let run = run.transpose();
    let run = run.map_err(|why| NotValidated::Unsolved(Box::new(why)))?;
    Ok(ComputedPoint { at, solved, run })
}
