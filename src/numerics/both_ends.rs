//! Elimination from both ends of a line at once, one chain in each of two lanes.
//!
//! The chain that runs down from the first node and the one that runs up from the last are mirror images, and do not
//! depend on each other until they meet: every instruction serves both. The two or three nodes left in the middle are
//! solved by themselves, and the solution spreads from there to the ends. Rows are counted from their own end here, so
//! that "upper" is towards the middle in both chains.
//!
//! The matrix is only read. A pivot that is small against its block as it was before, and may be nothing but rounding, is
//! not trusted: elimination from one end decides whether it vanishes.

use std::ops::Range;

use nalgebra::{Matrix3, Vector3};

use super::lanes::{self, Two, TwoM3, TwoV3};
use super::lu::{Lu, minus_applied, minus_product};
use super::{BlockBand, M3, V3};

/// Pivots are trusted above this share of their block as it was.
const TRUSTED: f64 = 1e-12;

/// The fewest nodes left in the middle, as far as a row reaches, and the most.
const FEWEST_BETWEEN: usize = 2;
const MOST_BETWEEN: usize = 3;

/// The fewest nodes for which elimination from two ends pays.
const SHORTEST: usize = 6;

/// Storage for the elimination.
#[derive(Debug, Clone)]
pub(super) struct BothEnds {
    /// Rows taken out, from the ends inwards; `taken` of them by the last elimination.
    rows: Vec<EliminatedRow>,
    taken: usize,
    /// The nodes between.
    middle: BlockBand,
}

/// A row of either chain, taken out: `x[k] = y - near x[k + 1] - far x[k + 2]`.
#[derive(Debug, Clone, Copy)]
struct EliminatedRow {
    near: TwoM3,
    far: TwoM3,
    y: TwoV3,
    pivots: TwoV3,
}

/// The next row of a chain and the one after it, as the rows taken out before have left them.
struct PendingRows<T> {
    next: Matrix3<T>,
    /// Couples the next row to the one after.
    upper: Matrix3<T>,
    /// Couples the row after to the next.
    lower: Matrix3<T>,
    after: Matrix3<T>,
    next_r: Vector3<T>,
    after_r: Vector3<T>,
}

impl BothEnds {
    /// Storage for a line of so many nodes; none for one that is too short.
    pub(super) fn new(nodes: usize) -> Option<Box<Self>> {
        let nothing = EliminatedRow {
            near: TwoM3::repeat(Two::ZERO),
            far: TwoM3::repeat(Two::ZERO),
            y: TwoV3::repeat(Two::ZERO),
            pivots: TwoV3::repeat(Two::ZERO),
        };
        let room = || Self {
            rows: vec![nothing; nodes / 2],
            taken: 0,
            middle: BlockBand::new(MOST_BETWEEN),
        };
        (nodes >= SHORTEST).then(|| Box::new(room()))
    }

    /// Allocates the couplings of bending.
    pub(super) fn widen(&mut self) {
        self.middle.widen();
    }

    /// Solves as [`BlockBand::solve`] does. `None`, and `r` unchanged, where the range is too short or a pivot is not
    /// trusted.
    pub(super) fn solve<const WIDE: bool>(
        &mut self,
        band: &BlockBand,
        range: &Range<usize>,
        r: &mut [V3],
    ) -> Option<()> {
        self.taken = 0;
        if range.len() < SHORTEST {
            return None;
        }
        let taken = (range.len() - FEWEST_BETWEEN) / 2;
        let ends = TwoEnded {
            band,
            first: range.start,
            last: range.end - 1,
        };
        let mut front = PendingRows::new(&ends, 0, r);
        for (k, row) in self.rows[..taken].iter_mut().enumerate() {
            let least = ends.least(k);
            *row = front.take_out::<WIDE>(&ends, k, r);
            let trusted = row.pivots.map(|p| p.abs().simd_gt(least));
            if !(trusted[0] & trusted[1] & trusted[2]).all() {
                return None;
            }
        }
        self.solve_between(&front, &ends, taken, r)?;
        self.taken = taken;
        self.spread::<WIDE>(&ends, r);
        Some(())
    }

