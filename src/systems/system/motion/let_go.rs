//! What begins a run in time off its equilibrium: held where the file puts it while everything else comes to rest, displaced, let go with
//! a velocity.

use super::joints::Role;
use super::moving_system::MovingSystem;
use super::rest_state::{at_rest, lines_at_rest, still};
use super::system_state::SystemState;
use crate::system::SolvedSystem;
use crate::system::freedoms::Placement;
use crate::system::initial::BodyInitial;
use crate::system::network::{Body, FreePoint, Held, Network, Point};
use crate::system::rest::UnsolvedSystem;
use crate::system::start::start;

/// The network with what begins where the file puts it held there: what it comes to rest as.
#[must_use]
pub(super) fn held(network: &Network) -> Network {
    let mut held = network.clone();
    if !is_placed(network) {
        return held;
    }
    let places = start(network).points;
    for (point, place) in held.points.iter_mut().zip(places) {
        if is_placed_point(point) {
            point.held = Held::At(place);
        }
    }
    for body in held.bodies.iter_mut().filter(|body| is_placed_body(body)) {
        (body.free, body.pinned) = (false, false);
    }
    held
}

/// Whether anything begins where the file puts it.
fn is_placed(network: &Network) -> bool {
    network.points.iter().any(is_placed_point) || network.bodies.iter().any(is_placed_body)
}

fn is_placed_point(point: &Point) -> bool {
    matches!(&point.held, Held::Free(free) if free.initial.placed)
}

fn is_placed_body(body: &Body) -> bool {
    body.turns() && body.initial.placed
}

/// Notes how far what is placed is from where it rests: infinitely where nothing else holds it.
pub(super) fn measure(network: &mut Network, solved: &SolvedSystem, rest: &Placement) {
    if !is_placed(network) {
        return;
    }
    let places = start(network).points;
    for (number, point) in network.points.iter_mut().enumerate() {
        let known = solved.network.point(&point.name);
        let is_held =
            known.is_some_and(|known| matches!(solved.network.points[known].held, Held::At(_)));
        if let Held::Free(FreePoint { initial, .. }) = &mut point.held
            && initial.placed
        {
            initial.from_rest = match is_held {
                true => f64::INFINITY,
                false => (places[number] - rest.points[number]).norm(),
            };
        }
    }
    for (body, (rest, at_rest)) in network
        .bodies
        .iter_mut()
        .zip(rest.bodies.iter().zip(&solved.network.bodies))
        .filter(|(body, _)| is_placed_body(body))
    {
        body.initial.from_rest = match at_rest.turns() {
            true => [
                (body.pose.origin - rest.origin).norm(),
                body.pose.rotation.angle_to(&rest.rotation),
            ],
            false => [f64::INFINITY; 2],
        };
    }
}

/// The system at time zero, where something begins off its equilibrium: displaced from a state of rest, lines at rest between their ends
/// there, all other points as they are; then with the velocities given.
///
/// # Errors
/// [`UnsolvedSystem`]: a line without a solution between its ends there.
pub(super) fn let_go(
    network: &Network,
    (system, rest): (&MovingSystem, &SystemState),
) -> Result<(MovingSystem, SystemState), UnsolvedSystem> {
    let place = |(point, joint): (&Point, &usize)| {
        let place = rest.joints.x[*joint];
        match &point.held {
            Held::Free(free) => place + free.initial.offset,
            Held::At(_) | Held::On(..) => place,
        }
    };
    let pose = |(number, body): (usize, &Body)| {
        let pose = system.body(rest, number).pose;
        match body.turns() {
            true => body.initial.pose(&pose),
            false => pose,
        }
    };
    let points = network.points.iter().zip(&system.joints.points);
    let mut placement = Placement {
        points: points.map(place).collect(),
        bodies: network.bodies.iter().enumerate().map(pose).collect(),
    };
    placement.carry(network);
    let lines = lines_at_rest(network, &placement)?;
    let (system, mut state) = at_rest(network.clone(), &placement, &lines);
    still(&mut state);
    system.prescribe(0.0, &mut state);
    set_velocities(&system, &mut state);
    system.follow(&mut state);
    system.begin_contacts(&mut state.joints);
    Ok((system, state))
}

/// Sets the velocities of what is free, of bodies the angular velocity along their own axes.
fn set_velocities(system: &MovingSystem, state: &mut SystemState) {
    let of_body = |body: usize| -> &BodyInitial { &system.network.bodies[body].initial };
    for joint in system.joints.free.clone() {
        let velocity = match system.joints.roles[joint] {
            Role::Free(number) => match &system.network.points[number].held {
                Held::Free(free) => free.initial.velocity,
                Held::At(_) | Held::On(..) => continue,
            },
            Role::Origin(body) => of_body(body).velocity,
            Role::Rotation(body) => state.bases[body].inverse() * of_body(body).angular_velocity,
            _ => continue,
        };
        state.joints.v[joint] = velocity;
    }
}
