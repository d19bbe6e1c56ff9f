//! A sparse system of 3 x 3 blocks, not necessarily symmetric, with symmetric places: LU factors within its envelope, from the first
//! block of each row that is not zero to the diagonal, and likewise by columns. Numbered from neighbour to neighbour
//! ([`from_neighbour_to_neighbour`](super::envelope::from_neighbour_to_neighbour)) the work of a chain or net grows with its size.
//! Blocks are factored without pivoting between them, as in [`BlockBand`](super::BlockBand).

use super::block_band::is_regular;
use super::lu::{Lu, minus_applied, minus_product};
use super::{M3, SingularBlock, V3};

/// The matrix, and then its factors in its place; allocates in [`BlockEnvelope::new`] only.
#[derive(Debug, Clone)]
pub struct BlockEnvelope {
    /// First column of each row, which is the first row of each column as well.
    first: Vec<usize>,
    /// Where the blocks of a row or column begin.
    start: Vec<usize>,
    diag: Vec<M3>,
    /// Blocks left of the diagonal, row by row.
    lower: Vec<M3>,
    /// Blocks above the diagonal, column by column.
    upper: Vec<M3>,
    pivots: Vec<Lu<f64>>,
    negative_pivots: usize,
}

impl BlockEnvelope {
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
        Self {
            first,
            start,
            diag: vec![M3::zeros(); n],
            lower: vec![M3::zeros(); blocks],
            upper: vec![M3::zeros(); blocks],
            pivots: vec![Lu::new(&M3::identity()); n],
            negative_pivots: 0,
        }
    }

    /// Sets all blocks to zero.
    pub fn clear(&mut self) {
        self.diag.fill(M3::zeros());
        self.lower.fill(M3::zeros());
        self.upper.fill(M3::zeros());
    }

    /// The block of a row and a column within the envelope.
    pub fn block(&mut self, row: usize, column: usize) -> &mut M3 {
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
    pub fn solve(&mut self, r: &mut [V3]) -> Result<(), SingularBlock> {
        self.negative_pivots = 0;
        for i in 0..self.first.len() {
            self.eliminate(i);
            let lu = Lu::new(&self.diag[i]);
            if !is_regular(&self.diag[i], &lu) {
                return Err(SingularBlock { node: i });
            }
            self.negative_pivots += lu.pivots.iter().filter(|p| **p < 0.0).count();
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
    pub fn solve_again(&self, r: &mut [V3]) {
        for i in 0..self.first.len() {
            let mut right = r[i];
            for (k, block) in (self.first[i]..i).zip(&self.lower[self.start[i]..]) {
                right = minus_applied(right, block, &r[k]);
            }
            r[i] = self.pivots[i].solve(&right);
        }
        self.substitute_back(r);
    }

    fn substitute_back(&self, r: &mut [V3]) {
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
    use nalgebra::{DMatrix, DVector};
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

    #[test]
    fn a_singular_block_is_named() {
        let mut matrix = BlockEnvelope::new(vec![0, 0]);
        *matrix.block(0, 0) = M3::identity();
        let solved = matrix.solve(&mut [V3::zeros(); 2]);
        assert_eq!(solved, Err(SingularBlock { node: 1 }));
    }
}
