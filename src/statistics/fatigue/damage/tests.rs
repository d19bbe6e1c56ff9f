use super::*;
use crate::fatigue::component::{Measure, chain_area};
use crate::fatigue::curve::Law;
use crate::fatigue::fixtures::{cycles_of, numbers, random_series};
use crate::fatigue::rainflow::three_point;
use crate::numerics::random::Random;

const STRENGTH: f64 = 8e6;

fn chain() -> FatigueComponent {
    let measure = Measure::Stress {
        nominal_area: chain_area(0.1),
    };
    FatigueComponent::new(
        "chain",
        Law::new(3.0, 6.0e10_f64.log10()),
        measure,
        Some(STRENGTH),
    )
    .unwrap()
}

fn rope() -> FatigueComponent {
    let law = Law::new(5.05, 3.25)
        .falling_with_mean(3.43)
        .with_knee(1e5, 7.0);
    FatigueComponent::new("rope", law, Measure::TensionRatio, Some(STRENGTH)).unwrap()
}

/// A record of tensions about 2 MN, some of them slack.
fn record(random: &mut Random) -> Vec<f64> {
    random_series(random)
        .iter()
        .map(|v| 2e6 + 3e5 * v)
        .collect()
}

#[test]
fn the_cycles_to_failure_do_a_damage_of_one() {
    let range = 100e6 * chain_area(0.1);
    let total = damage(
        &cycles_of(range, 60_000),
        &chain(),
        MeanCorrection::None,
        MeanLoad::OfCycle,
    )
    .unwrap();
    assert!((total.sum - 1.0).abs() < 1e-9 && total.cycles == 6e4);
    assert!((total.per_hour(1800.0).unwrap() - 2.0).abs() < 1e-9);
    assert!((total.per_year(YEAR).unwrap() - 1.0).abs() < 1e-9);
    assert!(total.per_year(0.0).is_err() && total.per_hour(f64::NAN).is_err());
}

/// Lines of the fixture: a curve of one or two slopes, ranges of stress, counts, Miner's sum of qats.
#[test]
fn as_summed_by_qats() {
    let mut rows = 0;
    for line in include_str!("../fixtures/miner.txt")
        .lines()
        .filter(|l| !l.starts_with('#'))
    {
        let fields: Vec<Vec<f64>> = line.split('|').map(numbers).collect();
        let mut law = Law::new(fields[0][0], fields[0][1]);
        if fields[0][2] > 0.0 {
            law = law.with_knee(fields[0][3], fields[0][2]);
        }
        // Of an area of 1 m2 a tension of 1 MN is a stress of 1 MPa.
        let measure = Measure::Stress { nominal_area: 1.0 };
        let component = FatigueComponent::new("", law, measure, None).unwrap();
        let pairs = fields[1].iter().zip(&fields[2]);
        let cycles: Vec<Cycle> = pairs
            .map(|(range, &count)| Cycle {
                count,
                ..cycles_of(range * 1e6, 1)[0]
            })
            .collect();
        let sum = damage(&cycles, &component, MeanCorrection::None, MeanLoad::OfCycle)
            .unwrap()
            .sum;
        assert!((sum / fields[3][0] - 1.0).abs() < 1e-11, "{sum} of {line}");
        rows += 1;
    }
    assert_eq!(rows, 60);
}

#[test]
fn no_cycles_do_no_damage() {
    let none = damage(&[], &chain(), MeanCorrection::None, MeanLoad::OfCycle).unwrap();
    assert_eq!(
        (none.sum, none.cycles, none.range_exponent),
        (0.0, 0.0, 3.0)
    );
}

/// All three slopes against sums of changed tensions.
#[test]
fn slopes_are_those_of_differences() {
    let mut random = Random::new(12, 0);
    let goodman = MeanCorrection::Goodman { strength: STRENGTH };
    for turn in 0..200 {
        let component = if turn % 2 == 0 { chain() } else { rope() };
        let correction = if turn % 4 < 2 {
            goodman
        } else {
            MeanCorrection::None
        };
        let cycles = three_point(&record(&mut random)).unwrap();
        let sum = |change: &dyn Fn(&Cycle) -> Cycle| -> f64 {
            let changed: Vec<Cycle> = cycles.iter().map(change).collect();
            damage(&changed, &component, correction, MeanLoad::OfCycle)
                .unwrap()
                .sum
        };
        let at = damage(&cycles, &component, correction, MeanLoad::OfCycle).unwrap();
        if at.sum == 0.0 {
            continue;
        }
        let h = 1e-5;
        let scaled = |f: f64| {
            sum(&|c| Cycle {
                range: c.range * f,
                mean: c.mean * f,
                ..*c
            })
        };
        let found = (scaled(1.0 + h) - scaled(1.0 - h)) / (2.0 * h * at.sum);
        assert!(
            (found - at.tension_exponent).abs() < 1e-4 * found,
            "{found} {at:?}"
        );
        let ranges = |f: f64| {
            sum(&|c| Cycle {
                range: c.range * f,
                ..*c
            })
        };
        let found = (ranges(1.0 + h) - ranges(1.0 - h)) / (2.0 * h * at.sum);
        assert!(
            (found - at.range_exponent).abs() < 1e-4 * found,
            "{found} {at:?}"
        );
        let longer = |by: f64| {
            sum(&|c| Cycle {
                range: c.range + by,
                ..*c
            })
        };
        let found = longer(1.0) - longer(0.0);
        if cycles.iter().all(|c| c.range > 1e4) {
            assert!(
                (found - at.range_slope).abs() < 1e-2 * found,
                "{found} {at:?}"
            );
        }
    }
}

