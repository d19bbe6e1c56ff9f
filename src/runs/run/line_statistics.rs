//! Statistics along the line: extremes and where they lie, falls, turns.

use super::Profile;
use super::response::travelling;
use super::wave_decomposition::standing_wave_ratio;
use crate::case::{LineQuantity, Statistic};
use crate::numerics::interpolation::linear_clamped;
use crate::numerics::quadrature::trapezoid;

/// The statistics along the line that every run computes.
pub(super) const ALWAYS: [(LineQuantity, Statistic); 18] = [
    (LineQuantity::Tension, Statistic::Max),
    (LineQuantity::Tension, Statistic::ArcOfMax),
    (LineQuantity::Tension, Statistic::Min),
    (LineQuantity::Tension, Statistic::ArcOfMin),
    (LineQuantity::Curvature, Statistic::Max),
    (LineQuantity::BendRadius, Statistic::Min),
    (LineQuantity::BendRadius, Statistic::ArcOfMin),
    (LineQuantity::Moment, Statistic::Max),
    (LineQuantity::Moment, Statistic::ArcOfMax),
    (LineQuantity::MeanLoad, Statistic::Max),
    (LineQuantity::MeanLoad, Statistic::Min),
    (LineQuantity::Stiffness, Statistic::Max),
    (LineQuantity::Stiffness, Statistic::Min),
    (LineQuantity::RmsDisplacement, Statistic::Max),
    (LineQuantity::RmsDiameters, Statistic::Max),
    (LineQuantity::RmsDiameters, Statistic::ArcOfMax),
    (LineQuantity::Travelling, Statistic::Mean),
    (LineQuantity::StandingWaveRatio, Statistic::Mean),
];

/// A turn by less than this share of the whole range is not counted.
const SMALL_TURN: f64 = 0.01;

/// A statistic of a quantity along the line, or along a stretch of it \[m\]; nothing where it was not recorded, is not
/// finite, the line has no such stretch, or no peak or valley of this number `nth`, from 1.
#[must_use]
pub fn evaluate(
    profile: &Profile,
    quantity: LineQuantity,
    statistic: Statistic,
    stretch: Option<[f64; 2]>,
    nth: Option<usize>,
) -> Option<f64> {
    let arc = if quantity.of_ropes() {
        &profile.ropes.arc
    } else {
        &profile.arc
    };
    let cut = |values: Vec<f64>| match stretch {
        Some(stretch) => cut(arc, &values, stretch),
        None => (values.len() == arc.len()).then(|| (arc.clone(), values)),
    };
    let extreme_of = |values: Vec<f64>, better: fn(f64, f64) -> bool| {
        let (arc, values) = cut(values)?;
        let (node, value) = extreme(&values, better)?;
        Some((*arc.get(node)?, value))
    };
    if quantity == LineQuantity::Travelling {
        let (arc, cos) = cut(profile.wave_cos.clone())?;
        let (_, sin) = cut(profile.wave_sin.clone())?;
        let share = || travelling(&arc, &cos, &sin);
        return (statistic == Statistic::Mean).then(share).flatten();
    }
    if quantity == LineQuantity::StandingWaveRatio {
        let mean = |values: &Vec<f64>| cut(values.clone()).and_then(|(arc, v)| mean(&arc, &v));
        let both = || mean(&profile.towards_a).zip(mean(&profile.towards_b));
        let both = (statistic == Statistic::Mean).then(both).flatten();
        return both.and_then(|(a, b)| standing_wave_ratio(a, b));
    }
    let values = NodeValues::of_profile(profile, quantity);
    let value = match statistic {
        Statistic::Max => extreme_of(values.greatest, |new, old| new > old)?.1,
        Statistic::Min => extreme_of(values.smallest, |new, old| new < old)?.1,
        Statistic::ArcOfMax => extreme_of(values.greatest, |new, old| new > old)?.0,
        Statistic::ArcOfMin => extreme_of(values.smallest, |new, old| new < old)?.0,
        Statistic::Mean => cut(values.end).and_then(|(arc, values)| mean(&arc, &values))?,
        Statistic::GreatestFall => greatest_fall(&cut(values.end)?.1)?,
        Statistic::Turns => count(&turns(&cut(values.end)?.1)?, |_| true),
        Statistic::Peaks => count(&turns(&cut(values.end)?.1)?, |turn| turn.peak),
        Statistic::Peak | Statistic::Valley => {
            let peak = statistic == Statistic::Peak;
            let turns = turns(&cut(values.end)?.1)?.into_iter();
            let mut alike = turns.filter(|turn| turn.peak == peak);
            alike.nth(nth?.checked_sub(1)?)?.value
        }
        _ => return None,
    };
    value.is_finite().then_some(value)
}

