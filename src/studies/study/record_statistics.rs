//! Statistics of a channel over the records of one run or of several with other seeds: moments and how far they have converged, spectrum,
//! the greatest value of so many hours by three methods, fatigue.
//!
//! Two errors are stated and never added: that of the sample, which longer or more records make smaller, and the numerical one of the run.

use crate::extremes::ExtremesError;
use crate::extremes::convergence::MeanEstimate;
use crate::extremes::greatest::{GreatestQuestion, PeakSample};
use crate::extremes::gumbel;
use crate::extremes::interval::{Interval, IntervalMethod};
use crate::extremes::moments::mean_crossing_rate;
use crate::extremes::spectrum::{SpectralDensity, welch};
use crate::extremes::target::{ExtremesTarget, Statistic};
use crate::extremes::threshold::{ThresholdChoice, ThresholdSearch};
use crate::fatigue::component::FatigueComponent;
use crate::fatigue::damage::{Damage, DamageError, MeanLoad, damage};
use crate::fatigue::mean_stress::MeanCorrection;
use crate::fatigue::rainflow::{Cycle, three_point};
use crate::numerics::statistics::{Statistics, mean, variance};

/// Runs that Gumbel's law is fitted to, at least.
pub const FEWEST_RUNS: usize = 5;

/// The record of a channel in one run, at even steps.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelRecord {
    /// Between two values \[s\].
    pub step: f64,
    /// The values.
    pub values: Vec<f64>,
    /// Least and greatest value of the run itself, between the values too; nothing where only these are known.
    pub extremes: Option<[f64; 2]>,
}

impl ChannelRecord {
    /// Of the rows of a history, whose last one may follow earlier than the others.
    #[must_use]
    pub fn of_history(time: &[f64], values: &[f64]) -> Option<Self> {
        let step = time.get(1)? - time[0];
        let even = time
            .windows(2)
            .take_while(|w| (w[1] - w[0] - step).abs() <= 1e-6 * step);
        let count = 1 + even.count();
        (step > 0.0 && count + 1 >= time.len()).then(|| Self {
            step,
            values: values[..count.min(values.len())].to_vec(),
            extremes: None,
        })
    }

    /// The greatest value: of the run itself, where that is known and greater.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        let own = self.extremes.map_or(f64::MIN, |[_, greatest]| greatest);
        self.values.iter().copied().fold(own, f64::max)
    }

    /// Its length \[s\].
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.step * self.values.len().saturating_sub(1) as f64
    }
}

/// What is asked of the extremes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExtremeQuestion {
    /// Of the greatest value of so many hours.
    pub hours: f64,
    /// Level of confidence of the intervals, between 0 and 1.
    pub level: f64,
}

/// How a greatest value is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExtremeMethod {
    /// Weibull's law of the peaks between up-crossings of the mean.
    Weibull,
    /// The generalized Pareto law of the peaks over a threshold.
    PeaksOverThreshold,
    /// Gumbel's law of the greatest values of the runs.
    Gumbel,
}

impl ExtremeMethod {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Weibull, Self::PeaksOverThreshold, Self::Gumbel];

    /// Its name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Weibull => "Weibull, peaks",
            Self::PeaksOverThreshold => "Pareto, peaks over threshold",
            Self::Gumbel => "Gumbel, maxima of runs",
        }
    }
}

/// A greatest value with its intervals of the sample.
#[derive(Debug, Clone, PartialEq)]
pub struct GreatestValue {
    /// How it was found.
    pub method: ExtremeMethod,
    /// The values that the law was fitted to.
    pub sample: usize,
    /// The most probable greatest value.
    pub most_probable: Interval,
    /// The expected greatest value.
    pub expected: Interval,
    /// What is to be said of it.
    pub remark: Option<&'static str>,
}

/// Statistics of a channel.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordStatistics {
    /// Moments, extremes and crossings of all records together.
    pub moments: Statistics,
    /// The mean with its error of the sample, where the records are long enough.
    pub mean: Result<MeanEstimate, ExtremesError>,
    /// Up-crossings of the mean per second.
    pub crossing_rate: Result<f64, ExtremesError>,
    /// The spectrum of the longest record.
    pub spectrum: Result<SpectralDensity, ExtremesError>,
    /// The greatest value by each method, or why there is none.
    pub greatest: Vec<(ExtremeMethod, Result<GreatestValue, ExtremesError>)>,
    /// Length of all records together \[s\].
    pub duration: f64,
}

