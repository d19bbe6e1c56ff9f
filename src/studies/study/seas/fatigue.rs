//! Fatigue of the lines over all seas by their probabilities.

use std::collections::BTreeMap;

use super::records::{RecordedSeries, SeaRunRecord};
use super::scene::CheckedScene;
use crate::case::Statistic;
use crate::checks::resolved::Check;
use crate::checks::utilisation::Estimate;
use crate::fatigue::damage::YEAR;
use crate::number::digits;
use crate::run::along::FatigueSpot;
use crate::study::record_statistics::{ChannelRecord, fatigue, scatter};

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

/// A place at which damage is summed. Places along a line come in their order.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct FatiguePlace {
    order: usize,
    /// The place along the line, which all units of its cross-section share.
    pub(super) along: String,
    /// Its whole name.
    pub(super) name: String,
}

impl FatiguePlace {
    /// A place whose tension is recorded.
    pub(super) fn recorded(place: &str) -> Self {
        Self {
            order: 0,
            along: place.to_owned(),
            name: place.to_owned(),
        }
    }
}

/// Damage at the places of a sea, or why there is none there.
pub(super) type SeaFatigue = BTreeMap<FatiguePlace, Result<SeaDamage, String>>;

/// The damage of a sea at every place that a check holds for: those with a recorded tension, or all that the runs counted along the lines.
#[must_use]
pub(super) fn of_sea(runs: &[SeaRunRecord], check: &Check, scene: &CheckedScene) -> SeaFatigue {
    let Some(first) = runs.first() else {
        return SeaFatigue::new();
    };
    if check.is_along() {
        return along(runs, check);
    }
    let places = first.places(RecordedSeries::Tension);
    let held = places.filter(|place| check.holds_for(super::subject::subject(place)));
    held.map(|place| (FatiguePlace::recorded(place), at(runs, place, check, scene)))
        .collect()
}

/// The damage that the runs of a sea counted along the lines.
fn along(runs: &[SeaRunRecord], check: &Check) -> SeaFatigue {
    let of_check = |run: &SeaRunRecord| -> Vec<FatigueSpot> {
        let own = run.along.iter().filter(|spot| spot.check == check.name);
        own.cloned().collect()
    };
    let each: Vec<Vec<FatigueSpot>> = runs.iter().map(of_check).collect();
    let Some(first) = each.first() else {
        return SeaFatigue::new();
    };
    let mut errors = BTreeMap::new();
    let spots = first.iter().enumerate().map(|(order, spot)| {
        let line = errors
            .entry(spot.line.clone())
            .or_insert_with(|| LineErrors::of_runs(runs, &spot.line));
        let same: Vec<&FatigueSpot> = each
            .iter()
            .filter_map(|own| own.get(order).filter(|other| is_same(spot, other)))
            .collect();
        let place = place_along(spot, order);
        let damage = match same.len() == runs.len() {
            true => Ok(pooled(&same, line)),
            false => Err(format!("{} is not counted in all runs", place.name)),
        };
        (place, damage)
    });
    spots.collect()
}

fn is_same(one: &FatigueSpot, other: &FatigueSpot) -> bool {
    let of = |spot: &FatigueSpot| (spot.arc_m.to_bits(), spot.angle_deg.to_bits());
    of(one) == of(other) && (&one.line, &one.unit) == (&other.line, &other.unit)
}

fn place_along(spot: &FatigueSpot, order: usize) -> FatiguePlace {
    let along = format!("{}|{} m", spot.line, digits(spot.arc_m, 6));
    let name = match spot.unit.is_empty() {
        true => along.clone(),
        false => format!("{along}|{}|{} deg", spot.unit, spot.angle_deg),
    };
    FatiguePlace { order, along, name }
}

/// The damage of a place in all runs together.
fn pooled(same: &[&FatigueSpot], errors: &LineErrors) -> SeaDamage {
    let sum = |of: &dyn Fn(&FatigueSpot) -> f64| -> f64 { same.iter().map(|spot| of(spot)).sum() };
    let years = sum(&|spot| spot.duration_s) / YEAR;
    let yearly: Vec<f64> = same
        .iter()
        .map(|spot| spot.damage / spot.duration_s * YEAR)
        .collect();
    let range = same.first().and_then(|spot| errors.of_range(spot));
    SeaDamage {
        per_year: sum(&|spot| spot.damage) / years,
        numerical: range.map(|range| sum(&|spot| spot.damage_by_range) * range / years),
        sample: scatter(&yearly),
    }
}

/// The greatest numerical errors of the runs of a sea on a line, which count for all its places: those between are not estimated.
struct LineErrors {
    /// Of a range of tension at the places where it is recorded \[N\].
    range: Option<f64>,
    /// Of the sharpest curvature \[1/m\].
    curvature: Option<f64>,
}

impl LineErrors {
    fn of_runs(runs: &[SeaRunRecord], line: &str) -> Self {
        let greatest = |of: &dyn Fn(&SeaRunRecord) -> Option<f64>| {
            let all: Option<Vec<f64>> = runs.iter().map(of).collect();
            all?.into_iter().reduce(f64::max)
        };
        let range = greatest(&|run| {
            let all: Vec<&str> = run.places(RecordedSeries::Tension).collect();
            let own = all
                .iter()
                .filter(|place| super::subject::subject(place) == line);
            let own: Vec<&str> = own.copied().collect();
            let places = if own.is_empty() { all } else { own };
            let of = |place: &str, of| run.numerical(RecordedSeries::Tension, place, of);
            let ranges = places.iter().map(|place| {
                let [low, high] = [Statistic::Min, Statistic::Max].map(|end| of(place, end));
                Some(low? + high?)
            });
            ranges
                .collect::<Option<Vec<f64>>>()?
                .into_iter()
                .reduce(f64::max)
        });
        let curvature = greatest(&|run| {
            // A line by itself has the radius of all its sections.
            let of_line = run.least_bend_radius(line);
            let (radius, error) = of_line.or_else(|| run.least_bend_radius(""))?;
            Some(error? / (radius * radius))
        });
        Self { range, curvature }
    }

    /// The error of a range of a place: of both its ends.
    fn of_range(&self, spot: &FatigueSpot) -> Option<f64> {
        let tension = spot.by_tension.abs() * self.range?;
        match spot.by_curvature > 0.0 {
            true => Some(tension + 2.0 * spot.by_curvature * self.curvature?),
            false => Some(tension),
        }
    }
}

fn at(
    runs: &[SeaRunRecord],
    place: &str,
    check: &Check,
    scene: &CheckedScene,
) -> Result<SeaDamage, String> {
    let diameter = scene.diameters.get(place).copied();
    let component = check.component(diameter, scene.strengths.get(place).copied())?;
    let records = runs
        .iter()
        .filter_map(|run| run.series(RecordedSeries::Tension, place));
    let records: Vec<ChannelRecord> = records.collect();
    if records.iter().any(|record| record.values.len() < 2) || records.is_empty() {
        return Err("there is no record over time".to_owned());
    }
    let found = fatigue(&records, &component).map_err(|error| error.to_string())?;
    let error = |of: Statistic| {
        let errors = runs
            .iter()
            .filter_map(|run| run.numerical(RecordedSeries::Tension, place, of));
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
