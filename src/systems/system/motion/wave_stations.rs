//! Where the waves are read for the bodies of a system: once a step, at the origin of each body and along its members.

use super::body_flow;
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::physics::sea::{SeaReader, WaterMotion};
use crate::system::members::{self, STATIONS};

impl MovingSystem {
    /// Writes the wave kinematics at time t \[s\] into a state; those of lines are extrapolated from a state in which they were written a time \[s\]
    /// before, where one is given.
    pub(super) fn write_wave_kinematics(
        &self,
        t: f64,
        before: Option<(f64, &SystemState)>,
        state: &mut SystemState,
    ) {
        if let Some(sea) = &self.water {
            let mut kept = std::mem::take(&mut state.joints.kept_waves);
            kept.clock.move_to(sea, t);
            let SystemState { lines, paid, .. } = &mut *state;
            for (number, line) in lines.iter_mut().enumerate() {
                let scene = self.scene_among(number, paid);
                let before = before.map(|(time, state)| (time, &state.lines[number]));
                scene.write_wave_kinematics_by(&kept.clock, before, line);
            }
            let reader = SeaReader::Again(sea, &kept.clock, &mut kept.places);
            read(self, reader, state);
            state.joints.kept_waves = kept;
        }
        body_flow::prepare(self, t, state);
    }
}

/// Reads the waves at the joints and at the stations of the bodies.
pub(super) fn read(system: &MovingSystem, mut sea: SeaReader<'_>, state: &mut SystemState) {
    let joints = &mut state.joints;
    joints
        .wave_flow
        .resize(joints.x.len(), WaterMotion::default());
    let roles = &system.joints.roles;
    let points = system.joints.free.clone();
    let points = points.filter(|joint| matches!(roles[*joint], Role::Free(_) | Role::Released(..)));
    for joint in points {
        joints.wave_flow[joint] = sea.flow(joint, &joints.x[joint], true);
    }
    for (number, range) in system.stations.iter().enumerate() {
        if range.is_empty() {
            continue;
        }
        let pose = state.body(&system.joints, number).pose;
        let flows = &mut state.body_flow[range.clone()];
        let first = state.joints.x.len() + range.start;
        let body = &system.network.bodies[number];
        let members = &body.members;
        flows[0] = sea.flow(first, &(pose.origin + pose.arm(&body.station())), true);
        let along = flows.len() - body.strips_in_waves();
        for (number, (place, _)) in (along..flows.len()).zip(body.drag_strips()) {
            let place = pose.origin + pose.arm(&place);
            flows[number] = sea.flow(first + number, &place, false);
        }
        let stations = (first + 1..).step_by(STATIONS);
        let flows = flows[1..].chunks_exact_mut(STATIONS);
        for ((member, flows), first) in members.iter().zip(flows).zip(stations) {
            members::read_waves(member, &pose, (&mut sea, first), flows);
        }
    }
}
