//! Static condensation of the banded system of one line onto its first and last nodes.
//!
//! With the nodes between eliminated, `K_ii x_i + K_ie x_e = 0`, what is left is the Schur complement
//! `S = K_ee - K_ei K_ii^-1 K_ie` (Guyan 1965, doi 10.2514/3.2874): of a tangent stiffness, that of the line as one element
//! between its ends. The elimination runs from the first node to the last, and carries the couplings to the first node along.
//! A front of three nodes (four with bending) moves along the line: the first node, the one that is eliminated next, and those that
//! it is coupled to.

use nalgebra::{Matrix3, Vector3};

use super::SingularBlock;
use super::block_band::{Banded, is_regular};
use super::lanes::Pivot;
use super::lu::{Lu, minus_applied, minus_product};
use super::side_front::{SideCouplings, SideFront};

/// Blocks by row and column: of the first node, then of the last.
pub type EndBlocks<T = f64> = [[Matrix3<T>; 2]; 2];

/// A line condensed onto its first node, its last, and the unknowns beside both: see [`Condensation::condense_beside`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CondensedBeside<T: Pivot = f64> {
    /// Blocks by row and column.
    pub blocks: [[Matrix3<T>; 4]; 4],
    /// What is left of the right-hand side.
    pub left: [Vector3<T>; 4],
}

impl<T: Pivot> CondensedBeside<T> {
    /// Of a line with nothing beside its ends.
    fn without(ends: &EndBlocks<T>, of_ends: &[Vector3<T>; 2]) -> Self {
        let mut condensed = Self {
            blocks: [[none(); 4]; 4],
            left: [unloaded(); 4],
        };
        for i in 0..2 {
            condensed.left[i] = of_ends[i];
            condensed.blocks[i][..2].copy_from_slice(&ends[i]);
        }
        condensed
    }
}

/// A condensation with its storage: allocates in [`Condensation::new`] only.
#[derive(Debug, Clone)]
pub struct Condensation<T: Pivot = f64> {
    /// The nodes between, in the order of elimination: `x[i] = load - (first x[0] + near x[i + 1] + far x[i + 2])`.
    rows: Vec<EliminatedNode<T>>,
    /// The same by the unknowns beside the line, where it has them.
    beside: Vec<[Matrix3<T>; 2]>,
    negative_pivots: usize,
}

#[derive(Debug, Clone, Copy)]
struct EliminatedNode<T: Pivot> {
    first: Matrix3<T>,
    near: Matrix3<T>,
    far: Matrix3<T>,
    load: Vector3<T>,
}

/// Nodes in the front: the first node of the line, the one that is eliminated next, and two beyond it.
pub(super) const FRONT: usize = 4;
/// Where the node is that is eliminated next.
pub(super) const NEXT: usize = 1;

type Front<T> = [[Matrix3<T>; FRONT]; FRONT];

/// A zero block.
#[inline(always)]
fn none<T: Pivot>() -> Matrix3<T> {
    Matrix3::repeat(T::from(0.0))
}

/// A zero vector.
#[inline(always)]
fn unloaded<T: Pivot>() -> Vector3<T> {
    Vector3::repeat(T::from(0.0))
}

impl<T: Pivot> Condensation<T> {
    /// Storage for a line of so many nodes.
    #[must_use]
    pub fn new(nodes: usize) -> Self {
        let nothing = EliminatedNode {
            first: none(),
            near: none(),
            far: none(),
            load: unloaded(),
        };
        Self {
            rows: vec![nothing; nodes.saturating_sub(2)],
            beside: Vec::new(),
            negative_pivots: 0,
        }
    }

    /// The same for a line with unknowns beside it.
    #[must_use]
    pub fn with_sides(mut self) -> Self {
        self.beside = vec![[none(); 2]; self.rows.len()];
        self
    }

    /// The matrix condensed onto its first and last nodes; it has as many nodes as the storage, two or more.
    ///
    /// # Errors
    /// [`SingularBlock`] when a pivot vanishes or is not finite.
    pub fn condense(&mut self, matrix: &impl Banded<T>) -> Result<EndBlocks<T>, SingularBlock> {
        Ok(self.condense_any::<false, false>(matrix, &[], None)?.0)
    }

