//! How often the rules of [`sequential`](super::sequential) give a false verdict, and how many seeds they take: measured.

use super::coverage::Distribution;
use super::error::ExtremesError;
use super::fractile_rule::FractileRule;
use super::gumbel_rule::GumbelRule;
use super::sequential::Verdict;
use super::target::ExtremesTarget;
use crate::numerics::random::Random;

/// The rule that is tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// [`FractileRule`] for this fractile.
    Fractile(f64),
    /// [`GumbelRule`] for this figure, with a first look after so many seeds.
    Gumbel(ExtremesTarget, usize),
}

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SequentialStudy {
    /// The rule.
    pub rule: Rule,
    /// The law of the greatest values.
    pub distribution: Distribution,
    /// The limit above the true figure, in standard deviations of a single value. At zero both verdicts are counted.
    pub margin: f64,
    /// Probability of a false verdict that the rule states.
    pub error: f64,
    /// Streams of seeds.
    pub streams: u32,
    /// Seeds after which a stream is given up.
    pub longest: usize,
    /// Seed of the study.
    pub seed: u64,
}

/// What came of the streams.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SequentialOutcome {
    /// Share of streams with the verdict [`Verdict::Below`].
    pub below: f64,
    /// Share of streams with the verdict [`Verdict::Above`].
    pub above: f64,
    /// Share of streams not settled after the longest.
    pub open: f64,
    /// Median of the seeds taken, unsettled streams with the longest.
    pub median_seeds: usize,
    /// The seeds that nine streams in ten take at most.
    pub most_seeds: usize,
}

/// Runs the streams, each a stream of the seed.
///
/// # Errors
/// Where the rule or the law refuses its numbers, or no stream is asked for.
pub fn run(study: &SequentialStudy) -> Result<SequentialOutcome, ExtremesError> {
    let target = match study.rule {
        Rule::Fractile(fractile) => ExtremesTarget::quantile(fractile),
        Rule::Gumbel(target, _) => target,
    };
    let limit =
        study.distribution.truth(target)? + study.margin * study.distribution.deviation()?;
    let streams: Result<Vec<_>, _> = (0..u64::from(study.streams))
        .map(|stream| run_stream(study, limit, stream))
        .collect();
    let streams = streams?;
    let mut seeds: Vec<usize> = streams.iter().map(|s| s.1).collect();
    seeds.sort_unstable();
    let share = |verdict| {
        let count = streams.iter().filter(|s| s.0 == verdict).count();
        count as f64 / streams.len() as f64
    };
    let place = |part: usize| seeds.get(seeds.len() * part / 10).copied();
    let none = ExtremesError::TooFew { found: 0, least: 1 };
    Ok(SequentialOutcome {
        below: share(Verdict::Below),
        above: share(Verdict::Above),
        open: share(Verdict::Open),
        median_seeds: place(5).ok_or_else(|| none.clone())?,
        most_seeds: place(9).ok_or(none)?,
    })
}

/// The verdict of a stream and the seeds it took.
fn run_stream(
    study: &SequentialStudy,
    limit: f64,
    stream: u64,
) -> Result<(Verdict, usize), ExtremesError> {
    let mut random = Random::new(study.seed, stream);
    let mut fractile = None;
    let mut gumbel = None;
    match study.rule {
        Rule::Fractile(q) => fractile = Some(FractileRule::new(limit, q, study.error)?),
        Rule::Gumbel(target, first) => {
            gumbel = Some(GumbelRule::new(limit, target, study.error, first)?);
        }
    }
    for seeds in 1..=study.longest {
        let greatest = study.distribution.draw(&mut random);
        let mut verdict = Verdict::Open;
        if let Some(rule) = &mut fractile {
            verdict = rule.observe(greatest)?;
        }
        if let Some(rule) = &mut gumbel {
            verdict = rule.observe(greatest)?;
        }
        if verdict != Verdict::Open {
            return Ok((verdict, seeds));
        }
    }
    Ok((Verdict::Open, study.longest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn study(rule: Rule, margin: f64, streams: u32) -> SequentialOutcome {
        run(&SequentialStudy {
            rule,
            distribution: Distribution::Gumbel,
            margin,
            error: 0.05,
            streams,
            longest: 200,
            seed: 2,
        })
        .unwrap()
    }

    /// At the limit both verdicts are false in turn: neither is given more often than stated, within two standard errors.
    #[test]
    fn false_verdicts_are_as_rare_as_stated() {
        let allowed = 0.05 + 2.0 * (0.05 * 0.95 / 150.0_f64).sqrt();
        for rule in [
            Rule::Fractile(0.37),
            Rule::Gumbel(ExtremesTarget::expected(1.0), 5),
        ] {
            let outcome = study(rule, 0.0, 150);
            assert!(
                outcome.below < allowed && outcome.above < allowed,
                "{outcome:?}"
            );
            assert!(
                outcome.below + outcome.above + outcome.open > 0.999,
                "{outcome:?}"
            );
            assert!(outcome.open > 0.8, "{outcome:?}");
        }
    }

    #[test]
    fn a_clear_case_is_settled() {
        for rule in [
            Rule::Fractile(0.5),
            Rule::Gumbel(ExtremesTarget::expected(1.0), 5),
        ] {
            let outcome = study(rule, 1.0, 100);
            assert!(outcome.below > 0.97 && outcome.above < 0.03, "{outcome:?}");
            assert!(outcome.median_seeds < 40 && outcome.most_seeds >= outcome.median_seeds);
        }
        let none = SequentialStudy {
            rule: Rule::Fractile(0.5),
            distribution: Distribution::Gumbel,
            margin: 0.0,
            error: 0.05,
            streams: 0,
            longest: 10,
            seed: 1,
        };
        assert!(run(&none).is_err());
    }
}
