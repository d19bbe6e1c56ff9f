//! Natural periods of bodies and points on their lines: `K x = w² M x` about the equilibrium.
//!
//! K is the exact stiffness of lines, hydrostatics and weights, condensed onto the bodies and points that have a mass; M their mass and
//! inertia with the added mass given. The lines bring no inertia here, and points without mass follow at once.

use std::collections::HashSet;
use std::ops::Range;

use nalgebra::{DMatrix, DVector, Matrix6, SymmetricEigen};

use super::super::along_bed::{on_slope, stiffness_along};
use super::super::balance::balance;
use super::super::bounds::Contact;
use super::super::equilibrium::SystemEquilibrium;
use super::super::freedoms::{Freedoms, UnknownBodies};
use super::super::line_physics::LinePhysics;
use super::super::network::{Held, Network};
use super::super::pose::cross;
use super::super::stiffness::{contacts, take};
use super::masses::{MovingUnknown, axes, first_direction, mass_at_rest, mass_matrix, masses};
use crate::numerics::envelope::EnvelopeMatrix;
use crate::numerics::lowest_modes::lowest_modes;

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

/// Natural modes, the longest period first.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct NaturalModes {
    /// The modes.
    pub modes: Vec<SystemMode>,
    /// Period below which there are modes that were not computed \[s\]; nothing where all were.
    pub complete_to_s: Option<f64>,
}

impl NaturalModes {
    /// The periods by their numbers \[s\]: those that end, as far as none is missing.
    pub fn numbered(&self) -> impl Iterator<Item = f64> {
        let shortest = self.complete_to_s.unwrap_or(0.0);
        let periods = self.modes.iter().filter_map(|mode| mode.period_s);
        periods.filter(move |period| period.is_finite() && *period >= shortest)
    }
}

/// Unknowns with inertia of a part of a system whose modes are all computed, from a dense matrix.
const DENSE: usize = 300;
/// Modes that are computed of a larger part, or some fewer.
const LOWEST: usize = 60;

