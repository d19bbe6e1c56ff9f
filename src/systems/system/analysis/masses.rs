//! Masses of the bodies and points of a system, by the unknowns that have inertia.

use nalgebra::{DMatrix, Matrix6, SMatrix};

use super::super::bounds::Contact;
use super::super::equilibrium::SystemEquilibrium;
use super::super::immersion::Immersion;
use super::super::members;
use super::super::network::{Body, FreePoint, Held, Network};
use super::super::pose::{Pose, cross};
use super::periods::Moving;
use crate::numerics::V3;

/// An unknown that has inertia.
pub(super) struct MovingUnknown {
    pub(super) of: Moving,
    pub(super) direction: usize,
    /// Its number among all.
    pub(super) unknown: usize,
}

/// The first direction that a body moves in: one that is pinned turns alone.
pub(super) fn first_direction(body: &Body) -> usize {
    if body.pinned { 3 } else { 0 }
}

/// Adds the masses of the unknowns that have inertia: by row, column and value.
pub(super) fn masses(
    network: &Network,
    rest: &SystemEquilibrium,
    own: &[MovingUnknown],
    add: &mut impl FnMut(usize, usize, f64),
) {
    for (k, moving) in own.iter().enumerate() {
        match (moving.of, moving.direction) {
            (Moving::Body(body), direction)
                if direction == first_direction(&network.bodies[body]) =>
            {
                let pose = &rest.placement.bodies[body];
                let block = mass_matrix(network, &network.bodies[body], pose);
                let size = 6 - direction;
                let block = block.view((direction, direction), (size, size));
                add_block((k, k), &block.into_owned(), add);
            }
            (Moving::Body(_), _) => {}
            (Moving::Point(point), direction) => {
                let Held::Free(free) = &network.points[point].held else {
                    continue;
                };
                let mass = mass_at_rest(network, rest, (point, free));
                add(k, k, mass[direction]);
                let lifts = lift(network, rest, point);
                // Its other directions stand beside this one.
                for j in k.saturating_sub(2)..own.len().min(k + 3) {
                    if own[j].of == moving.of {
                        let lifted = mass.z * lifts[direction] * lifts[own[j].direction];
                        add(k, j, lifted);
                    }
                }
            }
        }
    }
    for body in own.iter().filter(|moving| moving.direction == 3) {
        if let Moving::Body(number) = body.of
            && let Some((carrier, at)) = &network.bodies[number].carrier
        {
            carry((network, rest), own, (number, *carrier, at), add);
        }
    }
}

/// The mass of a free point where it rests, with the added mass of what of it is under water \[kg\]. What the surface holds down is out of the water by the share of its
/// buoyancy that this takes.
pub(super) fn mass_at_rest(
    network: &Network,
    rest: &SystemEquilibrium,
    (number, point): (usize, &FreePoint),
) -> V3 {
    if network.crossed {
        let z = rest.placement.points[number].z;
        return point.mass(Immersion::of_point(network, point, z).share);
    }
    let at_surface = rest.contact(number) == Contact::Surface && point.buoyancy > 0.0;
    let first = rest.freedoms.points[number].filter(|_| at_surface);
    let dry = first.map_or(0.0, |first| rest.balance.force[first + 2] / point.buoyancy);
    point.mass(1.0 - dry.clamp(0.0, 1.0))
}

fn add_block(
    (row, column): (usize, usize),
    block: &DMatrix<f64>,
    add: &mut impl FnMut(usize, usize, f64),
) {
    for i in 0..block.nrows() {
        for j in 0..block.ncols() {
            add(row + i, column + j, block[(i, j)]);
        }
    }
}

/// Adds the mass of a body that is pinned to another, at a place of that one, to the unknowns of that one.
fn carry(
    (network, rest): (&Network, &SystemEquilibrium),
    own: &[MovingUnknown],
    (number, carrier, at): (usize, usize, &V3),
    add: &mut impl FnMut(usize, usize, f64),
) {
    let first = |body: usize| own.iter().position(|known| known.of == Moving::Body(body));
    let (Some(row), Some(on)) = (first(number), first(carrier)) else {
        return;
    };
    let poses = &rest.placement.bodies;
    let mass = mass_matrix(network, &network.bodies[number], &poses[number]);
    let mut by = SMatrix::<f64, 3, 6>::identity();
    let arm = poses[carrier].arm(at);
    by.fixed_view_mut::<3, 3>(0, 3).copy_from(&-cross(&arm));
    let skipped = first_direction(&network.bodies[carrier]);
    let by = by.columns(skipped, 6 - skipped).into_owned();
    let straight = by.transpose() * mass.fixed_view::<3, 3>(0, 0) * &by;
    add_block((on, on), &straight, add);
    let across = by.transpose() * mass.fixed_view::<3, 3>(0, 3);
    let across = DMatrix::from_fn(across.nrows(), 3, |i, j| across[(i, j)]);
    add_block((on, row), &across, add);
    add_block((row, on), &across.transpose(), add);
}

/// How far a point is lifted by a motion along x, y and z: by the slope of the bed that it lies on.
fn lift(network: &Network, rest: &SystemEquilibrium, point: usize) -> [f64; 3] {
    let bed = network.bed.as_ref();
    let lies = rest.contact(point) == Contact::Bed;
    let rise = bed
        .filter(|_| lies)
        .map(|bed| bed.rise(&rest.placement.points[point]));
    rise.map_or([0.0; 3], |[x, y]| [x, y, 0.0])
}

/// The axes of a body in the earth's, for displacements and turns.
pub(super) fn axes(pose: &Pose) -> Matrix6<f64> {
    let mut axes = Matrix6::zeros();
    for k in [0, 3] {
        let mut block = axes.fixed_view_mut::<3, 3>(k, k);
        block.copy_from(pose.matrix().matrix());
    }
    axes
}

/// Mass, inertia and added mass of a body about its origin, in the axes of the earth \[kg, kg m, kg m²\].
#[must_use]
pub fn mass_matrix(network: &Network, body: &Body, pose: &Pose) -> Matrix6<f64> {
    let arm = pose.arm(&body.centre_of_gravity);
    let turn = pose.matrix();
    let inertia = turn.matrix() * body.inertia * turn.matrix().transpose();
    let lever = cross(&arm) * body.mass;
    let axes = axes(pose);
    let added = axes * body.added_mass * axes.transpose();
    let mut mass = added + members::added_mass(network, body, pose);
    for k in 0..3 {
        mass[(k, k)] += body.mass;
    }
    let mut upper = mass.fixed_view_mut::<3, 3>(0, 3);
    upper -= lever;
    let mut lower = mass.fixed_view_mut::<3, 3>(3, 0);
    lower += lever;
    let mut turning = mass.fixed_view_mut::<3, 3>(3, 3);
    turning += inertia - cross(&arm) * cross(&arm) * body.mass;
    0.5 * (mass + mass.transpose())
}
