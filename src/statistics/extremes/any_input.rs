//! Whatever the numbers, an answer of finite numbers or an error.

use super::convergence::{Halves, MeanEstimate};
use super::fractile_rule::FractileRule;
use super::greatest::{GreatestQuestion, PeakSample};
use super::gumbel_rule::GumbelRule;
use super::peaks::{block_maxima, over_threshold};
use super::spectrum::welch;
use super::{
    ExtremesTarget, Interval, IntervalMethod, Statistic, generalized_pareto, gumbel, weibull,
};
use crate::numerics::random::Random;

/// Values of any size, some equal, some no numbers.
fn values(random: &mut Random, most: f64) -> Vec<f64> {
    let count = (random.uniform() * most) as usize;
    let power = 10.0_f64.powf(620.0 * (random.uniform() - 0.5) * random.uniform());
    let shift = if random.uniform() < 0.3 {
        1e3 * power * random.uniform()
    } else {
        0.0
    };
    let mut values: Vec<f64> = (0..count)
        .map(|_| shift + power * random.uniform().powi(3))
        .collect();
    for _ in 0..2 {
        let (from, to) = (random.uniform(), random.uniform());
        let place = |u: f64| (u * count as f64) as usize;
        if count > 0 && random.uniform() < 0.3 {
            values[place(to)] = values[place(from)];
        }
        if count > 0 && random.uniform() < 0.1 {
            let odd = [f64::NAN, f64::INFINITY, 0.0, -1.0, 1.7e308, 5e-324];
            values[place(to)] = odd[(from * 6.0) as usize];
        }
    }
    values
}

fn number(random: &mut Random) -> f64 {
    let usual = [
        0.5,
        0.9,
        0.95,
        1.0,
        3.0,
        100.0,
        1e6,
        0.0,
        -1.0,
        f64::NAN,
        f64::INFINITY,
        1e-12,
    ];
    usual[(random.uniform() * 12.0) as usize]
}

fn target(random: &mut Random) -> ExtremesTarget {
    let statistic = match (random.uniform() * 3.0) as u8 {
        0 => Statistic::Quantile(number(random)),
        1 => Statistic::MostProbable,
        _ => Statistic::Expected,
    };
    ExtremesTarget {
        statistic,
        greatest_of: number(random),
    }
}

fn method(random: &mut Random) -> IntervalMethod {
    let (draws, seed) = ((random.uniform() * 30.0) as u32, 1);
    match (random.uniform() * 3.0) as u8 {
        0 => IntervalMethod::ProfileLikelihood,
        1 => IntervalMethod::Bartlett { draws, seed },
        _ => IntervalMethod::Conditional,
    }
}

fn check(found: &Interval) -> u32 {
    let finite = [found.estimate, found.low, found.high]
        .iter()
        .all(|v| v.is_finite());
    assert!(finite && found.low <= found.high, "{found:?}");
    1
}

#[test]
fn intervals() {
    let mut answers = 0;
    for turn in 0..700 {
        let mut random = Random::new(31, turn);
        let sample = values(&mut random, 9.0);
        let usual = turn % 2 == 0;
        let target = if usual {
            ExtremesTarget::expected(50.0)
        } else {
            target(&mut random)
        };
        let level = if usual { 0.95 } else { number(&mut random) };
        let method = method(&mut random);
        let location = if usual { 0.0 } else { number(&mut random) };
        for found in [
            gumbel::interval(&sample, target, level, method),
            weibull::interval(&sample, location, target, level, method),
            generalized_pareto::interval(&sample, location, target, level, method),
        ] {
            answers += found.as_ref().map_or(0, check);
        }
    }
    assert!(answers > 200, "{answers}");
}

#[test]
fn records() {
    let mut answers = 0;
    for turn in 0..400 {
        let mut random = Random::new(32, turn);
        let record = values(&mut random, 200.0);
        let step = if turn % 2 == 0 {
            0.5
        } else {
            number(&mut random)
        };
        let times: Vec<f64> = (0..record.len()).map(|k| step * k as f64).collect();
        if let Ok(spectrum) = welch(&record, step, None) {
            answers += 1;
            assert!(
                spectrum.density.iter().all(|d| *d >= 0.0 && d.is_finite()),
                "{record:?} {step}"
            );
        }
        if let Ok(found) = MeanEstimate::of_record(&record) {
            let numbers = [found.mean, found.error, found.batch_error, found.effective];
            assert!(numbers.iter().all(|v| v.is_finite()), "{found:?}");
        }
        if let Ok(found) = Halves::of_record(&record) {
            assert!(found.p_value >= 0.0 && found.p_value <= 1.0, "{found:?}");
        }
        let threshold = number(&mut random);
        let found = over_threshold(&times, &record, threshold, number(&mut random));
        assert!(found.is_err() || found.unwrap().iter().all(|p| p.value > threshold));
        assert!(block_maxima(&times, &record, number(&mut random)).is_err() || !record.is_empty());
        let question = GreatestQuestion {
            statistic: Statistic::Expected,
            hours: number(&mut random),
            level: 0.9,
            method: method(&mut random),
        };
        if let Ok(sample) = PeakSample::global_maxima(&record, step) {
            answers += sample.by_weibull(&question).as_ref().map_or(0, check);
            answers += sample.by_pareto(&question).as_ref().map_or(0, check);
        }
    }
    assert!(answers > 200, "{answers}");
}

#[test]
fn rules() {
    for turn in 0..300 {
        let mut random = Random::new(33, turn);
        let sample = values(&mut random, 50.0);
        let (limit, error) = (number(&mut random), number(&mut random));
        if let Ok(mut rule) = FractileRule::new(limit, number(&mut random), error) {
            for value in &sample {
                assert_eq!(rule.observe(*value).is_ok(), value.is_finite());
                let (share, low, high) = rule.exceedance();
                assert!(low <= share && share <= high, "{rule:?}");
            }
        }
        if let Ok(mut rule) = GumbelRule::new(limit, target(&mut random), error, 3) {
            let seen = sample.iter().filter(|v| rule.observe(**v).is_ok()).count();
            assert!(seen <= sample.len());
            let _finite = rule.interval().as_ref().map_or(0, check);
        }
    }
}
