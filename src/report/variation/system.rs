//! The variation of a system of lines.

use super::{OutcomeColumn, PointView, ResultView, VariationView};
use seacable_base::number::{si, with_error};
use seacable_model::case::StudyValue;
use seacable_studies::study::points::StudyPoint;
use seacable_studies::study::vary::Variation;
use seacable_studies::study::vary::system::{SystemOutcome, SystemPoint, SystemResult};
use seacable_systems::system::quantities::unit;
use seacable_systems::system::stability::Stability;

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
        let columns = results.iter().map(|name| OutcomeColumn {
            name: name.clone(),
            unit: unit(name).to_owned(),
        });
        let view = |(index, outcome): (usize, &Option<SystemOutcome>)| match outcome {
            None => PointView::stopped(),
            Some(Err(why)) => PointView::without("REFUSED", why),
            Some(Ok(found)) => at_rest(found, results, lost_line(&variation.points[index])),
        };
        Self {
            variation,
            results: columns.collect(),
            outcomes: outcomes.iter().enumerate().map(view).collect(),
            runs: false,
        }
    }
}

/// The line that is lost at a point.
fn lost_line(point: &StudyPoint) -> Option<&str> {
    let mut settings = point.settings.iter();
    let lost = settings.find(|setting| setting.key == "damage.lost_line")?;
    match &lost.value {
        StudyValue::Word(word) => Some(word),
        StudyValue::Number(_) => None,
    }
}

/// Whether a result is of this line or of one of its ends.
fn is_of(name: &str, line: &str) -> bool {
    let place = name.split_once('[').map_or("", |(_, place)| place);
    place.split(['|', ']']).next() == Some(line)
}

fn at_rest(point: &SystemPoint, names: &[String], lost: Option<&str>) -> PointView {
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
    // A line that is lost has no results, which is no fault.
    let missing = missing.filter(|(name, _)| !lost.is_some_and(|line| is_of(name, line)));
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
