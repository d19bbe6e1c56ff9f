//! An irregular record from a spectrum: regular components of equal energy.

use std::f64::consts::TAU;

use super::{Component, Spectrum};
use crate::numerics::random::Random;

/// A record of this spectrum as `count` components, frequencies rising; the same seed and stream give the same one.
///
/// The spectrum is cut into parts of equal energy. Each part gives one component, its frequency drawn at random
/// within the part (evenly by energy), so that no two frequencies have a common multiple and the record does not
/// repeat; its phase is random. The amplitudes are all `sqrt(2 m0 / count)`, so the variance of an endless record is
/// exactly that of the spectrum. A record of `count` components is as random as a sea can be for statistics of
/// crests when `count` is 100 or more.
///
/// Independent records of one seed, such as the axes of a motion, take different streams.
#[must_use]
pub fn synthesise(spectrum: &Spectrum, count: usize, seed: u64, stream: u64) -> Vec<Component> {
    let mut random = Random::new(seed, stream);
    let drawn: Vec<(f64, f64)> = (0..count)
        .map(|part| {
            let share = (part as f64 + random.uniform()) / count as f64;
            (share, TAU * random.uniform())
        })
        .collect();
    let amplitude = (2.0 * spectrum.variance / count as f64).sqrt();
    let frequencies = spectrum.quantiles(drawn.iter().map(|(share, _)| *share));
    let pairs = frequencies.into_iter().zip(&drawn);
    pairs
        .map(|(omega, (_, phase))| Component {
            omega,
            amplitude,
            phase: *phase,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sea::Moments;

    #[test]
    fn the_same_by_seed_and_of_the_asked_variance() {
        let spectrum = Spectrum::jonswap(5.0, 12.0, 3.3);
        let first = synthesise(&spectrum, 200, 42, 0);
        assert_eq!(first, synthesise(&spectrum, 200, 42, 0));
        assert_ne!(first, synthesise(&spectrum, 200, 43, 0));
        assert_ne!(first, synthesise(&spectrum, 200, 42, 1));
        assert!(first.windows(2).all(|pair| pair[0].omega < pair[1].omega));
        let (made, asked) = (Moments::of_components(&first), spectrum.moments());
        assert!((made.m0 / asked.m0 - 1.0).abs() < 1e-12);
        assert!((made.crossing_period() / asked.crossing_period() - 1.0).abs() < 0.02);
    }

    /// Variance of a record over a time, sampled finely.
    fn variance(record: &[Component], from: f64, to: f64) -> f64 {
        let samples = 4000;
        let value = |i: i32| {
            let t = from + (to - from) * f64::from(i) / f64::from(samples);
            record.iter().map(|c| c.at(t)).sum::<f64>()
        };
        (0..samples).map(|i| value(i).powi(2)).sum::<f64>() / f64::from(samples)
    }

    #[test]
    fn windows_of_a_record_scatter_as_a_sea_does_and_differ() {
        let spectrum = Spectrum::jonswap(4.0, 10.0, 3.3);
        let record = synthesise(&spectrum, 300, 5, 0);
        // A Gaussian record's variance over a window T has itself the variance (2 pi / T) int S² dω.
        let windows: Vec<f64> = (0..40)
            .map(|i| variance(&record, 1800.0 * f64::from(i), 1800.0 * f64::from(i + 1)))
            .collect();
        let mean = windows.iter().sum::<f64>() / 40.0;
        let n = 4000;
        let width = 5.0 * spectrum.peak / f64::from(n);
        let square: f64 = (1..n)
            .map(|i| spectrum.density(width * f64::from(i)).powi(2) * width)
            .sum();
        let expected = (TAU / 1800.0 * square).sqrt();
        let scatter = (windows.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / 39.0).sqrt();
        assert!(
            (mean - 1.0).abs() < 4.0 * expected / 40_f64.sqrt(),
            "{mean}"
        );
        // Forty windows know their scatter to about 11 %.
        assert!(
            (scatter / expected - 1.0).abs() < 0.45,
            "{scatter} {expected}"
        );
    }
}