impl RecordStatistics {
    /// Of the records of a channel; nothing without any value.
    #[must_use]
    pub fn of_records(records: &[ChannelRecord], question: ExtremeQuestion) -> Option<Self> {
        let all: Vec<f64> = records
            .iter()
            .flat_map(|r| r.values.iter().copied())
            .collect();
        let longest = records
            .iter()
            .max_by(|a, b| a.duration().total_cmp(&b.duration()))?;
        if all.is_empty() {
            return None;
        }
        let methods = ExtremeMethod::ALL.into_iter();
        let greatest = methods.map(|method| (method, greatest(records, method, question)));
        Some(Self {
            moments: Statistics::of_values(&all),
            mean: pooled_mean(records),
            crossing_rate: mean_crossing_rate(&longest.values, longest.step),
            spectrum: welch(&longest.values, longest.step, None),
            greatest: greatest.collect(),
            duration: records.iter().map(ChannelRecord::duration).sum(),
        })
    }
}

/// The mean of all records, each weighted by its length, with its error.
///
/// # Errors
/// Records that are too short or do not vary.
pub fn pooled_mean(records: &[ChannelRecord]) -> Result<MeanEstimate, ExtremesError> {
    let each: Result<Vec<MeanEstimate>, _> = records
        .iter()
        .map(|record| MeanEstimate::of_record(&record.values))
        .collect();
    let each = each?;
    let all: f64 = records
        .iter()
        .map(|record| record.values.len() as f64)
        .sum();
    let weighted = each.iter().zip(records);
    let weighted: Vec<(f64, &MeanEstimate)> = weighted
        .map(|(mean, record)| (record.values.len() as f64 / all, mean))
        .collect();
    let root = |error: fn(&MeanEstimate) -> f64| {
        let squares = weighted.iter().map(|(w, mean)| (w * error(mean)).powi(2));
        squares.sum::<f64>().sqrt()
    };
    let sum = |of: fn(&MeanEstimate) -> f64| weighted.iter().map(|(w, mean)| w * of(mean)).sum();
    Ok(MeanEstimate {
        mean: sum(|mean| mean.mean),
        error: root(|mean| mean.error),
        batch_error: root(|mean| mean.batch_error),
        correlation_steps: sum(|mean| mean.correlation_steps),
        effective: each.iter().map(|mean| mean.effective).sum(),
    })
}

/// The greatest value of the hours asked for.
///
/// # Errors
/// Records that the law cannot be fitted to.
pub fn greatest(
    records: &[ChannelRecord],
    method: ExtremeMethod,
    question: ExtremeQuestion,
) -> Result<GreatestValue, ExtremesError> {
    let ask = |statistic: Statistic, method: IntervalMethod| GreatestQuestion {
        statistic,
        hours: question.hours,
        level: question.level,
        method,
    };
    match method {
        ExtremeMethod::Weibull => {
            let sample = pooled_peaks(records)?;
            let by = |statistic| sample.by_weibull(&ask(statistic, IntervalMethod::Conditional));
            Ok(GreatestValue {
                method,
                sample: sample.peaks.len(),
                most_probable: by(Statistic::MostProbable)?,
                expected: by(Statistic::Expected)?,
                remark: None,
            })
        }
        ExtremeMethod::PeaksOverThreshold => {
            let sample = pooled_peaks(records)?;
            let count = sample.rate() * question.hours;
            let search = ThresholdSearch::default();
            let choice =
                ThresholdChoice::search(&sample.peaks, Statistic::MostProbable, count, &search)?;
            let best = choice
                .best()
                .ok_or(ExtremesError::NoMaximum("generalized Pareto"))?;
            let above = sample.above(best.fit.threshold);
            let by =
                |statistic| above.by_pareto(&ask(statistic, IntervalMethod::ProfileLikelihood));
            Ok(GreatestValue {
                method,
                sample: above.peaks.len(),
                most_probable: by(Statistic::MostProbable)?,
                expected: by(Statistic::Expected)?,
                remark: choice.rejected.then_some("the law fits at no threshold"),
            })
        }
        ExtremeMethod::Gumbel => by_gumbel(records, question),
    }
}

