//! A record of a motion: the sum of regular components at equal time steps.

use crate::physics::sea::Component;

/// Displacement, velocity and acceleration at equal steps from t = 0.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MotionRecord {
    /// Displacements.
    pub x: Vec<f64>,
    /// Velocities, per second.
    pub v: Vec<f64>,
    /// Accelerations, per second squared.
    pub a: Vec<f64>,
}

impl MotionRecord {
    /// `instants` instants a `step` \[s\] apart of components about a mean. Each component is rotated from instant to instant
    /// instead of by its cosine: rounding grows with the instants, to 1e-11 of the amplitude over a million.
    #[must_use]
    pub fn new(components: &[Component], mean: f64, step: f64, instants: usize) -> Self {
        let mut record = Self {
            x: vec![mean; instants],
            v: vec![0.0; instants],
            a: vec![0.0; instants],
        };
        for component in components {
            record.add(component, step);
        }
        record
    }

    fn add(&mut self, component: &Component, step: f64) {
        let w = component.omega;
        let (step_sin, step_cos) = (w * step).sin_cos();
        let (sin, cos) = component.phase.sin_cos();
        let (mut sin, mut cos) = (component.amplitude * sin, component.amplitude * cos);
        let rates = self.v.iter_mut().zip(&mut self.a);
        for (x, (v, a)) in self.x.iter_mut().zip(rates) {
            *x += cos;
            *v -= w * sin;
            *a -= w * w * cos;
            (sin, cos) = (
                sin * step_cos + cos * step_sin,
                cos * step_cos - sin * step_sin,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotation_gives_the_cosine_and_its_derivatives() {
        let component = Component {
            omega: 1.3,
            amplitude: 0.7,
            phase: 0.4,
        };
        let record = MotionRecord::new(&[component], 2.0, 0.25, 40_000);
        for i in [0, 1, 777, 39_999] {
            let angle = 1.3 * 0.25 * i as f64 + 0.4;
            assert!((record.x[i] - 2.0 - 0.7 * angle.cos()).abs() < 1e-10);
            assert!((record.v[i] + 0.7 * 1.3 * angle.sin()).abs() < 1e-10);
            assert!((record.a[i] + 0.7 * 1.69 * angle.cos()).abs() < 1e-10);
        }
    }
}
