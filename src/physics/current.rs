//! The current: uniform, or a table over depth with linear in between.

use crate::numerics::V3;

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
}

impl CurrentProfile {
    /// Greatest speed at any depth \[m/s\].
    #[must_use]
    pub fn max_speed(&self) -> f64 {
        match self {
            Self::Uniform(u) => u.norm(),
            Self::Table { velocity, .. } => velocity.iter().map(V3::norm).fold(0.0, f64::max),
        }
    }

    /// Velocity \[m/s\] and its derivative by z \[1/s\] at height z \[m\] above still water.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, z: f64) -> (V3, V3) {
        match self {
            Self::Uniform(u) => (*u, V3::zeros()),
            Self::Table { depth, velocity } => table(depth, velocity, -z),
        }
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
        assert_eq!(current.at(0.0), (V3::x(), V3::zeros()));
        assert_eq!(current.at(-20.0).0, V3::x() * 2.0);
        assert_eq!(current.at(-20.0).1, V3::x() * -0.1);
        assert_eq!(current.at(-99.0), (V3::x() * 3.0, V3::zeros()));
    }
}
