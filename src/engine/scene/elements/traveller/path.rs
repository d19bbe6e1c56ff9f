//! Path interpolation of a traveller between the nodes, with a continuous first and a bounded second derivative by arc length.
//!
//! On straight segments the direction would jump at every node, and a load would sink deeper at the nodes than between them: a
//! body that travels would be shaken once a segment. The path rounds each corner over half of the shorter segment to either side:
//! with e the direction of a segment by its unstretched length, r the arc length from the node, h the half segment and u = r / 2h,
//! `X = polygon + (e_after - e_before) h (1 - |u| - sqrt(1/2 - u²))` for `|r| <= h`, an arc tangent to both segments.
//!
//! A taut string under tension H gives way to a load Q by `Q / H` times `s (L - s) / L`; shared by nodes with weights n, by
//! `Q / 2H sum n_i n_j |s_i - s_j|` less. That is zero on a node and a quarter of the segment between two for a polygon, 7/32 and 1/4 for
//! the quadratic B-spline; by the arc above it is a quarter of the segment everywhere where segments are even. The path falls
//! short of the line by the first power of the segment length, evenly.

use crate::numerics::V3;
use crate::solve::State;

/// Weight of a node at a point of the path.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(in crate::scene) struct NodeWeight {
    /// The weight \[-\].
    pub(in crate::scene) share: f64,
    /// Its derivative by arc length \[1/m\].
    pub(in crate::scene) slope: f64,
    /// Its second derivative \[1/m²\].
    pub(in crate::scene) bend: f64,
}

/// A point of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::scene) struct PathPoint {
    /// Its segment.
    pub(in crate::scene) segment: usize,
    /// Speed along the unstretched line \[m/s\].
    pub(in crate::scene) rate: f64,
    /// Rate of that \[m/s²\].
    pub(in crate::scene) gain: f64,
    first: usize,
    count: usize,
    weights: [NodeWeight; 3],
}

impl PathPoint {
    /// The point at an arc length \[m\], with its rate \[m/s\] and second rate \[m/s²\], on a line with nodes at `arc`.
    pub(in crate::scene) fn new(arc: &[f64], (at, rate, gain): (f64, f64, f64)) -> Self {
        let last = arc.len() - 1;
        let segment = arc[1..last].partition_point(|end| *end <= at);
        let length = |i: usize| arc[i + 1] - arc[i];
        let here = length(segment);
        let along = ((at - arc[segment]) / here).clamp(0.0, 1.0);
        let straight = |share: f64, sign: f64| NodeWeight {
            share,
            slope: sign / here,
            bend: 0.0,
        };
        let pair = [straight(1.0 - along, -1.0), straight(along, 1.0)];
        let rounded = |node: usize| {
            let reach = 0.5 * length(node - 1).min(length(node));
            let from = arc[segment] + along * here - arc[node];
            (from.abs() <= reach).then_some((node, reach, from))
        };
        let before = (segment > 0).then(|| rounded(segment)).flatten();
        let after = || (segment + 1 < last).then(|| rounded(segment + 1)).flatten();
        let mut point = Self {
            segment,
            rate,
            gain,
            first: segment,
            count: 2,
            weights: [pair[0], pair[1], NodeWeight::default()],
        };
        if let Some((node, reach, from)) = before.or_else(after) {
            point.count = 3;
            point.first = node - 1;
            if node == segment {
                point.weights = [NodeWeight::default(), pair[0], pair[1]];
            }
            // From the node, by the length of both halves.
            let u = 0.5 * from / reach;
            let root = (0.5 - u * u).sqrt();
            let corner = NodeWeight {
                share: reach * (1.0 - u.abs() - root),
                slope: 0.5 * (u / root - u.signum()),
                bend: 0.125 / (reach * root.powi(3)),
            };
            let (b, a) = (1.0 / length(node - 1), 1.0 / length(node));
            for (weight, by) in point.weights.iter_mut().zip([b, -a - b, a]) {
                weight.share += by * corner.share;
                weight.slope += by * corner.slope;
                weight.bend += by * corner.bend;
            }
        }
        point
    }

    /// The nodes with their weights.
    pub(in crate::scene) fn nodes(&self) -> impl Iterator<Item = (usize, &NodeWeight)> {
        (self.first..).zip(&self.weights[..self.count])
    }

