//! A steady current: uniform, a table over depth that is linear in between, or a grid of places.

use std::sync::Arc;

use super::CurrentGrid;
use crate::numerics::{M3, V3};

/// Velocity of the water.
#[derive(Debug, Clone, PartialEq)]
pub enum CurrentProfile {
    /// The same everywhere \[m/s\].
    Uniform(V3),
    /// Velocity at depths below still water, increasing \[m\]; constant beyond both ends.
    Table {
        /// Depths \[m\].
        depth: Vec<f64>,
        /// Velocities there \[m/s\].
        velocity: Vec<V3>,
    },
    /// Velocity over a grid of places, at one time.
    Grid(Arc<CurrentGrid>),
}

impl CurrentProfile {
    /// Greatest speed at any depth \[m/s\].
    #[must_use]
    pub fn max_speed(&self) -> f64 {
        match self {
            Self::Uniform(u) => u.norm(),
            Self::Table { velocity, .. } => velocity.iter().map(V3::norm).fold(0.0, f64::max),
            Self::Grid(grid) => grid.max_speed(),
        }
    }

    /// The current of a grid at a time \[s\]: a table over depth where it is the same everywhere at one height.
    #[must_use]
    pub fn of_grid(grid: &CurrentGrid, t: f64) -> Self {
        let now = grid.frozen(t);
        if !now.is_level() {
            return Self::Grid(Arc::new(now));
        }
        match now.velocities() {
            [one] => Self::Uniform(*one),
            many => Self::Table {
                depth: now.heights().iter().rev().map(|z| -z).collect(),
                velocity: many.iter().rev().copied().collect(),
            },
        }
    }

    /// Velocity \[m/s\] and its derivative by z \[1/s\] at a place \[m\], z above still water.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, place: &V3) -> (V3, V3) {
        match self {
            Self::Uniform(u) => (*u, V3::zeros()),
            Self::Table { depth, velocity } => table(depth, velocity, -place.z),
            Self::Grid(grid) => {
                let (velocity, gradient) = grid.at(0.0, place);
                (velocity, gradient.column(2).into_owned())
            }
        }
    }

    /// Velocity \[m/s\] and its whole derivative \[1/s\] at a place \[m\].
    #[must_use]
    pub fn flow(&self, place: &V3) -> (V3, M3) {
        match self {
            Self::Grid(grid) => grid.at(0.0, place),
            _ => {
                let (velocity, shear) = self.at(place);
                (velocity, shear * V3::z().transpose())
            }
        }
    }

    /// Whether it changes along x or y.
    #[must_use]
    pub const fn is_grid(&self) -> bool {
        matches!(self, Self::Grid(_))
    }
}

fn table(depth: &[f64], velocity: &[V3], d: f64) -> (V3, V3) {
    let next = depth.partition_point(|&known| known <= d);
    match next {
        0 => (velocity[0], V3::zeros()),
        n if n == depth.len() => (velocity[n - 1], V3::zeros()),
        n => {
            let span = depth[n] - depth[n - 1];
            let slope = (velocity[n] - velocity[n - 1]) / span;
            (velocity[n - 1] + slope * (d - depth[n - 1]), -slope)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_between_depths_and_constant_beyond() {
        let current = CurrentProfile::Table {
            depth: vec![10.0, 30.0],
            velocity: vec![V3::x(), V3::x() * 3.0],
        };
        let at = |z: f64| current.at(&V3::new(7.0, -5.0, z));
        assert_eq!(at(0.0), (V3::x(), V3::zeros()));
        assert_eq!(at(-20.0).0, V3::x() * 2.0);
        assert_eq!(at(-20.0).1, V3::x() * -0.1);
        assert_eq!(at(-99.0), (V3::x() * 3.0, V3::zeros()));
    }
}
