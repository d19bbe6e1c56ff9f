//! Decomposition of a response at one period into the two waves of opposite direction.
//!
//! Around every place, the complex amplitude `a = cos + i sin` of [`response`](super::response) is fitted by least squares
//! over half a local wave by `A (D e^(i phase) + U e^(-i phase))`, with the phase and the amplitude A that WKB theory gives
//! the line at rest ([`wave_number`](crate::modes::wave_number)): D runs towards end A, U towards end B. With the greatest size D + U and the
//! least |D - U| of what both make together, their standing wave ratio is `(D + U) / |D - U|` (Pozar 2012, section 2.3, for
//! lines of any kind): 1 for a travelling wave, infinite for a standing one. Where loads act on the line or it
//! bends sharply, a fit says what the motion is most like.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::Profile;
use crate::modes::{WkbMedium, WkbWave};
use crate::scene::Scene;
use crate::statics::equilibrium::EquilibriumSearch;

/// The two waves around a place.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct OpposingWaves {
    /// Amplitude of what runs towards end A \[m\].
    pub(super) towards_a: f64,
    /// Amplitude of what runs towards end B \[m\].
    pub(super) towards_b: f64,
    /// Wave number of the response itself \[1/m\]: root of the mean square of its slope by that of its size, over a whole
    /// wave; 0 where nothing moves.
    pub(super) number: f64,
}

/// A line by itself at rest; none where it has no equilibrium, or is slack somewhere.
pub(super) fn at_rest(scene: &Scene) -> Option<WkbMedium> {
    let mut rest = scene.initial_state();
    let found = EquilibriumSearch::default().run(scene, 0.0, &mut rest);
    found.ok()?;
    WkbMedium::of_line_at_rest(scene, &rest)
}

/// Writes into the profile WKB wave number and amplitude of the line at rest at the driving period \[s\], and both waves. Changes
/// nothing where the response was not recorded.
pub(super) fn decompose_response(medium: &WkbMedium, period: f64, profile: &mut Profile) {
    if profile.wave_cos.is_empty() {
        return;
    }
    let wave = medium.wave(TAU / period);
    if let Some(found) = decompose(&medium.arc, &profile.wave_cos, &profile.wave_sin, &wave) {
        profile.towards_a = found.iter().map(|o| o.towards_a).collect();
        profile.towards_b = found.iter().map(|o| o.towards_b).collect();
        profile.wave_number = found.iter().map(|o| o.number).collect();
    }
    profile.wkb_number = wave.number;
    profile.wkb_amplitude = wave.amplitude;
}

/// Standing wave ratio of the mean amplitudes of both waves along a line or a stretch of it.
pub(super) fn standing_wave_ratio(towards_a: f64, towards_b: f64) -> Option<f64> {
    let (whole, rest) = (towards_a + towards_b, (towards_a - towards_b).abs());
    (rest > 0.0).then(|| whole / rest)
}

/// Fits both waves around every node, at these arc lengths \[m\]; nothing where the line is shorter than half a wave.
pub(super) fn decompose(
    arc: &[f64],
    cos: &[f64],
    sin: &[f64],
    wave: &WkbWave,
) -> Option<Vec<OpposingWaves>> {
    let whole = *wave.phase.last()?;
    let same = [cos.len(), sin.len(), wave.phase.len()]
        .iter()
        .all(|n| *n == arc.len());
    if !same || !whole.is_finite() || whole < PI {
        return None;
    }
    let a: Vec<Complex<f64>> = cos
        .iter()
        .zip(sin)
        .map(|(c, s)| Complex::new(*c, *s))
        .collect();
    let all = (0..arc.len()).map(|i| {
        let (from, to) = around(wave, i, PI);
        let (down, up) = fit(arc, &a, wave, i, from..to + 1);
        let (from, to) = around(wave, i, TAU.min(whole));
        OpposingWaves {
            towards_a: down.norm() * wave.amplitude[i],
            towards_b: up.norm() * wave.amplitude[i],
            number: number(&arc[from..=to], &a[from..=to]),
        }
    });
    Some(all.collect())
}

/// First and last node of the stretch of so much phase around a node, moved inwards at the ends of the line.
fn around(wave: &WkbWave, node: usize, phase: f64) -> (usize, usize) {
    let last = wave.phase.len() - 1;
    let whole = wave.phase[last];
    let from = (wave.phase[node] - 0.5 * phase).clamp(0.0, (whole - phase).max(0.0));
    let first = wave.phase.partition_point(|p| *p < from - 1e-9);
    let end = wave.phase.partition_point(|p| *p <= from + phase + 1e-9);
    (
        first.min(last),
        end.saturating_sub(1).clamp(first.min(last), last),
    )
}

