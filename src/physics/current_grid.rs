//! A current over a grid of times and places, linear in each of them between its rows and constant beyond.
//!
//! Between the rows of the grid the velocity is the product of linear interpolations along t, x, y and z, as MoorDyn v2 has it
//! (source/Util/Interp.hpp). Its derivative by place is that of the cell; it jumps between cells.

use crate::numerics::{M3, V3};

/// Velocities of the water at times and places.
#[derive(Debug, Clone, PartialEq)]
pub struct CurrentGrid {
    /// Times \[s\] and places along x, y and z \[m\], ascending; one value where nothing changes along an axis.
    axes: [Vec<f64>; 4],
    /// Velocity \[m/s\], z fastest, then y, x and t.
    velocity: Vec<V3>,
}

/// Numbers that make no grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CurrentGridError {
    /// Times or places that do not ascend, or numbers that are not finite.
    #[error("times and places of a grid ascend, and all its numbers are finite")]
    NotAscending,
    /// A velocity for each time and place.
    #[error("a grid has one velocity for each of its times and places")]
    NotRectangular,
}

/// Neighbours along an axis: their numbers, the share of the second, and the derivative of that share.
#[derive(Debug, Clone, Copy)]
struct AxisNeighbours {
    at: [usize; 2],
    share: f64,
    slope: f64,
}

impl AxisNeighbours {
    fn of_value(axis: &[f64], value: f64) -> Self {
        let next = axis.partition_point(|known| *known <= value);
        if next == 0 || next == axis.len() {
            let at = next.saturating_sub(1);
            return Self {
                at: [at, at],
                share: 0.0,
                slope: 0.0,
            };
        }
        let slope = 1.0 / (axis[next] - axis[next - 1]);
        Self {
            at: [next - 1, next],
            share: (value - axis[next - 1]) * slope,
            slope,
        }
    }

    /// The neighbours with their shares and the derivatives of these; one where nothing changes.
    fn neighbours(&self) -> impl Iterator<Item = (usize, f64, f64)> + use<> {
        let both = [
            (self.at[0], 1.0 - self.share, -self.slope),
            (self.at[1], self.share, self.slope),
        ];
        let count = if self.slope == 0.0 { 1 } else { 2 };
        both.into_iter().take(count)
    }
}

impl CurrentGrid {
    /// A grid of velocities \[m/s\] at times \[s\] and places x, y, z \[m\], z fastest, then y, x and t.
    ///
    /// # Errors
    /// The numbers make no grid.
    pub fn new(axes: [Vec<f64>; 4], velocity: Vec<V3>) -> Result<Self, CurrentGridError> {
        let ascends = |axis: &Vec<f64>| axis.windows(2).all(|pair| pair[0] < pair[1]);
        let finite = axes.iter().flatten().all(|number| number.is_finite())
            && velocity.iter().flatten().all(|number| number.is_finite());
        if !finite || !axes.iter().all(ascends) {
            return Err(CurrentGridError::NotAscending);
        }
        let count = axes
            .iter()
            .try_fold(1_usize, |product, axis| product.checked_mul(axis.len()));
        match count {
            Some(count) if count == velocity.len() && count > 0 => Ok(Self { axes, velocity }),
            _ => Err(CurrentGridError::NotRectangular),
        }
    }

    /// A grid from rows in any order: time and place `[t, x, y, z]`, velocity; each of them once.
    ///
    /// # Errors
    /// As [`CurrentGrid::new`].
    pub fn of_rows(rows: &[([f64; 4], V3)]) -> Result<Self, CurrentGridError> {
        let axes = [0, 1, 2, 3].map(|k| {
            let mut places: Vec<f64> = rows.iter().map(|(at, _)| at[k]).collect();
            places.sort_by(f64::total_cmp);
            places.dedup();
            places
        });
        let count = axes
            .iter()
            .try_fold(1_usize, |product, axis| product.checked_mul(axis.len()));
        if count != Some(rows.len()) {
            return Err(CurrentGridError::NotRectangular);
        }
        let mut velocity: Vec<Option<V3>> = vec![None; rows.len()];
        for (at, given) in rows {
            let numbers =
                [0, 1, 2, 3].map(|k: usize| axes[k].partition_point(|known| *known < at[k]));
            match velocity.get_mut(slot(&axes, numbers)) {
                Some(slot) if slot.is_none() => *slot = Some(*given),
                _ => return Err(CurrentGridError::NotRectangular),
            }
        }
        let velocity: Option<Vec<V3>> = velocity.into_iter().collect();
        Self::new(axes, velocity.ok_or(CurrentGridError::NotRectangular)?)
    }

    /// Velocity \[m/s\] at time t \[s\] at a place \[m\], and its derivative by the place \[1/s\].
    #[must_use]
    pub fn at(&self, t: f64, place: &V3) -> (V3, M3) {
        let at = [t, place.x, place.y, place.z];
        let [times, x, y, z] =
            [0, 1, 2, 3].map(|k: usize| AxisNeighbours::of_value(&self.axes[k], at[k]));
        let mut velocity = V3::zeros();
        let mut gradient = M3::zeros();
        for (it, wt, _) in times.neighbours() {
            for (ix, wx, dx) in x.neighbours() {
                for (iy, wy, dy) in y.neighbours() {
                    for (iz, wz, dz) in z.neighbours() {
                        let here = self.velocity[slot(&self.axes, [it, ix, iy, iz])];
                        velocity += here * (wt * wx * wy * wz);
                        let by = V3::new(dx * wy * wz, wx * dy * wz, wx * wy * dz) * wt;
                        gradient += here * by.transpose();
                    }
                }
            }
        }
        (velocity, gradient)
    }

