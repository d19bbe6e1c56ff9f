//! The lowest eigenvalues of `K x = w M x` within an envelope, with K and M symmetric, M not negative.
//!
//! Lanczos' method on `(K - s M)^-1 M` with all vectors kept orthogonal (Ericsson and Ruhe, *Math. Comp.* 35, 1980,
//! doi 10.1090/S0025-5718-1980-0583502-2). It may find one vector alone of an eigenvalue that has several: how many eigenvalues are
//! below a bound follows from the signs of the pivots of `K - b M` (Sylvester), and what is missing is sought orthogonal to what is known.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::envelope::{EnvelopeCholesky, EnvelopeMatrix};
use super::random::Random;

/// The lowest eigenvalues in ascending order, each with its vector, and a bound below which there are no others.
#[derive(Debug, Clone)]
pub struct LowestModes {
    /// Eigenvalues and vectors of unit mass.
    pub modes: Vec<(f64, DVector<f64>)>,
    /// The bound.
    pub bound: f64,
}

/// Distance of the shift below zero, by the greatest quotient of stiffness and mass: eigenvalues that are none have factors too.
const SHIFT: f64 = 1e-9;
/// Residual of a vector that counts as found.
const CONVERGED: f64 = 1e-11;
/// Shifts that are tried, each four times the one before.
const MOST_SHIFTS: i32 = 40;
/// What is above all eigenvalues, by the greatest quotient.
const ABOVE_ALL: f64 = 1e6;
/// Bisections for a bound, and distance of the shift from the lowest eigenvalue by the width of the slice.
const BISECTIONS: usize = 100;
const NEAR: f64 = 0.05;
/// Vectors by the number wanted at which a search is given up.
const MOST_VECTORS: usize = 20;
/// Share of a vector that is rounding, where those known span it; of the greatest quotient, where nothing is left to be found.
const SPANNED: f64 = 1e-10;
const EXHAUSTED: f64 = 1e-13;
/// Searches for vectors that are missing.
const MOST_SEARCHES: usize = 50;

/// The lowest eigenvalues, about as many as are wanted. Nothing where the search fails: unknowns without mass that nothing holds, or
/// more eigenvalues at one place than are wanted.
#[must_use]
pub fn lowest_modes(
    stiffness: &EnvelopeMatrix,
    masses: &EnvelopeMatrix,
    wanted: usize,
) -> Option<LowestModes> {
    let mut pencil = Pencil::new(stiffness, masses)?;
    let slice = pencil.slice(wanted)?;
    pencil.move_to_slice(&slice)?;
    let mut modes = Vec::new();
    for round in 0..MOST_SEARCHES {
        if modes.len() >= slice.count {
            break;
        }
        let missing = slice.count - modes.len();
        let more = pencil.search(&modes, missing, round)?;
        modes.extend(more.into_iter().filter(|(value, _)| *value < slice.bound));
    }
    modes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let bound = if slice.is_all {
        f64::INFINITY
    } else {
        slice.bound
    };
    (modes.len() == slice.count).then_some(LowestModes { modes, bound })
}

/// The lowest eigenvalues: how many there are below a bound.
struct Slice {
    bound: f64,
    count: usize,
    /// Whether there are no others.
    is_all: bool,
}

/// Eigenvalue and vector.
type Mode = (f64, DVector<f64>);

/// Stiffness and mass, and the factors of the stiffness shifted below all eigenvalues.
struct Pencil<'a> {
    stiffness: &'a EnvelopeMatrix,
    masses: &'a EnvelopeMatrix,
    /// The greatest quotient of stiffness and mass.
    greatest: f64,
    shift: f64,
    factors: EnvelopeCholesky,
}

/// The stiffness less a multiple of the masses.
fn shifted(stiffness: &EnvelopeMatrix, masses: &EnvelopeMatrix, shift: f64) -> EnvelopeMatrix {
    let mut shifted = stiffness.clone();
    shifted.add_scaled(masses, -shift);
    shifted
}