    fn sum(&self, values: &[V3], of: impl Fn(&NodeWeight) -> f64) -> V3 {
        self.nodes()
            .map(|(node, weight)| values[node] * of(weight))
            .sum()
    }

    /// Position \[m\].
    pub(in crate::scene) fn place(&self, state: &State) -> V3 {
        self.sum(&state.x, |by| by.share)
    }

    /// Velocity along the path \[m/s\].
    pub(in crate::scene) fn path_velocity(&self, state: &State) -> V3 {
        self.sum(&state.x, |by| by.slope) * self.rate
    }

    /// Velocity \[m/s\].
    pub(in crate::scene) fn velocity(&self, state: &State) -> V3 {
        self.sum(&state.v, |by| by.share) + self.path_velocity(state)
    }

    /// Acceleration \[m/s²\].
    pub(in crate::scene) fn acceleration(&self, state: &State) -> V3 {
        let along = |by: &NodeWeight| self.gain * by.slope + self.rate * self.rate * by.bend;
        self.sum(&state.a, |by| by.share)
            + self.sum(&state.v, |by| by.slope) * (2.0 * self.rate)
            + self.sum(&state.x, along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ARC: [f64; 5] = [0.0, 2.0, 5.0, 6.0, 10.0];

    fn weights(at: f64) -> [NodeWeight; 5] {
        let mut all = [NodeWeight::default(); 5];
        for (node, weight) in PathPoint::new(&ARC, (at, 1.0, 0.0)).nodes() {
            all[node] = *weight;
        }
        all
    }

    /// Shares make one, follow a straight line, and change without a jump; so do their slopes.
    #[test]
    fn the_path_is_smooth_and_keeps_to_a_straight_line() {
        let h = 1e-6;
        for step in 0..=1000 {
            let at = 0.01 * f64::from(step);
            let now = weights(at);
            let sum: f64 = now.iter().map(|w| w.share).sum();
            let place: f64 = now.iter().zip(ARC).map(|(w, arc)| w.share * arc).sum();
            assert!(
                (sum - 1.0).abs() < 1e-14 && (place - at).abs() < 1e-13,
                "{at}"
            );
            if (h..10.0 - h).contains(&at) {
                for ((a, b), w) in weights(at - h).iter().zip(weights(at + h)).zip(now) {
                    assert!(
                        ((b.share - a.share) / (2.0 * h) - w.slope).abs() < 1e-5,
                        "{at}"
                    );
                    assert!((b.slope - a.slope).abs() < 8.0 * h, "{at}");
                }
            }
        }
    }

    /// A load on a string sinks a quarter of a segment times Q / H less than on the line itself, wherever it is.
    #[test]
    fn a_load_sinks_evenly() {
        let arc: Vec<f64> = (0..9).map(f64::from).collect();
        for step in 0..=60 {
            let point = PathPoint::new(&arc, (1.0 + 0.1 * f64::from(step), 1.0, 0.0));
            let spread = |(i, by): (usize, &NodeWeight)| -> f64 {
                let with = point
                    .nodes()
                    .map(|(j, other)| other.share * (arc[j] - arc[i]).abs());
                0.5 * by.share * with.sum::<f64>()
            };
            let spread: f64 = point.nodes().map(spread).sum();
            assert!((spread - 0.25).abs() < 1e-14, "{step} {spread}");
        }
    }

    /// Where the nodes lie on a parabola with even segments, the mean of the second derivative is its own.
    #[test]
    fn its_second_derivative_is_the_curvature() {
        const PLACES: usize = 1000;
        let arc: Vec<f64> = (0..9).map(f64::from).collect();
        let mut state = State::at_rest(arc.iter().map(|s| V3::new(*s, 0.0, 0.3 * s * s)).collect());
        state.v.fill(V3::zeros());
        let bent = |k: usize| {
            let at = 2.0 + (k as f64 + 0.5) / PLACES as f64;
            PathPoint::new(&arc, (at, 2.0, 0.0)).acceleration(&state)
        };
        let mean = (0..PLACES).map(bent).sum::<V3>() / PLACES as f64;
        assert!((mean - V3::z() * (4.0 * 0.6)).norm() < 1e-5, "{mean}");
    }
}
