//! Displacements of the nodes about their mean positions: root mean squares and, where the line is driven at one period,
//! amplitude and phase at that period. Memory grows with the nodes, not with the time.
//!
//! Amplitude and phase are those across the line in the plane of its mean shape, by complex demodulation: with
//! `u(t) = Re(a e^(i omega t))`, `a = 2 <(u - mean u) e^(-i omega t)>` over the output times. A wave that runs towards end B
//! has `a ~ e^(-iks)`, one towards end A `a ~ e^(iks)`, a standing one the same phase all along but for its sign.

use std::f64::consts::TAU;
use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::Profile;
use crate::case::{Case, EndKind};
use crate::modes::LinePlane;
use crate::numerics::V3;

/// What is asked for of the response.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AskedResponse {
    /// Time from which on it is taken \[s\].
    pub from: f64,
    /// The one period at which the lines are driven \[s\]; nothing where there is none, or several.
    pub period: Option<f64>,
}

impl AskedResponse {
    /// By a case; nothing where it does not ask.
    #[must_use]
    pub fn of_case(case: &Case) -> Option<Self> {
        Some(Self {
            from: case.output.response_from_s?,
            period: period(case),
        })
    }
}

/// Sums over the output times from a given one on.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ResponseSums {
    from: f64,
    omega: Option<f64>,
    count: f64,
    /// Places at the first of these times, from which the sums are taken so that they lose no digits.
    origin: Vec<V3>,
    sum: Vec<V3>,
    squares: Vec<f64>,
    /// The same in the plane of x and y, and along z.
    #[serde(default)]
    squares_by_plane: Vec<[f64; 2]>,
    cos: Vec<V3>,
    sin: Vec<V3>,
    /// Sums of the cosines and sines themselves, for windows of no whole number of periods.
    turns: (f64, f64),
}

impl ResponseSums {
    /// Before the first of these times.
    pub(super) fn new(asked: AskedResponse) -> Self {
        Self {
            from: asked.from,
            omega: asked.period.map(|period| TAU / period),
            ..Self::default()
        }
    }

    /// Whether nothing was to be taken in up to this time.
    pub(super) fn begins_after(&self, time: f64) -> bool {
        self.from > time
    }

    /// Whether they are those of so many nodes, or of none yet.
    pub(super) fn fits(&self, nodes: usize) -> bool {
        let [a, b, c, d] = [&self.origin, &self.sum, &self.cos, &self.sin].map(Vec::len);
        let (e, f) = (self.squares.len(), self.squares_by_plane.len());
        let sizes = [a, b, c, d, e, f];
        sizes == [nodes; 6] || sizes == [0; 6]
    }

    /// Takes in the nodes at an output time.
    pub(super) fn add(&mut self, time: f64, nodes: &[V3]) {
        if time < self.from * (1.0 - 1e-12) {
            return;
        }
        if self.origin.is_empty() {
            let n = nodes.len();
            self.origin = nodes.to_vec();
            self.sum = vec![V3::zeros(); n];
            self.cos = vec![V3::zeros(); n];
            self.sin = vec![V3::zeros(); n];
            self.squares = vec![0.0; n];
            self.squares_by_plane = vec![[0.0; 2]; n];
        }
        let (sin, cos) = (self.omega.unwrap_or(0.0) * time).sin_cos();
        self.count += 1.0;
        self.turns.0 += cos;
        self.turns.1 += sin;
        for (i, (x, origin)) in nodes.iter().zip(&self.origin).enumerate() {
            let u = x - origin;
            self.sum[i] += u;
            self.squares[i] += u.norm_squared();
            let [horizontal, vertical] = &mut self.squares_by_plane[i];
            *horizontal += u.xy().norm_squared();
            *vertical += u.z * u.z;
            self.cos[i] += u * cos;
            self.sin[i] += u * sin;
        }
    }

