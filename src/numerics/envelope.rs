//! Matrices of unknowns that are coupled to few others, within their envelope: of each row and each column what lies between its first
//! coupling and the diagonal. Numbered from neighbour to neighbour, storage and work of a chain or a net of unknowns grow in
//! proportion to their number (George and Liu, *Computer Solution of Large Sparse Positive Definite Systems*, 1981, chapter 4).

use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector, Dim, Matrix, RawStorage};

use super::envelope_factors::EnvelopeLu;

/// The first unknown that each one is coupled to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EnvelopeShape {
    first: Vec<usize>,
    /// Where each row begins among the numbers kept, and their count.
    pub(super) starts: Vec<usize>,
}

impl EnvelopeShape {
    /// The shape by the first coupling of each row, its own number where there is none before it.
    #[must_use]
    pub fn new(first: Vec<usize>) -> Self {
        let mut starts = Vec::with_capacity(first.len() + 1);
        let mut count = 0;
        starts.push(0);
        for (row, first) in first.iter().enumerate() {
            count += row + 1 - first;
            starts.push(count);
        }
        Self { first, starts }
    }

    pub(super) fn len(&self) -> usize {
        self.first.len()
    }

    /// The unknowns that couplings join, directly or over others: numbered from neighbour to neighbour they follow one another.
    #[must_use]
    pub fn parts(&self) -> Vec<Range<usize>> {
        let mut parts = Vec::new();
        let (mut least, mut end) = (self.len(), self.len());
        for row in (0..self.len()).rev() {
            least = least.min(self.first[row]);
            if least == row {
                parts.push(row..end);
                end = row;
            }
        }
        parts.reverse();
        parts
    }

    /// The first column of a row, and where its numbers stand.
    pub(super) fn row(&self, row: usize) -> (usize, Range<usize>) {
        (self.first[row], self.starts[row]..self.starts[row + 1])
    }
}

/// A square matrix within an envelope that is symmetric in shape.
#[derive(Debug, Clone)]
pub struct EnvelopeMatrix {
    shape: Arc<EnvelopeShape>,
    /// Rows up to the diagonal.
    pub(super) lower: Vec<f64>,
    /// Columns down to the diagonal, which is in both.
    pub(super) upper: Vec<f64>,
}

/// Backward error by row of a solution that is as good as one with rows exchanged.
const SOLVED: f64 = 1e-12;

impl EnvelopeMatrix {
    /// Nothing but zeros.
    #[must_use]
    pub fn zeros(shape: &Arc<EnvelopeShape>) -> Self {
        let count = shape.starts[shape.len()];
        Self {
            shape: Arc::clone(shape),
            lower: vec![0.0; count],
            upper: vec![0.0; count],
        }
    }

    /// Rows, and columns.
    #[must_use]
    pub fn size(&self) -> usize {
        self.shape.len()
    }

    /// The shape.
    #[must_use]
    pub fn shape(&self) -> Arc<EnvelopeShape> {
        Arc::clone(&self.shape)
    }

    /// Adds a multiple of a matrix of the same shape.
    pub fn add_scaled(&mut self, other: &Self, factor: f64) {
        for (own, others) in [
            (&mut self.lower, &other.lower),
            (&mut self.upper, &other.upper),
        ] {
            for (own, other) in own.iter_mut().zip(others) {
                *own += factor * other;
            }
        }
    }

    /// Its symmetric part.
    #[must_use]
    pub fn symmetric_part(&self) -> Self {
        let both = self.lower.iter().zip(&self.upper);
        let mean: Vec<f64> = both.map(|(below, above)| 0.5 * (below + above)).collect();
        Self {
            shape: Arc::clone(&self.shape),
            lower: mean.clone(),
            upper: mean,
        }
    }

    /// The unknowns that couplings join: see [`EnvelopeShape::parts`].
    #[must_use]
    pub fn parts(&self) -> Vec<Range<usize>> {
        self.shape.parts()
    }

    /// The matrix of one of its parts.
    #[must_use]
    pub fn part(&self, unknowns: &Range<usize>) -> Self {
        let first = self.shape.first[unknowns.clone()].iter();
        let first = first.map(|first| first - unknowns.start).collect();
        let starts = &self.shape.starts;
        let numbers = starts[unknowns.start]..starts[unknowns.end];
        Self {
            shape: Arc::new(EnvelopeShape::new(first)),
            lower: self.lower[numbers.clone()].to_vec(),
            upper: self.upper[numbers].to_vec(),
        }
    }

