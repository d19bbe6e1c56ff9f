//! Factors of matrices within an envelope: they fill nothing outside of it.

use std::sync::Arc;

use nalgebra::DVector;

use super::envelope::{EnvelopeMatrix, EnvelopeShape};

/// Cholesky's factors of the symmetric part of a matrix.
#[derive(Debug, Clone)]
pub struct EnvelopeCholesky {
    shape: Arc<EnvelopeShape>,
    lower: Vec<f64>,
}

impl EnvelopeCholesky {
    /// Factors the symmetric part plus a diagonal; nothing where it is not positive definite.
    #[must_use]
    pub fn new(matrix: &EnvelopeMatrix, diagonal: &DVector<f64>) -> Option<Self> {
        let shape = matrix.shape();
        let both = matrix.lower.iter().zip(&matrix.upper);
        let mut lower: Vec<f64> = both.map(|(below, above)| 0.5 * (below + above)).collect();
        for i in 0..shape.len() {
            let (from, numbers) = shape.row(i);
            let (done, rest) = lower.split_at_mut(numbers.start);
            let row = &mut rest[..numbers.len()];
            row[i - from] += diagonal[i];
            for j in from..i {
                let (start, others) = shape.row(j);
                let dot = common((row, from), (&done[others.clone()], start), j);
                row[j - from] = (row[j - from] - dot) / done[others.end - 1];
            }
            let squares: f64 = row[..i - from].iter().map(|v| v * v).sum();
            let pivot = row[i - from] - squares;
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            row[i - from] = pivot.sqrt();
        }
        Some(Self { shape, lower })
    }

    /// The solution for a right-hand side.
    #[must_use]
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let mut x = right.clone();
        for i in 0..self.shape.len() {
            let (from, numbers) = self.shape.row(i);
            let row = &self.lower[numbers];
            let dot: f64 = (from..i).zip(row).map(|(j, factor)| factor * x[j]).sum();
            x[i] = (x[i] - dot) / row[i - from];
        }
        for i in (0..self.shape.len()).rev() {
            let (from, numbers) = self.shape.row(i);
            let row = &self.lower[numbers];
            x[i] /= row[i - from];
            let found = x[i];
            for (j, factor) in (from..i).zip(row) {
                x[j] -= factor * found;
            }
        }
        x
    }
}

/// Factors of a matrix without exchange of rows: rows of L, whose diagonal is 1, and columns of U.
#[derive(Debug, Clone)]
pub struct EnvelopeLu {
    shape: Arc<EnvelopeShape>,
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl EnvelopeLu {
    /// The factors; nothing where a pivot vanishes.
    #[must_use]
    pub fn new(matrix: &EnvelopeMatrix) -> Option<Self> {
        let shape = matrix.shape();
        let (mut lower, mut upper) = (matrix.lower.clone(), matrix.upper.clone());
        for i in 0..shape.len() {
            let (from, numbers) = shape.row(i);
            let (rows, rest) = lower.split_at_mut(numbers.start);
            let row = &mut rest[..numbers.len()];
            let (columns, rest) = upper.split_at_mut(numbers.start);
            let column = &mut rest[..numbers.len()];
            for j in from..i {
                let (start, others) = shape.row(j);
                let pivot = columns[others.end - 1];
                let dot = common((row, from), (&columns[others.clone()], start), j);
                row[j - from] = (row[j - from] - dot) / pivot;
                let dot = common((column, from), (&rows[others], start), j);
                column[j - from] -= dot;
            }
            let dot: f64 = row[..i - from]
                .iter()
                .zip(&*column)
                .map(|(a, b)| a * b)
                .sum();
            column[i - from] -= dot;
            let pivot = column[i - from];
            if pivot == 0.0 || !pivot.is_finite() {
                return None;
            }
        }
        Some(Self {
            shape,
            lower,
            upper,
        })
    }

    /// How many eigenvalues of a symmetric matrix are negative: as many as its pivots (Sylvester).
    #[must_use]
    pub fn negative_pivots(&self) -> usize {
        let ends = self.shape.starts.iter().skip(1);
        ends.filter(|end| self.upper[**end - 1] < 0.0).count()
    }

    /// The solution for a right-hand side.
    #[must_use]
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let mut x = right.clone();
        for i in 0..self.shape.len() {
            let (from, numbers) = self.shape.row(i);
            let row = &self.lower[numbers];
            let dot: f64 = (from..i).zip(row).map(|(j, factor)| factor * x[j]).sum();
            x[i] -= dot;
        }
        for i in (0..self.shape.len()).rev() {
            let (from, numbers) = self.shape.row(i);
            let column = &self.upper[numbers];
            x[i] /= column[i - from];
            let found = x[i];
            for (j, factor) in (from..i).zip(column) {
                x[j] -= factor * found;
            }
        }
        x
    }
}

/// The product of two rows, each with its first column, before a column.
fn common((row, from): (&[f64], usize), (other, start): (&[f64], usize), end: usize) -> f64 {
    let begin = from.max(start);
    let (row, other) = (
        &row[begin - from..end - from],
        &other[begin - start..end - start],
    );
    row.iter().zip(other).map(|(a, b)| a * b).sum()
}
