//! Cubic splines: the natural one of positions over time, and that of a periodic function.
//!
//! The natural spline passes through all points and has no curvature at its ends; position, velocity and acceleration are continuous, as
//! in the motion of a mass. Its second derivatives solve a tridiagonal system (de Boor, *A Practical Guide to Splines*,
//! chapter IV).

use nalgebra::{DMatrix, DVector};

use super::V3;
use super::interpolation::interval;

/// A table that defines no spline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SplineError {
    /// Fewer than two points.
    #[error("a table of positions needs two points or more")]
    Short,
    /// Times that do not ascend, at this point.
    #[error("times must rise; point {0} does not come after the one before")]
    Order(usize),
}

/// Whether points are a table: two or more, at ascending times.
pub(super) fn check_points(points: &[(f64, V3)]) -> Result<(), SplineError> {
    if points.len() < 2 {
        return Err(SplineError::Short);
    }
    let late = points.windows(2).position(|p| p[1].0 <= p[0].0);
    late.map_or(Ok(()), |i| Err(SplineError::Order(i + 1)))
}

/// By how much a spline leaves the range of two neighbouring points that turn nowhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overshoot {
    /// The axis, 0 to 2.
    pub axis: usize,
    /// When it is farthest out \[s\].
    pub time: f64,
    /// How far \[m\].
    pub distance: f64,
    /// By the range of all points along the axis \[-\].
    pub share: f64,
}

/// Points a period of a harmonic of which four predict the one in their middle with a twentieth of the error of two:
/// `3/16 (2 pi / 12)²`.
pub const POINTS_A_PERIOD: f64 = 12.0;
/// That share.
const LEFT: f64 = 0.05;
/// Share of the range that counts as rounding of a table.
const ROUNDING: f64 = 2.5e-4;

/// A smooth path through points.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    time: Vec<f64>,
    position: Vec<V3>,
    /// Acceleration at each point \[m/s²\].
    acceleration: Vec<V3>,
}

impl Spline {
    /// The path through these positions \[m\] at ascending times \[s\].
    ///
    /// # Errors
    /// [`SplineError`] when there are too few points or times do not ascend.
    pub fn through(points: &[(f64, V3)]) -> Result<Self, SplineError> {
        check_points(points)?;
        let (time, position): (Vec<f64>, Vec<V3>) = points.iter().copied().unzip();
        let acceleration = accelerations(&time, &position);
        Ok(Self {
            time,
            position,
            acceleration,
        })
    }

    /// First and last time \[s\].
    #[must_use]
    pub fn span(&self) -> (f64, f64) {
        (self.time[0], self.time[self.time.len() - 1])
    }

    /// Shortest time between two points \[s\].
    #[must_use]
    pub fn finest(&self) -> f64 {
        let gaps = self.time.windows(2).map(|t| t[1] - t[0]);
        gaps.fold(f64::INFINITY, f64::min)
    }

    /// The longest time between points that resolves the path \[s\]: from points so far apart, cubics predict those between them with
    /// a twentieth of the error of straight lines, as of a harmonic with [`POINTS_A_PERIOD`], or to what is rounding. The
    /// shortest time between two points, where even these do not predict each other.
    #[must_use]
    pub fn resolving_interval(&self) -> f64 {
        let mut longest = self.finest();
        let mut apart = 1;
        while let Some(interval) = self.predicted_from(apart) {
            longest = longest.max(interval);
            apart *= 2;
        }
        longest
    }

    /// The shortest time between points twice so many apart \[s\], if those predict the points in their middles.
    fn predicted_from(&self, apart: usize) -> Option<f64> {
        let middles = 3 * apart..self.time.len().saturating_sub(3 * apart);
        if middles.is_empty() {
            return None;
        }
        let (mut of_lines, mut of_cubics) = (0.0_f64, 0.0_f64);
        for i in middles.clone() {
            let around = [i - apart, i + apart, i - 3 * apart, i + 3 * apart];
            let error = |points: &[usize]| {
                let predicted = self.lagrange(points, self.time[i]);
                (self.position[i] - predicted).norm()
            };
            of_lines = of_lines.max(error(&around[..2]));
            of_cubics = of_cubics.max(error(&around));
        }
        let rounding = ROUNDING * self.range().norm();
        if of_cubics > rounding.max(LEFT * of_lines) {
            return None;
        }
        let intervals = middles.map(|i| self.time[i + apart] - self.time[i - apart]);
        Some(intervals.fold(f64::INFINITY, f64::min))
    }

