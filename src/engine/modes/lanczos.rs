//! The lowest eigenpairs of a line's pencil.
//!
//! Shift-invert Lanczos with several start vectors (Ruhe 1979, band Lanczos): the basis of
//! `A = (K - sigma M)^-1 M` grows by one vector a solve, made orthogonal against all earlier ones in the inner product of M,
//! twice. Several start vectors find eigenvalues that occur several times (a hanging line moves alike along x and y). An
//! eigenvalue of A is `1 / (lambda - sigma)`: with sigma below all of them, the lowest modes come first. That none
//! is missing is counted: K - mu M has as many negative pivots as there are eigenvalues below mu.

use nalgebra::{DMatrix, SymmetricEigen};

use super::ModePencil;
use crate::numerics::V3;

/// Start vectors: eigenvalues may occur as often.
const BLOCK: usize = 4;
/// Additional vectors, so that clustered eigenvalues are found together.
const BEYOND: usize = 2;
/// Relative residual of an accepted eigenpair; its eigenvalue is accurate to the square of this.
const ACCURACY: f64 = 1e-7;
/// Relative distance above the highest wanted eigenvalue at which the count is checked.
const MARGIN: f64 = 1e-4;

/// An eigenvalue and its vector.
#[derive(Debug, Clone, PartialEq)]
pub struct Eigenpair {
    /// omega² \[rad²/s²\]; negative where the line at rest is not stable.
    pub value: f64,
    /// Displacements of all nodes, `x' M x = 1` \[kg^-1/2\]; zero at prescribed nodes.
    pub vector: Vec<V3>,
}

/// Why the eigenproblem was not solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum EigenError {
    /// There is no free node.
    #[error("nothing of the line moves: give it more segments")]
    NothingMoves,
    /// The matrix could not be factored at any shift.
    #[error(
        "the stiffness of the line at rest is not finite, or its range is too wide for 16 digits"
    )]
    Singular,
    /// The iteration did not converge.
    #[error("only {found} of {wanted} modes converged in {solves} solutions")]
    Slow {
        /// Converged pairs.
        found: usize,
        /// Wanted pairs.
        wanted: usize,
        /// Solutions made.
        solves: usize,
    },
}

/// The `count` lowest eigenpairs, or all there are, from the lowest up; possibly a few more.
///
/// # Errors
/// [`EigenError`].
pub fn lowest(pencil: &mut ModePencil, count: usize) -> Result<Vec<Eigenpair>, EigenError> {
    let size = 3 * pencil.free().len();
    if size == 0 {
        return Err(EigenError::NothingMoves);
    }
    let wanted = (count.max(1) + BEYOND).min(size);
    let shift = shift_below_all(pencil)?;
    let mut band = KrylovBasis::new(pencil, shift, size);
    let most = size.min(8 * wanted + 80);
    let mut found = 0;
    while band.solved < most && band.grow(pencil)? {
        let due = band.solved >= wanted + BLOCK && band.solved.is_multiple_of(BLOCK);
        if due || band.solved == size {
            let (pairs, good) = band.pairs(wanted);
            found = good;
            if good >= wanted && none_missing(pencil, &pairs, wanted) {
                return Ok(band.vectors(&pairs[..wanted]));
            }
        }
    }
    // An exhausted space holds every pair, however they converged.
    let (pairs, good) = band.pairs(wanted);
    if good >= wanted.min(band.solved) && (band.solved == size || band.exhausted()) {
        return Ok(band.vectors(&pairs[..good.min(wanted)]));
    }
    Err(EigenError::Slow {
        found,
        wanted: count,
        solves: band.solved,
    })
}

/// A shift below every eigenvalue: 0 for a stable line.
fn shift_below_all(pencil: &mut ModePencil) -> Result<f64, EigenError> {
    let mut shift = 0.0;
    let step = 1e-12 * pencil.highest();
    for power in 0..9 {
        if pencil.count_below(shift) == Ok(0) {
            return Ok(shift);
        }
        shift = -step * 100_f64.powi(power);
    }
    Err(EigenError::Singular)
}

/// Whether the number of eigenvalues below a bound just above the highest wanted one is that of the pairs found.
fn none_missing(pencil: &mut ModePencil, pairs: &[RitzPair], wanted: usize) -> bool {
    let highest = pairs[wanted - 1].value;
    let above = highest + MARGIN * highest.abs();
    let here = pairs.iter().filter(|pair| pair.value < above).count();
    pencil.count_below(above).is_ok_and(|below| below == here)
}

/// A Ritz pair: eigenvalue, vector in the basis, relative residual.
struct RitzPair {
    value: f64,
    weights: Vec<f64>,
    left: f64,
}

