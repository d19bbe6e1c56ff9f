//! Difference curves: a channel of one run less that of another, on a common time axis.

use crate::case::ChannelId;
use crate::numerics::interpolation::linear_clamped;
use crate::run::History;

/// A channel of a run less that of another, over the time that both have.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveDifference {
    /// The channel.
    pub id: ChannelId,
    /// Times \[s\] and differences, at every time that either history has; straight in between, as both curves are.
    pub points: Vec<(f64, f64)>,
    /// Root mean square over time.
    pub rms: f64,
    /// The difference of the greatest size, and its time \[s\].
    pub greatest: (f64, f64),
}

/// The differences `to - from` of every channel that both have.
#[must_use]
pub fn differences(from: &History, to: &History) -> Vec<CurveDifference> {
    let ids = from.channels.iter().map(|channel| &channel.id);
    ids.filter_map(|id| difference(from, to, id)).collect()
}

/// The difference `to - from` of a channel, over the time that both histories have; none where one lacks the channel or they have
/// no time in common.
#[must_use]
pub fn difference(from: &History, to: &History, id: &ChannelId) -> Option<CurveDifference> {
    let curves = [curve(from, id)?, curve(to, id)?];
    let times = common_axis(curves[0].0, curves[1].0)?;
    let [from, to] = curves;
    let points: Vec<(f64, f64)> = times
        .into_iter()
        .map(|time| (time, value_at(to, time) - value_at(from, time)))
        .filter(|(_, difference)| difference.is_finite())
        .collect();
    let greatest = points.iter().copied().reduce(|best, here| {
        if here.1.abs() > best.1.abs() {
            here
        } else {
            best
        }
    })?;
    Some(CurveDifference {
        id: id.clone(),
        rms: root_mean_square(&points),
        greatest: (greatest.1, greatest.0),
        points,
    })
}

/// The points of a curve less those of another, at every place that either has within what both cover; straight in between.
#[must_use]
pub fn points_less(curve: &[(f64, f64)], other: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let split = |points: &[(f64, f64)]| -> (Vec<f64>, Vec<f64>) { points.iter().copied().unzip() };
    let (curve, other) = (split(curve), split(other));
    let axis = common_axis(&curve.0, &other.0).unwrap_or_default();
    let less = |at: f64| {
        let here = value_at((&curve.0, &curve.1), at);
        here - value_at((&other.0, &other.1), at)
    };
    let points = axis.into_iter().map(|at| (at, less(at)));
    points.filter(|(_, less)| less.is_finite()).collect()
}

/// Times and values, as many of the one as of the other.
type Curve<'a> = (&'a [f64], &'a [f64]);

fn curve<'a>(history: &'a History, id: &ChannelId) -> Option<Curve<'a>> {
    let channel = history.channels.iter().find(|c| c.id == *id)?;
    let count = history.time.len().min(channel.values.len());
    (count > 0).then(|| (&history.time[..count], &channel.values[..count]))
}

/// The times of both axes, increasing, within what both cover.
fn common_axis(a: &[f64], b: &[f64]) -> Option<Vec<f64>> {
    let begin = a.first()?.max(*b.first()?);
    let end = a.last()?.min(*b.last()?);
    let within = |t: &f64| (begin..=end).contains(t);
    let mut times: Vec<f64> = a.iter().chain(b).copied().filter(within).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    (!times.is_empty()).then_some(times)
}

/// The value at a time, straight between two times.
fn value_at((times, values): Curve<'_>, time: f64) -> f64 {
    match values {
        [only] => *only,
        _ => linear_clamped(times, values, time),
    }
}

/// Over time, of a curve straight between its points; of a single point its size.
fn root_mean_square(points: &[(f64, f64)]) -> f64 {
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return 0.0;
    };
    if last.0 <= first.0 {
        return first.1.abs();
    }
    let square = |pair: &[(f64, f64)]| {
        let (t0, d0) = pair[0];
        let (t1, d1) = pair[1];
        (t1 - t0) * (d0 * d0 + d0 * d1 + d1 * d1) / 3.0
    };
    let integral: f64 = points.windows(2).map(square).sum();
    (integral / (last.0 - first.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::Channel;
    use proptest::prelude::*;

    fn id() -> ChannelId {
        "z_m[end]".parse().unwrap()
    }

    fn history(time: Vec<f64>, value: impl Fn(f64) -> f64) -> History {
        let values = time.iter().map(|t| value(*t)).collect();
        let channels = vec![Channel {
            values,
            ..Channel::new(id())
        }];
        History { time, channels }
    }

    #[test]
    fn different_times_are_interpolated_over_what_both_cover() {
        let from = history(vec![0.0, 1.0, 2.0, 3.0], |t| t);
        let to = history(vec![0.5, 2.5], |t| 2.0 * t);
        let found = difference(&from, &to, &id()).unwrap();
        assert_eq!(
            found.points,
            [(0.5, 0.5), (1.0, 1.0), (2.0, 2.0), (2.5, 2.5)]
        );
        assert_eq!(found.greatest, (2.5, 2.5));
        // The mean of t² from 0.5 to 2.5 is (2.5³ - 0.5³) / 6.
        let exact = ((2.5_f64.powi(3) - 0.125) / 6.0).sqrt();
        assert!((found.rms - exact).abs() < 1e-12, "{}", found.rms);
    }

    #[test]
    fn lines_at_rest_have_one_point_and_strangers_none() {
        let (from, to) = (history(vec![0.0], |_| 1.0), history(vec![0.0], |_| 4.0));
        let found = difference(&from, &to, &id()).unwrap();
        assert_eq!((found.points, found.rms), (vec![(0.0, 3.0)], 3.0));
        let later = history(vec![5.0, 6.0], |_| 1.0);
        assert_eq!(difference(&from, &later, &id()), None);
        assert_eq!(difference(&from, &to, &"x_m[end]".parse().unwrap()), None);
    }

    proptest! {
        /// Of two straight lines the difference is straight, whatever the times; the other way round it changes sign.
        #[test]
        fn straight_lines_differ_by_a_straight_line(
            steps in prop::collection::vec(0.01..2.0f64, 1..30),
            others in prop::collection::vec(0.01..2.0f64, 1..30),
            slopes in prop::array::uniform2(-5.0..5.0f64),
        ) {
            let axis = |steps: &[f64]| {
                steps.iter().scan(0.0, |t, step| { *t += step; Some(*t) }).collect::<Vec<f64>>()
            };
            let (a, b) = (axis(&steps), axis(&others));
            let from = history([vec![0.0], a].concat(), |t| slopes[0] * t);
            let to = history([vec![0.0], b].concat(), |t| slopes[1] * t);
            let (there, back) = (
                difference(&from, &to, &id()).unwrap(),
                difference(&to, &from, &id()).unwrap(),
            );
            for (t, d) in &there.points {
                prop_assert!((d - (slopes[1] - slopes[0]) * t).abs() < 1e-9);
            }
            prop_assert!(there.points.windows(2).all(|pair| pair[0].0 < pair[1].0));
            prop_assert!((there.rms - back.rms).abs() <= 1e-12 * (1.0 + there.rms));
            prop_assert!(there.rms <= there.greatest.0.abs() * (1.0 + 1e-12));
        }
    }
}
