//! What is needed: every effect of a scene left out in turn, what that changes in the results, and what it saves.

mod effect;
mod of_line;
mod of_material;
mod of_system;

pub use effect::{EffectName, HasEffects, ScenePart};

use std::sync::atomic::AtomicBool;

use super::base_run::BaseRun;
use super::points::{self, BaseCase, PointOutcome, PointProgress, PointRun};
use super::study_job::StudyJob;
use crate::case::QuantityId;
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
    /// Effects that cannot be left out, and why.
    pub kept: &'static [(&'static str, &'static str)],
}

/// A case without one of its effects.
#[derive(Debug, Clone)]
pub struct PhysicsVariant {
    /// What was left out.
    pub part: EffectName,
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
pub fn compute<K: HasEffects>(
    base: &BaseCase,
    cancel: &AtomicBool,
    progress: &(dyn Fn(PointProgress<'_>) + Sync),
) -> Result<PhysicsStudy, String> {
    let base = BaseRun::compute::<K>(base, cancel)?;
    let own = base.content::<K>()?;
    let (mut present, mut absent) = (Vec::new(), Vec::new());
    for part in K::parts() {
        let mut scene = own.clone();
        (part.leave_out)(&mut scene);
        if scene == own {
            absent.push(part.effect.name);
        } else {
            present.push((part.effect, scene));
        }
    }
    let (parts, scenes): (Vec<EffectName>, Vec<K>) = present.into_iter().unzip();
    let jobs = parts.iter().zip(scenes).map(|(part, mut scene)| {
        scene.forget_what_it_says_of_itself();
        scene.of_content(&base.base, part.name)
    });
    let jobs: Vec<Result<StudyJob, String>> = jobs.collect();
    let outcomes = points::compute(jobs, cancel, progress);
    let variants = parts.into_iter().zip(outcomes);
    let variants = variants.map(|(part, outcome)| PhysicsVariant { part, outcome });
    Ok(PhysicsStudy {
        variants: variants.collect(),
        base,
        absent,
        kept: K::KEPT,
    })
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
