//! Round units laid side by side in a helix: when they touch, how small a circle holds them, how
//! many a circle holds.
//!
//! The axes of two units of one layer are the same helix, turned by a phase ψ against each other.
//! Seen from a point of one, a point of the other lies at the angle ψ+θ and the height θ R cot α, so
//! that the square of their distance is R² [2 − 2 cos(ψ+θ) + θ² cot²α]. The units touch where the
//! least of these over θ is the sum of their radii. That is exact for round units; the common
//! r √(1 + cot²(π/n)/cos²α) of Costello 1990 takes their cuts for ellipses and is short by some
//! 1e-4.

use std::convert::Infallible;
use std::f64::consts::{PI, TAU};

use crate::numerics::golden_section::golden_section;
use crate::numerics::roots::{Bracket, bisect};

/// Greatest number of wires of a layer.
pub(super) const MOST: usize = 100_000;

/// Least distance of two helices of pitch radius 1, turned by `phase` against each other \[-\].
///
/// `angle` is the lay angle to the axis, above 0 and below a right angle \[rad\].
#[must_use]
pub fn helix_distance(phase: f64, angle: f64) -> f64 {
    // Turned by more than half a turn, the other way round is shorter.
    let phase = phase.clamp(0.0, TAU);
    let phase = phase.min(TAU - phase);
    let cot = 1.0 / angle.tan();
    let squared = |theta: f64| {
        let chord = 2.0 * (0.5 * (phase + theta)).sin();
        chord * chord + (theta * cot).powi(2)
    };
    // The least lies where the other helix has turned back, at most as far as the phase. Steep
    // helices may have more than one such place: look at all of it first, then closer.
    const LOOKS: u32 = 48;
    let step = phase / f64::from(LOOKS);
    let best = (0..=LOOKS)
        .map(|i| -f64::from(i) * step)
        .min_by(|a, b| squared(*a).total_cmp(&squared(*b)))
        .unwrap_or(0.0);
    let around = (best - step, best + step);
    let Ok(theta) = golden_section(around, 0.0, 40, |theta| Ok::<_, Infallible>(squared(theta)));
    squared(theta).sqrt()
}

/// The phase at which two units of radii that add up to `sum` touch on this pitch radius \[rad\];
/// nothing when they do not even fit opposite each other.
#[must_use]
pub fn touching_phase(sum: f64, radius: f64, angle: f64) -> Option<f64> {
    let wanted = sum / radius;
    if !wanted.is_finite() || helix_distance(PI, angle) < wanted {
        return None;
    }
    let half_turn = Bracket { low: 0.0, high: PI };
    let apart = |phase: f64| helix_distance(phase, angle) < wanted;
    Some(bisect(half_turn, 60, Bracket::middle, apart).high)
}

/// Units set side by side around a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct PackedRing {
    /// The angle of each unit, in their order, the room left over shared out between them \[rad\].
    pub places: Vec<f64>,
    /// The angle that all of them take: a full turn when the layer is just full \[rad\].
    pub taken: f64,
}

/// Sets units of these radii around a layer, beginning with the thickest; nothing when two of them
/// do not even fit opposite each other. Units that are not neighbours may touch over a thin one.
#[must_use]
pub fn ring(radii: &[f64], radius: f64, angle: f64) -> Option<PackedRing> {
    let n = radii.len();
    if n < 2 {
        let places = vec![0.0; n];
        return Some(PackedRing { places, taken: 0.0 });
    }
    let thickest = (0..n).max_by(|a, b| radii[*a].total_cmp(&radii[*b]))?;
    let of = |i: usize| radii[(thickest + i) % n];
    let mut touch = TouchPhases {
        radius,
        angle,
        known: Vec::new(),
    };
    let mut from_thickest: Vec<f64> = vec![0.0];
    for j in 1..n {
        let mut place = from_thickest[j - 1] + touch.phase(of(j - 1) + of(j))?;
        for (i, before) in from_thickest.iter().enumerate().take(j - 1) {
            let sum = of(i) + of(j);
            if place - before < touch.at_most(sum) {
                place = place.max(before + touch.phase(sum)?);
            }
        }
        from_thickest.push(place);
    }
    let mut taken = from_thickest[n - 1] + touch.phase(of(n - 1) + of(0))?;
    for j in 1..n {
        for i in 0..j {
            let (gone, sum) = (from_thickest[j] - from_thickest[i], of(i) + of(j));
            if taken - gone < touch.at_most(sum) {
                taken = taken.max(gone + touch.phase(sum)?);
            }
        }
    }
    let gap = (TAU - taken).max(0.0) / n as f64;
    let places = (0..n).map(|i| {
        let turn = (i + n - thickest) % n;
        from_thickest[turn] + gap * turn as f64
    });
    Some(PackedRing {
        places: places.collect(),
        taken,
    })
}

/// Phases at which units touch on one pitch radius; they are mostly alike, so each is kept.
struct TouchPhases {
    radius: f64,
    angle: f64,
    known: Vec<(f64, f64)>,
}

