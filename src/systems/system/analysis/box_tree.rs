//! Many curves in a tree of boxes, so that those near a curve are found without looking at all (Ericson, *Real-Time Collision Detection*,
//! 2005, chapter 6).

use super::boxed_curve::{BoxedCurve, apart};
use crate::numerics::V3;

/// Curves in a tree of boxes.
#[derive(Debug, Clone)]
pub struct BoxTree {
    /// The curves by number, in the order of the leaves.
    order: Vec<usize>,
    nodes: Vec<BoxNode>,
}

/// A box around some curves that follow one another in their order.
#[derive(Debug, Clone)]
struct BoxNode {
    bounds: [V3; 2],
    from: usize,
    to: usize,
    /// The nodes of its halves; nothing for a leaf.
    halves: Option<[usize; 2]>,
}

/// Curves of a leaf.
const LEAF: usize = 4;

impl BoxTree {
    /// The tree of these curves.
    #[must_use]
    pub fn new(curves: &[BoxedCurve]) -> Self {
        let mut tree = Self {
            order: (0..curves.len()).collect(),
            nodes: Vec::new(),
        };
        if !curves.is_empty() {
            tree.divide(curves, (0, curves.len()));
        }
        tree
    }

    /// Adds the node of a range of the order, halved across its longest side, and those below it.
    fn divide(&mut self, curves: &[BoxedCurve], (from, to): (usize, usize)) -> usize {
        let mut bounds = *curves[self.order[from]].bounds();
        for curve in &self.order[from + 1..to] {
            let [least, greatest] = curves[*curve].bounds();
            bounds = [bounds[0].inf(least), bounds[1].sup(greatest)];
        }
        let number = self.nodes.len();
        self.nodes.push(BoxNode {
            bounds,
            from,
            to,
            halves: None,
        });
        if to - from > LEAF {
            let middle = |curve: &usize| {
                let [least, greatest] = curves[*curve].bounds();
                least + greatest
            };
            let places = self.order[from..to].iter().map(middle);
            let spread = places.fold(
                [V3::repeat(f64::INFINITY), V3::repeat(f64::NEG_INFINITY)],
                |[low, high]: [V3; 2], place| [low.inf(&place), high.sup(&place)],
            );
            let axis = (spread[1] - spread[0]).imax();
            let by_axis = |a: &usize, b: &usize| middle(a)[axis].total_cmp(&middle(b)[axis]);
            let half = (to - from) / 2;
            self.order[from..to].select_nth_unstable_by(half, by_axis);
            let one = self.divide(curves, (from, from + half));
            let two = self.divide(curves, (from + half, to));
            self.nodes[number].halves = Some([one, two]);
        }
        number
    }

    /// Visits curves, itself among them, roughly the nearest first; `visit` says how far off \[m\] others still matter.
    pub fn visit(&self, curve: &BoxedCurve, visit: &mut impl FnMut(usize) -> f64) {
        let mut within = f64::INFINITY;
        // The root comes first.
        let mut waiting: Vec<(f64, usize)> = vec![(0.0, 0)];
        while let Some((far, number)) = waiting.pop() {
            let Some(node) = self.nodes.get(number).filter(|_| far <= within) else {
                continue;
            };
            let Some(halves) = node.halves else {
                for other in &self.order[node.from..node.to] {
                    within = visit(*other);
                }
                continue;
            };
            let mut halves =
                halves.map(|half| (apart(curve.bounds(), &self.nodes[half].bounds), half));
            if halves[0].0 < halves[1].0 {
                halves.swap(0, 1);
            }
            waiting.extend(halves);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    #[test]
    fn the_nearest_of_many_is_found_and_few_of_them_are_visited() {
        let mut random = Random::new(11, 0);
        let short = |random: &mut Random| {
            let from = V3::from_fn(|_, _| 100.0 * random.uniform());
            let to = from + V3::from_fn(|_, _| random.uniform());
            BoxedCurve::new(vec![from, to])
        };
        let curves: Vec<BoxedCurve> = (0..1000).map(|_| short(&mut random)).collect();
        let tree = BoxTree::new(&curves);
        let mut visited = 0;
        for (number, curve) in curves.iter().enumerate() {
            let mut least = f64::INFINITY;
            tree.visit(curve, &mut |other| {
                visited += 1;
                if other != number {
                    least = curve.distance_within(&curves[other], least);
                }
                least
            });
            let all = curves.iter().enumerate();
            let others = all.filter(|(other, _)| *other != number);
            let wanted = others.map(|(_, other)| curve.distance(other));
            assert_eq!(least, wanted.fold(f64::INFINITY, f64::min));
        }
        assert!(visited < 100 * curves.len(), "{visited}");
    }
}
