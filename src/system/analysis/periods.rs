//! Natural periods of bodies and points on their lines: `K x = w² M x` about the equilibrium.
//!
//! K is the exact stiffness of lines, hydrostatics and weights, condensed onto the bodies and points that have a mass; M their mass and
//! inertia with the added mass given. The lines bring no inertia here, and points without mass follow at once.

use nalgebra::{DMatrix, DVector, Matrix6, SMatrix, SymmetricEigen};

use super::super::along_bed::{on_slope, stiffness_along};
use super::super::balance::balance;
use super::super::bounds::Contact;
use super::super::equilibrium::Equilibrium;
use super::super::freedoms::{Freedoms, UnknownBodies};
use super::super::line_at_rest::LinePhysics;
use super::super::members;
use super::super::network::{Body, Held, Network};
use super::super::pose::{Pose, cross};
use super::super::stiffness::{contacts, take};
use crate::numerics::V3;

/// A natural mode.
#[derive(Debug, Clone, PartialEq)]
pub struct SystemMode {
    /// Period \[s\]; infinite where nothing restores, nothing where the motion grows.
    pub period_s: Option<f64>,
    /// What moves most, by kinetic energy, and in which direction from 0 to 5.
    pub most: (Moving, usize),
}

/// A body or a point that has a mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moving {
    /// A body, with six directions.
    Body(usize),
    /// A free point, with three.
    Point(usize),
}

impl SystemMode {
    /// Name of what moves most, and the direction in words.
    #[must_use]
    pub fn names<'a>(&self, network: &'a Network) -> (&'a str, &'static str) {
        match self.most.0 {
            Moving::Body(body) => {
                let directions = ["surge", "sway", "heave", "roll", "pitch", "yaw"];
                (&network.bodies[body].name, directions[self.most.1])
            }
            Moving::Point(point) => (&network.points[point].name, ["x", "y", "z"][self.most.1]),
        }
    }
}

/// The natural modes of the bodies and free points that have a mass, the longest period first; none where nothing has one.
///
/// # Errors
/// A body with a mass and no inertia; a line without a solution.
pub fn periods(network: &Network, rest: &Equilibrium) -> Result<Vec<SystemMode>, String> {
    let all = Freedoms::of(network, UnknownBodies::All);
    let placement = &rest.placement;
    let lines = Some(rest.balance.lines.as_slice());
    let mut balance = balance(network, &all, placement, LinePhysics::Full, lines)
        .map_err(|unsolved| unsolved.why)?;
    let bed = network.bed.as_ref();
    // Bodies keep their six directions.
    let mut lying = on_slope(bed, (&all, placement), &contacts(rest, &all));
    lying.retain(|part| all.points.contains(&Some(part.first)));
    stiffness_along(bed, &lying, &balance.force, &mut balance.stiffness);
    let (own, inner) = unknowns(network, rest, &all);
    if own.is_empty() {
        return Ok(Vec::new());
    }
    let rows: Vec<usize> = own.iter().map(|moving| moving.unknown).collect();
    let stiffness = balance.stiffness.dense();
    let stiffness = 0.5 * (&stiffness + stiffness.transpose());
    let mut condensed = take(&stiffness, &rows, &rows);
    if !inner.is_empty()
        && let Some(response) = take(&stiffness, &inner, &inner)
            .lu()
            .solve(&take(&stiffness, &inner, &rows))
    {
        condensed -= take(&stiffness, &rows, &inner) * response;
    }
    modes(network, rest, &condensed, &own)
}

/// An unknown that has inertia.
struct MovingUnknown {
    of: Moving,
    direction: usize,
    /// Its number among all.
    unknown: usize,
}

