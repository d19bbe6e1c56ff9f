//! How an equilibrium rests: by the least eigenvalue of its stiffness.

use nalgebra::DVector;

use super::along_bed::{on_slope, stiffness_along};
use super::bounds::Contact;
use super::equilibrium::{SystemEquilibrium, levers};
use super::network::Network;
use crate::numerics::envelope::EnvelopeMatrix;
use crate::numerics::envelope_factors::EnvelopeCholesky;
use crate::numerics::random::Random;

/// How a system rests.
#[derive(Debug, Clone, PartialEq)]
pub enum Stability {
    /// It returns from any small displacement.
    Stable,
    /// It stays where it is put along some direction: the unknown that moves most, in words. Where no body is free the
    /// tensions are the same all along.
    Neutral(String),
    /// It leaves: the unknown that moves most, in words.
    Unstable(String),
}

/// Eigenvalues below this share of the greatest are none.
const NEUTRAL: f64 = 1e-11;
/// Negative eigenvalues beyond this share of the greatest are no rounding.
const UNSTABLE: f64 = 1e-9;

/// The stability of an equilibrium: the least eigenvalue of the stiffness of what may move.
#[must_use]
pub fn stability(network: &Network, rest: &SystemEquilibrium) -> Stability {
    let Some(Scaled {
        stiffness, most, ..
    }) = scaled(network, rest)
    else {
        return Stability::Stable;
    };
    // As many positive pivots of the shifted matrix as unknowns, as many eigenvalues above the shift (Sylvester).
    if above(&stiffness, NEUTRAL * most).is_some() {
        return Stability::Stable;
    }
    let mut random = Random::new(1, 0);
    let start = DVector::from_fn(stiffness.size(), |_, _| random.uniform() - 0.5);
    let unknown = softest(&stiffness, most, start).iamax();
    let name = rest.freedoms.name(network, unknown);
    if above(&stiffness, -UNSTABLE * most).is_none() {
        Stability::Unstable(name)
    } else {
        Stability::Neutral(name)
    }
}

/// The motion along which an unstable equilibrium is left, its greatest turn 1: the part of `towards` (turns of bodies in the earth's
/// directions, other unknowns nothing) in the eigenvectors of the least eigenvalue of the stiffness. Nothing where the equilibrium is not
/// unstable, or where it is and nothing turns.
#[must_use]
pub fn unstable_motion(
    network: &Network,
    rest: &SystemEquilibrium,
    towards: &DVector<f64>,
) -> Option<DVector<f64>> {
    let Scaled {
        stiffness,
        most,
        by,
        held,
    } = scaled(network, rest)?;
    if above(&stiffness, -UNSTABLE * most).is_some() {
        return None;
    }
    let mut start = towards.component_div(&by);
    for (unknown, _) in held.iter().enumerate().filter(|(_, held)| **held) {
        start[unknown] = 0.0;
    }
    let motion = softest(&stiffness, most, start).component_mul(&by);
    let bodies = rest.freedoms.bodies.iter().flatten();
    let turns = bodies.map(|first| motion.rows(first + 3, 3).amax());
    let turn = turns.fold(0.0, f64::max);
    (turn > 0.0 && turn.is_finite()).then(|| motion / turn)
}

/// The stiffness of what may move, in lengths.
struct Scaled {
    stiffness: EnvelopeMatrix,
    /// The greatest number on its diagonal.
    most: f64,
    /// By what the lengths are multiplied for the unknowns: turns count by the way they move a fairlead, or N m would be held against N/m.
    by: DVector<f64>,
    /// What does not move: `most` stands on its diagonal.
    held: Vec<bool>,
}

/// The stiffness of what may move; nothing where nothing does.
fn scaled(network: &Network, rest: &SystemEquilibrium) -> Option<Scaled> {
    let held: Vec<bool> = rest
        .contacts
        .iter()
        .map(|on| *on != Contact::None)
        .collect();
    if !held.contains(&false) {
        return None;
    }
    let by = levers(network, &rest.freedoms).map(|lever| 1.0 / lever);
    let mut stiffness = rest.balance.stiffness.clone();
    let bed = network.bed.as_ref();
    let lying = on_slope(bed, (&rest.freedoms, &rest.placement), &rest.contacts);
    stiffness_along(bed, &lying, &rest.balance.force, &mut stiffness);
    stiffness.scale(&by);
    stiffness.hold(&held, 0.0);
    let most = stiffness.diagonal().amax().max(f64::MIN_POSITIVE);
    for (unknown, _) in held.iter().enumerate().filter(|(_, held)| **held) {
        stiffness.add(unknown, unknown, most);
    }
    Some(Scaled {
        stiffness,
        most,
        by,
        held,
    })
}

/// The factors of a matrix less a multiple of the unit matrix; nothing where an eigenvalue is not above it.
fn above(stiffness: &EnvelopeMatrix, shift: f64) -> Option<EnvelopeCholesky> {
    let diagonal = DVector::from_element(stiffness.size(), -shift);
    EnvelopeCholesky::new(stiffness, &diagonal)
}

/// Bisections for the least eigenvalue, and solutions for its eigenvector: next to the eigenvalue one solution is nearly enough.
const BISECTIONS: usize = 40;
const SOLUTIONS: usize = 8;

/// The part of a vector in the eigenvectors of the least eigenvalue; `most` is the greatest number on the diagonal.
fn softest(stiffness: &EnvelopeMatrix, most: f64, mut vector: DVector<f64>) -> DVector<f64> {
    // Shifts below the eigenvalue and not below it.
    let mut low = -most;
    let mut factors = above(stiffness, low);
    while factors.is_none() && low.is_finite() {
        low *= 4.0;
        factors = above(stiffness, low);
    }
    let mut high = most;
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        match above(stiffness, middle) {
            Some(found) => (low, factors) = (middle, Some(found)),
            None => high = middle,
        }
    }
    if let Some(factors) = factors {
        for _ in 0..SOLUTIONS {
            vector = factors.solve(&vector).normalize();
        }
    }
    vector
}
