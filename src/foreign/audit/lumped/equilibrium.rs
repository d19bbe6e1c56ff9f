//! Lumped masses at rest: Newton's iteration with as much added stiffness as keeps the forces falling.

use std::sync::Arc;

use nalgebra::DVector;

use super::LumpedModel;
use super::forces::{Loads, bending, dry_part};
use crate::numerics::envelope::{EnvelopeMatrix, EnvelopeShape, number};
use crate::numerics::envelope_factors::EnvelopeCholesky;
use crate::numerics::{M3, V3};

/// Most iterations.
const MOST: usize = 6000;
/// Most evaluations of nodes: some seconds.
const MOST_WORK: f64 = 4e6;
/// Forces out of balance that count as none, by the greatest tension.
const BALANCED: f64 = 1e-9;
/// Forces that rounding leaves, by those that the last digit of the places makes.
const ROUNDED: f64 = 2.0;
/// Share of the energy that a step promises by which it must fall.
const ENOUGH: f64 = 1e-4;
/// Step of a difference quotient of bending, by the length of a segment.
const STEP: f64 = 1e-6;

/// The unknowns of a model and the shape of their matrix.
#[derive(Debug, Clone)]
pub struct Unknowns {
    /// Where the three unknowns of each node begin; nothing for a held one.
    pub first: Vec<Option<usize>>,
    shape: Arc<EnvelopeShape>,
    count: usize,
}

impl Unknowns {
    /// Of a model.
    #[must_use]
    pub fn of_model(model: &LumpedModel) -> Self {
        let free: Vec<usize> = (0..model.free.len()).filter(|n| model.free[*n]).collect();
        let mut at = vec![None; model.free.len()];
        for (k, node) in free.iter().enumerate() {
            at[*node] = Some(k);
        }
        let mut neighbours = vec![Vec::new(); free.len()];
        let mut couple = |a: usize, b: usize| {
            if let (Some(a), Some(b)) = (at[a], at[b]) {
                neighbours[a].push(b);
                neighbours[b].push(a);
            }
        };
        for line in &model.lines {
            for pair in line.nodes.windows(2) {
                couple(pair[0], pair[1]);
            }
        }
        for bend in &model.bends {
            couple(bend.nodes[0], bend.nodes[2]);
        }
        for all in &mut neighbours {
            all.sort_unstable();
            all.dedup();
        }
        let (begins, shape) = number(&neighbours, &vec![3; free.len()]);
        let first = at.iter().map(|k| k.map(|k| begins[k])).collect();
        Self {
            first,
            shape: Arc::new(shape),
            count: 3 * free.len(),
        }
    }

    /// A matrix of them without numbers yet.
    #[must_use]
    pub fn matrix(&self) -> EnvelopeMatrix {
        EnvelopeMatrix::zeros(&self.shape)
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }
}

/// Places of the nodes at rest \[m\], sought from `start`.
///
/// # Errors
/// What is left out of balance, where the search does not end.
pub fn at_rest(model: &LumpedModel, start: &[V3]) -> Result<Vec<V3>, String> {
    let unknowns = Unknowns::of_model(model);
    let still = vec![V3::zeros(); start.len()];
    let mut loads = Loads::of_model(model);
    let mut x = start.to_vec();
    let longest = model.lines.iter().map(|line| line.segment);
    let longest = longest.fold(0.0, f64::max);
    let mut added = 1e-6;
    model.evaluate(&x, &still, 0.0, &mut loads);
    let mut force = gathered(&unknowns, &loads);
    let mut energy = model.energy(&x);
    let mut work = 0.0;
    for _ in 0..MOST {
        if force.norm() <= balanced(model, &x) {
            return Ok(x);
        }
        if work > MOST_WORK {
            break;
        }
        let matrix = stiffness(model, &unknowns, &x);
        let diagonal = matrix.diagonal().map(f64::abs);
        let level = diagonal.max();
        let mut found = None;
        while added < 1e12 {
            let more = diagonal.map(|own| added * (own + 1e-3 * level));
            work += x.len() as f64;
            if let Some(factors) = EnvelopeCholesky::new(&matrix, &more) {
                let step = factors.solve(&force);
                let cut = (longest / step.amax().max(f64::MIN_POSITIVE)).min(1.0);
                let tried = moved(&unknowns, &x, &(&step * cut));
                model.evaluate(&tried, &still, 0.0, &mut loads);
                let left = gathered(&unknowns, &loads);
                let then = model.energy(&tried);
                // Far from rest the energy is what falls, near it only the forces have digits left.
                let falls = then < energy - ENOUGH * force.dot(&step) * cut;
                if falls || left.norm() < force.norm() {
                    found = Some((tried, left, then));
                    break;
                }
            }
            added *= 8.0;
        }
        let Some((tried, left, then)) = found else {
            break;
        };
        (x, force, energy) = (tried, left, then);
        added = (added / 20.0).max(1e-14);
    }
    match force.norm() <= 1e3 * BALANCED * scale(model, &x) {
        true => Ok(x),
        false => Err(format!("{:.3e} N are left out of balance", force.norm())),
    }
}