    /// How many pivots of the last elimination were negative; `None` where it was abandoned.
    pub(super) fn negative_pivots(&self) -> Option<usize> {
        let rows = &self.rows[..self.taken];
        let pivots = rows.iter().flat_map(|row| row.pivots.iter());
        let outer: u32 = pivots.map(|p| p.to_bitmask().count_ones()).sum();
        (self.taken > 0).then(|| outer as usize + self.middle.negative_pivots(0..MOST_BETWEEN))
    }

    /// Solves for the nodes between, `taken` rows from the ends.
    fn solve_between(
        &mut self,
        front: &PendingRows<Two>,
        ends: &TwoEnded,
        taken: usize,
        r: &mut [V3],
    ) -> Option<()> {
        let (first, last) = (ends.first + taken, ends.last - taken);
        let n = last + 1 - first;
        let (middle, band) = (&mut self.middle, ends.band);
        for (to, from) in [
            (&mut middle.diag, &band.diag),
            (&mut middle.upper, &band.upper),
            (&mut middle.lower, &band.lower),
            (&mut middle.far_upper, &band.far_upper),
            (&mut middle.far_lower, &band.far_lower),
        ] {
            if !from.is_empty() {
                to[..n].copy_from_slice(&from[first..=last]);
            }
        }
        // Both chains may have changed the same block: their changes add up.
        let mut sum = [V3::zeros(); MOST_BETWEEN];
        let sum = &mut sum[..n];
        sum.copy_from_slice(&r[first..=last]);
        let was = PendingRows::new(ends, taken, r);
        let [down, up] = [0, 1].map(|lane| front.lane(lane).minus(&was.lane(lane)));
        middle.diag[0] += down.next;
        middle.upper[0] += down.upper;
        middle.lower[1] += down.lower;
        middle.diag[1] += down.after;
        middle.diag[n - 1] += up.next;
        middle.lower[n - 1] += up.upper;
        middle.upper[n - 2] += up.lower;
        middle.diag[n - 2] += up.after;
        sum[0] += down.next_r;
        sum[1] += down.after_r;
        sum[n - 1] += up.next_r;
        sum[n - 2] += up.after_r;
        // A node that does not exist: an identity, without negative pivots.
        middle.diag[n..].fill(M3::identity());
        middle.solve(0..n, sum).ok()?;
        for (m, node) in middle.diag[..n].iter().zip(first..) {
            let least = least(&band.diag[node]);
            if !Lu::new(m).pivots.iter().all(|p| p.abs() > least) {
                return None;
            }
        }
        r[first..=last].copy_from_slice(sum);
        Some(())
    }

    /// Spreads the solution from the nodes between to the ends.
    fn spread<const WIDE: bool>(&self, ends: &TwoEnded, r: &mut [V3]) {
        let mut near = ends.vectors(self.taken, r);
        let mut far = ends.vectors(self.taken + 1, r);
        for (k, row) in self.rows[..self.taken].iter().enumerate().rev() {
            let mut x = minus_applied(row.y, &row.near, &near);
            if WIDE {
                x = minus_applied(x, &row.far, &far);
            }
            r[ends.first + k] = lanes::vector(&x, 0);
            r[ends.last - k] = lanes::vector(&x, 1);
            (far, near) = (near, x);
        }
    }
}

impl PendingRows<Two> {
    /// The k-th rows and those after them as they are in the matrix.
    fn new(ends: &TwoEnded, k: usize, r: &[V3]) -> Self {
        Self {
            next: ends.diag(k),
            upper: ends.upper(k),
            lower: ends.lower(k + 1),
            after: ends.diag(k + 1),
            next_r: ends.vectors(k, r),
            after_r: ends.vectors(k + 1, r),
        }
    }

