//! Response amplitude operators: how a vessel moves in a regular wave of unit amplitude.
//!
//! # The table
//! For one heading of the ship to the waves, at rising frequencies: amplitude per wave amplitude and phase of
//! surge, sway, heave \[m/m\] and roll, pitch, yaw \[rad/m\], about a reference point. Ship axes: x forward, y to
//! port, z up, rotations by the right hand (roll: port side up; pitch: bow down; yaw: bow to port). A phase is the
//! lead over the wave's crest as it passes the reference point.
//!
//! # Between and beyond its frequencies
//! Real and imaginary part are linear in angular frequency in between. Beyond either end the last entry holds;
//! [`Rao::energy_beyond`] gives the share of a sea's energy there.

use nalgebra::Complex;

use super::{Component, Harmonics};
use crate::numerics::V3;
use crate::numerics::interpolation::{mix, share};

/// Names of the six degrees of freedom, in their order.
pub const DEGREES: [&str; 6] = ["surge", "sway", "heave", "roll", "pitch", "yaw"];

/// Complex response per wave amplitude: surge, sway, heave \[m/m\], roll, pitch, yaw \[rad/m\].
pub type RaoResponse = [Complex<f64>; 6];

/// Why a table is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum RaoError {
    /// No entry.
    #[error("the table has no entry")]
    Empty,
    /// Frequencies fall, stand still or are none.
    #[error("frequencies must be positive and rise; entry {0} does not")]
    Order(usize),
}

/// A table of responses over frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Rao {
    omega: Vec<f64>,
    response: Vec<RaoResponse>,
}

/// The response a share of the way between two.
fn mixed(from: &RaoResponse, to: &RaoResponse, share: f64) -> RaoResponse {
    std::array::from_fn(|i| mix(from[i], to[i], share))
}

impl Rao {
    /// A table of responses at rising angular frequencies \[rad/s\].
    ///
    /// # Errors
    /// [`RaoError`] when it is empty or its frequencies do not rise.
    pub fn new(entries: Vec<(f64, RaoResponse)>) -> Result<Self, RaoError> {
        if entries.is_empty() {
            return Err(RaoError::Empty);
        }
        let mut before = 0.0;
        for (i, (omega, _)) in entries.iter().enumerate() {
            if !omega.is_finite() || *omega <= before {
                return Err(RaoError::Order(i));
            }
            before = *omega;
        }
        let (omega, response) = entries.into_iter().unzip();
        Ok(Self { omega, response })
    }

    /// The response at an angular frequency \[rad/s\].
    #[must_use]
    pub fn response(&self, omega: f64) -> RaoResponse {
        let next = self.omega.partition_point(|known| *known <= omega);
        if next == 0 || next == self.omega.len() {
            return self.response[next.saturating_sub(1)];
        }
        let share = share(&self.omega, next - 1, omega);
        mixed(&self.response[next - 1], &self.response[next], share)
    }

    /// The lowest and the highest angular frequency of the table \[rad/s\].
    #[must_use]
    pub fn span(&self) -> (f64, f64) {
        let last = self.omega.len().saturating_sub(1);
        (self.omega[0], self.omega[last])
    }

    /// The table a share of the way to another one, at the frequencies of both.
    #[must_use]
    pub fn between(&self, other: &Self, share: f64) -> Self {
        let mut omega = [self.omega.as_slice(), other.omega.as_slice()].concat();
        omega.sort_by(f64::total_cmp);
        omega.dedup();
        let at = |w: &f64| mixed(&self.response(*w), &other.response(*w), share);
        Self {
            response: omega.iter().map(at).collect(),
            omega,
        }
    }

    /// The table for waves from the other side: sway, roll and yaw go the other way.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let turned = |r: &RaoResponse| -> RaoResponse {
            std::array::from_fn(|i| if matches!(i, 1 | 3 | 5) { -r[i] } else { r[i] })
        };
        Self {
            omega: self.omega.clone(),
            response: self.response.iter().map(turned).collect(),
        }
    }

    /// The share of a sea's energy at frequencies beyond the ends of the table, 0 to 1.
    #[must_use]
    pub fn energy_beyond(&self, sea: &[Component]) -> f64 {
        let (first, last) = (self.omega[0], self.omega[self.omega.len() - 1]);
        let energy = |c: &Component| c.amplitude * c.amplitude;
        let all: f64 = sea.iter().map(energy).sum();
        let beyond = sea.iter().filter(|c| c.omega < first || c.omega > last);
        beyond.map(energy).sum::<f64>() / all
    }

    /// The motion \[m\] in the axes of the case of a point fixed to the ship, in a sea as it passes the ship's
    /// reference point. `heading` \[rad\] is where the ship points, from +x towards +y; `arm` \[m\] goes from the
    /// reference point to the point, in ship axes. Rotations count in first order, as they do in the table.
    #[must_use]
    pub fn motion_at(&self, sea: &[Component], heading: f64, arm: &V3) -> Harmonics {
        let (sin, cos) = heading.sin_cos();
        let amplitude = |c: &Component| {
            let wave = Complex::from_polar(c.amplitude, c.phase);
            let q = self.response(c.omega).map(|r| r * wave);
            // Displacement of the point: translation and rotation × arm.
            let forward = q[0] + q[4] * arm.z - q[5] * arm.y;
            let port = q[1] + q[5] * arm.x - q[3] * arm.z;
            let up = q[2] + q[3] * arm.y - q[4] * arm.x;
            let (x, y) = (forward * cos - port * sin, forward * sin + port * cos);
            (c.omega, [x, y, up])
        };
        Harmonics::of_amplitudes(sea.iter().map(amplitude))
    }
}

