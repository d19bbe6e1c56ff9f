//! The banded system of one line: 3 x 3 blocks, not necessarily symmetric, block-tridiagonal or, with bending,
//! block-pentadiagonal.
//!
//! Row i reads `lower[i] x[i-1] + diag[i] x[i] + upper[i] x[i+1] = r[i]`, with bending also
//! `far_lower[i] x[i-2] + far_upper[i] x[i+2]` on the left. The elimination runs from both ends at once and meets in the
//! middle; where a pivot is too small for that it starts again, from the first node to the last. Blocks are factored
//! without pivoting, which is stable for the tangents of a line (mass plus stiffness); a pivot that vanishes against its block is an
//! error.

use std::ops::Range;

use nalgebra::Matrix3;

use super::both_ends::BothEnds;
use super::lanes::Pivot;
use super::lu::{Lu, minus_applied, minus_product};
use super::{M3, V3};

/// A banded matrix of blocks with storage for its own elimination; allocates only in [`BlockBand::new`].
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
    /// Storage for elimination from both ends; none in a matrix that is too small for it.
    both: Option<Box<BothEnds>>,
}

/// A banded matrix whose blocks are read one by one, so that they need not be stored.
pub trait Banded<T: Pivot> {
    /// Number of nodes.
    fn nodes(&self) -> usize;

    /// Whether nodes two apart are coupled.
    fn is_wide(&self) -> bool;

    /// The block that couples row i to node j; zero beyond the line.
    fn coupling(&self, i: usize, j: usize) -> Matrix3<T>;
}

impl Banded<f64> for BlockBand {
    fn nodes(&self) -> usize {
        self.diag.len()
    }

    fn is_wide(&self) -> bool {
        Self::is_wide(self)
    }

    #[inline(always)]
    fn coupling(&self, i: usize, j: usize) -> M3 {
        let nodes = self.diag.len();
        if i >= nodes || j >= nodes {
            return M3::zeros();
        }
        match (i, j) {
            _ if i == j => self.diag[i],
            _ if j == i + 1 => self.upper[i],
            _ if i == j + 1 => self.lower[i],
            _ if j == i + 2 && Self::is_wide(self) => self.far_upper[i],
            _ if i == j + 2 && Self::is_wide(self) => self.far_lower[i],
            _ => M3::zeros(),
        }
    }
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
            both: BothEnds::new(nodes),
        }
    }

    /// Allocates the couplings of bending, all zero.
    pub fn widen(&mut self) {
        let nodes = self.diag.len();
        self.far_upper.resize(nodes, M3::zeros());
        self.far_lower.resize(nodes, M3::zeros());
        if let Some(both) = &mut self.both {
            both.widen();
        }
    }

    /// Whether the couplings of bending are allocated.
    #[must_use]
    pub fn is_wide(&self) -> bool {
        !self.far_upper.is_empty()
    }

    /// Sets the couplings of nodes two apart to zero, where they are allocated.
    pub fn clear_far(&mut self) {
        self.far_upper.fill(M3::zeros());
        self.far_lower.fill(M3::zeros());
    }

    /// Solves for the rows and nodes of `range`, couplings that leave it left out. `r` holds the
    /// right-hand side on entry and the solution on return; the matrix is overwritten.
    ///
    /// # Errors
    /// [`SingularBlock`] when a pivot vanishes or is not finite; `r` is then meaningless.
    pub fn solve(&mut self, range: Range<usize>, r: &mut [V3]) -> Result<(), SingularBlock> {
        if let Some(mut both) = self.both.take() {
            let solved = if self.is_wide() {
                both.solve::<true>(self, &range, r)
            } else {
                both.solve::<false>(self, &range, r)
            };
            self.both = Some(both);
            if solved.is_some() {
                return Ok(());
            }
        }
        if self.is_wide() {
            self.solve_from_first::<true>(range, r)
        } else {
            self.solve_from_first::<false>(range, r)
        }
    }

    /// How many pivots of the last [`BlockBand::solve`] on this range were negative: of a symmetric matrix, as many as it
    /// has negative eigenvalues (Sylvester).
    #[must_use]
    pub fn negative_pivots(&self, range: Range<usize>) -> usize {
        let from_both_ends = self.both.as_ref().and_then(|both| both.negative_pivots());
        from_both_ends.unwrap_or_else(|| {
            let negative = |m: &M3| Lu::new(m).pivots.iter().filter(|p| **p < 0.0).count();
            self.diag[range].iter().map(negative).sum()
        })
    }

    /// Elimination from the first node to the last and back.
    fn solve_from_first<const WIDE: bool>(
        &mut self,
        range: Range<usize>,
        r: &mut [V3],
    ) -> Result<(), SingularBlock> {
        let end = range.end;
        for i in range.clone() {
            let lu = Lu::new(&self.diag[i]);
            if !is_regular(&self.diag[i], &lu) {
                return Err(SingularBlock { node: i });
            }
            let y = lu.solve(&r[i]);
            r[i] = y;
            if i + 1 >= end {
                continue;
            }
            let near = lu.solve_block(&self.upper[i]);
            let below = self.lower[i + 1];
            self.diag[i + 1] = minus_product(self.diag[i + 1], &below, &near);
            r[i + 1] = minus_applied(r[i + 1], &below, &y);
            self.upper[i] = near;
            if WIDE && i + 2 < end {
                let far = lu.solve_block(&self.far_upper[i]);
                self.upper[i + 1] = minus_product(self.upper[i + 1], &below, &far);
                let below = self.far_lower[i + 2];
                self.lower[i + 2] = minus_product(self.lower[i + 2], &below, &near);
                self.diag[i + 2] = minus_product(self.diag[i + 2], &below, &far);
                r[i + 2] = minus_applied(r[i + 2], &below, &y);
                self.far_upper[i] = far;
            }
        }
        for i in range.rev() {
            if i + 1 < end {
                r[i] = minus_applied(r[i], &self.upper[i], &r[i + 1]);
            }
            if WIDE && i + 2 < end {
                r[i] = minus_applied(r[i], &self.far_upper[i], &r[i + 2]);
            }
        }
        Ok(())
    }
}

