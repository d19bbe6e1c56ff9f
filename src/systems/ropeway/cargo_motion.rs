//! The cargo of a ropeway with one degree of freedom: at its place and hauled across while the ship moves.

use super::RopewayError;
use super::oscillator::{CargoOscillator, CargoPosition, CargoState};
use super::ship_motion;
use super::solve::SolvedRopeway;

/// The part of the span, at either end, that a crossing leaves out: the cargo's equation ends at a support.
pub const MARGIN: f64 = 0.05;

impl SolvedRopeway {
    /// The cargo with one degree of freedom, eq. (12), at the horizontal tension of the elastic rope.
    ///
    /// # Errors
    /// Those of [`SolvedRopeway::equilibrium`]; [`RopewayError::NotFound`] where there is no cargo.
    pub fn oscillator(&self) -> Result<CargoOscillator, RopewayError> {
        if self.ropeway.cargo.mass_kg <= 0.0 {
            return Err(RopewayError::NotFound("there is no cargo to move"));
        }
        let rest = self.equilibrium(self.ropeway.cargo.position)?;
        Ok(CargoOscillator {
            mass_kg: self.ropeway.cargo.mass_kg,
            cargo_n: self.rope.cargo_n,
            horizontal_n: rest.solution.h_b_n,
            damping_ratio: self.ropeway.dynamics.damping_ratio,
        })
    }

    /// The cargo at a fraction of the span while the ship lies still.
    #[must_use]
    pub fn cargo_position(&self, position: f64) -> CargoPosition {
        CargoPosition {
            geometry: self.rope.geometry,
            x_m: position * self.rope.geometry.span_m,
        }
    }

    /// The cargo at its place while the ship moves by the motion of the file.
    ///
    /// # Errors
    /// Those of [`CargoOscillator::simulate`].
    pub fn cargo_motion(
        &self,
        duration_s: f64,
        every_s: f64,
    ) -> Result<Vec<CargoState>, RopewayError> {
        let still = self.cargo_position(self.ropeway.cargo.position);
        let at = |t: f64| self.moved(still, t);
        self.oscillator()?.simulate(at, duration_s, every_s)
    }

    /// The cargo hauled from the ship to the platform while the ship moves by the motion of the file.
    ///
    /// # Errors
    /// Those of [`CargoOscillator::simulate`].
    pub fn oscillator_crossing(&self, instants: usize) -> Result<Vec<CargoState>, RopewayError> {
        let span = self.rope.geometry.span_m;
        let way = (1.0 - 2.0 * MARGIN) * span;
        let duration = way / self.ropeway.cargo.speed_m_per_s;
        let at = |t: f64| {
            let gone = self.ropeway.cargo.speed_m_per_s * t;
            let x_m = ((1.0 - MARGIN) * span - gone).max(MARGIN * span);
            let geometry = self.rope.geometry;
            self.moved(CargoPosition { geometry, x_m }, t)
        };
        self.oscillator()?
            .simulate(at, duration, duration / instants as f64)
    }

    fn moved(&self, still: CargoPosition, time_s: f64) -> CargoPosition {
        let Some(motion) = &self.ropeway.motion else {
            return still;
        };
        let ship = ship_motion::at(motion, time_s);
        CargoPosition {
            geometry: self.rope.moved(ship.x_m, ship.z_m).geometry,
            ..still
        }
    }
}
