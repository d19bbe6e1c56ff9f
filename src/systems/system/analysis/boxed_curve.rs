//! The least distance of two polylines, by boxes around their parts: of two lines far apart only the boxes around the whole are looked
//! at, of two that are near the parts that are (Ericson, *Real-Time Collision Detection*, 2005, chapter 6).

use std::ops::Range;

use crate::numerics::V3;

/// A polyline with boxes around its parts, halved down to single segments.
#[derive(Debug, Clone)]
pub struct BoxedCurve {
    points: Vec<V3>,
    /// Least and greatest coordinates: of the whole, then those of the halves of box k at 2 k + 1 and 2 k + 2.
    boxes: Vec<[V3; 2]>,
}

/// A part of a polyline: its box, and its segments.
type CurvePart = (usize, Range<usize>);

impl BoxedCurve {
    /// Two points or more.
    #[must_use]
    pub fn new(points: Vec<V3>) -> Self {
        let segments = points.len().saturating_sub(1).max(1);
        let count = 2 * segments.next_power_of_two();
        let mut boxes = vec![[V3::zeros(); 2]; count];
        enclose(&points, &mut boxes, &(0, 0..segments));
        Self { points, boxes }
    }

    /// The points.
    #[must_use]
    pub fn points(&self) -> &[V3] {
        &self.points
    }

    /// The least distance from another.
    #[must_use]
    pub fn distance(&self, other: &Self) -> f64 {
        self.distance_within(other, f64::INFINITY)
    }

    /// The same where it is below a bound; else the bound.
    #[must_use]
    pub fn distance_within(&self, other: &Self, bound: f64) -> f64 {
        let mut best = bound;
        self.search(self.whole(), other, other.whole(), &mut best);
        best
    }

    /// Least and greatest coordinates of the whole \[m\].
    #[must_use]
    pub fn bounds(&self) -> &[V3; 2] {
        &self.boxes[0]
    }

    /// What the least distance is not below.
    #[must_use]
    pub fn distance_of_boxes(&self, other: &Self) -> f64 {
        apart(&self.boxes[0], &other.boxes[0])
    }

    fn whole(&self) -> CurvePart {
        (0, 0..self.points.len() - 1)
    }

    fn search(&self, own: CurvePart, other: &Self, others: CurvePart, best: &mut f64) {
        if apart(&self.boxes[own.0], &other.boxes[others.0]) >= *best {
            return;
        }
        match (own.1.len(), others.1.len()) {
            (1, 1) => {
                let (i, j) = (own.1.start, others.1.start);
                let (p, q) = nearest(&self.points[i..i + 2], &other.points[j..j + 2]);
                *best = best.min((p - q).norm());
            }
            (long, short) if long >= short => {
                let far = |part: &CurvePart| apart(&self.boxes[part.0], &other.boxes[others.0]);
                let [first, then] = nearer_first(halves(&own), far);
                self.search(first, other, others.clone(), best);
                self.search(then, other, others, best);
            }
            _ => {
                let far = |part: &CurvePart| apart(&self.boxes[own.0], &other.boxes[part.0]);
                let [first, then] = nearer_first(halves(&others), far);
                self.search(own.clone(), other, first, best);
                self.search(own, other, then, best);
            }
        }
    }
}

fn halves((node, segments): &CurvePart) -> [CurvePart; 2] {
    let middle = segments.start + segments.len() / 2;
    [
        (2 * node + 1, segments.start..middle),
        (2 * node + 2, middle..segments.end),
    ]
}

fn nearer_first([one, two]: [CurvePart; 2], far: impl Fn(&CurvePart) -> f64) -> [CurvePart; 2] {
    if far(&two) < far(&one) {
        [two, one]
    } else {
        [one, two]
    }
}

/// The box of a part, with those of its halves.
fn enclose(points: &[V3], boxes: &mut [[V3; 2]], part: &CurvePart) -> [V3; 2] {
    let (node, segments) = part;
    let found = if segments.len() > 1 {
        let [one, two] = halves(part).map(|half| enclose(points, boxes, &half));
        [one[0].inf(&two[0]), one[1].sup(&two[1])]
    } else {
        let (a, b) = (&points[segments.start], &points[segments.end]);
        [a.inf(b), a.sup(b)]
    };
    boxes[*node] = found;
    found
}

/// The distance of two boxes.
pub(super) fn apart(one: &[V3; 2], two: &[V3; 2]) -> f64 {
    let gap = (two[0] - one[1]).sup(&(one[0] - two[1]));
    gap.sup(&V3::zeros()).norm()
}

/// The nearest points of two straight segments (Ericson, *Real-Time Collision Detection*, 2005, sec. 5.1.9).
fn nearest(a: &[V3], b: &[V3]) -> (V3, V3) {
    let (d1, d2, r) = (a[1] - a[0], b[1] - b[0], a[0] - b[0]);
    let (aa, e, f) = (d1.norm_squared(), d2.norm_squared(), d2.dot(&r));
    let tiny = f64::MIN_POSITIVE;
    let (mut s, t);
    if aa <= tiny {
        s = 0.0;
        t = if e > tiny {
            (f / e).clamp(0.0, 1.0)
        } else {
            0.0
        };
    } else {
        let c = d1.dot(&r);
        let (cross, free) = (d1.dot(&d2), if e > tiny { f / e } else { 0.0 });
        let det = aa * e - cross * cross;
        s = if det > tiny {
            ((cross * f - c * e) / det).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let along = if e > tiny { (cross * s + f) / e } else { free };
        t = along.clamp(0.0, 1.0);
        if t != along {
            s = ((t * cross - c) / aa).clamp(0.0, 1.0);
        }
    }
    (a[0] + d1 * s, b[0] + d2 * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    #[test]
    fn boxes_find_the_least_distance_of_all_pairs_of_segments() {
        let mut random = Random::new(5, 0);
        for _ in 0..50 {
            let mut curve = |count: usize| {
                let mut at = V3::zeros();
                let points = (0..=count).map(|_| {
                    at += V3::from_fn(|_, _| random.uniform() - 0.4);
                    at
                });
                points.collect::<Vec<V3>>()
            };
            let shift = V3::new(3.0, -2.0, 1.0);
            let (one, mut two) = (curve(37), curve(12));
            two.iter_mut().for_each(|point| *point += shift);
            let pairs = one
                .windows(2)
                .flat_map(|a| two.windows(2).map(move |b| nearest(a, b)));
            let least = pairs
                .map(|(p, q)| (p - q).norm())
                .fold(f64::INFINITY, f64::min);
            let (one, two) = (BoxedCurve::new(one), BoxedCurve::new(two));
            assert!((one.distance(&two) - least).abs() <= 1e-14 * least);
            assert!(one.distance_of_boxes(&two) <= least);
        }
    }
}
