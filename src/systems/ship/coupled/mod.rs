//! Coupled analysis of a ship and its anchor line in the time domain, eqs (4) and (5) of the ropeway paper: a system of a free
//! body and a line ([`model`]), both in one Newton iteration, in axes along the equilibrium heading.
//!
//! Time and mesh errors are estimated separately by Richardson extrapolation of second order, from a run with half the step
//! (4/3 of the difference to the run with the whole step) and one with half the segments (1/3 of the difference to the run with
//! all).

mod error;
pub mod free_decay;
pub mod model;
mod time_domain;

use std::sync::atomic::{AtomicBool, Ordering};

pub use self::error::CoupledError;
use self::free_decay::FreeDecay;
use self::model::CoupledModel;
pub use self::time_domain::{CHANNELS, CoupledWork};
use self::time_domain::{TimeHistory, integrate};
use super::model::CoupledSettings;
use super::motion::rigid_displacement;
use super::motion_analysis::MotionAnalysis;
use super::static_analysis::StaticAnalysis;
use crate::numerics::V3;
use crate::numerics::statistics::{Statistics, rms_difference};

/// A ship and its anchor line in the time domain.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledAnalysis {
    /// The settings of the analysis.
    pub settings: CoupledSettings,
    /// Each channel at every step, from t = 0.
    pub records: Vec<Vec<f64>>,
    /// Step of the records \[s\].
    pub step: f64,
    /// Statistics of each channel, from `from_s` on.
    pub statistics: Vec<Statistics>,
    /// Root mean square time error of each channel, from `from_s` on; absent where the run with half the step failed.
    pub time_errors: Option<Vec<f64>>,
    /// Root mean square mesh error, likewise.
    pub mesh_errors: Option<Vec<f64>>,
    /// Work of the run, without those for the errors.
    pub work: CoupledWork,
    /// Free decay against the linearised equations.
    pub decay: Result<FreeDecay, String>,
    /// Whether wave loads act.
    pub waves: bool,
}

impl CoupledAnalysis {
    /// Runs the analysis with its error estimates and the free decay.
    ///
    /// # Errors
    /// [`CoupledError`].
    pub fn new(
        statics: &StaticAnalysis,
        motion: Option<&MotionAnalysis>,
        stop: &AtomicBool,
    ) -> Result<Self, CoupledError> {
        let model = CoupledModel::of_statics(statics)?;
        let settings = model.settings;
        let waves = statics.ship.motion.as_ref();
        let waves = waves.zip(motion.and_then(MotionAnalysis::response));
        let hang_off = model.hang_off();
        let run = |segments: usize, step_s: f64| {
            let file = model.system(&model.variant(segments, step_s), waves);
            integrate(file, &hang_off, stop)
        };
        let (segments, step) = (settings.segments, settings.step_s);
        let whole = run(segments, step)?;
        let (fine, coarse) = rayon::join(|| run(segments, 0.5 * step), || run(segments / 2, step));
        let decay = FreeDecay::new(&model, stop).map_err(|error| error.to_string());
        if stop.load(Ordering::Relaxed) {
            return Err(CoupledError::Stopped);
        }
        let from = first_counted(settings, settings.step_s);
        let statistics = whole.records.iter();
        Ok(Self {
            settings: settings.clone(),
            step: settings.step_s,
            statistics: statistics
                .map(|record| Statistics::of_values(counted(record, from)))
                .collect(),
            time_errors: errors(&whole, fine, from, 4.0 / 3.0),
            mesh_errors: errors(&whole, coarse, from, 1.0 / 3.0),
            work: whole.work,
            waves: waves.is_some(),
            records: whole.records,
            decay,
        })
    }

    /// Displacements of a point at `arm` \[m\] in ship axes, from the beginning of the statistics.
    #[must_use]
    pub fn point_displacements(&self, arm: &V3) -> Vec<V3> {
        let from = first_counted(&self.settings, self.step);
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

/// First instant of the statistics.
fn first_counted(settings: &CoupledSettings, step: f64) -> usize {
    (settings.from_s / step).round() as usize
}

fn counted(record: &[f64], from: usize) -> &[f64] {
    record.get(from..).unwrap_or(&[])
}

/// A factor times the root mean square difference of two runs, of each channel; none where the other failed.
fn errors(
    run: &TimeHistory,
    other: Result<TimeHistory, CoupledError>,
    from: usize,
    factor: f64,
) -> Option<Vec<f64>> {
    let other = other.ok()?;
    let pairs = run.records.iter().zip(&other.records);
    let error = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        factor * rms_difference(counted(a, from), counted(b, from))
    };
    Some(pairs.map(error).collect())
}
