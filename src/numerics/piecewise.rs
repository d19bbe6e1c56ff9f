//! Paths through a table of positions over time that stay between neighbouring rows: straight from row to row, or by cubics
//! that are monotone where the table is.
//!
//! The straight path has jumps of velocity at the rows, the monotone one jumps of acceleration. These rows are its
//! [kinks](PiecewiseCubic::next_kink). Between two of them the path is smooth, and is evaluated as the path of that *piece*, whichever
//! side of a kink the rounding of a time falls on.

use super::V3;
use super::interpolation::interval;
use super::spline::{SplineError, check_points};

/// Relative jump below which a path is smooth: rounding of slopes and curvatures.
const ROUNDING: f64 = 1e-9;

/// A path of one cubic from row to row of a table, for times from zero.
#[derive(Debug, Clone, PartialEq)]
pub struct PiecewiseCubic {
    /// Times of the rows \[s\].
    time: Vec<f64>,
    /// Coefficients of the cubic after each row, by powers of the time since: m, m/s, m/s², m/s³.
    cubics: Vec<[V3; 4]>,
    /// Rows after time zero at which velocity or acceleration jumps.
    kinks: Vec<Kink>,
}

/// A row at which velocity or acceleration jumps.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Kink {
    row: usize,
    /// Whether it is the velocity.
    of_velocity: bool,
}

impl PiecewiseCubic {
    /// Straight between positions \[m\] at ascending times \[s\]: second order in the interval of the rows.
    ///
    /// # Errors
    /// [`SplineError`] when there are too few points or times do not ascend.
    pub fn linear(points: &[(f64, V3)]) -> Result<Self, SplineError> {
        check_points(points)?;
        let cubics = points.windows(2).map(|p| {
            let slope = (p[1].1 - p[0].1) / (p[1].0 - p[0].0);
            [p[0].1, slope, V3::zeros(), V3::zeros()]
        });
        Ok(Self::of_cubics(points, cubics.collect()))
    }

    /// Cubic Hermite between positions \[m\] at ascending times \[s\], along each axis monotone where the rows are, and flat at
    /// their peaks (Fritsch and Carlson 1980, doi 10.1137/0717021). Slopes at the rows are weighted harmonic means of those on
    /// both sides (Fritsch and Butland 1984, doi 10.1137/0905021). Third order in the interval of the rows, second at peaks.
    ///
    /// # Errors
    /// As [`PiecewiseCubic::linear`].
    pub fn monotone(points: &[(f64, V3)]) -> Result<Self, SplineError> {
        check_points(points)?;
        let slopes = monotone_slopes(points);
        let cubics = points.windows(2).zip(slopes.windows(2)).map(|(p, v)| {
            let h = p[1].0 - p[0].0;
            let chord = (p[1].1 - p[0].1) / h;
            let second = (chord * 3.0 - v[0] * 2.0 - v[1]) / h;
            let third = (v[0] + v[1] - chord * 2.0) / (h * h);
            [p[0].1, v[0], second, third]
        });
        Ok(Self::of_cubics(points, cubics.collect()))
    }

    fn of_cubics(points: &[(f64, V3)], cubics: Vec<[V3; 4]>) -> Self {
        let mut path = Self {
            time: points.iter().map(|p| p.0).collect(),
            cubics,
            kinks: Vec::new(),
        };
        path.kinks = path.find_kinks();
        path
    }

    /// The rows after time zero at which velocity or acceleration jumps.
    fn find_kinks(&self) -> Vec<Kink> {
        let ends = |i: usize| {
            [
                self.of_row(i, self.time[i]),
                self.of_row(i, self.time[i + 1]),
            ]
        };
        let both = || (0..self.cubics.len()).flat_map(ends);
        let fastest = both().map(|(_, v, _)| v.norm()).fold(0.0, f64::max);
        let hardest = both().map(|(_, _, a)| a.norm()).fold(0.0, f64::max);
        let kink = |row: usize| {
            let (_, v0, a0) = self.of_row(row - 1, self.time[row]);
            let (_, v1, a1) = self.of_row(row, self.time[row]);
            let of_velocity = (v1 - v0).norm() > ROUNDING * fastest;
            let jumps = of_velocity || (a1 - a0).norm() > ROUNDING * hardest;
            (jumps && self.time[row] > 0.0).then_some(Kink { row, of_velocity })
        };
        (1..self.cubics.len()).filter_map(kink).collect()
    }

    /// First and last time \[s\].
    #[must_use]
    pub fn span(&self) -> (f64, f64) {
        (self.time[0], self.time[self.time.len() - 1])
    }

    /// Shortest time between two rows \[s\].
    #[must_use]
    pub fn finest(&self) -> f64 {
        let gaps = self.time.windows(2).map(|t| t[1] - t[0]);
        gaps.fold(f64::INFINITY, f64::min)
    }

    /// Median of the lengths of the pieces \[s\].
    #[must_use]
    pub fn median_piece(&self) -> f64 {
        let kinks = self.kinks.iter().map(|kink| self.time[kink.row]);
        let (first, last) = self.span();
        let mut from = first.max(0.0);
        let mut lengths: Vec<f64> = kinks
            .chain([last])
            .map(|to| to - std::mem::replace(&mut from, to))
            .collect();
        lengths.sort_by(f64::total_cmp);
        lengths[lengths.len() / 2]
    }

