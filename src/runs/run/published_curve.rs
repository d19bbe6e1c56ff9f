//! Comparison of a run with the published curves of its case: root mean square of the differences, in percent of the
//! greatest magnitude of the curve, over the output times of a window.

use super::{History, Quantity, QuantityId};
use crate::case::{Case, PublishedCurve, stands_at};

/// Number of shifts of a periodic curve that are tried over a period.
const SHIFTS: usize = 400;

/// A run beside a published curve.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveComparison {
    /// Root mean square of the differences \[% of the curve's greatest size\].
    pub percent: f64,
    /// Times of the curve are those of the run plus this \[s\]; nonzero only for a periodic curve.
    pub shift: f64,
    /// Times \[s\] and values of the run within the window.
    pub samples: Vec<(f64, f64)>,
}

/// What identifies the difference from the curve of this number among those of a case, from 0.
#[must_use]
pub fn difference_id(curve: &PublishedCurve, number: usize) -> QuantityId {
    QuantityId::CurveDifference(curve.channel.clone(), number + 1)
}

/// Compares a record with a curve.
///
/// # Errors
/// Why there is nothing to compare, in words.
pub fn compare(curve: &PublishedCurve, history: &History) -> Result<CurveComparison, String> {
    let channel = history.channels.iter().find(|c| c.id == curve.channel);
    let channel = channel.ok_or_else(|| format!("The run has no channel `{}`.", curve.channel))?;
    let within = |t: f64| {
        let window = curve.window_s;
        window.is_none_or(|[from, to]| (from..=to).contains(&t))
    };
    let samples = history
        .time
        .iter()
        .copied()
        .zip(channel.values.iter().copied());
    let samples: Vec<(f64, f64)> = samples.filter(|(t, _)| within(*t)).collect();
    let points: Vec<(f64, f64)> = points(curve).collect();
    let greatest = points.iter().fold(0.0_f64, |most, p| most.max(p.1.abs()));
    if greatest <= 0.0 {
        return Err("The published curve is zero everywhere.".to_owned());
    }
    let shifts = curve.period_s.map_or(1, |_| SHIFTS);
    let tried = (0..shifts).filter_map(|i| {
        let shift = curve.period_s.unwrap_or(0.0) * i as f64 / shifts as f64;
        Some((apart(&points, curve.period_s, shift, &samples)?, shift))
    });
    let (least, shift) = tried
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .ok_or_else(|| "The run has no output times where the curve has points.".to_owned())?;
    Ok(CurveComparison {
        percent: 100.0 * least / greatest,
        shift,
        samples,
    })
}

/// The points of a curve.
pub fn points(curve: &PublishedCurve) -> impl Iterator<Item = (f64, f64)> {
    let values = curve.value.iter().copied();
    curve.time_s.iter().copied().zip(values)
}

/// The differences of a record from the curves of its case; of curves that belong to another point of a study, none.
pub(super) fn differences(case: &Case, history: &History) -> Vec<Quantity> {
    let curves = case.published_curve.iter().enumerate();
    let here = curves.filter(|(_, curve)| {
        curve
            .at
            .as_ref()
            .is_none_or(|at| stands_at(case, &case.study, at))
    });
    let number = |(number, curve): (usize, &PublishedCurve)| {
        let percent = compare(curve, history).ok()?.percent;
        Some(Quantity::new(difference_id(curve, number), percent))
    };
    here.filter_map(number).collect()
}

/// Root mean square of the differences of the samples from a curve that is shifted by a time; nothing where they do not
/// meet.
fn apart(
    points: &[(f64, f64)],
    period: Option<f64>,
    shift: f64,
    samples: &[(f64, f64)],
) -> Option<f64> {
    let differences = samples
        .iter()
        .filter_map(|(t, v)| Some(v - at(points, period, t + shift)?));
    let (sum, count) = differences.fold((0.0, 0.0), |(sum, n), d| (sum + d * d, n + 1.0));
    (count > 0.0).then(|| f64::sqrt(sum / count))
}

/// The curve at a time, interpolated linearly; a periodic one also from its last point to its first.
fn at(points: &[(f64, f64)], period: Option<f64>, time: f64) -> Option<f64> {
    let (first, last) = (*points.first()?, *points.last()?);
    let time = period.map_or(time, |p| first.0 + (time - first.0).rem_euclid(p));
    let after = points.partition_point(|p| p.0 <= time);
    let before = *points.get(after.checked_sub(1)?)?;
    let next = match (points.get(after), period) {
        (Some(next), _) => *next,
        (None, Some(period)) => (first.0 + period, first.1),
        (None, None) => return (time <= last.0).then_some(last.1),
    };
    let span = next.0 - before.0;
    Some(
        before.1
            + (next.1 - before.1)
                * if span > 0.0 {
                    (time - before.0) / span
                } else {
                    0.0
                },
    )
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn a_curve_is_straight_between_its_points_and_ends_with_them() {
        let points = [(0.0, 1.0), (1.0, 3.0), (2.0, 3.0)];
        assert_eq!(at(&points, None, 0.5), Some(2.0));
        assert_eq!(at(&points, None, 2.0), Some(3.0));
        assert_eq!(at(&points, None, 2.1), None);
        assert_eq!(at(&points, None, -0.1), None);
        assert_eq!(at(&points, Some(4.0), 3.0), Some(2.0));
        assert_eq!(at(&points, Some(4.0), -3.0), Some(3.0));
    }

    #[test]
    fn a_curve_that_repeats_is_shifted_to_where_it_fits() {
        let points: Vec<(f64, f64)> = (0..40)
            .map(|i| (0.1 * f64::from(i), (TAU * f64::from(i) / 40.0).sin()))
            .collect();
        let sample = |i: i32| {
            (
                0.05 * f64::from(i),
                (TAU * (0.05 * f64::from(i) - 1.0) / 4.0).sin() + 0.01,
            )
        };
        let samples: Vec<(f64, f64)> = (0..400).map(sample).collect();
        let apart = |shift: f64| apart(&points, Some(4.0), shift, &samples).unwrap();
        assert!((apart(3.0) - 0.01).abs() < 2e-3);
        assert!(apart(1.0) > 1.0);
    }
}
