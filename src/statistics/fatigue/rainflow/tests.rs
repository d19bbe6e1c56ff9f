use super::*;
use crate::fatigue::fixtures::{numbers, random_series, sorted};
use crate::fatigue::four_point::FourPointCounter;
use crate::numerics::random::Random;

/// ASTM E1049-85, figure 6 and table X1.1: the count of the series -2 1 -3 5 -1 3 -4 4 -2.
#[test]
fn the_example_of_the_standard() {
    let cycles = three_point(&[-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0]).unwrap();
    let count = |range: f64| -> f64 {
        let same = cycles.iter().filter(|c| c.range == range);
        same.map(|c| c.count).sum()
    };
    let table: Vec<f64> = (1..=10).map(|range| count(f64::from(range))).collect();
    assert_eq!(table, [0.0, 0.0, 0.5, 1.5, 0.0, 0.5, 0.0, 1.0, 0.5, 0.0]);
    let closed: Vec<&Cycle> = cycles.iter().filter(|c| c.count == 1.0).collect();
    assert_eq!((closed.len(), closed[0].mean), (1, 1.0), "E-F from -1 to 3");
    assert_eq!((closed[0].start, closed[0].end), (4.0, 5.0));
}

/// Every line of the fixture: values, then range, mean and count of qats.
#[test]
fn as_counted_by_qats() {
    let mut series = 0;
    for line in include_str!("../fixtures/qats.txt")
        .lines()
        .filter(|l| !l.starts_with('#'))
    {
        let (values, expected) = line.split_once('|').unwrap();
        let cycles = three_point(&numbers(values)).unwrap();
        let found = sorted(cycles.iter().map(|c| [c.range, c.mean, c.count]));
        let expected = sorted(expected.split(';').map(|row| {
            let row = numbers(row);
            [row[0], row[1], row[2]]
        }));
        assert_eq!(found, expected, "of {values}");
        series += 1;
    }
    assert_eq!(series, 1060);
}

#[test]
fn mirrored_and_scaled_series() {
    let mut random = Random::new(5, 0);
    for _ in 0..300 {
        let values = random_series(&mut random);
        let cycles = three_point(&values).unwrap();
        for factor in [-1.0, 8.0, -0.25] {
            let other: Vec<f64> = values.iter().map(|v| v * factor).collect();
            let expected = cycles.iter().map(|c| Cycle {
                range: c.range * f64::abs(factor),
                mean: c.mean * factor,
                ..*c
            });
            assert_eq!(three_point(&other).unwrap(), expected.collect::<Vec<_>>());
        }
    }
}

/// All ranges add up to the total variation: every closed cycle is gone through twice, every half once.
#[test]
fn ranges_make_up_the_total_variation() {
    let mut random = Random::new(6, 0);
    for _ in 0..300 {
        let values = random_series(&mut random);
        let variation: f64 = values.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
        let cycles = three_point(&values).unwrap();
        let sum: f64 = cycles.iter().map(|c| 2.0 * c.count * c.range).sum();
        assert!(
            (sum - variation).abs() <= 1e-12 * variation,
            "{sum} of {variation}"
        );
        let greatest = cycles.iter().map(|c| c.range).fold(0.0, f64::max);
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(greatest, if values.is_empty() { 0.0 } else { high - low });
    }
}

#[test]
fn pauses_and_points_between_change_nothing() {
    let mut random = Random::new(7, 0);
    for _ in 0..200 {
        let values = random_series(&mut random);
        let mut counter = ThreePointCounter::new();
        let mut cycles = Vec::new();
        let mut time = 0.0;
        let mut previous = None;
        for &value in &values {
            let between = previous.map(|p: f64| p + 0.5 * (value - p));
            for value in between.into_iter().chain([value, value]) {
                time += 1.0;
                counter
                    .push(time, value, |cycle| cycles.push(cycle))
                    .unwrap();
            }
            previous = Some(value);
            counter = counter.clone();
        }
        counter.finish(|cycle| cycles.push(cycle));
        let found = cycles.iter().map(|c| (c.range, c.mean, c.count));
        let whole = three_point(&values).unwrap();
        let expected = whole.iter().map(|c| (c.range, c.mean, c.count));
        assert_eq!(found.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
    }
}

/// A counter stored and read again at any value goes on as if nothing had been.
#[test]
fn stored_states_go_on() {
    let mut random = Random::new(20, 0);
    for _ in 0..60 {
        let values = random_series(&mut random);
        let (mut counter, mut cycles) = (ThreePointCounter::new(), Vec::new());
        for (time, value) in places(&values) {
            let text = serde_json::to_string(&counter).unwrap();
            counter = serde_json::from_str(&text).unwrap();
            assert!(counter.is_sound(), "{text}");
            counter
                .push(time, value, |cycle| cycles.push(cycle))
                .unwrap();
        }
        counter.finish(|cycle| cycles.push(cycle));
        assert_eq!(cycles, three_point(&values).unwrap());
    }
    let unsound =
        r#"{"turning":{"candidate":null,"rises":null,"last_time":1.0,"seen":0},"open":[]}"#;
    assert!(
        !serde_json::from_str::<ThreePointCounter>(unsound)
            .unwrap()
            .is_sound()
    );
}

/// Whatever values and times come, they are refused or give cycles of finite numbers, and never more open turning points
/// than values.
#[test]
fn whatever_comes_is_counted_or_refused() {
    let mut random = Random::new(21, 0);
    let odd = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e300,
        -1e300,
        1e-320,
        f64::MAX,
        f64::NAN,
        f64::INFINITY,
        2.0,
    ];
    let (mut refused, mut counted) = (0, 0);
    for _ in 0..2000 {
        let mut pick = || odd[(odd.len() as f64 * random.uniform()) as usize];
        let (mut three, mut four) = (ThreePointCounter::new(), FourPointCounter::new());
        let mut check = |cycle: Cycle| {
            let numbers = [cycle.range, cycle.mean, cycle.start, cycle.end];
            assert!(
                numbers.iter().all(|n| n.is_finite()) && cycle.range > 0.0,
                "{cycle:?}"
            );
            counted += 1;
        };
        for step in 0..20 {
            let time = if pick() == 1.0 {
                pick()
            } else {
                f64::from(step)
            };
            let value = pick();
            let outcome = three.push(time, value, &mut check);
            assert_eq!(outcome.is_ok(), four.push(time, value, &mut check).is_ok());
            refused += usize::from(outcome.is_err());
            assert!(three.is_sound() && four.is_sound() && three.open() <= 20);
        }
        three.finish(&mut check);
        let residue = four.finish(&mut check);
        residue.half_cycles().for_each(&mut check);
        residue
            .closed_by_repeating()
            .into_iter()
            .for_each(&mut check);
    }
    assert!(refused > 1000 && counted > 10_000, "{refused} {counted}");
}

#[test]
fn series_without_cycles_and_bad_ones() {
    assert!(three_point(&[]).unwrap().is_empty());
    assert!(three_point(&[3.0]).unwrap().is_empty());
    assert!(three_point(&[3.0; 9]).unwrap().is_empty());
    assert_eq!(three_point(&[3.0, 1.0]).unwrap()[0].count, 0.5);
    assert!(three_point(&[3.0, f64::NAN]).is_err());
}