impl Rao {
    /// Roll, pitch and yaw \[rad\] in a sea as it passes the ship's reference point.
    #[must_use]
    pub fn rotations_in(&self, sea: &[Component]) -> Harmonics {
        let amplitude = |c: &Component| {
            let wave = Complex::from_polar(c.amplitude, c.phase);
            let q = self.response(c.omega);
            (c.omega, [q[3] * wave, q[4] * wave, q[5] * wave])
        };
        Harmonics::of_amplitudes(sea.iter().map(amplitude))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    fn zero() -> RaoResponse {
        [Complex::new(0.0, 0.0); 6]
    }

    fn one(degree: usize, value: Complex<f64>) -> Rao {
        let mut entry = zero();
        entry[degree] = value;
        Rao::new(vec![(0.5, entry)]).unwrap()
    }

    const WAVE: Component = Component {
        omega: 0.5,
        amplitude: 2.0,
        phase: 0.3,
    };

    #[test]
    fn heave_leads_the_crest_by_its_phase() {
        let rao = one(2, Complex::from_polar(0.7, 0.4));
        let motion = rao.motion_at(&[WAVE], 1.0, &V3::new(5.0, 3.0, 1.0));
        for t in [0.0, 2.0, 7.0] {
            let expected = 1.4 * (0.5 * t + 0.7_f64).cos();
            assert!((motion.at(t).0 - V3::z() * expected).norm() < 1e-14);
        }
    }

    #[test]
    fn rotations_move_a_point_with_an_arm_and_headings_turn_it() {
        // Bow down, seen at the bow: down; at the mast head: forward.
        let pitch = one(4, Complex::new(0.1, 0.0));
        let at = |arm: V3, heading: f64| pitch.motion_at(&[WAVE], heading, &arm).at(0.0).0;
        let angle = 0.2 * 0.3_f64.cos();
        assert!((at(V3::x() * 50.0, 0.0) + V3::z() * 50.0 * angle).norm() < 1e-13);
        assert!((at(V3::z() * 20.0, 0.0) - V3::x() * 20.0 * angle).norm() < 1e-13);
        assert!((at(V3::z() * 20.0, FRAC_PI_2) - V3::y() * 20.0 * angle).norm() < 1e-13);
        // Every rotation is about its own axis.
        for (degree, axis) in [(3, V3::x()), (4, V3::y()), (5, V3::z())] {
            let rao = one(degree, Complex::new(0.1, 0.0));
            let arm = V3::new(1.0, 2.0, 3.0);
            let moved = rao.motion_at(&[WAVE], 0.0, &arm).at(0.0).0;
            assert!((moved - axis.cross(&arm) * angle).norm() < 1e-13);
        }
    }

    #[test]
    fn the_ship_turns_by_the_response_times_the_wave() {
        for (degree, axis) in [(3, V3::x()), (4, V3::y()), (5, V3::z())] {
            let turned = one(degree, Complex::from_polar(0.1, 0.4)).rotations_in(&[WAVE]);
            for t in [0.0, 2.0, 7.0] {
                let expected = axis * (0.2 * (0.5 * t + 0.7_f64).cos());
                assert!((turned.at(t).0 - expected).norm() < 1e-14);
            }
        }
    }

    #[test]
    fn linear_between_and_held_beyond() {
        let entry = |x: f64| {
            let mut e = zero();
            e[0] = Complex::new(x, 2.0 * x);
            e
        };
        let rao = Rao::new(vec![(0.5, entry(1.0)), (1.0, entry(3.0))]).unwrap();
        assert!((rao.response(0.75)[0] - Complex::new(2.0, 4.0)).norm() < 1e-14);
        assert_eq!(rao.response(0.1), entry(1.0));
        assert_eq!(rao.response(9.0), entry(3.0));
        assert_eq!(rao.span(), (0.5, 1.0));
        let quick = Component { omega: 2.0, ..WAVE };
        assert_eq!(rao.energy_beyond(&[WAVE, quick]), 0.5);
        assert_eq!(Rao::new(vec![]), Err(RaoError::Empty));
        let falling = vec![(1.0, zero()), (0.5, zero())];
        assert_eq!(Rao::new(falling), Err(RaoError::Order(1)));
    }
}
