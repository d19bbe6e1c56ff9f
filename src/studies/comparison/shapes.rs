//! Shapes of the line at a common time, and how far two lines are apart.

use crate::numerics::interpolation::{interval, mix, share};
use crate::run::LineShape;

/// The times \[s\] from which and up to which both runs have shapes.
#[must_use]
pub fn common_times(a: &[LineShape], b: &[LineShape]) -> Option<(f64, f64)> {
    let begin = a.first()?.time.max(b.first()?.time);
    let end = a.last()?.time.min(b.last()?.time);
    (begin <= end).then_some((begin, end))
}

/// The shapes of both runs at a time \[s\]; none where either has no shapes around it.
#[must_use]
pub fn shapes_at(a: &[LineShape], b: &[LineShape], time: f64) -> Option<[LineShape; 2]> {
    Some([shape_at(a, time)?, shape_at(b, time)?])
}

/// The shape at a time \[s\]: nodes and tensions straight in time between two stored shapes, the nearer of the two where they differ in
/// number of nodes; none outside of what is stored.
#[must_use]
pub fn shape_at(shapes: &[LineShape], time: f64) -> Option<LineShape> {
    let (first, last) = (shapes.first()?, shapes.last()?);
    if time < first.time || time > last.time {
        return None;
    }
    if shapes.len() == 1 || first.time >= last.time {
        return Some(first.clone());
    }
    let times: Vec<f64> = shapes.iter().map(|shape| shape.time).collect();
    let i = interval(&times, time);
    let part = share(&times, i, time);
    let (from, to) = (&shapes[i], &shapes[i + 1]);
    let alike = from.nodes.len() == to.nodes.len() && from.tension.len() == to.tension.len();
    if !alike {
        let nearer = if part < 0.5 { from } else { to };
        return Some(nearer.clone());
    }
    let node = |(a, b): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|axis| mix(a[axis], b[axis], part));
    let tensions = from.tension.iter().zip(&to.tension);
    Some(LineShape {
        time,
        line: from.line,
        nodes: from.nodes.iter().zip(&to.nodes).map(node).collect(),
        tension: tensions.map(|(a, b)| mix(*a, *b, part)).collect(),
        ..LineShape::default()
    })
}

/// Distances \[m\] between two lines at equal shares of their unstretched lengths, against the arc length \[m\] of the first, at its nodes.
/// Each line is its nodes and their arc lengths; none where these are not as many.
#[must_use]
pub fn distances(
    (nodes, arc): (&[[f64; 3]], &[f64]),
    (other_nodes, other_arc): (&[[f64; 3]], &[f64]),
) -> Option<Vec<(f64, f64)>> {
    let whole = *arc.last()?;
    let other_whole = *other_arc.last()?;
    let fits = |nodes: &[[f64; 3]], arc: &[f64]| nodes.len() == arc.len() && arc.len() > 1;
    if !fits(nodes, arc) || !fits(other_nodes, other_arc) || whole <= 0.0 {
        return None;
    }
    let distance = |(node, s): (&[f64; 3], &f64)| {
        let at = s / whole * other_whole;
        let i = interval(other_arc, at);
        let part = share(other_arc, i, at).clamp(0.0, 1.0);
        let gap = |axis: usize| {
            let there = mix(other_nodes[i][axis], other_nodes[i + 1][axis], part);
            there - node[axis]
        };
        let square: f64 = [0, 1, 2].map(gap).iter().map(|d| d * d).sum();
        (*s, square.sqrt())
    };
    Some(nodes.iter().zip(arc).map(distance).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(time: f64, z: f64, nodes: usize) -> LineShape {
        LineShape {
            time,
            line: 0,
            nodes: vec![[0.0, 0.0, z]; nodes],
            tension: vec![10.0 * z; nodes],
            ..LineShape::default()
        }
    }

    #[test]
    fn shapes_are_straight_in_time() {
        let shapes = [shape(0.0, 0.0, 2), shape(2.0, 4.0, 2)];
        let half = shape_at(&shapes, 0.5).unwrap();
        assert_eq!((half.nodes[1], half.tension[0]), ([0.0, 0.0, 1.0], 10.0));
        assert_eq!(shape_at(&shapes, 2.5), None);
        let other = [shape(1.0, 0.0, 5)];
        assert_eq!(common_times(&shapes, &other), Some((1.0, 1.0)));
        let [a, b] = shapes_at(&shapes, &other, 1.0).unwrap();
        assert_eq!((a.nodes.len(), b.nodes.len()), (2, 5));
    }

    #[test]
    fn meshes_may_differ() {
        let straight = |n: usize, y: f64| -> (Vec<[f64; 3]>, Vec<f64>) {
            let arc: Vec<f64> = (0..=n).map(|i| 10.0 * i as f64 / n as f64).collect();
            (arc.iter().map(|s| [*s, y, 0.0]).collect(), arc)
        };
        let (a, b) = (straight(3, 0.0), straight(7, 2.0));
        let found = distances((&a.0, &a.1), (&b.0, &b.1)).unwrap();
        assert_eq!(found.len(), 4);
        assert!(
            found.iter().all(|(_, d)| (d - 2.0).abs() < 1e-12),
            "{found:?}"
        );
        assert_eq!(distances((&a.0, &a.1[1..]), (&b.0, &b.1)), None);
    }
}