    /// The polynomial through some points at time t \[m\].
    fn lagrange(&self, points: &[usize], t: f64) -> V3 {
        let weight = |i: usize| {
            let others = points.iter().filter(|j| **j != i);
            let factor = |j: &usize| (t - self.time[*j]) / (self.time[i] - self.time[*j]);
            others.map(factor).product::<f64>()
        };
        points.iter().map(|i| self.position[*i] * weight(*i)).sum()
    }

    /// Position \[m\], velocity \[m/s\] and acceleration \[m/s²\] at time t \[s\]; beyond its ends the path continues straight.
    #[must_use]
    pub fn at(&self, t: f64) -> (V3, V3, V3) {
        let (first, last) = self.span();
        let inside = t.clamp(first, last);
        let (x, v, a) = self.piece(interval(&self.time, inside) + 1, inside);
        if t == inside {
            (x, v, a)
        } else {
            (x + v * (t - inside), v, V3::zeros())
        }
    }

    /// The greatest overshoot until a time \[s\], by the range of its axis: how far the path leaves the range of two neighbouring
    /// points. It is none where the points around them show a peak between the two (they rise before and fall after, or the
    /// reverse, and the two differ): the path has one there with reason.
    #[must_use]
    pub fn overshoot(&self, until: f64) -> Option<Overshoot> {
        let range = self.range();
        let pieces = (1..self.time.len()).filter(|i| self.time[i - 1] < until);
        let on = |(i, axis): (usize, usize)| self.overshoot_on(i, axis, range[axis]);
        let each = pieces.flat_map(|i| [0, 1, 2].map(|axis| (i, axis)));
        each.filter_map(on)
            .reduce(|a, b| if b.share > a.share { b } else { a })
    }

    /// The range of all points \[m\].
    fn range(&self) -> V3 {
        let least = |a: V3, b: &V3| a.inf(b);
        let greatest = |a: V3, b: &V3| a.sup(b);
        let first = self.position[0];
        let all = || self.position.iter();
        all().fold(first, greatest) - all().fold(first, least)
    }

    /// The overshoot along an axis of this range on the piece that ends at point i.
    fn overshoot_on(&self, i: usize, axis: usize, range: f64) -> Option<Overshoot> {
        let x = |i: usize| self.position[i][axis];
        let rise = |i: usize| {
            if i < self.time.len() {
                x(i) - x(i - 1)
            } else {
                0.0
            }
        };
        let before = if i > 1 { rise(i - 1) } else { 0.0 };
        if before * rise(i + 1) < 0.0 && rise(i) != 0.0 {
            return None;
        }
        let (low, high) = (x(i - 1).min(x(i)), x(i - 1).max(x(i)));
        let out = self.turns(i, axis).into_iter().map(|time| {
            let there = self.piece(i, time).0[axis];
            (time, (low - there).max(there - high))
        });
        let (time, distance) = out.reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        (distance > 0.0 && range > 0.0).then(|| Overshoot {
            axis,
            time,
            distance,
            share: distance / range,
        })
    }

    /// The times on the piece that ends at point i at which the velocity along an axis vanishes: roots of a parabola, the
    /// larger first and the other by their product, which loses no digits.
    fn turns(&self, i: usize, axis: usize) -> Vec<f64> {
        let h = self.time[i] - self.time[i - 1];
        let (a0, a1) = (self.acceleration[i - 1][axis], self.acceleration[i][axis]);
        let chord = (self.position[i][axis] - self.position[i - 1][axis]) / h;
        let (square, first) = (0.5 * h * (a1 - a0), h * a0);
        let constant = chord - h * (a0 / 3.0 + a1 / 6.0);
        let discriminant = first * first - 4.0 * square * constant;
        if discriminant < 0.0 {
            return Vec::new();
        }
        let q = -0.5 * (first + discriminant.sqrt().copysign(first));
        let shares = [q / square, constant / q].into_iter();
        let inside = shares.filter(|share| (0.0..=1.0).contains(share));
        inside.map(|share| self.time[i - 1] + share * h).collect()
    }