    /// Time of the kink at the end of a piece, the first of which is 0 \[s\]; infinite for the last.
    #[must_use]
    pub fn next_kink(&self, piece: usize) -> f64 {
        let kink = self.kinks.get(piece);
        kink.map_or(f64::INFINITY, |kink| self.time[kink.row])
    }

    /// Whether it is the velocity that jumps at the end of a piece.
    #[must_use]
    pub fn velocity_jumps(&self, piece: usize) -> bool {
        self.kinks.get(piece).is_some_and(|kink| kink.of_velocity)
    }

    /// The piece at time t \[s\]; at a kink the piece after it.
    #[must_use]
    pub fn piece_at(&self, t: f64) -> usize {
        self.kinks.partition_point(|kink| self.time[kink.row] <= t)
    }

    /// Position \[m\], velocity \[m/s\] and acceleration \[m/s²\] on a piece at time t \[s\]. Beyond the ends of the piece its first
    /// and last cubic continue; beyond those of the table the path continues straight.
    #[must_use]
    pub fn on_piece(&self, piece: usize, t: f64) -> (V3, V3, V3) {
        let row = |kink: usize| self.kinks.get(kink).map(|kink| kink.row);
        let last_cubic = self.cubics.len() - 1;
        let from = piece.checked_sub(1).and_then(row).unwrap_or(0);
        let to = row(piece).map_or(last_cubic, |row| row - 1);
        let (first, last) = self.span();
        let inside = t.clamp(first, last);
        let (x, v, a) = self.of_row(interval(&self.time, inside).clamp(from, to), inside);
        if t == inside {
            (x, v, a)
        } else {
            (x + v * (t - inside), v, V3::zeros())
        }
    }

    /// On the cubic after a row.
    fn of_row(&self, row: usize, t: f64) -> (V3, V3, V3) {
        let s = t - self.time[row];
        let [x, v, c, d] = &self.cubics[row];
        (
            x + (v + (c + d * s) * s) * s,
            v + (c * 2.0 + d * (3.0 * s)) * s,
            c * 2.0 + d * (6.0 * s),
        )
    }
}

/// Monotone slopes at the points, axis by axis \[m/s\].
fn monotone_slopes(points: &[(f64, V3)]) -> Vec<V3> {
    let n = points.len();
    let width = |i: usize| points[i + 1].0 - points[i].0;
    let chord = |i: usize, axis: usize| (points[i + 1].1[axis] - points[i].1[axis]) / width(i);
    let slope = |i: usize, axis: usize| match i {
        _ if n == 2 => chord(0, axis),
        0 => end_slope([width(0), width(1)], [chord(0, axis), chord(1, axis)]),
        i if i == n - 1 => end_slope(
            [width(n - 2), width(n - 3)],
            [chord(n - 2, axis), chord(n - 3, axis)],
        ),
        i => harmonic_mean(
            [width(i - 1), width(i)],
            [chord(i - 1, axis), chord(i, axis)],
        ),
    };
    let at = |i: usize| V3::from_fn(|axis, _| slope(i, axis));
    (0..n).map(at).collect()
}

/// The weighted harmonic mean of the slopes before and after a row; 0 where they differ in sign (Fritsch and Butland 1984, with the
/// weights of Brodlie).
fn harmonic_mean([before, after]: [f64; 2], [d0, d1]: [f64; 2]) -> f64 {
    if d0 * d1 <= 0.0 {
        return 0.0;
    }
    let (w0, w1) = (before + 2.0 * after, 2.0 * before + after);
    (w0 + w1) / (w0 / d0 + w1 / d1)
}

