//! Stiffness of what is held: the tangent of the whole system condensed onto a body.

use nalgebra::{DMatrix, Matrix6};

use super::balance::{UnsolvedLine, balance};
use super::body_loads::body_loads;
use super::bounds::Contact;
use super::equilibrium::Equilibrium;
use super::freedoms::{Freedoms, UnknownBodies};
use super::line_at_rest::LinePhysics;
use super::network::Network;

/// Stiffness of the lines on a body about its origin: minus the change of their force and moment as the body moves and turns,
/// everything free in balance \[N/m, N, N m\]. The axes are the earth's; other held bodies stay.
///
/// # Errors
/// A line without a solution; not at an equilibrium.
pub fn of_body(
    network: &Network,
    rest: &Equilibrium,
    body: usize,
) -> Result<Matrix6<f64>, UnsolvedLine> {
    let freedoms = Freedoms::of(network, UnknownBodies::All);
    let (placement, lines) = (&rest.placement, &rest.balance.lines);
    let all = balance(
        network,
        &freedoms,
        placement,
        LinePhysics::Full,
        Some(lines),
    )?;
    let first = freedoms.bodies[body].unwrap_or(0);
    let own: Vec<usize> = (first..first + 6).collect();
    let others = relaxed(network, rest, &freedoms, body);
    let mut block = take(&all.stiffness, &own, &own);
    let inner = take(&all.stiffness, &others, &others);
    let coupling = take(&all.stiffness, &others, &own);
    if !others.is_empty()
        && let Some(response) = inner.lu().solve(&coupling)
    {
        block -= take(&all.stiffness, &own, &others) * response;
    }
    let pose = &placement.bodies[body];
    let loads = body_loads(network, &network.bodies[body], pose, LinePhysics::Full).1;
    Ok(Matrix6::from_fn(|i, j| block[(i, j)]) - loads)
}

/// The unknowns that follow a body: free points and other free bodies, but for heights that bed or surface hold.
fn relaxed(network: &Network, rest: &Equilibrium, all: &Freedoms, body: usize) -> Vec<usize> {
    let mut unknowns = Vec::new();
    let mut add = |here: Option<usize>, there: Option<usize>, size: usize| {
        let (Some(here), Some(there)) = (here, there) else {
            return;
        };
        unknowns.extend(
            (0..size)
                .filter(|k| rest.contacts[there + k] == Contact::None)
                .map(|k| here + k),
        );
    };
    for (here, there) in all.points.iter().zip(&rest.freedoms.points) {
        add(*here, *there, 3);
    }
    for (index, (here, there)) in all.bodies.iter().zip(&rest.freedoms.bodies).enumerate() {
        if index != body && network.bodies[index].free {
            add(*here, *there, 6);
        }
    }
    unknowns
}

/// Rows and columns of a matrix.
#[must_use]
pub fn take(matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
        matrix[(rows[i], columns[j])]
    })
}

/// The stiffness with the unknowns that are held standing for themselves.
#[must_use]
pub fn held_apart(stiffness: &DMatrix<f64>, held: &[bool]) -> DMatrix<f64> {
    let mut stiffness = stiffness.clone();
    for (unknown, held) in held.iter().enumerate() {
        if *held {
            stiffness.row_mut(unknown).fill(0.0);
            stiffness.column_mut(unknown).fill(0.0);
            stiffness[(unknown, unknown)] = 1.0;
        }
    }
    stiffness
}
