//! What matters: every numeric input of a case varied alone by its tolerance, and how far that moves a result.

mod input;
mod values;

pub use input::{InputTolerance, SkippedInput, USUAL_TOLERANCE, VariedInput, varied_inputs};

use std::sync::atomic::AtomicBool;

use super::base_run::BaseRun;
use super::points::{self, BaseCase, PointOutcome, PointProgress};
use super::studied::Studied;
use crate::case::QuantityId;
use crate::comparison::is_beyond_error;
use crate::run::Quantity;

/// The effects of all inputs of a case.
#[derive(Debug, Clone)]
pub struct InputEffects {
    /// The case itself, with error bars.
    pub base: BaseRun,
    /// The inputs that were varied.
    pub inputs: Vec<VariedInput>,
    /// The inputs that were not, and why.
    pub skipped: Vec<SkippedInput>,
    /// What became of each input at its lower and its upper value; absent where it was stopped before.
    pub outcomes: Vec<[Option<PointOutcome>; 2]>,
}

/// Computes the case with error bars, and without at both values of every input, side by side on the threads of the caller's pool.
/// `progress` is called after each of the variants.
///
/// # Errors
/// The case itself could not be computed, and why.
pub fn compute<K: Studied>(
    base: &BaseCase,
    cancel: &AtomicBool,
    progress: &(dyn Fn(PointProgress<'_>) + Sync),
) -> Result<InputEffects, String> {
    let base = BaseRun::compute::<K>(base, cancel)?;
    let (inputs, skipped) = varied_inputs::<K>(&base.base.text);
    let settings = inputs.iter().flat_map(VariedInput::settings);
    let requests = settings.map(|setting| K::variant(&base.base, &[setting]));
    let computed = points::compute(requests.collect(), cancel, progress);
    let mut computed = computed.into_iter();
    let outcomes = inputs
        .iter()
        .map(|_| [computed.next().flatten(), computed.next().flatten()]);
    Ok(InputEffects {
        outcomes: outcomes.collect(),
        base,
        inputs,
        skipped,
    })
}

/// The effect of an input on a result.
#[derive(Debug, Clone)]
pub struct InputEffect<'a> {
    /// The input.
    pub input: &'a VariedInput,
    /// The result at the lower and the upper value of the input, or why there is none.
    pub results: [Result<f64, String>; 2],
    /// These less the result of the case itself; absent where there is none.
    pub changes: [Option<f64>; 2],
    /// Whether one of the results lies outside of the error bar of the case itself; absent where that has none or is not settled.
    pub beyond_error: Option<bool>,
}

impl InputEffect<'_> {
    /// The greater of both changes in size; zero where there is none.
    #[must_use]
    pub fn size(&self) -> f64 {
        let sizes = self.changes.iter().flatten().map(|change| change.abs());
        sizes.fold(0.0, f64::max)
    }
}

/// Share of a result below which a change is none: two computations of the same round differently.
const NOTHING: f64 = 1e-12;

impl InputEffects {
    /// A result of the case itself.
    #[must_use]
    pub fn result(&self, id: &QuantityId) -> Option<&Quantity> {
        self.base.run.result(id)
    }

    /// The effects on a result, the greatest first; inputs without any result last. Nothing where the case has no such result.
    #[must_use]
    pub fn ranked(&self, id: &QuantityId) -> Option<Vec<InputEffect<'_>>> {
        let quantity = self.result(id)?;
        let base = quantity.value;
        let change = |value: &f64| {
            let change = value - base;
            if change.abs() <= NOTHING * base.abs() {
                0.0
            } else {
                change
            }
        };
        let effects = self
            .inputs
            .iter()
            .zip(&self.outcomes)
            .map(|(input, outcomes)| {
                let results = outcomes
                    .each_ref()
                    .map(|outcome| found(outcome.as_ref(), id));
                let found = results.iter().flatten();
                let beyond: Vec<_> = found
                    .map(|value| is_beyond_error(quantity, *value))
                    .collect();
                let known = !beyond.is_empty() && beyond.iter().all(Option::is_some);
                InputEffect {
                    input,
                    changes: results
                        .each_ref()
                        .map(|result| result.as_ref().ok().map(change)),
                    beyond_error: known.then(|| beyond.contains(&Some(true))),
                    results,
                }
            });
        let mut effects: Vec<InputEffect<'_>> = effects.collect();
        let known = |effect: &InputEffect<'_>| effect.changes.iter().any(Option::is_some);
        effects.sort_by(|a, b| known(b).cmp(&known(a)).then(b.size().total_cmp(&a.size())));
        Some(effects)
    }

    /// CPU time of all variants together \[s\].
    #[must_use]
    pub fn cpu_s(&self) -> f64 {
        let runs = self.outcomes.iter().flatten().flatten().flatten();
        runs.map(|run| run.info.cost.cpu_s).sum()
    }
}

/// The result of a point, or why there is none.
fn found(outcome: Option<&PointOutcome>, id: &QuantityId) -> Result<f64, String> {
    let run = match outcome {
        None => return Err("stopped before it began".to_owned()),
        Some(Err(why)) => return Err(why.clone()),
        Some(Ok(run)) => run,
    };
    if let Some(why) = run.failure() {
        return Err(why.to_owned());
    }
    let value = run
        .result(id)
        .map(|quantity| quantity.value)
        .filter(|value| value.is_finite());
    value.ok_or_else(|| "its run does not have the result".to_owned())
}
