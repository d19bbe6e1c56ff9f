//! The mean position: at rest under current, wind and the mean drift of the waves, with what is moved in the middle of its motion.

use nalgebra::Vector6;

use crate::numerics::V3;
use crate::solve::{Marched, NewtonError, Parted};
use crate::system::motion::pose_motion::BodyMotion;
use crate::system::motion::start::{Start, settle};
use crate::system::motion::system_state::SystemState;
use crate::system::pose::Pose;
use crate::system::potential_flow::wave_loads::WaveLoads;

/// The state in the mean position, without velocities, from that in which a run in time starts.
///
/// # Errors
/// Where it does not come to rest: the node.
pub(super) fn mean_position(start: &Start) -> Result<SystemState, NewtonError> {
    let Start { system, state, .. } = start;
    let mut mean = state.clone();
    for (joint, place) in system.joints.points.iter().zip(&system.network.points) {
        if let Some(motion) = &place.motion {
            mean.joints.x[*joint] = motion.position;
        }
    }
    for (number, body) in system.network.bodies.iter().enumerate() {
        let Some(motion) = body.motion.as_ref().filter(|_| !body.free && !body.pinned) else {
            continue;
        };
        let angles = motion.angles.position;
        let motion = BodyMotion {
            pose: Pose::new(motion.place.position, angles.x, angles.y, angles.z),
            ..BodyMotion::default()
        };
        mean.set_body(&system.joints, number, &motion);
    }
    for part in mean.parts_mut() {
        part.v.fill(V3::zeros());
        part.a.fill(V3::zeros());
    }
    for (flow, load) in system.flows.iter().zip(&mut mean.flow_loads) {
        let waves = flow.waves.as_ref();
        load.waves = waves.map_or_else(Vector6::zeros, WaveLoads::mean_drift);
    }
    system.follow_prescribed(&mut mean);
    system.follow(&mut mean);
    settle(system, &mut mean)?;
    mean.joints.memory.grips = system.anchors(&mean.joints);
    system.commit(0.0, 0.0, &mut mean);
    Ok(mean)
}