    /// Takes the next rows, the k-th, out of the two that follow.
    #[inline(always)]
    fn take_out<const WIDE: bool>(&mut self, ends: &TwoEnded, k: usize, r: &[V3]) -> EliminatedRow {
        let lu = Lu::new(&self.next);
        let near = lu.solve_block(&self.upper);
        let y = lu.solve(&self.next_r);
        self.next = minus_product(self.after, &self.lower, &near);
        self.next_r = minus_applied(self.after_r, &self.lower, &y);
        self.upper = ends.upper(k + 1);
        let lower = std::mem::replace(&mut self.lower, ends.lower(k + 2));
        self.after = ends.diag(k + 2);
        self.after_r = ends.vectors(k + 2, r);
        let mut far = near;
        if WIDE {
            far = lu.solve_block(&ends.far_upper(k));
            let below = ends.far_lower(k + 2);
            self.upper = minus_product(self.upper, &lower, &far);
            self.lower = minus_product(self.lower, &below, &near);
            self.after = minus_product(self.after, &below, &far);
            self.after_r = minus_applied(self.after_r, &below, &y);
        }
        EliminatedRow {
            near,
            far,
            y,
            pivots: lu.pivots,
        }
    }

    /// Those of one chain.
    fn lane(&self, lane: usize) -> PendingRows<f64> {
        let block = |m: &TwoM3| lanes::block(m, lane);
        let vector = |v: &TwoV3| lanes::vector(v, lane);
        PendingRows {
            next: block(&self.next),
            upper: block(&self.upper),
            lower: block(&self.lower),
            after: block(&self.after),
            next_r: vector(&self.next_r),
            after_r: vector(&self.after_r),
        }
    }
}

impl PendingRows<f64> {
    fn minus(&self, was: &Self) -> Self {
        Self {
            next: self.next - was.next,
            upper: self.upper - was.upper,
            lower: self.lower - was.lower,
            after: self.after - was.after,
            next_r: self.next_r - was.next_r,
            after_r: self.after_r - was.after_r,
        }
    }
}

/// A matrix read from both ends of a range: k counts nodes from either end.
struct TwoEnded<'a> {
    band: &'a BlockBand,
    first: usize,
    last: usize,
}

impl TwoEnded<'_> {
    #[inline(always)]
    fn diag(&self, k: usize) -> TwoM3 {
        self.blocks(k, &self.band.diag, &self.band.diag)
    }

    #[inline(always)]
    fn upper(&self, k: usize) -> TwoM3 {
        self.blocks(k, &self.band.upper, &self.band.lower)
    }

    #[inline(always)]
    fn lower(&self, k: usize) -> TwoM3 {
        self.blocks(k, &self.band.lower, &self.band.upper)
    }

    #[inline(always)]
    fn far_upper(&self, k: usize) -> TwoM3 {
        self.blocks(k, &self.band.far_upper, &self.band.far_lower)
    }

    #[inline(always)]
    fn far_lower(&self, k: usize) -> TwoM3 {
        self.blocks(k, &self.band.far_lower, &self.band.far_upper)
    }

    #[inline(always)]
    fn blocks(&self, k: usize, down: &[M3], up: &[M3]) -> TwoM3 {
        lanes::blocks(&down[self.first + k], &up[self.last - k])
    }

    #[inline(always)]
    fn vectors(&self, k: usize, r: &[V3]) -> TwoV3 {
        lanes::vectors(&r[self.first + k], &r[self.last - k])
    }

    /// The least pivots that are trusted.
    #[inline(always)]
    fn least(&self, k: usize) -> Two {
        let [down, up] = [self.first + k, self.last - k].map(|node| least(&self.band.diag[node]));
        Two::new([down, up])
    }
}

/// The least pivot of a block that is trusted.
#[inline(always)]
fn least(m: &M3) -> f64 {
    TRUSTED * (m[(0, 0)].abs() + m[(1, 1)].abs() + m[(2, 2)].abs())
}
