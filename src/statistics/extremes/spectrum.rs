//! Spectral density of a record by Welch's method, with its confidence and its moments.

use std::f64::consts::TAU;

use super::error::{ExtremesError, check_finite, check_probability};
use super::moments::check_step;
use super::special::chi_squared_quantile;
use super::spectral_moments::SpectralMoments;
use crate::numerics::fourier::transform;
use crate::numerics::statistics::mean;

/// One-sided spectral density.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralDensity {
    /// Between frequencies, in Hz; the first is zero.
    pub frequency_step: f64,
    /// Density at each frequency, in the square of the unit of the record per Hz.
    pub density: Vec<f64>,
    /// Segments averaged.
    pub segments: usize,
    /// Degrees of freedom of a density.
    pub freedom: f64,
}

/// Spectral density of a record of `step` seconds between its values: mean of the squared transforms of segments that overlap by
/// half, each less its mean and times Hann's window (Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70). Values after the last
/// whole segment are left out. The length of a segment is [`segment_length`] unless given.
///
/// # Errors
/// Where the record has fewer than 8 values or one that is not finite or too great to be squared, the step is not above zero, or the segment is not from 8
/// to the number of values.
pub fn welch(
    values: &[f64],
    step: f64,
    segment: Option<usize>,
) -> Result<SpectralDensity, ExtremesError> {
    check_finite(values, 8)?;
    check_step(step)?;
    let length = segment.unwrap_or_else(|| segment_length(values.len()));
    if length < 8 || length > values.len() {
        return Err(ExtremesError::OutOfRange {
            name: "the length of a segment",
            value: length as f64,
            range: "from 8 to the number of values",
        });
    }
    let window = hann(length);
    let power: f64 = window.iter().map(|w| w * w).sum();
    let hop = length - length / 2;
    let mut density = vec![0.0; length / 2 + 1];
    let mut segments = 0;
    let (mut windowed, mut spectrum) = (Vec::with_capacity(length), Vec::new());
    for start in (0..=values.len() - length).step_by(hop) {
        let Some(part) = values.get(start..start + length) else {
            break;
        };
        let centre = mean(part);
        windowed.clear();
        windowed.extend(part.iter().zip(&window).map(|(v, w)| (v - centre) * w));
        transform(&mut windowed, &mut spectrum);
        for (sum, z) in density.iter_mut().zip(&spectrum) {
            *sum += z.norm_sqr();
        }
        segments += 1;
    }
    let scale = step / (power * segments as f64);
    for (k, sum) in density.iter_mut().enumerate() {
        // Zero and the Nyquist frequency have no negative counterpart.
        let sides = if k == 0 || 2 * k == length { 1.0 } else { 2.0 };
        *sum *= sides * scale;
    }
    if density.iter().any(|d| !d.is_finite()) {
        return Err(too_great(values));
    }
    Ok(SpectralDensity {
        frequency_step: 1.0 / (step * length as f64),
        density,
        segments,
        freedom: freedom(&window, hop, segments),
    })
}

/// The value whose square is beyond what a number can hold.
fn too_great(values: &[f64]) -> ExtremesError {
    let greatest = values
        .iter()
        .enumerate()
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    ExtremesError::NotFinite {
        index: greatest.map_or(0, |(index, _)| index),
    }
}

/// The length of a segment that makes about eight of a record of so many values: even, a product of 2, 3 and 5 so that it is
/// transformed quickly. A longer one resolves more, a shorter one scatters less.
#[must_use]
pub fn segment_length(count: usize) -> usize {
    let most = (2 * count / 9).max(8).min(count);
    let smooth = |length: usize| {
        [2, 3, 5].iter().fold(length, |mut rest, factor| {
            while rest.is_multiple_of(*factor) && rest > 0 {
                rest /= factor;
            }
            rest
        }) == 1
    };
    (8..=most)
        .rev()
        .find(|l| l.is_multiple_of(2) && smooth(*l))
        .unwrap_or(most)
}

/// Hann's window, periodic.
fn hann(length: usize) -> Vec<f64> {
    let at = |k: usize| 0.5 - 0.5 * (TAU * k as f64 / length as f64).cos();
    (0..length).map(at).collect()
}

/// Degrees of freedom of the mean of overlapping segments (Welch 1967): twice their number, less what neighbours share.
fn freedom(window: &[f64], hop: usize, segments: usize) -> f64 {
    let power: f64 = window.iter().map(|w| w * w).sum();
    let shared = |shift: usize| {
        let product: f64 = window
            .iter()
            .zip(window.iter().skip(shift))
            .map(|(a, b)| a * b)
            .sum();
        (product / power).powi(2)
    };
    let n = segments as f64;
    let sum: f64 = (1..segments)
        .take_while(|j| j * hop < window.len())
        .map(|j| (1.0 - j as f64 / n) * shared(j * hop))
        .sum();
    2.0 * n / (1.0 + 2.0 * sum)
}

