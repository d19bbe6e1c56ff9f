//! A fractile of the greatest value against a limit, seed by seed, without any assumption on its law.

use std::convert::Infallible;

use super::conditional::settled;
use super::error::{ExtremesError, check_finite, check_probability};
use super::sequential::Verdict;
use super::special::{ln_beta, ln_incomplete_beta};
use crate::numerics::roots::false_position;

/// Whether a fractile of the greatest value lies below a limit.
///
/// Each seed exceeds the limit or not; the fractile `q` lies below it where the probability to exceed is at most `1 - q`. Against
/// each answer runs the ratio of the likelihood mixed over the beta law of 1/2 and 1/2, cut to the other side, to that at
/// `1 - q`: where the answer is wrong its expectation does not rise, so it ever reaches `1/error` with probability `error` at most
/// (Ville's inequality; Robbins, Ann. Math. Statist. 41 (1970) 1397; Howard and others, Ann. Statist. 49 (2021) 1055).
#[derive(Debug, Clone, PartialEq)]
pub struct FractileRule {
    limit: f64,
    /// Probability to exceed the limit at which the fractile is the limit.
    exceedance: f64,
    error: f64,
    over: u64,
    under: u64,
    verdict: Verdict,
}

/// The exponents of the beta law over which likelihoods are mixed (Krichevsky and Trofimov 1981).
const PRIOR: f64 = 0.5;

impl FractileRule {
    /// For a limit in the unit of the values and a fractile between 0 and 1 (0.5 the median, 0.37 the most probable greatest),
    /// with this probability of a false verdict over all looks together.
    ///
    /// # Errors
    /// Where the limit is not finite, or the fractile or the error not between 0 and 1.
    pub fn new(limit: f64, fractile: f64, error: f64) -> Result<Self, ExtremesError> {
        check_finite(&[limit], 1)?;
        check_probability("the fractile", fractile)?;
        check_probability("the probability of a false verdict", error)?;
        Ok(Self {
            limit,
            exceedance: 1.0 - fractile,
            error,
            over: 0,
            under: 0,
            verdict: Verdict::Open,
        })
    }

    /// Takes the greatest value of the next seed; a settled verdict stays.
    ///
    /// # Errors
    /// Where the value is no number.
    pub fn observe(&mut self, greatest: f64) -> Result<Verdict, ExtremesError> {
        check_finite(&[greatest], 1)?;
        if greatest > self.limit {
            self.over += 1;
        } else {
            self.under += 1;
        }
        if self.verdict == Verdict::Open {
            self.verdict = self.judge();
        }
        Ok(self.verdict)
    }

    /// The verdict so far.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        self.verdict
    }

    /// The probability to exceed the limit, as the share of seeds, and an interval of confidence `1 - error` that holds at all
    /// looks together. From 0 to 1 before the first seed.
    #[must_use]
    pub fn exceedance(&self) -> (f64, f64, f64) {
        let (s, f) = (self.over as f64, self.under as f64);
        if s + f == 0.0 {
            return (0.5, 0.0, 1.0);
        }
        let share = s / (s + f);
        let mixed = ln_beta(PRIOR + s, PRIOR + f) - ln_beta(PRIOR, PRIOR);
        let off = |p: f64| {
            let ratio = mixed - ln_likelihood(p, s, f);
            // Far outside, the likelihood vanishes.
            Ok::<_, Infallible>(settled(ratio.min(1e6) + self.error.ln(), 1e-10))
        };
        let end = |edge: f64| match false_position((share, edge), off) {
            Ok(found) => found.unwrap_or(edge),
        };
        let low = if s == 0.0 { 0.0 } else { end(0.0) };
        let high = if f == 0.0 { 1.0 } else { end(1.0) };
        (share, low, high)
    }

    fn judge(&self) -> Verdict {
        let (s, f, p) = (self.over as f64, self.under as f64, self.exceedance);
        let level = -self.error.ln();
        if mixture_below(s, f, p) >= level {
            Verdict::Below
        } else if mixture_below(f, s, 1.0 - p) >= level {
            Verdict::Above
        } else {
            Verdict::Open
        }
    }
}

/// Logarithm of the likelihood of `s` successes and `f` failures.
fn ln_likelihood(p: f64, s: f64, f: f64) -> f64 {
    let part = |count: f64, log: f64| if count == 0.0 { 0.0 } else { count * log };
    part(s, p.ln()) + part(f, (-p).ln_1p())
}

/// Logarithm of the likelihood mixed over probabilities below `p`, over that at `p`.
fn mixture_below(s: f64, f: f64, p: f64) -> f64 {
    let cut = |s: f64, f: f64| {
        ln_beta(PRIOR + s, PRIOR + f) + ln_incomplete_beta(PRIOR + s, PRIOR + f, p)
    };
    cut(s, f) - cut(0.0, 0.0) - ln_likelihood(p, s, f)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    #[test]
    fn few_seeds_settle_a_clear_case() {
        let mut rule = FractileRule::new(10.0, 0.5, 0.05).unwrap();
        let mut seeds = 0;
        while rule.observe(5.0).unwrap() == Verdict::Open {
            seeds += 1;
        }
        assert_eq!(rule.verdict(), Verdict::Below);
        assert!((3..8).contains(&seeds), "{seeds}");
        // A settled verdict stays.
        for _ in 0..100 {
            assert_eq!(rule.observe(50.0).unwrap(), Verdict::Below);
        }
    }

    #[test]
    fn the_mixture_is_a_martingale() {
        for (s, f, p) in [(0.0, 0.0, 0.63), (3.0, 1.0, 0.5), (1.0, 9.0, 0.1)] {
            let next = p * mixture_below(s + 1.0, f, p).exp()
                + (1.0 - p) * mixture_below(s, f + 1.0, p).exp();
            assert!((next / mixture_below(s, f, p).exp() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_interval_holds_the_share() {
        let mut rule = FractileRule::new(0.3, 0.5, 0.05).unwrap();
        assert_eq!(rule.exceedance(), (0.5, 0.0, 1.0));
        let mut random = Random::new(4, 0);
        for _ in 0..2000 {
            rule.observe(random.uniform()).unwrap();
            let (share, low, high) = rule.exceedance();
            assert!(low <= share && share <= high && low >= 0.0 && high <= 1.0);
        }
        let (_, low, high) = rule.exceedance();
        assert!(low < 0.7 && 0.7 < high && high - low < 0.09, "{low} {high}");
    }

    #[test]
    fn bad_questions_are_refused() {
        assert!(FractileRule::new(f64::NAN, 0.5, 0.05).is_err());
        assert!(FractileRule::new(1.0, 1.0, 0.05).is_err());
        assert!(FractileRule::new(1.0, 0.5, 0.0).is_err());
        let mut rule = FractileRule::new(1.0, 0.5, 0.05).unwrap();
        assert!(rule.observe(f64::NAN).is_err());
        assert_eq!(rule.exceedance(), (0.5, 0.0, 1.0));
    }
}
