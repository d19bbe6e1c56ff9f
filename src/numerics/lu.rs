//! LU factors of a 3 x 3 block, of numbers or of two numbers in lanes.

use nalgebra::{Matrix3, Vector3};

use super::lanes::Number;

/// Factors of a 3 x 3 block without pivoting: `L D U`, the diagonals of L and U ones.
#[derive(Debug, Clone)]
pub(super) struct Lu<T> {
    l10: T,
    l20: T,
    l21: T,
    u01: T,
    u02: T,
    u12: T,
    /// The diagonal of D.
    pub(super) pivots: Vector3<T>,
    /// One over it.
    inverse: [T; 3],
}

impl<T: Number> Lu<T> {
    /// The factors. Where a pivot vanishes the others are infinite or NaN; the caller checks.
    ///
    /// The pivots are ratios of the leading minors, so that no division waits for another one; each minor is a
    /// difference of two products, as accurate as the difference that it replaces in the usual order of operations.
    #[inline(always)]
    pub(super) fn new(m: &Matrix3<T>) -> Self {
        let one = T::from(1.0);
        let a = m[(0, 0)];
        let minor = |i: usize, j: usize| a * m[(i, j)] - m[(i, 0)] * m[(0, j)];
        let (d11, d12, d21, d22) = (minor(1, 1), minor(1, 2), minor(2, 1), minor(2, 2));
        // The determinant, times a.
        let d = d11 * d22 - d21 * d12;
        let (by_a, by_d11, by_d) = (one / a, one / d11, one / d);
        Self {
            l10: m[(1, 0)] * by_a,
            l20: m[(2, 0)] * by_a,
            l21: d21 * by_d11,
            u01: m[(0, 1)] * by_a,
            u02: m[(0, 2)] * by_a,
            u12: d12 * by_d11,
            pivots: Vector3::new(a, d11 * by_a, d * by_d11 * by_a),
            inverse: [by_a, a * by_d11, a * d11 * by_d],
        }
    }

    /// The block's inverse times a vector.
    #[inline(always)]
    pub(super) fn solve(&self, r: &Vector3<T>) -> Vector3<T> {
        let y0 = r[0];
        let y1 = r[1] - self.l10 * y0;
        let y2 = r[2] - self.l20 * y0 - self.l21 * y1;
        let x2 = y2 * self.inverse[2];
        let x1 = y1 * self.inverse[1] - self.u12 * x2;
        let x0 = y0 * self.inverse[0] - self.u02 * x2 - self.u01 * x1;
        Vector3::new(x0, x1, x2)
    }

    /// The block's inverse times another block.
    #[inline(always)]
    pub(super) fn solve_block(&self, b: &Matrix3<T>) -> Matrix3<T> {
        let column = |j: usize| self.solve(&Vector3::new(b[(0, j)], b[(1, j)], b[(2, j)]));
        Matrix3::from_columns(&[column(0), column(1), column(2)])
    }
}

/// `d - a b`, written out: the general product of the matrix library costs twice as much here.
#[inline(always)]
pub(super) fn minus_product<T: Number>(
    mut d: Matrix3<T>,
    a: &Matrix3<T>,
    b: &Matrix3<T>,
) -> Matrix3<T> {
    for j in 0..3 {
        for i in 0..3 {
            let row = a[(i, 0)] * b[(0, j)] + a[(i, 1)] * b[(1, j)] + a[(i, 2)] * b[(2, j)];
            d[(i, j)] -= row;
        }
    }
    d
}

/// `d - a x`.
#[inline(always)]
pub(super) fn minus_applied<T: Number>(
    d: Vector3<T>,
    a: &Matrix3<T>,
    x: &Vector3<T>,
) -> Vector3<T> {
    let row = |i: usize| d[i] - (a[(i, 0)] * x[0] + a[(i, 1)] * x[1] + a[(i, 2)] * x[2]);
    Vector3::new(row(0), row(1), row(2))
}
