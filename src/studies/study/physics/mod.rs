//! What is needed: every effect of a scene left out in turn, what that changes in the results, and what it saves.

mod effect;

pub use effect::{KEPT, SCENE_PARTS, ScenePart};

use std::sync::atomic::AtomicBool;

use super::base_run::BaseRun;
use super::points::{self, BaseCase, PointOutcome, PointProgress, PointRequest, PointRun};
use crate::case::{Case, QuantityId, StudyPoint, Subject, channels, kind, write};
use crate::comparison::is_beyond_error;
use crate::run::Quantity;

/// A case without each of its effects.
#[derive(Debug, Clone)]
pub struct PhysicsStudy {
    /// The case itself, with error bars.
    pub base: BaseRun,
    /// What was left out, or changed, in turn.
    pub variants: Vec<PhysicsVariant>,
    /// Effects that the case does not have.
    pub absent: Vec<&'static str>,
}

/// A case without one of its effects.
#[derive(Debug, Clone)]
pub struct PhysicsVariant {
    /// What was left out.
    pub part: ScenePart,
    /// What became of it; absent where it was stopped before.
    pub outcome: Option<PointOutcome>,
}

/// A result without an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Omission {
    /// The result less that of the case itself.
    pub change: f64,
    /// The same by the size of the result of the case itself; absent where that is zero.
    pub relative: Option<f64>,
    /// Whether it is more than the error of the result of the case itself; absent where that is not estimated or not settled.
    pub matters: Option<bool>,
}

/// Computes the case with error bars, and without each of its effects, side by side on the threads of the caller's pool.
///
/// # Errors
/// The case itself could not be computed, and why.
pub fn compute(
    base: &BaseCase,
    cancel: &AtomicBool,
    progress: &(dyn Fn(PointProgress<'_>) + Sync),
) -> Result<PhysicsStudy, String> {
    let base = BaseRun::compute(base, cancel)?;
    let (mut present, mut absent) = (Vec::new(), Vec::new());
    for part in SCENE_PARTS {
        let mut case = base.case.clone();
        (part.leave_out)(&mut case);
        if case == base.case {
            absent.push(part.name);
        } else {
            present.push((part, case));
        }
    }
    let requests = present
        .iter()
        .map(|(part, case)| request(&base, part, case));
    let outcomes = points::compute(requests.collect(), cancel, progress);
    let variants = present.into_iter().zip(outcomes);
    let variants = variants.map(|((part, _), outcome)| PhysicsVariant { part, outcome });
    Ok(PhysicsStudy {
        variants: variants.collect(),
        base,
        absent,
    })
}

/// The case without an effect, without what it says about itself that may not hold any more.
fn request(base: &BaseRun, part: &ScenePart, case: &Case) -> PointRequest {
    let mut case = case.clone();
    case.marks.clear();
    case.trial.clear();
    for curve in &mut case.published_curve {
        curve.points_file = None;
    }
    // Channels that the case does not have any more have no published values.
    let channels = channels(&case);
    let is_there = |subject: &Subject| match subject {
        Subject::Channel(id) => channels.iter().any(|channel| channel.id == *id),
        _ => true,
    };
    case.published.retain(|row| is_there(&row.channel));
    case.trend.retain(|row| is_there(&row.channel));
    case.published_curve
        .retain(|row| channels.iter().any(|channel| channel.id == row.channel));
    without_idle_studies(&mut case);
    base.base
        .request_of(write(&case), vec![part.name.to_owned()])
}

/// Leaves out the studies of keys that went with the effect, and what is published at their points.
fn without_idle_studies(case: &mut Case) {
    if case.study.is_empty() {
        return;
    }
    let rows = kind::rows::<Case>(&write(case));
    let has = |key: &str| {
        rows.iter()
            .any(|row| row.path == key && !row.value.is_empty())
    };
    case.study.retain(|study| has(&study.key));
    let known = |at: &Option<StudyPoint>| {
        let mut studies = case.study.iter();
        at.as_ref()
            .is_none_or(|at| studies.any(|study| study.name == at.study))
    };
    case.published
        .retain(|row| known(&row.at) && known(&row.change_from) && known(&row.ratio_to));
    case.published_curve.retain(|row| known(&row.at));
    case.trend
        .retain(|row| case.study.iter().any(|study| study.name == row.study));
}

impl PhysicsVariant {
    /// The run, if it came to its end.
    ///
    /// # Errors
    /// Why there is none.
    pub fn run(&self) -> Result<&PointRun, String> {
        match &self.outcome {
            None => Err("it was stopped before it began".to_owned()),
            Some(Err(why)) => Err(why.clone()),
            Some(Ok(run)) => match run.failure() {
                Some(why) => Err(why.to_owned()),
                None => Ok(run),
            },
        }
    }
}

impl PhysicsStudy {
    /// What leaving an effect out does to a result; none where either run does not have it.
    #[must_use]
    pub fn omission(&self, variant: &PhysicsVariant, id: &QuantityId) -> Option<Omission> {
        let base = self.base.run.result(id)?;
        let value = variant.run().ok()?.result(id)?.value;
        Some(omission(base, value))
    }

    /// How many results change by more than their error, and of how many that is known.
    #[must_use]
    pub fn changed(&self, variant: &PhysicsVariant) -> (usize, usize) {
        let run = variant.run().ok();
        let omissions = self
            .base
            .run
            .summary
            .iter()
            .filter_map(|base| omission(base, run?.result(&base.id)?.value).matters);
        let known: Vec<bool> = omissions.collect();
        (
            known.iter().filter(|matters| **matters).count(),
            known.len(),
        )
    }
}

fn omission(base: &Quantity, value: f64) -> Omission {
    let change = value - base.value;
    Omission {
        change,
        relative: (base.value != 0.0).then(|| change / base.value.abs()),
        matters: is_beyond_error(base, value),
    }
}
