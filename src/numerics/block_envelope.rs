//! A sparse system of 3 x 3 blocks, not necessarily symmetric, with symmetric places: LU factors within its envelope, from the first
//! block of each row that is not zero to the diagonal, and likewise by columns. Numbered from neighbour to neighbour
//! ([`from_neighbour_to_neighbour`](super::envelope::from_neighbour_to_neighbour)) the work of a chain or net grows with its size.
//! Blocks are factored without pivoting between them, as in [`BlockBand`](super::BlockBand).

use nalgebra::{Matrix3, Vector3};

use super::SingularBlock;
use super::block_band::is_regular;
use super::lanes::Pivot;
use super::lu::{Lu, minus_applied, minus_product};

/// The matrix, and then its factors in its place; allocates in [`BlockEnvelope::new`] only.
#[derive(Debug, Clone)]
pub struct BlockEnvelope<T: Pivot = f64> {
    /// First column of each row, which is the first row of each column as well.
    first: Vec<usize>,
    /// Where the blocks of a row or column begin.
    start: Vec<usize>,
    diag: Vec<Matrix3<T>>,
    /// Blocks left of the diagonal, row by row.
    lower: Vec<Matrix3<T>>,
    /// Blocks above the diagonal, column by column.
    upper: Vec<Matrix3<T>>,
    pivots: Vec<Lu<T>>,
    negative_pivots: usize,
}

impl<T: Pivot> BlockEnvelope<T> {
    /// A zero matrix; `first` is the first column of each row, its own at most.
    #[must_use]
    pub fn new(first: Vec<usize>) -> Self {
        let mut start = Vec::with_capacity(first.len());
        let mut blocks = 0;
        for (row, column) in first.iter().enumerate() {
            start.push(blocks);
            blocks += row - column;
        }
        let n = first.len();
        let zero = Self::zero();
        Self {
            first,
            start,
            diag: vec![zero; n],
            lower: vec![zero; blocks],
            upper: vec![zero; blocks],
            pivots: vec![Lu::new(&Self::zero()); n],
            negative_pivots: 0,
        }
    }

    #[inline(always)]
    fn zero() -> Matrix3<T> {
        Matrix3::repeat(T::from(0.0))
    }

    /// Sets all blocks to zero.
    pub fn clear(&mut self) {
        let zero = Self::zero();
        self.diag.fill(zero);
        self.lower.fill(zero);
        self.upper.fill(zero);
    }

    /// Sets the matrix to the sum of others of the same envelope, each times its factor.
    pub fn set_to_sum(&mut self, parts: &[(T, &BlockEnvelope<f64>)]) {
        self.clear();
        for (factor, part) in parts {
            self.add(part, *factor);
        }
    }

    /// Adds another matrix of the same envelope, times a factor.
    pub fn add(&mut self, other: &BlockEnvelope<f64>, factor: T) {
        let add = |sum: &mut [Matrix3<T>], part: &[Matrix3<f64>]| {
            for (sum, block) in sum.iter_mut().zip(part) {
                *sum += block.map(|entry| T::from(entry) * factor);
            }
        };
        add(&mut self.diag, &other.diag);
        add(&mut self.lower, &other.lower);
        add(&mut self.upper, &other.upper);
    }

    /// A block on the diagonal.
    #[must_use]
    pub fn diagonal(&self, row: usize) -> Matrix3<T> {
        self.diag[row]
    }

    /// The block of a row and a column within the envelope.
    pub fn block(&mut self, row: usize, column: usize) -> &mut Matrix3<T> {
        match row.cmp(&column) {
            std::cmp::Ordering::Equal => &mut self.diag[row],
            std::cmp::Ordering::Greater => {
                &mut self.lower[self.start[row] + column - self.first[row]]
            }
            std::cmp::Ordering::Less => {
                &mut self.upper[self.start[column] + row - self.first[column]]
            }
        }
    }

    /// Solves for a right-hand side, which becomes the solution; the matrix becomes its factors.
    ///
    /// # Errors
    /// [`SingularBlock`] when a pivot vanishes or is not finite.
    pub fn solve(&mut self, r: &mut [Vector3<T>]) -> Result<(), SingularBlock> {
        self.negative_pivots = 0;
        for i in 0..self.first.len() {
            self.eliminate(i);
            let lu = Lu::new(&self.diag[i]);
            if !is_regular(&self.diag[i], &lu) {
                return Err(SingularBlock { node: i });
            }
            self.negative_pivots += lu.pivots.iter().filter(|p| p.is_negative()).count();
            let mut right = r[i];
            for (k, block) in (self.first[i]..i).zip(&self.lower[self.start[i]..]) {
                right = minus_applied(right, block, &r[k]);
            }
            r[i] = lu.solve(&right);
            self.pivots[i] = lu;
        }
        self.substitute_back(r);
        Ok(())
    }

    /// Solves for another right-hand side with the factors of the matrix solved last.
    pub fn solve_again(&self, r: &mut [Vector3<T>]) {
        for i in 0..self.first.len() {
            let mut right = r[i];
            for (k, block) in (self.first[i]..i).zip(&self.lower[self.start[i]..]) {
                right = minus_applied(right, block, &r[k]);
            }
            r[i] = self.pivots[i].solve(&right);
        }
        self.substitute_back(r);
    }

    fn substitute_back(&self, r: &mut [Vector3<T>]) {
        for i in (0..self.first.len()).rev() {
            let found = r[i];
            for (k, block) in (self.first[i]..i).zip(&self.upper[self.start[i]..]) {
                r[k] = minus_applied(r[k], block, &found);
            }
        }
    }

