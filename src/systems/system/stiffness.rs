//! Stiffness of what is held: the tangent of the whole system condensed onto a body.

use nalgebra::{DMatrix, DVector, Matrix6};

use super::along_bed::{on_slope, stiffness_along};
use super::balance::{Balance, UnsolvedLine, balance};
use super::body_loads::body_loads;
use super::bounds::Contact;
use super::equilibrium::SystemEquilibrium;
use super::freedoms::{Freedoms, UnknownBodies};
use super::line_physics::LinePhysics;
use super::network::Network;
use crate::numerics::envelope::EnvelopeMatrix;

/// Stiffness of the lines on a body about its origin: minus the change of their force and moment as the body moves and turns,
/// everything free in balance \[N/m, N, N m\]. The axes are the earth's; other held bodies stay.
///
/// # Errors
/// A line without a solution; not at an equilibrium.
pub fn of_body(
    network: &Network,
    rest: &SystemEquilibrium,
    body: usize,
) -> Result<Matrix6<f64>, UnsolvedLine> {
    let whole = Whole::new(network, rest)?;
    Ok(whole.on_body(network, rest, body))
}

/// The same for every body.
///
/// # Errors
/// As [`of_body`].
pub fn of_bodies(
    network: &Network,
    rest: &SystemEquilibrium,
) -> Result<Vec<Matrix6<f64>>, UnsolvedLine> {
    if network.bodies.is_empty() {
        return Ok(Vec::new());
    }
    let whole = Whole::new(network, rest)?;
    let bodies = 0..network.bodies.len();
    Ok(bodies
        .map(|body| whole.on_body(network, rest, body))
        .collect())
}

/// The tangent of a system, held bodies among its unknowns.
struct Whole {
    freedoms: Freedoms,
    balance: Balance,
}

impl Whole {
    fn new(network: &Network, rest: &SystemEquilibrium) -> Result<Self, UnsolvedLine> {
        let freedoms = Freedoms::of_network(network, UnknownBodies::All);
        let near = Some(rest.balance.lines.as_slice());
        let at = &rest.placement;
        let balance = balance(network, &freedoms, at, LinePhysics::Full, near)?;
        Ok(Self { freedoms, balance })
    }

    /// The stiffness by the motions along the bed of what lies on it where it slopes, but for a body that is moved itself.
    fn along_bed(
        &self,
        network: &Network,
        rest: &SystemEquilibrium,
        body: usize,
    ) -> EnvelopeMatrix {
        let mut stiffness = self.balance.stiffness.clone();
        let contacts = contacts(rest, &self.freedoms);
        let bed = network.bed.as_ref();
        let mut lying = on_slope(bed, (&self.freedoms, &rest.placement), &contacts);
        lying.retain(|part| Some(part.first) != self.freedoms.bodies[body]);
        stiffness_along(bed, &lying, &self.balance.force, &mut stiffness);
        stiffness
    }

    fn on_body(&self, network: &Network, rest: &SystemEquilibrium, body: usize) -> Matrix6<f64> {
        let first = self.freedoms.bodies[body].unwrap_or(0);
        let stiffness = &self.along_bed(network, rest, body);
        let mut block = Matrix6::zeros();
        let follow = follows(rest, &self.freedoms, body);
        let columns: Vec<DVector<f64>> = (0..6).map(|k| stiffness.column(first + k)).collect();
        for (k, column) in columns.iter().enumerate() {
            block.set_column(k, &column.fixed_rows::<6>(first));
        }
        if follow.contains(&true) {
            let held: Vec<bool> = follow.iter().map(|follows| !follows).collect();
            let mut inner = stiffness.clone();
            inner.hold(&held, 1.0);
            let pulls = columns.into_iter().map(|mut column| {
                let zeros = column
                    .iter_mut()
                    .zip(&follow)
                    .filter(|(_, follows)| !**follows);
                zeros.for_each(|(value, _)| *value = 0.0);
                column
            });
            let pulls: Vec<DVector<f64>> = pulls.collect();
            for (k, response) in inner.solve(&pulls).into_iter().flatten().enumerate() {
                let back = stiffness.times(&response);
                let mut column = block.column_mut(k);
                column -= back.fixed_rows::<6>(first);
            }
        }
        let pose = &rest.placement.bodies[body];
        let loads = body_loads(network, &network.bodies[body], pose, LinePhysics::Full).1;
        block - loads
    }
}

/// The contacts of an equilibrium in the numbers of the unknowns of all bodies.
#[must_use]
pub fn contacts(rest: &SystemEquilibrium, all: &Freedoms) -> Vec<Contact> {
    let mut contacts = vec![Contact::None; all.count];
    let points = all.points.iter().zip(&rest.freedoms.points);
    let bodies = all.bodies.iter().zip(&rest.freedoms.bodies);
    for (here, there) in points.chain(bodies) {
        if let (Some(here), Some(there)) = (here, there) {
            contacts[here + 2] = rest.contacts[there + 2];
        }
    }
    contacts
}

/// Whether each unknown follows a body: those of free points and other free bodies, but for heights that bed or surface hold.
fn follows(rest: &SystemEquilibrium, all: &Freedoms, body: usize) -> Vec<bool> {
    let mut follows = vec![false; all.count];
    let mut add = |here: Option<usize>, there: Option<usize>, size: usize| {
        let (Some(here), Some(there)) = (here, there) else {
            return;
        };
        for k in 0..size {
            follows[here + k] = rest.contacts[there + k] == Contact::None;
        }
    };
    for (here, there) in all.points.iter().zip(&rest.freedoms.points) {
        add(*here, *there, 3);
    }
    for (index, (here, there)) in all.bodies.iter().zip(&rest.freedoms.bodies).enumerate() {
        if index != body {
            add(*here, *there, 6);
        }
    }
    follows
}

/// Rows and columns of a matrix.
#[must_use]
pub fn take(matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
        matrix[(rows[i], columns[j])]
    })
}