/// The slope at an end of the table by the parabola through three rows, limited to what keeps the cubic monotone
/// (Moler 2004, *Numerical Computing with MATLAB*, section 3.4); widths and slopes from the end inwards.
fn end_slope([h0, h1]: [f64; 2], [d0, d1]: [f64; 2]) -> f64 {
    let slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if slope * d0 <= 0.0 {
        0.0
    } else if d0 * d1 <= 0.0 && slope.abs() > 3.0 * d0.abs() {
        3.0 * d0
    } else {
        slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Constructor = fn(&[(f64, V3)]) -> Result<PiecewiseCubic, SplineError>;

    fn at(path: &PiecewiseCubic, t: f64) -> (V3, V3, V3) {
        path.on_piece(path.piece_at(t), t)
    }

    fn table(rows: &[(f64, f64)]) -> Vec<(f64, V3)> {
        let row = |&(t, x): &(f64, f64)| (t, V3::new(x, -2.0 * x, 1.0));
        rows.iter().map(row).collect()
    }

    const RAMP_AND_HOLD: [(f64, f64); 5] =
        [(0.0, 0.0), (1.0, 0.0), (3.0, 4.0), (4.0, 4.0), (9.0, 4.0)];

    #[test]
    fn linear_is_straight_and_has_its_kinks_where_the_slope_jumps() {
        let path = PiecewiseCubic::linear(&table(&RAMP_AND_HOLD)).unwrap();
        // The row at 4 s lies on a straight line: no kink.
        let kinks = [0, 1, 2].map(|piece| path.next_kink(piece));
        assert_eq!(kinks, [1.0, 3.0, f64::INFINITY]);
        assert!(path.velocity_jumps(0) && path.velocity_jumps(1) && !path.velocity_jumps(2));
        let (x, v, a) = at(&path, 1.5);
        assert_eq!(
            (x, v, a),
            (
                V3::new(1.0, -2.0, 1.0),
                V3::new(2.0, -4.0, 0.0),
                V3::zeros()
            )
        );
        // Both sides of a kink by its pieces.
        assert_eq!(path.on_piece(0, 1.0).1, V3::zeros());
        assert_eq!(path.on_piece(1, 1.0).1, V3::new(2.0, -4.0, 0.0));
        assert_eq!(path.on_piece(1, 3.0 + 1e-12).1, V3::new(2.0, -4.0, 0.0));
        assert_eq!(at(&path, 8.0).0, V3::new(4.0, -8.0, 1.0));
    }

    #[test]
    fn monotone_is_a_smoothstep_on_a_ramp_and_does_not_overshoot() {
        let path = PiecewiseCubic::monotone(&table(&RAMP_AND_HOLD)).unwrap();
        // Flat at both ends of the ramp: x = 4 (3 s² - 2 s³).
        for k in 0..=200 {
            let t = 0.045 * f64::from(k);
            let s = (0.5 * (t - 1.0)).clamp(0.0, 1.0);
            let (x, v, _) = at(&path, t);
            assert!((x.x - 4.0 * (3.0 - 2.0 * s) * s * s).abs() < 1e-14);
            assert!((v.x - 12.0 * (1.0 - s) * s).abs() < 1e-14);
        }
        assert_eq!(
            [0, 1, 2].map(|p| path.next_kink(p)),
            [1.0, 3.0, f64::INFINITY]
        );
        assert!(!path.velocity_jumps(0));
        assert_eq!(path.on_piece(0, 1.0).2.x, 0.0);
        assert_eq!(path.on_piece(1, 1.0).2.x, 6.0);
    }

    #[test]
    fn nothing_leaves_the_box_of_two_rows() {
        let rows: Vec<_> = (0..60_i32)
            .map(|i| {
                (
                    f64::from(i) + 0.3 * f64::from(i % 3),
                    f64::from(i * i * 7 % 23),
                )
            })
            .collect();
        for make in [PiecewiseCubic::linear, PiecewiseCubic::monotone] {
            let path = make(&table(&rows)).unwrap();
            for pair in rows.windows(2) {
                let (low, high) = (pair[0].1.min(pair[1].1), pair[0].1.max(pair[1].1));
                for k in 0..=20 {
                    let t = pair[0].0 + (pair[1].0 - pair[0].0) * f64::from(k) / 20.0;
                    let x = at(&path, t).0.x;
                    assert!((low - 1e-12..=high + 1e-12).contains(&x), "{x} at {t}");
                }
            }
        }
    }

    #[test]
    fn rates_are_derivatives_and_orders_are_two_and_three() {
        let error = |make: Constructor, step: f64| {
            let rows: Vec<_> = (0..=(6.0 / step) as usize)
                .map(|i| (step * i as f64, (0.2 * step * i as f64).sin()))
                .collect();
            let path = make(&table(&rows)).unwrap();
            let mut worst = 0.0_f64;
            for k in 0..600 {
                let t = 0.01 * f64::from(k) + 0.003;
                let h = 1e-6;
                let ((x0, v0, _), (x, v, a), (x1, v1, _)) =
                    (at(&path, t - h), at(&path, t), at(&path, t + h));
                assert!(((x1 - x0) / (2.0 * h) - v).norm() < 1e-8);
                assert!(((v1 - v0) / (2.0 * h) - a).norm() < 1e-8);
                worst = worst.max((x.x - (0.2 * t).sin()).abs());
            }
            worst
        };
        let order = |make| (error(make, 0.5) / error(make, 0.25)).log2();
        let [linear, monotone] = [
            order(PiecewiseCubic::linear),
            order(PiecewiseCubic::monotone),
        ];
        assert!((1.9..2.2).contains(&linear), "{linear}");
        assert!(monotone > 2.8, "{monotone}");
    }

    #[test]
    fn kinks_before_time_zero_are_none() {
        let rows = [(-2.0, 1.0), (0.0, 0.0), (1.0, 3.0), (5.0, 3.0)];
        let path = PiecewiseCubic::linear(&table(&rows)).unwrap();
        assert_eq!(path.next_kink(0), 1.0);
        assert_eq!(path.on_piece(0, 0.0).1.x, 3.0);
        assert_eq!(path.median_piece(), 4.0);
        assert_eq!(
            PiecewiseCubic::monotone(&table(&rows[..1])),
            Err(SplineError::Short)
        );
        let two = PiecewiseCubic::monotone(&table(&rows[..2])).unwrap();
        assert_eq!(at(&two, -1.0).0.x, 0.5);
    }
}
