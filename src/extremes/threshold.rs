//! The threshold of peaks over a threshold: the lowest from which on the generalized Pareto law fits, and how much the result
//! changes with it.

use super::anderson_darling::{distance, p_value};
use super::error::{ExtremesError, check_finite, check_inside, check_probability};
use super::generalized_pareto::ParetoFit;
use super::target::{Statistic, Target};

/// One threshold that was tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThresholdTrial {
    /// The fit above it.
    pub fit: ParetoFit,
    /// Anderson-Darling distance of the peaks from the fit.
    pub distance: f64,
    /// Probability of as great a distance where the law holds.
    pub p_value: f64,
    /// The figure asked for, at this threshold.
    pub estimate: f64,
}

/// The thresholds that were tried, ascending, and the one chosen.
#[derive(Debug, Clone, PartialEq)]
pub struct ThresholdChoice {
    /// The trials.
    pub trials: Vec<ThresholdTrial>,
    /// Place of the one chosen.
    pub chosen: usize,
    /// Whether the law was rejected at all thresholds; the highest is then chosen and the figure is doubtful.
    pub rejected: bool,
}

/// How thresholds are tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThresholdSearch {
    /// Thresholds tried, at even steps of the logarithm of the number of peaks above.
    pub candidates: usize,
    /// Peaks above the highest at least: 5 or more.
    pub fewest: usize,
    /// The rate at which thresholds are rejected falsely.
    pub significance: f64,
    /// Samples drawn at each threshold for its probability.
    pub draws: u32,
    /// Seed of the draws.
    pub seed: u64,
}

impl Default for ThresholdSearch {
    fn default() -> Self {
        Self {
            candidates: 10,
            fewest: 30,
            significance: 0.1,
            draws: 199,
            seed: 1,
        }
    }
}

impl ThresholdChoice {
    /// Tries thresholds on declustered peaks and takes the lowest that the rule ForwardStop does not reject: the first k are
    /// rejected where k is the greatest with a mean of `-ln(1 - p)` over the first k of the significance at most (Bader, Yan and
    /// Zhang, Ann. Appl. Stat. 12 (2018) 310). The figure is that of the greatest of `count` peaks of the whole sample, its
    /// number above each threshold in proportion.
    ///
    /// # Errors
    /// Where peaks are fewer than `fewest` plus one or not finite, a number is out of range, or no threshold has a fit.
    pub fn search(
        peaks: &[f64],
        statistic: Statistic,
        count: f64,
        search: &ThresholdSearch,
    ) -> Result<Self, ExtremesError> {
        let fewest = search.fewest.max(5);
        check_finite(peaks, fewest + 1)?;
        check_probability("the significance", search.significance)?;
        check_inside("the number of peaks", count, (1.0, 1e15), "above 1")?;
        let mut descending = peaks.to_vec();
        descending.sort_by(|a, b| b.total_cmp(a));
        let mut trials: Vec<ThresholdTrial> = Vec::new();
        for above in numbers_above(peaks.len() - 1, fewest, search.candidates.max(1)) {
            let Some(threshold) = descending.get(above) else {
                continue;
            };
            let part = descending.partition_point(|p| p > threshold);
            let kept = descending.get(..part).unwrap_or_default();
            if let Ok(trial) =
                try_threshold(kept, *threshold, peaks.len(), (statistic, count), search)
            {
                trials.push(trial);
            }
        }
        let stop = forward_stop(&trials, search.significance);
        let last = trials
            .len()
            .checked_sub(1)
            .ok_or(ExtremesError::NoMaximum("generalized Pareto"))?;
        Ok(Self {
            chosen: stop.min(last),
            rejected: stop > last,
            trials,
        })
    }

    /// The trial chosen.
    #[must_use]
    pub fn best(&self) -> Option<&ThresholdTrial> {
        self.trials.get(self.chosen)
    }

    /// Least and greatest estimate of the figure over the chosen threshold and all higher ones. Where they differ by more than
    /// the interval at the chosen one is wide, the figure depends on the threshold.
    #[must_use]
    pub fn stability(&self) -> (f64, f64) {
        let from_chosen = self.trials.iter().skip(self.chosen).map(|t| t.estimate);
        from_chosen.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
            (low.min(v), high.max(v))
        })
    }
}

