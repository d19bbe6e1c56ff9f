//! Moments of a record, and the greatest value to expect of records.

use std::f64::consts::PI;

/// The mean.
#[must_use]
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The sum of the squares of the deviations from a mean.
fn squared_deviations(values: &[f64], mean: f64) -> f64 {
    values.iter().map(|v| (v - mean).powi(2)).sum()
}

/// The variance about a mean, that of the record itself and not of a population that it samples.
#[must_use]
pub fn variance(values: &[f64], mean: f64) -> f64 {
    squared_deviations(values, mean) / values.len() as f64
}

/// The median: of an even number of values the mean of both in the middle, `None` of no values.
#[must_use]
pub fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let upper = *values.get(values.len() / 2)?;
    let lower = *values.get(values.len().saturating_sub(1) / 2)?;
    Some(0.5 * (lower + upper))
}

/// Root mean square and greatest of values that are not negative; zero of no values.
#[must_use]
pub fn rms_and_max(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (sum, most, count) = values.fold((0.0, 0.0_f64, 0_u32), |(sum, most, count), v| {
        (sum + v * v, most.max(v), count + 1)
    });
    ((sum / f64::from(count.max(1))).sqrt(), most)
}

/// Moments, extremes and crossings of a record.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Statistics {
    /// Mean.
    pub mean: f64,
    /// Root of the mean square, about zero.
    pub rms: f64,
    /// Root of the mean square about the mean.
    pub deviation: f64,
    /// Greatest.
    pub max: f64,
    /// Smallest.
    pub min: f64,
    /// Third moment about the mean over the cube of the deviation (skewness); zero for a Gaussian record.
    pub skewness: f64,
    /// Fourth moment over the fourth power, minus three (excess kurtosis); zero for a Gaussian record.
    pub excess: f64,
    /// Upward crossings of the mean.
    pub crossings: usize,
}

impl Statistics {
    /// Of values at equal steps; all zero without any.
    #[must_use]
    pub fn of_values(values: &[f64]) -> Self {
        if values.is_empty() {
            return Self::default();
        }
        let n = values.len() as f64;
        let mean = mean(values);
        let moment = |power: i32| values.iter().map(|v| (v - mean).powi(power)).sum::<f64>() / n;
        let variance = variance(values, mean);
        let deviation = variance.sqrt();
        let standard = |moment: f64, scale: f64| if scale > 0.0 { moment / scale } else { 0.0 };
        let above = |v: f64| v > mean;
        Self {
            mean,
            rms: (variance + mean * mean).sqrt(),
            deviation,
            max: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            min: values.iter().copied().fold(f64::INFINITY, f64::min),
            skewness: standard(moment(3), variance * deviation),
            excess: standard(moment(4), variance * variance)
                - if variance > 0.0 { 3.0 } else { 0.0 },
            crossings: values
                .windows(2)
                .filter(|pair| !above(pair[0]) && above(pair[1]))
                .count(),
        }
    }
}

/// Root mean square difference of two records.
#[must_use]
pub fn rms_difference(a: &[f64], b: &[f64]) -> f64 {
    let squares: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (squares / a.len().max(1) as f64).sqrt()
}

/// A greatest value to expect, and by how much it scatters from one record to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExpectedMaximum {
    /// Mean over many records.
    pub expected: f64,
    /// Deviation from record to record.
    pub spread: f64,
}

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

/// The greatest of a Gaussian record about its mean, after so many upward crossings of it: `s (c + γ/c)` with
/// `c = √(2 ln n)`, its spread `s π / (√6 c)` (Cartwright and Longuet-Higgins 1956, doi 10.1098/rspa.1956.0173; asymptotic in n).
#[must_use]
pub fn expected_gaussian_maximum(deviation: f64, crossings: f64) -> ExpectedMaximum {
    let c = (2.0 * crossings.max(2.0).ln()).sqrt();
    ExpectedMaximum {
        expected: deviation * (c + EULER / c),
        spread: deviation * PI / (6.0_f64.sqrt() * c),
    }
}

/// Gumbel's law fitted to the greatest values of several records by their moments: `exp(-exp(-(x - mode)/scale))`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gumbel {
    /// Most probable value.
    pub mode: f64,
    /// Scale.
    pub scale: f64,
    /// Mean of the values, and their deviation.
    pub greatest: ExpectedMaximum,
    /// Standard error of that mean.
    pub error: f64,
}

impl Gumbel {
    /// Fitted to two values or more; the deviation is the unbiased one.
    #[must_use]
    pub fn fit(values: &[f64]) -> Option<Self> {
        if values.len() < 2 {
            return None;
        }
        let n = values.len() as f64;
        let mean = mean(values);
        let square = squared_deviations(values, mean) / (n - 1.0);
        let spread = square.sqrt();
        let scale = spread * 6.0_f64.sqrt() / PI;
        Some(Self {
            mode: mean - EULER * scale,
            scale,
            greatest: ExpectedMaximum {
                expected: mean,
                spread,
            },
            error: spread / n.sqrt(),
        })
    }

    /// The value that a record stays below with this probability, between 0 and 1.
    #[must_use]
    pub fn quantile(&self, probability: f64) -> f64 {
        self.mode - self.scale * (-probability.ln()).ln()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn root_mean_square_and_greatest() {
        let (rms, most) = rms_and_max([3.0, 4.0].into_iter());
        assert!((rms - 12.5_f64.sqrt()).abs() < 1e-15);
        assert_eq!(most, 4.0);
        assert_eq!(rms_and_max(std::iter::empty()), (0.0, 0.0));
    }

    #[test]
    fn medians() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(2.5));
        assert_eq!(median(Vec::new()), None);
    }

    #[test]
    fn of_a_sine() {
        let values: Vec<f64> = (0..10_000)
            .map(|i| 3.0 + 2.0 * (f64::from(i) * 0.01 * 2.0 * PI).sin())
            .collect();
        let s = Statistics::of_values(&values);
        assert!((s.mean - 3.0).abs() < 1e-12);
        assert!((s.deviation - 2.0_f64.sqrt()).abs() < 1e-12);
        assert!((s.rms - 11.0_f64.sqrt()).abs() < 1e-12);
        assert!(s.skewness.abs() < 1e-12 && (s.excess + 1.5).abs() < 1e-12);
        assert!((99..=100).contains(&s.crossings));
        assert_eq!(Statistics::of_values(&[]), Statistics::default());
        assert_eq!(Statistics::of_values(&[4.0, 4.0]).excess, 0.0);
    }

    #[test]
    fn gumbel_finds_its_own_law() {
        let mut random = Random::new(3, 0);
        let values: Vec<f64> = (0..20_000)
            .map(|_| 5.0 - 2.0 * (-random.uniform().ln()).ln())
            .collect();
        let fit = Gumbel::fit(&values).unwrap();
        assert!((fit.mode - 5.0).abs() < 0.06 && (fit.scale - 2.0).abs() < 0.05);
        assert!((fit.quantile((-1.0_f64).exp()) - fit.mode).abs() < 1e-12);
        assert!(Gumbel::fit(&values[..1]).is_none());
    }
}
