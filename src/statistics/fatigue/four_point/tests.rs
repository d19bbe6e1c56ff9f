use super::*;
use crate::fatigue::classes::Classes;
use crate::fatigue::fixtures::{numbers, random_series, sorted};
use crate::fatigue::rainflow::three_point;
use crate::numerics::random::Random;

fn both(cycles: &[Cycle]) -> Vec<[f64; 3]> {
    sorted(cycles.iter().map(|c| [c.range, c.mean, c.count]))
}

/// Lines of the fixture: classes | values | closed cycles | residue | cycles of the residue repeated, as numbers of
/// classes of fatpack. Where fatpack's joint leaves out an extreme, the last field is missing.
#[test]
fn as_counted_by_fatpack() {
    let (mut series, mut repeated) = (0, 0);
    for line in include_str!("../fixtures/fatpack.txt")
        .lines()
        .filter(|l| !l.starts_with('#'))
    {
        let fields: Vec<&str> = line.split('|').collect();
        let values = numbers(fields[1]);
        let classes = Classes::of_values(&values, fields[0].parse().unwrap()).unwrap();
        let count = four_point(&classes.rounded(&values)).unwrap();
        let step = classes.centre(f64::INFINITY) - classes.centre(f64::NEG_INFINITY);
        let step = step / fields[0].parse::<f64>().unwrap();
        let in_classes = |cycles: &[Cycle]| -> Vec<(i64, i64)> {
            let low = classes.centre(f64::NEG_INFINITY);
            let pair = |c: &Cycle| {
                let (range, sum) = (c.range / step, 2.0 * (c.mean - low) / step);
                assert!((range - range.round()).abs() < 1e-9 && (sum - sum.round()).abs() < 1e-9);
                (range.round() as i64, sum.round() as i64)
            };
            let mut pairs: Vec<_> = cycles.iter().map(pair).collect();
            pairs.sort_unstable();
            pairs
        };
        let pairs = |field: &str| -> Vec<(i64, i64)> {
            let rows = field.split(';').filter(|row| !row.is_empty()).map(numbers);
            let mut pairs: Vec<_> = rows
                .map(|p| ((p[0] - p[1]).abs() as i64, (p[0] + p[1]) as i64))
                .collect();
            pairs.sort_unstable();
            pairs
        };
        assert_eq!(in_classes(&count.cycles), pairs(fields[2]), "{line}");
        let residue = count
            .residue
            .reversals()
            .iter()
            .map(|r| classes.index(r.value) as f64);
        assert_eq!(residue.collect::<Vec<_>>(), numbers(fields[3]), "{line}");
        if let Some(field) = fields.get(4) {
            assert_eq!(
                in_classes(&count.residue.closed_by_repeating()),
                pairs(field),
                "{line}"
            );
            repeated += 1;
        }
        series += 1;
    }
    assert_eq!(series, 1000);
    assert!(repeated > 300, "{repeated}");
}

#[test]
fn with_half_cycles_it_is_the_three_point_count() {
    let mut random = Random::new(8, 0);
    for _ in 0..500 {
        let values = random_series(&mut random);
        let four = four_point(&values).unwrap().with_half_cycles();
        let three = three_point(&values).unwrap();
        let damage =
            |cycles: &[Cycle]| -> f64 { cycles.iter().map(|c| c.count * c.range.powi(3)).sum() };
        let (a, b) = (damage(&four), damage(&three));
        assert!((a - b).abs() <= 1e-12 * b, "{a} {b}");
        let half = |cycles: &[Cycle]| cycles.iter().map(|c| 2.0 * c.count * c.range).sum::<f64>();
        assert!((half(&four) - half(&three)).abs() <= 1e-12 * half(&three));
    }
}

/// ASTM E1049-85, 5.4.5: of a repeating history arranged to begin at its greatest value all cycles are closed.
#[test]
fn repeating_is_the_count_from_the_greatest_value_on() {
    let mut random = Random::new(9, 0);
    for _ in 0..500 {
        let values = random_series(&mut random);
        let Some(peak) = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])) else {
            continue;
        };
        let found = four_point(&values).unwrap().repeating();
        let around: Vec<f64> = (0..=values.len())
            .map(|i| values[(peak + i) % values.len()])
            .collect();
        let three = three_point(&around).unwrap();
        // Ranges from the greatest value come as two equal halves, down and up again.
        let (halves, closed): (Vec<Cycle>, Vec<Cycle>) = three.iter().partition(|c| c.count == 0.5);
        let ranges = |cycles: &[Cycle]| both(cycles).iter().map(|r| r[0]).collect::<Vec<_>>();
        let halves = ranges(&halves);
        assert!(
            halves.chunks(2).all(|pair| pair[0] == pair[1]),
            "{halves:?}"
        );
        let mut expected = ranges(&closed);
        expected.extend(halves.iter().step_by(2));
        expected.sort_by(f64::total_cmp);
        assert_eq!(ranges(&found), expected, "{values:?}");
    }
}

#[test]
fn the_joint_keeps_the_extremes() {
    // Start and end of the residue turn opposite ways: the start lies between its neighbours once joined.
    let count = four_point(&[0.0, 5.0, -7.0]).unwrap();
    assert!(count.cycles.is_empty());
    let closed = count.residue.closed_by_repeating();
    assert_eq!(
        (closed.len(), closed[0].range, closed[0].mean),
        (1, 12.0, -1.0)
    );
}

#[test]
fn series_without_cycles_and_bad_ones() {
    for values in [&[][..], &[2.0], &[2.0, 2.0, 2.0]] {
        let count = four_point(values).unwrap();
        assert!(count.clone().repeating().is_empty() && count.with_half_cycles().is_empty());
    }
    let two = four_point(&[2.0, 5.0]).unwrap();
    assert_eq!(two.residue.closed_by_repeating()[0].range, 3.0);
    assert!(four_point(&[0.0, f64::NEG_INFINITY]).is_err());
}
