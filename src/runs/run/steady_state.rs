//! The time from which on a response is steady.

use super::response::AskedResponse;
use super::{LineShape, Quantity, QuantityId, Subject};
use crate::numerics::V3;

/// A period counts as steady when its root mean square is this near to that of the last one.
const BAND: f64 = 0.05;
/// Nodes that move less than this share of the farthest do not count.
const STILL: f64 = 1e-6;

/// Time \[s\] from which on every period of the driving moves the line as far as the last one does, to a twentieth:
/// root mean squares over all nodes about their mean places, each by its own root mean square of the recorded window, so
/// that a place counts however little it moves; of several lines the last to. Nothing where nothing drives the lines at one
/// period, or fewer than four shapes a period are stored.
#[must_use]
pub fn settling_quantity(asked: Option<AskedResponse>, shapes: &[LineShape]) -> Option<Quantity> {
    let AskedResponse { from, period } = asked?;
    let period = period?;
    let lines = shapes.iter().map(|shape| shape.line).max()? + 1;
    let mut value = f64::NEG_INFINITY;
    for line in 0..lines {
        let own: Vec<&LineShape> = shapes.iter().filter(|shape| shape.line == line).collect();
        value = value.max(steady_from(&own, period, from)?);
    }
    let id = QuantityId::single(Subject::SteadyTime);
    Some(Quantity::new(id, value))
}

fn steady_from(shapes: &[&LineShape], period: f64, from: f64) -> Option<f64> {
    let first = shapes.first()?;
    let nodes = first.nodes.len();
    let of_whole = shapes.iter().filter(|s| s.nodes.len() == nodes);
    let whole: Vec<&LineShape> = of_whole.copied().collect();
    let recorded: Vec<&&LineShape> = whole.iter().filter(|s| s.time >= from).collect();
    let count = recorded.len() as f64;
    let mean: Vec<V3> = (0..nodes)
        .map(|i| recorded.iter().map(|s| V3::from(s.nodes[i])).sum::<V3>() / count)
        .collect();
    let off = |shape: &LineShape, i: usize| (V3::from(shape.nodes[i]) - mean[i]).norm_squared();
    let own: Vec<f64> = (0..nodes)
        .map(|i| recorded.iter().map(|s| off(s, i)).sum::<f64>() / count)
        .collect();
    let still = STILL * STILL * own.iter().copied().fold(0.0, f64::max);
    let moving: Vec<usize> = (0..nodes).filter(|i| own[*i] > still).collect();
    let square = |shape: &LineShape| -> f64 {
        let each = moving.iter().map(|i| off(shape, *i) / own[*i]);
        each.sum::<f64>() / moving.len().max(1) as f64
    };
    let squares: Vec<(f64, f64)> = whole.iter().map(|s| (s.time, square(s))).collect();
    // Root mean square over the period that ends at each shape.
    let periods = squares
        .iter()
        .enumerate()
        .filter(|(_, s)| s.0 >= first.time + period);
    let sizes: Option<Vec<(f64, f64)>> = periods
        .map(|(i, (time, _))| {
            let since = squares.partition_point(|s| s.0 <= time - period * (1.0 + 1e-9));
            let inside = &squares[since..=i];
            let sum: f64 = inside.iter().map(|s| s.1).sum();
            (inside.len() >= 4).then(|| (time - period, (sum / inside.len() as f64).sqrt()))
        })
        .collect();
    let sizes = sizes?;
    let last = sizes.last()?.1;
    let off = sizes.iter().rposition(|s| (s.1 - last).abs() > BAND * last);
    match off {
        None => Some(first.time),
        Some(at) => sizes.get(at + 1).map(|s| s.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_that_grows_is_steady_once_it_is_within_a_twentieth() {
        let shape = |n: i32| {
            let time = 0.5 * f64::from(n);
            let size = (time / 40.0).min(1.0);
            let z = size * (std::f64::consts::TAU * time / 10.0).sin();
            LineShape {
                time,
                line: 0,
                nodes: vec![[0.0; 3], [1.0, 0.0, z]],
                tension: vec![0.0; 2],
                ..LineShape::default()
            }
        };
        let shapes: Vec<LineShape> = (0..=400).map(shape).collect();
        let shapes: Vec<&LineShape> = shapes.iter().collect();
        let from = steady_from(&shapes, 10.0, 100.0).unwrap();
        assert!((32.0..=40.0).contains(&from), "{from}");
        assert!(steady_from(&shapes, 1.0, 100.0).is_none());
        assert!(steady_from(&[], 1.0, 100.0).is_none());
    }
}