/// The natural modes of the bodies and free points that have a mass; none where nothing has one. What no line joins moves by itself: each
/// part of the system has modes of its own, of large ones those of the longest periods.
///
/// # Errors
/// A body with a mass and no inertia; a line without a solution; what has no mass and nothing holds, in a large part.
pub fn periods(network: &Network, rest: &SystemEquilibrium) -> Result<NaturalModes, String> {
    let all = Freedoms::of_network(network, UnknownBodies::All);
    let stiffness = stiffness(network, rest, &all)?;
    let (mut found, mut greatest, mut bound) = (Vec::new(), 0.0_f64, f64::INFINITY);
    for part in parts(network, rest, &all, &stiffness) {
        let modes = match part.own.len() > DENSE {
            true => lowest(network, rest, &part, &stiffness)?,
            false => modes(network, rest, &part.condensed(&stiffness), &part.own)?,
        };
        found.extend(modes.found);
        greatest = greatest.max(modes.greatest);
        bound = bound.min(modes.bound);
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let modes = found.into_iter();
    let modes = modes.map(|(value, most)| SystemMode {
        period_s: period(value, greatest),
        most,
    });
    Ok(NaturalModes {
        modes: modes.collect(),
        complete_to_s: bound
            .is_finite()
            .then(|| period(bound, greatest).unwrap_or(f64::INFINITY)),
    })
}

/// The period of an eigenvalue \[1/s²\]; `greatest` is that of all by size.
fn period(value: f64, greatest: f64) -> Option<f64> {
    if value.abs() <= 1e-12 * greatest {
        return Some(f64::INFINITY);
    }
    (value > 0.0).then(|| std::f64::consts::TAU / value.sqrt())
}

/// The stiffness of everything, held bodies included.
fn stiffness(
    network: &Network,
    rest: &SystemEquilibrium,
    all: &Freedoms,
) -> Result<EnvelopeMatrix, String> {
    let placement = &rest.placement;
    let lines = Some(rest.balance.lines.as_slice());
    let mut balance = balance(network, all, placement, LinePhysics::Full, lines)
        .map_err(|unsolved| unsolved.why)?;
    let bed = network.bed.as_ref();
    // Bodies keep their six directions.
    let mut lying = on_slope(bed, (all, placement), &contacts(rest, all));
    let points: HashSet<usize> = all.points.iter().flatten().copied().collect();
    lying.retain(|part| points.contains(&part.first));
    stiffness_along(bed, &lying, &balance.force, &mut balance.stiffness);
    Ok(balance.stiffness)
}

/// What lines join, directly or over others.
struct JoinedPart {
    unknowns: Range<usize>,
    /// The unknowns that have inertia.
    own: Vec<MovingUnknown>,
    /// Those that follow at once.
    inner: Vec<usize>,
}

impl JoinedPart {
    /// The stiffness condensed onto the unknowns that have inertia.
    fn condensed(&self, stiffness: &EnvelopeMatrix) -> DMatrix<f64> {
        let from = self.unknowns.start;
        let rows = self.own.iter().map(|moving| moving.unknown - from);
        let rows: Vec<usize> = rows.collect();
        let inner: Vec<usize> = self.inner.iter().map(|unknown| unknown - from).collect();
        let stiffness = stiffness.part(&self.unknowns).dense();
        let stiffness = 0.5 * (&stiffness + stiffness.transpose());
        let mut condensed = take(&stiffness, &rows, &rows);
        if !inner.is_empty()
            && let Some(response) = take(&stiffness, &inner, &inner)
                .lu()
                .solve(&take(&stiffness, &inner, &rows))
        {
            condensed -= take(&stiffness, &rows, &inner) * response;
        }
        condensed
    }
}

/// The parts of a system in which something has inertia; what bed or surface hold is in neither of their lists.
fn parts(
    network: &Network,
    rest: &SystemEquilibrium,
    all: &Freedoms,
    stiffness: &EnvelopeMatrix,
) -> Vec<JoinedPart> {
    let mut number = vec![0; all.count];
    let mut parts: Vec<JoinedPart> = Vec::new();
    for unknowns in stiffness.parts() {
        number[unknowns.clone()].fill(parts.len());
        parts.push(JoinedPart {
            unknowns,
            own: Vec::new(),
            inner: Vec::new(),
        });
    }
    for (body, first) in all.bodies.iter().enumerate() {
        let Some(first) = first.filter(|_| network.bodies[body].mass > 0.0) else {
            continue;
        };
        let first_free = first_direction(&network.bodies[body]);
        let directions = (first_free..6).map(|direction| MovingUnknown {
            of: Moving::Body(body),
            direction,
            unknown: first + direction,
        });
        parts[number[first]].own.extend(directions);
    }
    for (point, (here, there)) in all.points.iter().zip(&rest.freedoms.points).enumerate() {
        let (Some(here), Some(there), Held::Free(free)) =
            (here, there, &network.points[point].held)
        else {
            continue;
        };
        let mass = mass_at_rest(network, rest, (point, free));
        let part = &mut parts[number[*here]];
        for k in (0..3).filter(|k| rest.contacts[there + k] == Contact::None) {
            match mass[k] > 0.0 {
                true => part.own.push(MovingUnknown {
                    of: Moving::Point(point),
                    direction: k,
                    unknown: here + k,
                }),
                false => part.inner.push(here + k),
            }
        }
    }
    parts.retain(|part| !part.own.is_empty());
    parts
}

/// The modes of a part.
struct PartModes {
    /// Eigenvalues \[1/s²\], and what moves most in each.
    found: Vec<(f64, (Moving, usize))>,
    /// The greatest eigenvalue by size, spins of rods included.
    greatest: f64,
    /// All below this are found.
    bound: f64,
}

/// The modes of a part of lowest frequency.
fn lowest(
    network: &Network,
    rest: &SystemEquilibrium,
    part: &JoinedPart,
    stiffness: &EnvelopeMatrix,
) -> Result<PartModes, String> {
    let from = part.unknowns.start;
    let mut stiffness = stiffness.part(&part.unknowns).symmetric_part();
    let mut held = vec![true; stiffness.size()];
    let moving = part.own.iter().map(|moving| moving.unknown);
    for unknown in moving.chain(part.inner.iter().copied()) {
        held[unknown - from] = false;
    }
    stiffness.hold(&held, stiffness.diagonal().amax());
    let mut mass = EnvelopeMatrix::zeros(&stiffness.shape());
    masses(network, rest, &part.own, &mut |row, column, value| {
        let at = |own: usize| part.own[own].unknown - from;
        mass.add(at(row), at(column), value);
    });
    let found = lowest_modes(&stiffness, &mass, LOWEST)
        .ok_or_else(|| "something without mass is held by nothing, or bodies have no inertia: give each its mass and `inertia_kg_m2`".to_owned())?;
    let quotients = part.own.iter().map(|moving| {
        let at = moving.unknown - from;
        (stiffness.at(at, at) / mass.at(at, at)).abs()
    });
    let mut modes = PartModes {
        found: Vec::new(),
        greatest: quotients.fold(0.0, f64::max),
        bound: found.bound,
    };
    for (value, vector) in found.modes {
        let own = part.own.iter().map(|moving| vector[moving.unknown - from]);
        let motion = DVector::from_iterator(part.own.len(), own);
        modes.add(value, (network, rest), &part.own, &motion);
    }
    Ok(modes)
}

impl PartModes {
    /// Adds a mode, unless it is the spin of a rod.
    fn add(
        &mut self,
        value: f64,
        (network, rest): (&Network, &SystemEquilibrium),
        own: &[MovingUnknown],
        motion: &DVector<f64>,
    ) {
        if !is_spin(network, rest, own, motion) {
            let most = &own[most_energy(network, rest, own, motion)];
            self.found.push((value, (most.of, most.direction)));
        }
    }
}

/// All modes of a part.
fn modes(
    network: &Network,
    rest: &SystemEquilibrium,
    stiffness: &DMatrix<f64>,
    own: &[MovingUnknown],
) -> Result<PartModes, String> {
    let mut masses = DMatrix::zeros(own.len(), own.len());
    self::masses(network, rest, own, &mut |row, column, value| {
        masses[(row, column)] += value;
    });
    let factors = masses.clone().cholesky().ok_or_else(|| {
        "a body has mass and no moments of inertia about each axis: give `inertia_kg_m2`".to_owned()
    })?;
    let lower = factors.l();
    let Some(inverse) = lower.clone().try_inverse() else {
        return Err("the masses of the bodies cannot be inverted".to_owned());
    };
    let back = inverse.transpose();
    let scaled = &inverse * stiffness * &back;
    let eigen = SymmetricEigen::new(0.5 * (&scaled + scaled.transpose()));
    let mut modes = PartModes {
        found: Vec::new(),
        greatest: eigen.eigenvalues.amax(),
        bound: f64::INFINITY,
    };
    for (k, value) in eigen.eigenvalues.iter().enumerate() {
        let motion = &back * eigen.eigenvectors.column(k);
        modes.add(*value, (network, rest), own, &motion);
    }
    Ok(modes)
}

/// The direction that a motion is mostly of, by its share of the kinetic energy. That of a body is taken along its own axes and
/// about its centre of gravity: about another origin its pitch would read as surge.
fn most_energy(
    network: &Network,
    rest: &SystemEquilibrium,
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
            (Moving::Point(point), direction) => {
                if let Held::Free(free) = &network.points[point].held {
                    let mass = mass_at_rest(network, rest, (point, free));
                    energy[k] = mass[direction] * motion[k] * motion[k];
                }
            }
        }
    }
    energy.imax()
}