    /// How many pivots of the matrix solved last were negative.
    #[must_use]
    pub fn negative_pivots(&self) -> usize {
        self.negative_pivots
    }

    /// Row i of the lower and column i of the upper factor, and the diagonal block left over.
    fn eliminate(&mut self, i: usize) {
        let (from, start) = (self.first[i], self.start[i]);
        for j in from..i {
            let (other, other_start) = (self.first[j], self.start[j]);
            let common = from.max(other);
            let (mut left, mut above) =
                (self.lower[start + j - from], self.upper[start + j - from]);
            for k in common..j {
                let (ik, jk) = (start + k - from, other_start + k - other);
                left = minus_product(left, &self.lower[ik], &self.upper[jk]);
                above = minus_product(above, &self.lower[jk], &self.upper[ik]);
            }
            above = self.pivots[j].solve_block(&above);
            self.lower[start + j - from] = left;
            self.upper[start + j - from] = above;
            self.diag[i] = minus_product(self.diag[i], &left, &above);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{M3, V3};
    use nalgebra::{Complex, DMatrix, DVector};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn agrees_with_a_dense_factorisation(
            reach in proptest::collection::vec(0usize..5, 1..9),
            entries in proptest::collection::vec(-1.0f64..1.0, 97),
        ) {
            let first: Vec<usize> =
                reach.iter().enumerate().map(|(i, back)| i.saturating_sub(*back)).collect();
            let n = first.len();
            let mut matrix = BlockEnvelope::new(first.clone());
            let mut dense = DMatrix::zeros(3 * n, 3 * n);
            let mut next = entries.iter().copied().cycle();
            for (i, from) in first.iter().enumerate() {
                for j in *from..=i {
                    for (row, column) in [(i, j), (j, i)] {
                        let mut block = M3::from_fn(|_, _| next.next().unwrap());
                        if i == j {
                            block += M3::identity() * 20.0;
                        }
                        *matrix.block(row, column) = block;
                        dense.fixed_view_mut::<3, 3>(3 * row, 3 * column).copy_from(&block);
                    }
                }
            }
            let mut x: Vec<V3> = (0..n).map(|i| V3::new(i as f64, 1.0, -2.0)).collect();
            let right = DVector::from_iterator(3 * n, x.iter().flatten().copied());
            let expected = dense.lu().solve(&right).unwrap();
            matrix.solve(&mut x).unwrap();
            let mut again: Vec<V3> = (0..n).map(|i| V3::new(i as f64, 1.0, -2.0)).collect();
            matrix.solve_again(&mut again);
            for (k, value) in expected.iter().enumerate() {
                prop_assert!((x[k / 3][k % 3] - value).abs() < 1e-12);
                prop_assert!((again[k / 3][k % 3] - value).abs() < 1e-12);
            }
        }
    }

    /// A sum of real matrices, one of them times the imaginary unit, against the real system of twice the size.
    #[test]
    fn a_complex_system_is_two_real_ones() {
        let first = vec![0, 0, 1, 0];
        let n = first.len();
        let mut next = (0..).map(|k| f64::from(k * 7919 % 101) / 101.0 - 0.5);
        let mut parts = [(); 2].map(|()| BlockEnvelope::new(first.clone()));
        let mut dense = DMatrix::zeros(6 * n, 6 * n);
        for (i, from) in first.iter().enumerate() {
            for j in *from..=i {
                for (row, column) in [(i, j), (j, i)] {
                    let mut blocks = [(); 2].map(|()| M3::from_fn(|_, _| next.next().unwrap()));
                    if i == j {
                        blocks[0] += M3::identity() * 9.0;
                    }
                    for (part, block) in parts.iter_mut().zip(&blocks) {
                        *part.block(row, column) = *block;
                    }
                    let [real, imaginary] = blocks;
                    for (down, across, block) in [
                        (0, 0, real),
                        (n, n, real),
                        (n, 0, imaginary),
                        (0, n, -imaginary),
                    ] {
                        let at = (3 * (row + down), 3 * (column + across));
                        dense.fixed_view_mut::<3, 3>(at.0, at.1).copy_from(&block);
                    }
                }
            }
        }
        let right = DVector::from_fn(6 * n, |k, _| k as f64 - 4.0);
        let expected = dense.lu().solve(&right).unwrap();
        let mut matrix = BlockEnvelope::new(first);
        let factors = [Complex::from(1.0), Complex::i()];
        matrix.set_to_sum(&[(factors[0], &parts[0]), (factors[1], &parts[1])]);
        let value = |k: usize| Complex::new(right[k], right[3 * n + k]);
        let mut x: Vec<Vector3<Complex<f64>>> = (0..n)
            .map(|i| Vector3::from_fn(|r, _| value(3 * i + r)))
            .collect();
        matrix.solve(&mut x).unwrap();
        for k in 0..3 * n {
            let found = x[k / 3][k % 3];
            assert!((found.re - expected[k]).abs() < 1e-12);
            assert!((found.im - expected[3 * n + k]).abs() < 1e-12);
        }
    }

    #[test]
    fn a_singular_block_is_named() {
        let mut matrix = BlockEnvelope::new(vec![0, 0]);
        *matrix.block(0, 0) = M3::identity();
        let solved = matrix.solve(&mut [V3::zeros(); 2]);
        assert_eq!(solved, Err(SingularBlock { node: 1 }));
    }
}
