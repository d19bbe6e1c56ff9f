//! Natural periods of bodies on their lines: `K x = w² M x` about the equilibrium.
//!
//! K is the exact stiffness of lines, hydrostatics and weights, condensed onto the bodies that have a mass; M their mass and inertia with the
//! added mass given. The lines bring no inertia here, and free points follow at once.

use nalgebra::{DMatrix, DVector, Matrix6, SymmetricEigen};

use super::super::balance::balance;
use super::super::bounds::Contact;
use super::super::equilibrium::Equilibrium;
use super::super::freedoms::{Freedoms, UnknownBodies};
use super::super::line_at_rest::LinePhysics;
use super::super::network::{Body, Network};
use super::super::pose::{Pose, cross};
use super::super::stiffness::take;

/// A natural mode of the bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyMode {
    /// Period \[s\]; infinite where nothing restores, nothing where the motion grows.
    pub period_s: Option<f64>,
    /// The body and the direction from 0 to 5 that move most.
    pub most: (usize, usize),
}

/// The natural modes of the bodies that have a mass, the longest period first; none where no body has one.
///
/// # Errors
/// A body with a mass and no inertia; a line without a solution.
pub fn periods(network: &Network, rest: &Equilibrium) -> Result<Vec<BodyMode>, String> {
    let massive: Vec<usize> = (0..network.bodies.len())
        .filter(|b| network.bodies[*b].mass > 0.0)
        .collect();
    let all = Freedoms::of(network, UnknownBodies::All);
    let placement = &rest.placement;
    let lines = Some(rest.balance.lines.as_slice());
    let balance = balance(network, &all, placement, LinePhysics::Full, lines)
        .map_err(|unsolved| unsolved.why)?;
    let own: Vec<usize> = massive
        .iter()
        .filter_map(|body| all.bodies[*body])
        .flat_map(|first| first..first + 6)
        .collect();
    if own.is_empty() {
        return Ok(Vec::new());
    }
    let points = all.points.iter().zip(&rest.freedoms.points);
    let free = points.filter_map(|(here, there)| Some((here.as_ref()?, there.as_ref()?)));
    let inner: Vec<usize> = free
        .flat_map(|(here, there)| {
            let moves = (0..3).filter(|k| rest.contacts[there + k] == Contact::None);
            moves.map(move |k| here + k).collect::<Vec<_>>()
        })
        .collect();
    let stiffness = balance.symmetric();
    let mut condensed = take(&stiffness, &own, &own);
    if !inner.is_empty()
        && let Some(response) = take(&stiffness, &inner, &inner)
            .lu()
            .solve(&take(&stiffness, &inner, &own))
    {
        condensed -= take(&stiffness, &own, &inner) * response;
    }
    let mut masses = DMatrix::zeros(own.len(), own.len());
    for (k, body) in massive.iter().enumerate() {
        let block = mass_matrix(&network.bodies[*body], &placement.bodies[*body]);
        masses.view_mut((6 * k, 6 * k), (6, 6)).copy_from(&block);
    }
    modes(&condensed, &masses, &massive)
}

fn modes(
    stiffness: &DMatrix<f64>,
    masses: &DMatrix<f64>,
    bodies: &[usize],
) -> Result<Vec<BodyMode>, String> {
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
    let mut found: Vec<(f64, BodyMode)> = Vec::new();
    for (k, value) in eigen.eigenvalues.iter().enumerate() {
        // Shares of the kinetic energy tell which direction a mode is mostly of.
        let shape: DVector<f64> = eigen.eigenvectors.column(k).into_owned();
        let most = shape.iamax();
        let period_s = if value.abs() <= 1e-12 * greatest {
            Some(f64::INFINITY)
        } else {
            (*value > 0.0).then(|| std::f64::consts::TAU / value.sqrt())
        };
        found.push((
            *value,
            BodyMode {
                period_s,
                most: (bodies[most / 6], most % 6),
            },
        ));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(found.into_iter().map(|(_, mode)| mode).collect())
}

/// Mass, inertia and added mass of a body about its origin, in the axes of the earth \[kg, kg m, kg m²\].
#[must_use]
pub fn mass_matrix(body: &Body, pose: &Pose) -> Matrix6<f64> {
    let arm = pose.arm(&body.centre_of_gravity);
    let turn = pose.matrix();
    let inertia = turn.matrix() * body.inertia * turn.matrix().transpose();
    let lever = cross(&arm) * body.mass;
    let mut mass = body.added_mass;
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
