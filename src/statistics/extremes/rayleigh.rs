//! Peaks of a narrow-band Gaussian process in closed form: Rayleigh's law.
//!
//! Rice, Bell Syst. Tech. J. 23 (1944) 282; Cartwright and Longuet-Higgins, Proc. R. Soc. A 237 (1956) 212. Peaks are counted as
//! independent, which makes the greatest slightly too great where they come in groups.

use std::f64::consts::PI;

use super::error::{ExtremesError, check_inside, check_probability};
use super::spectral_moments::SpectralMoments;
use super::target::{EULER, ExponentialMaximum};

/// A stationary narrow-band Gaussian process.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NarrowBand {
    /// Mean, in the unit of the record.
    pub mean: f64,
    /// Standard deviation, in the unit of the record.
    pub deviation: f64,
    /// Upward crossings of the mean per second.
    pub rate: f64,
}

impl NarrowBand {
    /// Of a deviation and a rate above zero.
    ///
    /// # Errors
    /// Where a number is not finite or not above zero.
    pub fn new(mean: f64, deviation: f64, rate: f64) -> Result<Self, ExtremesError> {
        super::error::check_finite(&[mean], 1)?;
        check_inside("the deviation", deviation, (0.0, f64::INFINITY), "above 0")?;
        check_inside(
            "the crossing rate",
            rate,
            (0.0, f64::INFINITY),
            "above 0 /s",
        )?;
        Ok(Self {
            mean,
            deviation,
            rate,
        })
    }

    /// Of a spectrum: deviation `sqrt(m0)`, rate `sqrt(m2/m0)` (Rice's formula).
    ///
    /// # Errors
    /// Where the spectrum is empty.
    pub fn of_spectrum(mean: f64, moments: &SpectralMoments) -> Result<Self, ExtremesError> {
        Self::new(mean, moments.m0.sqrt(), (moments.m2 / moments.m0).sqrt())
    }

    /// Upward crossings of a level per second, `rate exp(-u^2/2)` at `u` deviations from the mean.
    #[must_use]
    pub fn crossing_rate(&self, level: f64) -> f64 {
        let u = (level - self.mean) / self.deviation;
        self.rate * (-0.5 * u * u).exp()
    }

    /// Mean peak: `sqrt(pi/2)` deviations above the mean.
    #[must_use]
    pub fn mean_peak(&self) -> f64 {
        self.mean + self.deviation * (0.5 * PI).sqrt()
    }

    /// Peaks in so many seconds, one for each upward crossing of the mean.
    #[must_use]
    pub fn peaks(&self, seconds: f64) -> f64 {
        self.rate * seconds
    }

    /// Most probable greatest of so many peaks: `sqrt(2 ln N)` deviations above the mean, for N large.
    ///
    /// # Errors
    /// Where the number of peaks is not above 1.
    pub fn most_probable(&self, peaks: f64) -> Result<f64, ExtremesError> {
        check_peaks(peaks)?;
        Ok(self.mean + self.deviation * (2.0 * peaks.ln()).sqrt())
    }

    /// Expected greatest of so many independent peaks, exact: the integral of `1 - (1 - exp(-u^2/2))^N`.
    ///
    /// # Errors
    /// Where the number of peaks is not above 1.
    pub fn expected(&self, peaks: f64) -> Result<f64, ExtremesError> {
        check_peaks(peaks)?;
        let root = ExponentialMaximum::of_count(peaks).ln_moment(0.5).0.exp();
        Ok(self.mean + self.deviation * 2.0_f64.sqrt() * root)
    }

    /// The same for N large, `c + 0.5772/c` deviations with `c = sqrt(2 ln N)`.
    ///
    /// # Errors
    /// Where the number of peaks is not above 1.
    pub fn expected_asymptotic(&self, peaks: f64) -> Result<f64, ExtremesError> {
        check_peaks(peaks)?;
        let c = (2.0 * peaks.ln()).sqrt();
        Ok(self.mean + self.deviation * (c + EULER / c))
    }

    /// The value that the greatest of so many independent peaks stays below with a probability.
    ///
    /// # Errors
    /// Where the number of peaks is not above 1, or the probability not between 0 and 1.
    pub fn quantile(&self, probability: f64, peaks: f64) -> Result<f64, ExtremesError> {
        check_peaks(peaks)?;
        check_probability("the probability", probability)?;
        let exceedance = -(probability.ln() / peaks).exp_m1();
        Ok(self.mean + self.deviation * (-2.0 * exceedance.ln()).sqrt())
    }
}

