//! The bed under a line that lies on it: level or sloping, with Coulomb friction.

use super::error::CatenaryError;
use super::line::RigidBed;

/// A bed of slope θ and coefficient of friction μ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slope {
    pub sin: f64,
    pub cos: f64,
    pub tan: f64,
    pub friction: f64,
}

impl Slope {
    pub(super) fn new(bed: &RigidBed) -> Self {
        let (sin, cos) = bed.slope_rad.sin_cos();
        Self {
            sin,
            cos,
            tan: bed.slope_rad.tan(),
            friction: bed.friction,
        }
    }

    /// Tension lost towards A per weight on the bed: sin θ + μ cos θ.
    pub(super) fn drop(&self) -> f64 {
        self.sin + self.friction * self.cos
    }

    /// 1/cos θ - 1
    pub(super) fn secant_minus_1(&self) -> f64 {
        self.tan * self.tan / (1.0 + 1.0 / self.cos)
    }

    /// Whether friction holds slack line on the slope.
    pub(super) fn holds(&self) -> bool {
        self.friction >= self.tan.abs()
    }

    /// Slack line slides down this slope.
    pub(super) fn slides(&self) -> CatenaryError {
        CatenaryError::SlackOnSlope {
            needed: self.tan.abs(),
        }
    }
}