/// The peaks of all records about the mean of all.
fn pooled_peaks(records: &[ChannelRecord]) -> Result<PeakSample, ExtremesError> {
    let samples: Result<Vec<PeakSample>, _> = records
        .iter()
        .map(|record| PeakSample::global_maxima(&record.values, record.step))
        .collect();
    let samples = samples?;
    // A peak is above the mean of its own record; the law begins at the least of these.
    let thresholds = samples.iter().map(|sample| sample.threshold);
    Ok(PeakSample {
        threshold: thresholds.fold(f64::INFINITY, f64::min),
        hours: samples.iter().map(|sample| sample.hours).sum(),
        peaks: samples
            .into_iter()
            .flat_map(|sample| sample.peaks)
            .collect(),
    })
}

/// By Gumbel's law of the greatest value of each run: the greatest of so many hours is that of as many runs as these hours hold.
fn by_gumbel(
    records: &[ChannelRecord],
    question: ExtremeQuestion,
) -> Result<GreatestValue, ExtremesError> {
    let (found, least) = (records.len(), FEWEST_RUNS);
    if found < least {
        return Err(ExtremesError::TooFew { found, least });
    }
    let maxima = records.iter().map(ChannelRecord::greatest);
    let maxima: Vec<f64> = maxima.collect();
    let hours = records.iter().map(ChannelRecord::duration).sum::<f64>() / 3600.0 / found as f64;
    let by = |statistic| {
        let target = ExtremesTarget {
            statistic,
            greatest_of: question.hours / hours,
        };
        gumbel::interval(&maxima, target, question.level, IntervalMethod::Conditional)
    };
    Ok(GreatestValue {
        method: ExtremeMethod::Gumbel,
        sample: found,
        most_probable: by(Statistic::MostProbable)?,
        expected: by(Statistic::Expected)?,
        remark: None,
    })
}

/// Fatigue of a component under the tensions of some records.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordFatigue {
    /// Damage of the whole time of the records.
    pub damage: Damage,
    /// Damage of a year.
    pub per_year: f64,
    /// Its standard error by the scatter from record to record, of three records or more.
    pub sample_error: Option<f64>,
}

/// Counts the cycles of each record, and sums their damage. A curve whose constant depends on the mean load takes that of all records.
///
/// # Errors
/// A tension that the curve cannot take, or records without duration.
pub fn fatigue(
    records: &[ChannelRecord],
    component: &FatigueComponent,
) -> Result<RecordFatigue, FatigueError> {
    let all: f64 = records
        .iter()
        .map(|record| record.values.iter().sum::<f64>())
        .sum();
    let count: usize = records.iter().map(|record| record.values.len()).sum();
    let mean = MeanLoad::OfRecord(all / count.max(1) as f64);
    let of = |cycles: &[Cycle]| damage(cycles, component, MeanCorrection::None, mean);
    let (mut cycles, mut yearly) = (Vec::new(), Vec::new());
    for record in records {
        let own = three_point(&record.values)?;
        yearly.push(of(&own)?.per_year(record.duration())?);
        cycles.extend(own);
    }
    let duration = records.iter().map(ChannelRecord::duration).sum();
    let damage = of(&cycles)?;
    Ok(RecordFatigue {
        damage,
        per_year: damage.per_year(duration)?,
        sample_error: scatter(&yearly),
    })
}

/// The standard error of a mean by the scatter of three values or more.
pub(crate) fn scatter(values: &[f64]) -> Option<f64> {
    let n = values.len() as f64;
    let spread = (variance(values, mean(values)) / (n - 1.0)).sqrt();
    (values.len() > 2).then_some(spread)
}