/// Smallest pivot against the greatest entry of its block.
const SMALLEST_PIVOT: f64 = 1e-14;

/// Whether no pivot of a block vanishes and all its entries are finite.
pub(super) fn is_regular<T: Pivot>(block: &Matrix3<T>, lu: &Lu<T>) -> bool {
    let size = block[(0, 0)].size() + block[(1, 1)].size() + block[(2, 2)].size();
    // A comparison that is false for NaN refuses NaN as well.
    let there = |pivot: &T| pivot.size() > SMALLEST_PIVOT * size;
    lu.pivots.iter().all(there) && size < f64::MAX
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

    /// Against a dense factorisation with pivoting.
    fn agrees_with_dense(mut m: BlockBand, n: usize) -> Result<(), TestCaseError> {
        let r: Vec<V3> = (0..n)
            .map(|i| V3::new(i as f64, 1.0, -(i as f64)))
            .collect();
        let b = DVector::from_iterator(3 * n, r.iter().flat_map(|v| v.iter().copied()));
        let expected = dense(&m, n).lu().solve(&b).unwrap();
        let mut x = r;
        m.solve(0..n, &mut x).unwrap();
        for i in 0..3 * n {
            prop_assert!((x[i / 3][i % 3] - expected[i]).abs() < 1e-12);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn agrees_with_dense_lu(
            n in 1usize..17,
            wide in any::<bool>(),
            entries in proptest::collection::vec(-1.0f64..1.0, 9 * 16 * 5),
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
            agrees_with_dense(m, n)?;
        }
    }

    /// A stiff chain that turns at every node, `stiff` along its segments and 1 across, with some bending; `held` at its
    /// ends.
    fn chain(n: usize, wide: bool, stiff: f64, held: f64) -> BlockBand {
        let mut m = BlockBand::new(n);
        for i in 0..n - 1 {
            let angle = 0.7 * i as f64;
            let t = V3::new(angle.cos(), 0.6 * angle.sin(), 0.8 * angle.sin());
            let along = t * t.transpose();
            add(&mut m, i, &[1.0, -1.0], M3::identity() + along * stiff);
        }
        m.diag[0] += M3::identity() * held;
        m.diag[n - 1] += M3::identity() * held;
        if wide {
            m.widen();
            for i in 0..n - 2 {
                add(&mut m, i, &[1.0, -2.0, 1.0], M3::identity());
            }
        }
        m
    }

    /// Adds the energy of `sum weights[k] x[i + k]` in this metric.
    fn add(m: &mut BlockBand, i: usize, weights: &[f64], metric: M3) {
        for (a, one) in weights.iter().enumerate() {
            for (b, other) in weights.iter().enumerate() {
                let bands = [
                    &mut m.far_lower,
                    &mut m.lower,
                    &mut m.diag,
                    &mut m.upper,
                    &mut m.far_upper,
                ];
                bands[2 + b - a][i + a] += metric * (one * other);
            }
        }
    }

    /// What is left of the equations is rounding of their terms, however stiff the chain: 1e-8 is the share of tension in
    /// the stiffness of the stiffest lines.
    #[test]
    fn stiff_chains_are_solved_to_rounding() {
        for (n, wide, stiff) in [
            (57, false, 1e4),
            (57, false, 1e8),
            (56, true, 1e4),
            (57, true, 1e8),
        ] {
            let mut m = chain(n, wide, stiff, stiff);
            let a = dense(&m, n);
            let b = DVector::from_element(3 * n, 1.0);
            let mut x = vec![V3::repeat(1.0); n];
            m.solve(0..n, &mut x).unwrap();
            let x = DVector::from_iterator(3 * n, x.iter().flat_map(|v| v.iter().copied()));
            let left = (&a * &x - &b).amax() / (a.amax() * x.amax() + 1.0);
            assert!(left < 2e-15, "{n} {wide} {stiff}: {left:e}");
        }
    }

    /// Where the chains meet, the pivots of such a line are rounding: elimination from one end decides.
    #[test]
    fn a_chain_that_nothing_holds_is_left_to_one_end() {
        for (n, wide) in [(31, false), (30, true), (31, true)] {
            for (held, from_both_ends) in [(1.0, true), (0.0, false)] {
                let mut m = chain(n, wide, 1.0, held);
                let _ = m.solve(0..n, &mut vec![V3::x(); n]);
                let both = m.both.unwrap();
                assert_eq!(both.negative_pivots(), from_both_ends.then_some(0));
            }
        }
    }

    #[test]
    fn negative_pivots_count_negative_eigenvalues() {
        for (n, wide) in [(4, false), (7, false), (7, true), (8, false), (8, true)] {
            let mut m = BlockBand::new(n);
            if wide {
                m.widen();
                m.far_upper.fill(M3::identity() * 0.3);
                m.far_lower.fill(M3::identity() * 0.3);
            }
            for i in 0..n {
                m.diag[i] = M3::from_diagonal(&V3::new(3.0, i as f64 - 2.5, -4.0));
                m.upper[i] = M3::from_element(0.2);
                m.lower[i] = M3::from_element(0.2);
            }
            let eigenvalues = dense(&m, n).symmetric_eigenvalues();
            let expected = eigenvalues.iter().filter(|e| **e < 0.0).count();
            m.solve(0..n, &mut vec![V3::zeros(); n]).unwrap();
            assert_eq!(m.negative_pivots(0..n), expected);
        }
    }

    /// A saddle, as of a tie's multiplier: no pivot to begin with at its end, but one after elimination from the other.
    #[test]
    fn an_end_that_cannot_begin_is_eliminated_last() {
        for wide in [false, true] {
            let n = 9;
            let mut m = chain(n, wide, 10.0, 1.0);
            m.diag[n - 1] = M3::zeros();
            agrees_with_dense(m, n).unwrap();
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
        for (n, at) in [(1, 0), (9, 2), (9, 4), (9, 8)] {
            let mut m = chain(n.max(2), false, 10.0, 1.0);
            m.diag[at][(1, 1)] = f64::NAN;
            assert!(m.solve(0..n, &mut vec![V3::zeros(); n]).is_err());
        }
    }
}