/// The growing basis, and the image of A in it.
struct KrylovBasis {
    shift: f64,
    basis: Vec<Vec<V3>>,
    /// `columns[j][i]`: the part of A times vector j along vector i.
    columns: Vec<Vec<f64>>,
    solved: usize,
}

impl KrylovBasis {
    fn new(pencil: &ModePencil, shift: f64, size: usize) -> Self {
        let mut band = Self {
            shift,
            basis: Vec::new(),
            columns: Vec::new(),
            solved: 0,
        };
        let mut numbers = Xorshift(0x9E37_79B9_7F4A_7C15);
        for _ in 0..BLOCK.min(size) {
            let mut start = vec![V3::zeros(); pencil.nodes()];
            for i in pencil.free() {
                start[i] = V3::from_fn(|_, _| numbers.next());
            }
            band.add(pencil, start);
        }
        band
    }

    /// Whether every vector of the basis has been multiplied by A.
    fn exhausted(&self) -> bool {
        self.solved == self.basis.len()
    }

    /// Multiplies the next vector of the basis by A; false if there is none.
    fn grow(&mut self, pencil: &mut ModePencil) -> Result<bool, EigenError> {
        if self.exhausted() {
            return Ok(false);
        }
        let mut image = vec![V3::zeros(); pencil.nodes()];
        pencil.multiply_mass(&self.basis[self.solved], &mut image);
        pencil
            .solve(self.shift, &mut image)
            .map_err(|_| EigenError::Singular)?;
        let column = self.add(pencil, image);
        self.columns.push(column);
        self.solved += 1;
        Ok(true)
    }

    /// Orthogonalises a vector and adds it to the basis; returns its components along the basis.
    fn add(&mut self, pencil: &ModePencil, mut vector: Vec<V3>) -> Vec<f64> {
        let before = pencil.mass_product(&vector, &vector).sqrt();
        let mut parts = vec![0.0; self.basis.len()];
        for _ in 0..2 {
            for (part, other) in parts.iter_mut().zip(&self.basis) {
                let along = pencil.mass_product(other, &vector);
                *part += along;
                for (x, o) in vector.iter_mut().zip(other) {
                    *x -= o * along;
                }
            }
        }
        let beyond = pencil.mass_product(&vector, &vector).sqrt();
        if beyond > 1e-12 * before {
            for x in &mut vector {
                *x /= beyond;
            }
            parts.push(beyond);
            self.basis.push(vector);
        }
        parts
    }

    /// The Ritz pairs, lowest first, and how many of the first `wanted` have converged.
    fn pairs(&self, wanted: usize) -> (Vec<RitzPair>, usize) {
        let n = self.solved;
        let part = |j: usize, i: usize| self.columns[j].get(i).copied().unwrap_or(0.0);
        let image = DMatrix::from_fn(n, n, |i, j| 0.5 * (part(j, i) + part(i, j)));
        let eigen = SymmetricEigen::new(image);
        let ritz = |k: usize| {
            let weights: Vec<f64> = eigen.eigenvectors.column(k).iter().copied().collect();
            let outside = n..self.basis.len();
            let left = outside.map(|i| {
                let along = weights.iter().enumerate().map(|(j, w)| w * part(j, i));
                along.sum::<f64>().powi(2)
            });
            let theta = eigen.eigenvalues[k];
            RitzPair {
                value: self.shift + 1.0 / theta,
                left: left.sum::<f64>().sqrt() / theta.abs(),
                weights,
            }
        };
        let mut pairs: Vec<RitzPair> = (0..n)
            .filter(|k| eigen.eigenvalues[*k] > 0.0)
            .map(ritz)
            .collect();
        pairs.sort_by(|a, b| a.value.total_cmp(&b.value));
        let good = pairs.iter().take(wanted).take_while(|p| p.left < ACCURACY);
        let good = good.count();
        (pairs, good)
    }

    fn vectors(&self, pairs: &[RitzPair]) -> Vec<Eigenpair> {
        let combine = |pair: &RitzPair| {
            let mut vector = vec![V3::zeros(); self.basis[0].len()];
            for (weight, basis) in pair.weights.iter().zip(&self.basis) {
                for (x, b) in vector.iter_mut().zip(basis) {
                    *x += b * *weight;
                }
            }
            Eigenpair {
                value: pair.value,
                vector,
            }
        };
        pairs.iter().map(combine).collect()
    }
}

/// Numbers between -1 and 1 that look random and are the same every time (xorshift).
struct Xorshift(u64);

impl Xorshift {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