/// The unknowns that have inertia, and those that follow at once; what bed or surface hold is in neither.
fn unknowns(
    network: &Network,
    rest: &Equilibrium,
    all: &Freedoms,
) -> (Vec<MovingUnknown>, Vec<usize>) {
    let (mut own, mut inner) = (Vec::new(), Vec::new());
    for (body, first) in all.bodies.iter().enumerate() {
        let Some(first) = first.filter(|_| network.bodies[body].mass > 0.0) else {
            continue;
        };
        let first_free = first_direction(&network.bodies[body]);
        own.extend((first_free..6).map(|direction| MovingUnknown {
            of: Moving::Body(body),
            direction,
            unknown: first + direction,
        }));
    }
    for (point, (here, there)) in all.points.iter().zip(&rest.freedoms.points).enumerate() {
        let (Some(here), Some(there), Held::Free(free)) =
            (here, there, &network.points[point].held)
        else {
            continue;
        };
        for k in (0..3).filter(|k| rest.contacts[there + k] == Contact::None) {
            match free.moving_mass > 0.0 {
                true => own.push(MovingUnknown {
                    of: Moving::Point(point),
                    direction: k,
                    unknown: here + k,
                }),
                false => inner.push(here + k),
            }
        }
    }
    (own, inner)
}

/// The first direction that a body moves in: one that is pinned turns alone.
fn first_direction(body: &Body) -> usize {
    if body.pinned { 3 } else { 0 }
}

/// The masses of the unknowns that have inertia.
fn masses(network: &Network, rest: &Equilibrium, own: &[MovingUnknown]) -> DMatrix<f64> {
    let mut masses = DMatrix::zeros(own.len(), own.len());
    for (k, moving) in own.iter().enumerate() {
        match (moving.of, moving.direction) {
            (Moving::Body(body), direction)
                if direction == first_direction(&network.bodies[body]) =>
            {
                let pose = &rest.placement.bodies[body];
                let block = mass_matrix(network, &network.bodies[body], pose);
                let size = 6 - direction;
                let block = block.view((direction, direction), (size, size));
                masses.view_mut((k, k), (size, size)).copy_from(&block);
            }
            (Moving::Body(_), _) => {}
            (Moving::Point(point), direction) => {
                let Held::Free(free) = &network.points[point].held else {
                    continue;
                };
                masses[(k, k)] = free.moving_mass;
                let lifts = lift(network, rest, point);
                for (j, other) in own.iter().enumerate() {
                    if other.of == moving.of {
                        masses[(k, j)] +=
                            free.moving_mass * lifts[direction] * lifts[other.direction];
                    }
                }
            }
        }
    }
    for (number, body) in network.bodies.iter().enumerate() {
        if let Some((carrier, at)) = &body.carrier {
            carry((network, rest), own, (number, *carrier, at), &mut masses);
        }
    }
    masses
}

/// Adds the mass of a body that is pinned to another, at a place of that one, to the unknowns of that one.
fn carry(
    (network, rest): (&Network, &Equilibrium),
    own: &[MovingUnknown],
    (number, carrier, at): (usize, usize, &V3),
    masses: &mut DMatrix<f64>,
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
    let by = by.columns(skipped, 6 - skipped);
    let size = by.ncols();
    let straight = by.transpose() * mass.fixed_view::<3, 3>(0, 0) * by;
    let mut block = masses.view_mut((on, on), (size, size));
    block += straight;
    let across = by.transpose() * mass.fixed_view::<3, 3>(0, 3);
    masses.view_mut((on, row), (size, 3)).copy_from(&across);
    masses
        .view_mut((row, on), (3, size))
        .copy_from(&across.transpose());
}

/// How far a point is lifted by a motion along x, y and z: by the slope of the bed that it lies on.
fn lift(network: &Network, rest: &Equilibrium, point: usize) -> [f64; 3] {
    let bed = network.bed.as_ref();
    let lies = rest.contact(point) == Contact::Bed;
    let gradient = bed
        .filter(|_| lies)
        .map(|bed| bed.gradient(&rest.placement.points[point]));
    gradient.map_or([0.0; 3], |gradient| [-gradient.x, -gradient.y, 0.0])
}