impl TouchPhases {
    fn phase(&mut self, sum: f64) -> Option<f64> {
        let same = |(of, _): &&(f64, f64)| (of - sum).abs() <= f64::EPSILON * sum;
        if let Some((_, phase)) = self.known.iter().find(same) {
            return Some(*phase);
        }
        let phase = touching_phase(sum, self.radius, self.angle)?;
        self.known.push((sum, phase));
        Some(phase)
    }

    /// What the phase is at most: helices are at least cos α of their chord apart.
    fn at_most(&self, sum: f64) -> f64 {
        2.0 * (sum / (2.0 * self.radius * self.angle.cos()))
            .min(1.0)
            .asin()
    }
}

/// The smallest pitch radius on which units of these radii lie side by side, in this order \[m\].
/// One unit alone needs none.
#[must_use]
pub fn smallest_radius(radii: &[f64], angle: f64) -> f64 {
    let Some(first) = radii.first() else {
        return 0.0;
    };
    if radii.len() < 2 {
        return 0.0;
    }
    let alike = radii
        .iter()
        .all(|r| (r - first).abs() <= f64::EPSILON * first);
    if alike {
        return 2.0 * first / helix_distance(TAU / radii.len() as f64, angle);
    }
    let fits = |radius: f64| ring(radii, radius, angle).is_some_and(|ring| ring.taken <= TAU);
    let mut high = radii.iter().sum::<f64>() / angle.cos();
    while !fits(high) && high.is_finite() {
        high *= 2.0;
    }
    let bracket = Bracket { low: 0.0, high };
    bisect(bracket, 50, Bracket::middle, |radius| !fits(radius)).high
}

/// How many units of one radius a pitch radius holds.
#[must_use]
pub fn most(unit: f64, radius: f64, angle: f64) -> usize {
    let Some(phase) = touching_phase(2.0 * unit, radius, angle) else {
        return 1;
    };
    // The factor keeps the count at its smallest radius, against rounding.
    ((TAU / phase * (1.0 + 1e-9)).floor() as usize).min(MOST)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Least distance of two helices by brute force.
    fn by_hand(phase: f64, angle: f64) -> f64 {
        let phase = phase.min(TAU - phase);
        (0..=20_000)
            .map(|i| {
                let theta = -f64::from(i) * phase / 20_000.0;
                let other = (phase + theta).cos();
                (2.0 - 2.0 * other + (theta / angle.tan()).powi(2)).sqrt()
            })
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn helices_are_as_far_apart_as_their_nearest_points() {
        for phase in [0.05, 0.3, 1.0, 2.0, 3.0, PI, 4.0] {
            for degrees in [1.0_f64, 10.0, 20.0, 44.0, 50.0, 60.0] {
                let angle = degrees.to_radians();
                let (ours, other) = (helix_distance(phase, angle), by_hand(phase, angle));
                assert!(
                    ours <= other && (ours / other - 1.0).abs() < 1e-5,
                    "{phase} {degrees}: {ours} {other}"
                );
            }
        }
    }

    #[test]
    fn straight_units_need_the_circle_of_the_polygon() {
        let radius = smallest_radius(&[1.0; 6], 1e-4);
        assert!((radius - 2.0).abs() < 1e-7, "{radius}");
        assert_eq!(most(1.0, radius, 1e-4), 6);
    }

    #[test]
    fn nearly_the_circle_of_costello() {
        let (n, angle) = (9.0, 10f64.to_radians());
        let ours = smallest_radius(&[7.8e-3; 9], angle);
        let ellipses = 7.8e-3 * (1.0 + 1.0 / ((PI / n).tan() * angle.cos()).powi(2)).sqrt();
        assert!((ours / ellipses - 1.0).abs() < 2e-4, "{ours} {ellipses}");
    }

    #[test]
    fn unlike_units_close_the_layer() {
        let radii = [1.0, 0.5, 0.7, 1.2, 0.5];
        let angle = 0.3;
        let radius = smallest_radius(&radii, angle);
        let taken = ring(&radii, radius, angle).unwrap().taken;
        assert!((taken - TAU).abs() < 1e-6, "{taken}");
        assert!(smallest_radius(&[1.0, 0.5], angle) >= 0.75 - 1e-9);
    }

    #[test]
    fn thick_units_meet_over_a_thin_one() {
        let radius = smallest_radius(&[0.01, 1.0, 0.01, 1.0], 1e-3);
        assert!((radius - 1.0).abs() < 1e-6, "{radius}");
        let ring = ring(&[0.01, 1.0, 0.01, 1.0], radius, 1e-3).unwrap();
        assert!((ring.places[3] - ring.places[1]).abs() >= PI - 1e-6);
    }

    #[test]
    fn helices_keep_their_chord_times_the_cosine() {
        for i in 1..=60 {
            for degrees in [0.5_f64, 10.0, 30.0, 45.0, 60.0] {
                let (phase, angle) = (PI * f64::from(i) / 60.0, degrees.to_radians());
                let least = 2.0 * (0.5 * phase).sin() * angle.cos();
                assert!(helix_distance(phase, angle) >= least * (1.0 - 1e-12));
            }
        }
    }
}