/// Whether a motion is the spin of a rod, which what keeps it in place makes up.
fn is_spin(
    network: &Network,
    rest: &SystemEquilibrium,
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

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use super::*;
    use crate::case::kind::parse_stored;
    use crate::system::SystemFile;

    #[test]
    fn the_longest_periods_of_a_large_part_are_those_of_its_dense_matrix() {
        let mut text = "[system]\ntitle = \"chain\"\n[materials.w]\nmass_kg_per_m = 20.0\ndiameter_m = 0.06\nea_n = 1e8\n".to_owned();
        for k in 0..40 {
            let x = 50.0 * f64::from(k);
            let mass = if k % 7 == 3 { 0.0 } else { 100.0 };
            let _ = write!(
                text,
                "[points.f{k}]\nkind = \"free\"\nmass_kg = {mass:?}\n[points.x{k}]\nkind = \"fixed\"\nposition_m = [{x:?}, 0.0, 0.0]\n\
                 [[lines]]\nname = \"u{k}\"\nfrom = \"f{k}\"\nto = \"x{k}\"\nmaterial = \"w\"\nlength_m = 100.0\n"
            );
            if k > 0 {
                let _ = write!(
                    text,
                    "[[lines]]\nname = \"s{k}\"\nfrom = \"f{}\"\nto = \"f{k}\"\nmaterial = \"w\"\nlength_m = 60.0\n",
                    k - 1
                );
            }
        }
        let solved = parse_stored::<SystemFile>(&text, "chain.toml").unwrap();
        let (network, rest) = (&solved.network, &solved.rest);
        let all = Freedoms::of_network(network, UnknownBodies::All);
        let stiffness = stiffness(network, rest, &all).unwrap();
        let parts = parts(network, rest, &all, &stiffness);
        let [part] = &parts[..] else {
            panic!("{} parts", parts.len())
        };
        let mut dense = modes(network, rest, &part.condensed(&stiffness), &part.own).unwrap();
        dense.found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let lowest = lowest(network, rest, part, &stiffness).unwrap();
        assert!((20..=LOWEST).contains(&lowest.found.len()));
        for (found, wanted) in lowest.found.iter().zip(&dense.found) {
            assert!(
                (found.0 / wanted.0 - 1.0).abs() < 1e-9,
                "{found:?} {wanted:?}"
            );
        }
        let next = dense.found[lowest.found.len()].0;
        assert!(lowest.found.last().unwrap().0 < lowest.bound && lowest.bound <= next);
    }
}
