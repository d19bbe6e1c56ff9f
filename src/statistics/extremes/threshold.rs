//! The threshold of peaks over a threshold: the lowest from which on the generalized Pareto law fits, and how much the result
//! changes with it.

use super::anderson_darling::{ExponentialDraw, Simulation, distance};
use super::error::{ExtremesError, check_finite, check_inside, check_probability};
use super::generalized_pareto::ParetoFit;
use super::target::{ExtremesTarget, Statistic};

/// One threshold that was tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThresholdTrial {
    /// The fit above it.
    pub fit: ParetoFit,
    /// Anderson-Darling distance of the peaks from the fit.
    pub distance: f64,
    /// Probability of as great a distance where the law holds: its least and greatest value, as near to each other as the choice needs.
    pub p_value: [f64; 2],
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
    /// Samples drawn at each threshold for its probability, at most.
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
        let mut trials: Vec<(ThresholdTrial, Simulation)> = Vec::new();
        for above in numbers_above(peaks.len() - 1, fewest, search.candidates.max(1)) {
            let Some(threshold) = descending.get(above) else {
                continue;
            };
            let part = descending.partition_point(|p| p > threshold);
            let kept = descending.get(..part).unwrap_or_default();
            let greatest_of = count * kept.len() as f64 / peaks.len() as f64;
            let target = ExtremesTarget {
                statistic,
                greatest_of,
            };
            trials.extend(try_threshold(kept, *threshold, target).ok());
        }
        let stop = simulate(&mut trials, search);
        let trials: Vec<ThresholdTrial> = trials.into_iter().map(|(trial, _)| trial).collect();
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

/// The fit to peaks above a threshold, in descending order, whose probability is open.
fn try_threshold(
    kept: &[f64],
    threshold: f64,
    target: ExtremesTarget,
) -> Result<(ThresholdTrial, Simulation), ExtremesError> {
    let fit = ParetoFit::fit(kept, threshold)?;
    let ascending: Vec<f64> = kept.iter().rev().map(|p| p - threshold).collect();
    let distance = distance(&ascending, fit.scale, fit.shape);
    let trial = ThresholdTrial {
        fit,
        distance,
        p_value: [0.0, 1.0],
        estimate: fit.value(target)?,
    };
    Ok((trial, Simulation::new(&fit, distance)))
}

/// Draws between two looks at what is known.
const BATCH: u32 = 10;

/// How many of the first trials are rejected, by as many draws as it takes to be certain what all of them would say. Trials of whose samples none has
/// a fit are left out. A draw serves all trials, the later ones by a part of it.
fn simulate(trials: &mut Vec<(ThresholdTrial, Simulation)>, search: &ThresholdSearch) -> usize {
    let draws = search.draws;
    let (mut drawn, mut open) = (0, trials.len());
    let mut stop = 0;
    while open > 0 && drawn < draws {
        let until = draws.min(drawn + BATCH);
        for number in drawn..until {
            add_draw(&mut trials[..open], search.seed, u64::from(number));
        }
        drawn = until;
        if drawn == draws {
            trials.retain(|(_, simulation)| simulation.is_fitted());
        } else if trials.iter().any(|(_, simulation)| !simulation.is_fitted()) {
            continue;
        }
        for (trial, simulation) in trials.iter_mut() {
            trial.p_value = simulation.bounds(draws);
        }
        let [most, least] = [0, 1].map(|bound| {
            let probabilities = trials.iter().map(|(trial, _)| trial.p_value[bound]);
            forward_stop(probabilities, search.significance)
        });
        // What comes after the most that may be rejected has no say.
        (stop, open) = (least, if least == most { 0 } else { most });
    }
    if draws == 0 {
        trials.clear();
    }
    stop
}

/// Adds a draw to each of these trials.
fn add_draw(trials: &mut [(ThresholdTrial, Simulation)], seed: u64, number: u64) {
    let most = trials.iter().map(|(trial, _)| trial.fit.count).max();
    let mut draw = ExponentialDraw::new(seed, number, most.unwrap_or(0));
    for (trial, simulation) in trials {
        draw.keep(trial.fit.count);
        simulation.add(&draw);
    }
}

/// How many of the first trials are rejected.
fn forward_stop(probabilities: impl Iterator<Item = f64>, significance: f64) -> usize {
    let (mut sum, mut rejected) = (0.0, 0);
    for (k, probability) in probabilities.enumerate() {
        sum -= (-probability).ln_1p().max(-40.0);
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
