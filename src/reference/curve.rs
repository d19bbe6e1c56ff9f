//! A published curve held against a channel: root mean square of the differences, in percent of the curve's greatest size.

use super::row::Row;
use super::value::{Claim, hold};
use crate::{
    case::{At, PublishedCurve},
    run::{Run, RunState},
};

/// Shifts of a curve that repeats which are tried a period.
const SHIFTS: usize = 400;

pub(super) fn row<'r>(
    curve: &PublishedCurve,
    lookup: &dyn Fn(Option<&At>) -> Option<&'r Run>,
) -> Row {
    let claim = Claim {
        name: &curve.name,
        source: &curve.source,
        value: 0.0,
        tolerance: curve.tolerance_percent,
        unit: "% of peak, rms".to_owned(),
        inputs: curve.inputs,
        fitted: false,
        basis: None,
        at: curve.at.clone(),
        from: None,
        by: None,
        out_of_reach: curve.out_of_reach.as_deref(),
    };
    let number = lookup(curve.at.as_ref())
        .ok_or_else(|| "This variant of the case has not been run.".to_owned())
        .and_then(|run| difference(curve, run));
    // A curve has no numerical error of its own: those of the run's numbers stand in its summary.
    hold(claim, number.map(|percent| (percent, None)))
}

/// The difference of a run from the curve \[% of the curve's greatest size\], over the output times of the window.
fn difference(curve: &PublishedCurve, run: &Run) -> Result<f64, String> {
    if run.info.state != RunState::Done {
        return Err("The run did not come to its end.".to_owned());
    }
    let channel = run.history.channel(&curve.channel);
    let channel = channel.ok_or_else(|| format!("The run has no channel `{}`.", curve.channel))?;
    let samples = run.history.time.iter().copied();
    let samples: Vec<(f64, f64)> = samples
        .zip(channel.values.iter().copied())
        .filter(|(t, _)| {
            curve
                .window_s
                .is_none_or(|[from, to]| (from..=to).contains(t))
        })
        .collect();
    let points: Vec<(f64, f64)> = curve
        .time_s
        .iter()
        .copied()
        .zip(curve.value.iter().copied())
        .collect();
    let greatest = curve
        .value
        .iter()
        .fold(0.0_f64, |most, v| most.max(v.abs()));
    let shifts = curve.period_s.map_or(1, |_| SHIFTS);
    let shift = |i: usize| curve.period_s.unwrap_or(0.0) * i as f64 / shifts as f64;
    let all = (0..shifts).filter_map(|i| apart(&points, curve.period_s, shift(i), &samples));
    let best = all.reduce(f64::min);
    let best =
        best.ok_or_else(|| "The run has no output times where the curve has points.".to_owned())?;
    if greatest > 0.0 {
        Ok(100.0 * best / greatest)
    } else {
        Err("The published curve is nought everywhere.".to_owned())
    }
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

/// The curve at a time, straight between its points; one that repeats goes on from its last point to its first.
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