impl<'a> Pencil<'a> {
    fn new(stiffness: &'a EnvelopeMatrix, masses: &'a EnvelopeMatrix) -> Option<Self> {
        let (stiffnesses, own) = (stiffness.diagonal(), masses.diagonal());
        let pairs = stiffnesses.iter().zip(&own);
        let quotients = pairs.filter(|(_, mass)| **mass > 0.0);
        let quotients = quotients.map(|(stiffness, mass)| (stiffness / mass).abs());
        let greatest = quotients.fold(f64::MIN_POSITIVE, f64::max);
        let zeros = DVector::zeros(stiffness.size());
        let shifts = (0..MOST_SHIFTS).map(|k| -SHIFT * greatest * 4_f64.powi(k));
        for shift in shifts {
            let factors = EnvelopeCholesky::new(&shifted(stiffness, masses, shift), &zeros);
            if let Some(factors) = factors {
                return Some(Self {
                    stiffness,
                    masses,
                    greatest,
                    shift,
                    factors,
                });
            }
        }
        None
    }

    /// How many eigenvalues are below a bound.
    fn count_below(&self, bound: f64) -> Option<usize> {
        shifted(self.stiffness, self.masses, bound).negative_pivots()
    }

    /// A bound that about as many eigenvalues are below as are wanted, not more.
    fn slice(&self, wanted: usize) -> Option<Slice> {
        let (mut low, mut high) = (self.shift, self.shift.abs());
        let mut count = self.count_below(high)?;
        while count <= wanted {
            if high > ABOVE_ALL * self.greatest {
                return Some(Slice {
                    bound: high,
                    count,
                    is_all: true,
                });
            }
            (low, high) = (high, 4.0 * high);
            count = self.count_below(high)?;
        }
        let mut known = 0;
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            count = self.count_below(middle)?;
            match count <= wanted {
                true => (low, known) = (middle, count),
                false => high = middle,
            }
            if count <= wanted && 5 * count >= 4 * wanted {
                break;
            }
        }
        (known > 0).then_some(Slice {
            bound: low,
            count: known,
            is_all: false,
        })
    }

    /// Moves the shift up to the lowest eigenvalue, as near as the slice is narrow: those of a slice far from the shift look all alike.
    fn move_to_slice(&mut self, slice: &Slice) -> Option<()> {
        if slice.is_all {
            return Some(());
        }
        let (mut low, mut high) = (self.shift, slice.bound);
        while high - low > NEAR * (slice.bound - low) {
            let middle = 0.5 * (low + high);
            match self.count_below(middle)? {
                0 => low = middle,
                _ => high = middle,
            }
        }
        let shift = low - NEAR * (slice.bound - low);
        let zeros = DVector::zeros(self.masses.size());
        let moved = shifted(self.stiffness, self.masses, shift);
        if let Some(factors) = EnvelopeCholesky::new(&moved, &zeros).filter(|_| shift > self.shift)
        {
            (self.shift, self.factors) = (shift, factors);
        }
        Some(())
    }

    /// The lowest eigenvalues, as many as are wanted, with vectors orthogonal to those known.
    fn search(&self, known: &[Mode], wanted: usize, round: usize) -> Option<Vec<Mode>> {
        let size = self.masses.size();
        let most = (MOST_VECTORS * wanted.max(5)).min(size);
        let mut space = Space::new(size, known, self.masses);
        let mut random = Random::new(1, round as u64);
        let start = DVector::from_fn(size, |_, _| random.uniform() - 0.5);
        let mut next = self.apply(&start);
        let before = next.norm();
        space.orthogonalise(&mut next);
        if next.norm() <= SPANNED * before {
            return Some(Vec::new());
        }
        let (mut diagonal, mut beside) = (Vec::new(), Vec::new());
        let mut check = 2 * wanted + 10;
        loop {
            let moved = self.masses.times(&next);
            let norm = next.dot(&moved).max(0.0).sqrt();
            let count = diagonal.len();
            let greatest = diagonal.iter().copied().fold(0.0, f64::max);
            let is_all = norm <= EXHAUSTED * greatest || count == size;
            if is_all || count == check || count == most {
                let found = Ritz::new(&diagonal, &beside, norm);
                if is_all || found.converged >= wanted {
                    return Some(space.modes(&found, wanted, self.shift));
                }
                if count == most {
                    return None;
                }
                check += check / 4;
            }
            if count > 0 {
                beside.push(norm);
            }
            space.push(&(next / norm), &(moved / norm));
            let last = space.last();
            next = self.factors.solve(&last);
            diagonal.push(next.dot(&last));
            space.orthogonalise(&mut next);
        }
    }

    fn apply(&self, vector: &DVector<f64>) -> DVector<f64> {
        self.factors.solve(&self.masses.times(vector))
    }
}