    /// The same of the matrix and of a right-hand side, one entry a node: what is left of it on the first and last nodes.
    ///
    /// # Errors
    /// As [`Condensation::condense`].
    pub fn condense_loaded(
        &mut self,
        matrix: &impl Banded<T>,
        loads: &[Vector3<T>],
    ) -> Result<(EndBlocks<T>, [Vector3<T>; 2]), SingularBlock> {
        self.condense_any::<true, false>(matrix, loads, None)
    }

    /// The same of a line that may be coupled to an unknown beside each end, then with storage for them ([`with_sides`](Self::with_sides)): see
    /// [`SideCouplings`]. Their own rows have no load; where there are none, they are zero.
    ///
    /// # Errors
    /// As [`Condensation::condense`].
    pub fn condense_beside(
        &mut self,
        matrix: &impl Banded<T>,
        loads: &[Vector3<T>],
        couplings: Option<&SideCouplings<T>>,
    ) -> Result<CondensedBeside<T>, SingularBlock> {
        let Some(couplings) = couplings else {
            let (ends, of_ends) = self.condense_loaded(matrix, loads)?;
            return Ok(CondensedBeside::without(&ends, &of_ends));
        };
        let (nodes, beyond) = (matrix.nodes(), if matrix.is_wide() { 3 } else { 2 });
        let mut sides = SideFront::new(couplings, nodes, beyond);
        let (ends, of_ends) = self.condense_any::<true, true>(matrix, loads, Some(&mut sides))?;
        let (by_sides, of_sides) = (sides.by_sides(), sides.of_sides());
        let blocks = [0, 1, 2, 3].map(|i| {
            [0, 1, 2, 3].map(|j| match (i, j) {
                (0..2, 0..2) => ends[i][j],
                (0..2, _) => by_sides[i][j - 2],
                (_, 0..2) => of_sides[i - 2][j],
                _ => sides.own[i - 2][j - 2],
            })
        });
        let left = [of_ends[0], of_ends[1], sides.load[0], sides.load[1]];
        Ok(CondensedBeside { blocks, left })
    }

    fn condense_any<const LOADED: bool, const BESIDE: bool>(
        &mut self,
        matrix: &impl Banded<T>,
        loads: &[Vector3<T>],
        sides: Option<&mut SideFront<T>>,
    ) -> Result<(EndBlocks<T>, [Vector3<T>; 2]), SingularBlock> {
        if matrix.is_wide() {
            self.condense_as::<3, LOADED, BESIDE>(matrix, loads, sides)
        } else {
            self.condense_as::<2, LOADED, BESIDE>(matrix, loads, sides)
        }
    }

