//! The state of a run in time after an accepted step, complete enough to be resumed to the same bits.

use serde::{Deserialize, Serialize};

use super::march::Marching;
use super::system_state::SystemState;
use crate::dynamics::{Integrator, MarchProgress, MethodState};
use crate::run::recorder_state::RecorderState;
use crate::run::{Profile, Resumed};
use crate::solve::Parted;

/// The state of a run in time after an accepted step. Written as `checkpoint.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SystemCheckpoint {
    /// What happened to the lines so far, in words.
    pub happened: Vec<String>,
    /// Position of the march.
    pub place: MarchProgress,
    /// The method.
    pub method: MethodState,
    /// What is recorded so far.
    pub recorded: RecorderState,
    /// The lines, points and bodies.
    pub state: SystemState,
}

/// A stored run of a system to be resumed.
pub type ResumedSystem = Resumed<SystemCheckpoint>;

/// Segments that a line is paid out by at most.
const MOST_ADDED: i64 = 1_000_000;

impl SystemCheckpoint {
    /// Time of the state \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.recorded.time().unwrap_or(self.place.time)
    }

    /// The state of a march.
    pub(super) fn of(march: &Marching<'_>) -> Self {
        Self {
            happened: march.happened.clone(),
            place: march.place,
            method: march.method.method_state(),
            recorded: march.recorder.state(),
            state: march.state.clone(),
        }
    }

    /// Checks that lines are paid out in it as in this system: their number, and segments that a line may have.
    pub(super) fn check_added(&self, state: &SystemState) -> Result<(), String> {
        let added = self.state.added.iter().flatten();
        let agrees = self.state.added.len() == state.added.len()
            && self.state.lines.len() == state.lines.len()
            && added.clone().all(|added| added.abs() < MOST_ADDED)
            && added.sum::<i64>() == self.state.nodes() - state.nodes();
        agrees
            .then_some(())
            .ok_or_else(|| "its checkpoint.toml does not belong to this system".to_owned())
    }

    /// Checks that it is one of this system: sizes agree, and lines end at joints that it has.
    pub(super) fn check(
        &self,
        state: &SystemState,
        channels: usize,
        profiles: &[Profile],
    ) -> Result<(), String> {
        self.recorded.check(channels, profiles)?;
        let sizes = |state: &SystemState| -> Vec<usize> {
            let parts = state
                .parts()
                .flat_map(|p| [p.x.len(), p.v.len(), p.a.len()]);
            parts
                .chain([state.bases.len(), state.attached.len()])
                .collect()
        };
        let nodes: Vec<usize> = state.parts().map(|part| part.x.len()).collect();
        let mut attached = self.state.attached.iter().flatten();
        let agrees = sizes(&self.state) == sizes(state)
            && self.method.fits(&nodes)
            && self.state.velocities.len() == state.velocities.len()
            && self.state.drive_excess.len() == state.drive_excess.len()
            && attached.all(|joint| *joint < state.joints.x.len())
            && self.place.is_possible();
        agrees
            .then_some(())
            .ok_or_else(|| "its checkpoint.toml does not belong to this system".to_owned())
    }
}
