//! A depth over a rectangular grid of places, with its first and second derivatives.
//!
//! *Bilinear* between the four corners of a cell: continuous, with kinks of the slope at the lines of the grid. *Smooth*: cubic
//! Hermite polynomials along x and y in product, with slopes at the lines from the parabola through three neighbours (one-sided
//! at the edge), hence a continuous slope (Keys 1981, doi 10.1109/TASSP.1981.1163711, here for uneven spacing). Both
//! reproduce a plane. Beyond the grid the depth is that of its edge.

use std::ops::RangeInclusive;

/// Differences of depths that are rounding, by the depth.
const FLAT: f64 = 1e-12;

/// How the depth is interpolated between the places of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DepthInterpolation {
    /// Bilinear.
    Bilinear,
    /// With a continuous slope.
    Smooth,
}

/// Depths on a rectangular grid.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthGrid {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Depth at x\[i\], y\[j\]: number `i * y.len() + j`.
    depth: Vec<f64>,
    interpolation: DepthInterpolation,
}

/// A depth and its derivatives at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthAt {
    /// The depth \[m\].
    pub depth: f64,
    /// Its derivatives by x and y \[-\].
    pub slope: [f64; 2],
    /// Its second derivatives by x twice, by x and y, by y twice \[1/m\].
    pub curvature: [f64; 3],
}

/// A grid that is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum DepthGridError {
    /// Fewer than two places along an axis.
    #[error("a grid has two places along x and along y at least")]
    TooFew,
    /// Places that do not ascend, or numbers that are not finite.
    #[error("the places of a grid ascend, and all its numbers are finite")]
    NotAscending,
    /// A depth for each place.
    #[error("a grid has one depth for each pair of x and y")]
    NotRectangular,
}

/// Four neighbours of a place along an axis, with their shares in the value and its first two derivatives.
struct Neighbours {
    at: [usize; 4],
    shares: [[f64; 4]; 3],
}

impl DepthGrid {
    /// A grid of depths \[m\] at places x and y \[m\], ascending; the depth at `x[i]`, `y[j]` is number `i * y.len() + j`.
    ///
    /// # Errors
    /// The numbers make no grid.
    pub fn new(
        x: Vec<f64>,
        y: Vec<f64>,
        depth: Vec<f64>,
        interpolation: DepthInterpolation,
    ) -> Result<Self, DepthGridError> {
        if x.len() < 2 || y.len() < 2 {
            return Err(DepthGridError::TooFew);
        }
        let ascends = |axis: &[f64]| axis.windows(2).all(|pair| pair[0] < pair[1]);
        let mut all = x.iter().chain(&y).chain(&depth);
        if !ascends(&x) || !ascends(&y) || !all.all(|number| number.is_finite()) {
            return Err(DepthGridError::NotAscending);
        }
        if x.len().checked_mul(y.len()) != Some(depth.len()) {
            return Err(DepthGridError::NotRectangular);
        }
        Ok(Self {
            x,
            y,
            depth,
            interpolation,
        })
    }

    /// A grid from rows of x, y and depth \[m\] in any order, each pair of places once.
    ///
    /// # Errors
    /// As [`DepthGrid::new`].
    pub fn of_rows(
        rows: &[[f64; 3]],
        interpolation: DepthInterpolation,
    ) -> Result<Self, DepthGridError> {
        let axis = |k: usize| {
            let mut places: Vec<f64> = rows.iter().map(|row| row[k]).collect();
            places.sort_by(f64::total_cmp);
            places.dedup();
            places
        };
        let (x, y) = (axis(0), axis(1));
        let count = x.len().checked_mul(y.len());
        if count != Some(rows.len()) {
            return Err(DepthGridError::NotRectangular);
        }
        let mut depth = vec![f64::NAN; rows.len()];
        for [at_x, at_y, value] in rows {
            let i = x.partition_point(|place| place < at_x);
            let j = y.partition_point(|place| place < at_y);
            let slot = depth.get_mut(i * y.len() + j);
            match slot {
                Some(slot) if slot.is_nan() => *slot = *value,
                _ => return Err(DepthGridError::NotRectangular),
            }
        }
        Self::new(x, y, depth, interpolation)
    }

    /// The places along x and along y between which depths are given \[m\].
    #[must_use]
    pub fn places(&self) -> [&[f64]; 2] {
        [&self.x, &self.y]
    }