    /// Writes the outcome of the nodes of a line into its profile; `diameters` are those of the nodes \[m\].
    pub(super) fn finish(&self, nodes: Range<usize>, diameters: &[f64], profile: &mut Profile) {
        if self.count < 2.0 || self.sum.len() < nodes.end {
            return;
        }
        let mean: Vec<V3> = self.sum[nodes.clone()]
            .iter()
            .map(|s| s / self.count)
            .collect();
        profile.rms = mean
            .iter()
            .zip(&self.squares[nodes.clone()])
            .map(|(m, s)| (s / self.count - m.norm_squared()).max(0.0).sqrt())
            .collect();
        let by_diameter = profile.rms.iter().zip(diameters);
        profile.rms_diameters = by_diameter.map(|(rms, d)| rms / d).collect();
        let by_plane = |plane: usize, of_mean: fn(&V3) -> f64| -> Vec<f64> {
            let squares = &self.squares_by_plane[nodes.clone()];
            let sums = mean.iter().zip(squares).zip(diameters);
            let rms = |((m, s), d): ((&V3, &[f64; 2]), &f64)| {
                (s[plane] / self.count - of_mean(m)).max(0.0).sqrt() / d
            };
            sums.map(rms).collect()
        };
        profile.rms_horizontal = by_plane(0, |m| m.xy().norm_squared());
        profile.rms_vertical = by_plane(1, |m| m.z * m.z);
        let origin = &self.origin[nodes.clone()];
        let places: Vec<V3> = mean.iter().zip(origin).map(|(m, o)| m + o).collect();
        let across = LinePlane::nearest_to(&places).across(&places);
        let share = 2.0 / self.count;
        let demodulated = |sums: &[V3], turn: f64| -> Vec<f64> {
            let all = sums.iter().zip(&mean).enumerate();
            all.map(|(i, (sum, m))| (sum - m * turn).dot(&across[i]) * share)
                .collect()
        };
        if self.omega.is_some() {
            profile.wave_cos = demodulated(&self.cos[nodes.clone()], self.turns.0);
            let sin = demodulated(&self.sin[nodes], self.turns.1);
            // e^(-i omega t): the imaginary part is minus the sine's.
            profile.wave_sin = sin.into_iter().map(|s| -s).collect();
        } else {
            profile.wave_cos = vec![0.0; places.len()];
            profile.wave_sin = vec![0.0; places.len()];
        }
    }
}

/// The one period \[s\] at which the line is driven: that of regular waves, or of an end that moves.
#[must_use]
pub fn period(case: &Case) -> Option<f64> {
    let waves = case.waves.as_ref().and_then(|waves| waves.period_s);
    let moving = [&case.ends.a, &case.ends.b].into_iter().find_map(|end| {
        let moves = end.kind == EndKind::Moving;
        end.period_s.filter(|_| moves)
    });
    waves.or(moving)
}

/// How much of the motion travels, -1 to 1, on nodes at these arc lengths with this amplitude at the driving period: with
/// D the amplitude of what runs towards end A and U of what runs towards end B, `(D² - U²) / (D² + U²)`; 0 of a standing
/// wave. Taken from the flux: `<Im(a* a')> / sqrt(<|a|²> <|a'|²>)`, exact for an even line over whole waves.
pub(super) fn travelling(arc: &[f64], cos: &[f64], sin: &[f64]) -> Option<f64> {
    if arc.len() < 3 || cos.len() != arc.len() || sin.len() != arc.len() {
        return None;
    }
    let (mut flux, mut size, mut slope) = (0.0, 0.0, 0.0);
    for i in 1..arc.len() {
        let step = arc[i] - arc[i - 1];
        if step <= 0.0 {
            continue;
        }
        let (c, s) = (0.5 * (cos[i] + cos[i - 1]), 0.5 * (sin[i] + sin[i - 1]));
        let (dc, ds) = ((cos[i] - cos[i - 1]) / step, (sin[i] - sin[i - 1]) / step);
        flux += (c * ds - s * dc) * step;
        size += (c * c + s * s) * step;
        slope += (dc * dc + ds * ds) * step;
    }
    let whole = (size * slope).sqrt();
    (whole > 0.0).then(|| flux / whole)
}

