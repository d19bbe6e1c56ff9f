//! The lowest eigenvalues of `K x = w M x` within an envelope, with K and M symmetric, M not negative.
//!
//! How many eigenvalues are below a bound follows from the signs of the pivots of `K - b M` (Sylvester): by bisection they are divided into
//! slices of a few, and those of each are found by Lanczos' method on `(K - s M)^-1 M` with s in the middle of the slice and all vectors kept
//! orthogonal (Ericsson and Ruhe, *Math. Comp.* 35, 1980, doi 10.1090/S0025-5718-1980-0583502-2; Grimes, Lewis and Simon, *SIAM J. Matrix
//! Anal. Appl.* 15, 1994, doi 10.1137/S0895479888151111; neither verified against the paper). It may find one vector alone of an eigenvalue that has several: what is missing is
//! sought orthogonal to what is known.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::envelope::EnvelopeMatrix;
use super::envelope_factors::{EnvelopeCholesky, EnvelopeLu};
use super::random::Random;

/// The lowest eigenvalues in ascending order, each with its vector, and a bound below which there are no others.
#[derive(Debug, Clone)]
pub struct LowestModes {
    /// Eigenvalues and vectors of unit mass.
    pub modes: Vec<(f64, DVector<f64>)>,
    /// The bound.
    pub bound: f64,
}

/// Distance of the lower end below zero, by the greatest quotient of stiffness and mass: eigenvalues that are none are above it too.
const BELOW: f64 = 1e-9;
/// Lower ends that are tried, each four times the one before.
const MOST_ENDS: i32 = 40;
/// What is above all eigenvalues, by the greatest quotient.
const ABOVE_ALL: f64 = 1e6;
/// Bisections for a bound.
const BISECTIONS: usize = 100;
/// Eigenvalues of a slice, unless it is so narrow, by its place or by the greatest quotient, that they are one.
const OF_SLICE: usize = 10;
const NARROW: [f64; 2] = [1e-10, 1e-14];
/// Where slices are halved, and the gap that is looked for there, by their width.
const CUTS: [f64; 5] = [0.5, 0.45, 0.55, 0.4, 0.6];
const GAP: f64 = 0.01;
/// Residual of a vector that counts as found.
const CONVERGED: f64 = 1e-11;
/// Vectors by the number wanted at which a search is given up.
const MOST_VECTORS: usize = 60;
/// Share of a vector that is rounding, where those known span it; of the greatest quotient, where nothing is left to be found.
const SPANNED: f64 = 1e-10;
const EXHAUSTED: f64 = 1e-13;
/// Searches in a slice for vectors that are missing.
const MOST_SEARCHES: usize = 50;

/// The lowest eigenvalues, as many as are wanted or some fewer. Nothing where the search fails: unknowns without mass that nothing holds,
/// or more eigenvalues at one place than are wanted.
#[must_use]
pub fn lowest_modes(
    stiffness: &EnvelopeMatrix,
    masses: &EnvelopeMatrix,
    wanted: usize,
) -> Option<LowestModes> {
    let pencil = Pencil::new(stiffness, masses)?;
    let whole = pencil.below_bound(wanted)?;
    let is_all = whole.high > ABOVE_ALL * pencil.greatest;
    let mut slices = Vec::new();
    pencil.divide(whole, &mut slices)?;
    if !is_all && slices.len() > 1 {
        // Its upper end need not lie in a gap.
        slices.pop();
    }
    let bound = slices.last().map(|slice| slice.high).filter(|_| !is_all);
    let mut modes = Vec::new();
    for slice in &slices {
        modes.extend(pencil.modes_of(slice)?);
    }
    Some(LowestModes {
        modes,
        bound: bound.unwrap_or(f64::INFINITY),
    })
}

/// Eigenvalue and vector.
type LowestMode = (f64, DVector<f64>);

/// How many eigenvalues there are between two bounds.
#[derive(Clone, Copy)]
struct Slice {
    low: f64,
    high: f64,
    count: usize,
}

/// Stiffness and mass.
struct Pencil<'a> {
    stiffness: &'a EnvelopeMatrix,
    masses: &'a EnvelopeMatrix,
    /// The greatest quotient of both.
    greatest: f64,
    /// What is below all eigenvalues.
    low: f64,
}

impl<'a> Pencil<'a> {
    fn new(stiffness: &'a EnvelopeMatrix, masses: &'a EnvelopeMatrix) -> Option<Self> {
        let (stiffnesses, own) = (stiffness.diagonal(), masses.diagonal());
        let pairs = stiffnesses.iter().zip(&own);
        let quotients = pairs.filter(|(_, mass)| **mass > 0.0);
        let quotients = quotients.map(|(stiffness, mass)| (stiffness / mass).abs());
        let greatest = quotients.fold(f64::MIN_POSITIVE, f64::max);
        let zeros = DVector::zeros(stiffness.size());
        let mut pencil = Self {
            stiffness,
            masses,
            greatest,
            low: 0.0,
        };
        let mut ends = (0..MOST_ENDS).map(|k| -BELOW * greatest * 4_f64.powi(k));
        let is_below = |end: &f64| EnvelopeCholesky::new(&pencil.shifted(*end), &zeros).is_some();
        pencil.low = ends.find(is_below)?;
        Some(pencil)
    }

    /// The stiffness less a multiple of the masses.
    fn shifted(&self, shift: f64) -> EnvelopeMatrix {
        let mut shifted = self.stiffness.clone();
        shifted.add_scaled(self.masses, -shift);
        shifted
    }