    /// The depth with its derivatives. A place that is not finite counts as at the edge.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> DepthAt {
        let along_x = neighbours(&self.x, x, self.interpolation);
        let along_y = neighbours(&self.y, y, self.interpolation);
        // Depths from one of them: equal ones give that depth, and no slope, to the last bit.
        let beside = self.depth[along_x.at[1] * self.y.len() + along_y.at[1]];
        let sum = |of_x: usize, of_y: usize| {
            let mut total = 0.0;
            for (i, share_x) in along_x.at.iter().zip(&along_x.shares[of_x]) {
                if *share_x == 0.0 {
                    continue;
                }
                let row = &self.depth[i * self.y.len()..][..self.y.len()];
                let pairs = along_y.at.iter().zip(&along_y.shares[of_y]);
                let row = pairs.map(|(j, share)| share * (row[*j] - beside));
                total += share_x * row.sum::<f64>();
            }
            total
        };
        DepthAt {
            depth: beside + sum(0, 0),
            slope: [sum(1, 0), sum(0, 1)],
            curvature: [sum(2, 0), sum(1, 1), sum(0, 2)],
        }
    }

    /// The depth where the grid is flat below the straight way between two places: all depths that count there are equal, to rounding.
    /// Nothing where they differ.
    #[must_use]
    pub fn flat_along(&self, from: [f64; 2], to: [f64; 2]) -> Option<f64> {
        let mut shares = vec![0.0, 1.0];
        for (axis, k) in [(&self.x, 0), (&self.y, 1)] {
            let crossed = axis.iter().map(|line| (line - from[k]) / (to[k] - from[k]));
            shares.extend(crossed.filter(|share| 0.0 < *share && *share < 1.0));
        }
        shares.sort_unstable_by(f64::total_cmp);
        let mut flat: Option<f64> = None;
        for pair in shares.windows(2) {
            let share = 0.5 * (pair[0] + pair[1]);
            let place = |k: usize| from[k] + share * (to[k] - from[k]);
            for i in self.counting(&self.x, place(0))? {
                for j in self.counting(&self.y, place(1))? {
                    let depth = self.depth[i * self.y.len() + j];
                    let known = *flat.get_or_insert(depth);
                    if (depth - known).abs() > FLAT * known.abs() {
                        return None;
                    }
                }
            }
        }
        flat
    }

    /// The numbers of the places of an axis whose depths count at a place and next to it; nothing for a place that is not finite.
    fn counting(&self, axis: &[f64], place: f64) -> Option<RangeInclusive<usize>> {
        let last = axis.len() - 1;
        let (before, through) = (
            axis.partition_point(|p| *p < place),
            axis.partition_point(|p| *p <= place),
        );
        let more = match self.interpolation {
            DepthInterpolation::Bilinear => 0,
            DepthInterpolation::Smooth => 1,
        };
        place.is_finite().then(|| match (before, through) {
            (_, 0) => 0..=0,
            (before, _) if before > last => last..=last,
            _ => before.saturating_sub(1 + more)..=(through + more).min(last),
        })
    }

    /// The least and the greatest depth at the places of the grid \[m\] that are not outside of a box, and those next to it.
    #[must_use]
    pub fn range_within(&self, least: [f64; 2], greatest: [f64; 2]) -> [f64; 2] {
        let span = |axis: &[f64], from: f64, to: f64| {
            // A smooth depth takes two places on either side.
            let first = axis.partition_point(|place| *place < from);
            let last = axis.partition_point(|place| *place <= to);
            first.saturating_sub(2)..(last + 2).min(axis.len())
        };
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for i in span(&self.x, least[0], greatest[0]) {
            for j in span(&self.y, least[1], greatest[1]) {
                let depth = self.depth[i * self.y.len() + j];
                range = [range[0].min(depth), range[1].max(depth)];
            }
        }
        range
    }

    /// The least and the greatest depth of the whole grid \[m\].
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.range_within([f64::NEG_INFINITY; 2], [f64::INFINITY; 2])
    }
}

/// The neighbours of a place; beyond the axis those of its end, without slope.
fn neighbours(axis: &[f64], place: f64, interpolation: DepthInterpolation) -> Neighbours {
    let last = axis.len() - 1;
    let inside = axis[0] <= place && place <= axis[last];
    if !inside {
        let end = if place > axis[last] { last } else { 0 };
        let mut shares = [[0.0; 4]; 3];
        shares[0][0] = 1.0;
        return Neighbours {
            at: [end; 4],
            shares,
        };
    }
    let k = axis.partition_point(|p| *p <= place).clamp(1, last) - 1;
    let at = [k.saturating_sub(1), k, k + 1, (k + 2).min(last)];
    let width = axis[k + 1] - axis[k];
    let t = (place - axis[k]) / width;
    let shares = match interpolation {
        DepthInterpolation::Bilinear => [
            [0.0, 1.0 - t, t, 0.0],
            [0.0, -1.0 / width, 1.0 / width, 0.0],
            [0.0; 4],
        ],
        DepthInterpolation::Smooth => cubic(axis, at, t, width),
    };
    Neighbours { at, shares }
}