/// Both amplitudes by least squares, each node weighing as its share of the arc length.
fn fit(
    arc: &[f64],
    a: &[Complex<f64>],
    wave: &WkbWave,
    node: usize,
    stretch: std::ops::Range<usize>,
) -> (Complex<f64>, Complex<f64>) {
    let (mut weight, mut mixed) = (0.0, Complex::<f64>::default());
    let (mut down, mut up) = (Complex::<f64>::default(), Complex::<f64>::default());
    let last = arc.len() - 1;
    for j in stretch {
        let share = 0.5 * (arc[(j + 1).min(last)] - arc[j.saturating_sub(1)]);
        let turn = Complex::from_polar(1.0, wave.phase[j] - wave.phase[node]);
        let size = wave.amplitude[j];
        weight += share * size * size;
        mixed += turn.conj() * turn.conj() * (share * size * size);
        down += a[j] * turn.conj() * (share * size);
        up += a[j] * turn * (share * size);
    }
    let determinant = weight * weight - mixed.norm_sqr();
    if determinant <= 1e-12 * weight * weight {
        return (Complex::default(), Complex::default());
    }
    (
        (down * weight - mixed * up) / determinant,
        (up * weight - mixed.conj() * down) / determinant,
    )
}

fn number(arc: &[f64], a: &[Complex<f64>]) -> f64 {
    let (mut slope, mut size) = (0.0, 0.0);
    for (s, a) in arc.windows(2).zip(a.windows(2)) {
        let step = s[1] - s[0];
        if step > 0.0 {
            slope += (a[1] - a[0]).norm_sqr() / step;
            // The mean square of what is straight in between.
            size += step * (a[0].norm_sqr() + a[1].norm_sqr() + (a[0] * a[1].conj()).re) / 3.0;
        }
    }
    if size > 0.0 {
        (slope / size).sqrt()
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modes::WkbMedium;

    /// Two waves on a line whose tension grows fivefold.
    fn response(down: f64, up: f64) -> (Vec<f64>, Vec<f64>, Vec<f64>, WkbWave) {
        let arc: Vec<f64> = (0..=600).map(f64::from).collect();
        let medium = WkbMedium {
            tension: arc.iter().map(|s| 1e3 + 8.0 * s).collect(),
            ei: vec![0.0; 601],
            mass: vec![4.0; 601],
            arc: arc.clone(),
        };
        let wave = medium.wave(TAU / 10.0);
        let at = |i: usize| {
            let turn = Complex::from_polar(1.0, wave.phase[i]);
            (turn * down + turn.conj() * up) * wave.amplitude[i]
        };
        let all: Vec<Complex<f64>> = (0..601).map(at).collect();
        let cos = all.iter().map(|a| a.re).collect();
        let sin = all.iter().map(|a| a.im).collect();
        (arc, cos, sin, wave)
    }

    #[test]
    fn opposing_waves_are_separated_everywhere() {
        for (down, up) in [(2.0, 0.0), (2.0, 0.5), (1.0, 1.0), (0.3, 1.7)] {
            let (arc, cos, sin, wave) = response(down, up);
            let found = decompose(&arc, &cos, &sin, &wave).unwrap();
            for (here, amplitude) in found.iter().zip(&wave.amplitude) {
                assert!((here.towards_a - down * amplitude).abs() < 1e-9, "{here:?}");
                assert!((here.towards_b - up * amplitude).abs() < 1e-9, "{here:?}");
            }
        }
    }

    #[test]
    fn the_response_has_its_own_wave_number() {
        let (arc, cos, sin, wave) = response(2.0, 0.5);
        let found = decompose(&arc, &cos, &sin, &wave).unwrap();
        // Over a whole wave the number changes, and its mean is that of the middle to second order.
        for (here, expected) in found.iter().zip(&wave.number).take(400).skip(200) {
            let off = here.number / expected - 1.0;
            assert!(off.abs() < 0.05, "{off}");
        }
    }

    #[test]
    fn less_than_half_a_wave_is_not_decomposed() {
        let (arc, cos, sin, mut wave) = response(1.0, 1.0);
        wave.phase.iter_mut().for_each(|p| *p *= 0.1);
        assert!(decompose(&arc, &cos, &sin, &wave).is_none());
    }
}
