//! The banded system of one line: 3 x 3 blocks, not necessarily symmetric, block-tridiagonal or, with bending,
//! block-pentadiagonal.
//!
//! Row i reads `lower[i] x[i-1] + diag[i] x[i] + upper[i] x[i+1] = r[i]`, with bending also
//! `far_lower[i] x[i-2] + far_upper[i] x[i+2]` on the left. The elimination runs from
//! both ends at once and meets in the middle: the two chains do not depend on each other, so a
//! processor works on both, where one chain alone would leave it waiting. Blocks are factored without
//! pivoting, which the tangents of a line (mass plus stiffness) bear; a pivot that vanishes against
//! its block is refused, never divided by.

use std::ops::Range;

use super::{M3, V3};

/// A banded matrix of blocks with room for its own elimination; allocates only when made.
#[derive(Debug, Clone)]
pub struct BlockBand {
    /// Blocks on the diagonal, one a node.
    pub diag: Vec<M3>,
    /// `upper[i]` couples row i to node i + 1.
    pub upper: Vec<M3>,
    /// `lower[i]` couples row i to node i - 1.
    pub lower: Vec<M3>,
    /// `far_upper[i]` couples row i to node i + 2; empty where nothing bends.
    pub far_upper: Vec<M3>,
    /// `far_lower[i]` couples row i to node i - 2; empty where nothing bends.
    pub far_lower: Vec<M3>,
}

/// A pivot vanished in the block of this node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the matrix is singular at node {node}")]
pub struct SingularBlock {
    /// The node.
    pub node: usize,
}

impl BlockBand {
    /// A zero block-tridiagonal matrix for `nodes` nodes.
    #[must_use]
    pub fn new(nodes: usize) -> Self {
        Self {
            diag: vec![M3::zeros(); nodes],
            upper: vec![M3::zeros(); nodes],
            lower: vec![M3::zeros(); nodes],
            far_upper: Vec::new(),
            far_lower: Vec::new(),
        }
    }

    /// Makes room for the couplings of bending, all zero.
    pub fn widen(&mut self) {
        let nodes = self.diag.len();
        self.far_upper.resize(nodes, M3::zeros());
        self.far_lower.resize(nodes, M3::zeros());
    }

    /// Whether there is room for the couplings of bending.
    #[must_use]
    pub fn is_wide(&self) -> bool {
        !self.far_upper.is_empty()
    }

    /// Sets the couplings of nodes two apart to zero, where there is room for them.
    pub fn clear_far(&mut self) {
        self.far_upper.fill(M3::zeros());
        self.far_lower.fill(M3::zeros());
    }

    /// Solves for the rows and nodes of `range`, couplings that leave it left out. `r` holds the
    /// right-hand side on entry and the solution on return; the matrix is used up.
    ///
    /// # Errors
    /// [`SingularBlock`] when a pivot vanishes or is not finite; `r` is then meaningless.
    pub fn solve(&mut self, range: Range<usize>, r: &mut [V3]) -> Result<(), SingularBlock> {
        if range.is_empty() {
            return Ok(());
        }
        if self.is_wide() {
            return self.solve_wide(range, r);
        }
        let (first, last) = (range.start, range.end - 1);
        let middle = first + (last - first) / 2;
        let (mut down, mut up) = (first, last);
        while down < middle || up > middle {
            if down < middle {
                self.eliminate_down(down, r)?;
                down += 1;
            }
            if up > middle {
                self.eliminate_up(up, r)?;
                up -= 1;
            }
        }
        let lu = Lu::new(&self.diag[middle]).ok_or(SingularBlock { node: middle })?;
        r[middle] = lu.solve(&r[middle]);
        let steps = (middle - first).max(last - middle);
        for k in 1..=steps {
            if middle >= first + k {
                let i = middle - k;
                let x = self.upper[i] * r[i + 1];
                r[i] -= x;
            }
            if middle + k <= last {
                let i = middle + k;
                let x = self.lower[i] * r[i - 1];
                r[i] -= x;
            }
        }
        Ok(())
    }

    /// How many pivots of the last [`BlockBand::solve`] on this range were negative: of a symmetric matrix, as many as it
    /// has negative eigenvalues (Sylvester).
    #[must_use]
    pub fn negative_pivots(&self, range: Range<usize>) -> usize {
        let count = |block: &M3| Lu::new(block).map_or(0, |lu| lu.negative());
        self.diag[range].iter().map(count).sum()
    }