/// Shares of four neighbours in a cubic Hermite polynomial and its derivatives, `t` along the cell between the middle two.
fn cubic(axis: &[f64], at: [usize; 4], t: f64, width: f64) -> [[f64; 4]; 3] {
    let [before, from, to, after] = at;
    let left = slope_shares((from > before).then(|| axis[from] - axis[before]), width);
    let right = slope_shares((after > to).then(|| axis[after] - axis[to]), width);
    // Values and slopes at both ends of the cell, as polynomials and their derivatives.
    let (t2, t3) = (t * t, t * t * t);
    let hermite = [
        [
            2.0 * t3 - 3.0 * t2 + 1.0,
            width * (t3 - 2.0 * t2 + t),
            3.0 * t2 - 2.0 * t3,
            width * (t3 - t2),
        ],
        [
            (6.0 * t2 - 6.0 * t) / width,
            3.0 * t2 - 4.0 * t + 1.0,
            (6.0 * t - 6.0 * t2) / width,
            3.0 * t2 - 2.0 * t,
        ],
        [
            (12.0 * t - 6.0) / (width * width),
            (6.0 * t - 4.0) / width,
            (6.0 - 12.0 * t) / (width * width),
            (6.0 * t - 2.0) / width,
        ],
    ];
    hermite.map(|[value_from, slope_from, value_to, slope_to]| {
        [
            slope_from * left[0],
            value_from + slope_from * left[1] - slope_to * right[2],
            value_to + slope_from * left[2] - slope_to * right[1],
            -slope_to * right[0],
        ]
    })
}

/// Shares of the outer neighbour, of the place itself and of the other end of the cell in the slope at a place towards that other
/// end: of the parabola through the three, or of the cell alone at an edge.
fn slope_shares(outer: Option<f64>, width: f64) -> [f64; 3] {
    let Some(outer) = outer else {
        return [0.0, -1.0 / width, 1.0 / width];
    };
    let whole = outer + width;
    let (by_outer, by_cell) = (width / (whole * outer), outer / (whole * width));
    [-by_outer, by_outer - by_cell, by_cell]
}

#[cfg(test)]
mod tests {
    use super::*;
    use DepthInterpolation::{Bilinear, Smooth};

    const X: [f64; 6] = [-3.0, -1.0, 0.5, 2.0, 4.5, 5.0];
    const Y: [f64; 5] = [0.0, 1.0, 2.5, 3.0, 6.0];

    fn grid(of: impl Fn(f64, f64) -> f64, interpolation: DepthInterpolation) -> DepthGrid {
        let pairs = X.iter().flat_map(|x| Y.iter().map(move |y| (*x, *y)));
        let depth = pairs.map(|(x, y)| of(x, y)).collect();
        DepthGrid::new(X.to_vec(), Y.to_vec(), depth, interpolation).unwrap()
    }

