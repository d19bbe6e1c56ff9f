//! The greatest value of so many hours from the peaks of one record.
//!
//! Peaks come at a rate, so the greatest of T hours is that of `rate T` independent peaks. Its intervals count the scatter of the
//! peaks; that of the rate, `1/sqrt(n)` of it, moves the result by `scale/sqrt(n)`, less than a `ln(rate T)`-th of the former.

use super::error::{ExtremesError, check_finite, check_inside};
use super::generalized_pareto;
use super::interval::{Interval, IntervalMethod};
use super::moments::check_step;
use super::peaks::{global_maxima, over_threshold};
use super::target::{ExtremesTarget, Statistic};
use super::weibull;
use crate::numerics::statistics::mean;

/// Peaks of a record above a threshold, with the time they were seen in.
#[derive(Debug, Clone, PartialEq)]
pub struct PeakSample {
    /// Peaks, all above the threshold, in the unit of the record.
    pub peaks: Vec<f64>,
    /// The threshold: the location of Weibull's law, the threshold of the generalized Pareto law.
    pub threshold: f64,
    /// Length of the record in hours.
    pub hours: f64,
}

/// What is asked of the greatest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreatestQuestion {
    /// The figure.
    pub statistic: Statistic,
    /// Of so many hours.
    pub hours: f64,
    /// Level of confidence of the interval, between 0 and 1.
    pub level: f64,
    /// How the interval is made.
    pub method: IntervalMethod,
}

impl PeakSample {
    /// The global maxima of a record at even steps in seconds, about its mean: for Weibull's law.
    ///
    /// # Errors
    /// Where values are fewer than two or not finite, or the step is not above zero.
    pub fn global_maxima(values: &[f64], step: f64) -> Result<Self, ExtremesError> {
        check_finite(values, 2)?;
        check_step(step)?;
        let peaks = global_maxima(values).iter().map(|p| p.value).collect();
        let seconds = step * (values.len() - 1) as f64;
        Self::new(peaks, mean(values), seconds)
    }

    /// The greatest of clusters over a threshold, `separation` seconds apart; times in seconds.
    ///
    /// # Errors
    /// Those of [`over_threshold`], and fewer than two values.
    pub fn over_threshold(
        times: &[f64],
        values: &[f64],
        threshold: f64,
        separation: f64,
    ) -> Result<Self, ExtremesError> {
        check_finite(values, 2)?;
        let peaks = over_threshold(times, values, threshold, separation)?;
        let seconds = match times {
            [first, .., last] => last - first,
            _ => 0.0,
        };
        Self::new(peaks.iter().map(|p| p.value).collect(), threshold, seconds)
    }

    fn new(peaks: Vec<f64>, threshold: f64, seconds: f64) -> Result<Self, ExtremesError> {
        let range = (0.0, f64::INFINITY);
        check_inside("the length of the record", seconds, range, "above 0 s")?;
        Ok(Self {
            peaks,
            threshold,
            hours: seconds / 3600.0,
        })
    }

    /// The peaks above a higher threshold, in the same time.
    #[must_use]
    pub fn above(&self, threshold: f64) -> Self {
        let kept = self.peaks.iter().copied().filter(|p| *p > threshold);
        Self {
            peaks: kept.collect(),
            threshold: threshold.max(self.threshold),
            hours: self.hours,
        }
    }

    /// Peaks per hour.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.peaks.len() as f64 / self.hours
    }

    /// The figure by Weibull's law of the peaks with the threshold as location.
    ///
    /// # Errors
    /// Those of [`weibull::interval`]; where less than one peak is expected in the hours.
    pub fn by_weibull(&self, question: &GreatestQuestion) -> Result<Interval, ExtremesError> {
        let target = self.target(question)?;
        weibull::interval(
            &self.peaks,
            self.threshold,
            target,
            question.level,
            question.method,
        )
    }

    /// The figure by the generalized Pareto law of the peaks over the threshold.
    ///
    /// # Errors
    /// Those of [`generalized_pareto::interval`]; where less than one peak is expected in the hours.
    pub fn by_pareto(&self, question: &GreatestQuestion) -> Result<Interval, ExtremesError> {
        let target = self.target(question)?;
        generalized_pareto::interval(
            &self.peaks,
            self.threshold,
            target,
            question.level,
            question.method,
        )
    }

    fn target(&self, question: &GreatestQuestion) -> Result<ExtremesTarget, ExtremesError> {
        check_inside(
            "the time in hours",
            question.hours,
            (0.0, f64::INFINITY),
            "above 0 h",
        )?;
        Ok(ExtremesTarget {
            statistic: question.statistic,
            greatest_of: self.rate() * question.hours,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    /// Half sines of Rayleigh's heights, ten seconds each, an hour and two thirds long.
    fn record(seed: u64) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        let mut values = Vec::new();
        for _ in 0..600 {
            let height = (-2.0 * random.uniform().ln()).sqrt();
            for k in 0..20 {
                values.push(height * (std::f64::consts::TAU * f64::from(k) / 20.0).sin());
            }
        }
        values
    }

    #[test]
    fn three_hours_from_one_record() {
        let values = record(3);
        let maxima = PeakSample::global_maxima(&values, 0.5).unwrap();
        assert!((maxima.rate() - 360.0).abs() < 2.0);
        // Most probable of 1080 Rayleigh peaks.
        let exact = (2.0 * 1080.0_f64.ln()).sqrt();
        let mut question = GreatestQuestion {
            statistic: Statistic::MostProbable,
            hours: 3.0,
            level: 0.95,
            method: IntervalMethod::Conditional,
        };
        let weibull = maxima.by_weibull(&question).unwrap();
        assert!(
            weibull.holds(exact) && weibull.high - weibull.low < 0.8,
            "{weibull:?}"
        );
        assert!(maxima.by_pareto(&question).is_err());
        question.method = IntervalMethod::ProfileLikelihood;
        let times: Vec<f64> = (0..values.len()).map(|k| 0.5 * k as f64).collect();
        let clusters = PeakSample::over_threshold(&times, &values, 1.5, 4.0).unwrap();
        let pareto = clusters.by_pareto(&question).unwrap();
        assert!(pareto.holds(exact), "{pareto:?}");
        assert!(clusters.above(2.0).peaks.len() < clusters.peaks.len());
    }

    #[test]
    fn bad_questions_are_refused() {
        let maxima = PeakSample::global_maxima(&record(1), 0.5).unwrap();
        let question = |hours| GreatestQuestion {
            statistic: Statistic::Expected,
            hours,
            level: 0.95,
            method: IntervalMethod::Conditional,
        };
        assert!(maxima.by_weibull(&question(0.0)).is_err());
        assert!(maxima.by_weibull(&question(1e-6)).is_err());
        assert!(maxima.by_weibull(&question(f64::NAN)).is_err());
        assert!(maxima.by_weibull(&question(1.0)).is_ok());
        assert!(maxima.above(100.0).by_weibull(&question(1.0)).is_err());
        assert!(PeakSample::global_maxima(&[1.0], 0.5).is_err());
        let flat = PeakSample::global_maxima(&[1.0; 50], 0.5).unwrap();
        assert!(flat.by_weibull(&question(1.0)).is_err());
    }
}
