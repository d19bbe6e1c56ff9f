//! The rope while the ship moves, made fast and on the winch of the file.

use super::RopewayError;
use super::ship_motion;
use super::solve::SolvedRopeway;
use super::winch::{ShipOffset, WinchControl, WinchSample, simulate};

/// The rope while the ship moves, made fast and on the winch.
#[derive(Debug, Clone, PartialEq)]
pub struct WinchRun {
    /// Samples with the rope made fast.
    pub made_fast: Result<Vec<WinchSample>, RopewayError>,
    /// Samples on the winch; absent: there is none.
    pub constant_tension: Option<Result<Vec<WinchSample>, RopewayError>>,
    /// Tension that the winch keeps \[N\].
    pub tension_n: f64,
}

impl SolvedRopeway {
    /// The winch's settings; absent: the ropeway has none.
    ///
    /// # Errors
    /// Those of [`SolvedRopeway::equilibrium`], which gives the tension where the file does not.
    pub fn winch_control(&self) -> Result<Option<WinchControl>, RopewayError> {
        let Some(winch) = &self.ropeway.winch else {
            return Ok(None);
        };
        let tension_n = match winch.tension_n {
            Some(tension) => tension,
            None => self.equilibrium(self.ropeway.cargo.position)?.ship_n(),
        };
        Ok(Some(WinchControl {
            tension_n,
            speed_m_per_s: winch.speed_m_per_s.unwrap_or(f64::INFINITY),
            power_w: winch.power_w.unwrap_or(f64::INFINITY),
            stored_m: self.ropeway.stored_m(),
        }))
    }

    /// Simulates the rope over a motion of the ship, with the cargo where the file has it.
    ///
    /// # Errors
    /// Those of [`SolvedRopeway::equilibrium`].
    pub fn run_winch(&self, series: &[ShipOffset]) -> Result<WinchRun, RopewayError> {
        let start = self.equilibrium(self.ropeway.cargo.position)?;
        let control = self.winch_control()?;
        Ok(WinchRun {
            made_fast: simulate(&self.rope, &start, None, series),
            tension_n: control.map_or_else(|| start.ship_n(), |control| control.tension_n),
            constant_tension: control
                .map(|control| simulate(&self.rope, &start, Some(&control), series)),
        })
    }

    /// The ship's motion of the file over its duration; absent: the ship lies still.
    #[must_use]
    pub fn ship_motion(&self) -> Option<Vec<ShipOffset>> {
        let motion = self.ropeway.motion.as_ref()?;
        Some(ship_motion::series(
            motion,
            self.ropeway.dynamics.duration_s,
        ))
    }
}