    /// The steady current at a time \[s\].
    #[must_use]
    pub fn frozen(&self, t: f64) -> Self {
        let cell = AxisNeighbours::of_value(&self.axes[0], t);
        let count = self.velocity.len() / self.axes[0].len();
        let mut velocity = vec![V3::zeros(); count];
        for (it, share, _) in cell.neighbours() {
            let known = &self.velocity[it * count..(it + 1) * count];
            for (sum, known) in velocity.iter_mut().zip(known) {
                *sum += known * share;
            }
        }
        let [_, x, y, z] = self.axes.clone();
        Self {
            axes: [vec![t], x, y, z],
            velocity,
        }
    }

    /// Whether it changes with time.
    #[must_use]
    pub fn varies_in_time(&self) -> bool {
        self.axes[0].len() > 1
    }

    /// Whether it is the same everywhere at one height.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.axes[1].len() == 1 && self.axes[2].len() == 1
    }

    /// Its times \[s\], ascending.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.axes[0]
    }

    /// Its heights z \[m\], ascending.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.axes[3]
    }

    /// Its velocities \[m/s\], z fastest, then y, x and t.
    #[must_use]
    pub fn velocities(&self) -> &[V3] {
        &self.velocity
    }

    /// Greatest speed at any time and place \[m/s\].
    #[must_use]
    pub fn max_speed(&self) -> f64 {
        self.velocity.iter().map(V3::norm).fold(0.0, f64::max)
    }
}

/// Number of a velocity by the numbers of its time, x, y and z.
fn slot(axes: &[Vec<f64>; 4], [it, ix, iy, iz]: [usize; 4]) -> usize {
    let [_, nx, ny, nz] = [0, 1, 2, 3].map(|k: usize| axes[k].len());
    ((it * nx + ix) * ny + iy) * nz + iz
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A field that is linear in each coordinate, which the interpolation reproduces.
    fn field(t: f64, x: f64, y: f64, z: f64) -> V3 {
        V3::new(
            1.0 + 0.1 * x * t - 0.2 * y * z,
            0.3 * x * y + t * z,
            0.01 * x * y * z * t - y,
        )
    }

    fn grid() -> CurrentGrid {
        let axes: [&[f64]; 4] = [&[0.0, 2.0, 5.0], &[-4.0, 1.0], &[0.0, 3.0], &[-9.0, -1.0]];
        let mut rows = Vec::new();
        for t in axes[0] {
            for x in axes[1] {
                for y in axes[2] {
                    for z in axes[3] {
                        rows.push(([*t, *x, *y, *z], field(*t, *x, *y, *z)));
                    }
                }
            }
        }
        rows.reverse();
        CurrentGrid::of_rows(&rows).unwrap()
    }

    #[test]
    fn a_field_linear_in_each_coordinate_is_reproduced() {
        let grid = grid();
        for (t, x, y, z) in [(0.5, -3.0, 1.0, -2.0), (4.0, 0.3, 2.9, -8.0)] {
            let (velocity, gradient) = grid.at(t, &V3::new(x, y, z));
            assert!((velocity - field(t, x, y, z)).norm() < 1e-13);
            let h = 1e-5;
            for axis in 0..3 {
                let step = V3::ith(axis, h);
                let by = grid.at(t, &(V3::new(x, y, z) + step)).0
                    - grid.at(t, &(V3::new(x, y, z) - step)).0;
                assert!((by / (2.0 * h) - gradient.column(axis)).norm() < 1e-9);
            }
            let frozen = grid.frozen(t).at(99.0, &V3::new(x, y, z)).1;
            assert!((frozen - gradient).norm() < 1e-13);
        }
    }

    #[test]
    fn constant_beyond_the_ends() {
        let grid = grid();
        let (velocity, gradient) = grid.at(99.0, &V3::new(-9.0, 9.0, 2.0));
        assert_eq!(velocity, field(5.0, -4.0, 3.0, -1.0));
        assert_eq!(gradient, M3::zeros());
        assert_eq!(
            grid.at(-1.0, &V3::new(-9.0, 9.0, 2.0)).0,
            field(0.0, -4.0, 3.0, -1.0)
        );
    }

    #[test]
    fn rows_that_make_no_grid() {
        let row = |t: f64, x: f64| ([t, x, 0.0, 0.0], V3::x());
        let missing = [row(0.0, 0.0), row(0.0, 1.0), row(1.0, 0.0)];
        assert_eq!(
            CurrentGrid::of_rows(&missing),
            Err(CurrentGridError::NotRectangular)
        );
        let twice = [row(0.0, 0.0), row(0.0, 0.0)];
        assert_eq!(
            CurrentGrid::of_rows(&twice),
            Err(CurrentGridError::NotRectangular)
        );
        assert_eq!(
            CurrentGrid::of_rows(&[]),
            Err(CurrentGridError::NotRectangular)
        );
    }
}
