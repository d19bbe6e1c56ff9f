//! The state of a run of a system in time after an accepted step: whether it belongs to a system.

use super::system_state::SystemState;
use crate::run::{Checkpoint, Profile, Resumed};
use crate::solve::Parted;

/// The state of a run of a system in time after an accepted step.
pub type SystemCheckpoint = Checkpoint<SystemState>;

/// A stored run of a system to be resumed.
pub type ResumedSystem = Resumed<SystemState>;

/// Segments that a line is paid out by at most.
const MOST_ADDED: i64 = 1_000_000;

/// Why it does not belong to a system.
const OTHER_SIZES: &str = "it has other lines, points or bodies";

/// Checks that lines are paid out in a checkpoint as in this system: their number, and segments that a line may have.
pub(super) fn check_added(from: &SystemCheckpoint, state: &SystemState) -> Result<(), String> {
    let stored = &from.state;
    let added = stored.added.iter().flatten();
    let agrees = stored.added.len() == state.added.len()
        && stored.lines.len() == state.lines.len()
        && added.clone().all(|added| added.abs() < MOST_ADDED)
        && added.sum::<i64>() == stored.nodes() - state.nodes();
    agrees.then_some(()).ok_or_else(|| OTHER_SIZES.to_owned())
}

/// Checks that a checkpoint is one of this system: sizes agree, and lines end at joints that it has.
pub(super) fn check(
    from: &SystemCheckpoint,
    state: &SystemState,
    channels: usize,
    profiles: &[Profile],
) -> Result<(), String> {
    from.recorded.check(channels, profiles)?;
    let sizes = |state: &SystemState| -> Vec<usize> {
        let parts = state
            .parts()
            .flat_map(|p| [p.x.len(), p.v.len(), p.a.len()]);
        parts
            .chain([state.bases.len(), state.attached.len()])
            .collect()
    };
    let nodes: Vec<usize> = state.parts().map(|part| part.x.len()).collect();
    let stored = &from.state;
    let mut attached = stored.attached.iter().flatten();
    let agrees = sizes(stored) == sizes(state)
        && from.method.fits(&nodes)
        && stored.velocities.len() == state.velocities.len()
        && stored.drive_excess.len() == state.drive_excess.len()
        && attached.all(|joint| *joint < state.joints.x.len())
        && from.place.is_possible();
    agrees.then_some(()).ok_or_else(|| OTHER_SIZES.to_owned())
}
