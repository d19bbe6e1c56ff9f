//! Seeds drawn until a verdict is settled: looks after 5, 10, 20, ... runs of a sea, with intervals that hold at all of them together.
//!
//! Who looks again after every seed and stops when an interval says so errs more often than the interval states. Here look k may err with
//! `6 / (pi^2 k^2)` of the whole error, which sums to it over all looks, as in
//! [`GumbelRule`](crate::extremes::gumbel_rule::GumbelRule).

use crate::case::StatisticsInputs;
use crate::study::record_statistics::FEWEST_RUNS;

/// A look at the runs of a sea.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Look {
    /// Its number, from 1.
    pub number: u32,
    /// The runs that it takes, the first ones of the sea.
    pub runs: usize,
}

impl Look {
    /// The first one.
    pub const FIRST: Self = Self {
        number: 1,
        runs: FEWEST_RUNS,
    };

    /// The last look that so many runs allow; nothing before the first one.
    #[must_use]
    pub fn last_of(runs: usize) -> Option<Self> {
        let mut look = (runs >= Self::FIRST.runs).then_some(Self::FIRST)?;
        while look.next().runs <= runs {
            look = look.next();
        }
        Some(look)
    }

    /// The one after it, at twice the runs.
    #[must_use]
    pub const fn next(self) -> Self {
        Self {
            number: self.number + 1,
            runs: self.runs.saturating_mul(2),
        }
    }

    /// The level of its interval, so that those of all looks hold together with this confidence.
    #[must_use]
    pub fn level(self, confidence: f64) -> f64 {
        let share = 6.0 / (std::f64::consts::PI * f64::from(self.number)).powi(2);
        1.0 - (1.0 - confidence) * share
    }
}

/// How many of so many runs an interval takes, and its level.
pub(super) fn taken(statistics: &StatisticsInputs, runs: usize) -> (usize, f64) {
    let confidence = statistics.confidence;
    match Look::last_of(runs).filter(|_| statistics.until_settled) {
        Some(look) => (look.runs, look.level(confidence)),
        None if statistics.until_settled => (0, confidence),
        None => (runs, confidence),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extremes::gumbel::{self, GumbelFit};
    use crate::extremes::gumbel_rule::GumbelRule;
    use crate::extremes::interval::IntervalMethod;
    use crate::extremes::target::{ExtremesTarget, Statistic};
    use crate::numerics::random::Random;

    #[test]
    fn looks_double_and_spend_no_more_than_the_whole_error() {
        let runs = [4, 5, 9, 10, 39, 40, 1000];
        let found = runs.map(|runs| Look::last_of(runs).map(|look| look.runs));
        let wanted = [
            None,
            Some(5),
            Some(5),
            Some(10),
            Some(20),
            Some(40),
            Some(640),
        ];
        assert_eq!(found, wanted);
        let (mut look, mut spent) = (Look::FIRST, 0.0);
        for _ in 0..1000 {
            spent += 1.0 - look.level(0.95);
            look = Look {
                number: look.number + 1,
                ..look
            };
        }
        assert!(spent < 0.05 && spent > 0.0499, "{spent}");
    }

    #[test]
    fn the_interval_of_a_look_is_that_of_the_rule_whose_errors_are_measured() {
        let law = GumbelFit {
            mode: 3.0,
            scale: 0.4,
            count: 0,
            log_likelihood: 0.0,
        };
        let mut random = Random::new(7, 0);
        let values: Vec<f64> = (0..23).map(|_| law.draw(&mut random)).collect();
        let target = ExtremesTarget {
            statistic: Statistic::MostProbable,
            greatest_of: 18.0,
        };
        let mut rule = GumbelRule::new(10.0, target, 0.05, Look::FIRST.runs).unwrap();
        for value in &values {
            rule.observe(*value).unwrap();
        }
        let look = Look::last_of(values.len()).unwrap();
        let level = look.level(0.95);
        let method = IntervalMethod::Conditional;
        let found = gumbel::interval(&values[..look.runs], target, level, method).unwrap();
        assert_eq!(found, rule.interval().unwrap());
    }
}