/// Peaks and valleys of the response along a line: arc length \[m\], value, and whether it is a peak. Ripples of less than
/// 1 % of the range are left out, as are the ends.
#[must_use]
pub fn peaks_and_valleys(arc: &[f64], values: &[f64]) -> Vec<(f64, f64, bool)> {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let small = 0.01 * (high - low);
    let mut found = Vec::new();
    let (mut top, mut bottom) = (0, 0);
    let mut rising = None;
    for (i, value) in values.iter().enumerate() {
        if *value > values[top] {
            top = i;
        }
        if *value < values[bottom] {
            bottom = i;
        }
        if rising != Some(false) && values[top] - value > small {
            if rising.is_some() {
                found.push((arc[top], values[top], true));
            }
            (rising, bottom, top) = (Some(false), i, i);
        } else if rising != Some(true) && value - values[bottom] > small {
            if rising.is_some() {
                found.push((arc[bottom], values[bottom], false));
            }
            (rising, bottom, top) = (Some(true), i, i);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn string() -> (Vec<f64>, Vec<V3>) {
        let arc: Vec<f64> = (0..=400).map(|i| f64::from(i) * 0.25).collect();
        let places = arc.iter().map(|s| V3::new(*s, 0.0, 0.0)).collect();
        (arc, places)
    }

    /// Two waves on a string of 100 m, five waves long, of period 10 s, the one towards A of 2 and the one towards B of
    /// `back`.
    fn driven(back: f64) -> (Vec<f64>, Profile) {
        let (arc, places) = string();
        let k = TAU / 20.0;
        let mut response = ResponseSums {
            from: 20.0,
            omega: Some(TAU / 10.0),
            ..ResponseSums::default()
        };
        for n in 0..1000 {
            let t = f64::from(n) * 0.1;
            let phase = TAU / 10.0 * t;
            let nodes: Vec<V3> = places
                .iter()
                .map(|p| {
                    let u = 2.0 * (phase + k * p.x).cos() + back * (phase - k * p.x).cos();
                    p + V3::z() * (u + 7.0)
                })
                .collect();
            response.add(t, &nodes);
        }
        let mut profile = Profile::default();
        response.finish(0..arc.len(), &vec![0.5; arc.len()], &mut profile);
        (arc, profile)
    }

    #[test]
    fn root_mean_squares_are_about_the_mean() {
        let (_, profile) = driven(0.0);
        for (rms, by_diameter) in profile.rms.iter().zip(&profile.rms_diameters) {
            assert!((rms - 2.0_f64.sqrt()).abs() < 1e-9);
            assert!((by_diameter - 2.0 * rms).abs() < 1e-12);
        }
    }

    #[test]
    fn displacements_along_z_and_across_it_are_apart() {
        let mut response = ResponseSums::default();
        for n in 0..1000 {
            let phase = TAU * 0.01 * f64::from(n);
            let turning = V3::new(3.0 * phase.cos(), 4.0 * phase.cos(), 2.0 * phase.sin());
            response.add(f64::from(n), &[turning + V3::new(1.0, 2.0, 3.0), V3::x()]);
        }
        let mut profile = Profile::default();
        response.finish(0..2, &[0.5, 0.5], &mut profile);
        let root = 0.5_f64.sqrt() / 0.5;
        assert!((profile.rms_horizontal[0] - 5.0 * root).abs() < 1e-9);
        assert!((profile.rms_vertical[0] - 2.0 * root).abs() < 1e-9);
        let both = profile.rms_horizontal[0].hypot(profile.rms_vertical[0]);
        assert!((both - profile.rms_diameters[0]).abs() < 1e-9);
        assert_eq!(
            (profile.rms_horizontal[1], profile.rms_vertical[1]),
            (0.0, 0.0)
        );
    }

    #[test]
    fn travelling_and_standing_waves_are_distinguished() {
        for back in [0.0, 0.5, 1.0, 2.0, 5.0] {
            let (arc, profile) = driven(back);
            let expected = (4.0 - back * back) / (4.0 + back * back);
            let share = travelling(&arc, &profile.wave_cos, &profile.wave_sin).unwrap();
            assert!(
                (share - expected).abs() < 1e-3,
                "{back}: {share} {expected}"
            );
            let most = profile.wave_cos.iter().zip(&profile.wave_sin);
            let most = most.map(|(c, s)| c.hypot(*s)).fold(0.0, f64::max);
            assert!((most - 2.0 - back).abs() < 1e-3 * (2.0 + back));
        }
    }

    #[test]
    fn peaks_and_valleys_in_their_order() {
        let arc = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
        let found = peaks_and_valleys(&arc, &[0.0, 5.0, 2.0, 2.01, 8.0, 1.0]);
        assert_eq!(
            found,
            [(1.0, 5.0, true), (2.0, 2.0, false), (4.0, 8.0, true)]
        );
        assert!(peaks_and_valleys(&[], &[]).is_empty());
    }
}
