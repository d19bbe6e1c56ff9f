//! The rope in motion while the ship moves, made fast and on the winch: what the inertia of rope, cargo and drum makes of the tensions that
//! equilibria give ([`simulate`]).

use super::RopewayError;
use super::elastic::{Carrier, RopeEquilibrium};
use super::model::HangPointMotion;
use super::rope_system::{self, LINES, SHIP, SHIP_TENSION};
use super::ship_motion;
use super::solve::SolvedRopeway;
use super::winch::{ShipOffset, WinchControl, WinchSample, WinchState, simulate};
use crate::case::Solver;
use crate::numerics::statistics::Statistics;
use crate::physics::ramp::smooth_ramp;
use crate::run::History;
use crate::run::error_estimate::HistoryPair;
use crate::system::SystemFile;
use crate::system::model::{PayoutInputs, PointInputs, WhichEnd};
use crate::system::motion::run::MotionRun;

/// Longest time of the ship's motion that is computed \[s\], and the most steps.
const LONGEST: f64 = 300.0;
const MOST_STEPS: f64 = 6000.0;

/// Time over which the motion grows \[s\], and the least that passes before statistics count.
const RAMP: f64 = 20.0;
const LEAD: f64 = 40.0;

/// Longest step \[s\].
const STEP: f64 = 0.05;

/// Least and most segments: more change no tension by its error of time.
const SEGMENTS: (usize, usize) = (20, 200);

/// The rope in motion.
#[derive(Debug, Clone, PartialEq)]
pub struct RopeMotion {
    /// Made fast.
    pub made_fast: Result<MovingRope, RopewayError>,
    /// On the winch; absent: there is none.
    pub constant_tension: Option<Result<MovingRope, RopewayError>>,
}

/// The rope in motion, held in one way.
#[derive(Debug, Clone, PartialEq)]
pub struct MovingRope {
    /// Times in the ship's motion \[s\].
    pub times: Vec<f64>,
    /// Tension at the ship \[N\].
    pub ship_n: Vec<f64>,
    /// Mean, standard deviation, minimum and maximum of it \[N\], and the greatest speed of the rope over the winch \[m/s\].
    pub results: [f64; 5],
    /// Numerical errors of these by time steps, and by the mesh; absent where they are not estimated.
    pub errors: Option<[[f64; 5]; 2]>,
    /// What a reader should know of the run.
    pub warnings: Vec<String>,
    /// The same results of equilibria over the same time.
    pub quasi_static: [f64; 5],
}

/// The times of a run.
#[derive(Debug, Clone, Copy)]
struct Window {
    /// Time that passes before the ship's motion is that of the file \[s\].
    lead: f64,
    /// Time of the ship's motion \[s\].
    until: f64,
    /// Interval of the results \[s\].
    interval: f64,
}

impl SolvedRopeway {
    /// The rope in motion over the first 5 min at most of the motion of the ship in the file; absent: the ship lies still.
    #[must_use]
    pub fn rope_motion(&self) -> Option<RopeMotion> {
        let motion = self.ropeway.motion.as_ref()?;
        if motion.surge_m == 0.0 && motion.heave_m == 0.0 {
            return None;
        }
        let window = window(&self.ship_motion()?);
        let winch = self.ropeway.winch.is_some();
        Some(RopeMotion {
            made_fast: self.moving_rope(motion, window, None),
            constant_tension: winch.then(|| {
                let control = self.winch_control()?;
                self.moving_rope(motion, window, control)
            }),
        })
    }

    /// The rope on a winch or made fast, in motion and in equilibria.
    fn moving_rope(
        &self,
        motion: &HangPointMotion,
        window: Window,
        control: Option<WinchControl>,
    ) -> Result<MovingRope, RopewayError> {
        let start = self.equilibrium(self.ropeway.cargo.position)?;
        if start.carrier != Carrier::Rope {
            return Err(RopewayError::NotFound("the cargo hangs on a support"));
        }
        // A winch that is at its limits remembers the motion before.
        let series = window.series(motion);
        let samples = simulate(&self.rope, &start, control.as_ref(), &series)?;
        if samples.iter().any(|at| at.state == WinchState::RopeOut) {
            return Err(RopewayError::NotFound(
                "a winch that runs out of rope is not covered in motion",
            ));
        }
        // The winch has hauled its tension before the ship moves.
        let length = samples.first().map_or(start.length_m, |at| at.length_m);
        let rest = self.rope.with_cargo_at(length, start.arc_m)?;
        let run = rope_system::compute(self.system(motion, (&rest, control), window))?;
        let counts = |at: &&WinchSample| window.counts(at.ship.time_s);
        let equilibria: Vec<&WinchSample> = samples.iter().filter(counts).collect();
        let tensions: Vec<f64> = equilibria.iter().map(|at| at.ship_n).collect();
        let speeds = equilibria.iter().map(|at| at.speed_m_per_s.abs());
        let (times, ship_n) = tensions_of(&run.history, window)?;
        Ok(MovingRope {
            times,
            ship_n,
            results: results_of(&run.history, window)?,
            errors: errors(&run, window),
            warnings: run.warnings.clone(),
            quasi_static: results(&tensions, speeds.fold(0.0, f64::max)),
        })
    }