    /// `BEYOND` is the place of the last node in the front.
    fn condense_as<const BEYOND: usize, const LOADED: bool, const BESIDE: bool>(
        &mut self,
        matrix: &impl Banded<T>,
        loads: &[Vector3<T>],
        mut sides: Option<&mut SideFront<T>>,
    ) -> Result<(EndBlocks<T>, [Vector3<T>; 2]), SingularBlock> {
        let mut front = [[none(); FRONT]; FRONT];
        let mut load = [unloaded(); FRONT];
        let load_of = |node: usize| loads.get(node).copied().unwrap_or_else(unloaded);
        for (i, row) in front[..=BEYOND].iter_mut().enumerate() {
            for (j, block) in row[..=BEYOND].iter_mut().enumerate() {
                *block = matrix.coupling(i, j);
            }
            load[i] = load_of(i);
        }
        self.negative_pivots = 0;
        for (k, eliminated) in self.rows.iter_mut().enumerate() {
            let lu = Lu::new(&front[NEXT][NEXT]);
            if !is_regular(&front[NEXT][NEXT], &lu) {
                return Err(SingularBlock { node: k + 1 });
            }
            self.negative_pivots += lu.pivots.iter().filter(|p| p.is_negative()).count();
            *eliminated = EliminatedNode {
                first: lu.solve_block(&front[NEXT][0]),
                near: lu.solve_block(&front[NEXT][2]),
                far: if BEYOND > 2 {
                    lu.solve_block(&front[NEXT][3])
                } else {
                    none()
                },
                load: unloaded(),
            };
            if LOADED {
                eliminated.load = lu.solve(&load[NEXT]);
                for a in (0..=BEYOND).filter(|a| *a != NEXT) {
                    load[a] = minus_applied(load[a], &front[a][NEXT], &eliminated.load);
                }
                load.copy_within(NEXT + 1..=BEYOND, NEXT);
                load[BEYOND] = load_of(k + 1 + BEYOND);
            }
            if BESIDE && let Some(sides) = &mut sides {
                let by_next = [0, 1, 2, 3].map(|place| front[place][NEXT]);
                let own = [eliminated.first, none(), eliminated.near, eliminated.far];
                self.beside[k] = sides.eliminate(&lu, &by_next, &own, &eliminated.load);
                sides.advance(BEYOND, k + 1 + BEYOND);
            }
            eliminate::<T, BEYOND>(&mut front, eliminated);
            advance::<T, BEYOND>(&mut front, matrix, k + 1);
        }
        let blocks = [
            [front[0][0], front[0][NEXT]],
            [front[NEXT][0], front[NEXT][NEXT]],
        ];
        Ok((blocks, [load[0], load[NEXT]]))
    }

    /// The displacements of the nodes between for those of the first and last in `x`, with the loads condensed last: the linear
    /// response of the matrix condensed last.
    pub fn respond(&self, x: &mut [Vector3<T>]) {
        self.respond_as::<true, false>(x, None);
    }

    /// The same without these loads.
    pub fn respond_unloaded(&self, x: &mut [Vector3<T>]) {
        self.respond_as::<false, false>(x, None);
    }

    /// As [`Condensation::respond`], for displacements of the unknowns beside the ends too, if there are any.
    pub fn respond_beside(&self, x: &mut [Vector3<T>], sides: Option<&[Vector3<T>; 2]>) {
        match sides {
            Some(_) => self.respond_as::<true, true>(x, sides),
            None => self.respond(x),
        }
    }

    /// The same without the loads.
    pub fn respond_beside_unloaded(&self, x: &mut [Vector3<T>], sides: Option<&[Vector3<T>; 2]>) {
        match sides {
            Some(_) => self.respond_as::<false, true>(x, sides),
            None => self.respond_unloaded(x),
        }
    }

    fn respond_as<const LOADED: bool, const BESIDE: bool>(
        &self,
        x: &mut [Vector3<T>],
        sides: Option<&[Vector3<T>; 2]>,
    ) {
        let first = x[0];
        for (k, row) in self.rows.iter().enumerate().rev() {
            let node = k + 1;
            let load = if LOADED { row.load } else { unloaded() };
            let mut here = minus_applied(load, &row.first, &first);
            here = minus_applied(here, &row.near, &x[node + 1]);
            if let Some(far) = x.get(node + 2) {
                here = minus_applied(here, &row.far, far);
            }
            if BESIDE && let Some(sides) = sides {
                for (by, moved) in self.beside[k].iter().zip(sides) {
                    here = minus_applied(here, by, moved);
                }
            }
            x[node] = here;
        }
    }

    /// How many pivots of the matrix condensed last were negative: of a symmetric matrix, as many as its nodes between have negative
    /// eigenvalues (Sylvester).
    #[must_use]
    pub fn negative_pivots(&self) -> usize {
        self.negative_pivots
    }
}

/// Takes the next node out of the rows and columns of the others.
#[inline(always)]
fn eliminate<T: Pivot, const BEYOND: usize>(front: &mut Front<T>, row: &EliminatedNode<T>) {
    for a in (0..=BEYOND).filter(|a| *a != NEXT) {
        let by = front[a][NEXT];
        front[a][0] = minus_product(front[a][0], &by, &row.first);
        front[a][2] = minus_product(front[a][2], &by, &row.near);
        if BEYOND > 2 {
            front[a][3] = minus_product(front[a][3], &by, &row.far);
        }
    }
}

