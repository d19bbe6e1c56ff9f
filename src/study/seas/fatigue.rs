//! Fatigue of the lines over all seas by their probabilities.

use std::collections::BTreeMap;

use super::records::{RunRecord, Series};
use super::scene::CheckedScene;
use crate::case::{CheckInputs, Statistic};
use crate::checks::resolved::Check;
use crate::checks::utilisation::Estimate;
use crate::fatigue::component::Component;
use crate::fatigue::curve_file::read_curve;
use crate::fatigue::curve_library::published;
use crate::study::record_statistics::{ChannelRecord, fatigue};

/// Standard errors that count as the interval of a damage: 95 % of a normal law.
const NORMAL_95: f64 = 1.96;

/// Damage of one sea at a place, if it lasted all year \[1/year\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaDamage {
    /// The damage.
    pub per_year: f64,
    /// Its numerical error; nothing where the runs have none.
    pub numerical: Option<f64>,
    /// Its standard error by the scatter from run to run; nothing of fewer than three.
    pub sample: Option<f64>,
}

/// Damage at the places of a sea, or why there is none there.
pub(super) type SeaFatigue = BTreeMap<String, Result<SeaDamage, String>>;

/// The damage of a sea at every place with a tension that a check holds for.
#[must_use]
pub(super) fn of_sea(runs: &[RunRecord], check: &Check, scene: &CheckedScene) -> SeaFatigue {
    let Some(first) = runs.first() else {
        return SeaFatigue::new();
    };
    let places = first.places(Series::Tension);
    let held = places.filter(|place| check.holds_for(super::subject(place)));
    held.map(|place| (place.to_owned(), at(runs, place, check, scene)))
        .collect()
}

fn at(
    runs: &[RunRecord],
    place: &str,
    check: &Check,
    scene: &CheckedScene,
) -> Result<SeaDamage, String> {
    let component = component(check, place, scene)?;
    let records = runs
        .iter()
        .filter_map(|run| run.series(Series::Tension, place));
    let records: Vec<ChannelRecord> = records.collect();
    if records.iter().any(|record| record.values.len() < 2) || records.is_empty() {
        return Err("there is no record over time".to_owned());
    }
    let found = fatigue(&records, &component).map_err(|error| error.to_string())?;
    let error = |of: Statistic| {
        let errors = runs
            .iter()
            .filter_map(|run| run.numerical(Series::Tension, place, of));
        errors.reduce(f64::max)
    };
    // A range is off by at most the errors of both its ends.
    let range = error(Statistic::Max)
        .zip(error(Statistic::Min))
        .map(|(a, b)| a + b);
    let numerical = range.map(|range| match found.damage.sum > 0.0 {
        true => found.damage.error_of_ranges(range) * found.per_year / found.damage.sum,
        false => 0.0,
    });
    Ok(SeaDamage {
        per_year: found.per_year,
        numerical,
        sample: found.sample_error,
    })
}

/// The component of a check at a place: its curve with the diameter and the strength there.
pub(super) fn component(
    check: &Check,
    place: &str,
    scene: &CheckedScene,
) -> Result<Component, String> {
    if let Some(text) = &check.curve {
        return read_curve(text).map_err(|error| error.to_string());
    }
    let CheckInputs {
        curve,
        diameter_m,
        break_load_n,
        ..
    } = &check.inputs;
    let name = curve.as_deref().unwrap_or_default();
    let curve = published(name).ok_or_else(|| format!("there is no published curve `{name}`"))?;
    let diameter = diameter_m.or_else(|| scene.diameters.get(place).copied());
    let strength = break_load_n.or_else(|| scene.strengths.get(place).copied());
    let found = curve.component(diameter, strength);
    found.map_err(|error| error.to_string())
}

/// The damage of the years of service with all seas by their shares \[-\]: value and both errors. The numerical errors are added
/// as if all had the same sign; those of the samples are independent.
#[must_use]
pub fn of_service(parts: &[(f64, SeaDamage)], years: f64) -> Estimate {
    let sum = |of: &dyn Fn(&SeaDamage) -> f64| -> f64 {
        parts
            .iter()
            .map(|(share, sea)| share * of(sea))
            .sum::<f64>()
            * years
    };
    let all = |of: fn(&SeaDamage) -> Option<f64>| parts.iter().all(|(_, sea)| of(sea).is_some());
    let value = sum(&|sea| sea.per_year);
    let squares = parts
        .iter()
        .map(|(share, sea)| (share * sea.sample.unwrap_or(0.0)).powi(2));
    let spread = NORMAL_95 * squares.sum::<f64>().sqrt() * years;
    let known = all(|sea| sea.sample);
    Estimate {
        value,
        numerical: all(|sea| sea.numerical).then(|| sum(&|sea| sea.numerical.unwrap_or(0.0))),
        // Of a single record nobody knows what the next one would do.
        sample: Some(match known {
            true => [(value - spread).max(0.0), value + spread],
            false => [0.0, f64::INFINITY],
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seas_add_up_by_their_shares_with_both_errors_apart() {
        let sea = |per_year, numerical, sample| SeaDamage {
            per_year,
            numerical,
            sample,
        };
        let parts = [
            (0.75, sea(0.01, Some(0.001), Some(0.002))),
            (0.25, sea(0.04, Some(0.002), Some(0.004))),
        ];
        let found = of_service(&parts, 20.0);
        assert!((found.value - 0.35).abs() < 1e-12);
        assert!((found.numerical.unwrap() - 20.0 * 0.00125).abs() < 1e-12);
        let spread = 1.96 * 20.0 * (0.0015_f64.powi(2) + 0.001_f64.powi(2)).sqrt();
        let [low, high] = found.sample.unwrap();
        assert!((high - 0.35 - spread).abs() < 1e-12 && (0.35 - spread - low).abs() < 1e-12);
        let one = of_service(&[(1.0, sea(0.01, None, None))], 1.0);
        assert_eq!(one.numerical, None);
        assert_eq!(one.sample, Some([0.0, f64::INFINITY]));
    }
}
