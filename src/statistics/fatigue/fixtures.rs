//! What the tests of this room share.

use crate::fatigue::rainflow::Cycle;
use crate::numerics::random::Random;

/// Numbers with spaces between.
pub(crate) fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace()
        .map(|n| n.parse().unwrap())
        .collect()
}

/// Rows in ascending order.
pub(crate) fn sorted<const N: usize>(rows: impl Iterator<Item = [f64; N]>) -> Vec<[f64; N]> {
    let mut rows: Vec<_> = rows.collect();
    rows.sort_by(|a, b| {
        let unequal = a
            .iter()
            .zip(b)
            .map(|(a, b)| a.total_cmp(b))
            .find(|o| o.is_ne());
        unequal.unwrap_or(std::cmp::Ordering::Equal)
    });
    rows
}

/// A series of 0 to 60 values, of whole numbers (with plateaus and equal ranges) as often as of real ones.
pub(crate) fn random_series(random: &mut Random) -> Vec<f64> {
    let length = (61.0 * random.uniform()) as usize;
    let whole = random.uniform() < 0.5;
    let mut value = || {
        let v = 20.0 * random.uniform() - 10.0;
        if whole { v.round() } else { v }
    };
    (0..length).map(|_| value()).collect()
}

/// Closed cycles of a range about zero.
pub(crate) fn cycles_of(range: f64, number: usize) -> Vec<Cycle> {
    let cycle = Cycle {
        range,
        mean: 0.0,
        count: 1.0,
        start: 0.0,
        end: 1.0,
    };
    vec![cycle; number]
}
