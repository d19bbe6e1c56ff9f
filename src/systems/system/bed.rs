//! The sea bed under a system: level, sloping evenly, or with depths over a grid of places.

use std::sync::Arc;

use crate::numerics::{DepthGrid, M3, V3};

/// The sea bed under a system.
#[derive(Debug, Clone, PartialEq)]
pub enum Bed {
    /// Level, at this height above still water \[m\], negative.
    Level(f64),
    /// A plane that slopes: its height at x = y = 0 \[m\], and its unit normal.
    Plane(f64, V3),
    /// With depths over a grid.
    Grid(Arc<DepthGrid>),
}

impl Bed {
    /// Height of the bed below a place \[m\].
    #[inline]
    #[must_use]
    pub fn z_below(&self, place: &V3) -> f64 {
        match self {
            Self::Level(z) => *z,
            Self::Plane(z, normal) => z - (normal.x * place.x + normal.y * place.y) / normal.z,
            Self::Grid(grid) => -grid.at(place.x, place.y).depth,
        }
    }

    /// Height of a place above the bed \[m\], along the normal of a plane, vertical over a grid; negative below it.
    #[inline]
    #[must_use]
    pub fn height(&self, place: &V3) -> f64 {
        match self {
            Self::Plane(z, normal) => normal.dot(place) - normal.z * z,
            Self::Level(_) | Self::Grid(_) => place.z - self.z_below(place),
        }
    }

    /// How the height of the bed rises along x and y at a place \[-\].
    #[must_use]
    pub fn rise(&self, place: &V3) -> [f64; 2] {
        let gradient = self.gradient(place);
        [-gradient.x / gradient.z, -gradient.y / gradient.z]
    }

    /// Derivative of that height by the place, along which the bed pushes \[-\]: its normal, longer over a grid that slopes.
    #[inline]
    #[must_use]
    pub fn gradient(&self, place: &V3) -> V3 {
        match self {
            Self::Level(_) => V3::z(),
            Self::Plane(_, normal) => *normal,
            Self::Grid(grid) => {
                let [by_x, by_y] = grid.at(place.x, place.y).slope;
                V3::new(by_x, by_y, 1.0)
            }
        }
    }

    /// Second derivative of that height \[1/m\]; nothing on a plane.
    #[inline]
    #[must_use]
    pub fn curvature(&self, place: &V3) -> Option<M3> {
        match self {
            Self::Level(_) | Self::Plane(..) => None,
            Self::Grid(grid) => {
                let [xx, xy, yy] = grid.at(place.x, place.y).curvature;
                Some(M3::new(xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 0.0))
            }
        }
    }

    /// Height of the bed \[m\] where it is flat below the straight way between two places; nothing where it is not.
    #[must_use]
    pub fn flat_between(&self, from: &V3, to: &V3) -> Option<f64> {
        match self {
            Self::Level(z) => Some(*z),
            Self::Plane(..) => None,
            Self::Grid(grid) => grid
                .flat_along([from.x, from.y], [to.x, to.y])
                .map(|depth| -depth),
        }
    }

    /// Whether it has one height everywhere.
    #[must_use]
    pub fn is_level(&self) -> bool {
        matches!(self, Self::Level(_))
    }
}
