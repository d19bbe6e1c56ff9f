//! How an equilibrium rests: by the least eigenvalue of its stiffness.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::bounds::Contact;
use super::equilibrium::{Equilibrium, levers};
use super::network::Network;
use super::stiffness::take;
use crate::numerics::envelope::EnvelopeCholesky;

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
pub fn stability(network: &Network, rest: &Equilibrium) -> Stability {
    let moving: Vec<usize> = (0..rest.freedoms.count)
        .filter(|&k| rest.contacts[k] == Contact::None)
        .collect();
    if moving.is_empty() {
        return Stability::Stable;
    }
    // Turns count by the way they move a fairlead, or N m would be held against N/m.
    let lever = levers(network, &rest.freedoms);
    let mut stiffness: DMatrix<f64> = take(&rest.balance.symmetric(), &moving, &moving);
    for (row, i) in moving.iter().enumerate() {
        for (column, j) in moving.iter().enumerate() {
            stiffness[(row, column)] /= lever[*i] * lever[*j];
        }
    }
    let most = stiffness.diagonal().amax();
    // As many positive pivots as unknowns, as many positive eigenvalues (Sylvester): most systems need no more.
    let floor = DVector::from_element(moving.len(), -NEUTRAL * most);
    let order: Vec<usize> = (0..moving.len()).collect();
    if EnvelopeCholesky::new(&stiffness, &floor, &order).is_some() {
        return Stability::Stable;
    }
    let eigen = SymmetricEigen::new(stiffness);
    let least = eigen.eigenvalues.imin();
    let value = eigen.eigenvalues[least];
    if value > NEUTRAL * most {
        return Stability::Stable;
    }
    let unknown = moving[eigen.eigenvectors.column(least).iamax()];
    let name = rest.freedoms.name(network, unknown);
    if value < -UNSTABLE * most {
        Stability::Unstable(name)
    } else {
        Stability::Neutral(name)
    }
}