    /// How many eigenvalues are below a bound.
    fn count_below(&self, bound: f64) -> Option<usize> {
        Some(EnvelopeLu::new(&self.shifted(bound))?.negative_pivots())
    }

    /// The eigenvalues below a bound that about as many are below as are wanted, not more.
    fn below_bound(&self, wanted: usize) -> Option<Slice> {
        let of = |high: f64, count: usize| Slice {
            low: self.low,
            high,
            count,
        };
        let (mut low, mut high) = (self.low, self.low.abs());
        let mut count = self.count_below(high)?;
        while count <= wanted {
            if high > ABOVE_ALL * self.greatest {
                return Some(of(high, count));
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
        (known > 0).then_some(of(low, known))
    }

    /// Divides a slice into such of few eigenvalues, in ascending order: the farther a shift is from them, the more they look alike.
    fn divide(&self, slice: Slice, into: &mut Vec<Slice>) -> Option<()> {
        let Slice { low, high, count } = slice;
        let place = low.abs().max(high.abs());
        let narrow = (NARROW[0] * place).max(NARROW[1] * self.greatest);
        if count <= OF_SLICE || high - low <= narrow {
            into.extend((count > 0).then_some(slice));
            return Some(());
        }
        let (cut, below) = self.cut(low, high)?;
        let known = self.count_below(low)?;
        let lower = below.saturating_sub(known);
        self.divide(
            Slice {
                high: cut,
                count: lower,
                ..slice
            },
            into,
        )?;
        self.divide(
            Slice {
                low: cut,
                count: count.saturating_sub(lower),
                ..slice
            },
            into,
        )
    }

    /// Where to halve a slice, in a gap between eigenvalues if one is found, and how many are below.
    fn cut(&self, low: f64, high: f64) -> Option<(f64, usize)> {
        let width = high - low;
        for place in CUTS {
            let cut = low + place * width;
            let [under, over] = [cut - GAP * width, cut + GAP * width];
            let below = self.count_below(under)?;
            if self.count_below(over)? == below {
                return Some((cut, below));
            }
        }
        let cut = low + CUTS[0] * width;
        Some((cut, self.count_below(cut)?))
    }

    /// The modes of a slice in ascending order.
    fn modes_of(&self, slice: &Slice) -> Option<Vec<LowestMode>> {
        let Slice { low, high, count } = *slice;
        let shift = 0.5 * (low + high);
        let factors = EnvelopeLu::new(&self.shifted(shift))?;
        let mut modes: Vec<LowestMode> = Vec::new();
        for round in 0..MOST_SEARCHES {
            if modes.len() >= count {
                break;
            }
            let missing = count - modes.len();
            let more = self.search((shift, &factors), &modes, missing, round)?;
            let inside = more
                .into_iter()
                .filter(|(value, _)| (low..high).contains(value));
            modes.extend(inside);
        }
        modes.sort_by(|a, b| a.0.total_cmp(&b.0));
        (modes.len() == count).then_some(modes)
    }

    /// The eigenvalues nearest to a shift, as many as are wanted, with vectors orthogonal to those known.
    fn search(
        &self,
        (shift, factors): (f64, &EnvelopeLu),
        known: &[LowestMode],
        wanted: usize,
        round: usize,
    ) -> Option<Vec<LowestMode>> {
        let size = self.masses.size();
        let most = (MOST_VECTORS * wanted.max(5)).min(size);
        let mut space = Subspace::new(size, known, self.masses);
        let mut random = Random::new(1, round as u64);
        let start = DVector::from_fn(size, |_, _| random.uniform() - 0.5);
        let mut next = factors.solve(&self.masses.times(&start));
        let before = next.norm();
        space.orthogonalise(&mut next);
        if next.norm() <= SPANNED * before {
            return Some(Vec::new());
        }
        let (mut diagonal, mut beside) = (Vec::<f64>::new(), Vec::new());
        let mut check = 2 * wanted + 10;
        loop {
            let moved = self.masses.times(&next);
            let norm = next.dot(&moved).max(0.0).sqrt();
            let count = diagonal.len();
            let greatest = diagonal.iter().copied().map(f64::abs).fold(0.0, f64::max);
            let is_all = norm <= EXHAUSTED * greatest || count == size;
            if is_all || count == check || count == most {
                let found = Ritz::new(&diagonal, &beside, norm);
                let converged = found.converged.min(wanted);
                if is_all || converged == wanted {
                    return Some(space.modes(&found, converged, shift));
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
            next = factors.solve(&last);
            diagonal.push(next.dot(&last));
            space.orthogonalise(&mut next);
        }
    }
}

/// Eigenvalues and vectors of a tridiagonal matrix.
struct Ritz {
    values: Vec<f64>,
    vectors: DMatrix<f64>,
    /// The greatest first, by size.
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
        order.sort_by(|a, b| values[*b].abs().total_cmp(&values[*a].abs()));
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
struct Subspace {
    known: usize,
    count: usize,
    vectors: DMatrix<f64>,
    /// The masses times them.
    moved: DMatrix<f64>,
}

impl Subspace {
    fn new(size: usize, known: &[LowestMode], masses: &EnvelopeMatrix) -> Self {
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

    /// The first modes.
    fn modes(&self, found: &Ritz, wanted: usize, shift: f64) -> Vec<LowestMode> {
        let basis = self.vectors.columns(self.known, self.count - self.known);
        let greatest = found.order.first().map_or(0.0, |k| found.values[*k].abs());
        let first = found.order.iter().take(wanted);
        let first = first.filter(|k| found.values[**k].abs() > EXHAUSTED * greatest);
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
    use crate::envelope::number;

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
                (6..=20).contains(&found.modes.len()),
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
