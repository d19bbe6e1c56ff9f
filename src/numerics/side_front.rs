//! Two unknowns of three numbers beside a banded line, carried along as it is condensed: one is coupled to its first two nodes, one to its
//! last two.
//!
//! The direction d of a clamp that turns is such an unknown. It acts on a line by the chord beside it alone, so that of both nodes of the
//! chord the couplings are opposite: with C that of the second node, `-C` is that of the first. The matrix of both is symmetric.

use nalgebra::{Matrix3, Vector3};

use super::condensation::{EndBlocks, FRONT, NEXT};
use super::lanes::Pivot;
use super::lu::{Lu, minus_applied, minus_product};

/// Of the unknowns at ends A and B their coupling C, if there is one.
pub type SideCouplings<T = f64> = [Option<Matrix3<T>>; 2];

/// Rows and columns of both unknowns, by the places of the front.
pub(super) struct SideFront<T: Pivot> {
    /// The coupling to each of the nodes from the first, from the last but one: zero between.
    ends: [[Matrix3<T>; 2]; 2],
    last: usize,
    columns: [[Matrix3<T>; 2]; FRONT],
    rows: [[Matrix3<T>; 2]; FRONT],
    /// What is left of the unknowns by each other, and of their loads.
    pub(super) own: [[Matrix3<T>; 2]; 2],
    pub(super) load: [Vector3<T>; 2],
}

fn none<T: Pivot>() -> Matrix3<T> {
    Matrix3::repeat(T::from(0.0))
}

impl<T: Pivot> SideFront<T> {
    /// At the first nodes of a line, up to the place `beyond` of the front.
    pub(super) fn new(couplings: &SideCouplings<T>, nodes: usize, beyond: usize) -> Self {
        let both = |coupling: &Option<Matrix3<T>>| {
            let second = coupling.unwrap_or_else(none);
            [none() - second, second]
        };
        let mut front = Self {
            ends: couplings.each_ref().map(both),
            last: nodes - 1,
            columns: [[none(); 2]; FRONT],
            rows: [[none(); 2]; FRONT],
            own: [[none(); 2]; 2],
            load: [Vector3::repeat(T::from(0.0)); 2],
        };
        for place in 0..=beyond {
            front.enter(place, place);
        }
        front
    }

    /// The coupling of a node to the unknown at an end.
    fn coupling(&self, node: usize, end: usize) -> Matrix3<T> {
        let first = [0, self.last - 1][end];
        match node.checked_sub(first) {
            Some(k @ 0..2) => self.ends[end][k],
            _ => none(),
        }
    }

    fn enter(&mut self, place: usize, node: usize) {
        self.columns[place] = [0, 1].map(|end| self.coupling(node, end));
        self.rows[place] = self.columns[place].map(|block| block.transpose());
    }

    /// Takes the next node out, by its row of the front: the couplings of the others to it, and what it is coupled to. What it is by the two
    /// unknowns.
    pub(super) fn eliminate(
        &mut self,
        lu: &Lu<T>,
        by_next: &[Matrix3<T>; FRONT],
        eliminated: &[Matrix3<T>; FRONT],
        load: &Vector3<T>,
    ) -> [Matrix3<T>; 2] {
        let by_sides = self.columns[NEXT].map(|column| lu.solve_block(&column));
        let of_next = self.rows[NEXT];
        for end in 0..2 {
            for place in (0..FRONT).filter(|place| *place != NEXT) {
                let column = &mut self.columns[place][end];
                *column = minus_product(*column, &by_next[place], &by_sides[end]);
                let row = &mut self.rows[place][end];
                *row = minus_product(*row, &of_next[end], &eliminated[place]);
            }
            for (own, by_side) in self.own[end].iter_mut().zip(&by_sides) {
                *own = minus_product(*own, &of_next[end], by_side);
            }
            self.load[end] = minus_applied(self.load[end], &of_next[end], load);
        }
        by_sides
    }

    /// Moves past the node just eliminated; `entering` comes in at the place `beyond`.
    pub(super) fn advance(&mut self, beyond: usize, entering: usize) {
        self.columns.copy_within(NEXT + 1..=beyond, NEXT);
        self.rows.copy_within(NEXT + 1..=beyond, NEXT);
        self.enter(beyond, entering);
    }

    /// What is left of the first and last nodes by the unknowns.
    pub(super) fn by_sides(&self) -> EndBlocks<T> {
        [self.columns[0], self.columns[NEXT]]
    }

    /// What is left of the unknowns by the first and last nodes.
    pub(super) fn of_sides(&self) -> EndBlocks<T> {
        [0, 1].map(|end| [self.rows[0][end], self.rows[NEXT][end]])
    }
}
