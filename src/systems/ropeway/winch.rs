//! A constant-tension winch on a moving ship, within its limits of speed, power and rope; or the rope made fast there.
//!
//! Quasi-static: each sample is an equilibrium, as the ship moves slowly compared with the rope's own periods. The cargo
//! stays at its arc length from the platform. The motion is any series of displacements of the hang point.

use super::RopewayError;
use super::elastic::{ElasticRope, RopeEquilibrium};
use crate::numerics::statistics::Statistics;

/// Displacement of the rope's hang point on the ship from its mean position, at a time.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ShipOffset {
    /// Time \[s\].
    pub time_s: f64,
    /// Away from the platform \[m\].
    pub x_m: f64,
    /// Upwards \[m\].
    pub z_m: f64,
}

/// Settings of a constant-tension winch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WinchControl {
    /// Tension at the ship that it keeps \[N\].
    pub tension_n: f64,
    /// Greatest speed of the rope \[m/s\]; infinite for no limit.
    pub speed_m_per_s: f64,
    /// Greatest power \[W\]; infinite for no limit.
    pub power_w: f64,
    /// Length of rope that can lie between the ends \[m\].
    pub stored_m: f64,
}

/// How the rope's end on the ship is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WinchState {
    /// Made fast.
    MadeFast,
    /// The winch keeps its tension.
    ConstantTension,
    /// The winch is at its greatest speed.
    SpeedLimit,
    /// The winch is at its greatest power.
    PowerLimit,
    /// All rope is paid out.
    RopeOut,
}

/// The rope at an instant of the ship's motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WinchSample {
    /// Displacement of the hang point.
    pub ship: ShipOffset,
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
    /// How the end on the ship is held.
    pub state: WinchState,
}

/// Statistics of a quantity over the samples.
#[must_use]
pub fn statistics(samples: &[WinchSample], of: impl Fn(&WinchSample) -> f64) -> Statistics {
    let values: Vec<f64> = samples.iter().map(of).collect();
    Statistics::of_values(&values)
}

/// Simulates the rope over a motion of the ship: with a winch, or made fast without one.
///
/// # Errors
/// [`RopewayError::BeyondReach`] where the ship goes further than the rope reaches; [`RopewayError::TooLittleTension`] where no
/// length gives the tension of the winch.
pub fn simulate(
    rope: &ElasticRope,
    start: &RopeEquilibrium,
    control: Option<&WinchControl>,
    motion: &[ShipOffset],
) -> Result<Vec<WinchSample>, RopewayError> {
    let mut simulation = WinchSimulation {
        rope,
        arc_m: start.arc_m,
        length_m: start.length_m,
        time_s: None,
        slope: None,
    };
    motion
        .iter()
        .map(|ship| simulation.step(*ship, control))
        .collect()
}

struct WinchSimulation<'a> {
    rope: &'a ElasticRope,
    arc_m: f64,
    length_m: f64,
    /// Time of the previous sample.
    time_s: Option<f64>,
    /// Slope of tension over length, as last estimated \[N/m\].
    slope: Option<f64>,
}

impl WinchSimulation<'_> {
    fn step(
        &mut self,
        ship: ShipOffset,
        control: Option<&WinchControl>,
    ) -> Result<WinchSample, RopewayError> {
        let there = self.rope.moved(ship.x_m, ship.z_m);
        let before = self.length_m;
        let (length, state) = match control {
            None => (before, WinchState::MadeFast),
            Some(control) => {
                let wanted = self.length_for_tension(&there, control.tension_n)?;
                self.limit_length(wanted, ship.time_s, control)
            }
        };
        let rest = there
            .with_cargo_at(length, self.arc_m)
            .map_err(|error| out_of_reach(error, ship, length))?;
        let lapse = self.time_s.map_or(0.0, |time| ship.time_s - time);
        let speed = if lapse > 0.0 {
            (length - before) / lapse
        } else {
            0.0
        };
        self.length_m = length;
        self.time_s = Some(ship.time_s);
        Ok(WinchSample {
            ship,
            length_m: length,
            speed_m_per_s: speed,
            ship_n: rest.ship_n(),
            platform_n: rest.platform_n(),
            depth_m: -rest.cargo_m.1,
            power_w: -speed * rest.ship_n(),
            state,
        })
    }

    /// The length that gives the tension: secant steps from the last length and slope; a bracketed search where they fail.
    fn length_for_tension(
        &mut self,
        there: &ElasticRope,
        tension_n: f64,
    ) -> Result<f64, RopewayError> {
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
        let length = there.length_for_tension(tension_n, rest)?;
        let near = length * (1.0 + 1e-7);
        self.slope = Some((rest(near)?.ship_n() - tension_n) / (near - length));
        Ok(length)
    }

    /// The length that the winch reaches towards a wanted one, within its limits.
    fn limit_length(&self, wanted: f64, time_s: f64, control: &WinchControl) -> (f64, WinchState) {
        let mut length = wanted;
        let mut state = WinchState::ConstantTension;
        if let Some(before) = self.time_s {
            let by_power = control.power_w / control.tension_n;
            let most = control.speed_m_per_s.min(by_power) * (time_s - before);
            let change = wanted - self.length_m;
            if change.abs() > most {
                length = self.length_m + most.copysign(change);
                state = if by_power < control.speed_m_per_s {
                    WinchState::PowerLimit
                } else {
                    WinchState::SpeedLimit
                };
            }
        }
        if length > control.stored_m {
            return (control.stored_m, WinchState::RopeOut);
        }
        (length, state)
    }
}

fn out_of_reach(error: RopewayError, ship: ShipOffset, length_m: f64) -> RopewayError {
    match error {
        RopewayError::Overstretched | RopewayError::TooShort { .. } => RopewayError::BeyondReach {
            time_s: ship.time_s,
            off_m: ship.x_m,
            length_m,
        },
        other => other,
    }
}