    /// On the piece that ends at point i.
    fn piece(&self, i: usize, t: f64) -> (V3, V3, V3) {
        let h = self.time[i] - self.time[i - 1];
        let (p, q) = ((self.time[i] - t) / h, (t - self.time[i - 1]) / h);
        let (x0, x1) = (&self.position[i - 1], &self.position[i]);
        let (a0, a1) = (&self.acceleration[i - 1], &self.acceleration[i]);
        let cubic = |s: f64| (s * s * s - s) * h * h / 6.0;
        let slope = |s: f64| (3.0 * s * s - 1.0) * h / 6.0;
        (
            x0 * p + x1 * q + a0 * cubic(p) + a1 * cubic(q),
            (x1 - x0) / h - a0 * slope(p) + a1 * slope(q),
            a0 * p + a1 * q,
        )
    }
}

/// Accelerations at the points, zero at both ends, by elimination of the tridiagonal system (Thomas algorithm).
fn accelerations(time: &[f64], position: &[V3]) -> Vec<V3> {
    let n = time.len();
    let mut acceleration = vec![V3::zeros(); n];
    let mut factor = vec![0.0; n];
    let rate = |i: usize| (position[i + 1] - position[i]) / (time[i + 1] - time[i]);
    for i in 1..n - 1 {
        let (before, after) = (time[i] - time[i - 1], time[i + 1] - time[i]);
        let pivot = 2.0 * (before + after) - before * factor[i - 1];
        factor[i] = after / pivot;
        acceleration[i] = ((rate(i) - rate(i - 1)) * 6.0 - acceleration[i - 1] * before) / pivot;
    }
    for i in (1..n - 1).rev() {
        let next = acceleration[i + 1];
        acceleration[i] -= next * factor[i];
    }
    acceleration
}