/// The resolution of a statistic on the nodes: for a place along the line the longest segment \[m\].
#[must_use]
pub fn resolution(profile: &Profile, statistic: Statistic) -> f64 {
    match statistic {
        Statistic::ArcOfMax | Statistic::ArcOfMin => longest_segment(profile),
        _ => 0.0,
    }
}

/// The longest segment of a line \[m\].
#[must_use]
pub fn longest_segment(profile: &Profile) -> f64 {
    let lengths = profile.arc.windows(2).map(|pair| pair[1] - pair[0]);
    lengths.fold(0.0, f64::max)
}

/// A quantity node by node: at the end of the run, its greatest and its smallest values over time. Where extremes are not
/// recorded, those are the values at the end.
struct NodeValues {
    end: Vec<f64>,
    greatest: Vec<f64>,
    smallest: Vec<f64>,
}

impl NodeValues {
    fn of_profile(profile: &Profile, quantity: LineQuantity) -> Self {
        let (p, ropes) = (profile, &profile.ropes);
        let heights = || -> Vec<f64> { p.nodes.iter().map(|node| node[2]).collect() };
        match quantity {
            LineQuantity::Tension => Self::new(&p.tension, &p.tension_max, &p.tension_min),
            LineQuantity::TensionSwing => Self::at_end(&swings(&p.tension_max, &p.tension_min)),
            LineQuantity::StiffnessSwing => {
                Self::at_end(&swings(&ropes.stiffness_max, &ropes.stiffness_min))
            }
            LineQuantity::Height => Self::new(&heights(), &p.z_max, &p.z_min),
            LineQuantity::BedClearance => {
                Self::new(&p.bed_clearance, &p.bed_clearance, &p.bed_clearance_min)
            }
            LineQuantity::Curvature => Self::new(&p.curvature, &p.curvature_max, &p.curvature),
            LineQuantity::BendRadius => {
                let end = radii(&p.curvature);
                Self::new(&end, &end, &radii(&p.curvature_max))
            }
            LineQuantity::Moment => Self::new(&p.moment, &p.moment_max, &p.moment),
            LineQuantity::Stiffness => {
                Self::new(&ropes.stiffness, &ropes.stiffness_max, &ropes.stiffness_min)
            }
            LineQuantity::MeanLoad => Self::at_end(&ropes.mean_load),
            LineQuantity::RmsDisplacement => Self::at_end(&p.rms),
            LineQuantity::RmsDiameters => Self::at_end(&p.rms_diameters),
            LineQuantity::RmsVertical => Self::at_end(&p.rms_vertical),
            LineQuantity::RmsHorizontal => Self::at_end(&p.rms_horizontal),
            LineQuantity::Wavelength => Self::at_end(&wavelengths(&p.wave_number)),
            LineQuantity::WkbWavelength => Self::at_end(&wavelengths(&p.wkb_number)),
            // Not of a node, but of a stretch.
            LineQuantity::Travelling | LineQuantity::StandingWaveRatio => Self::at_end(&[]),
        }
    }

    fn new(end: &[f64], greatest: &[f64], smallest: &[f64]) -> Self {
        Self {
            end: end.to_vec(),
            greatest: greatest.to_vec(),
            smallest: smallest.to_vec(),
        }
    }

