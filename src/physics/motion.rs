//! Prescribed motion of an end: held, or harmonic along each axis with a smooth start.

use std::f64::consts::TAU;

use crate::linalg::V3;

/// Motion of a held end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndMotion {
    /// Mean position \[m\].
    pub position: V3,
    /// Amplitudes along x, y, z \[m\].
    pub amplitude: V3,
    /// Angular frequency \[rad/s\].
    pub omega: f64,
    /// Phases along x, y, z \[rad\].
    pub phase: V3,
    /// The motion grows from nothing over this time \[s\].
    pub ramp: f64,
}

impl EndMotion {
    /// Held still.
    #[must_use]
    pub fn still(position: V3) -> Self {
        Self {
            position,
            amplitude: V3::zeros(),
            omega: 0.0,
            phase: V3::zeros(),
            ramp: 0.0,
        }
    }

    /// Position \[m\], velocity \[m/s\] and acceleration \[m/s²\] at time t \[s\]:
    /// `x0 + r(t) A sin(omega t + phase)`, r rising from 0 to 1 as a quintic with no kink in acceleration.
    #[must_use]
    pub fn at(&self, t: f64) -> (V3, V3, V3) {
        if self.amplitude == V3::zeros() {
            return (self.position, V3::zeros(), V3::zeros());
        }
        let (r, r1, r2) = self.growth(t);
        let w = self.omega;
        let angle = self.phase.map(|p| w * t + p);
        let s = angle.map(f64::sin).component_mul(&self.amplitude);
        let c = angle.map(f64::cos).component_mul(&self.amplitude) * w;
        (
            self.position + s * r,
            c * r + s * r1,
            s * (r2 - w * w * r) + c * (2.0 * r1),
        )
    }

    /// The growth r and its two derivatives by time.
    fn growth(&self, t: f64) -> (f64, f64, f64) {
        if t >= self.ramp {
            return (1.0, 0.0, 0.0);
        }
        let s = (t / self.ramp).max(0.0);
        let r = s * s * s * (10.0 + s * (6.0 * s - 15.0));
        let r1 = 30.0 * s * s * (1.0 - s) * (1.0 - s) / self.ramp;
        let r2 = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (self.ramp * self.ramp);
        (r, r1, r2)
    }
}

/// Angular frequency \[rad/s\] of a period \[s\].
#[must_use]
pub fn omega(period: f64) -> f64 {
    TAU / period
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn velocity_and_acceleration_are_derivatives() {
        let motion = EndMotion {
            position: V3::new(1.0, 2.0, 3.0),
            amplitude: V3::new(1.0, 0.5, 2.0),
            omega: 0.7,
            phase: V3::new(0.0, 1.0, 2.0),
            ramp: 5.0,
        };
        for t in [0.5, 2.0, 4.9, 7.0] {
            let h = 1e-4;
            let (before, now, after) = (motion.at(t - h), motion.at(t), motion.at(t + h));
            assert!(((after.0 - before.0) / (2.0 * h) - now.1).norm() < 1e-6);
            assert!(((after.1 - before.1) / (2.0 * h) - now.2).norm() < 1e-6);
        }
    }
}
