//! The rope's end on a moving ship: made fast, or held by a winch that keeps the tension as far as its speed, its power
//! and its rope allow.
//!
//! Each instant is an equilibrium: the ship's motion is slow beside the rope's own. The cargo stays at its place
//! along the rope, seen from the platform. The motion is any series of displacements of the hang point.

use super::Trouble;
use super::exact::{Rest, Span};

/// Where the rope's hang point on the ship is at an instant, as displaced from where it lies still.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct HangPoint {
    /// Time \[s\].
    pub time_s: f64,
    /// Away from the platform \[m\].
    pub x_m: f64,
    /// Upwards \[m\].
    pub z_m: f64,
}

/// A winch that keeps the tension at the ship.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Keeper {
    /// Tension it keeps \[N\].
    pub tension_n: f64,
    /// Greatest speed of the rope \[m/s\]; infinite for no limit.
    pub speed_m_per_s: f64,
    /// Greatest power \[W\]; infinite for no limit.
    pub power_w: f64,
    /// Length of rope that can lie between the ends \[m\].
    pub stored_m: f64,
}

/// How the rope is held at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Held {
    /// Made fast.
    Fast,
    /// The winch keeps its tension.
    Kept,
    /// The winch is at its greatest speed.
    AtSpeed,
    /// The winch is at its greatest power.
    AtPower,
    /// There is no more rope to pay out.
    RopeOut,
}

/// The rope at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Where the hang point is.
    pub ship: HangPoint,
    /// Unstretched length between the ends \[m\].
    pub length_m: f64,
    /// Speed of the rope over the winch, paying out positive \[m/s\].
    pub speed_m_per_s: f64,
    /// Tension at the ship \[N\].
    pub ship_n: f64,
    /// Tension at the platform \[N\].
    pub platform_n: f64,
    /// Depth of the cargo below the platform's hang point \[m\].
    pub depth_m: f64,
    /// Power that the winch puts into the rope; negative where it brakes \[W\].
    pub power_w: f64,
    /// How it is held.
    pub held: Held,
}

/// What a series comes to.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Extremes {
    /// Smallest.
    pub least: f64,
    /// Greatest.
    pub most: f64,
    /// Mean.
    pub mean: f64,
    /// Root of the mean square about the mean.
    pub deviation: f64,
}

/// Smallest, greatest and mean value of a quantity over a series, and its scatter.
#[must_use]
pub fn extremes(moments: &[Moment], of: impl Fn(&Moment) -> f64) -> Extremes {
    if moments.is_empty() {
        return Extremes::default();
    }
    let n = moments.len() as f64;
    let mean = moments.iter().map(&of).sum::<f64>() / n;
    let square = moments.iter().map(|m| (of(m) - mean).powi(2)).sum::<f64>() / n;
    Extremes {
        least: moments.iter().map(&of).fold(f64::INFINITY, f64::min),
        most: moments.iter().map(&of).fold(f64::NEG_INFINITY, f64::max),
        mean,
        deviation: square.sqrt(),
    }
}

/// Follows the ship: without a keeper the rope is fast and keeps its length.
///
/// # Errors
/// [`Trouble::BeyondReach`] where the ship goes further than the rope reaches; [`Trouble::TooLittleTension`] where it
/// comes so near, or asks for so little, that no length gives the tension.
pub fn follow(
    span: &Span,
    start: &Rest,
    keeper: Option<&Keeper>,
    motion: &[HangPoint],
) -> Result<Vec<Moment>, Trouble> {
    let mut follower = Follower {
        span,
        arc_m: start.arc_m,
        length_m: start.length_m,
        time_s: None,
        slope: None,
    };
    motion
        .iter()
        .map(|ship| follower.step(*ship, keeper))
        .collect()
}

struct Follower<'a> {
    span: &'a Span,
    arc_m: f64,
    length_m: f64,
    /// Time of the instant before.
    time_s: Option<f64>,
    /// Change of tension by length, as last seen \[N/m\].
    slope: Option<f64>,
}

impl Follower<'_> {
    fn step(&mut self, ship: HangPoint, keeper: Option<&Keeper>) -> Result<Moment, Trouble> {
        let there = self.span.moved(ship.x_m, ship.z_m);
        let before = self.length_m;
        let (wanted, held) = match keeper {
            None => (before, Held::Fast),
            Some(keeper) => {
                let wanted = self.wanted(&there, keeper.tension_n)?;
                self.reached(wanted, ship.time_s, keeper)
            }
        };
        let rest = there
            .with_cargo_at(wanted, self.arc_m)
            .map_err(|trouble| out_of_reach(trouble, ship, wanted))?;
        let lapse = self.time_s.map_or(0.0, |time| ship.time_s - time);
        let speed = if lapse > 0.0 {
            (wanted - before) / lapse
        } else {
            0.0
        };
        self.length_m = wanted;
        self.time_s = Some(ship.time_s);
        Ok(Moment {
            ship,
            length_m: wanted,
            speed_m_per_s: speed,
            ship_n: rest.ship_n(),
            platform_n: rest.platform_n(),
            depth_m: -rest.cargo_m.1,
            power_w: -speed * rest.ship_n(),
            held,
        })
    }

    /// The length that gives the tension: Newton with the slope as last seen, the search over all lengths where that fails.
    fn wanted(&mut self, there: &Span, tension_n: f64) -> Result<f64, Trouble> {
        let rest = |length: f64| there.with_cargo_at(length, self.arc_m);
        if let Some(mut slope) = self.slope {
            let mut length = self.length_m;
            let mut before: Option<(f64, f64)> = None;
            for _ in 0..12 {
                let Ok(here) = rest(length) else { break };
                let off = here.ship_n() - tension_n;
                if let Some((at, was)) = before
                    && length != at
                {
                    slope = (off - was) / (length - at);
                }
                if off.abs() <= 1e-9 * tension_n {
                    self.slope = Some(slope);
                    return Ok(length);
                }
                if slope.is_nan() || slope >= 0.0 {
                    break;
                }
                before = Some((length, off));
                length -= off / slope;
            }
        }
        let length = there.length_by_tension(tension_n, rest)?;
        let near = length * (1.0 + 1e-7);
        self.slope = Some((rest(near)?.ship_n() - tension_n) / (near - length));
        Ok(length)
    }

    /// What the winch makes of a wanted length.
    fn reached(&self, wanted: f64, time_s: f64, keeper: &Keeper) -> (f64, Held) {
        let mut length = wanted;
        let mut held = Held::Kept;
        if let Some(before) = self.time_s {
            let by_power = keeper.power_w / keeper.tension_n;
            let most = keeper.speed_m_per_s.min(by_power) * (time_s - before);
            let change = wanted - self.length_m;
            if change.abs() > most {
                length = self.length_m + most.copysign(change);
                held = if by_power < keeper.speed_m_per_s {
                    Held::AtPower
                } else {
                    Held::AtSpeed
                };
            }
        }
        if length > keeper.stored_m {
            return (keeper.stored_m, Held::RopeOut);
        }
        (length, held)
    }
}

fn out_of_reach(trouble: Trouble, ship: HangPoint, length_m: f64) -> Trouble {
    match trouble {
        Trouble::Overstretched | Trouble::TooShort { .. } => Trouble::BeyondReach {
            time_s: ship.time_s,
            off_m: ship.x_m,
            length_m,
        },
        other => other,
    }
}
