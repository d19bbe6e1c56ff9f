//! A system computed in time, with the numerical errors of its results.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

pub use super::channel_result::{ChannelResult, RunChannelSummary};
use super::system_in_time::{SystemInTime, check_steps};
use crate::case::Solver;
use crate::run::along::FatigueSpot;
use crate::run::computation::Computation;
use crate::run::compute::Computed;
use crate::run::energy_balance::EnergyBalance;
use crate::run::error_estimate::{ErrorEstimates, HistoryPair};
use crate::run::event::JobEvent;
use crate::run::job::with_estimates;
use crate::run::{Cost, History, LineShape, Profile, Quantity, RunState, Settings, Work};
use crate::system::SolvedSystem;
use crate::system::rest::UnsolvedSystem;

/// A computed run.
#[derive(Debug, Clone)]
pub struct MotionRun {
    /// Settings that it used, with how its errors were estimated.
    pub settings: Settings,
    /// Statistics of the channels, with errors, in the order of the history.
    pub channels: Vec<ChannelResult>,
    /// All single numbers with their errors: of channels, along the lines, of the energy.
    pub summary: Vec<Quantity>,
    /// The channels at the output times; of a long run some of them.
    pub history: History,
    /// The pairs of companions by which errors of curves are told: in time, and of the mesh.
    pub companions: Vec<HistoryPair>,
    /// Work done.
    pub work: Work,
    /// Time that it came to \[s\].
    pub reached: f64,
    /// The time that it took.
    pub cost: Cost,
    /// Shapes of the lines at chosen instants.
    pub shapes: Vec<LineShape>,
    /// The lines node by node, at the end and with their envelopes.
    pub profiles: Vec<Profile>,
    /// The damage along the lines, where checks count it.
    pub fatigue: Vec<FatigueSpot>,
    /// The energy balance.
    pub balance: EnergyBalance,
    /// What happened to the lines, in words.
    pub happened: Vec<String>,
    /// How it ended.
    pub state: RunState,
    /// Why it failed, if it did.
    pub failure: Option<String>,
    /// What a reader should know.
    pub warnings: Vec<String>,
}

/// The run of a computation, with the errors of its results.
fn with_errors(found: Computed, errors: ErrorEstimates) -> MotionRun {
    let record = found.record;
    MotionRun {
        settings: found.settings,
        channels: ChannelResult::all(&record.history.channels, &errors.summary),
        summary: errors.summary,
        companions: errors.curves,
        balance: record.balance.unwrap_or_default(),
        fatigue: record.fatigue,
        history: record.history,
        shapes: record.shapes,
        profiles: record.profiles,
        work: found.outcome.work,
        reached: found.outcome.reached,
        cost: found.cost,
        happened: found.happened,
        state: found.outcome.state,
        failure: found.outcome.failure,
        warnings: found.warnings,
    }
}

/// Computes a system in time, with companions that tell its errors, and sends the rows of its history.
///
/// # Errors
/// Where the divided lines do not come to rest. A run that fails later says so in [`MotionRun::failure`].
pub fn run(
    solved: &SolvedSystem,
    given: &Solver,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Result<MotionRun, UnsolvedSystem> {
    let system = SystemInTime::new(Arc::new(solved.clone()), given.clone());
    system.begun()?;
    let chosen = system.with_chosen_method(None, cancel);
    let (system, why) = chosen.unwrap_or((system, None));
    let begun = system.begun()?;
    check_steps(&system.plan(begun).settings)?;
    let mut computed = system.compute(None, cancel, Some(&mut *events));
    computed.settings.method_reason = why;
    let (computed, errors) = with_estimates(&system, computed, None, cancel, events);
    Ok(with_errors(computed, errors))
}
