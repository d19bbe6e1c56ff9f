//! The ship of a file and its anchor line in time, eqs (4) and (5) of the ropeway paper: a rigid body at the end of a line of
//! the dynamic solver, both in one Newton ([`moored_ship`]), in axes along the heading at which the ship rests.
//!
//! Time error and mesh error are told apart by companions, one with half the step and one with half the segments, after
//! Richardson for a method of order two: of the record with the whole step 4/3 of the difference, of that with all
//! segments 1/3.

pub mod forcing;
pub mod free_decay;
pub mod model;
pub mod moored_ship;

use std::sync::atomic::{AtomicBool, Ordering};

use self::forcing::{Forcing, wave_loads};
use self::free_decay::{FreeDecay, decay};
use self::model::CoupledModel;
use self::moored_ship::{MooredShip, MooredShipError};
use crate::dynamics::generalized_alpha::GeneralizedAlpha;
use crate::dynamics::{Integrator, March, MarchError};
use crate::numerics::V3;
use crate::numerics::statistics::Statistics;
use crate::ship::model::CoupledSettings;
use crate::ship::motion::rigid_displacement;
use crate::ship::motion_analysis::MotionAnalysis;
use crate::ship::static_analysis::StaticAnalysis;
use crate::solve::{ExplicitRhs, Instant, Kinematics, Progressing, State};

/// Damping of the method at the highest frequencies: enough for a line that snaps taut.
const RHO: f64 = 0.4;

/// Tolerance of positions \[-\] and iterations of a step.
const NEWTON: (f64, usize) = (1e-10, 30);

/// What is recorded, with its unit.
pub const CHANNELS: [(&str, &str); 11] = [
    ("surge", "m"),
    ("sway", "m"),
    ("heave", "m"),
    ("roll", "deg"),
    ("pitch", "deg"),
    ("yaw", "deg"),
    ("hang point ahead", "m"),
    ("hang point to port", "m"),
    ("hang point up", "m"),
    ("line at the ship", "N"),
    ("line at the anchor", "N"),
];

/// A ship and its anchor line in time.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledAnalysis {
    /// The words that it was computed by.
    pub settings: CoupledSettings,
    /// Each channel at every step, from t = 0.
    pub records: Vec<Vec<f64>>,
    /// Time between two of a record \[s\].
    pub step: f64,
    /// Statistics of each channel, from `from_s` on.
    pub statistics: Vec<Statistics>,
    /// Root mean square error of each record by the step, from `from_s` on; absent where the companion gave up.
    pub time_errors: Option<Vec<f64>>,
    /// The same by the mesh.
    pub mesh_errors: Option<Vec<f64>>,
    /// Work of the run itself.
    pub work: Work,
    /// The ship let go from a displacement, against the linearised equations.
    pub decay: Result<FreeDecay, String>,
    /// Whether waves act.
    pub waves: bool,
}

/// Machine-independent work of a march.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Steps taken.
    pub steps: u64,
    /// Steps halved.
    pub halved: u64,
    /// Newton iterations.
    pub iterations: u64,
}