    fn at_end(end: &[f64]) -> Self {
        Self::new(end, end, end)
    }
}

/// Greatest less smallest; nothing where extremes were not recorded.
fn swings(greatest: &[f64], smallest: &[f64]) -> Vec<f64> {
    let pairs = greatest.iter().zip(smallest);
    pairs.map(|(most, least)| most - least).collect()
}

fn wavelengths(numbers: &[f64]) -> Vec<f64> {
    numbers.iter().map(|k| std::f64::consts::TAU / k).collect()
}

fn radii(curvatures: &[f64]) -> Vec<f64> {
    curvatures.iter().map(|c| 1.0 / c).collect()
}

/// Arc lengths and values on a stretch of the line, its ends interpolated; nothing where the line does not reach so far.
fn cut(arc: &[f64], values: &[f64], [from, to]: [f64; 2]) -> Option<(Vec<f64>, Vec<f64>)> {
    // Arc lengths are sums of roundings: the end of the line belongs to it.
    let slop = 1e-9 * arc.last()?.max(1.0);
    let (first, last) = (*arc.first()?, *arc.last()?);
    if values.len() != arc.len() || from < first - slop || to > last + slop || from > to {
        return None;
    }
    let at = |s: f64| linear_clamped(arc, values, s);
    let inner = arc
        .iter()
        .zip(values)
        .filter(|(a, _)| **a > from && **a < to);
    let mut points = vec![(from, at(from))];
    points.extend(inner.map(|(a, v)| (*a, *v)));
    points.push((to, at(to)));
    Some(points.into_iter().unzip())
}

