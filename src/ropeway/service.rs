//! What the winch and the cargo do while the ship moves: the file's motion followed, and what comes of it.

use super::Trouble;
use super::motion;
use super::swing::{Hang, Swing, Swung};
use super::winch::{HangPoint, Keeper, Moment, follow};
use super::work::Worked;

/// The part of the span, at either end, that a crossing leaves out: the cargo's equation ends at a support.
pub const MARGIN: f64 = 0.05;

/// The rope's end on the moving ship, made fast and held by the winch.
#[derive(Debug, Clone, PartialEq)]
pub struct Followed {
    /// Made fast.
    pub fast: Result<Vec<Moment>, Trouble>,
    /// Held by the winch; absent: there is none.
    pub kept: Option<Result<Vec<Moment>, Trouble>>,
    /// Tension that the winch keeps \[N\].
    pub tension_n: f64,
}

impl Worked {
    /// The winch's settings; absent: the ropeway has none.
    ///
    /// # Errors
    /// Those of [`Worked::rest`], which gives the tension where the file does not.
    pub fn keeper(&self) -> Result<Option<Keeper>, Trouble> {
        let Some(winch) = &self.ropeway.winch else {
            return Ok(None);
        };
        let tension_n = match winch.tension_n {
            Some(tension) => tension,
            None => self.rest(self.ropeway.cargo.position)?.ship_n(),
        };
        Ok(Some(Keeper {
            tension_n,
            speed_m_per_s: winch.speed_m_per_s.unwrap_or(f64::INFINITY),
            power_w: winch.power_w.unwrap_or(f64::INFINITY),
            stored_m: self.ropeway.stored_m(),
        }))
    }

    /// The rope's end follows a motion of the ship, with the cargo where the file has it.
    ///
    /// # Errors
    /// Those of [`Worked::rest`].
    pub fn follow(&self, series: &[HangPoint]) -> Result<Followed, Trouble> {
        let start = self.rest(self.ropeway.cargo.position)?;
        let keeper = self.keeper()?;
        Ok(Followed {
            fast: follow(&self.span, &start, None, series),
            tension_n: keeper.map_or_else(|| start.ship_n(), |keeper| keeper.tension_n),
            kept: keeper.map(|keeper| follow(&self.span, &start, Some(&keeper), series)),
        })
    }

    /// The ship's motion of the file over the time that is followed; absent: the ship lies still.
    #[must_use]
    pub fn series(&self) -> Option<Vec<HangPoint>> {
        let motion = self.ropeway.motion.as_ref()?;
        Some(motion::series(motion, self.ropeway.dynamics.duration_s))
    }

    /// The cargo with one degree of freedom, eq. (12), on the pull that the exact rope has.
    ///
    /// # Errors
    /// Those of [`Worked::rest`]; [`Trouble::NotFound`] where there is no cargo.
    pub fn swing(&self) -> Result<Swing, Trouble> {
        if self.ropeway.cargo.mass_kg <= 0.0 {
            return Err(Trouble::NotFound("there is no cargo to move"));
        }
        let rest = self.rest(self.ropeway.cargo.position)?;
        Ok(Swing {
            mass_kg: self.ropeway.cargo.mass_kg,
            cargo_n: self.span.cargo_n,
            horizontal_n: rest.solution.h_b_n,
            damping_ratio: self.ropeway.dynamics.damping_ratio,
        })
    }

    /// Where the cargo hangs at a part of the span while the ship lies still.
    #[must_use]
    pub fn hang(&self, position: f64) -> Hang {
        Hang {
            gap: self.span.gap,
            x_m: position * self.span.gap.span_m,
        }
    }

    /// The cargo at its place while the ship moves as the file says.
    ///
    /// # Errors
    /// Those of [`Swing::follow`].
    pub fn swung(&self, duration_s: f64, every_s: f64) -> Result<Vec<Swung>, Trouble> {
        let still = self.hang(self.ropeway.cargo.position);
        let at = |t: f64| self.moved(still, t);
        self.swing()?.follow(at, duration_s, every_s)
    }

    /// The cargo hauled from the ship to the platform while the ship moves as the file says.
    ///
    /// # Errors
    /// Those of [`Swing::follow`].
    pub fn crossing(&self, instants: usize) -> Result<Vec<Swung>, Trouble> {
        let span = self.span.gap.span_m;
        let way = (1.0 - 2.0 * MARGIN) * span;
        let duration = way / self.ropeway.cargo.speed_m_per_s;
        let at = |t: f64| {
            let gone = self.ropeway.cargo.speed_m_per_s * t;
            let x_m = ((1.0 - MARGIN) * span - gone).max(MARGIN * span);
            let gap = self.span.gap;
            self.moved(Hang { gap, x_m }, t)
        };
        self.swing()?
            .follow(at, duration, duration / instants as f64)
    }

    fn moved(&self, hang: Hang, time_s: f64) -> Hang {
        let Some(motion) = &self.ropeway.motion else {
            return hang;
        };
        let ship = motion::at(motion, time_s);
        Hang {
            gap: self.span.moved(ship.x_m, ship.z_m).gap,
            ..hang
        }
    }
}