/// Why there is no damage.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FatigueError {
    /// A series without cycles.
    #[error(transparent)]
    Series(#[from] crate::fatigue::turning_points::SeriesError),
    /// Damage that is none.
    #[error(transparent)]
    Damage(#[from] DamageError),
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::extremes::rayleigh::NarrowBand;
    use crate::fatigue::closed_form::narrow_band_damage;
    use crate::fatigue::curve_library::published;
    use crate::numerics::random::Random;

    const PERIOD: f64 = 10.0;
    const DEVIATION: f64 = 1e5;

    /// A narrow band about a mean of 1 MN: harmonics near a period, an hour in steps of a twentieth of it.
    fn record(seed: u64) -> ChannelRecord {
        let mut random = Random::new(seed, 0);
        let waves: Vec<(f64, f64)> = (0..60)
            .map(|k| {
                let frequency = (1.0 + 0.05 * (f64::from(k) / 30.0 - 1.0)) / PERIOD;
                (TAU * frequency, TAU * random.uniform())
            })
            .collect();
        let amplitude = DEVIATION * (2.0 / waves.len() as f64).sqrt();
        let at = |time: f64| {
            let sum = waves
                .iter()
                .map(|(omega, phase)| (omega * time + phase).sin());
            1e6 + amplitude * sum.sum::<f64>()
        };
        ChannelRecord {
            step: 0.5,
            values: (0..7200).map(|row| at(0.5 * f64::from(row))).collect(),
            extremes: None,
        }
    }

    fn records() -> Vec<ChannelRecord> {
        (0..12).map(record).collect()
    }

    const QUESTION: ExtremeQuestion = ExtremeQuestion {
        hours: 3.0,
        level: 0.95,
    };

    #[test]
    fn a_narrow_band_has_the_extremes_of_rayleigh() {
        let records = records();
        let found = RecordStatistics::of_records(&records, QUESTION).unwrap();
        let mean = found.mean.unwrap();
        assert!(
            (mean.mean - 1e6).abs() < 4.0 * mean.error.max(mean.batch_error),
            "{mean:?}"
        );
        assert!(
            (found.moments.deviation / DEVIATION - 1.0).abs() < 0.03,
            "{:?}",
            found.moments
        );
        let rate = found.crossing_rate.unwrap();
        assert!((rate * PERIOD - 1.0).abs() < 0.03, "{rate}");
        let peak = found.spectrum.unwrap().peak_frequency();
        assert!((peak * PERIOD - 1.0).abs() < 0.1, "{peak}");
        let band = NarrowBand::new(1e6, DEVIATION, rate).unwrap();
        let exact = band.expected(band.peaks(3.0 * 3600.0)).unwrap();
        for (method, greatest) in found.greatest {
            let greatest = greatest.unwrap();
            let expected = greatest.expected;
            assert!(expected.low < expected.estimate && expected.estimate < expected.high);
            // Peaks of a narrow band follow each other slowly, so that the intervals of peaks are too narrow.
            let off = (expected.estimate - exact).abs();
            assert!(off < 0.05 * exact, "{method:?}: {expected:?}, {exact}");
        }
    }

    #[test]
    fn a_narrow_band_has_the_damage_of_the_gamma_function() {
        let records = records();
        let curve = published("api-studless-chain").unwrap();
        let component = curve.component(None, Some(8e6)).unwrap();
        let found = fatigue(&records, &component).unwrap();
        let rate = 1.0 / PERIOD;
        let exact =
            narrow_band_damage(&component, DEVIATION, 1e6, rate * 365.25 * 86400.0).unwrap();
        let error = found.sample_error.unwrap();
        assert!(
            (found.per_year - exact).abs() < 4.0 * error,
            "{found:?}, {exact}"
        );
        assert!(error < 0.1 * exact, "{error}, {exact}");
        assert!(
            fatigue(&records[..1], &component)
                .unwrap()
                .sample_error
                .is_none()
        );
    }

    #[test]
    fn records_are_rows_at_even_steps() {
        let of = |time: &[f64]| ChannelRecord::of_history(time, &vec![1.0; time.len()]);
        assert_eq!(of(&[0.0, 0.5, 1.0]).unwrap().duration(), 1.0);
        // The last row may come early.
        assert_eq!(of(&[0.0, 0.5, 1.0, 1.2]).unwrap().duration(), 1.0);
        for uneven in [&[][..], &[1.0], &[0.0, 0.5, 0.7, 1.2], &[0.0, 0.0]] {
            assert_eq!(of(uneven), None, "{uneven:?}");
        }
        assert!(RecordStatistics::of_records(&[], QUESTION).is_none());
    }
}