impl SpectralDensity {
    /// Factors on a density that give its interval at a level of confidence: `(freedom/chi2, freedom/chi2)`, chi-squared at both
    /// tails (Bendat and Piersol, Random Data, 2010, section 8.5.3).
    ///
    /// # Errors
    /// Where the level is not between 0 and 1.
    pub fn confidence(&self, level: f64) -> Result<(f64, f64), ExtremesError> {
        check_probability("the level", level)?;
        let tail = 0.5 * (1.0 - level);
        let at = |p| self.freedom / chi_squared_quantile(self.freedom, p);
        Ok((at(1.0 - tail), at(tail)))
    }

    /// Frequency of the greatest density, in Hz.
    #[must_use]
    pub fn peak_frequency(&self) -> f64 {
        let best = self
            .density
            .iter()
            .enumerate()
            .max_by(|a, b| a.1.total_cmp(b.1));
        best.map_or(0.0, |(k, _)| k as f64 * self.frequency_step)
    }

    /// Moments up to a greatest frequency in Hz, which may be infinite.
    #[must_use]
    pub fn moments(&self, greatest: f64) -> SpectralMoments {
        let mut moments = SpectralMoments::default();
        for (k, density) in self.density.iter().enumerate() {
            let f = k as f64 * self.frequency_step;
            if f > greatest {
                break;
            }
            let part = density * self.frequency_step;
            moments.m0 += part;
            moments.m1 += part * f;
            moments.m2 += part * f * f;
            moments.m4 += part * f.powi(4);
        }
        moments
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    fn noise(count: usize, seed: u64) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        (0..count)
            .map(|_| 12.0_f64.sqrt() * (random.uniform() - 0.5))
            .collect()
    }

    /// The sum over frequencies is the mean square of the windowed values over that of the window.
    #[test]
    fn parseval() {
        for length in [16, 30, 45] {
            let values = noise(length, 4);
            let spectrum = welch(&values, 0.3, Some(length)).unwrap();
            let (window, centre) = (hann(length), mean(&values));
            let squares: f64 = values
                .iter()
                .zip(&window)
                .map(|(v, w)| ((v - centre) * w).powi(2))
                .sum();
            let power: f64 = window.iter().map(|w| w * w).sum();
            let m0 = spectrum.moments(f64::INFINITY).m0;
            assert!((m0 - squares / power).abs() < 1e-13, "{length}");
        }
    }

    #[test]
    fn a_sine_has_its_variance_and_its_frequency() {
        let values: Vec<f64> = (0..6000)
            .map(|k| 5.0 + 2.0 * (TAU * 0.125 * 0.25 * f64::from(k)).sin())
            .collect();
        let spectrum = welch(&values, 0.25, Some(640)).unwrap();
        let moments = spectrum.moments(f64::INFINITY);
        assert!((spectrum.peak_frequency() - 0.125).abs() < 1e-12);
        assert!((moments.m0 - 2.0).abs() < 1e-10);
        assert!((moments.zero_crossing_period().unwrap() - 8.0).abs() < 0.01);
        assert!((moments.mean_period().unwrap() - 8.0).abs() < 0.01);
        assert!(moments.bandwidth().unwrap() < 0.1 && moments.narrowness().unwrap() < 0.1);
    }

    /// White noise of variance 1 has density 2 step: the interval holds it as often as it says.
    #[test]
    fn the_interval_covers() {
        let (mut held, mut tried) = (0.0, 0.0);
        for seed in 0..40 {
            let spectrum = welch(&noise(1440, seed), 0.5, Some(320)).unwrap();
            assert_eq!(spectrum.segments, 8);
            let (low, high) = spectrum.confidence(0.9).unwrap();
            // Every third frequency: neighbours share the window.
            for density in spectrum.density.iter().skip(3).step_by(3).take(50) {
                held += f64::from(u8::from(density * low < 1.0 && 1.0 < density * high));
                tried += 1.0;
            }
        }
        assert!((held / tried - 0.9_f64).abs() < 0.02, "{}", held / tried);
    }

    #[test]
    fn freedom_of_half_overlap() {
        // Neighbours of Hann's window share 1/36 of the variance.
        let spectrum = welch(&noise(1440, 1), 0.5, Some(320)).unwrap();
        let exact = 16.0 / (1.0 + 2.0 * (7.0 / 8.0) / 36.0);
        assert!((spectrum.freedom - exact).abs() < 1e-10);
    }

    #[test]
    fn segments_and_bad_records() {
        assert_eq!(segment_length(1440), 320);
        for count in 8..400 {
            let length = segment_length(count);
            assert!(length >= 8 && length <= count);
            assert!(welch(&noise(count, 2), 1.0, None).is_ok());
        }
        assert!(welch(&noise(7, 1), 1.0, None).is_err());
        assert!(welch(&noise(20, 1), 1.0, Some(21)).is_err());
        assert!(welch(&noise(20, 1), f64::NAN, None).is_err());
        let flat = welch(&[3.0; 64], 1.0, None).unwrap().moments(f64::INFINITY);
        assert_eq!(flat.m0, 0.0);
        assert!(flat.zero_crossing_period().is_err() && flat.bandwidth().is_err());
    }
}
