//! The ship as a rigid body: matrices of mass, added mass, damping and hydrostatic restoring, eq. (4) of the ropeway paper, and
//! their validation.

use nalgebra::{Matrix3, Matrix6, SymmetricEigen};

use super::model::{Hull, HullKeys};
use crate::case::Finding;
use crate::case::schema::TableType;
use crate::numerics::{M3, V3};

/// Matrices about the reference point in ship axes: surge, sway, heave, roll, pitch, yaw.
#[derive(Debug, Clone, PartialEq)]
pub struct HullMatrices {
    /// Rigid-body and added mass \[kg, kg m, kg m²\].
    pub mass: Matrix6<f64>,
    /// The added mass of it.
    pub added_mass: Matrix6<f64>,
    /// Linear damping, without that of wind and current.
    pub damping: Matrix6<f64>,
    /// Restoring stiffness, without the mooring.
    pub restoring: Matrix6<f64>,
}

impl HullMatrices {
    /// The matrices of a hull that has passed validation.
    #[must_use]
    pub fn of_hull(hull: &Hull) -> Self {
        let matrix = |list: &[f64]| matrix(list).unwrap_or_else(Matrix6::zeros);
        let added_mass = matrix(&hull.added_mass_si);
        Self {
            mass: rigid_body_mass(hull) + added_mass,
            added_mass,
            damping: matrix(&hull.damping_si),
            restoring: matrix(&hull.restoring_si),
        }
    }

    /// Rows and columns of surge, sway and yaw.
    #[must_use]
    pub fn planar(matrix: &Matrix6<f64>) -> Matrix3<f64> {
        const PLANAR: [usize; 3] = [0, 1, 5];
        Matrix3::from_fn(|i, j| matrix[(PLANAR[i], PLANAR[j])])
    }
}

/// Rigid-body mass matrix about the reference point: `[m, -m S(g); m S(g), I - m S(g)²]`, I the inertia about the centre of gravity g.
fn rigid_body_mass(hull: &Hull) -> Matrix6<f64> {
    let m = hull.mass_kg;
    let centre: M3 = V3::from(hull.centre_m).cross_matrix();
    let inertia = M3::from_diagonal(&V3::from(hull.gyration_m).map(|k| m * k * k));
    let mut mass = Matrix6::zeros();
    let mut put = |i: usize, j: usize, block: M3| {
        mass.fixed_view_mut::<3, 3>(3 * i, 3 * j).copy_from(&block);
    };
    put(0, 0, M3::identity() * m);
    put(0, 1, centre * -m);
    put(1, 0, centre * m);
    put(1, 1, inertia - centre * centre * m);
    mass
}

/// A matrix from an empty list, its diagonal, or its rows.
fn matrix(list: &[f64]) -> Option<Matrix6<f64>> {
    match list.len() {
        0 => Some(Matrix6::zeros()),
        6 => Some(Matrix6::from_diagonal(&nalgebra::Vector6::from_row_slice(
            list,
        ))),
        36 => Some(Matrix6::from_row_slice(list)),
        _ => None,
    }
}

/// Matrices that are not physical; a coupled analysis needs restoring in heave, roll and pitch.
pub(super) fn check(keys: &HullKeys<'_>, coupled: bool) -> Vec<Finding> {
    let (added_mass, damping, restoring) =
        (&keys.added_mass_si, &keys.damping_si, &keys.restoring_si);
    let lists = [added_mass, damping, restoring];
    let wrong_length = lists.into_iter().filter_map(|key| {
        let list = key.get().filter(|list| matrix(list).is_none())?;
        Some(key.finding(
            format!("holds {} numbers", list.len()),
            "give six for the diagonal (surge, sway, heave, roll, pitch, yaw), or thirty-six by rows",
        ))
    });
    let mut found: Vec<Finding> = wrong_length.collect();
    if !found.is_empty() || lists.iter().any(|key| key.is_faulty()) {
        return found;
    }
    let Ok(hull) = Hull::from_keys(keys) else {
        return found;
    };
    let all = HullMatrices::of_hull(&hull);
    if asymmetry(&all.mass) > 1e-9 {
        found.push(added_mass.finding(
            "is not symmetric",
            "give a matrix that equals its transpose",
        ));
    } else if all.mass.cholesky().is_none() {
        found.push(added_mass.finding(
            "the sum of mass and added mass is not positive definite",
            "give added mass that is positive semidefinite",
        ));
    }
    if smallest_eigenvalue(&all.damping) < -1e-9 * all.damping.abs().max() {
        found.push(damping.finding(
            "feeds energy into some motion: its symmetric part is not positive semidefinite",
            "give damping that is not negative in any motion",
        ));
    }
    let upright = all.restoring.fixed_view::<3, 3>(2, 2).into_owned();
    let symmetric = (upright + upright.transpose()) * 0.5;
    if coupled && symmetric.cholesky().is_none() {
        found.push(restoring.finding(
            "is not positive definite in heave, roll and pitch",
            "give positive restoring in heave, roll and pitch: otherwise the ship sinks or capsizes",
        ));
    }
    found
}

/// Asymmetry of a matrix relative to its diagonal.
fn asymmetry(matrix: &Matrix6<f64>) -> f64 {
    let scale = |i: usize, j: usize| (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt();
    let off = |i: usize, j: usize| {
        (matrix[(i, j)] - matrix[(j, i)]).abs() / scale(i, j).max(f64::MIN_POSITIVE)
    };
    let pairs = (0..6).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs.map(|(i, j)| off(i, j)).fold(0.0, f64::max)
}

/// The smallest eigenvalue of the symmetric part.
fn smallest_eigenvalue(matrix: &Matrix6<f64>) -> f64 {
    let symmetric = (matrix + matrix.transpose()) * 0.5;
    SymmetricEigen::new(symmetric).eigenvalues.min()
}