/// Second derivatives, at its points, of the cubic spline through one period of a function, continuous in its first and second
/// derivative around the period.
#[must_use]
pub fn periodic_second_derivatives(at: &[f64], value: &[f64], period: f64) -> Vec<f64> {
    let n = at.len();
    if n < 3 {
        return vec![0.0; n];
    }
    let width = |i: usize| {
        if i + 1 < n {
            at[i + 1] - at[i]
        } else {
            period + at[0] - at[i]
        }
    };
    let mut matrix = DMatrix::zeros(n, n);
    let mut right = DVector::zeros(n);
    for i in 0..n {
        let (before, after) = ((i + n - 1) % n, (i + 1) % n);
        let (h0, h1) = (width(before), width(i));
        matrix[(i, before)] += h0 / 6.0;
        matrix[(i, i)] += (h0 + h1) / 3.0;
        matrix[(i, after)] += h1 / 6.0;
        right[i] = (value[after] - value[i]) / h1 - (value[i] - value[before]) / h0;
    }
    // Diagonally dominant, hence regular.
    let solved = matrix.lu().solve(&right);
    solved.map_or_else(|| vec![0.0; n], |m| m.iter().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn follows_a_smooth_path_with_its_velocity_and_acceleration() {
        let path = |t: f64| V3::new((0.7 * t).sin(), 0.1 * t, (0.3 * t).cos());
        let error = |step: f64| {
            let count = (20.0 / step) as usize;
            let points: Vec<_> = (0..=count)
                .map(|i| (step * i as f64, path(step * i as f64)))
                .collect();
            let spline = Spline::through(&points).unwrap();
            let t = 9.87;
            (spline.at(t).0 - path(t)).norm()
        };
        // Fourth order.
        assert!(error(0.25) < 1e-4);
        assert!(error(0.125) < error(0.25) / 10.0);
    }

    #[test]
    fn rates_are_derivatives_and_join_at_the_points() {
        let places = [1.0, -2.0, 0.5, 4.0, 4.0, 3.0].map(|x| V3::new(x, -x, x * x));
        let times = [0.0, 1.0, 1.5, 4.0, 6.0, 6.5];
        let points: Vec<_> = times.into_iter().zip(places).collect();
        let spline = Spline::through(&points).unwrap();
        let h = 1e-6;
        for t in [-1.0, 0.4, 1.2, 3.3, 6.1, 8.0] {
            let (before, now, after) = (spline.at(t - h), spline.at(t), spline.at(t + h));
            assert!(((after.0 - before.0) / (2.0 * h) - now.1).norm() < 1e-6);
            assert!(((after.1 - before.1) / (2.0 * h) - now.2).norm() < 1e-5);
        }
        for (t, x) in points {
            let (low, high) = (spline.at(t - 1e-9), spline.at(t + 1e-9));
            assert!((spline.at(t).0 - x).norm() < 1e-12);
            assert!((low.1 - high.1).norm() < 1e-7 && (low.2 - high.2).norm() < 1e-6);
        }
    }

    /// A slow drift and a wave on it, rounded to millimetres: it is the wave that steps have to resolve. A short table, and one whose
    /// points predict nothing, has its own interval.
    #[test]
    fn the_interval_that_resolves_a_path_is_that_of_its_quickest_motion() {
        let table = |interval: f64, noise: f64| {
            let place = |k: u32| {
                let t = f64::from(k) * interval;
                let x = 20.0 * (0.03 * t).sin() + 2.0 * (0.6 * t).sin();
                let stray = noise * ((f64::from(k) * 12.9898).sin() * 43758.5453).fract();
                (t, V3::new(((x + stray) * 1e3).round() / 1e3, 0.0, 0.0))
            };
            let points: Vec<(f64, V3)> = (0..8000).map(place).collect();
            Spline::through(&points).unwrap()
        };
        let period = std::f64::consts::TAU / 0.6;
        for interval in [0.05, 0.1] {
            let found = table(interval, 0.0).resolving_interval();
            assert!((period / 24.0..period / 9.0).contains(&found), "{found}");
        }
        assert!((table(0.1, 0.5).resolving_interval() - 0.1).abs() < 1e-9);
        let short = [0.0, 0.2, 0.3].map(|t| (t, V3::new(t, 0.0, 0.0)));
        assert!((Spline::through(&short).unwrap().resolving_interval() - 0.1).abs() < 1e-12);
    }

    /// Its range is found once, not once for each of its points.
    #[test]
    fn a_long_table_is_looked_at_in_no_time() {
        let points = |k: u32| (f64::from(k), V3::new(f64::from(k % 2), 0.0, 0.0));
        let points: Vec<(f64, V3)> = (0..300_000).map(points).collect();
        let spline = Spline::through(&points).unwrap();
        assert!(
            spline
                .overshoot(f64::INFINITY)
                .is_none_or(|found| found.share < 0.5)
        );
    }

    #[test]
    fn overshoots_on_a_ramp_and_hold_and_not_on_a_coarse_sine() {
        let ramp = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0].map(|x| V3::new(0.0, 0.0, 2.0 * x));
        let points: Vec<_> = (0..6).map(f64::from).zip(ramp).collect();
        let spline = Spline::through(&points).unwrap();
        let found = spline.overshoot(10.0).unwrap();
        // The greatest of the path by samples.
        let sampled = (0..=5000).map(|k| spline.at(0.001 * f64::from(k)).0.z);
        let most = sampled.fold(0.0, f64::max) - 2.0;
        assert_eq!(found.axis, 2);
        assert!((found.distance - most).abs() < 1e-5 && (found.share - 0.5 * most).abs() < 1e-5);
        assert!(most > 0.1, "{most}");
        let there = spline.at(found.time).0.z;
        assert!((there - 2.0 - most).abs() < 1e-5 || (-there - most).abs() < 1e-5);
        // What comes after the run does not count.
        assert!(spline.overshoot(1.0).unwrap().share < 0.5 * found.share);
        let sine: Vec<_> = (0..40_i32)
            .map(|i| (f64::from(i), V3::x() * (0.9 * f64::from(i)).sin()))
            .collect();
        let sine = Spline::through(&sine).unwrap();
        assert!(sine.overshoot(30.0).is_none_or(|found| found.share < 1e-3));
    }

    #[test]
    fn no_table_of_one_point_or_with_times_that_stand_still() {
        assert_eq!(Spline::through(&[(0.0, V3::x())]), Err(SplineError::Short));
        let still = [(0.0, V3::x()), (1.0, V3::x()), (1.0, V3::y())];
        assert_eq!(Spline::through(&still), Err(SplineError::Order(2)));
    }
}
