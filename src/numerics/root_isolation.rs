//! All roots of a smooth function between two points: an interval is discarded only when a bound of the second derivative
//! proves that the function has no root on it, and holds one root when the bound proves it monotone.

use super::roots::Bracket;

/// A function with its derivative and a bound of its second derivative, smooth between its knots.
pub trait BoundedCurvature {
    /// Value and first derivative.
    fn at(&self, x: f64) -> (f64, f64);

    /// An upper bound of the second derivative's magnitude between the knots around x.
    fn second_derivative_bound(&self, x: f64) -> f64;

    /// Rounding error of the value.
    fn rounding(&self) -> f64;
}

/// Where a function is zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IsolatedRoot {
    /// At a point.
    Point(f64),
    /// From one point to another, to rounding: an interval where it vanishes, or a short one where it touches zero.
    Interval(f64, f64),
}

/// Greatest number of intervals examined; a physical function takes some hundred.
const MOST: usize = 200_000;

/// All roots between neighbouring `knots`, which ascend, in ascending order; `None` when the function is not finite or
/// varies too fast to be bounded.
#[must_use]
pub fn isolate_roots(f: &impl BoundedCurvature, knots: &[f64]) -> Option<Vec<IsolatedRoot>> {
    let mut found = Vec::new();
    let mut open: Vec<(f64, f64)> = knots
        .windows(2)
        .rev()
        .map(|pair| (pair[0], pair[1]))
        .collect();
    let mut seen = 0;
    while let Some((a, b)) = open.pop() {
        seen += 1;
        if seen > MOST {
            return None;
        }
        let middle = 0.5 * (a + b);
        let half = 0.5 * (b - a);
        if half <= 0.0 {
            continue;
        }
        let (value, slope) = f.at(middle);
        if !(value.is_finite() && slope.is_finite()) {
            return None;
        }
        let curvature = f.second_derivative_bound(middle);
        // Taylor: everywhere on the interval, f differs from its middle by no more than this.
        let reach = (slope.abs() + 0.5 * curvature * half) * half;
        if value.abs() > reach + f.rounding() {
            continue;
        }
        if slope.abs() > curvature * half && reach > f.rounding() {
            found.extend(crossing(f, a, b).map(IsolatedRoot::Point));
        } else if reach + value.abs() <= 4.0 * f.rounding() || half <= 1e-12 * (1.0 + middle.abs())
        {
            found.push(IsolatedRoot::Interval(a, b));
        } else {
            open.push((middle, b));
            open.push((a, middle));
        }
    }
    Some(joined(found))
}

/// The zero of a function that is monotone from a to b, if it has one; an end where the value there is rounding.
fn crossing(f: &impl BoundedCurvature, a: f64, b: f64) -> Option<f64> {
    let (at_a, at_b) = (f.at(a).0, f.at(b).0);
    if at_a.abs() <= f.rounding() {
        return Some(a);
    }
    if at_b.abs() <= f.rounding() {
        return Some(b);
    }
    if at_a.signum() == at_b.signum() {
        return None;
    }
    Some(refined(f, Bracket { low: a, high: b }, at_b.signum()))
}

/// Newton inside a bracket at whose upper end the function has this sign.
fn refined(f: &impl BoundedCurvature, mut bracket: Bracket, sign: f64) -> f64 {
    let mut x = bracket.middle();
    for _ in 0..200 {
        let (value, slope) = f.at(x);
        if value == 0.0 {
            return x;
        }
        bracket.shrink(x, sign * value);
        let next = bracket.newton(x, value, slope);
        if (next - x).abs() <= 4.0 * f64::EPSILON * (1.0 + x.abs()) {
            return next;
        }
        x = next;
    }
    x
}

/// Joins neighbours that are the same zero.
fn joined(found: Vec<IsolatedRoot>) -> Vec<IsolatedRoot> {
    const SAME: f64 = 1e-9;
    let mut out: Vec<IsolatedRoot> = Vec::new();
    for zero in found {
        let (from, to) = match zero {
            IsolatedRoot::Point(x) => (x, x),
            IsolatedRoot::Interval(a, b) => (a, b),
        };
        match out.last_mut() {
            Some(IsolatedRoot::Point(x)) if from - *x <= SAME => {
                let start = *x;
                if to > from {
                    out.pop();
                    out.push(IsolatedRoot::Interval(start, to));
                }
            }
            Some(IsolatedRoot::Interval(_, end)) if from - *end <= SAME => *end = end.max(to),
            _ => out.push(zero),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial, lowest power first.
    struct Polynomial(Vec<f64>);

    impl BoundedCurvature for Polynomial {
        fn at(&self, x: f64) -> (f64, f64) {
            let mut sum = (0.0, 0.0);
            for c in self.0.iter().rev() {
                sum = (sum.0 * x + c, sum.1 * x + sum.0);
            }
            sum
        }
        fn second_derivative_bound(&self, _: f64) -> f64 {
            let terms = self.0.iter().enumerate();
            terms
                .skip(2)
                .map(|(n, c)| (n * (n - 1)) as f64 * c.abs() * 3.0_f64.powi(n as i32 - 2))
                .sum()
        }
        fn rounding(&self) -> f64 {
            1e-12
        }
    }

    fn points(zeros: &[IsolatedRoot]) -> Vec<f64> {
        let each = zeros.iter().map(|z| match z {
            IsolatedRoot::Point(x) => *x,
            IsolatedRoot::Interval(a, b) => 0.5 * (a + b),
        });
        each.collect()
    }

    #[test]
    fn simple_double_and_triple_roots_are_all_found() {
        // (x - 1) (x + 1)² (x - 2)³, multiplied out.
        let mut poly = vec![1.0];
        for root in [1.0, -1.0, -1.0, 2.0, 2.0, 2.0] {
            let mut next = vec![0.0; poly.len() + 1];
            for (i, c) in poly.iter().enumerate() {
                next[i + 1] += c;
                next[i] -= root * c;
            }
            poly = next;
        }
        let found = isolate_roots(&Polynomial(poly), &[-3.0, 0.3, 3.0]).unwrap();
        let points = points(&found);
        assert_eq!(points.len(), 3, "{found:?}");
        for (x, root) in points.iter().zip([-1.0, 1.0, 2.0]) {
            assert!((x - root).abs() < 1e-4, "{x} {root}");
        }
        assert!(matches!(found[1], IsolatedRoot::Point(x) if (x - 1.0).abs() < 1e-12));
    }

    #[test]
    fn a_function_that_vanishes_is_one_interval() {
        let found = isolate_roots(&Polynomial(vec![0.0]), &[0.0, 1.0, 2.0]).unwrap();
        assert_eq!(found, vec![IsolatedRoot::Interval(0.0, 2.0)]);
    }
}