    /// Places inside of cells, off the lines of the grid.
    fn places() -> impl Iterator<Item = (f64, f64)> {
        (0..37).flat_map(|i| {
            (0..23).map(move |j| {
                (
                    -2.95 + 7.9 * f64::from(i) / 36.0,
                    0.03 + 5.9 * f64::from(j) / 22.0,
                )
            })
        })
    }

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance, "{a} {b}");
    }

    #[test]
    fn a_plane_is_reproduced_with_its_slope() {
        for interpolation in [Bilinear, Smooth] {
            let plane = grid(|x, y| 30.0 + 0.2 * x - 0.1 * y, interpolation);
            for (x, y) in places() {
                let found = plane.at(x, y);
                near(found.depth, 30.0 + 0.2 * x - 0.1 * y, 1e-13 * 30.0);
                near(found.slope[0], 0.2, 1e-12);
                near(found.slope[1], -0.1, 1e-12);
                assert!(found.curvature.iter().all(|c| c.abs() < 1e-11));
            }
        }
    }

    #[test]
    fn products_and_parabolas_are_reproduced() {
        let product = grid(|x, y| 5.0 + x * y, Bilinear);
        // Between the outermost cells slopes are those of the parabola.
        let bowl = grid(|x, y| 40.0 + x * x - 0.5 * x * y + 2.0 * y * y, Smooth);
        for (x, y) in places() {
            near(product.at(x, y).depth, 5.0 + x * y, 1e-12);
            near(product.at(x, y).curvature[1], 1.0, 1e-12);
            if (-1.0..4.5).contains(&x) && (1.0..3.0).contains(&y) {
                let found = bowl.at(x, y);
                near(found.depth, 40.0 + x * x - 0.5 * x * y + 2.0 * y * y, 1e-11);
                near(found.slope[0], 2.0 * x - 0.5 * y, 1e-11);
                near(found.curvature[2], 4.0, 1e-10);
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_depth() {
        let step = 1e-5;
        for interpolation in [Bilinear, Smooth] {
            let hills = grid(
                |x, y| (x * 0.8).sin() * (y * 0.6).cos() * 3.0,
                interpolation,
            );
            let safe = |axis: &[f64], p: f64| axis.iter().all(|line| (line - p).abs() > 2.0 * step);
            for (x, y) in places().filter(|(x, y)| safe(&X, *x) && safe(&Y, *y)) {
                let found = hills.at(x, y);
                let by_x = |of: fn(&DepthAt) -> f64| {
                    (of(&hills.at(x + step, y)) - of(&hills.at(x - step, y))) / (2.0 * step)
                };
                let by_y = |of: fn(&DepthAt) -> f64| {
                    (of(&hills.at(x, y + step)) - of(&hills.at(x, y - step))) / (2.0 * step)
                };
                near(found.slope[0], by_x(|at| at.depth), 1e-8);
                near(found.slope[1], by_y(|at| at.depth), 1e-8);
                near(found.curvature[0], by_x(|at| at.slope[0]), 1e-7);
                near(found.curvature[1], by_x(|at| at.slope[1]), 1e-7);
                near(found.curvature[2], by_y(|at| at.slope[1]), 1e-7);
            }
        }
    }

    #[test]
    fn the_smooth_slope_has_no_kinks() {
        let hills = grid(|x, y| (x * 0.8).sin() * (y * 0.6).cos() * 3.0, Smooth);
        for x in &X[1..5] {
            let [before, after] = [-1e-9, 1e-9].map(|aside| hills.at(x + aside, 1.7).slope);
            near(before[0], after[0], 1e-7);
            near(before[1], after[1], 1e-7);
        }
    }

    #[test]
    fn beyond_the_grid_is_its_edge_and_nothing_is_not_a_number() {
        for interpolation in [Bilinear, Smooth] {
            let hills = grid(|x, y| 10.0 + x * y, interpolation);
            near(hills.at(1e9, 2.5).depth, 10.0 + 5.0 * 2.5, 1e-12);
            near(hills.at(-1e300, 9.0).depth, 10.0 - 18.0, 1e-12);
            assert_eq!(hills.at(1e9, -1e9).slope, [0.0; 2]);
            for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let found = hills.at(odd, odd);
                assert!(found.depth.is_finite() && found.slope.iter().all(|s| s.is_finite()));
            }
        }
    }

    #[test]
    fn flat_parts_are_found_and_exact() {
        // Flat up to x = 0.5, a slope beyond.
        let of = |x: f64, _: f64| 33.3 - 0.1 * (x - 0.5).max(0.0);
        for (interpolation, flat_to) in [(Bilinear, 0.5), (Smooth, -1.0)] {
            let hills = grid(of, interpolation);
            for to in [[flat_to - 1e-9, 5.0], [-3.0, 0.0], [-40.0, 70.0]] {
                assert_eq!(hills.flat_along([-2.5, 1.0], to), Some(33.3), "{to:?}");
                let [x, y] = to;
                assert_eq!(hills.at(x, y).depth, 33.3);
                assert_eq!(hills.at(x, y).slope, [0.0; 2]);
            }
            for to in [[flat_to + 0.1, 5.0], [4.0, 1.0], [f64::NAN, 0.0]] {
                assert_eq!(hills.flat_along([-2.5, 1.0], to), None, "{to:?}");
            }
            // Over the slope and back onto the edge, which is flat in itself.
            assert_eq!(hills.flat_along([-9.0, 1.0], [9.0, 1.0]), None);
            assert_eq!(
                hills.flat_along([7.0, 1.0], [9.0, 9.0]),
                Some(33.3 - 0.1 * 4.5)
            );
        }
    }

    #[test]
    fn rows_in_any_order_make_a_grid_and_gaps_none() {
        let mut rows = vec![
            [1.0, 0.0, 5.0],
            [0.0, 2.0, 7.0],
            [1.0, 2.0, 8.0],
            [0.0, 0.0, 4.0],
        ];
        let grid = DepthGrid::of_rows(&rows, Bilinear).unwrap();
        near(grid.at(0.5, 1.0).depth, 6.0, 1e-12);
        assert_eq!(grid.range(), [4.0, 8.0]);
        rows[3] = [1.0, 0.0, 4.0];
        assert_eq!(
            DepthGrid::of_rows(&rows, Bilinear),
            Err(DepthGridError::NotRectangular)
        );
        rows.pop();
        assert!(DepthGrid::of_rows(&rows, Bilinear).is_err());
        assert_eq!(DepthGrid::of_rows(&[], Smooth), Err(DepthGridError::TooFew));
    }
}