fn modes(
    network: &Network,
    rest: &Equilibrium,
    stiffness: &DMatrix<f64>,
    own: &[MovingUnknown],
) -> Result<Vec<SystemMode>, String> {
    let masses = masses(network, rest, own);
    let factors = masses.clone().cholesky().ok_or_else(|| {
        "a body has mass and no moments of inertia about each axis: give `inertia_kg_m2`".to_owned()
    })?;
    let lower = factors.l();
    let Some(inverse) = lower.clone().try_inverse() else {
        return Err("the masses of the bodies cannot be inverted".to_owned());
    };
    let scaled = &inverse * stiffness * inverse.transpose();
    let eigen = SymmetricEigen::new(0.5 * (&scaled + scaled.transpose()));
    let greatest = eigen.eigenvalues.amax();
    let mut found: Vec<(f64, SystemMode)> = Vec::new();
    for (k, value) in eigen.eigenvalues.iter().enumerate() {
        let motion = inverse.transpose() * eigen.eigenvectors.column(k);
        if is_spin(network, rest, own, &motion) {
            continue;
        }
        let most = &own[most_energy(network, rest, own, &motion)];
        let period_s = if value.abs() <= 1e-12 * greatest {
            Some(f64::INFINITY)
        } else {
            (*value > 0.0).then(|| std::f64::consts::TAU / value.sqrt())
        };
        let most = (most.of, most.direction);
        found.push((*value, SystemMode { period_s, most }));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(found.into_iter().map(|(_, mode)| mode).collect())
}

/// The direction that a motion is mostly of, by its share of the kinetic energy. That of a body is taken along its own axes and
/// about its centre of gravity: about another origin its pitch would read as surge.
fn most_energy(
    network: &Network,
    rest: &Equilibrium,
    own: &[MovingUnknown],
    motion: &DVector<f64>,
) -> usize {
    let mut energy = DVector::zeros(own.len());
    for (k, moving) in own.iter().enumerate() {
        match (moving.of, moving.direction) {
            (Moving::Body(body), 3) if network.bodies[body].pinned => {
                let (body, pose) = (&network.bodies[body], &rest.placement.bodies[body]);
                let axes = pose.matrix();
                let mass = mass_matrix(network, body, pose);
                let mass = mass.fixed_view::<3, 3>(3, 3);
                let mass = axes.matrix().transpose() * mass * axes.matrix();
                let here = axes.matrix().transpose() * motion.fixed_rows::<3>(k);
                for j in 0..3 {
                    energy[k + j] = mass[(j, j)] * here[j] * here[j];
                }
            }
            (Moving::Body(body), 0) => {
                let (body, pose) = (&network.bodies[body], &rest.placement.bodies[body]);
                let mut shift = Matrix6::identity();
                let arm = cross(&pose.arm(&body.centre_of_gravity));
                shift.fixed_view_mut::<3, 3>(0, 3).copy_from(&arm);
                shift *= axes(pose);
                let mass = shift.transpose() * mass_matrix(network, body, pose) * shift;
                let mut here = motion.fixed_rows::<6>(k).into_owned();
                let turn = arm * here.fixed_rows::<3>(3);
                let mut step = here.fixed_rows_mut::<3>(0);
                step -= turn;
                let here = axes(pose).transpose() * here;
                for j in 0..6 {
                    energy[k + j] = mass[(j, j)] * here[j] * here[j];
                }
            }
            (Moving::Body(_), _) => {}
            (Moving::Point(point), _) => {
                if let Held::Free(free) = &network.points[point].held {
                    energy[k] = free.moving_mass * motion[k] * motion[k];
                }
            }
        }
    }
    energy.imax()
}

/// Whether a motion is the spin of a rod, which what keeps it in place makes up.
fn is_spin(
    network: &Network,
    rest: &Equilibrium,
    own: &[MovingUnknown],
    motion: &DVector<f64>,
) -> bool {
    let whole = motion.norm_squared();
    own.iter().enumerate().any(|(k, moving)| {
        let Moving::Body(body) = moving.of else {
            return false;
        };
        let Some(axis) = network.bodies[body]
            .spins_about
            .filter(|_| moving.direction == 3)
        else {
            return false;
        };
        let axis = rest.placement.bodies[body].arm(&axis);
        let spin = axis.dot(&motion.fixed_rows::<3>(k));
        spin * spin > 0.99 * whole
    })
}

/// The axes of a body in the earth's, for displacements and turns.
fn axes(pose: &Pose) -> Matrix6<f64> {
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