    /// Adds to a number within the envelope.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        let place = |long: usize, short: usize| {
            let (first, numbers) = self.shape.row(long);
            numbers.start + short - first
        };
        if row >= column {
            self.lower[place(row, column)] += value;
        }
        if row <= column {
            self.upper[place(column, row)] += value;
        }
    }

    /// Adds a block within the envelope, its first number at this row and column.
    pub fn add_block<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(
        &mut self,
        row: usize,
        column: usize,
        block: &Matrix<f64, R, C, S>,
    ) {
        for (j, values) in block.column_iter().enumerate() {
            for (i, value) in values.iter().enumerate() {
                self.add(row + i, column + j, *value);
            }
        }
    }

    /// A number; zero outside of the envelope.
    #[must_use]
    pub fn at(&self, row: usize, column: usize) -> f64 {
        let (long, short) = (row.max(column), row.min(column));
        let (first, numbers) = self.shape.row(long);
        if short < first {
            return 0.0;
        }
        let numbers_of = if row >= column {
            &self.lower
        } else {
            &self.upper
        };
        numbers_of[numbers.start + short - first]
    }

    /// Adds a multiple of a row to another one, then the same of their columns: `J' K J`, where the unknown `from` follows the unknown
    /// `to` by this factor. Both have one envelope, as unknowns of one part have.
    pub fn add_multiple(&mut self, to: usize, from: usize, factor: f64) {
        for column in 0..self.size() {
            let value = self.at(from, column);
            if value != 0.0 {
                self.add(to, column, factor * value);
            }
        }
        for row in 0..self.size() {
            let value = self.at(row, from);
            if value != 0.0 {
                self.add(row, to, factor * value);
            }
        }
    }

    /// The diagonal.
    #[must_use]
    pub fn diagonal(&self) -> DVector<f64> {
        let ends = self.shape.starts.iter().skip(1).map(|end| end - 1);
        DVector::from_iterator(self.size(), ends.map(|end| self.lower[end]))
    }

    /// A column.
    #[must_use]
    pub fn column(&self, column: usize) -> DVector<f64> {
        let mut unit = DVector::zeros(self.size());
        unit[column] = 1.0;
        self.times(&unit)
    }

    /// The share of its greatest number by which the matrix differs from its symmetric part.
    #[must_use]
    pub fn asymmetry(&self) -> f64 {
        let (mut odd, mut even) = (0.0_f64, 0.0_f64);
        for (below, above) in self.lower.iter().zip(&self.upper) {
            odd = odd.max((below - above).abs());
            even = even.max((below + above).abs());
        }
        if even > 0.0 { odd / even } else { 0.0 }
    }

    /// Multiplies rows and columns by these numbers.
    pub fn scale(&mut self, by: &DVector<f64>) {
        self.each(|row, column| by[row] * by[column]);
    }

    /// Lets the unknowns that are held stand for themselves, with this number on the diagonal.
    pub fn hold(&mut self, held: &[bool], diagonal: f64) {
        if !held.contains(&true) {
            return;
        }
        self.each(|row, column| f64::from(!held[row] && !held[column]));
        for row in (0..self.size()).filter(|row| held[*row]) {
            self.add(row, row, diagonal);
        }
    }

    fn each(&mut self, factor: impl Fn(usize, usize) -> f64) {
        for row in 0..self.size() {
            let (first, numbers) = self.shape.row(row);
            for (column, at) in (first..).zip(numbers) {
                let factor = factor(row, column);
                self.lower[at] *= factor;
                self.upper[at] *= factor;
            }
        }
    }

    /// The product with a vector.
    #[must_use]
    pub fn times(&self, vector: &DVector<f64>) -> DVector<f64> {
        self.product(vector, |value| value)
    }

    fn product(&self, vector: &DVector<f64>, value: fn(f64) -> f64) -> DVector<f64> {
        let mut product = DVector::zeros(self.size());
        for row in 0..self.size() {
            let (first, numbers) = self.shape.row(row);
            for (column, at) in (first..row).zip(numbers.clone()) {
                product[row] += value(self.lower[at]) * vector[column];
                product[column] += value(self.upper[at]) * vector[row];
            }
            product[row] += value(self.lower[numbers.end - 1]) * vector[row];
        }
        product
    }

    /// All of it.
    #[must_use]
    pub fn dense(&self) -> DMatrix<f64> {
        let mut dense = DMatrix::zeros(self.size(), self.size());
        for row in 0..self.size() {
            let (first, numbers) = self.shape.row(row);
            for (column, at) in (first..).zip(numbers) {
                dense[(row, column)] = self.lower[at];
                dense[(column, row)] = self.upper[at];
            }
        }
        dense
    }

    /// Solutions for right-hand sides: by factors without exchange of rows, or densely where these lose digits. Nothing for a
    /// singular matrix.
    #[must_use]
    pub fn solve(&self, rights: &[DVector<f64>]) -> Option<Vec<DVector<f64>>> {
        let factors = EnvelopeLu::new(self);
        let plain = factors.and_then(|factors| {
            let solve = |right| Some(factors.solve(right)).filter(|x| self.is_solved(x, right));
            rights.iter().map(solve).collect()
        });
        plain.or_else(|| {
            let factors = self.dense().lu();
            rights.iter().map(|right| factors.solve(right)).collect()
        })
    }

    fn is_solved(&self, solution: &DVector<f64>, right: &DVector<f64>) -> bool {
        let left = self.times(solution);
        let terms = self.product(&solution.abs(), f64::abs);
        (0..self.size())
            .all(|row| (left[row] - right[row]).abs() <= SOLVED * (terms[row] + right[row].abs()))
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

/// Where each node's unknowns begin when they are numbered from neighbour to neighbour, nodes of `sizes` unknowns, and the shape of
/// their matrix.
#[must_use]
pub fn number(neighbours: &[Vec<usize>], sizes: &[usize]) -> (Vec<usize>, EnvelopeShape) {
    let order = from_neighbour_to_neighbour(neighbours);
    let mut begins = vec![0; sizes.len()];
    let mut count = 0;
    for node in &order {
        begins[*node] = count;
        count += sizes[*node];
    }
    let mut first = Vec::with_capacity(count);
    for node in order {
        let own = begins[node];
        let coupled = neighbours[node].iter().map(|other| begins[*other]);
        let least = coupled.fold(own, usize::min);
        first.extend((0..sizes[node]).map(|_| least));
    }
    (begins, EnvelopeShape::new(first))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envelope_factors::EnvelopeCholesky;
    use crate::random::Random;

    /// A ring of nodes of three and six unknowns with a hub, diagonal numbers as given.
    fn ring(nodes: usize, diagonal: f64, oblique: f64) -> EnvelopeMatrix {
        let hub = nodes;
        let mut neighbours = vec![Vec::new(); nodes + 1];
        for node in 0..nodes {
            for other in [(node + 1) % nodes, hub] {
                neighbours[node].push(other);
                neighbours[other].push(node);
            }
        }
        let sizes: Vec<usize> = (0..=nodes)
            .map(|node| if node % 3 == 0 { 6 } else { 3 })
            .collect();
        let (begins, shape) = number(&neighbours, &sizes);
        let mut matrix = EnvelopeMatrix::zeros(&Arc::new(shape));
        let mut random = Random::new(3, 0);
        for node in 0..=nodes {
            for other in neighbours[node].iter().chain([&node]) {
                for row in begins[node]..begins[node] + sizes[node] {
                    for column in begins[*other]..begins[*other] + sizes[*other] {
                        let value = random.uniform() - 0.5;
                        matrix.add(row, column, value);
                        matrix.add(column, row, value * (1.0 - oblique));
                    }
                }
            }
        }
        for row in 0..matrix.size() {
            matrix.add(row, row, diagonal);
        }
        matrix
    }

    #[test]
    fn a_row_and_its_column_are_added_to_others() {
        let mut matrix = ring(5, 4.0, 0.3);
        let dense = matrix.dense();
        let n = matrix.size();
        // Unknowns of one node.
        let (to, from) = (0, 2);
        let mut follows = DMatrix::identity(n, n);
        follows[(from, to)] = 0.7;
        matrix.add_multiple(to, from, 0.7);
        let wanted = follows.transpose() * dense * follows;
        assert!((matrix.dense() - wanted).amax() < 1e-14);
    }

    fn right(n: usize) -> DVector<f64> {
        let mut random = Random::new(4, 0);
        DVector::from_fn(n, |_, _| random.uniform())
    }

    #[test]
    fn factors_solve_what_the_dense_matrix_solves() {
        let matrix = ring(12, 40.0, 0.0);
        let b = right(matrix.size());
        let expected = matrix.dense().lu().solve(&b).unwrap();
        let added = DVector::zeros(b.len());
        let cholesky = EnvelopeCholesky::new(&matrix, &added).unwrap().solve(&b);
        assert!((cholesky - &expected).amax() < 1e-13);
        assert!((matrix.times(&expected) - &b).amax() < 1e-12);
        let oblique = ring(12, 40.0, 0.7);
        assert!(oblique.asymmetry() > 1e-3 && matrix.asymmetry() < 1e-15);
        let expected = oblique.dense().lu().solve(&b).unwrap();
        let found = oblique.solve(std::slice::from_ref(&b)).unwrap().remove(0);
        assert!((found - expected).amax() < 1e-13);
    }

    #[test]
    fn an_indefinite_matrix_has_no_cholesky_factors_and_is_still_solved() {
        let mut matrix = ring(12, 0.0, 0.7);
        let diagonal = matrix.diagonal();
        matrix.add(0, 0, -diagonal[0]);
        let b = right(matrix.size());
        assert!(EnvelopeCholesky::new(&matrix, &DVector::zeros(b.len())).is_none());
        let found = matrix.solve(std::slice::from_ref(&b)).unwrap().remove(0);
        assert!((matrix.times(&found) - &b).amax() < 1e-10);
    }

    #[test]
    fn what_no_coupling_joins_are_parts_with_matrices_of_their_own() {
        let neighbours = [vec![3], vec![4], vec![], vec![0, 5], vec![1], vec![3]];
        let (begins, shape) = number(&neighbours, &[3, 6, 3, 3, 3, 3]);
        let shape = Arc::new(shape);
        let mut sizes: Vec<usize> = shape.parts().iter().map(Range::len).collect();
        sizes.sort_unstable();
        assert_eq!(sizes, [3, 9, 9]);
        let mut matrix = EnvelopeMatrix::zeros(&shape);
        matrix.add(begins[4] + 1, begins[1] + 2, 5.0);
        let parts = shape.parts();
        let part = parts.iter().find(|part| part.contains(&begins[1]));
        let part = part.unwrap();
        let own = matrix.part(part);
        let at = |unknown: usize| unknown - part.start;
        assert_eq!(own.at(at(begins[4] + 1), at(begins[1] + 2)), 5.0);
        let whole = matrix.dense();
        let size = (part.len(), part.len());
        assert_eq!(own.dense(), whole.view((part.start, part.start), size));
    }

    #[test]
    fn unknowns_that_are_held_stand_for_themselves() {
        let mut matrix = ring(5, 40.0, 0.3);
        let n = matrix.size();
        let free = matrix.dense();
        let held: Vec<bool> = (0..n).map(|k| k % 4 == 1).collect();
        matrix.hold(&held, 2.0);
        let dense = matrix.dense();
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let expected = match (held[i] || held[j], i == j) {
                (true, true) => 2.0,
                (true, false) => 0.0,
                (false, _) => free[(i, j)],
            };
            assert_eq!(dense[(i, j)], expected);
        }
    }

    #[test]
    fn the_envelope_of_a_chain_and_of_a_star_grows_with_their_size() {
        let kept = |neighbours: &[Vec<usize>]| {
            let (_, shape) = number(neighbours, &vec![3; neighbours.len()]);
            *shape.starts.last().unwrap()
        };
        let chain = |n: usize| -> Vec<Vec<usize>> {
            let near = |k: usize| [k.checked_sub(1), (k + 1 < n).then_some(k + 1)];
            (0..n)
                .map(|k| near(k).into_iter().flatten().collect())
                .collect()
        };
        let star = |n: usize| -> Vec<Vec<usize>> {
            let mut all = vec![vec![0]; n];
            all[0] = (1..n).collect();
            all
        };
        assert!(kept(&chain(400)) <= 15 * 400);
        assert!(kept(&star(400)) <= 20 * 400);
    }
}
