//! The state of a system at rest, before it is let go.

use super::{
    super::{
        balance::{UnsolvedLine, line_at_rest, without_rest},
        equilibrium::SystemError,
        freedoms::Placement,
        line_at_rest::LineAtRest,
        line_physics::LinePhysics,
        network::{Held, Line, Network},
        rest::{UnsolvedSystem, refused as refused_at_rest},
    },
    flow_load::FlowLoad,
    joints::Role,
    moving_system::MovingSystem,
    surplus::Surplus,
    system_state::SystemState,
    velocity_history::VelocityHistory,
};
use crate::{
    numerics::V3,
    physics::sea::WaterMotion,
    solve::{Parted, State},
};
use nalgebra::UnitQuaternion;

/// The lines at rest between points at these places, without what they would be solved again by: of many lines that is most of the memory.
pub(super) fn lines_at_rest(
    network: &Network,
    placement: &Placement,
) -> Result<Vec<LineAtRest>, UnsolvedSystem> {
    let at_rest = |index| {
        let line = line_at_rest(network, placement, index, LinePhysics::Full, None);
        let mut line =
            line.or_else(|unsolved| without_rest(network, placement, index).ok_or(unsolved))?;
        if let Some(divided) = &mut line.discretised {
            divided.free_work();
        }
        Ok(line)
    };
    let lines = (0..network.lines.len()).map(at_rest);
    let lines: Result<_, UnsolvedLine> = lines.collect();
    lines.map_err(|unsolved| refused_at_rest(network, &SystemError::Line(unsolved)))
}

/// Puts what is held where the network has it.
pub(super) fn carried(network: &Network, placement: &mut Placement) {
    for (point, place) in network.points.iter().zip(&mut placement.points) {
        if let Held::At(at) = &point.held {
            *place = *at;
        }
    }
    for (body, pose) in network.bodies.iter().zip(&mut placement.bodies) {
        if !body.free && body.carrier.is_none() {
            pose.origin = body.pose.origin;
        }
        if !body.turns() {
            pose.rotation = body.pose.rotation;
        }
    }
    placement.carry(network);
}

/// Unstretched length of the longest line, a metre at least \[m\].
pub(super) fn longest(network: &Network) -> f64 {
    network.lines.iter().map(Line::length).fold(1.0, f64::max)
}

/// The system and its state there.
pub(super) fn at_rest(
    network: Network,
    placement: &Placement,
    lines: &[LineAtRest],
) -> (MovingSystem, SystemState) {
    let found = lines.iter().filter_map(|line| line.discretised.as_ref());
    let (scenes, lines): (Vec<_>, Vec<_>) = found
        .map(|line| {
            let (scene, state) = line.scene_and_state();
            let mut state = state.clone();
            state.extrapolated_tension.clear();
            (scene.clone(), state)
        })
        .unzip();
    let system = MovingSystem::new(network, scenes);
    let joints = &system.joints;
    let mut point_of = vec![None; joints.roles.len()];
    for (point, joint) in joints.points.iter().enumerate().rev() {
        point_of[*joint] = Some(point);
    }
    let place = |(joint, role): (usize, &Role)| match role {
        Role::Origin(body) => placement.bodies[*body].origin,
        Role::Rotation(_) | Role::Released(..) | Role::Payout(_) => V3::zeros(),
        _ => point_of[joint].map_or_else(V3::zeros, |point| placement.points[point]),
    };
    let places: Vec<V3> = joints.roles.iter().enumerate().map(place).collect();
    let bases = placement.bodies.iter().map(|pose| pose.rotation);
    let state = state_of(&system, (places, bases.collect()), lines);
    (system, state)
}

/// The state of a system without motion: its joints at these places, its bodies in these rotations, its lines.
pub(super) fn state_of(
    system: &MovingSystem,
    (places, bases): (Vec<V3>, Vec<UnitQuaternion<f64>>),
    lines: Vec<State>,
) -> SystemState {
    let ends = |line: &Line| [line.from, line.to].map(|point| system.joints.points[point]);
    let stations = system.stations.last().map_or(0, |range| range.end);
    SystemState {
        body_flow: vec![WaterMotion::default(); stations],
        flow_loads: vec![FlowLoad::default(); system.flows.len()],
        velocities: vec![VelocityHistory::default(); system.flows.len()],
        lines,
        joints: State::at_rest(places),
        bases,
        attached: system.network.lines.iter().map(ends).collect(),
        kinks_passed_s: 0.0,
        paid: system
            .paid
            .iter()
            .map(|paid| system.scenes[paid.line].clone())
            .collect(),
        added: vec![[0; 2]; system.paid.len()],
        surplus: vec![[Surplus::default(); 2]; system.paid.len()],
        drive_excess: vec![0.0; system.payouts.len()],
    }
}

/// Takes all velocities and accelerations out.
pub(super) fn still(state: &mut SystemState) {
    for part in state.parts_mut() {
        part.v.fill(V3::zeros());
        part.a.fill(V3::zeros());
    }
}
