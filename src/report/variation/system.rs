//! The variation of a system of lines.

use super::{PointView, ResultColumn, ResultView, VariationView};
use crate::number::{si, with_error};
use crate::study::vary::Variation;
use crate::study::vary::system::{SystemOutcome, SystemPoint, SystemResult};
use crate::system::quantities::unit;
use crate::system::stability::Stability;

/// Errors below this share of a value are rounding, which no table has digits for.
const ROUNDING: f64 = 1e-9;

impl<'a> VariationView<'a> {
    /// The variation of a system of lines; points that did not begin have no outcome.
    #[must_use]
    pub fn of_system(
        variation: &'a Variation,
        outcomes: &[Option<SystemOutcome>],
        results: &[String],
    ) -> Self {
        let columns = results.iter().map(|name| ResultColumn {
            name: name.clone(),
            unit: unit(name).to_owned(),
        });
        let view = |outcome: &Option<SystemOutcome>| match outcome {
            None => PointView::stopped(),
            Some(Err(why)) => PointView::without("REFUSED", why),
            Some(Ok(point)) => at_rest(point, results),
        };
        Self {
            variation,
            results: columns.collect(),
            outcomes: outcomes.iter().map(view).collect(),
            runs: false,
        }
    }
}

fn at_rest(point: &SystemPoint, names: &[String]) -> PointView {
    let found = point.results.iter().zip(names);
    let results: Vec<Option<ResultView>> = found
        .clone()
        .map(|(found, name)| Some(shown(found.as_ref().ok()?, unit(name))))
        .collect();
    let rests = match &point.stability {
        Stability::Stable => None,
        Stability::Neutral(most) => Some(format!("neutral in {most}")),
        Stability::Unstable(most) => Some(format!("unstable in {most}")),
    };
    let missing = found.filter_map(|(found, name)| Some((name, found.as_ref().err()?)));
    let missing: Vec<String> = missing
        .map(|(name, why)| format!("{name}: {why}"))
        .collect();
    PointView {
        results,
        reason: (!missing.is_empty()).then(|| ("INCOMPLETE", missing.join(" "))),
        remark: rests,
        ..PointView::default()
    }
}

fn shown(found: &SystemResult, unit: &str) -> ResultView {
    let SystemResult { value, error } = *found;
    let beyond_rounding = error.filter(|error| *error > ROUNDING * value.abs());
    ResultView {
        value,
        error,
        bar: beyond_rounding.map(|error| [value - error, value + error]),
        text: match beyond_rounding {
            Some(error) => with_error(value, Some(error), unit),
            None => si(value, unit),
        },
        unestimated: false,
    }
}