    /// The system: the ship's end moves, and on a winch the rope passes it.
    fn system(
        &self,
        motion: &HangPointMotion,
        (rest, control): (&RopeEquilibrium, Option<WinchControl>),
        window: Window,
    ) -> SystemFile {
        let (least, most) = SEGMENTS;
        let segments = self.ropeway.about.segments.clamp(least, most);
        let mut file = rope_system::at_rest(&self.ropeway, rest, segments);
        let periods = [
            motion.surge_period_s,
            motion.surge_period_s,
            motion.heave_period_s,
        ];
        let ship = [self.ropeway.about.span_m, 0.0, self.ropeway.ship.height_m];
        let mut moved = PointInputs::moved(ship, [motion.surge_m, 0.0, motion.heave_m], periods);
        moved.phase_deg = periods.map(|period| -360.0 * (window.lead / period).fract());
        moved.ramp_s = RAMP;
        file.points.insert(SHIP.to_owned(), moved);
        if let Some(control) = control {
            let by_power = control.power_w / control.tension_n;
            let fastest = control.speed_m_per_s.min(by_power);
            file.payouts = vec![PayoutInputs {
                greatest_rate_m_per_s: fastest.is_finite().then_some(fastest),
                // The files state no drum. One as heavy as the rope between the ends keeps the tension about as well as the rope
                // itself lets it; what a geared drive has in inertia is often more.
                drum_mass_kg: self.rope.weight_n_per_m / self.ropeway.about.gravity_m_per_s2
                    * rest.length_m,
                ..PayoutInputs::at_tension(LINES[1], WhichEnd::B, control.tension_n)
            }];
        }
        file.solver = Some(Solver {
            time_step_s: Some(STEP.min(window.interval)),
            ..Solver::over(window.lead + window.until)
        });
        file.output.interval_s = window.interval;
        file
    }
}

/// The times of a run of a motion of the ship, which is at equal intervals.
fn window(motion: &[ShipOffset]) -> Window {
    let last = motion.last().map_or(0.0, |at| at.time_s);
    let interval = last / motion.len().saturating_sub(1).max(1) as f64;
    let most = LONGEST.min(MOST_STEPS * STEP.min(interval));
    Window {
        lead: (LEAD / interval).ceil() * interval,
        until: last.min((most / interval).floor().max(2.0) * interval),
        interval,
    }
}

impl Window {
    /// Whether results count at a time of the run \[s\].
    fn counts(&self, time: f64) -> bool {
        time > self.lead - 0.5 * self.interval
    }

    /// Displacements of the ship as in the run, which grow.
    fn series(&self, motion: &HangPointMotion) -> Vec<ShipOffset> {
        let rows = ((self.lead + self.until) / self.interval).round() as usize;
        let at = |row: usize| {
            let time_s = self.interval * row as f64;
            let grown = smooth_ramp(time_s, RAMP).0;
            let ship = ship_motion::at(motion, time_s - self.lead);
            ShipOffset {
                time_s,
                x_m: grown * ship.x_m,
                z_m: grown * ship.z_m,
            }
        };
        (0..=rows).map(at).collect()
    }
}

/// Mean, standard deviation, minimum and maximum of tensions \[N\], and a speed \[m/s\].
fn results(tensions: &[f64], speed: f64) -> [f64; 5] {
    let Statistics {
        mean,
        deviation,
        min,
        max,
        ..
    } = Statistics::of_values(tensions);
    [mean, deviation, min, max, speed]
}

/// Times in the ship's motion \[s\] and values of a channel, from where the motion is that of the file.
fn counted(
    history: &History,
    channel: &str,
    window: Window,
) -> Result<(Vec<f64>, Vec<f64>), RopewayError> {
    let values = rope_system::values(history, channel)?;
    let rows = history.time.iter().zip(values);
    let rows = rows.filter(|(time, _)| window.counts(**time));
    Ok(rows
        .map(|(time, value)| (time - window.lead, value))
        .unzip())
}

fn tensions_of(history: &History, window: Window) -> Result<(Vec<f64>, Vec<f64>), RopewayError> {
    counted(history, SHIP_TENSION, window)
}

fn results_of(history: &History, window: Window) -> Result<[f64; 5], RopewayError> {
    let (_, tensions) = tensions_of(history, window)?;
    // Made fast the line has no length that changes.
    let (times, lengths) =
        counted(history, &format!("length_m[{}]", LINES[1]), window).unwrap_or_default();
    let pairs = times.windows(2).zip(lengths.windows(2));
    let speeds = pairs.map(|(time, length)| ((length[1] - length[0]) / (time[1] - time[0])).abs());
    Ok(results(&tensions, speeds.fold(0.0, f64::max)))
}

/// Numerical errors of the results, by companions with longer steps and with longer segments.
fn errors(run: &MotionRun, window: Window) -> Option<[[f64; 5]; 2]> {
    let [time, mesh] = run.companions.as_slice() else {
        return None;
    };
    let from = |pair: &HistoryPair| {
        let mut errors = [0.0; 5];
        for (k, error) in errors.iter_mut().enumerate() {
            *error = pair.error(|history| Some(results_of(history, window).ok()?[k]))?;
        }
        Some(errors)
    };
    Some([from(time)?, from(mesh)?])
}