fn check_peaks(peaks: f64) -> Result<(), ExtremesError> {
    check_inside("the number of peaks", peaks, (1.0, 1e15), "above 1")
}

#[cfg(test)]
mod tests {
    use super::super::peaks::global_maxima;
    use super::super::spectrum::welch;
    use super::super::target::ExtremesTarget;
    use super::super::weibull::WeibullFit;
    use super::*;
    use crate::numerics::random::Random;
    use crate::numerics::statistics::{Statistics, mean};

    /// A Gaussian record of deviation 1: harmonics of normal amplitudes about 0.1 Hz, three in a hundred wide.
    fn record(seed: u64, count: usize) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        let mut values = vec![0.0; count];
        let width = 0.003;
        for i in -60..=60 {
            let off = 0.05 * f64::from(i);
            // Frequencies shaken, so that the record does not repeat.
            let frequency = 0.1 + width * (off + 0.05 * (random.uniform() - 0.5));
            let weight = (0.05 * (-0.5 * off * off).exp() / (2.0 * PI).sqrt()).sqrt();
            let amplitude = weight * (-4.0 * random.uniform().ln()).sqrt();
            let phase = 2.0 * PI * random.uniform();
            for (k, value) in values.iter_mut().enumerate() {
                *value += amplitude * (2.0 * PI * frequency * 0.5 * k as f64 + phase).cos();
            }
        }
        values
    }

    #[test]
    fn closed_forms_agree_with_one_another() {
        let process = NarrowBand::new(2.0, 3.0, 0.1).unwrap();
        assert!((process.expected(1.0 + 1e-12).unwrap() - process.mean_peak()).abs() < 1e-9);
        assert!((process.crossing_rate(2.0) - 0.1).abs() < 1e-15);
        // One crossing is left in the time of N at the most probable greatest.
        let most = process.most_probable(1000.0).unwrap();
        assert!((process.crossing_rate(most) * 1e4 - 1.0).abs() < 1e-9);
        let (exact, series) = (
            process.expected(1e6).unwrap(),
            process.expected_asymptotic(1e6).unwrap(),
        );
        assert!((exact - series).abs() < 0.02 * 3.0);
        let e = process.quantile((-1.0_f64).exp(), 1e6).unwrap();
        assert!((e - process.most_probable(1e6).unwrap()).abs() < 1e-5);
        assert!(process.expected(f64::NAN).is_err() && NarrowBand::new(0.0, 0.0, 1.0).is_err());
    }

    /// The tolerance of each is three to four standard errors over twelve records.
    #[test]
    fn fits_of_synthesised_records() {
        let (mut shape, mut scale, mut peak, mut rate, mut most) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let seeds = 12;
        for seed in 0..seeds {
            let values = record(seed, 8000);
            let statistics = Statistics::of_values(&values);
            let unit: Vec<f64> = values.iter().map(|v| v / statistics.deviation).collect();
            let maxima = global_maxima(&unit);
            let peaks: Vec<f64> = maxima.iter().map(|m| m.value).collect();
            let fit = WeibullFit::fit(&peaks, 0.0).unwrap();
            shape += fit.shape / f64::from(seeds as u32);
            scale += fit.scale / f64::from(seeds as u32);
            peak += mean(&peaks) / f64::from(seeds as u32);
            most +=
                fit.value(ExtremesTarget::most_probable(1000.0)).unwrap() / f64::from(seeds as u32);
            let moments = welch(&unit, 0.5, Some(800)).unwrap().moments(0.2);
            rate += NarrowBand::of_spectrum(0.0, &moments).unwrap().rate / f64::from(seeds as u32);
        }
        let process = NarrowBand::new(0.0, 1.0, 0.1).unwrap();
        assert!((shape - 2.0).abs() < 0.2, "shape {shape}");
        assert!((scale - 2.0_f64.sqrt()).abs() < 0.04, "scale {scale}");
        assert!((peak - process.mean_peak()).abs() < 0.03, "peak {peak}");
        assert!((rate - 0.1).abs() < 0.001, "rate {rate}");
        let closed = process.most_probable(1000.0).unwrap();
        assert!((most / closed - 1.0).abs() < 0.08, "{most} {closed}");
    }
}