/// Numbers of peaks above the candidates, falling.
fn numbers_above(most: usize, fewest: usize, candidates: usize) -> Vec<usize> {
    let steps = candidates.saturating_sub(1).max(1) as f64;
    let ratio = (fewest as f64 / most as f64).ln() / steps;
    let number = |i: usize| (most as f64 * (ratio * i as f64).exp()).round() as usize;
    let mut numbers: Vec<usize> = (0..candidates).map(number).collect();
    numbers.dedup();
    numbers
}

fn try_threshold(
    kept: &[f64],
    threshold: f64,
    all: usize,
    (statistic, count): (Statistic, f64),
    search: &ThresholdSearch,
) -> Result<ThresholdTrial, ExtremesError> {
    let fit = ParetoFit::fit(kept, threshold)?;
    let distance = distance(kept, &fit);
    let greatest_of = count * kept.len() as f64 / all as f64;
    Ok(ThresholdTrial {
        fit,
        distance,
        p_value: p_value(distance, &fit, search.draws, search.seed)?,
        estimate: fit.value(Target {
            statistic,
            greatest_of,
        })?,
    })
}

/// How many of the first trials are rejected.
fn forward_stop(trials: &[ThresholdTrial], significance: f64) -> usize {
    let (mut sum, mut rejected) = (0.0, 0);
    for (k, trial) in trials.iter().enumerate() {
        sum -= (-trial.p_value).ln_1p().max(-40.0);
        if sum <= significance * (k + 1) as f64 {
            rejected = k + 1;
        }
    }
    rejected
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    const QUICK: ThresholdSearch = ThresholdSearch {
        candidates: 6,
        fewest: 30,
        significance: 0.1,
        draws: 39,
        seed: 1,
    };

    #[test]
    fn the_lowest_is_kept_where_the_law_holds_everywhere() {
        let mut random = Random::new(6, 0);
        let peaks: Vec<f64> = (0..300).map(|_| -random.uniform().ln()).collect();
        let choice =
            ThresholdChoice::search(&peaks, Statistic::MostProbable, 1000.0, &QUICK).unwrap();
        assert_eq!((choice.chosen, choice.rejected), (0, false));
        let (low, high) = choice.stability();
        let best = choice.best().unwrap();
        assert!(low <= best.estimate && best.estimate <= high && best.fit.count == 299);
        assert!(
            choice
                .trials
                .windows(2)
                .all(|t| t[0].fit.threshold < t[1].fit.threshold)
        );
    }

    /// Uniform below 1 and exponential above: thresholds well below 1 are rejected.
    #[test]
    fn a_threshold_below_the_tail_is_rejected() {
        let mut random = Random::new(6, 0);
        let mut peak = || {
            let u = random.uniform();
            if u < 0.7 {
                0.9 + u / 7.0
            } else {
                1.0 - ((1.0 - u) / 0.3).ln()
            }
        };
        let peaks: Vec<f64> = (0..600).map(|_| peak()).collect();
        let choice =
            ThresholdChoice::search(&peaks, Statistic::MostProbable, 1000.0, &QUICK).unwrap();
        let threshold = choice.best().unwrap().fit.threshold;
        assert!(!choice.rejected && threshold > 0.95, "{choice:?}");
    }

    #[test]
    fn bad_peaks_are_refused() {
        let search = |peaks: &[f64], count| {
            ThresholdChoice::search(peaks, Statistic::Expected, count, &QUICK)
        };
        assert!(search(&[1.0; 20], 100.0).is_err());
        assert!(search(&[1.0; 200], 100.0).is_err());
        assert!(search(&[f64::NAN; 200], 100.0).is_err());
        let rising: Vec<f64> = (0..100)
            .map(|k| -((f64::from(k) + 0.5) / 100.0).ln())
            .collect();
        assert!(search(&rising, 0.5).is_err() && search(&rising, 100.0).is_ok());
    }
}