/// Eigenvalues and vectors of a tridiagonal matrix.
struct Ritz {
    values: Vec<f64>,
    vectors: DMatrix<f64>,
    /// The greatest first.
    order: Vec<usize>,
    /// How many of the first have converged.
    converged: usize,
}

impl Ritz {
    /// For this norm of the vector that would be next.
    fn new(diagonal: &[f64], beside: &[f64], norm: f64) -> Self {
        let count = diagonal.len();
        let mut matrix = DMatrix::zeros(count, count);
        for (k, value) in diagonal.iter().enumerate() {
            matrix[(k, k)] = *value;
        }
        for (k, value) in beside.iter().enumerate() {
            (matrix[(k, k + 1)], matrix[(k + 1, k)]) = (*value, *value);
        }
        let eigen = SymmetricEigen::new(matrix);
        let values: Vec<f64> = eigen.eigenvalues.iter().copied().collect();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
        let vectors = eigen.eigenvectors;
        let residual = |k: usize| norm * vectors[(count - 1, k)].abs();
        let is_found = |k: &&usize| residual(**k) <= CONVERGED * values[**k].abs();
        let converged = order.iter().take_while(is_found).count();
        Self {
            values,
            vectors,
            order,
            converged,
        }
    }
}

/// Vectors of unit mass that are orthogonal by mass, known ones first.
struct Space {
    known: usize,
    count: usize,
    vectors: DMatrix<f64>,
    /// The masses times them.
    moved: DMatrix<f64>,
}

impl Space {
    fn new(size: usize, known: &[Mode], masses: &EnvelopeMatrix) -> Self {
        let mut space = Self {
            known: known.len(),
            count: 0,
            vectors: DMatrix::zeros(size, 0),
            moved: DMatrix::zeros(size, 0),
        };
        for (_, vector) in known {
            space.push(vector, &masses.times(vector));
        }
        space
    }

    fn push(&mut self, vector: &DVector<f64>, moved: &DVector<f64>) {
        if self.count == self.vectors.ncols() {
            let more = (2 * self.count).max(16);
            for matrix in [&mut self.vectors, &mut self.moved] {
                *matrix = std::mem::take(matrix).resize_horizontally(more, 0.0);
            }
        }
        self.vectors.set_column(self.count, vector);
        self.moved.set_column(self.count, moved);
        self.count += 1;
    }

    /// The masses times the last vector.
    fn last(&self) -> DVector<f64> {
        self.moved.column(self.count - 1).into_owned()
    }

    /// Takes from a vector what is along those of the space; twice is enough.
    fn orthogonalise(&self, vector: &mut DVector<f64>) {
        let mut along = DVector::zeros(self.count);
        for _ in 0..2 {
            along.gemv_tr(1.0, &self.moved.columns(0, self.count), vector, 0.0);
            vector.gemv(-1.0, &self.vectors.columns(0, self.count), &along, 1.0);
        }
    }