    /// Elimination of five bands, from the first node to the last and back.
    fn solve_wide(&mut self, range: Range<usize>, r: &mut [V3]) -> Result<(), SingularBlock> {
        let end = range.end;
        for i in range.clone() {
            let lu = Lu::new(&self.diag[i]).ok_or(SingularBlock { node: i })?;
            let y = lu.solve(&r[i]);
            r[i] = y;
            if i + 1 >= end {
                continue;
            }
            let near = lu.solve_block(&self.upper[i]);
            let far = lu.solve_block(&self.far_upper[i]);
            let below = self.lower[i + 1];
            subtract_product(&mut self.diag[i + 1], &below, &near);
            subtract_product(&mut self.upper[i + 1], &below, &far);
            r[i + 1] -= below * y;
            if i + 2 < end {
                let below = self.far_lower[i + 2];
                subtract_product(&mut self.lower[i + 2], &below, &near);
                subtract_product(&mut self.diag[i + 2], &below, &far);
                r[i + 2] -= below * y;
            }
            (self.upper[i], self.far_upper[i]) = (near, far);
        }
        for i in range.rev() {
            if i + 1 < end {
                let x = self.upper[i] * r[i + 1];
                r[i] -= x;
            }
            if i + 2 < end {
                let x = self.far_upper[i] * r[i + 2];
                r[i] -= x;
            }
        }
        Ok(())
    }

    /// Takes node i out of row i + 1; `upper[i]` becomes `diag[i]^-1 upper[i]`.
    #[inline(always)]
    fn eliminate_down(&mut self, i: usize, r: &mut [V3]) -> Result<(), SingularBlock> {
        let lu = Lu::new(&self.diag[i]).ok_or(SingularBlock { node: i })?;
        let w = lu.solve_block(&self.upper[i]);
        let y = lu.solve(&r[i]);
        let coupling = self.lower[i + 1];
        subtract_product(&mut self.diag[i + 1], &coupling, &w);
        r[i + 1] -= coupling * y;
        self.upper[i] = w;
        r[i] = y;
        Ok(())
    }

    /// Takes node i out of row i - 1; `lower[i]` becomes `diag[i]^-1 lower[i]`.
    #[inline(always)]
    fn eliminate_up(&mut self, i: usize, r: &mut [V3]) -> Result<(), SingularBlock> {
        let lu = Lu::new(&self.diag[i]).ok_or(SingularBlock { node: i })?;
        let w = lu.solve_block(&self.lower[i]);
        let y = lu.solve(&r[i]);
        let coupling = self.upper[i - 1];
        subtract_product(&mut self.diag[i - 1], &coupling, &w);
        r[i - 1] -= coupling * y;
        self.lower[i] = w;
        r[i] = y;
        Ok(())
    }
}

/// `d -= a b`, written out: the general product of the matrix library costs twice as much here.
#[inline(always)]
fn subtract_product(d: &mut M3, a: &M3, b: &M3) {
    for j in 0..3 {
        for i in 0..3 {
            d[(i, j)] -= a[(i, 0)] * b[(0, j)] + a[(i, 1)] * b[(1, j)] + a[(i, 2)] * b[(2, j)];
        }
    }
}

/// Smallest pivot against the greatest entry of its block.
const SMALLEST_PIVOT: f64 = 1e-14;

/// LU factors of a 3 x 3 block without pivoting; diagonal stored inverted.
struct Lu {
    l10: f64,
    l20: f64,
    l21: f64,
    u01: f64,
    u02: f64,
    u12: f64,
    p0: f64,
    p1: f64,
    p2: f64,
}

impl Lu {
    #[inline(always)]
    fn new(m: &M3) -> Option<Self> {
        let (a00, a01, a02) = (m[(0, 0)], m[(0, 1)], m[(0, 2)]);
        let p0 = 1.0 / a00;
        let l10 = m[(1, 0)] * p0;
        let l20 = m[(2, 0)] * p0;
        let a11 = m[(1, 1)] - l10 * a01;
        let u12 = m[(1, 2)] - l10 * a02;
        let p1 = 1.0 / a11;
        let l21 = (m[(2, 1)] - l20 * a01) * p1;
        let a22 = m[(2, 2)] - l20 * a02 - l21 * u12;
        let size = m[(0, 0)].abs() + m[(1, 1)].abs() + m[(2, 2)].abs();
        let least = a00.abs().min(a11.abs()).min(a22.abs());
        // A comparison that is false for NaN refuses NaN as well.
        (least > SMALLEST_PIVOT * size && size < f64::MAX).then_some(Self {
            l10,
            l20,
            l21,
            u01: a01,
            u02: a02,
            u12,
            p0,
            p1,
            p2: 1.0 / a22,
        })
    }

    fn negative(&self) -> usize {
        let pivots = [self.p0, self.p1, self.p2];
        pivots.into_iter().filter(|p| *p < 0.0).count()
    }