/// Forces \[N\] that count as none: a share of the greatest tension, or of short and stiff segments what rounding leaves.
fn balanced(model: &LumpedModel, x: &[V3]) -> f64 {
    let mut squares = 0.0;
    for line in &model.lines {
        let stiff = line.elasticity.initial() / line.segment;
        let places = line.nodes.iter().map(|node| x[*node].norm_squared());
        squares += stiff * stiff * places.sum::<f64>();
    }
    let rounded = ROUNDED * f64::EPSILON * squares.sqrt();
    rounded.max(BALANCED * scale(model, x))
}

/// The greatest tension \[N\], at least 1.
fn scale(model: &LumpedModel, x: &[V3]) -> f64 {
    let lines = model.lines.iter().enumerate();
    let all =
        lines.flat_map(|(k, line)| (0..line.nodes.len() - 1).map(move |s| model.tension(k, s, x)));
    all.fold(1.0, f64::max)
}

fn gathered(unknowns: &Unknowns, loads: &Loads) -> DVector<f64> {
    let mut force = DVector::zeros(unknowns.count);
    for (node, first) in unknowns.first.iter().enumerate() {
        if let Some(first) = first {
            force
                .fixed_rows_mut::<3>(*first)
                .copy_from(&loads.force[node]);
        }
    }
    force
}

fn moved(unknowns: &Unknowns, x: &[V3], step: &DVector<f64>) -> Vec<V3> {
    let nodes = x.iter().zip(&unknowns.first);
    nodes
        .map(|(place, first)| match first {
            Some(first) => place + step.fixed_rows::<3>(*first),
            None => *place,
        })
        .collect()
}

/// The negative change of the forces by the places \[N/m\].
#[must_use]
pub fn stiffness(model: &LumpedModel, unknowns: &Unknowns, x: &[V3]) -> EnvelopeMatrix {
    let mut matrix = unknowns.matrix();
    let mut add = |row: usize, column: usize, block: &M3| {
        if let (Some(row), Some(column)) = (unknowns.first[row], unknowns.first[column]) {
            matrix.add_block(row, column, block);
        }
    };
    for line in &model.lines {
        for pair in line.nodes.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let apart = x[b] - x[a];
            let length = apart.norm();
            let Some(along) = apart.try_normalize(0.0) else {
                continue;
            };
            let (tension, slope) = line.elasticity.at(length / line.segment - 1.0);
            let outer = along * along.transpose();
            let block =
                (M3::identity() - outer) * (tension / length) + outer * (slope / line.segment);
            for (row, column, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                add(row, column, &(block * sign));
            }
            let dry = dry_part(line, [x[a].z, x[b].z]);
            let area = 0.25 * std::f64::consts::PI * line.diameter * line.diameter;
            let displaced = model.gravity * model.density * area * line.segment;
            for (row, by) in [a, b].into_iter().zip(dry.by) {
                for (column, by) in [a, b].into_iter().zip(by) {
                    add(
                        row,
                        column,
                        &(V3::z() * V3::z().transpose() * (displaced * by)),
                    );
                }
            }
        }
        let last = line.nodes.len() - 1;
        for (i, node) in line.nodes.iter().copied().enumerate() {
            let halves = if i == 0 || i == last { 0.5 } else { 1.0 };
            if model.bed_z.is_some_and(|z| x[node].z < z) {
                let push = model.bed_stiffness * line.diameter * halves * line.segment;
                add(node, node, &(V3::z() * V3::z().transpose() * push));
            }
        }
    }
    bends(model, x, &mut add);
    matrix
}

/// The stiffness of bending, by difference quotients.
fn bends(model: &LumpedModel, x: &[V3], add: &mut impl FnMut(usize, usize, &M3)) {
    for bend in &model.bends {
        let size = STEP * shortest_arm(bend, x);
        let mut near = bend.nodes.map(|node| x[node]);
        for column in 0..3 {
            let mut block = [M3::zeros(); 3];
            for axis in 0..3 {
                let own = near[column][axis];
                near[column][axis] = own + size;
                let ahead = bending(&bend.local(), &near);
                near[column][axis] = own - size;
                let behind = bending(&bend.local(), &near);
                near[column][axis] = own;
                for row in 0..3 {
                    let by = (behind[row] - ahead[row]) / (2.0 * size);
                    block[row].set_column(axis, &by);
                }
            }
            for (row, block) in bend.nodes.into_iter().zip(&block) {
                add(row, bend.nodes[column], block);
            }
        }
    }
}

/// The shorter of the two segments of a bend \[m\].
fn shortest_arm(bend: &super::Bend, x: &[V3]) -> f64 {
    let [a, b, c] = bend.nodes.map(|node| x[node]);
    (b - a).norm().min((c - b).norm())
}

impl super::Bend {
    /// The same bend of three places alone.
    fn local(&self) -> Self {
        Self {
            nodes: [0, 1, 2],
            ..*self
        }
    }
}