    /// The first modes in ascending order.
    fn modes(&self, found: &Ritz, wanted: usize, shift: f64) -> Vec<Mode> {
        let basis = self.vectors.columns(self.known, self.count - self.known);
        let greatest = found.order.first().map_or(0.0, |k| found.values[*k]);
        let first = found.order.iter().take(wanted);
        let first = first.filter(|k| found.values[**k] > EXHAUSTED * greatest);
        first
            .map(|k| {
                let vector = basis * found.vectors.column(*k);
                (shift + 1.0 / found.values[*k], vector)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::numerics::envelope::number;

    /// Masses on springs in a row, each moving in three directions of which two are alike; every fifth has no mass.
    fn chain(nodes: usize, grounded: f64) -> (EnvelopeMatrix, EnvelopeMatrix) {
        let near = |k: usize| [k.checked_sub(1), (k + 1 < nodes).then_some(k + 1)];
        let neighbours: Vec<Vec<usize>> = (0..nodes)
            .map(|k| near(k).into_iter().flatten().collect())
            .collect();
        let (begins, shape) = number(&neighbours, &vec![3; nodes]);
        let shape = Arc::new(shape);
        let [mut stiffness, mut masses] = [(); 2].map(|()| EnvelopeMatrix::zeros(&shape));
        for k in 0..nodes {
            for (direction, spring) in [1.0, 1.0, 70.0].into_iter().enumerate() {
                let at = begins[k] + direction;
                stiffness.add(at, at, grounded);
                if k % 5 != 4 {
                    masses.add(at, at, 2.0);
                }
                if k + 1 < nodes {
                    let next = begins[k + 1] + direction;
                    for (i, j, sign) in [
                        (at, at, 1.0),
                        (next, next, 1.0),
                        (at, next, -1.0),
                        (next, at, -1.0),
                    ] {
                        stiffness.add(i, j, sign * spring);
                    }
                }
            }
        }
        (stiffness, masses)
    }

    /// All of them, densely: by `M x = (1/(w - s)) (K - s M) x`, as some unknowns have no mass.
    fn all(stiffness: &EnvelopeMatrix, masses: &EnvelopeMatrix, shift: f64) -> Vec<f64> {
        let shifted = stiffness.dense() - masses.dense() * shift;
        let inverse = shifted.cholesky().unwrap().l().try_inverse().unwrap();
        let eigen = SymmetricEigen::new(&inverse * masses.dense() * inverse.transpose());
        let finite = eigen.eigenvalues.iter().filter(|value| **value > 1e-9);
        let mut values: Vec<f64> = finite.map(|value| shift + 1.0 / value).collect();
        values.sort_by(f64::total_cmp);
        values
    }

    #[test]
    fn the_lowest_are_found_each_as_often_as_it_is_there() {
        for grounded in [0.1, 0.0, -0.3] {
            let (stiffness, masses) = chain(120, grounded);
            let wanted = all(&stiffness, &masses, -1.0);
            let found = lowest_modes(&stiffness, &masses, 20).unwrap();
            assert!(
                (15..=20).contains(&found.modes.len()),
                "{}",
                found.modes.len()
            );
            for ((value, vector), wanted) in found.modes.iter().zip(&wanted) {
                assert!((value - wanted).abs() < 1e-10, "{value} for {wanted}");
                let left = stiffness.times(vector) - masses.times(vector) * *value;
                assert!(
                    left.amax() < 1e-8 && (vector.dot(&masses.times(vector)) - 1.0).abs() < 1e-9
                );
            }
            let below = wanted.iter().filter(|value| **value < found.bound);
            assert_eq!(below.count(), found.modes.len());
        }
    }

    #[test]
    fn all_are_found_where_there_are_fewer_than_wanted() {
        let (stiffness, masses) = chain(4, 1.0);
        let wanted = all(&stiffness, &masses, -1.0);
        let found = lowest_modes(&stiffness, &masses, 40).unwrap();
        assert_eq!(found.modes.len(), wanted.len());
        for ((value, _), wanted) in found.modes.iter().zip(&wanted) {
            assert!((value - wanted).abs() < 1e-10, "{value} for {wanted}");
        }
    }

    #[test]
    fn what_has_no_mass_and_no_hold_has_no_modes() {
        let (stiffness, masses) = chain(5, 0.0);
        let nothing = EnvelopeMatrix::zeros(&stiffness.shape());
        assert!(lowest_modes(&nothing, &nothing, 3).is_none());
        assert!(lowest_modes(&stiffness, &masses, 3).is_some());
    }
}