    #[inline(always)]
    fn solve(&self, r: &V3) -> V3 {
        let y0 = r[0];
        let y1 = r[1] - self.l10 * y0;
        let y2 = r[2] - self.l20 * y0 - self.l21 * y1;
        let x2 = y2 * self.p2;
        let x1 = (y1 - self.u12 * x2) * self.p1;
        let x0 = (y0 - self.u01 * x1 - self.u02 * x2) * self.p0;
        V3::new(x0, x1, x2)
    }

    #[inline(always)]
    fn solve_block(&self, b: &M3) -> M3 {
        let c0 = self.solve(&V3::new(b[(0, 0)], b[(1, 0)], b[(2, 0)]));
        let c1 = self.solve(&V3::new(b[(0, 1)], b[(1, 1)], b[(2, 1)]));
        let c2 = self.solve(&V3::new(b[(0, 2)], b[(1, 2)], b[(2, 2)]));
        M3::from_columns(&[c0, c1, c2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use proptest::prelude::*;

    fn dense(m: &BlockBand, n: usize) -> DMatrix<f64> {
        let mut a = DMatrix::zeros(3 * n, 3 * n);
        for i in 0..n {
            a.fixed_view_mut::<3, 3>(3 * i, 3 * i).copy_from(&m.diag[i]);
            if i + 1 < n {
                a.fixed_view_mut::<3, 3>(3 * i, 3 * i + 3)
                    .copy_from(&m.upper[i]);
                a.fixed_view_mut::<3, 3>(3 * i + 3, 3 * i)
                    .copy_from(&m.lower[i + 1]);
            }
            if i + 2 < n && m.is_wide() {
                a.fixed_view_mut::<3, 3>(3 * i, 3 * i + 6)
                    .copy_from(&m.far_upper[i]);
                a.fixed_view_mut::<3, 3>(3 * i + 6, 3 * i)
                    .copy_from(&m.far_lower[i + 2]);
            }
        }
        a
    }

    proptest! {
        /// Against a dense factorisation with pivoting.
        #[test]
        fn agrees_with_dense_lu(
            n in 1usize..9,
            wide in any::<bool>(),
            entries in proptest::collection::vec(-1.0f64..1.0, 9 * 9 * 3 + 27),
        ) {
            let mut m = BlockBand::new(n);
            let mut next = entries.iter().copied().cycle();
            let mut block = || M3::from_fn(|_, _| next.next().unwrap());
            if wide {
                m.widen();
                m.far_upper.fill_with(&mut block);
                m.far_lower.fill_with(&mut block);
            }
            for i in 0..n {
                m.diag[i] = block() + M3::identity() * 12.0;
                m.upper[i] = block();
                m.lower[i] = block();
            }
            let r: Vec<V3> = (0..n).map(|i| V3::new(i as f64, 1.0, -(i as f64))).collect();
            let a = dense(&m, n);
            let b = DVector::from_iterator(3 * n, r.iter().flat_map(|v| v.iter().copied()));
            let expected = a.lu().solve(&b).unwrap();
            let mut x = r;
            m.solve(0..n, &mut x).unwrap();
            for i in 0..3 * n {
                prop_assert!((x[i / 3][i % 3] - expected[i]).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn negative_pivots_count_negative_eigenvalues() {
        for wide in [false, true] {
            let mut m = BlockBand::new(7);
            if wide {
                m.widen();
                m.far_upper.fill(M3::identity() * 0.3);
                m.far_lower.fill(M3::identity() * 0.3);
            }
            for i in 0..7 {
                m.diag[i] = M3::from_diagonal(&V3::new(3.0, i as f64 - 2.5, -4.0));
                m.upper[i] = M3::from_element(0.2);
                m.lower[i] = M3::from_element(0.2);
            }
            let eigenvalues = dense(&m, 7).symmetric_eigenvalues();
            let expected = eigenvalues.iter().filter(|e| **e < 0.0).count();
            m.solve(0..7, &mut [V3::zeros(); 7]).unwrap();
            assert_eq!(m.negative_pivots(0..7), expected);
        }
    }

    #[test]
    fn a_singular_block_is_named() {
        let mut m = BlockBand::new(3);
        m.diag[0] = M3::identity();
        m.diag[2] = M3::identity();
        let mut r = vec![V3::zeros(); 3];
        assert_eq!(m.solve(0..3, &mut r), Err(SingularBlock { node: 1 }));
    }

    #[test]
    fn not_a_number_is_refused() {
        let mut m = BlockBand::new(1);
        m.diag[0] = M3::identity() * f64::NAN;
        assert!(m.solve(0..1, &mut [V3::zeros()]).is_err());
    }
}