/// Moves the front past the node just eliminated.
#[inline(always)]
fn advance<T: Pivot, const BEYOND: usize>(
    front: &mut Front<T>,
    matrix: &impl Banded<T>,
    node: usize,
) {
    for row in front.iter_mut() {
        row.copy_within(NEXT + 1..=BEYOND, NEXT);
        row[BEYOND] = none();
    }
    front.copy_within(NEXT + 1..=BEYOND, NEXT);
    front[BEYOND] = [none(); FRONT];
    let entering = node + BEYOND;
    for (place, row) in front.iter_mut().enumerate().take(BEYOND).skip(NEXT) {
        row[BEYOND] = matrix.coupling(node + place, entering);
    }
    for (place, block) in front[BEYOND]
        .iter_mut()
        .enumerate()
        .take(BEYOND + 1)
        .skip(NEXT)
    {
        *block = matrix.coupling(entering, node + place);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockBand, M3, V3};
    use nalgebra::{Complex, DMatrix};
    use proptest::prelude::*;

    fn matrix(n: usize, wide: bool, entries: &[f64]) -> BlockBand {
        let mut m = BlockBand::new(n);
        let mut next = entries.iter().copied().cycle();
        let mut block = || M3::from_fn(|_, _| next.next().unwrap());
        if wide {
            m.widen();
            m.far_upper.fill_with(&mut block);
            m.far_lower.fill_with(&mut block);
        }
        for i in 0..n {
            m.diag[i] = block() + M3::identity() * if i % 3 == 2 { -12.0 } else { 12.0 };
            m.upper[i] = block();
            m.lower[i] = block();
        }
        m
    }

    fn dense(m: &BlockBand, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
        DMatrix::from_fn(3 * rows.len(), 3 * columns.len(), |r, c| {
            m.coupling(rows[r / 3], columns[c / 3])[(r % 3, c % 3)]
        })
    }

    proptest! {
        #[test]
        fn agrees_with_a_dense_schur_complement(
            n in 2usize..12,
            wide in any::<bool>(),
            entries in proptest::collection::vec(-1.0f64..1.0, 9 * 12 * 5),
        ) {
            let m = matrix(n, wide, &entries);
            let (ends, inner) = ([0, n - 1], (1..n - 1).collect::<Vec<_>>());
            let mut condensation = Condensation::new(n);
            let got = condensation.condense(&m).unwrap();
            let mut expected = dense(&m, &ends, &ends);
            if !inner.is_empty() {
                let by_ends = dense(&m, &inner, &inner).lu().solve(&dense(&m, &inner, &ends)).unwrap();
                expected -= dense(&m, &ends, &inner) * &by_ends;
                let mut x = vec![V3::zeros(); n];
                (x[0], x[n - 1]) = (V3::new(1.0, -2.0, 0.5), V3::new(0.3, 0.1, -1.0));
                let moved = nalgebra::DVector::from_iterator(
                    6,
                    x[0].iter().chain(&x[n - 1]).copied(),
                );
                let response = -by_ends * moved;
                condensation.respond(&mut x);
                for (k, value) in response.iter().enumerate() {
                    prop_assert!((x[1 + k / 3][k % 3] - value).abs() < 1e-12);
                }
            }
            for r in 0..6 {
                for c in 0..6 {
                    let block = got[r / 3][c / 3][(r % 3, c % 3)];
                    prop_assert!((block - expected[(r, c)]).abs() < 1e-12);
                }
            }
            prop_assert_eq!(condensation.negative_pivots(), 3 * inner.iter().filter(|i| *i % 3 == 2).count());
        }
    }

    #[test]
    fn loads_are_condensed_with_the_matrix() {
        for wide in [false, true] {
            let n = 9;
            let m = matrix(n, wide, &[0.3, -0.7, 0.2, 0.9, -0.1, 0.5, -0.4]);
            let loads: Vec<V3> = (0..n).map(|i| V3::new(i as f64, 1.0, -2.0)).collect();
            let all: Vec<usize> = (0..n).collect();
            let right = nalgebra::DVector::from_iterator(3 * n, loads.iter().flatten().copied());
            let expected = dense(&m, &all, &all).lu().solve(&right).unwrap();
            let mut condensation = Condensation::new(n);
            let (blocks, left) = condensation.condense_loaded(&m, &loads).unwrap();
            let ends = nalgebra::Matrix6::from_fn(|r, c| blocks[r / 3][c / 3][(r % 3, c % 3)]);
            let left = nalgebra::Vector6::from_fn(|r, _| left[r / 3][r % 3]);
            let ends = ends.lu().solve(&left).unwrap();
            let mut x = vec![V3::zeros(); n];
            x[0].copy_from(&ends.fixed_rows::<3>(0));
            x[n - 1].copy_from(&ends.fixed_rows::<3>(3));
            condensation.respond(&mut x);
            for (k, value) in expected.iter().enumerate() {
                assert!((x[k / 3][k % 3] - value).abs() < 1e-12);
            }
            // Without the loads: as if none had been condensed.
            let mut unloaded = x.clone();
            condensation.respond_unloaded(&mut unloaded);
            let mut bare = Condensation::new(n);
            bare.condense(&m).unwrap();
            bare.respond(&mut x);
            assert_eq!(unloaded, x);
        }
    }

    /// The matrix of a line with an unknown beside each end, all of it.
    fn with_sides(m: &BlockBand, couplings: &[M3; 2]) -> DMatrix<f64> {
        let n = m.diag.len();
        let all: Vec<usize> = (0..n).collect();
        let mut whole = DMatrix::zeros(3 * n + 6, 3 * n + 6);
        whole
            .view_mut((0, 0), (3 * n, 3 * n))
            .copy_from(&dense(m, &all, &all));
        for (end, (coupling, first)) in couplings.iter().zip([0, n - 2]).enumerate() {
            let side = 3 * (n + end);
            for (node, block) in [(first, -coupling), (first + 1, *coupling)] {
                let mut column = whole.view_mut((3 * node, side), (3, 3));
                column += block;
                let mut row = whole.view_mut((side, 3 * node), (3, 3));
                row += block.transpose();
            }
        }
        whole
    }

    #[test]
    fn unknowns_beside_the_ends_are_carried_along() {
        for (n, wide) in [(2, true), (3, true), (4, true), (9, true), (7, false)] {
            let m = matrix(n, wide, &[0.3, -0.7, 0.2, 0.9, -0.1, 0.5, -0.4]);
            let couplings = [
                M3::new(1.0, 0.2, -0.5, 0.3, -2.0, 0.1, 0.7, 0.4, 1.5),
                M3::new(-0.8, 0.6, 0.2, 1.1, 0.9, -0.3, 0.2, 0.1, 1.2),
            ];
            let loads: Vec<V3> = (0..n).map(|i| V3::new(i as f64, 1.0, -2.0)).collect();
            let whole = with_sides(&m, &couplings);
            let inner: Vec<usize> = (3..3 * (n - 1)).collect();
            let kept: Vec<usize> = (0..3).chain(3 * (n - 1)..3 * n + 6).collect();
            let take = |rows: &[usize], columns: &[usize]| {
                DMatrix::from_fn(rows.len(), columns.len(), |r, c| {
                    whole[(rows[r], columns[c])]
                })
            };
            let load =
                |unknown: usize| loads.get(unknown / 3).map_or(0.0, |load| load[unknown % 3]);
            let right = |rows: &[usize]| DMatrix::from_fn(rows.len(), 1, |r, _| load(rows[r]));
            let lu = take(&inner, &inner).lu();
            let solved = |b: DMatrix<f64>| {
                if inner.is_empty() {
                    b
                } else {
                    lu.solve(&b).unwrap()
                }
            };
            let by_kept = solved(take(&inner, &kept));
            let by_load = solved(right(&inner));
            let blocks = take(&kept, &kept) - take(&kept, &inner) * &by_kept;
            let left = right(&kept) - take(&kept, &inner) * &by_load;
            let mut condensation = Condensation::new(n).with_sides();
            let found = condensation
                .condense_beside(&m, &loads, Some(&couplings.map(Some)))
                .unwrap();
            for r in 0..12 {
                assert!((found.left[r / 3][r % 3] - left[r]).abs() < 1e-12);
                for c in 0..12 {
                    let block = found.blocks[r / 3][c / 3][(r % 3, c % 3)];
                    assert!((block - blocks[(r, c)]).abs() < 1e-12, "{n} {r} {c}");
                }
            }
            let moved = [0, 1, 2, 3].map(|k| V3::new(1.0 + k as f64, -2.0, 0.5));
            let sides = [moved[2], moved[3]];
            let column = DMatrix::from_fn(12, 1, |r, _| moved[r / 3][r % 3]);
            let expected = by_load - by_kept * column;
            let mut x = vec![V3::zeros(); n];
            (x[0], x[n - 1]) = (moved[0], moved[1]);
            condensation.respond_beside(&mut x, Some(&sides));
            for (k, value) in expected.iter().enumerate() {
                assert!((x[1 + k / 3][k % 3] - value).abs() < 1e-12);
            }
        }
    }

    /// A band in lanes of its own: real and imaginary part.
    struct ComplexBand([BlockBand; 2]);

    impl Banded<Complex<f64>> for ComplexBand {
        fn nodes(&self) -> usize {
            self.0[0].diag.len()
        }

        fn is_wide(&self) -> bool {
            self.0[0].is_wide()
        }

        fn coupling(&self, i: usize, j: usize) -> Matrix3<Complex<f64>> {
            let [real, imaginary] = self.0.each_ref().map(|part| part.coupling(i, j));
            real.zip_map(&imaginary, Complex::new)
        }
    }

    #[test]
    fn complex_bands_are_condensed_like_real_ones() {
        for wide in [false, true] {
            let n = 8;
            let parts = [[0.3, -0.7, 0.2, 0.9], [0.1, 0.4, -0.6, 0.8]];
            let band = ComplexBand(parts.map(|entries| matrix(n, wide, &entries)));
            let whole = DMatrix::from_fn(3 * n, 3 * n, |r, c| {
                band.coupling(r / 3, c / 3)[(r % 3, c % 3)]
            });
            let loads: Vec<Vector3<Complex<f64>>> = (0..n)
                .map(|i| {
                    Vector3::new(
                        Complex::new(i as f64, 1.0),
                        Complex::i(),
                        Complex::from(-2.0),
                    )
                })
                .collect();
            let right = nalgebra::DVector::from_iterator(3 * n, loads.iter().flatten().copied());
            let expected = whole.lu().solve(&right).unwrap();
            let mut condensation = Condensation::new(n);
            let (blocks, left) = condensation.condense_loaded(&band, &loads).unwrap();
            let ends = nalgebra::Matrix6::from_fn(|r, c| blocks[r / 3][c / 3][(r % 3, c % 3)]);
            let left = nalgebra::Vector6::from_fn(|r, _| left[r / 3][r % 3]);
            let ends = ends.lu().solve(&left).unwrap();
            let mut x = vec![Vector3::zeros(); n];
            x[0].copy_from(&ends.fixed_rows::<3>(0));
            x[n - 1].copy_from(&ends.fixed_rows::<3>(3));
            condensation.respond(&mut x);
            for (k, value) in expected.iter().enumerate() {
                assert!((x[k / 3][k % 3] - value).norm() < 1e-12);
            }
        }
    }

    #[test]
    fn a_singular_node_is_named() {
        let mut m = matrix(5, false, &[0.0]);
        m.diag[3] = M3::zeros();
        let condensed = Condensation::new(5).condense(&m);
        assert_eq!(condensed, Err(SingularBlock { node: 3 }));
    }
}