/// Average over arc length by trapezes; over no length: the value there.
fn mean(arc: &[f64], values: &[f64]) -> Option<f64> {
    let length = arc.last()? - arc.first()?;
    if length <= 0.0 {
        return values.first().copied();
    }
    Some(trapezoid(arc, values) / length)
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

/// A place where values turn from rising to falling, a peak, or back.
#[derive(Debug, Clone, Copy, PartialEq)]
struct TurningPoint {
    value: f64,
    peak: bool,
}

/// Where the values turn, in their order; small ripples are left out.
fn turns(values: &[f64]) -> Option<Vec<TurningPoint>> {
    let first = *values.first()?;
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let small = SMALL_TURN * (high - low);
    // The extreme values since the last turn; a way is known once one of them is far enough behind.
    let (mut bottom, mut top) = (first, first);
    let mut rising = None;
    let mut found = Vec::new();
    for value in values.iter().copied() {
        (bottom, top) = (bottom.min(value), top.max(value));
        let way = match rising {
            Some(true) | None if top - value > small => Some(false),
            Some(false) | None if value - bottom > small => Some(true),
            _ => rising,
        };
        if way != rising {
            found.extend(rising.map(|peak| TurningPoint {
                value: if peak { top } else { bottom },
                peak,
            }));
            rising = way;
            (bottom, top) = (value, value);
        }
    }
    Some(found)
}

fn count(turns: &[TurningPoint], of: impl Fn(&TurningPoint) -> bool) -> f64 {
    turns.iter().filter(|turn| of(turn)).count() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn up_down_up_turns_twice_and_ripples_do_not_count() {
        let counts = |values: &[f64]| {
            let peaks = count(&turns(values)?, |turn| turn.peak);
            Some((count(&turns(values)?, |_| true), peaks))
        };
        assert_eq!(counts(&[0.0, 1.0, 2.0, 3.0]), Some((0.0, 0.0)));
        assert_eq!(counts(&[0.0, 5.0, 2.0, 8.0]), Some((2.0, 1.0)));
        assert_eq!(
            counts(&[0.0, 50.0, 49.8, 50.1, 20.0, 80.0]),
            Some((2.0, 1.0))
        );
        assert_eq!(counts(&[3.0, 1.0]), Some((0.0, 0.0)));
        assert_eq!(counts(&[1.0; 4]), Some((0.0, 0.0)));
        assert_eq!(counts(&[]), None);
    }

    #[test]
    fn peaks_and_valleys_are_counted_from_end_a() {
        // sin 3s + s/10 turns at cos 3s = -1/30, with small ripples that are no turns.
        let arc: Vec<f64> = (0..=6000).map(|i| f64::from(i) * 1e-3).collect();
        let curve = |s: f64| (3.0 * s).sin() + 0.1 * s;
        let ripple = |s: f64| 1e-3 * (400.0 * s).sin();
        let profile = Profile {
            rms: arc.iter().map(|s| curve(*s) + ripple(*s)).collect(),
            arc,
            ..Profile::default()
        };
        let take = |statistic, nth, stretch| {
            let quantity = LineQuantity::RmsDisplacement;
            evaluate(&profile, quantity, statistic, stretch, Some(nth))
        };
        let first_peak = (-1.0_f64 / 30.0).acos() / 3.0;
        let first_valley = (std::f64::consts::TAU - (-1.0_f64 / 30.0).acos()) / 3.0;
        let wave = std::f64::consts::TAU / 3.0;
        for n in 0..3_usize {
            let along = wave * n as f64;
            let near = |found: Option<f64>, s: f64| (found.unwrap() - curve(s)).abs() < 2e-3;
            assert!(near(take(Statistic::Peak, n + 1, None), first_peak + along));
            let valley = take(Statistic::Valley, n + 1, None);
            assert!(near(valley, first_valley + along));
        }
        assert_eq!(take(Statistic::Peak, 4, None), None);
        assert_eq!(take(Statistic::Peak, 0, None), None);
        // A stretch that begins behind the first peak has the second as its first.
        let second = take(Statistic::Peak, 2, None);
        assert_eq!(take(Statistic::Peak, 1, Some([1.0, 6.0])), second);
        assert_eq!(take(Statistic::Peak, 3, Some([1.0, 6.0])), None);
    }

    #[test]
    fn a_stretch_has_its_ends_interpolated() {
        let profile = Profile {
            arc: vec![0.0, 2.0, 4.0, 8.0],
            tension: vec![0.0, 4.0, 2.0, 6.0],
            tension_max: vec![0.0, 4.0, 2.0, 6.0],
            tension_min: vec![0.0, 4.0, 2.0, 6.0],
            ..Profile::default()
        };
        let take = |s, stretch| evaluate(&profile, LineQuantity::Tension, s, Some(stretch), None);
        assert_eq!(take(Statistic::Mean, [1.0, 1.0]), Some(2.0));
        assert_eq!(take(Statistic::Mean, [8.0, 8.0]), Some(6.0));
        assert_eq!(take(Statistic::Mean, [0.0, 2.0]), Some(2.0));
        assert_eq!(take(Statistic::Max, [1.0, 3.0]), Some(4.0));
        assert_eq!(take(Statistic::ArcOfMin, [3.0, 8.0]), Some(4.0));
        assert_eq!(take(Statistic::Peaks, [0.0, 8.0]), Some(1.0));
        assert_eq!(take(Statistic::Peaks, [2.0, 8.0]), Some(0.0));
        assert_eq!(take(Statistic::Mean, [0.0, 9.0]), None);
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
        let take = |q, s| evaluate(&profile, q, s, None, None);
        assert_eq!(take(LineQuantity::Tension, Statistic::Max), Some(9.0));
        assert_eq!(take(LineQuantity::Tension, Statistic::ArcOfMax), Some(2.0));
        assert_eq!(take(LineQuantity::Tension, Statistic::ArcOfMin), Some(5.0));
        assert_eq!(take(LineQuantity::Tension, Statistic::Mean), None);
        assert_eq!(take(LineQuantity::TensionSwing, Statistic::Max), Some(6.0));
        assert_eq!(
            take(LineQuantity::TensionSwing, Statistic::ArcOfMax),
            Some(5.0)
        );
        assert_eq!(take(LineQuantity::Moment, Statistic::Max), None);
        assert!((resolution(&profile, Statistic::ArcOfMax) - 3.0).abs() < 1e-12);
    }
}
