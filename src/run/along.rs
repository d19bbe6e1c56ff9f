//! Single numbers taken of the whole line: extremes and where they lie, falls, turns.

use super::Profile;
use crate::case::{AlongLine, Statistic};

/// What every run summarises of its line.
pub(super) const ALWAYS: [(AlongLine, Statistic); 9] = [
    (AlongLine::Tension, Statistic::Max),
    (AlongLine::Tension, Statistic::ArcOfMax),
    (AlongLine::Tension, Statistic::Min),
    (AlongLine::Tension, Statistic::ArcOfMin),
    (AlongLine::Curvature, Statistic::Max),
    (AlongLine::BendRadius, Statistic::Min),
    (AlongLine::BendRadius, Statistic::ArcOfMin),
    (AlongLine::Moment, Statistic::Max),
    (AlongLine::Moment, Statistic::ArcOfMax),
];

/// A turn by less than this share of the whole range is not counted.
const SMALL_TURN: f64 = 0.01;

/// A statistic of a quantity along the line; nothing where it was not recorded or is not finite.
pub(super) fn evaluate(
    profile: &Profile,
    quantity: AlongLine,
    statistic: Statistic,
) -> Option<f64> {
    let greatest = || extreme(&most(profile, quantity), |new, old| new > old);
    let smallest = || extreme(&least(profile, quantity), |new, old| new < old);
    let arc = |node: usize| profile.arc.get(node).copied();
    let value = match statistic {
        Statistic::Max => greatest()?.1,
        Statistic::Min => smallest()?.1,
        Statistic::ArcOfMax => arc(greatest()?.0)?,
        Statistic::ArcOfMin => arc(smallest()?.0)?,
        Statistic::GreatestFall => greatest_fall(&at_end(profile, quantity))?,
        Statistic::Turns => turns(&at_end(profile, quantity))?,
        _ => return None,
    };
    value.is_finite().then_some(value)
}

/// How finely a statistic can be told on the nodes: a place along the line to half a segment, the longest.
pub(super) fn resolution(profile: &Profile, statistic: Statistic) -> f64 {
    match statistic {
        Statistic::ArcOfMax | Statistic::ArcOfMin => {
            let lengths = profile.arc.windows(2).map(|pair| pair[1] - pair[0]);
            0.5 * lengths.fold(0.0, f64::max)
        }
        _ => 0.0,
    }
}

/// The quantity node by node at the end of the run.
fn at_end(profile: &Profile, quantity: AlongLine) -> Vec<f64> {
    match quantity {
        AlongLine::Tension => profile.tension.clone(),
        AlongLine::Height => profile.nodes.iter().map(|p| p[2]).collect(),
        AlongLine::Curvature => profile.curvature.clone(),
        AlongLine::BendRadius => radii(&profile.curvature),
        AlongLine::Moment => profile.moment.clone(),
    }
}

/// Its greatest values over time.
fn most(profile: &Profile, quantity: AlongLine) -> Vec<f64> {
    match quantity {
        AlongLine::Tension => profile.tension_max.clone(),
        AlongLine::Height => profile.z_max.clone(),
        AlongLine::Curvature => profile.curvature_max.clone(),
        AlongLine::Moment => profile.moment_max.clone(),
        AlongLine::BendRadius => at_end(profile, quantity),
    }
}

/// Its smallest values over time; of what is recorded only at its greatest, those at the end.
fn least(profile: &Profile, quantity: AlongLine) -> Vec<f64> {
    match quantity {
        AlongLine::Tension => profile.tension_min.clone(),
        AlongLine::Height => profile.z_min.clone(),
        AlongLine::BendRadius => radii(&profile.curvature_max),
        AlongLine::Curvature | AlongLine::Moment => at_end(profile, quantity),
    }
}

fn radii(curvatures: &[f64]) -> Vec<f64> {
    curvatures.iter().map(|c| 1.0 / c).collect()
}

/// The first node at which a value is better than all others, and that value.
pub(super) fn extreme(values: &[f64], better: impl Fn(f64, f64) -> bool) -> Option<(usize, f64)> {
    let numbered = values.iter().copied().enumerate();
    numbered.reduce(|best, here| if better(here.1, best.1) { here } else { best })
}

/// The most by which any value lies below an earlier one.
fn greatest_fall(values: &[f64]) -> Option<f64> {
    let mut highest = *values.first()?;
    let mut fall: f64 = 0.0;
    for value in values {
        highest = highest.max(*value);
        fall = fall.max(highest - value);
    }
    Some(fall)
}

/// How often the values turn, small ripples left out.
fn turns(values: &[f64]) -> Option<f64> {
    let first = *values.first()?;
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let small = SMALL_TURN * (high - low);
    // The extreme values since the last turn; a way is known once one of them is far enough behind.
    let (mut bottom, mut top) = (first, first);
    let mut rising = None;
    let mut count = 0;
    for value in values.iter().copied() {
        (bottom, top) = (bottom.min(value), top.max(value));
        let way = match rising {
            Some(true) | None if top - value > small => Some(false),
            Some(false) | None if value - bottom > small => Some(true),
            _ => rising,
        };
        if way != rising {
            count += u32::from(rising.is_some());
            rising = way;
            (bottom, top) = (value, value);
        }
    }
    Some(f64::from(count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn up_down_up_turns_twice_and_ripples_do_not_count() {
        let turns = |values: &[f64]| turns(values);
        assert_eq!(turns(&[0.0, 1.0, 2.0, 3.0]), Some(0.0));
        assert_eq!(turns(&[0.0, 5.0, 2.0, 8.0]), Some(2.0));
        assert_eq!(turns(&[0.0, 50.0, 49.8, 50.1, 20.0, 80.0]), Some(2.0));
        assert_eq!(turns(&[3.0, 1.0]), Some(0.0));
        assert_eq!(turns(&[1.0; 4]), Some(0.0));
        assert_eq!(turns(&[]), None);
    }

    #[test]
    fn falls_go_from_a_to_b() {
        assert_eq!(greatest_fall(&[0.0, 5.0, 2.0, 8.0]), Some(3.0));
        assert_eq!(greatest_fall(&[0.0, 1.0]), Some(0.0));
    }

    #[test]
    fn places_of_extremes_and_what_was_not_recorded() {
        let profile = Profile {
            arc: vec![0.0, 2.0, 5.0],
            tension_max: vec![1.0, 9.0, 3.0],
            tension_min: vec![1.0, 4.0, -3.0],
            ..Profile::default()
        };
        let take = |q, s| evaluate(&profile, q, s);
        assert_eq!(take(AlongLine::Tension, Statistic::Max), Some(9.0));
        assert_eq!(take(AlongLine::Tension, Statistic::ArcOfMax), Some(2.0));
        assert_eq!(take(AlongLine::Tension, Statistic::ArcOfMin), Some(5.0));
        assert_eq!(take(AlongLine::Tension, Statistic::Mean), None);
        assert_eq!(take(AlongLine::Moment, Statistic::Max), None);
        assert!((resolution(&profile, Statistic::ArcOfMax) - 1.5).abs() < 1e-12);
    }
}
