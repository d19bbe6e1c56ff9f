//! Stiffness and mass of a line at rest as a banded matrix pencil.

use std::ops::Range;

use crate::numerics::{BlockBand, M3, SingularBlock, V3};
use crate::scene::Scene;
use crate::solve::{Factors, Kinematics, Residual, State};

const STIFFNESS: Factors = Factors {
    mass: 0.0,
    damping: 0.0,
    stiffness: 1.0,
};
const MASS: Factors = Factors {
    mass: 1.0,
    damping: 0.0,
    stiffness: 0.0,
};

/// The matrices of `K x = lambda M x` over the free nodes of a line, both symmetric, M positive and a 3 x 3 block a node.
#[derive(Debug, Clone)]
pub struct ModePencil {
    /// K \[N/m\].
    stiffness: BlockBand,
    /// Blocks of M \[kg\].
    mass: Vec<M3>,
    /// The free nodes.
    free: Range<usize>,
    /// Work array of [`ModePencil::solve`].
    work: BlockBand,
}

impl ModePencil {
    /// The pencil of a scene at rest in `state`, drag left out.
    #[must_use]
    pub fn new(scene: &Scene, state: &State) -> Self {
        let bare = scene.without_drag();
        let nodes = bare.nodes();
        let mut residual = vec![V3::zeros(); nodes];
        let mut tangent = |factors| {
            let mut tangent = BlockBand::new(nodes);
            if bare.is_pentadiagonal() {
                tangent.widen();
            }
            bare.linearise(0.0, state, factors, &mut residual, &mut tangent);
            tangent
        };
        let mass = tangent(MASS).diag;
        let mut stiffness = tangent(STIFFNESS);
        symmetrise(&mut stiffness);
        Self {
            work: stiffness.clone(),
            stiffness,
            mass: mass.iter().map(|m| (m + m.transpose()) * 0.5).collect(),
            free: bare.free(),
        }
    }

    /// The free nodes.
    #[must_use]
    pub fn free(&self) -> Range<usize> {
        self.free.clone()
    }

    /// Nodes, both ends counted.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.mass.len()
    }

    /// The mass of a node, added mass included \[kg\].
    #[must_use]
    pub fn mass(&self, node: usize) -> &M3 {
        &self.mass[node]
    }

    /// `y = M x` on the free nodes; the others are left as they are.
    pub fn multiply_mass(&self, x: &[V3], y: &mut [V3]) {
        for i in self.free() {
            y[i] = self.mass[i] * x[i];
        }
    }

    /// `x' M y` over the free nodes.
    #[must_use]
    pub fn mass_product(&self, x: &[V3], y: &[V3]) -> f64 {
        self.free().map(|i| x[i].dot(&(self.mass[i] * y[i]))).sum()
    }

    /// `x' K x` over the free nodes.
    #[must_use]
    pub fn stiffness_product(&self, x: &[V3]) -> f64 {
        let k = &self.stiffness;
        let within = |j: usize| self.free.contains(&j);
        let row = |i: usize| {
            let mut sum = k.diag[i] * x[i];
            let mut add = |blocks: &[M3], j: usize| {
                if within(j) && !blocks.is_empty() {
                    sum += blocks[i] * x[j];
                }
            };
            add(&k.upper, i + 1);
            add(&k.far_upper, i + 2);
            if i > 0 {
                add(&k.lower, i - 1);
            }
            if i > 1 {
                add(&k.far_lower, i - 2);
            }
            x[i].dot(&sum)
        };
        self.free().map(row).sum()
    }

    /// Solves `(K - shift M) x = r` in place; the pivots give the number of eigenvalues below the shift (Sylvester's law
    /// of inertia).
    ///
    /// # Errors
    /// [`SingularBlock`] if the shift is an eigenvalue, up to rounding.
    pub fn solve(&mut self, shift: f64, r: &mut [V3]) -> Result<(), SingularBlock> {
        self.load(shift);
        self.work.solve(self.free.clone(), r)
    }

    /// Number of eigenvalues below this shift \[rad²/s²\].
    ///
    /// # Errors
    /// [`SingularBlock`] if the shift is an eigenvalue, up to rounding.
    pub fn count_below(&mut self, shift: f64) -> Result<usize, SingularBlock> {
        let mut nothing = vec![V3::zeros(); self.nodes()];
        self.solve(shift, &mut nothing)?;
        Ok(self.work.negative_pivots(self.free.clone()))
    }

    /// The greatest ratio of stiffness to mass on the diagonal \[rad²/s²\]: of the order of the highest eigenvalue.
    #[must_use]
    pub fn highest(&self) -> f64 {
        let ratio = |i: usize| {
            (0..3)
                .map(|a| self.stiffness.diag[i][(a, a)].abs() / self.mass[i][(a, a)])
                .fold(0.0, f64::max)
        };
        self.free().map(ratio).fold(0.0, f64::max)
    }

    fn load(&mut self, shift: f64) {
        let (from, to) = (&self.stiffness, &mut self.work);
        to.upper.clone_from(&from.upper);
        to.lower.clone_from(&from.lower);
        to.far_upper.clone_from(&from.far_upper);
        to.far_lower.clone_from(&from.far_lower);
        for ((out, k), m) in to.diag.iter_mut().zip(&from.diag).zip(&self.mass) {
            *out = k - m * shift;
        }
    }
}

/// Symmetrises a matrix, which differs from its transpose by rounding.
fn symmetrise(k: &mut BlockBand) {
    let nodes = k.diag.len();
    for block in &mut k.diag {
        *block = (*block + block.transpose()) * 0.5;
    }
    let pair = |upper: &mut [M3], lower: &mut [M3], reach: usize| {
        for i in 0..nodes.saturating_sub(reach) {
            let mean = (upper[i] + lower[i + reach].transpose()) * 0.5;
            upper[i] = mean;
            lower[i + reach] = mean.transpose();
        }
    };
    pair(&mut k.upper, &mut k.lower, 1);
    if !k.far_upper.is_empty() {
        pair(&mut k.far_upper, &mut k.far_lower, 2);
    }
}