/// The damage of a record whose tensions are wrong by up to 2% lies within the bounds of the exact one.
#[test]
fn an_error_bar_of_the_tension_is_carried_to_the_damage() {
    let mut random = Random::new(13, 0);
    for _ in 0..100 {
        let tensions = record(&mut random);
        let sum = |factor: f64| {
            let scaled: Vec<f64> = tensions.iter().map(|t| t * factor).collect();
            let cycles = three_point(&scaled).unwrap();
            damage(&cycles, &chain(), MeanCorrection::None, MeanLoad::OfCycle).unwrap()
        };
        let (low, high) = sum(1.0).bounds(0.02).unwrap();
        assert!(
            (sum(0.98).sum - low).abs() <= 1e-9 * low
                && (sum(1.02).sum - high).abs() <= 1e-9 * high
        );
    }
    let one = Damage {
        sum: 1.0,
        tension_exponent: 3.0,
        range_slope: 2.0,
        ..Damage::default()
    };
    assert!(one.bounds(1.0).is_err() && one.bounds(-0.1).is_err() && one.bounds(f64::NAN).is_err());
    assert_eq!(one.error_of_ranges(-0.5), 1.0);
}

#[test]
fn the_equivalent_range_does_the_same_damage() {
    let mut random = Random::new(14, 0);
    let plain = |cycles: &[Cycle]| {
        damage(cycles, &chain(), MeanCorrection::None, MeanLoad::OfCycle).unwrap()
    };
    for _ in 0..50 {
        let cycles = three_point(&record(&mut random)).unwrap();
        let range = equivalent_range(&cycles, 3.0, 1000.0).unwrap();
        let (a, b) = (plain(&cycles_of(range, 1000)).sum, plain(&cycles).sum);
        assert!((a - b).abs() <= 1e-11 * b, "{a} {b}");
    }
    assert_eq!(equivalent_range(&[], 3.0, 1.0).unwrap(), 0.0);
    let huge = equivalent_range(&cycles_of(1e200, 3), 9.0, 3.0).unwrap();
    assert!((huge / 1e200 - 1.0).abs() < 1e-12);
    assert!(
        equivalent_range(&[], 0.0, 1.0).is_err() && equivalent_range(&[], 3.0, f64::NAN).is_err()
    );
    assert!(equivalent_range(&cycles_of(f64::NAN, 1), 3.0, 1.0).is_err());
}

/// Whatever numbers come, the answer is a finite damage or an error.
#[test]
fn whatever_comes_is_finite_or_refused() {
    let mut random = Random::new(15, 0);
    let odd = [
        0.0,
        -0.0,
        1.0,
        -3.0,
        1e-310,
        1e300,
        f64::MAX,
        f64::NAN,
        f64::INFINITY,
        1e6,
        2e6,
    ];
    let (chain, rope) = (chain(), rope());
    let mut refused = 0;
    for turn in 0..20_000 {
        let mut pick = || odd[(odd.len() as f64 * random.uniform()) as usize];
        let cycle = Cycle {
            range: pick(),
            mean: pick(),
            count: pick(),
            start: pick(),
            end: pick(),
        };
        let correction = match turn % 3 {
            0 => MeanCorrection::Goodman { strength: pick() },
            1 => MeanCorrection::Goodman { strength: STRENGTH },
            _ => MeanCorrection::None,
        };
        let mean = if turn % 2 == 0 {
            MeanLoad::OfCycle
        } else {
            MeanLoad::OfRecord(pick())
        };
        let component = if turn % 5 == 0 { &rope } else { &chain };
        match damage(&[cycle; 2], component, correction, mean) {
            Ok(d) => {
                let numbers = [
                    d.sum,
                    d.cycles,
                    d.greatest_range,
                    d.range_exponent,
                    d.tension_exponent,
                    d.range_slope,
                ];
                assert!(numbers.iter().all(|n| n.is_finite()), "{cycle:?} {d:?}");
            }
            Err(error) => {
                assert!(!error.to_string().is_empty());
                refused += 1;
            }
        }
        if let Ok(range) = equivalent_range(&[cycle; 2], pick(), pick()) {
            assert!(range.is_finite());
        }
    }
    assert!((1000..19_900).contains(&refused), "{refused}");
}
