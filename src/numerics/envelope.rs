//! Cholesky's factors of a symmetric, positive definite matrix within its envelope: from the first number of each row that is not
//! zero to the diagonal. Numbered from neighbour to neighbour, the work of a chain or net of unknowns grows in proportion to their
//! number (George and Liu, *Computer Solution of Large Sparse Positive Definite Systems*, 1981, chapter 4).

use std::collections::VecDeque;

use nalgebra::{DMatrix, DVector};

/// The factors of a matrix in an order of its unknowns.
#[derive(Debug, Clone)]
pub struct EnvelopeCholesky {
    order: Vec<usize>,
    /// First column of each row.
    first: Vec<usize>,
    /// Rows from there to the diagonal.
    rows: Vec<Vec<f64>>,
}

impl EnvelopeCholesky {
    /// Factors `matrix` plus a diagonal, its unknowns taken in this order; nothing where it is not positive definite. The upper
    /// triangle is not read.
    #[must_use]
    pub fn new(matrix: &DMatrix<f64>, diagonal: &DVector<f64>, order: &[usize]) -> Option<Self> {
        let n = order.len();
        let mut first = Vec::with_capacity(n);
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(n);
        for i in 0..n {
            let entry = |j: usize| matrix[(order[i].max(order[j]), order[i].min(order[j]))];
            let from = (0..i).find(|j| entry(*j) != 0.0).unwrap_or(i);
            let mut row: Vec<f64> = (from..=i).map(entry).collect();
            row[i - from] += diagonal[order[i]];
            for j in from..i {
                let (other, start): (&Vec<f64>, usize) = (&rows[j], first[j]);
                let common = start.max(from);
                let dot: f64 = row[common - from..j - from]
                    .iter()
                    .zip(&other[common - start..j - start])
                    .map(|(a, b)| a * b)
                    .sum();
                row[j - from] = (row[j - from] - dot) / other[j - start];
            }
            let squares: f64 = row[..i - from].iter().map(|v| v * v).sum();
            let pivot = row[i - from] - squares;
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            row[i - from] = pivot.sqrt();
            first.push(from);
            rows.push(row);
        }
        Some(Self {
            order: order.to_vec(),
            first,
            rows,
        })
    }

    /// The solution for a right-hand side.
    #[must_use]
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let n = self.order.len();
        let mut x: Vec<f64> = self.order.iter().map(|k| right[*k]).collect();
        for i in 0..n {
            let (from, row) = (self.first[i], &self.rows[i]);
            let dot: f64 = row[..i - from]
                .iter()
                .zip(&x[from..i])
                .map(|(a, b)| a * b)
                .sum();
            x[i] = (x[i] - dot) / row[i - from];
        }
        for i in (0..n).rev() {
            let (from, row) = (self.first[i], &self.rows[i]);
            x[i] /= row[i - from];
            let found = x[i];
            for (value, factor) in x[from..i].iter_mut().zip(row) {
                *value -= factor * found;
            }
        }
        let mut solution = DVector::zeros(n);
        for (k, value) in self.order.iter().zip(x) {
            solution[*k] = value;
        }
        solution
    }
}

/// Nodes numbered from neighbour to neighbour, beginning with one of the fewest neighbours (Cuthill and McKee 1969), in reverse.
#[must_use]
pub fn from_neighbour_to_neighbour(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let mut order = Vec::with_capacity(neighbours.len());
    let mut seen = vec![false; neighbours.len()];
    let mut by_degree: Vec<usize> = (0..neighbours.len()).collect();
    by_degree.sort_by_key(|node| neighbours[*node].len());
    for begin in by_degree {
        let mut waiting = VecDeque::from([begin]);
        while let Some(node) = waiting.pop_front() {
            if std::mem::replace(&mut seen[node], true) {
                continue;
            }
            order.push(node);
            let mut next: Vec<usize> = neighbours[node]
                .iter()
                .copied()
                .filter(|n| !seen[*n])
                .collect();
            next.sort_by_key(|node| neighbours[*node].len());
            waiting.extend(next);
        }
    }
    order.reverse();
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    #[test]
    fn the_solution_solves_the_matrix_in_any_order() {
        let mut random = Random::new(3, 0);
        let n = 24;
        let mut half = DMatrix::from_fn(n, n, |_, _| random.uniform() - 0.5);
        for i in 0..n {
            for j in 0..n {
                if i.abs_diff(j) > 3 {
                    half[(i, j)] = 0.0;
                }
            }
        }
        let matrix = &half * half.transpose() + DMatrix::identity(n, n) * 0.1;
        let right = DVector::from_fn(n, |_, _| random.uniform());
        let neighbours: Vec<Vec<usize>> = (0..n)
            .map(|i| {
                (0..n)
                    .filter(|j| *j != i && matrix[(i, *j)] != 0.0)
                    .collect()
            })
            .collect();
        let plain: Vec<usize> = (0..n).collect();
        for order in [plain, from_neighbour_to_neighbour(&neighbours)] {
            let factors = EnvelopeCholesky::new(&matrix, &DVector::zeros(n), &order).unwrap();
            let x = factors.solve(&right);
            assert!((&matrix * x - &right).amax() < 1e-10);
        }
        let indefinite = &matrix - DMatrix::identity(n, n) * 10.0;
        assert!(
            EnvelopeCholesky::new(&indefinite, &DVector::zeros(n), &(0..n).collect::<Vec<_>>())
                .is_none()
        );
    }
}
