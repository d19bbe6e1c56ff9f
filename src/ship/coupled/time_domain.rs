//! Time integration of ship and anchor line, and what is recorded of it.

use std::sync::atomic::{AtomicBool, Ordering};

use super::CoupledError;
use super::forcing::Forcing;
use super::model::CoupledModel;
use super::moored_ship::MooredShip;
use crate::dynamics::generalized_alpha::GeneralizedAlpha;
use crate::dynamics::{Integrator, March};
use crate::numerics::V3;
use crate::ship::motion::rigid_displacement;
use crate::solve::{AcceptedStep, ExplicitRhs, Kinematics, Progressing, State};

/// Spectral radius at infinite frequency: damping enough for a line that snaps taut.
const RHO_INF: f64 = 0.4;

/// Relative tolerance of positions and maximum iterations of a step.
const NEWTON: (f64, usize) = (1e-10, 30);

/// Names and units of the channels.
pub const CHANNELS: [(&str, &str); 11] = [
    ("surge", "m"),
    ("sway", "m"),
    ("heave", "m"),
    ("roll", "deg"),
    ("pitch", "deg"),
    ("yaw", "deg"),
    ("hang-off surge", "m"),
    ("hang-off sway", "m"),
    ("hang-off heave", "m"),
    ("line at the ship", "N"),
    ("line at the anchor", "N"),
];

/// Work of a time integration, independent of the machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct CoupledWork {
    /// Steps.
    pub steps: u64,
    /// Steps halved.
    pub halved: u64,
    /// Newton iterations.
    pub iterations: u64,
}

/// Records of all channels with the work of the integration.
pub(super) struct TimeHistory {
    pub(super) records: Vec<Vec<f64>>,
    pub(super) work: CoupledWork,
}

/// Integrates with so many segments and the time step halved so often, at the output times of the whole step.
pub(super) fn integrate(
    model: &CoupledModel<'_>,
    forcing: &Forcing,
    (segments, halvings): (usize, u32),
    stop: &AtomicBool,
) -> Result<TimeHistory, CoupledError> {
    let settings = model.settings;
    let (ship, line) = model.system(segments, forcing.clone())?;
    let yaw = settings.start_yaw_deg.to_radians();
    let mut state = ship.rotated(&line, V3::z() * yaw);
    ship.accelerate(0.0, &mut state);
    let mut method = GeneralizedAlpha::new(ship.nodes(), RHO_INF, NEWTON.0, NEWTON.1);
    let intervals = (settings.duration_s / settings.step_s).round().max(1.0);
    let interval_steps = 1_u32 << halvings;
    let march = March {
        duration: settings.duration_s,
        step: settings.duration_s / intervals / f64::from(interval_steps),
    };
    let mut records = vec![Vec::with_capacity(intervals as usize + 1); CHANNELS.len()];
    let mut whole_steps = 0_u32;
    let hang_off = model.hang_off();
    let mut record = |instant: AcceptedStep<'_>| {
        let recorded = instant.whole && whole_steps.is_multiple_of(interval_steps);
        whole_steps += u32::from(instant.whole);
        if recorded {
            let values = channels(&ship, instant.state, &hang_off);
            for (record, value) in records.iter_mut().zip(values) {
                record.push(value);
            }
        }
        if stop.load(Ordering::Relaxed) {
            Progressing::Stop
        } else {
            Progressing::Continue
        }
    };
    let outcome = march.run(&mut method, &ship, &mut state, &mut record)?;
    if outcome.stopped {
        return Err(CoupledError::Stopped);
    }
    Ok(TimeHistory {
        records,
        work: CoupledWork {
            steps: outcome.steps,
            halved: outcome.rejections,
            iterations: method.work_counts().iterations,
        },
    })
}

/// The values of [`CHANNELS`] in a state.
fn channels(ship: &MooredShip, state: &State, hang_off: &V3) -> [f64; CHANNELS.len()] {
    let q = ship.motion(state);
    let point = rigid_displacement(std::array::from_fn(|i| q[i]), hang_off);
    [
        q[0],
        q[1],
        q[2],
        q[3].to_degrees(),
        q[4].to_degrees(),
        q[5].to_degrees(),
        point.x,
        point.y,
        point.z,
        ship.tension(state),
        ship.anchor_tension(state),
    ]
}