/// Why there is no such run.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CoupledError {
    /// The file lacks what it needs.
    #[error("{0}")]
    Missing(&'static str),
    /// The line is none.
    #[error("the anchor line cannot be built: {0}")]
    Line(String),
    /// The line does not hold a ship.
    #[error(transparent)]
    MooredShip(#[from] MooredShipError),
    /// The march gave up.
    #[error("the march gave up {0}")]
    March(#[from] MarchError),
    /// Somebody asked for it to stop.
    #[error("it was stopped")]
    Stopped,
}

/// A march's records with its work.
struct Marched {
    records: Vec<Vec<f64>>,
    work: Work,
}

impl CoupledAnalysis {
    /// Follows ship and line, with the companions that tell the errors, and the free decay.
    ///
    /// # Errors
    /// [`CoupledError`].
    pub fn new(
        statics: &StaticAnalysis,
        motion: Option<&MotionAnalysis>,
        stop: &AtomicBool,
    ) -> Result<Self, CoupledError> {
        let setting = CoupledModel::of(statics)?;
        let settings = setting.settings;
        let hull = statics.hull.as_ref();
        let hull = hull.ok_or(CoupledError::Missing("the file has no [hull]"))?;
        let waves = motion.and_then(|motion| {
            let loads = |answer| wave_loads(hull, answer, &motion.motions.sea);
            motion.answer().map(loads)
        });
        let forcing = Forcing {
            waves: waves.unwrap_or_default(),
            ramp: settings.ramp_s,
            ..setting.flows()
        };
        let run = |segments: usize, halvings: u32| {
            let hang = statics
                .ship
                .motion
                .as_ref()
                .map_or([0.0; 3], |m| m.hang_point_m);
            march(
                &setting,
                &forcing,
                segments,
                halvings,
                &V3::from(hang),
                stop,
            )
        };
        let whole = run(settings.segments, 0)?;
        let (fine, coarse) = rayon::join(
            || run(settings.segments, 1),
            || run(settings.segments / 2, 0),
        );
        let from = (settings.from_s / settings.step_s).round() as usize;
        let counted = |record: &Vec<f64>| record.get(from..).unwrap_or(&[]).to_vec();
        let errors = |other: Result<Marched, CoupledError>, share: f64| {
            let other = other.ok()?;
            let pairs = whole.records.iter().zip(&other.records);
            Some(
                pairs
                    .map(|(a, b)| share * apart(&counted(a), &counted(b)))
                    .collect(),
            )
        };
        let decay = decay(&setting).map_err(|error| error.to_string());
        if stop.load(Ordering::Relaxed) {
            return Err(CoupledError::Stopped);
        }
        Ok(Self {
            settings: settings.clone(),
            step: settings.step_s,
            statistics: whole
                .records
                .iter()
                .map(|record| Statistics::of(&counted(record)))
                .collect(),
            time_errors: errors(fine, 4.0 / 3.0),
            mesh_errors: errors(coarse, 1.0 / 3.0),
            work: whole.work,
            waves: !forcing.waves.is_empty(),
            records: whole.records,
            decay,
        })
    }

    /// Displacements of a point at `arm` \[m\] in the axes of the ship, from where statistics begin.
    #[must_use]
    pub fn point_displacements(&self, arm: &V3) -> Vec<V3> {
        let from = (self.settings.from_s / self.step).round() as usize;
        let count = self.records.first().map_or(0, Vec::len);
        let at = |i: usize| {
            let q = std::array::from_fn(|degree| {
                let value = self.records[degree][i];
                if degree < 3 {
                    value
                } else {
                    value.to_radians()
                }
            });
            rigid_displacement(q, arm)
        };
        (from.min(count)..count).map(at).collect()
    }
}

/// Root mean square difference.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let squares: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (squares / a.len().max(1) as f64).sqrt()
}

fn march(
    setting: &CoupledModel<'_>,
    forcing: &Forcing,
    segments: usize,
    halvings: u32,
    hang: &V3,
    stop: &AtomicBool,
) -> Result<Marched, CoupledError> {
    let settings = setting.settings;
    let (moored, line) = setting.system(segments, forcing.clone())?;
    let yaw = settings.start_yaw_deg.to_radians();
    let mut state = moored.turned(&line, V3::z() * yaw);
    moored.accelerate(0.0, &mut state);
    let mut method = GeneralizedAlpha::new(moored.nodes(), RHO, NEWTON.0, NEWTON.1);
    let march = March {
        duration: settings.duration_s,
        step: settings.step_s / f64::from(1_u32 << halvings),
        output: settings.step_s,
    };
    let instants = (settings.duration_s / settings.step_s).round() as usize + 1;
    let mut records = vec![Vec::with_capacity(instants); CHANNELS.len()];
    let outcome = march.run(&mut method, &moored, &mut state, &mut |instant: Instant<
        '_,
    >| {
        if instant.output {
            for (record, value) in records
                .iter_mut()
                .zip(channels(&moored, instant.state, hang))
            {
                record.push(value);
            }
        }
        if stop.load(Ordering::Relaxed) {
            Progressing::Stop
        } else {
            Progressing::Continue
        }
    })?;
    if outcome.stopped {
        return Err(CoupledError::Stopped);
    }
    Ok(Marched {
        records,
        work: Work {
            steps: outcome.steps,
            halved: outcome.rejections,
            iterations: method.work_counts().iterations,
        },
    })
}

/// The values of [`CHANNELS`] in a state.
fn channels(moored: &MooredShip, state: &State, hang: &V3) -> [f64; CHANNELS.len()] {
    let q = moored.motion(state);
    let point = rigid_displacement(std::array::from_fn(|i| q[i]), hang);
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
        moored.tension(state),
        moored.anchor_tension(state),
    ]
}
