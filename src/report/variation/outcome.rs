//! What became of the points of a variation, whatever kind of file was varied.

use super::VariationView;
use crate::comparison::result_text;
use seacable_base::visible;
use seacable_model::case::QuantityId;
use seacable_runs::run::Quantity;
use seacable_studies::comparison::error_bar;
use seacable_studies::study::points::{PointOutcome, PointRun};
use seacable_studies::study::vary::Variation;

/// A result that is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct OutcomeColumn {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
}

/// A result at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct ResultView {
    /// Its value.
    pub value: f64,
    /// Its numerical error, where it is known.
    pub error: Option<f64>,
    /// The range in which it lies.
    pub bar: Option<[f64; 2]>,
    /// With unit and error, in words.
    pub text: String,
    /// Whether an error could have been estimated and was not.
    pub unestimated: bool,
}

/// What became of a point.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PointView {
    /// The results, in the order of their columns.
    pub results: Vec<Option<ResultView>>,
    /// Why there are none, in a word and in full; nothing where there are.
    pub reason: Option<(&'static str, String)>,
    /// What is to be said of it nevertheless.
    pub remark: Option<String>,
    /// What it cost \\[s\\].
    pub cpu_s: Option<f64>,
    /// Where its run is stored.
    pub dir: Option<String>,
    /// Whether it was not computed since nothing needs it.
    pub unneeded: bool,
}

impl PointView {
    /// A point without results, and why.
    pub(super) fn without(state: &'static str, why: &str) -> Self {
        Self {
            reason: Some((state, why.to_owned())),
            ..Self::default()
        }
    }

    /// A point that was stopped before it began.
    pub(super) fn stopped() -> Self {
        Self::without("STOPPED", "it was stopped before it began")
    }

    pub(super) fn result(&self, place: usize) -> Option<&ResultView> {
        self.results.get(place)?.as_ref()
    }

    pub(super) fn state(&self) -> &'static str {
        let good = if self.unneeded { "NOT NEEDED" } else { "OK" };
        self.reason.as_ref().map_or(good, |(state, _)| state)
    }

    fn of_case(outcome: Option<&PointOutcome>, results: &[QuantityId]) -> Self {
        match outcome {
            None => Self::stopped(),
            Some(Err(why)) => Self::without("REFUSED", why),
            Some(Ok(run)) => Self::of_run(run, results),
        }
    }

    fn of_run(run: &PointRun, results: &[QuantityId]) -> Self {
        let warnings = run.info.warnings.len();
        let plural = if warnings == 1 { "" } else { "s" };
        Self {
            results: results
                .iter()
                .map(|id| run.result(id).map(ResultView::of_quantity))
                .collect(),
            reason: run.failure().map(|why| ("FAILED", why.to_owned())),
            remark: (warnings > 0).then(|| format!("{warnings} warning{plural}")),
            cpu_s: Some(run.info.cost.cpu_s),
            dir: run.dir.as_ref().map(|dir| visible::path(dir)),
            unneeded: false,
        }
    }
}

impl ResultView {
    fn of_quantity(quantity: &Quantity) -> Self {
        Self {
            value: quantity.value,
            error: quantity.error_estimate(),
            bar: error_bar(quantity),
            text: result_text(quantity),
            unestimated: quantity.error_estimate().is_none(),
        }
    }
}

impl VariationView<'_> {
    /// The same where points without an outcome were not needed: a sea was settled before.
    #[must_use]
    pub fn with_unneeded(mut self, outcomes: &[Option<PointOutcome>]) -> Self {
        for (view, outcome) in self.outcomes.iter_mut().zip(outcomes) {
            if outcome.is_none() {
                *view = PointView {
                    unneeded: true,
                    ..PointView::default()
                };
            }
        }
        self
    }
}

impl<'a> VariationView<'a> {
    /// The variation of a line case; points that did not begin have no outcome.
    #[must_use]
    pub fn of_case(
        variation: &'a Variation,
        outcomes: &[Option<PointOutcome>],
        results: &[QuantityId],
    ) -> Self {
        let columns = results.iter().map(|id| OutcomeColumn {
            name: id.to_string(),
            unit: id.unit(),
        });
        let view = |index| {
            let outcome: Option<&Option<PointOutcome>> = outcomes.get(index);
            PointView::of_case(outcome.and_then(Option::as_ref), results)
        };
        Self {
            variation,
            results: columns.collect(),
            outcomes: (0..variation.points.len()).map(view).collect(),
            runs: true,
        }
    }
}
