//! How much of a free point is under water: of a ball of its volume about it.

use super::network::{FreePoint, Network};

/// The part of a ball under water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Immersion {
    /// Share of its volume.
    pub share: f64,
    /// Derivative of the share by height \[1/m\].
    pub by_height: f64,
    /// Integral of the share over the height from the surface \[m\].
    pub integral: f64,
}

impl Immersion {
    /// All of it, wherever it is.
    pub const WHOLE: Self = Self {
        share: 1.0,
        by_height: 0.0,
        integral: 0.0,
    };

    /// Of a point at a height above the surface \[m\].
    #[must_use]
    pub fn of_point(network: &Network, point: &FreePoint, z: f64) -> Self {
        if point.always_wet {
            return Self {
                integral: z,
                ..Self::WHOLE
            };
        }
        let weight = network.density * network.gravity;
        let volume = if weight > 0.0 {
            point.buoyancy / weight
        } else {
            0.0
        };
        Self::of_ball(volume, z)
    }

    /// Of a ball of a volume \[m^3\] whose centre is at a height above the surface \[m\].
    #[must_use]
    pub fn of_ball(volume: f64, z: f64) -> Self {
        let r = (0.75 * volume / std::f64::consts::PI).cbrt();
        if z >= r {
            return Self {
                share: 0.0,
                by_height: 0.0,
                integral: 0.375 * r,
            };
        }
        if z <= -r {
            return Self {
                share: 1.0,
                by_height: 0.0,
                integral: z + 0.375 * r,
            };
        }
        let integral = 0.5 * z - 0.375 * z * z / r + z.powi(4) / (16.0 * r.powi(3));
        Self {
            share: (r - z).powi(2) * (2.0 * r + z) / (4.0 * r.powi(3)),
            by_height: -0.75 * (r * r - z * z) / r.powi(3),
            // As far below the ball's top as the parts beyond it continue.
            integral: integral + 0.1875 * r,
        }
    }
}
